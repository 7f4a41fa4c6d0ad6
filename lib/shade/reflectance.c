#include "shade/reflectance.h"

#include "base/powers.h"
#include "shade/fade.h"
#include "shade/film.h"
#include "shade/highlight.h"
#include "shade/interface.h"

/* The branches of a path's Fresnel equations, as choices. */
SIMD_INLINE double fresnel_of(double cosine, double ratio)
{
    const double squared = ratio * ratio - (1.0 - cosine * cosine), ahead = sqrt(squared > 0.0 ? squared : 0.0);
    const double across = (cosine - ahead) / (cosine + ahead);
    const double along = (ratio * ratio * cosine - ahead) / (ratio * ratio * cosine + ahead);
    const double both = 0.5 * (across * across + along * along), some = squared > 0.0 ? both : 1.0;

    return ratio == 1.0 ? 0.0 : some;
}

double reflectance_fresnel(double cosine, double ratio) { return fresnel_of(cosine, ratio); }

/* ---- surfaces side by side ---- */

/* A cosine below 0 is of a normal that is bent beyond the horizon: as in POV-Ray Fresnel's reflection is whole there. */
SIMD_CLONES static void add_fresnel(reflectances *restrict m, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const double ahead = fresnel_of(m->cosine[i], m->ratio[i]), whole = m->cosine[i] < 0.0 ? 1.0 : ahead;

        m->course[i] = m->fresnel[i] ? whole : m->course[i];
    }
}

SIMD_CLONES static void find_away(reflectances *restrict m, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        m->course[i] = 1.0 - m->cosine[i];
}

static void add_powers(reflectances *m, uint32_t n)
{
    double power[BATCH_MAX];

    for (uint32_t i = 0; i < n; i++)
        power[i] = m->course[i] > 0.0 ? m->course[i] : 0.0;
    powers_raise_each(m->falloff, n, power);
    for (uint32_t i = 0; i < n; i++)
        m->course[i] = m->falloff[i] == 1.0 ? m->course[i] : power[i];
}

SIMD_CLONES static void mix_colours(reflectances *restrict m, int k, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        m->by[k][i] = m->min[k][i] + (m->max[k][i] - m->min[k][i]) * (float)m->course[i];
}

static void find_shares(reflectances *m, bool fresnel, uint32_t n)
{
    double loss[BATCH_MAX];

    for (uint32_t i = 0; i < n; i++)
        loss[i] = fresnel ? m->cosine[i] : 0.0;
    if (fresnel)
        highlight_fresnel_lanes(loss, n);
    for (uint32_t i = 0; i < n; i++)
        m->share[i] = m->metallic[i] * (float)(1.0 - loss[i]);
}

SIMD_CLONES static void dye(reflectances *restrict m, int k, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const float dyed = m->by[k][i] * (1.0f + (m->color[k][i] - 1.0f) * m->share[i]);

        m->by[k][i] = m->metallic[i] != 0.0f ? dyed : m->by[k][i];
    }
}

static colour colour_at(const reflectances *m, uint32_t i) { return colour_of(m->by[0][i], m->by[1][i], m->by[2][i]); }

static void find_all(reflectances *m, const model *of)
{
    const uint32_t n = m->count;

    find_away(m, n);
    if (m->has_powers)
        add_powers(m, n);
    if (m->has_fresnel)
        add_fresnel(m, n);
    if (m->has_metal)
        find_shares(m, of->fresnel_metallic, n);
    for (int k = 0; k < 3; k++)
        mix_colours(m, k, n);
    for (uint32_t i = 0; i < n; i++)
        m->weight[i] = m->fresnel[i] ? colour_weight(colour_at(m, i)) : m->most[i];
    for (int k = 0; m->has_metal && k < 3; k++)
        dye(m, k, n);
}

/* The ior of the object over that of the dielectric entered last, and the inverse where the ray leaves the object. That is the
 * ior ahead over that behind but for a ray that leaves one dielectric within another: for POV-Ray the one that was entered
 * last is the one ahead. If that is the object itself, there is none of Fresnel's reflection. Nor does it know of dispersion. */
static double ratio_at(const shade_context *c, const surface *s, const dielectric_crossing *at)
{
    const model *m = c->scene->model;
    const dielectric_span in = s->from->inside;
    dielectric_crossing white = *at;

    if (s->from->hue >= 0.0f)
        dielectric_cross(&c->dielectrics, in, m, at->object, -1.0f, &white);
    if (white.index == in.count)
        return white.after / white.before;
    if (white.index + 1 == in.count)
        return in.count == 1 ? 1.0 / white.before : 1.0;
    return white.before / dielectric_ior(dielectric_interior(m, at->object), -1.0f);
}

static void put_colour(float out[3][BATCH_MAX], uint32_t i, colour c)
{
    out[0][i] = c.r;
    out[1][i] = c.g;
    out[2][i] = c.b;
}

/* What holds at any angle. */
static void put_constants(reflectances *m, uint32_t i, const appearance *a)
{
    const reflection *r = &a->finish->reflection;

    m->falloff[i] = colour_equal(r->min, r->max) ? 1.0 : (double)r->falloff;
    m->fresnel[i] = a->fresnel;
    m->ratio[i] = 1.0;
    m->most[i] = pov_maxf(colour_weight(r->min), colour_weight(r->max));   /* at any angle, as in POV-Ray */
    m->metallic[i] = r->metallic;
    put_colour(m->min, i, r->min);
    put_colour(m->max, i, r->max);
    put_colour(m->color, i, a->pigment);
    m->has_fresnel |= a->fresnel;
    m->has_powers |= m->falloff[i] != 1.0;
    m->has_metal |= r->metallic != 0.0f;
}

/* i: the last of the lanes. */
static inline void put_ratio(const shade_context *c, reflectances *m, surfaces *s, uint32_t i, uint32_t lane)
{
    const uint32_t known = s->interfaces;
    const dielectric_crossing *at;

    if (!s->at[lane].appearance->fresnel)
        return;
    at = interface_find(c, s, lane);
    if (s->interfaces > known)
        m->last_ratio = ratio_at(c, &s->at[lane], at);
    m->ratio[i] = m->last_ratio;
}

/* Batches of one appearance often follow one another: then what holds at any angle stands in its lanes. */
static bool begin_alike(reflectances *m, const surfaces *s)
{
    const appearance *a = s->count > 0 ? s->at[0].appearance : NULL;
    const bool same = a && s->alike && a->lasts && a->angular;

    if (m->held != a || !same) {
        m->has_fresnel = m->has_powers = m->has_metal = false;
        m->held_count = 0;
    }
    m->held = same ? a : NULL;
    m->count = same ? s->count : 0;
    for (; m->held_count < m->count; m->held_count++)
        put_constants(m, m->held_count, a);
    return same;
}

/* Surfaces whose reflection depends on the angle. True: all, and they are of one appearance. */
static bool begin(const shade_context *c, reflectances *m, surfaces *s)
{
    const bool same = begin_alike(m, s);

    if (same)
        memcpy(m->cosine, s->geometry.cosine, s->count * sizeof m->cosine[0]);
    for (uint32_t i = 0; same && m->has_fresnel && i < s->count; i++)
        put_ratio(c, m, s, i, i);
    for (uint32_t i = 0; !same && i < s->count; i++) {
        if (!s->at[i].appearance->angular)
            continue;
        put_constants(m, m->count, s->at[i].appearance);
        m->of[m->count] = (uint8_t)i;
        m->cosine[m->count] = s->geometry.cosine[i];
        put_ratio(c, m, s, m->count++, i);
    }
    return same;
}

/* Is the light that it mirrors filmed here? */
static bool is_filmed(const appearance *a) { return a->finish->irid.amount != 0.0f && !a->powered; }

/* through: the factor of the filter. */
static void set(const shade_context *c, surfaces *s, uint32_t lane, coefficient mirrored, float through)
{
    const appearance *a = s->at[lane].appearance;
    const finish *f = a->finish;
    const colour by = mirrored.by;
    onward out = a->onward;
    colour filter = out.filter.by;

    if (f->conserve_energy)
        filter = colour_mul(filter, colour_of(1.0f - by.r, 1.0f - by.g, 1.0f - by.b));
    if (f->conserve_energy || through != 1.0f)
        onward_set_filter(&out, c->scene->model, colour_scale(filter, through));
    s->reflection[lane] = mirrored;
    s->filter[lane] = out.filter;
    s->dark[lane] = out.dark;
}

/* What light loses on its way does not count in the weight of a ray, as POV-Ray has it: it is a factor of its own. */
static void fade_all(const shade_context *c, surfaces *s)
{
    for (uint32_t i = 0; i < s->count; i++) {
        surface *at = &s->at[i];

        at->faded = colour_of(1.0f, 1.0f, 1.0f);
        if (!at->appearance->clear)
            fade_inside(c, at->from, at->ray, at->at, &at->faded);
    }
}

/* Filters of one appearance, and their weights, side by side. */
typedef struct SIMD_ALIGNED filters { float by[3][BATCH_MAX], weight[BATCH_MAX], luminance[BATCH_MAX]; } filters;

SIMD_CLONES static void find_filters(const reflectances *restrict m, colour own, bool conserves, float through, uint32_t n, filters *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const colour left = colour_of(1.0f - m->by[0][i], 1.0f - m->by[1][i], 1.0f - m->by[2][i]);
        const colour by = colour_scale(colour_mul(own, conserves ? left : colour_of(1.0f, 1.0f, 1.0f)), through);

        out->by[0][i] = by.r;
        out->by[1][i] = by.g;
        out->by[2][i] = by.b;
        out->weight[i] = colour_weight(by);
        out->luminance[i] = fabsf(colour_luminance(by));
    }
}

/* All surfaces, which have this appearance. filtered: something asks what goes through them. */
static void set_alike(const model *m, surfaces *s, const appearance *a, float through, bool filtered)
{
    const reflectances *r = &s->reflectances;
    const bool conserves = a->finish->conserve_energy, changes = conserves || through != 1.0f;
    const float least = m->opaque_dark_filters ? (float)m->adc_bailout : -1.0f;
    filters f;

    for (uint32_t i = 0; i < r->count; i++) {
        const coefficient mirrored = { colour_at(r, i), r->weight[i] };

        s->reflection[i] = mirrored;
    }
    if (!filtered)
        return;
    if (changes)
        find_filters(r, a->onward.filter.by, conserves, through, r->count, &f);
    for (uint32_t i = 0; i < r->count; i++) {
        const coefficient filter = { colour_of(f.by[0][i], f.by[1][i], f.by[2][i]), f.weight[i] };

        s->filter[i] = changes ? filter : a->onward.filter;
        s->dark[i] = changes ? f.luminance[i] < least : a->onward.dark;
    }
}

/* Of lanes whose reflection is set. */
static void add_films(const shade_context *c, surfaces *s, const uint8_t *lanes, uint32_t n)
{
    const geometry *g = &s->geometry;
    films all;

    all.count = 0;
    for (uint32_t k = 0; k < n; k++) {
        all.cosines[k] = geometry_cosines(g, lanes[k]);
        films_add(&all, s->at[lanes[k]].appearance->finish, lanes_at(&g->to.point, lanes[k]));
    }
    films_find(&all, c->scene->model);
    films_mirrored(&all, c->scene->model);
    for (uint32_t k = 0; k < n; k++) {
        colour *by = &s->reflection[lanes[k]].by;

        *by = colour_mul(*by, colour_of(all.factor[0][k], all.factor[1][k], all.factor[2][k]));
        s->film[lanes[k]] = all.thickness[k];
        s->filmed |= (uint64_t)1 << lanes[k];
    }
}

/* layered: the filter's factor is that of a whole stack. */
static void set_all(const shade_context *c, surfaces *s, bool layered)
{
    reflectances *m = &s->reflectances;
    const bool same = begin(c, m, s);
    uint8_t filmed[BATCH_MAX];
    uint32_t films_count = 0;

    s->filmed = 0;
    find_all(m, c->scene->model);
    if (same && m->held->finish->irid.amount == 0.0f) {
        set_alike(c->scene->model, s, m->held, layered ? 1.0f : m->held->finish->refraction, layered || m->held->transmissive);
        return;
    }
    for (uint32_t k = 0; k < m->count; k++) {
        const coefficient mirrored = { colour_at(m, k), m->weight[k] };
        const uint32_t i = same ? k : m->of[k];

        set(c, s, i, mirrored, layered ? 1.0f : s->at[i].appearance->finish->refraction);
        if (is_filmed(s->at[i].appearance))
            filmed[films_count++] = (uint8_t)i;
    }
    if (films_count > 0)
        add_films(c, s, filmed, films_count);
}

static void set_any(const shade_context *c, surfaces *s, bool layered)
{
    if (c->scene->plan->fading)
        fade_all(c, s);
    if (c->scene->angular)
        set_all(c, s, layered);
}

void reflectance_set(const shade_context *c, surfaces *s) { set_any(c, s, false); }

void reflectance_set_layers(const shade_context *c, surfaces *s) { set_any(c, s, true); }
