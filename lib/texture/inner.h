/* inner.h - patterns made of other parts of a scene: object, pigment_pattern and function. */
#ifndef TEXTURE_INNER_H
#define TEXTURE_INNER_H

#include "texture/pattern.h"

/* An object that is asked for points alone. A leaf has inside(), a group members. */
typedef struct solid_part {
    node_op op;
    bool is_inverse, has_map;
    double map[3][4];            /* inverse */
    bool (*inside)(const void *self, pov_vec3 point, pov_vec3 low);   /* NULL: of a group, or of what has no inside */
    const void *self;
    const struct solid_part *first, *next;
} solid_part;

/* The parsed forms. */
typedef struct object_pattern { const solid_part *solid; } object_pattern;
typedef struct pigment_pattern { const pigment_node *pigment; } pigment_pattern;

/* What pigments gave for functions lately, each for a few points: members of an average often ask one for its components, each of the same
 * points. Begin with a count of 0. */
enum { FUNCTION_LANES = 16, FUNCTION_MEMO = 8 };
typedef struct function_said {
    const void *of;
    uint32_t n;
    double at[3][FUNCTION_LANES];
    pigment found[FUNCTION_LANES];
} function_said;
typedef struct function_memo {
    uint32_t count, next;        /* next: the one that goes when all are there */
    function_said said[FUNCTION_MEMO];
} function_memo;

/* What a function of x, y and z is asked with. */
typedef struct function_pattern {
    void (*values)(const void *self, const vec_lanes *at, uint32_t n, function_memo *memo, double *out);
    const void *self;
} function_pattern;

extern const pattern_class pattern_object, pattern_pigment_pattern, pattern_function;

bool solid_holds(const solid_part *s, pov_vec3 point);

#endif
