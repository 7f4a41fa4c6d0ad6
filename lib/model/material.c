#include "model/material.h"

#include <string.h>

void material_init(material *m)
{
    memset(m, 0, sizeof *m);
    finish_init(&m->finish);
    interior_init(&m->interior);
}

void material_set_textures(material *m, const texture *outside, const texture *inside)
{
    const texture *const both[] = { outside, inside };
    const texture all = { .blend = BLEND_LIST, .count = inside ? 2 : 1, .textures = both };
    pigment most;

    m->texture = outside;
    m->inside = inside;
    if (!outside)
        return;
    m->needs_uv = texture_has_uv(&all);
    texture_bounds(&all, &most, &m->finish);
    material_set_pigment(m, most);
}

void material_set_pigment(material *m, pigment p)
{
    m->pigment = p.color;
    m->filter = p.filter;
    m->transmit = p.transmit;
}

bool material_equal(const material *a, const material *b)
{
    return a->texture == b->texture && a->inside == b->inside && colour_equal(a->pigment, b->pigment) &&
           a->filter == b->filter && a->transmit == b->transmit && finish_equal(&a->finish, &b->finish) &&
           interior_equal(&a->interior, &b->interior) && a->double_illuminate == b->double_illuminate;
}

bool material_is_clear(const material *m)
{
    const finish *f = &m->finish;

    return !m->texture && !m->inside && m->filter + m->transmit == 1.0f && colour_equal(material_filter(m), colour_of(1.0f, 1.0f, 1.0f)) &&
           !m->interior.given && !m->interior.media && !finish_is_glossy(f) && !finish_is_mirror(f) && !finish_is_angular(f) && f->crand == 0.0f;
}
