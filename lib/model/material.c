#include "model/material.h"

#include <string.h>

void material_init(material *m)
{
    memset(m, 0, sizeof *m);
    m->ambient = colour_of(0.1f, 0.1f, 0.1f);
    m->diffuse = 0.6f;
    m->phong_size = 40.0f;
    m->ior = 1.0;
}

static bool colour_equal(colour a, colour b)
{
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

bool material_equal(const material *a, const material *b)
{
    return colour_equal(a->pigment, b->pigment) && a->filter == b->filter && a->transmit == b->transmit &&
           colour_equal(a->ambient, b->ambient) && a->diffuse == b->diffuse && a->phong == b->phong &&
           a->phong_size == b->phong_size && a->metallic == b->metallic &&
           colour_equal(a->reflection, b->reflection) && a->has_interior == b->has_interior && a->ior == b->ior;
}
