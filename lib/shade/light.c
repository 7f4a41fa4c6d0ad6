#include "shade/light.h"

#include "base/simd.h"
#include "shade/geometry.h"
#include "shade/pigment.h"
#include "world/bits.h"

#include <povtrace/exact.h>

/* How surfaces see one light, by lane. */
typedef struct sight {
    vec_lanes way;               /* from the surface to the light */
    double cosine[BATCH_MAX];    /* between it and the normal */
    double gloss[BATCH_MAX];     /* ... and the mirrored ray */
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

/* What white light becomes on its way to the ray's start. Highlights that are lost in the sum are not computed: all its
 * components are then as large as PLAN_VISIBLE, because the smallest is. */
static inline colour answer(const model *m, const plan_look *look, double cosine, double gloss)
{
    const float part = look->body * (float)cosine;
    const colour sum = colour_scale(look->pigment, part);
    float strength;

    if (!(gloss > look->gloss_least) || (gloss <= look->dull && fabsf(look->pigment_least * part) >= PLAN_VISIBLE))
        return sum;
    strength = look->material->phong * pigment_power(gloss, look);
    return colour_add(sum, colour_scale(pigment_highlight(m, look->material, cosine), strength));
}

/* What a light gives where nothing can stand in the way. */
static inline void add_light(surface *s, colour given) { s->lit = colour_add(s->lit, given); }

/* Note the ray from a surface to the light: the n-th. */
static inline void ask(light_rays *l, uint32_t n, uint32_t lane, pov_vec3 way, colour given)
{
    pov_ray *ray = &l->room[lane];

    ray->dir = way;
    l->rays[n] = ray;
    l->given[n] = given;
    l->of[n] = (uint8_t)lane;
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

static void send(pov_tracer *t)
{
    const light_rays *l = &t->light_rays;
    colour through[BATCH_MAX];
    uint64_t lit;

    t->counts.shadow += l->count;
    lit = t->spots.count > 0 && any_on_spot(t, l)
              ? light_each(t, l, through)
              : world_light_path_many(t->world, t->walker, l->rays, l->count, 1.0, through);
    for (; lit; lit &= lit - 1) {
        const uint32_t i = first_of64(lit);

        add_light(&t->surfaces[l->of[i]], colour_mul(l->given[i], through[i]));
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

/* The rays of the lit surfaces to one light, but for those that it cannot change anything about. */
static void shine(pov_tracer *t, const light *l, uint32_t n)
{
    light_rays *rays = &t->light_rays;
    const uint32_t lit_count = rays->lit_count;
    const bool shadows = t->plan->shadows;
    uint32_t behind = 0, idle = 0, asked = 0;
    sight s;
    const bool grazing = look_at_light(&s, &t->geometry, l, lanes_whole(n));

    if (grazing)
        name_left(t, s.cosine);
    for (uint32_t k = 0; k < lit_count; k++) {
        const uint32_t i = rays->lit[k];
        colour given;

        if (!(s.cosine[i] > 0.0)) {
            behind++;
            continue;
        }
        given = colour_mul(l->color, answer(t->model, t->surfaces[i].look, s.cosine[i], s.gloss[i]));
        if (!(given.r > 0.0f) && colour_is_black(given))
            idle++;
        else if (shadows)
            ask(rays, asked++, i, lanes_at(&s.way, i), given);
        else
            add_light(&t->surfaces[i], given);
    }
    t->counts.shadow_behind += behind;
    t->counts.shadow_idle += idle;
    rays->count = asked;
    if (asked > 0)
        send(t);
    if (grazing)
        name_left(t, NULL);
    t->failed = t->failed || walker_failed(t->walker);
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
