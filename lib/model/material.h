/* material.h - what a surface does to light. */
#ifndef MODEL_MATERIAL_H
#define MODEL_MATERIAL_H

#include "model/colour.h"

typedef struct material {
    colour pigment;
    float filter, transmit;
    colour ambient;              /* finish */
    float diffuse, phong, phong_size, metallic;
    colour reflection;
    bool has_interior;           /* an interior { } was given: the solid is a medium */
    double ior;
} material;

/* The defaults of the language: black, ambient 0.1, diffuse 0.6, phong_size 40, ior 1, all else 0. */
void material_init(material *m);
bool material_equal(const material *a, const material *b);

static inline bool material_is_transparent(const material *m) { return m->filter != 0.0f || m->transmit != 0.0f; }

/* Factor of light that passes the surface. */
static inline colour material_filter(const material *m)
{
    colour c = colour_scale(m->pigment, m->filter);

    return colour_add(c, colour_of(m->transmit, m->transmit, m->transmit));
}

#endif
