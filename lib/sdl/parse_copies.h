/* parse_copies.h - declared solids that are used often: each use waits until all has been read, and becomes a copy of a
 * part if that pays, else leaves like those of any object. */
#ifndef SDL_PARSE_COPIES_H
#define SDL_PARSE_COPIES_H

#include "sdl/parse.h"

/* A declared solid as it is used: with its surface, and its transformations in front of that. */
typedef struct copied {
    const object_parsed *object; /* its surface is moved by none that stands behind it */
    const surface_parsed *surface, *defaults;
    const transform *map;        /* NULL: all of them move the surface too */
    uint32_t leaves;             /* 0: it is never stored as a part */
    uint32_t uses;
    const model *part;           /* once it is made */
} copied;

/* A use: before that leaf of the model, moved so. */
typedef struct copy_use { uint32_t of, leaf; const transform *map; place at; } copy_use;

typedef struct copied_list { copied *items; size_t count, capacity; } copied_list;
typedef struct copy_uses { copy_use *items; size_t count, capacity; } copy_uses;

typedef struct copies_read {
    copied_list of;
    copy_uses uses;
    const surface_parsed *defaults;   /* of the last use */
} copies_read;

/* A group of a name, around which are only unions that say nothing but where it is; map: all its transformations, the
 * last `outer` of them from these. True: it waits. */
bool parse_copies_wait(pov_reader *in, const object_parsed *o, const transform *map, uint32_t outer);
/* All has been read. */
void parse_copies_finish(pov_reader *in);
void parse_copies_free(copies_read *all, const env *e);

#endif
