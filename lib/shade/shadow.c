#include "shade/shadow.h"

#include "base/lane_mask.h"
#include "base/simd.h"
#include "base/vec3.h"
#include "shade/haze.h"

/* Rays from coincident surfaces are traced one by one. Bits by ray: `which` are those, and of them the result those that are lit. */
static uint64_t trace_coincident(const lighting *l, segment_end end, uint64_t *which, colour *through)
{
    const shade_context *c = l->context;
    uint64_t lit = 0;

    *which = 0;
    for (uint32_t i = 0; c->coincident_sets.count > 0 && i < l->count; i++) {
        const surface *s = &l->on->at[l->of[i]];

        if (!s->coincident)
            continue;
        *which |= (uint64_t)1 << i;
        if (transmittance_from(c, &c->coincident_sets.items[s->coincident - 1], l->rays[i], s->from, segment_end_of(end, i), &through[i]))
            lit |= (uint64_t)1 << i;
    }
    return lit;
}

/* Some of the rays, as bits: those from several surfaces at one hit are traced once. */
static uint64_t trace_hits(const lighting *l, segment_end end, uint64_t which, colour *through)
{
    const pov_ray *rays[BATCH_MAX];
    const path *from[BATCH_MAX];
    light_origin ends[BATCH_MAX];
    colour some[BATCH_MAX];
    uint8_t of[BATCH_MAX];
    const hit *last = NULL;
    uint32_t n = 0;
    uint64_t found, lit = 0;

    for (uint64_t rest = which; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const surface *s = &l->on->at[l->of[i]];

        if (s->at != last || !vec3_is_same(l->rays[i]->dir, rays[n - 1]->dir)) {
            from[n] = s->from;
            if (end.at && end.by_ray)
                ends[n] = end.at[i];
            rays[n++] = l->rays[i];
            last = s->at;
        }
        of[i] = (uint8_t)(n - 1);
    }
    l->context->counts.shadow -= lane_mask_count(which) - n;
    end.at = end.at && end.by_ray ? ends : end.at;
    found = transmittance_find(l->context, rays, from, n, end, some);
    for (; which; which &= which - 1) {
        const uint32_t i = first_of64(which);

        through[i] = some[of[i]];
        lit |= (found >> of[i] & 1) << i;
    }
    return lit;
}

/* The rays that are not occluded. */
static uint64_t trace(const lighting *l, segment_end end, colour *through)
{
    shade_context *c = l->context;
    const path *from[BATCH_MAX];
    uint64_t each, lit = trace_coincident(l, end, &each, through);

    c->counts.shadow += l->count;
    if (each || l->on->shared)
        return lit | trace_hits(l, end, lane_mask_all(l->count) & ~each, through);
    if (!c->scene->plan->located)
        return transmittance_find(c, l->rays, NULL, l->count, end, through);
    for (uint32_t i = 0; i < l->count; i++)
        from[i] = l->on->at[l->of[i]].from;
    return transmittance_find(c, l->rays, from, l->count, end, through);
}

/* ---- by lane ---- */

/* Do rays to one point tell what is left of the light? */
static bool is_plain(const lighting *l, const scene_light *from)
{
    return !from->grid && from->light->through_count == 0 && !(from->light->flags & LIGHT_ATTENUATED) && l->context->coincident_sets.count == 0;
}

bool shadow_is_white(const lighting *l, const scene_light *from)
{
    return is_plain(l, from) && !l->context->scene->plan->coloured_shadows;
}

bool shadow_is_by_lane(const lighting *l, const scene_light *from) { return !l->apart && !l->on->shared && is_plain(l, from); }

/* Which side of their surfaces directions go to: to that of the normal, the other, or neither, as in world_origin_aim(). */
enum { SIDE_NEITHER, SIDE_UP, SIDE_DOWN };

/* As world_origin_reflect() names them, and ray_soa_excluded(). */
static void name_lanes(lighting *l)
{
    for (uint32_t i = 0; !l->named && i < l->on->count; i++) {
        const hit *h = l->on->at[i].at;
        const uint32_t away = h->outside ? 1u << SIDE_UP : 1u << SIDE_DOWN;

        l->origin[i] = h->object;
        l->away[i] = h->crossing.mark.flags & POV_MARK_OUTWARD ? ~0u : away;
        l->excluded[i] = l->away[i] >> SIDE_UP & 1 ? h->object : POV_NO_OWNER;
        l->closed[i] = h->crossing.mark.flags & POV_MARK_CLOSED;
    }
    l->named = true;
}

/* The same by their sides. */
SIMD_CLONES static void exclude_by_side(const uint32_t *restrict origin, const uint32_t *restrict away, const int64_t *restrict side, uint32_t n,
                                        uint32_t *restrict out)
{
    for (uint32_t i = 0; i < n; i++)
        out[i] = away[i] >> (uint32_t)side[i] & 1 ? origin[i] : POV_NO_OWNER;
}

/* Does a ray from one of n lanes go into a closed solid? */
SIMD_CLONES static bool any_enters(const uint32_t *restrict closed, const uint32_t *restrict excluded, uint32_t n)
{
    uint32_t any = 0;

    for (uint32_t i = 0; i < n; i++)
        any |= excluded[i] == POV_NO_OWNER ? closed[i] : 0;
    return any != 0;
}

static const pov_ray *const *make_rays(void *user)
{
    lighting *l = user;

    lighting_put_rays(l);
    return l->rays;
}

uint64_t shadow_trace_lanes(lighting *l, segment_end end, colour *through, bool *filtered)
{
    const path *from[BATCH_MAX];
    const incidence *at = &l->on->geometry.to;
    const uint8_t *of = l->count < l->on->count ? l->of : NULL;
    lane_rays rays = { { &at->point, &at->point_lo, l->dir, l->excluded, l->which, of }, l->origin, make_rays, l, false };

    name_lanes(l);
    if (l->sided)
        exclude_by_side(l->origin, l->away, l->side, lanes_whole(l->on->count), l->excluded);
    rays.enters = l->context->scene->plan->coloured_shadows && any_enters(l->closed, l->excluded, l->on->count);
    l->context->counts.shadow += l->count;
    for (uint32_t i = 0; l->context->scene->plan->located && i < l->count; i++)
        from[i] = l->on->at[l->of[i]].from;
    return transmittance_find_lanes(l->context, &rays, from, l->count, end, through, filtered);
}

/* ---- through other objects, and in the air ---- */

/* Shorten rays to where they first cross what a light is projected through. Returns those that do. */
static uint64_t shorten(lighting *l, const light *from, double tmax)
{
    const shade_context *c = l->context;
    uint64_t through = 0;

    for (uint32_t i = 0; i < l->count; i++)
        through |= (uint64_t)transmittance_shorten(c, from, tmax, &l->own[l->rays[i] - l->own]) << i;
    return through;
}

void shadow_keep_crossing(lighting *l, const light *from, double tmax)
{
    uint64_t through;

    lighting_put_rays(l);
    through = shorten(l, from, tmax);
    for (l->count = 0; through; through &= through - 1)
        l->of[l->count++] = l->of[first_of64(through)];
}

/* Light that the atmosphere and fog dim. */
static void attenuate(const lighting *l, const light *from, double tmax, uint64_t lit, colour *through)
{
    const path *paths[BATCH_MAX];
    const light_segments on = { l->rays, paths, l->count, tmax };

    for (uint32_t i = 0; i < l->count; i++)
        paths[i] = l->on->at[l->of[i]].from;
    haze_attenuate(l->context, from, &on, lit, through);
}

/* The rays to one point of a light source that are not occluded. */
uint64_t shadow_trace(lighting *l, const light *from, segment_end end, colour *through)
{
    uint64_t lit;

    if (from->through_count == 0) {
        lit = trace(l, end, through);
    } else {
        lit = shorten(l, from, end.tmax);
        end.at = NULL;
        lit &= trace(l, end, through);
    }
    if (from->flags & LIGHT_ATTENUATED)
        attenuate(l, from, end.tmax, lit, through);
    return lit;
}

/* Set the origin surfaces of the rays, at these cosines. NULL: none is so small that it matters. */
void shadow_name_origins(lighting *l, const double *cosines)
{
    for (uint32_t k = 0; k < l->finishes.count; k++) {
        const uint32_t i = l->finishes.lit[k];

        world_origin_reflect(&l->own[i], l->on->at[i].at, cosines ? cosines[i] : 1.0);
    }
}

/* The sum of a direction's components' sizes is a bound of its length. */
SIMD_CLONES static void find_sides(const vec_lanes *restrict dir, const vec_lanes *restrict normal, uint32_t n,
                                   int64_t *restrict side)
{
    for (uint32_t i = 0; i < n; i++) {
        const double along = dir->x[i] * normal->x[i] + dir->y[i] * normal->y[i] + dir->z[i] * normal->z[i];
        const double least = WORLD_GRAZING * (fabs(dir->x[i]) + fabs(dir->y[i]) + fabs(dir->z[i]));
        const int64_t down = -along > least ? SIDE_DOWN : SIDE_NEITHER;

        side[i] = along > least ? SIDE_UP : down;
    }
}

void shadow_find_sides(lighting *l, const vec_lanes *dir)
{
    find_sides(dir, &l->on->geometry.to.normal, lanes_whole(l->on->count), l->side);
}

static uint32_t side_flags(const hit *h, int64_t side)
{
    static const uint32_t names[2][3] = { { 0, POV_MARK_INWARD, POV_MARK_OUTWARD }, { 0, POV_MARK_OUTWARD, POV_MARK_INWARD } };

    return h->crossing.mark.flags | names[h->outside][side];
}

static void put_sides(lighting *l, const uint8_t *lanes, uint32_t count)
{
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t i = lanes[k];

        l->own[i].origin_mark.flags = side_flags(l->on->at[i].at, l->side[i]);
    }
}

void shadow_put_sides(lighting *l) { put_sides(l, l->of, l->count); }

void shadow_name_sides(lighting *l, const uint8_t *lanes, uint32_t count, const vec_lanes *dir)
{
    shadow_find_sides(l, dir);
    put_sides(l, lanes, count);
}

void shadow_name_rays(lighting *l, const vec_lanes *dir)
{
    SIMD_ALIGNED int64_t side[LANES_MAX];
    uint32_t n = 0;
    vec_lanes normal;

    do
        lanes_put(&normal, n, lanes_at(&l->on->geometry.to.normal, l->of[n < l->count ? n : 0]));
    while (++n < lanes_whole(l->count));
    find_sides(dir, &normal, lanes_whole(l->count), side);
    for (uint32_t k = 0; k < l->count; k++)
        l->own[k].origin_mark.flags = side_flags(l->on->at[l->of[k]].at, side[k]);
}
