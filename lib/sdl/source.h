/* source.h - the texts that are being read: a stack, so that a text may stop for another and go on behind it.
 * */
#ifndef SDL_SOURCE_H
#define SDL_SOURCE_H

#include "base/env.h"

typedef struct source {
    struct source *below;        /* the text that goes on where this one ends */
    struct source *older;        /* every text ever pushed, for freeing: places in messages point into them */
    const char *name;            /* the caller's, as the text is; both outlive the stack */
    const char *text, *end;
    const char *at;              /* the next byte */
    const char *line_start;
    int line;
} source;

typedef struct source_stack {
    const env *env;
    source *top, *all;
    uint64_t hash;               /* of all texts pushed so far */
} source_stack;

/* A stretch of text: what messages point at. */
typedef struct place {
    const source *source;        /* NULL: nowhere */
    const char *start;
    uint32_t length;
    int line, column;            /* 1-based, the column in bytes */
} place;

void source_init(source_stack *s, const env *e);
void source_free(source_stack *s);
/* Begin to read another text; a byte-order mark of UTF-8 is skipped. False: no memory. */
bool source_push(source_stack *s, const char *text, size_t length, const char *name);
/* Go on with the text below. False: there is none, the stack stays. */
bool source_pop(source_stack *s);

#endif
