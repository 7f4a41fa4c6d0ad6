/* dielectric.h - nested dielectrics: the transparent solids that a ray has entered and not left.
 *
 * Lists of objects are stored one behind the other: a ray's list is a span, with the object entered last at its end.
 * Lists are allocated and freed like a stack. */
#ifndef SHADE_DIELECTRIC_H
#define SHADE_DIELECTRIC_H

#include "world/surface.h"

#include <povtrace/trace.h>

typedef struct dielectric_stack { uint32_t *items; size_t count, capacity; } dielectric_stack;
typedef struct dielectric_span { size_t first, count; } dielectric_span;

/* A ray's crossing of an interface. */
typedef struct dielectric_crossing {
    uint32_t object;
    size_t index;                /* index of the object in the ray's list; the list's length: it is entered */
    double before, after;        /* ior on both sides */
} dielectric_crossing;

/* The ior around a ray is that of the dielectric entered last. An object in the list is left, any other is entered;
 * leaving one that is not the last changes the list only. */
void dielectric_cross(const dielectric_stack *stack, dielectric_span in, const model *m, uint32_t which, float hue,
                      dielectric_crossing *out);
/* The interior of a solid, and its ior for light of a hue. */
const interior *dielectric_interior(const model *m, uint32_t which);
double dielectric_ior(const interior *in, float hue);
/* The list of the transmitted ray: a new one at the top; with an index of SIZE_MAX the same once more. False: no memory. */
bool dielectric_pass_any(dielectric_stack *stack, const env *e, dielectric_span *in, const dielectric_crossing *c);
/* The same; most rays enter the only one, or leave it. */
static inline bool dielectric_pass(dielectric_stack *stack, const env *e, dielectric_span *in, const dielectric_crossing *c)
{
    const bool enters = in->count == 0, first = c->index == 0;

    if (!first || in->count > 1 || stack->count == stack->capacity)
        return dielectric_pass_any(stack, e, in, c);
    stack->items[stack->count] = c->object;
    in->first = stack->count;
    in->count = enters;
    stack->count += enters;
    return true;
}
/* Drop everything above `floor` except the span, which is moved down onto it. */
static inline void dielectric_compact(dielectric_stack *stack, dielectric_span *span, size_t floor)
{
    for (size_t i = 0; span->first != floor && i < span->count; i++)
        stack->items[floor + i] = stack->items[span->first + i];
    span->first = floor;
    stack->count = floor + span->count;
}
bool dielectric_is_in(const dielectric_stack *stack, dielectric_span in, uint32_t which);
/* Do two lists hold the same? */
static inline bool dielectric_are_alike(const dielectric_stack *stack, dielectric_span a, dielectric_span b)
{
    bool same = a.count == b.count;

    for (size_t i = 0; same && i < a.count; i++)
        same = stack->items[a.first + i] == stack->items[b.first + i];
    return same;
}
bool dielectric_push(dielectric_stack *stack, const env *e, uint32_t which);

/* The dielectrics around the start of camera rays: searched once for all rays with the same start. */
typedef struct dielectric_start {
    dielectric_stack found;      /* those that contain org + org_lo, when known */
    pov_vec3 org, org_lo;
    bool known;
} dielectric_start;

/* False: no memory. */
bool dielectric_find(dielectric_start *s, const env *e, const world *w, const pov_ray *ray);
/* A list of its own for one ray, at the top. False: no memory. */
bool dielectric_begin(dielectric_stack *stack, const env *e, const dielectric_start *from, dielectric_span *out);

#endif
