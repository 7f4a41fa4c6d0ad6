/* pattern.h - the kinds of patterns: values of points in the space in which they were written. One row of a table, and
 * one file, each. */
#ifndef TEXTURE_PATTERN_H
#define TEXTURE_PATTERN_H

#include "base/lanes.h"
#include "model/pattern.h"

enum { PATTERN_LIST_MAX = 8 };

typedef struct pattern_class {
    const char *keyword;
    uint32_t count;              /* number of pigments that its values, 0 to count - 1, select */
    pigment list[PATTERN_LIST_MAX];   /* defaults of pigments that are not given */
    /* Values of n points, lane by lane. Lanes up to lanes_whole(n) may be read and written. */
    void (*evaluate)(const void *self, const vec_lanes *at, uint32_t n, double *value);
} pattern_class;

/* The class of a keyword. NULL: not a pattern. */
const pattern_class *pattern_find(const char *keyword);

#endif
