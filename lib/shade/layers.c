#include "shade/layers.h"

#include "shade/reflectance.h"

void layers_begin(layers *l) { l->surface = l->term = 0; }

/* ---- terms as surfaces ---- */

static const texture_term *term_at(const painted *p, uint32_t of, uint32_t k)
{
    if (paint_is_merged(p, of))
        return NULL;
    return p->first[of] + k < p->first[of + 1] ? &p->terms[p->order[p->first[of] + k]] : NULL;
}

static uint32_t count_terms(const surfaces *s, const painted *p, uint32_t of)
{
    const uint32_t count = p->first[of + 1] - p->first[of];
    const stack *constant = s->at[of].appearance->stack;

    if (constant)
        return constant->count;
    return count > 0 && !paint_is_merged(p, of) ? count : 1;
}

static void copy_geometry(geometry *to, uint32_t i, const geometry *from, uint32_t lane)
{
    lanes_put(&to->to.dir, i, lanes_at(&from->to.dir, lane));
    lanes_put(&to->to.point, i, lanes_at(&from->to.point, lane));
    lanes_put(&to->to.point_lo, i, lanes_at(&from->to.point_lo, lane));
    lanes_put(&to->to.normal, i, lanes_at(&from->to.normal, lane));
    lanes_put(&to->smooth, i, lanes_at(from->raw, lane));
}

/* One more surface at the hit of the present one. */
static uint32_t begin_layer(layers *l, const surfaces *s)
{
    surfaces *on = &l->on;
    const uint32_t i = on->count++, lane = l->surface;

    on->at[i] = s->at[lane];
    on->rays[i] = s->rays[lane];
    on->found[i] = s->found[lane];
    copy_geometry(&on->geometry, i, &s->geometry, lane);
    return i;
}

/* The term before the next one; t NULL: the surface's texture is constant, or its terms are as one. */
static void add(const shade_context *c, layers *l, const surfaces *s, const painted *p, const texture_term *t)
{
    const uint32_t i = begin_layer(l, s), lane = l->surface;
    const texture_term *next = term_at(p, lane, l->term + 1);
    layer *out = &l->of[i];

    out->of = (uint8_t)lane;
    out->first = !t || t->first;
    out->last = !next || next->first;
    out->is_weighed = false;
    out->share = t ? t->share : 1.0f;
    lanes_put(&l->on.geometry.bent, i, paint_normal(s, lane, t));
    if (!t)
        return;
    paint_appearance(c->scene, &s->at[lane], t, &l->on.varying[i]);
    l->on.at[i].appearance = &l->on.varying[i];
}

/* The next layer of a stack that is alike everywhere. */
static void add_constant(layers *l, const surfaces *s, const stack *of)
{
    const uint32_t i = begin_layer(l, s), lane = l->surface;
    const stack_layer *one = &of->layers[l->term];

    l->of[i] = one->of;
    l->of[i].of = (uint8_t)lane;
    lanes_put(&l->on.geometry.bent, i, lanes_at(s->geometry.raw, lane));
    l->on.at[i].appearance = &one->appearance;
}

/* ---- weights ---- */

static void weigh(const shade_context *c, layers *l, uint32_t i)
{
    const appearance *a = l->on.at[i].appearance;
    appearance *own = &l->on.varying[i];
    const onward on = surfaces_onward(&l->on, i);

    if (layer_weigh(&l->of[i], l->of[i].share, c->scene->model, a, &on, &l->left))
        return;
    if (a != own)
        *own = *a;
    layer_hide(&l->of[i], own);
    l->on.at[i].appearance = own;
}

/* Do the terms of the next surface fit? Only a surface with more terms than a batch is divided. */
static bool fits(const layers *l, const surfaces *s, const painted *p)
{
    return l->on.count == 0 || l->on.count + count_terms(s, p, l->surface) <= BATCH_MAX;
}

static void add_next(const shade_context *c, layers *l, const surfaces *s, const painted *p)
{
    const stack *constant = s->at[l->surface].appearance->stack;

    if (constant)
        add_constant(l, s, constant);
    else
        add(c, l, s, p, term_at(p, l->surface, l->term));
}

static void fill(const shade_context *c, layers *l, const surfaces *s, const painted *p)
{
    l->on.count = l->on.interfaces = 0;
    l->on.alike = false;
    l->on.shared = true;
    while (l->surface < s->count && (l->term > 0 || fits(l, s, p)) && l->on.count < BATCH_MAX) {
        add_next(c, l, s, p);
        if (++l->term < count_terms(s, p, l->surface))
            continue;
        l->surface++;
        l->term = 0;
    }
}

bool layers_take(const shade_context *c, layers *l, const surfaces *s, const painted *p)
{
    surfaces *on = &l->on;

    fill(c, l, s, p);
    if (on->count == 0)
        return false;
    on->geometry.shading = &on->geometry.bent;
    on->geometry.raw = &on->geometry.smooth;
    geometry_turn(&on->geometry, on->count);
    if (c->scene->angular || c->scene->plan->fading)
        reflectance_set_layers(c, on);
    for (uint32_t i = 0; i < on->count; i++)
        if (!l->of[i].is_weighed)
            weigh(c, l, i);
    return true;
}
