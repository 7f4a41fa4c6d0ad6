#include "shade/light.h"

#include "base/bits.h"
#include "base/simd.h"
#include "shade/geometry.h"
#include "shade/pigment.h"

#include <povtrace/exact.h>

/* How surfaces see one light, by lane. */
typedef struct sight {
    vec_lanes way;               /* from the surface to the light */
    double cosine[BATCH_MAX];    /* between it and the normal */
    double gloss[BATCH_MAX];     /* ... and the mirrored ray */
    float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX];   /* what they send on when nothing stands in the way */
    uint32_t odd[BATCH_MAX];     /* 1: that is not known yet */
    uint32_t faces[BATCH_MAX], gives[BATCH_MAX];   /* 1: the light is before it; and it sends anything on */
} sight;

static inline void see(sight *s, const geometry *g, uint32_t i, pov_vec3 direction)
{
    s->cosine[i] = pov_dot(lanes_at(&g->to.normal, i), direction);
    s->gloss[i] = pov_dot(lanes_at(&g->mirrored, i), direction);
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

static inline int look_all(sight *restrict s, const geometry *restrict g, const light *restrict l, uint32_t n, bool low)
{
    const pov_vec3 at = l->position, at_lo = l->position_lo;
    int64_t plain = -1, steep = -1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 direction;

        s->way.x[i] = towards(at.x, at_lo.x, g->to.point.x[i], g->to.point_lo.x[i], low);
        s->way.y[i] = towards(at.y, at_lo.y, g->to.point.y[i], g->to.point_lo.y[i], low);
        s->way.z[i] = towards(at.z, at_lo.z, g->to.point.z[i], g->to.point_lo.z[i], low);
        plain &= geometry_unit(s->way.x[i], s->way.y[i], s->way.z[i], &direction);
        see(s, g, i, direction);
        steep &= fabs(s->cosine[i]) > WORLD_AWAY ? -1 : 0;
    }
    return (plain ? 0 : ODD_WAY) | (steep ? 0 : GRAZING);
}

SIMD_CLONES static int look_plain(sight *restrict s, const geometry *restrict g, const light *restrict l, uint32_t n)
{
    return look_all(s, g, l, n, false);
}

SIMD_CLONES static int look_low(sight *restrict s, const geometry *restrict g, const light *restrict l, uint32_t n)
{
    return look_all(s, g, l, n, true);
}

/* True: there may be a cosine too small for world_leave(). */
static bool look_at_light(sight *s, const geometry *g, const light *l, uint32_t n)
{
    const pov_vec3 lo = l->position_lo;
    const bool low = lo.x != 0.0 || lo.y != 0.0 || lo.z != 0.0;
    const int found = low ? look_low(s, g, l, n) : look_plain(s, g, l, n);

    if (found & ODD_WAY)
        for (uint32_t i = 0; i < n; i++)
            see(s, g, i, pov_unit(lanes_at(&s->way, i)));
    return found != 0;
}

/* What white light becomes on its way to the ray's start, with a highlight. */
static colour answer(const model *m, const plan_look *look, double cosine, double gloss)
{
    const colour body = colour_scale(look->pigment, look->body * (float)cosine);
    const float strength = look->material->phong * pigment_power(gloss, look);

    return colour_add(body, colour_scale(pigment_highlight(m, look->material, cosine), strength));
}

static inline float lesser(float a, float b) { return a < b ? a : b; }

/* What of the light's colour all send on, to the bit as above where there is a highlight. One that is lost in the sum
 * is none: all components of that are then as large as PLAN_VISIBLE. It is not computed either, for floats below the
 * range of normal ones take a processor a hundred times as long. False: some are odd. */
SIMD_CLONES static bool answer_plain(sight *restrict s, const finishes *restrict f, colour of, uint32_t n)
{
    uint32_t odd = 0;

    for (uint32_t i = 0; i < n; i++) {
        const double cosine = s->cosine[i], gloss = s->gloss[i];
        const float part = f->body[i] * (float)cosine;
        const float red = f->red[i] * part, green = f->green[i] * part, blue = f->blue[i] * part;
        const float least = lesser(fabsf(red), lesser(fabsf(green), fabsf(blue)));
        const bool shines = (cosine > 0.0) & (gloss > 0.0) & !((gloss <= f->dull[i]) & (least >= PLAN_VISIBLE));
        const double product = pigment_product(shines ? gloss : 0.0, f->power[i]);
        const float lo = f->phong[i] * pigment_lo(product), hi = f->phong[i] * pigment_hi(product);
        const float strength = shines ? lo : 0.0f;

        s->odd[i] = shines & !(lo == hi);
        odd |= s->odd[i];
        s->red[i] = of.r * (red + strength);
        s->green[i] = of.g * (green + strength);
        s->blue[i] = of.b * (blue + strength);
        s->faces[i] = cosine > 0.0;
        s->gives[i] = (cosine > 0.0) & !colour_is_black(colour_of(s->red[i], s->green[i], s->blue[i]));
    }
    return !odd;
}

static void answer_all(const pov_tracer *t, sight *s, colour of, uint32_t n)
{
    const light_rays *l = &t->light_rays;

    if (answer_plain(s, &l->finishes, of, n))
        return;
    for (uint32_t k = 0; k < l->lit_count; k++) {
        const uint32_t i = l->lit[k];
        colour c;

        if (!s->odd[i])
            continue;
        c = colour_mul(of, answer(t->model, t->surfaces[i].look, s->cosine[i], s->gloss[i]));
        s->red[i] = c.r;
        s->green[i] = c.g;
        s->blue[i] = c.b;
        s->gives[i] = s->faces[i] & !colour_is_black(c);
    }
}

static inline colour given_at(const sight *s, uint32_t i) { return colour_of(s->red[i], s->green[i], s->blue[i]); }

/* The rays from lit surfaces that the light is before and that send anything on. Nothing is decided by branches, which
 * nobody could guess. Returns how many the light is before. */
static uint32_t aim(light_rays *l, const sight *s)
{
    pov_ray *const room = l->room;
    const size_t lit_count = l->lit_count;
    uint32_t facing = 0;
    size_t count = 0;

    for (size_t k = 0; k < lit_count; k++) {
        const size_t i = l->lit[k];

        room[i].dir = lanes_at(&s->way, (uint32_t)i);
        l->rays[count] = &room[i];
        l->of[count] = (uint8_t)i;
        facing += s->faces[i];
        count += s->gives[i];
    }
    l->count = (uint32_t)count;
    return facing;
}

static bool any_on_spot(const pov_tracer *t, const light_rays *l)
{
    for (uint32_t i = 0; i < l->count; i++)
        if (t->surfaces[l->of[i]].spot)
            return true;
    return false;
}

/* Rays from surfaces that lie on others go alone. */
static uint64_t light_each(pov_tracer *t, const light_rays *l, colour *through)
{
    uint64_t lit = 0;

    for (uint32_t i = 0; i < l->count; i++) {
        const uint32_t at = t->surfaces[l->of[i]].spot;
        const bool is_lit = at ? world_light_path_from(t->world, t->walker, &t->spots.items[at - 1], l->rays[i], 1.0,
                                                       &through[i])
                               : world_light_path(t->world, t->walker, l->rays[i], 1.0, &through[i]);
        lit |= (uint64_t)is_lit << i;
    }
    return lit;
}

/* Of the rays to a light those that get there. */
static uint64_t send(pov_tracer *t, colour *through)
{
    const light_rays *l = &t->light_rays;

    t->counts.shadow += l->count;
    if (t->spots.count > 0 && any_on_spot(t, l))
        return light_each(t, l, through);
    return world_light_path_many(t->world, t->walker, l->rays, l->count, 1.0, through);
}

static inline void add_light(surface *s, colour given) { s->lit = colour_add(s->lit, given); }

static void light_up(pov_tracer *t, const sight *s)
{
    const light_rays *l = &t->light_rays;
    colour through[BATCH_MAX];

    if (!t->plan->shadows)
        for (uint32_t i = 0; i < l->count; i++)
            add_light(&t->surfaces[l->of[i]], given_at(s, l->of[i]));
    else
        for (uint64_t lit = send(t, through); lit; lit &= lit - 1) {
            const uint32_t i = first_of64(lit);

            add_light(&t->surfaces[l->of[i]], colour_mul(given_at(s, l->of[i]), through[i]));
        }
}

/* What rays from the lit surfaces leave, at these cosines. NULL: at none so small that it matters. */
static void name_left(pov_tracer *t, const double *cosines)
{
    light_rays *l = &t->light_rays;

    for (uint32_t k = 0; k < l->lit_count; k++) {
        const uint32_t i = l->lit[k];

        world_leave(&l->room[i], t->surfaces[i].at, cosines ? cosines[i] : 1.0);
    }
}

/* What one light gives the lit surfaces. */
static void shine(pov_tracer *t, const light *l, uint32_t n)
{
    light_rays *rays = &t->light_rays;
    uint32_t facing;
    sight s;
    const bool grazing = look_at_light(&s, &t->geometry, l, lanes_whole(n));

    if (grazing)
        name_left(t, s.cosine);
    answer_all(t, &s, l->color, lanes_whole(n));
    facing = aim(rays, &s);
    t->counts.shadow_behind += rays->lit_count - facing;
    t->counts.shadow_idle += facing - rays->count;
    if (rays->count > 0)
        light_up(t, &s);
    if (grazing)
        name_left(t, NULL);
    t->failed = t->failed || walker_failed(t->walker);
}

static inline void finish(finishes *f, uint32_t i, const plan_look *look)
{
    f->red[i] = look->pigment.r;
    f->green[i] = look->pigment.g;
    f->blue[i] = look->pigment.b;
    f->body[i] = look->body;
    f->phong[i] = look->phong;
    f->dull[i] = look->dull;
    f->power[i] = look->power;
}

/* The surfaces that lights change; rays from them start all alike, to whatever light. */
static void begin(pov_tracer *t, uint32_t n)
{
    light_rays *l = &t->light_rays;
    uint32_t count = 0;

    l->room = t->mirrored->room;
    for (uint32_t i = 0; i < n; i++) {
        const surface *s = &t->surfaces[i];
        pov_ray *ray = &l->room[i];

        if (!s->look->lit)
            continue;
        l->lit[count++] = (uint8_t)i;
        finish(&l->finishes, i, s->look);
        ray->org = s->at->point;
        ray->org_lo = s->at->point_lo;
        world_leave(ray, s->at, 1.0);
    }
    l->lit_count = count;
}

void light_gather(pov_tracer *t, uint32_t n)
{
    const uint32_t *lit = &t->light_rays.lit_count;

    begin(t, n);
    for (size_t k = 0; *lit > 0 && k < t->model->lights.count && !t->failed && !tracer_gives_up(t, *lit); k++)
        shine(t, &t->model->lights.items[k], n);
}
