/* source.h - the texts that are read: what places in messages point into. */
#ifndef SDL_SOURCE_H
#define SDL_SOURCE_H

#include "base/env.h"

typedef struct source {
    struct source *older;        /* every text of a reader, for freeing */
    const char *name;
    const char *text, *end;
    const char *at;              /* the next byte */
    const char *line_start;
    int line;
    char *owned;                 /* text and name of an included file; NULL: another's, which outlive the source */
    struct token_buffer *tokens; /* of a file that is included often; NULL: not yet */
    int again;                   /* how often its text was read after the first time */
} source;

typedef struct source_list {
    const env *env;
    source *all;
    uint64_t hash;               /* of all texts so far */
} source_list;

/* A stretch of text: what messages point at. */
typedef struct place {
    const source *source;        /* NULL: nowhere */
    const char *start;
    uint32_t length;
    int line, column;            /* 1-based, the column in bytes */
} place;

void source_init(source_list *s, const env *e);
void source_free(source_list *s);
/* Another text, to be read from its beginning; a byte-order mark of UTF-8 is skipped. NULL: no memory. */
source *source_add(source_list *s, const char *text, size_t length, const char *name);

#endif
