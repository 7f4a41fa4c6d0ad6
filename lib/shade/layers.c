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

static uint32_t count_terms(const painted *p, uint32_t of)
{
    const uint32_t count = p->first[of + 1] - p->first[of];

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

/* The term before the next one; t NULL: the surface's texture is constant, or its terms are as one. */
static void add(const shade_context *c, layers *l, const surfaces *s, const painted *p, const texture_term *t)
{
    surfaces *on = &l->on;
    const uint32_t i = on->count++, lane = l->surface;
    const texture_term *next = term_at(p, lane, l->term);
    layer *out = &l->of[i];

    out->of = (uint8_t)lane;
    out->first = !t || t->first;
    out->last = !next || next->first;
    out->share = t ? t->share : 1.0f;
    on->at[i] = s->at[lane];
    on->rays[i] = s->rays[lane];
    on->found[i] = s->found[lane];
    copy_geometry(&on->geometry, i, &s->geometry, lane);
    lanes_put(&on->geometry.bent, i, paint_normal(s, lane, t));
    if (!t)
        return;
    paint_appearance(c->scene, &s->at[lane], t, !out->last, &on->varying[i]);
    on->at[i].appearance = &on->varying[i];
}

/* ---- weights ---- */

/* A layer that nothing is left for is as if it were not there. */
static void hide(surfaces *on, uint32_t i, layer *out)
{
    appearance *own = &on->varying[i];

    *own = *on->at[i].appearance;
    own->lit = own->gathers = own->reflective = own->transmissive = false;
    own->emitted = out->by = colour_of(0.0f, 0.0f, 0.0f);
    on->at[i].appearance = own;
}

/* A share does not count in the weight of a ray. */
static coefficient share_of(colour c, float share)
{
    const coefficient out = { colour_scale(c, share), colour_weight(c) };

    return out;
}

/* What a layer lets through is what is left for those below it, and at the end for the transmitted ray. What it reflects
 * is not filtered by those above it, but they count in its weight, as POV-Ray has it. */
static void weigh(const shade_context *c, layers *l, uint32_t i)
{
    layer *out = &l->of[i];
    const appearance *a = l->on.at[i].appearance;

    if (out->first)
        l->left = colour_of(1.0f, 1.0f, 1.0f);
    if (!out->first && appearance_is_dark(c->scene->model, l->left)) {
        hide(&l->on, i, out);
        return;
    }
    out->by = colour_scale(l->left, out->share);
    out->reflection = share_of(a->reflection.by, out->share);
    out->reflection.weight *= fabsf(colour_luminance(l->left));
    l->left = colour_mul(l->left, a->filter.by);
    out->through = share_of(colour_scale(l->left, a->finish->refraction), out->share);
    out->is_dark = appearance_is_dark(c->scene->model, l->left);
}

/* Do the terms of the next surface fit? Only a surface with more terms than a batch is divided. */
static bool fits(const layers *l, const painted *p)
{
    return l->on.count == 0 || l->on.count + count_terms(p, l->surface) <= BATCH_MAX;
}

static void fill(const shade_context *c, layers *l, const surfaces *s, const painted *p)
{
    l->on.count = 0;
    l->on.shared = true;
    while (l->surface < s->count && (l->term > 0 || fits(l, p)) && l->on.count < BATCH_MAX) {
        add(c, l, s, p, term_at(p, l->surface, l->term++));
        if (l->term < count_terms(p, l->surface))
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
        weigh(c, l, i);
    return true;
}
