/* material.h - what a surface does to light. */
#ifndef MODEL_MATERIAL_H
#define MODEL_MATERIAL_H

#include "model/interior.h"
#include "model/texture.h"

typedef struct material {
    const texture *texture;      /* NULL: constant, of the pigment and the finish below. Where there is a texture, what is
                                  * zero in them is zero everywhere */
    const texture *inside;       /* where rays hit the surface from inside; NULL: the same as outside */
    bool needs_uv;               /* the textures ask for the surface's uv coordinates */
    colour pigment;
    float filter, transmit;
    finish finish;
    interior interior;
    bool double_illuminate;      /* light from behind counts as light from the front */
} material;

/* The defaults of the language: black. */
void material_init(material *m);
bool material_equal(const material *a, const material *b);
void material_set_pigment(material *m, pigment p);
/* Set textures, which may be NULL as above, and pigment and finish after them. */
void material_set_textures(material *m, const texture *outside, const texture *inside);

/* Do rays and light pass it as if nothing were there? */
bool material_is_clear(const material *m);

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
