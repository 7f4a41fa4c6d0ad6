#include "shade/light.h"

#include "base/bits.h"
#include "base/simd.h"
#include "shade/highlight.h"

#include <povtrace/exact.h>

/* How surfaces see one light, by lane. */
typedef struct light_sample {
    vec_lanes dir;               /* from the surface to the light */
    double cosine[BATCH_MAX];    /* between it and the normal */
    double specular_cos[BATCH_MAX];   /* ... and the mirrored ray */
    float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX];   /* what they send on when nothing stands in the way */
    uint32_t odd[BATCH_MAX];     /* 1: that is not known yet */
    uint32_t front[BATCH_MAX], contributes[BATCH_MAX];   /* 1: the light is before it; and it sends anything on */
} light_sample;

static inline void sample(light_sample *s, const geometry *g, uint32_t i, pov_vec3 direction)
{
    s->cosine[i] = pov_dot(lanes_at(&g->to.normal, i), direction);
    s->specular_cos[i] = pov_dot(lanes_at(&g->mirrored, i), direction);
}

/* From a point to the light along one axis, rounded once: both ends have two parts, so that a light may be near or far.
 * Of a light without a low part less is left to do for the same bits. */
static inline double towards(double l, double l_lo, double p, double p_lo, bool low)
{
    pov_two way;

    if (low)
        return pov_two_sub(pov_two_of(l, l_lo), pov_two_of(p, p_lo)).hi;
    way = pov_two_sum(l, -p);
    return way.hi + (way.lo + (0.0 - p_lo));
}

/* What looking at a light finds besides: a way so short or long that its square is none; a cosine too small for
 * world_leave(). */
enum { ODD_WAY = 1, GRAZING = 2 };

static inline int sample_all(light_sample *restrict s, const geometry *restrict g, const light *restrict l, uint32_t n, bool low)
{
    const pov_vec3 at = l->position, at_lo = l->position_lo;
    int64_t plain = -1, steep = -1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 direction;

        s->dir.x[i] = towards(at.x, at_lo.x, g->to.point.x[i], g->to.point_lo.x[i], low);
        s->dir.y[i] = towards(at.y, at_lo.y, g->to.point.y[i], g->to.point_lo.y[i], low);
        s->dir.z[i] = towards(at.z, at_lo.z, g->to.point.z[i], g->to.point_lo.z[i], low);
        plain &= geometry_unit(s->dir.x[i], s->dir.y[i], s->dir.z[i], &direction);
        sample(s, g, i, direction);
        steep &= fabs(s->cosine[i]) > WORLD_AWAY ? -1 : 0;
    }
    return (plain ? 0 : ODD_WAY) | (steep ? 0 : GRAZING);
}

SIMD_CLONES static int sample_plain(light_sample *restrict s, const geometry *restrict g, const light *restrict l, uint32_t n)
{
    return sample_all(s, g, l, n, false);
}

SIMD_CLONES static int sample_low(light_sample *restrict s, const geometry *restrict g, const light *restrict l, uint32_t n)
{
    return sample_all(s, g, l, n, true);
}

/* True: there may be a cosine too small for world_leave(). */
static bool sample_light(light_sample *s, const geometry *g, const light *l, uint32_t n)
{
    const pov_vec3 lo = l->position_lo;
    const bool low = lo.x != 0.0 || lo.y != 0.0 || lo.z != 0.0;
    const int found = low ? sample_low(s, g, l, n) : sample_plain(s, g, l, n);

    if (found & ODD_WAY)
        for (uint32_t i = 0; i < n; i++)
            sample(s, g, i, pov_unit(lanes_at(&s->dir, i)));
    return found != 0;
}

/* What white light becomes on its way to the ray's start, with a highlight. */
static colour brdf(const model *m, const appearance *of, double cosine, double specular_cos)
{
    const colour diffuse = colour_scale(of->pigment, of->diffuse_weight * (float)cosine);
    const float strength = of->material->phong * highlight_power(specular_cos, of);

    return colour_add(diffuse, colour_scale(highlight_colour(m, of, cosine), strength));
}

static inline float lesser(float a, float b) { return a < b ? a : b; }

/* What of the light's colour all send on, to the bit as above where there is a highlight. One that is lost in the sum
 * is none: all components of that are then as large as APPEARANCE_VISIBLE. It is not computed either, for floats below the
 * range of normal ones take a processor a hundred times as long. False: some are odd. */
SIMD_CLONES static bool brdf_plain(light_sample *restrict s, const finishes *restrict f, colour of, uint32_t n)
{
    uint32_t odd = 0;

    for (uint32_t i = 0; i < n; i++) {
        const double cosine = s->cosine[i], specular_cos = s->specular_cos[i];
        const float part = f->diffuse_weight[i] * (float)cosine;
        const float red = f->red[i] * part, green = f->green[i] * part, blue = f->blue[i] * part;
        const float least = lesser(fabsf(red), lesser(fabsf(green), fabsf(blue)));
        const bool shines = (cosine > 0.0) & (specular_cos > 0.0) & !((specular_cos <= f->highlight_cutoff[i]) & (least >= APPEARANCE_VISIBLE));
        const double product = highlight_product(shines ? specular_cos : 0.0, f->power[i]);
        const float lo = f->phong[i] * highlight_lo(product), hi = f->phong[i] * highlight_hi(product);
        const float strength = shines ? lo : 0.0f;

        s->odd[i] = shines & !(lo == hi);
        odd |= s->odd[i];
        s->red[i] = of.r * (red + strength);
        s->green[i] = of.g * (green + strength);
        s->blue[i] = of.b * (blue + strength);
        s->front[i] = cosine > 0.0;
        s->contributes[i] = (cosine > 0.0) & !colour_is_black(colour_of(s->red[i], s->green[i], s->blue[i]));
    }
    return !odd;
}

static void brdf_all(const lighting *l, light_sample *s, colour of, uint32_t n)
{
    const model *m = l->context->scene->model;

    if (brdf_plain(s, &l->finishes, of, n))
        return;
    for (uint32_t k = 0; k < l->lit_count; k++) {
        const uint32_t i = l->lit[k];
        colour c;

        if (!s->odd[i])
            continue;
        c = colour_mul(of, brdf(m, l->on->at[i].appearance, s->cosine[i], s->specular_cos[i]));
        s->red[i] = c.r;
        s->green[i] = c.g;
        s->blue[i] = c.b;
        s->contributes[i] = s->front[i] & !colour_is_black(c);
    }
}

static inline colour given_at(const light_sample *s, uint32_t i) { return colour_of(s->red[i], s->green[i], s->blue[i]); }

/* The rays from lit surfaces that the light is before and that send anything on. Nothing is decided by branches, which
 * nobody could guess. Returns how many the light is before. */
static uint32_t aim(lighting *l, const light_sample *s)
{
    pov_ray *const own = l->own;
    const size_t lit_count = l->lit_count;
    uint32_t front = 0;
    size_t count = 0;

    for (size_t k = 0; k < lit_count; k++) {
        const size_t i = l->lit[k];

        own[i].dir = lanes_at(&s->dir, (uint32_t)i);
        l->rays[count] = &own[i];
        l->of[count] = (uint8_t)i;
        front += s->front[i];
        count += s->contributes[i];
    }
    l->count = (uint32_t)count;
    return front;
}

static bool any_on_spot(const lighting *l)
{
    for (uint32_t i = 0; i < l->count; i++)
        if (l->on->at[l->of[i]].spot)
            return true;
    return false;
}

/* Rays from coincident surfaces are traced one by one. */
static uint64_t trace_each(const lighting *l, colour *through)
{
    const shade_context *c = l->context;
    const world *w = c->scene->world;
    uint64_t lit = 0;

    for (uint32_t i = 0; i < l->count; i++) {
        const uint32_t at = l->on->at[l->of[i]].spot;
        const bool is_lit = at ? world_light_path_from(w, c->walker, &c->spots.items[at - 1], l->rays[i], 1.0, &through[i])
                               : world_light_path(w, c->walker, l->rays[i], 1.0, &through[i]);
        lit |= (uint64_t)is_lit << i;
    }
    return lit;
}

/* Of the rays to a light those that get there. */
static uint64_t trace(const lighting *l, colour *through)
{
    shade_context *c = l->context;

    c->counts.shadow += l->count;
    if (c->spots.count > 0 && any_on_spot(l))
        return trace_each(l, through);
    return world_light_path_many(c->scene->world, c->walker, l->rays, l->count, 1.0, through);
}

static inline void add_light(surface *s, colour given) { s->lit = colour_add(s->lit, given); }

static void add_visible(const lighting *l, const light_sample *s)
{
    colour through[BATCH_MAX];

    if (!l->context->scene->plan->shadows)
        for (uint32_t i = 0; i < l->count; i++)
            add_light(&l->on->at[l->of[i]], given_at(s, l->of[i]));
    else
        for (uint64_t lit = trace(l, through); lit; lit &= lit - 1) {
            const uint32_t i = first_of64(lit);

            add_light(&l->on->at[l->of[i]], colour_mul(given_at(s, l->of[i]), through[i]));
        }
}

/* What rays from the lit surfaces leave, at these cosines. NULL: at none so small that it matters. */
static void name_left(lighting *l, const double *cosines)
{
    for (uint32_t k = 0; k < l->lit_count; k++) {
        const uint32_t i = l->lit[k];

        world_leave(&l->own[i], l->on->at[i].at, cosines ? cosines[i] : 1.0);
    }
}

/* What one light gives the lit surfaces. */
static void add_light_source(lighting *l, const light *from)
{
    shade_context *c = l->context;
    const uint32_t n = lanes_whole(l->on->count);
    uint32_t front;
    light_sample s;
    const bool grazing = sample_light(&s, &l->on->geometry, from, n);

    if (grazing)
        name_left(l, s.cosine);
    brdf_all(l, &s, from->color, n);
    front = aim(l, &s);
    c->counts.shadow_behind += l->lit_count - front;
    c->counts.shadow_idle += front - l->count;
    if (l->count > 0)
        add_visible(l, &s);
    if (grazing)
        name_left(l, NULL);
    c->failed = c->failed || walker_failed(c->walker);
}

static inline void set_finish(finishes *f, uint32_t i, const appearance *a)
{
    f->red[i] = a->pigment.r;
    f->green[i] = a->pigment.g;
    f->blue[i] = a->pigment.b;
    f->diffuse_weight[i] = a->diffuse_weight;
    f->phong[i] = a->phong;
    f->highlight_cutoff[i] = a->highlight_cutoff;
    f->power[i] = a->power;
}

/* The surfaces that lights change; rays from them start all alike, to whatever light. */
static void begin(lighting *l, shade_context *c, surfaces *on)
{
    uint32_t count = 0;

    l->context = c;
    l->on = on;
    for (uint32_t i = 0; i < on->count; i++) {
        const surface *s = &on->at[i];
        pov_ray *ray = &l->own[i];

        if (!s->appearance->lit)
            continue;
        l->lit[count++] = (uint8_t)i;
        set_finish(&l->finishes, i, s->appearance);
        ray->org = s->at->point;
        ray->org_lo = s->at->point_lo;
        world_leave(ray, s->at, 1.0);
    }
    l->lit_count = count;
}

void light_gather(lighting *l, shade_context *c, surfaces *on)
{
    const light_list *lights = &c->scene->model->lights;

    begin(l, c, on);
    for (size_t k = 0; l->lit_count > 0 && k < lights->count; k++) {
        if (c->failed || interrupt_is_due(&c->interrupt, l->lit_count))
            return;
        add_light_source(l, &lights->items[k]);
    }
}
