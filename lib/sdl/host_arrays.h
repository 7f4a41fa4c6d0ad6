/* host_arrays.h - shapes that are read from arrays: their plugins' parse() takes numbers from these, not from text. */
#ifndef SDL_HOST_ARRAYS_H
#define SDL_HOST_ARRAYS_H

#include "build/parts.h"

#include <povtrace/plugin.h>

/* The object that is read next; pov_reader.rows points here while it is. */
typedef struct array_rows {
    const scene_parts *all;
    const build_part *part;
    size_t row;
    int column;                  /* the next one; or the next list, */
    const build_list *list;      /* the one that is being read, */
    size_t item;                 /* and its next item */
    bool is_counted;             /* the count of the list has been read */
    int behind;                  /* numbers of materials that stand behind the last item and have not been read */
} array_rows;

/* What a plugin is offered meanwhile: of columns, or of lists. */
pov_host host_arrays(void);
pov_host host_lists(void);
/* Go on with the text of a material, NULL: with nothing. */
void host_begin_material(pov_reader *in, const build_material *m);

#endif
