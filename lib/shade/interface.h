/* interface.h - the interfaces between dielectrics that a batch's surfaces are. */
#ifndef SHADE_INTERFACE_H
#define SHADE_INTERFACE_H

#include "shade/context.h"
#include "shade/surface.h"

static inline bool interface_is_alike(const dielectric_stack *lists, const surface *a, const surface *b)
{
    return a->at->object == b->at->object && a->from->hue == b->from->hue && dielectric_are_alike(lists, a->from->inside, b->from->inside);
}

/* Find what surface `lane` is. Mostly that is what the last one was that was asked for. */
static inline const dielectric_crossing *interface_find(const shade_context *c, surfaces *s, uint32_t lane)
{
    const surface *at = &s->at[lane];
    dielectric_crossing *out = s->interfaces > 0 ? &s->crossing[s->interfaces - 1] : NULL;

    if (!out || !interface_is_alike(&c->dielectrics, at, &s->at[s->last_interface])) {
        out = &s->crossing[s->interfaces++];
        dielectric_cross(&c->dielectrics, at->from->inside, c->scene->model, shading_solid(c->scene, at->at->object), at->from->hue, out);
    }
    s->last_interface = lane;
    s->interface[lane] = (uint8_t)(s->interfaces - 1);
    return out;
}

static inline const dielectric_crossing *interface_at(const surfaces *s, uint32_t lane) { return &s->crossing[s->interface[lane]]; }

#endif
