/* pattern.h - a varying pigment: a pattern gives each point a value that selects from a list. */
#ifndef MODEL_PATTERN_H
#define MODEL_PATTERN_H

#include "model/colour.h"

#include <stddef.h>
#include <stdint.h>

struct pattern_class;

typedef struct pigment { colour color; float filter, transmit; } pigment;

typedef struct pattern {
    const struct pattern_class *class;
    const void *self;            /* parsed form of its own keywords; NULL: it has none */
    size_t self_size;
    uint32_t map;                /* number in the model's map table of the pigment's own transformations */
    uint32_t count;
    const pigment *list;
} pattern;

bool pattern_equal(const pattern *a, const pattern *b);

#endif
