/* dielectric.h - the dielectrics that a ray is in: the transparent solids that it has entered and not left.
 *
 * Lists of objects, one behind the other: a ray's list is a span, the one entered last at its end. Lists are made and
 * dropped in the order of a stack. */
#ifndef SHADE_DIELECTRIC_H
#define SHADE_DIELECTRIC_H

#include "world/surface.h"

#include <povtrace/trace.h>

typedef struct dielectric_stack { uint32_t *items; size_t count, capacity; } dielectric_stack;
typedef struct dielectric_span { size_t first, count; } dielectric_span;

/* A ray's crossing of an object's surface, as its list sees it. */
typedef struct dielectric_crossing {
    uint32_t object;
    size_t index;                /* the object's place in the ray's list; the list's length: it is entered */
    double before, after;        /* ior on both sides */
} dielectric_crossing;

/* The ior around a ray is that of the dielectric entered last of those it is in. An object in the list is left, any
 * other is entered; to leave one that is not the last changes nothing but the list. */
void dielectric_cross(const dielectric_stack *stack, dielectric_span in, const model *m, uint32_t which,
                      dielectric_crossing *out);
/* The list of the ray behind the crossing: a new one at the top. False: no memory. */
bool dielectric_pass(dielectric_stack *stack, const env *e, dielectric_span *in, const dielectric_crossing *c);
/* Drop everything above `floor` but the span, which moves down onto it. */
void dielectric_compact(dielectric_stack *stack, dielectric_span *span, size_t floor);
bool dielectric_push(dielectric_stack *stack, const env *e, uint32_t which);

/* Those around the start of camera rays: looked for once for all rays that start at the same point. */
typedef struct dielectric_start {
    dielectric_stack found;      /* those that hold org + org_lo, when known */
    pov_vec3 org, org_lo;
    bool known;
} dielectric_start;

/* False: no memory. */
bool dielectric_find(dielectric_start *s, const env *e, const world *w, const pov_ray *ray);
/* A list of its own for one ray, at the top. False: no memory. */
bool dielectric_begin(dielectric_stack *stack, const env *e, const dielectric_start *from, dielectric_span *out);

#endif
