#include "shade/light.h"

#include "base/simd.h"
#include "shade/geometry.h"
#include "shade/pigment.h"
#include "world/bits.h"

#include <povtrace/exact.h>

/* How surfaces see one light, by lane. */
typedef struct sight {
    lanes way;                   /* from the surface to the light */
    double cosine[BATCH_MAX];    /* between it and the normal */
    double gloss[BATCH_MAX];     /* ... and the mirrored ray */
} sight;

static inline void see(sight *s, const geometry *g, uint32_t i, pov_vec3 direction)
{
    s->cosine[i] = pov_dot(lanes_at(&g->normal, i), direction);
    s->gloss[i] = pov_dot(lanes_at(&g->mirrored, i), direction);
}

/* From a point to the light along one axis, rounded once: both ends have two parts, so that a light may be near or far. */
static inline double towards(double l, double l_lo, double p, double p_lo)
{
    return pov_two_sub(pov_two_of(l, l_lo), pov_two_of(p, p_lo)).hi;
}

/* False: some way is so short or long that its square is none. */
SIMD_CLONES static bool look_plain(sight *restrict s, const geometry *restrict g, const light *restrict l, uint32_t n)
{
    const pov_vec3 at = l->position, at_lo = l->position_lo;
    int plain = 1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 direction;

        s->way.x[i] = towards(at.x, at_lo.x, g->point.x[i], g->point_lo.x[i]);
        s->way.y[i] = towards(at.y, at_lo.y, g->point.y[i], g->point_lo.y[i]);
        s->way.z[i] = towards(at.z, at_lo.z, g->point.z[i], g->point_lo.z[i]);
        plain &= geometry_unit(s->way.x[i], s->way.y[i], s->way.z[i], &direction);
        see(s, g, i, direction);
    }
    return plain;
}

static void look_at_light(sight *s, const geometry *g, const light *l, uint32_t n)
{
    if (!look_plain(s, g, l, n))
        for (uint32_t i = 0; i < n; i++)
            see(s, g, i, pov_unit(lanes_at(&s->way, i)));
}

static inline bool is_visible(colour c)
{
    return fabsf(c.r) >= PLAN_VISIBLE && fabsf(c.g) >= PLAN_VISIBLE && fabsf(c.b) >= PLAN_VISIBLE;
}

/* What white light becomes on its way to the ray's start. Highlights that are lost in the sum are not computed. */
static inline colour answer(const model *m, const surface *s, double cosine, double gloss)
{
    const material *of = s->look->material;
    const plan_look *look = s->look;
    const colour sum = colour_scale(of->pigment, look->body * (float)cosine);
    float strength;

    if (!look->glossy || !(gloss > 0.0) || (gloss <= look->dull && is_visible(sum)))
        return sum;
    strength = of->phong * pigment_power(gloss, of, look);
    return colour_add(sum, colour_scale(pigment_highlight(m, of, cosine), strength));
}

/* Note the ray from a surface to the light, or add what it gives where nothing can stand in the way. */
static inline void ask(pov_tracer *t, uint32_t lane, pov_vec3 way, double cosine, colour given)
{
    light_rays *l = &t->light_rays;
    surface *s = &t->surfaces[lane];

    if (!t->plan->shadows) {
        s->lit = colour_add(s->lit, given);
        return;
    }
    l->room[lane].dir = way;
    world_leave(&l->room[lane], s->at, cosine);
    l->rays[l->count] = &l->room[lane];
    l->of[l->count] = s;
    l->given[l->count++] = given;
}

static bool any_on_spot(const light_rays *l)
{
    for (uint32_t i = 0; i < l->count; i++)
        if (l->of[i]->spot)
            return true;
    return false;
}

/* Rays from surfaces that lie on others go alone. */
static uint64_t light_each(pov_tracer *t, const light_rays *l, colour *through)
{
    uint64_t lit = 0;

    for (uint32_t i = 0; i < l->count; i++) {
        const uint32_t at = l->of[i]->spot;
        const bool is_lit = at ? world_light_path_from(t->world, t->walker, &t->spots.items[at - 1], l->rays[i], 1.0,
                                                       &through[i])
                               : world_light_path(t->world, t->walker, l->rays[i], 1.0, &through[i]);
        lit |= (uint64_t)is_lit << i;
    }
    return lit;
}

static void send(pov_tracer *t)
{
    light_rays *l = &t->light_rays;
    colour through[BATCH_MAX];
    uint64_t lit;

    t->counts.shadow += l->count;
    lit = t->spots.count > 0 && any_on_spot(l)
              ? light_each(t, l, through)
              : world_light_path_many(t->world, t->walker, l->rays, l->count, 1.0, through);
    for (; lit; lit &= lit - 1) {
        const uint32_t i = first_of64(lit);

        l->of[i]->lit = colour_add(l->of[i]->lit, colour_mul(l->given[i], through[i]));
    }
}

/* The rays of the lit surfaces to one light, but for those that it cannot change anything about. */
static void shine(pov_tracer *t, const light *l, uint32_t n)
{
    const light_rays *rays = &t->light_rays;
    uint32_t behind = 0, idle = 0;
    sight s;

    look_at_light(&s, &t->geometry, l, n);
    t->light_rays.count = 0;
    for (uint32_t k = 0; k < rays->lit_count; k++) {
        const uint32_t i = rays->lit[k];
        colour given;

        if (!(s.cosine[i] > 0.0)) {
            behind++;
            continue;
        }
        given = colour_mul(l->color, answer(t->model, &t->surfaces[i], s.cosine[i], s.gloss[i]));
        if (colour_is_black(given))
            idle++;
        else
            ask(t, i, lanes_at(&s.way, i), s.cosine[i], given);
    }
    t->counts.shadow_behind += behind;
    t->counts.shadow_idle += idle;
    if (rays->count > 0)
        send(t);
    t->failed = t->failed || walker_failed(t->walker);
}

/* The surfaces that lights change; rays from them start all alike, to whatever light. */
static void begin(pov_tracer *t, uint32_t n)
{
    light_rays *l = &t->light_rays;

    l->lit_count = 0;
    for (uint32_t i = 0; i < n; i++) {
        const surface *s = &t->surfaces[i];
        pov_ray *ray = &l->room[i];

        if (!s->look->lit)
            continue;
        l->lit[l->lit_count++] = i;
        ray->org = s->at->point;
        ray->org_lo = s->at->point_lo;
    }
}

void light_gather(pov_tracer *t, uint32_t n)
{
    const uint32_t *lit = &t->light_rays.lit_count;

    begin(t, n);
    for (size_t k = 0; *lit > 0 && k < t->model->lights.count && !t->failed && !tracer_gives_up(t, *lit); k++)
        shine(t, &t->model->lights.items[k], n);
}
