#include "shade/lighting.h"

#include "base/simd.h"
#include "light/aim.h"
#include "shade/area_view.h"
#include "shade/haze.h"
#include "shade/photon_light.h"
#include "shade/photons.h"
#include "shade/subsurface.h"
#include "shade/transmittance.h"

#include <string.h>

/* Collect rays from lit surfaces that face the light and reflect any of it, without unpredictable branches. Returns the
 * number of surfaces that face the light. */
static uint32_t aim(lighting *l, const light_sample *s, const vec_lanes *dir)
{
    pov_ray *const own = l->own;
    const size_t lit_count = l->finishes.count;
    uint32_t front = 0;
    size_t count = 0;

    for (size_t k = 0; k < lit_count; k++) {
        const size_t i = l->finishes.lit[k];

        own[i].dir = lanes_at(dir, (uint32_t)i);
        l->rays[count] = &own[i];
        l->of[count] = (uint8_t)i;
        front += s->front[i];
        count += s->contributes[i];
    }
    l->count = (uint32_t)count;
    return front;
}

static bool any_coincident(const lighting *l)
{
    for (uint32_t i = 0; i < l->count; i++)
        if (l->on->at[l->of[i]].coincident)
            return true;
    return false;
}

/* Rays from coincident surfaces are traced one by one. */
static uint64_t trace_each(const lighting *l, segment_end end, colour *through)
{
    const shade_context *c = l->context;
    uint64_t lit = 0;

    for (uint32_t i = 0; i < l->count; i++) {
        const uint32_t at = l->on->at[l->of[i]].coincident;
        const path *from = l->on->at[l->of[i]].from;
        const bool is_lit = at ? transmittance_from(c, &c->coincident_sets.items[at - 1], l->rays[i], from, end, &through[i])
                               : transmittance_find(c, &l->rays[i], &from, 1, end, &through[i]) != 0;

        lit |= (uint64_t)is_lit << i;
    }
    return lit;
}

/* Rays from several surfaces at one hit are traced once. */
static uint64_t trace_hits(const lighting *l, segment_end end, colour *through)
{
    const pov_ray *rays[BATCH_MAX];
    const path *from[BATCH_MAX];
    colour some[BATCH_MAX];
    uint8_t which[BATCH_MAX];
    uint32_t n = 0;
    uint64_t found, lit = 0;

    for (uint32_t i = 0; i < l->count; i++) {
        if (i == 0 || l->on->at[l->of[i]].at != l->on->at[l->of[i - 1]].at) {
            from[n] = l->on->at[l->of[i]].from;
            rays[n++] = l->rays[i];
        }
        which[i] = (uint8_t)(n - 1);
    }
    l->context->counts.shadow -= l->count - n;
    found = transmittance_find(l->context, rays, from, n, end, some);
    for (uint32_t i = 0; i < l->count; i++) {
        through[i] = some[which[i]];
        lit |= (found >> which[i] & 1) << i;
    }
    return lit;
}

/* The rays that are not occluded. */
static uint64_t trace(const lighting *l, segment_end end, colour *through)
{
    shade_context *c = l->context;
    const path *from[BATCH_MAX];

    c->counts.shadow += l->count;
    if (c->coincident_sets.count > 0 && any_coincident(l))
        return trace_each(l, end, through);
    if (l->on->shared)
        return trace_hits(l, end, through);
    if (!c->scene->plan->media)
        return transmittance_find(c, l->rays, NULL, l->count, end, through);
    for (uint32_t i = 0; i < l->count; i++)
        from[i] = l->on->at[l->of[i]].from;
    return transmittance_find(c, l->rays, from, l->count, end, through);
}

/* Shorten rays to where they first cross what a light is projected through. Returns those that do. */
static uint64_t shorten(lighting *l, const light *from, double tmax)
{
    const shade_context *c = l->context;
    uint64_t through = 0;

    for (uint32_t i = 0; i < l->count; i++)
        through |= (uint64_t)transmittance_shorten(c, from, tmax, &l->own[l->of[i]]) << i;
    return through;
}

/* Light that the atmosphere dims on its whole way. */
static void attenuate(const lighting *l, const light *from, double tmax, uint64_t lit, colour *through)
{
    for (; lit; lit &= lit - 1) {
        const uint32_t i = first_of64(lit);

        haze_attenuate(l->context, from, l->rays[i], tmax, &through[i]);
    }
}

/* The rays to one point of a light source that are not occluded. */
static uint64_t trace_to(lighting *l, const light *from, segment_end end, colour *through)
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
static void name_origins(lighting *l, const double *cosines)
{
    for (uint32_t k = 0; k < l->finishes.count; k++) {
        const uint32_t i = l->finishes.lit[k];

        world_origin_reflect(&l->own[i], l->on->at[i].at, cosines ? cosines[i] : 1.0);
    }
}

/* Components of directions along the normals, and bounds of their lengths: the sums of their components' sizes. */
SIMD_CLONES static void project(const vec_lanes *restrict dir, const vec_lanes *restrict normal, uint32_t n,
                                double *restrict along, double *restrict length)
{
    for (uint32_t i = 0; i < n; i++) {
        along[i] = dir->x[i] * normal->x[i] + dir->y[i] * normal->y[i] + dir->z[i] * normal->z[i];
        length[i] = fabs(dir->x[i]) + fabs(dir->y[i]) + fabs(dir->z[i]);
    }
}

/* The same where the shading normal does not tell the side of a ray: the geometric one does. */
static void name_sides(lighting *l, const uint8_t *lanes, uint32_t count, const vec_lanes *dir)
{
    SIMD_ALIGNED double along[LANES_MAX], length[LANES_MAX];

    project(dir, &l->on->geometry.to.normal, lanes_whole(l->on->count), along, length);
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t i = lanes[k];

        world_origin_aim(&l->own[i], l->on->at[i].at, along[i], length[i]);
    }
}

/* Which draw of points that move: those for shadows, or those whose light is reflected. */
enum { DRAW_SHADOWS, DRAW_REFLECTED };

/* Directions to the k-th point of an area light. False: by lane these are different points. */
static bool aim_at_point(const scene_light *from, uint32_t k, const light_points *at, const vec_lanes *to, light_lanes *in,
                         light_origin *origin)
{
    in->tmax = 1.0;
    if (from->grid->moves) {
        grid_aim(from->light, from->grid, k, DRAW_SHADOWS, at, to, &in->dir);
        return false;
    }
    *origin = grid_origin(from->light, from->grid, k);
    light_aim(origin, at, &in->dir);
    return true;
}

/* Where rays to a light end that comes from this point. */
static segment_end end_of(const scene_light *from, const light_lanes *in, const light_origin *origin)
{
    const segment_end end = { in->tmax, from->class->parallel ? NULL : origin };

    return end;
}

static light_points points_of(const lighting *l)
{
    const geometry *g = &l->on->geometry;
    const light_points at = { &g->to.point, &g->to.point_lo, l->on->count };

    return at;
}

/* Light that something dims on its way, hidden or not, needs its rays. */
static bool needs_rays(const light *l) { return l->through_count > 0 || (l->flags & LIGHT_ATTENUATED); }

/* Views by ray; `open`: rays from which something may hide a part of the light. The others get all of it or nothing; *lit:
 * those that do. */
static uint32_t find_views(const lighting *l, const scene_light *from, const vec_lanes *to, area_view *views, uint8_t *open,
                           uint64_t *lit, colour *through)
{
    const float sum = from->grid->sum;
    const geometry *g = &l->on->geometry;
    uint32_t n = 0;

    for (uint32_t i = 0; i < l->count; i++) {
        const uint32_t lane = l->of[i];
        bool is_clear;

        if (needs_rays(from->light))
            area_view_hide(&views[i]);
        else
            area_view_find(l->context->scene, from, l->on->at[lane].at, lanes_at(&g->to.normal, lane), lanes_at(to, lane),
                           &views[i]);
        is_clear = !views[i].dark && views[i].count == 0;
        through[i] = is_clear ? colour_of(sum, sum, sum) : colour_of(0.0f, 0.0f, 0.0f);
        *lit |= (uint64_t)is_clear << i;
        if (!views[i].dark && views[i].count > 0)
            open[n++] = (uint8_t)i;
    }
    return n;
}

/* Of the open rays those that something may hide the k-th point from. The others get its light. */
static uint64_t choose_hidden(lighting *l, const light_grid *g, uint32_t k, const area_view *views, const uint8_t *open,
                              uint32_t count, uint8_t *which, colour *through)
{
    const grid_part place = grid_place(g, k);
    const float weight = g->points[k].weight;
    uint64_t lit = 0;

    l->count = 0;
    for (uint32_t n = 0; n < count; n++) {
        const uint8_t i = open[n];

        if (area_view_has(&views[i], &place)) {
            through[i] = colour_add(through[i], colour_of(weight, weight, weight));
            lit |= (uint64_t)1 << i;
        } else {
            which[l->count] = i;
            l->of[l->count] = l->seen[i];
            l->rays[l->count] = &l->own[l->seen[i]];
            l->count++;
        }
    }
    return lit;
}

/* Add the light of the k-th point to the rays at `which`. Returns those that get any. */
static uint64_t trace_point(lighting *l, const scene_light *from, uint32_t k, const vec_lanes *to, const uint8_t *which,
                            colour *through)
{
    const light_points at = points_of(l);
    colour some[BATCH_MAX];
    light_origin origin;
    light_lanes in;
    const bool at_one = aim_at_point(from, k, &at, to, &in, &origin);
    uint64_t lit = 0;

    name_sides(l, l->of, l->count, &in.dir);
    for (uint32_t i = 0; i < l->count; i++)
        l->own[l->of[i]].dir = lanes_at(&in.dir, l->of[i]);
    for (uint64_t rest = trace_to(l, from->light, end_of(from, &in, at_one ? &origin : NULL), some); rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);

        through[which[i]] = colour_add(through[which[i]], colour_scale(some[i], from->grid->points[k].weight));
        lit |= (uint64_t)1 << which[i];
    }
    return lit;
}

/* The mean transmittance to all points of an area light; `to` are the directions to its middle. */
static uint64_t trace_area(lighting *l, const scene_light *from, const vec_lanes *to, colour *through)
{
    const uint32_t count = l->count;
    area_view views[BATCH_MAX];
    uint8_t open[BATCH_MAX], which[BATCH_MAX];
    uint64_t lit = 0;
    const uint32_t open_count = find_views(l, from, to, views, open, &lit, through);

    memcpy(l->seen, l->of, count);
    for (uint32_t k = 0; open_count > 0 && k < from->grid->count; k++) {
        lit |= choose_hidden(l, from->grid, k, views, open, open_count, which, through);
        if (l->count > 0)
            lit |= trace_point(l, from, k, to, which, through);
    }
    memcpy(l->of, l->seen, count);
    l->count = count;
    name_origins(l, NULL);
    return lit;
}

/* The direction from a lane's surface to a point of the area that is drawn for its path. */
static pov_vec3 aim_at_some(const lighting *l, const scene_light *from, uint32_t lane, const vec_lanes *to)
{
    const path *p = l->on->at[lane].from;
    const shade_context *c = l->context;
    const uint32_t number = (uint32_t)(from - c->scene->lights), draws = c->scene->model->radiosity.draws;
    const sequence_point u = random_point(&c->samples[p->lane], p->draw, draws, p->branch * 0x85ebca6bu + number + 1);
    const uint32_t k = grid_draw(from->grid, u.x);
    const geometry *g = &l->on->geometry;
    vec_lanes point, low, middle;
    const light_points at = { &point, &low, 1 };
    light_origin origin;
    light_lanes in;

    for (uint32_t i = 0; i < lanes_whole(1); i++) {
        lanes_put(&point, i, lanes_at(&g->to.point, lane));
        lanes_put(&low, i, lanes_at(&g->to.point_lo, lane));
        lanes_put(&middle, i, lanes_at(to, lane));
    }
    aim_at_point(from, k, &at, &middle, &in, &origin);
    return lanes_at(&in.dir, 0);
}

/* The same for one point of the area each, drawn by the weights: where radiosity gathers light more would be lost time. */
static uint64_t trace_some(lighting *l, const scene_light *from, const light_lanes *in, colour *through)
{
    light_lanes to = *in;
    segment_end end = { 1.0, NULL };
    uint64_t lit;

    for (uint32_t i = 0; i < l->count; i++)
        lanes_put(&to.dir, l->of[i], aim_at_some(l, from, l->of[i], &in->dir));
    name_sides(l, l->of, l->count, &to.dir);
    for (uint32_t i = 0; i < l->count; i++)
        l->own[l->of[i]].dir = lanes_at(&to.dir, l->of[i]);
    lit = trace_to(l, from->light, end, through);
    name_origins(l, NULL);
    return lit;
}

/* Shadows of an area light. */
static uint64_t trace_soft(lighting *l, const scene_light *from, const light_lanes *in, colour *through)
{
    return l->on->at[0].from->gathers > 0 ? trace_some(l, from, in, through) : trace_area(l, from, &in->dir, through);
}

static inline void add_light(surface *s, colour given) { s->lit = colour_add(s->lit, given); }

static void add_visible(lighting *l, const scene_light *from, const light_sample *s, const light_lanes *in)
{
    const light_origin origin = light_own_origin(from->light);
    colour through[BATCH_MAX];

    if (!l->context->scene->plan->shadows || (from->light->flags & LIGHT_SHADOWLESS))
        for (uint32_t i = 0; i < l->count; i++)
            add_light(&l->on->at[l->of[i]], brdf_at(s, l->of[i]));
    else
        for (uint64_t lit = from->grid ? trace_soft(l, from, in, through)
                                       : trace_to(l, from->light, end_of(from, in, &origin), through);
             lit; lit &= lit - 1) {
            const uint32_t i = first_of64(lit);

            add_light(&l->on->at[l->of[i]], colour_mul(brdf_at(s, l->of[i]), through[i]));
        }
}

/* Incident light from the k-th point of an area light. Where points move, cone and fading are those of the middle. */
static void find_incident(const scene_light *from, uint32_t k, const light_points *at, const light_lanes *middle,
                          light_lanes *in)
{
    if (from->grid->moves) {
        grid_aim(from->light, from->grid, k, DRAW_REFLECTED, at, &middle->dir, &in->dir);
    } else {
        const light_origin origin = grid_origin(from->light, from->grid, k);

        from->class->incident(from->light, &origin, at, in);
    }
}

/* What an area light would give if it were not occluded: the mean over its points. */
static void reflect_area(lighting *l, const scene_light *from, light_sample *s, const light_lanes *middle, uint32_t n)
{
    const bool highlights = l->glossy && !(from->light->flags & LIGHT_SHADOWLESS);
    const light_points at = points_of(l);
    const float share = 1.0f / (float)from->grid->count;
    light_lanes in = *middle;
    light_sample one;

    for (uint32_t i = 0; i < n; i++)
        s->red[i] = s->green[i] = s->blue[i] = 0.0f;
    for (uint32_t k = 0; k < from->grid->count; k++) {
        find_incident(from, k, &at, middle, &in);
        brdf_cosines(&one, &l->on->geometry, &in.dir, n);
        brdf_reflect(&l->finishes, l->context->scene->model, &one, &in, highlights, n);
        for (uint32_t i = 0; i < n; i++) {
            s->red[i] += one.front[i] ? share * one.red[i] : 0.0f;
            s->green[i] += one.front[i] ? share * one.green[i] : 0.0f;
            s->blue[i] += one.front[i] ? share * one.blue[i] : 0.0f;
        }
    }
    for (uint32_t i = 0; i < n; i++)
        s->front[i] = s->contributes[i] = !colour_is_black(brdf_at(s, i));
}

/* Add the light of one source to the lit surfaces. */
static void add_light_source(lighting *l, const scene_light *from)
{
    shade_context *c = l->context;
    const geometry *g = &l->on->geometry;
    const light_origin origin = light_own_origin(from->light);
    const light_points at = points_of(l);
    const uint32_t n = lanes_whole(at.n);
    const bool sided = geometry_is_bent(g) || brdf_has_back(&l->finishes);
    uint32_t front;
    light_sample s;
    light_lanes in;
    bool named;

    if (l->photons)
        photons_aim(c, (size_t)(from - c->scene->lights));
    from->class->incident(from->light, &origin, &at, &in);
    named = brdf_cosines(&s, g, &in.dir, n) || sided;
    if (sided)
        name_sides(l, l->finishes.lit, l->finishes.count, &in.dir);
    else if (named)
        name_origins(l, s.cosine);
    brdf_reflect(&l->finishes, c->scene->model, &s, &in, l->glossy && !(from->light->flags & LIGHT_SHADOWLESS), n);
    if (from->grid && (from->light->flags & LIGHT_AREA_ILLUMINATION))
        reflect_area(l, from, &s, &in, n);
    front = aim(l, &s, &in.dir);
    c->counts.shadow_behind += l->finishes.count - front;
    c->counts.shadow_idle += front - l->count;
    if (l->count > 0)
        add_visible(l, from, &s, &in);
    if (named)
        name_origins(l, NULL);
    c->failed = c->failed || query_context_failed(c->context);
}

/* Collect the lit surfaces; rays from them start alike for all lights. */
static void begin(lighting *l, shade_context *c, surfaces *on)
{
    l->context = c;
    l->on = on;
    l->glossy = on->count == 0 || on->at[0].from->gathers == 0;   /* paths of a batch have the same history */
    brdf_begin(&l->finishes, c->scene->model, on);
    for (uint32_t k = 0; k < l->finishes.count; k++) {
        const uint32_t i = l->finishes.lit[k];
        const surface *s = &on->at[i];
        pov_ray *ray = &l->own[i];

        ray->org = s->at->point;
        ray->org_lo = s->at->point_lo;
        world_origin_reflect(ray, s->at, 1.0);
    }
}

/* Of the lit surfaces only those that this light shines on. */
static void choose_lit(lighting *l, const light *from, const uint8_t *all, uint32_t count)
{
    finishes *f = &l->finishes;

    f->count = 0;
    for (uint32_t k = 0; k < count; k++)
        if (model_is_lit_by(l->context->scene->model, l->on->at[all[k]].at->object, from))
            f->lit[f->count++] = all[k];
}

/* The lights of a scene with light groups. */
static void gather_by_group(lighting *l, const shading *scene)
{
    const uint32_t count = l->finishes.count;
    uint8_t all[BATCH_MAX];

    memcpy(all, l->finishes.lit, count);
    for (size_t k = 0; k < scene->light_count; k++) {
        if (l->context->failed || interrupt_is_due(&l->context->interrupt, count))
            return;
        choose_lit(l, scene->lights[k].light, all, count);
        if (l->finishes.count > 0)
            add_light_source(l, &scene->lights[k]);
    }
}

/* ---- one light of many ---- */

/* By lane: the light that was drawn among those before, by what they would give, the sum of that, and a random number. */
typedef struct lottery {
    uint32_t light[BATCH_MAX];
    double sum[BATCH_MAX], won[BATCH_MAX], number[BATCH_MAX];
} lottery;

static void begin_lottery(const lighting *l, const uint8_t *all, uint32_t count, lottery *out)
{
    const shade_context *c = l->context;

    for (uint32_t k = 0; k < count; k++) {
        const path *p = l->on->at[all[k]].from;

        out->sum[all[k]] = out->won[all[k]] = 0.0;
        out->light[all[k]] = UINT32_MAX;
        out->number[all[k]] = random_point(&c->samples[p->lane], p->draw, c->scene->model->radiosity.draws, p->branch * 0x85ebca6bu).x;
    }
}

/* What is left of the number after a choice is as random as it was before. */
static void offer(lottery *to, uint32_t lane, uint32_t number, double weight)
{
    double share;

    if (!(weight > 0.0))
        return;
    to->sum[lane] += weight;
    share = weight / to->sum[lane];
    if (to->number[lane] < share) {
        to->light[lane] = number;
        to->won[lane] = weight;
        to->number[lane] /= share;
    } else {
        to->number[lane] = (to->number[lane] - share) / (1.0 - share);
    }
}

/* What the light would give if nothing were in its way. */
static void offer_light(lighting *l, uint32_t number, lottery *to)
{
    const shading *scene = l->context->scene;
    const scene_light *from = &scene->lights[number];
    const light_origin origin = light_own_origin(from->light);
    const light_points at = points_of(l);
    const uint32_t n = lanes_whole(at.n);
    light_sample s;
    light_lanes in;

    from->class->incident(from->light, &origin, &at, &in);
    brdf_cosines(&s, &l->on->geometry, &in.dir, n);
    brdf_reflect(&l->finishes, scene->model, &s, &in, false, n);
    for (uint32_t k = 0; k < l->finishes.count; k++) {
        const uint32_t lane = l->finishes.lit[k];

        if (s.front[lane] && s.contributes[lane])
            offer(to, lane, number, (double)colour_weight(brdf_at(&s, lane)));
    }
}

/* Of the lit surfaces those that have drawn this light. */
static void choose_drawn(lighting *l, const lottery *from, uint32_t number, const uint8_t *all, uint32_t count)
{
    l->finishes.count = 0;
    for (uint32_t k = 0; k < count; k++)
        if (from->light[all[k]] == number)
            l->finishes.lit[l->finishes.count++] = all[k];
}

/* Each surface asks one light, and takes what that gives for all. */
static void gather_some(lighting *l, const shading *scene)
{
    const uint32_t count = l->finishes.count;
    colour before[BATCH_MAX];
    uint8_t all[BATCH_MAX];
    lottery drawn;

    memcpy(all, l->finishes.lit, count);
    begin_lottery(l, all, count, &drawn);
    for (uint32_t k = 0; k < scene->light_count; k++) {
        choose_lit(l, scene->lights[k].light, all, count);
        offer_light(l, k, &drawn);
    }
    for (uint32_t k = 0; k < count; k++) {
        before[k] = l->on->at[all[k]].lit;
        l->on->at[all[k]].lit = colour_of(0.0f, 0.0f, 0.0f);
    }
    for (uint32_t k = 0; k < scene->light_count; k++) {
        if (l->context->failed || interrupt_is_due(&l->context->interrupt, count))
            return;
        choose_drawn(l, &drawn, k, all, count);
        if (l->finishes.count > 0)
            add_light_source(l, &scene->lights[k]);
    }
    for (uint32_t k = 0; k < count; k++) {
        surface *s = &l->on->at[all[k]];
        const double by = drawn.won[all[k]] > 0.0 ? drawn.sum[all[k]] / drawn.won[all[k]] : 0.0;

        s->lit = colour_add(before[k], colour_scale(s->lit, (float)by));
    }
}

void light_gather(lighting *l, shade_context *c, surfaces *on)
{
    const shading *scene = c->scene;

    begin(l, c, on);
    if (l->photons)
        photon_light_add(l->photons, c, &l->finishes, on);
    if (scene->plan->subsurface)
        subsurface_add(c, &l->finishes, on);
    if (scene->light_count > 1 && l->finishes.count > 0 && on->at[0].from->gathers > 0) {
        gather_some(l, scene);
        return;
    }
    if (scene->model->light_groups.count > 0) {
        gather_by_group(l, scene);
        return;
    }
    for (size_t k = 0; l->finishes.count > 0 && k < scene->light_count; k++) {
        if (c->failed || interrupt_is_due(&c->interrupt, l->finishes.count))
            return;
        add_light_source(l, &scene->lights[k]);
    }
}
