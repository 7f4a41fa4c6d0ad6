#include "model/material.h"

#include <string.h>

void material_init(material *m)
{
    memset(m, 0, sizeof *m);
    finish_init(&m->finish);
    interior_init(&m->interior);
}

bool pattern_equal(const pattern *a, const pattern *b)
{
    if (a == b || !a || !b)
        return a == b;
    return a->class == b->class && a->map == b->map && a->count == b->count && a->self_size == b->self_size &&
           memcmp(a->list, b->list, a->count * sizeof *a->list) == 0 &&
           (a->self_size == 0 || memcmp(a->self, b->self, a->self_size) == 0);
}

static float larger(float a, float b) { return fabsf(b) > fabsf(a) ? b : a; }

void material_set_pattern(material *m, const pattern *p)
{
    m->pattern = p;
    m->pigment = colour_of(0.0f, 0.0f, 0.0f);
    m->filter = m->transmit = 0.0f;
    for (uint32_t i = 0; i < p->count; i++) {
        const pigment *one = &p->list[i];

        m->pigment = colour_of(larger(m->pigment.r, one->color.r), larger(m->pigment.g, one->color.g),
                               larger(m->pigment.b, one->color.b));
        m->filter = larger(m->filter, one->filter);
        m->transmit = larger(m->transmit, one->transmit);
    }
}

bool material_equal(const material *a, const material *b)
{
    return pattern_equal(a->pattern, b->pattern) && colour_equal(a->pigment, b->pigment) && a->filter == b->filter &&
           a->transmit == b->transmit && finish_equal(&a->finish, &b->finish) &&
           interior_equal(&a->interior, &b->interior) &&
           a->double_illuminate == b->double_illuminate;
}
