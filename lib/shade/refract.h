/* refract.h - the media that a ray is in, and its bending between them. */
#ifndef SHADE_REFRACT_H
#define SHADE_REFRACT_H

#include "world/surface.h"

/* Lists of media by object index, one behind the other: a ray's list is a span of it, the one entered last at
 * its end. Lists are made and dropped in the order of a stack. */
typedef struct media_stack { uint32_t *items; size_t count, capacity; } media_stack;
typedef struct media_span { size_t first, count; } media_span;

/* A ray's crossing of an object's surface, as the list of media sees it. */
typedef struct media_crossing {
    uint32_t object;
    size_t index;                /* the object's place in the ray's list; the list's length: it is entered */
    double before, after;        /* ior on both sides */
} media_crossing;

/* The medium of a ray is the one entered last of those it is in. An object in the list is left, any other is
 * entered; to leave one that is not the last changes nothing but the list. */
void media_cross(const media_stack *stack, media_span in, const model *m, uint32_t which, media_crossing *out);
/* The list of the ray behind the crossing: a new one at the top. False: no memory. */
bool media_pass(media_stack *stack, const env *e, media_span *in, const media_crossing *c);
/* Drop everything above `floor` but the span, which moves down onto it. */
void media_settle(media_stack *stack, media_span *span, size_t floor);
bool media_push(media_stack *stack, const env *e, uint32_t which);

/* Snell's law. View is the unit direction of the ray, normal the unit normal turned towards its start, cosine
 * the one between them (>= 0). False: total internal reflection. */
bool refract(pov_vec3 view, pov_vec3 normal, double cosine, double before, double after, pov_vec3 *out);

/* The same by lane, to the bit. */
typedef struct bends {
    double before[WORLD_MANY], after[WORLD_MANY];   /* also of lanes that fill the last four */
    double squared_cosine[WORLD_MANY];              /* of the way behind the surface; 0 or less: there is none */
    vec_lanes way;
} bends;
void refract_many(bends *b, const vec_lanes *view, const vec_lanes *normal, const double *cosines, uint32_t n);

#endif
