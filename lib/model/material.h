/* material.h - what a surface does to light. */
#ifndef MODEL_MATERIAL_H
#define MODEL_MATERIAL_H

#include "model/finish.h"
#include "model/interior.h"
#include "model/pattern.h"

typedef struct material {
    const pattern *pattern;      /* the pigment varies; NULL: it is constant. Where it varies, the next three are the
                                  * largest that each component can be: what is zero there is zero everywhere */
    colour pigment;
    float filter, transmit;
    finish finish;
    interior interior;
    bool double_illuminate;      /* light from behind counts as light from the front */
} material;

/* The defaults of the language: black. */
void material_init(material *m);
bool material_equal(const material *a, const material *b);
void material_set_pattern(material *m, const pattern *p);

static inline bool material_is_transparent(const material *m) { return m->filter != 0.0f || m->transmit != 0.0f; }

/* Factor of light that passes the surface. */
static inline colour material_filter_of(colour c, float filter, float transmit)
{
    return colour_add(colour_scale(c, filter), colour_of(transmit, transmit, transmit));
}

static inline colour material_filter(const material *m)
{
    return material_filter_of(m->pigment, m->filter, m->transmit);
}

#endif
