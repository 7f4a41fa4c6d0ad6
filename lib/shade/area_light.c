#include "shade/area_light.h"

#include "light/aim.h"
#include "shade/area_view.h"
#include "shade/shadow.h"

#include <string.h>

/* Directions to the k-th point of an area light from some lanes, and the point: one for each where it moves. */
static void aim_at_point(const scene_light *from, uint32_t k, const light_points *at, const vec_lanes *to,
                         const uint8_t *lanes, uint32_t count, light_lanes *in, light_origin *ends)
{
    in->tmax = 1.0;
    if (from->grid->moves) {
        grid_aim(from->light, from->grid, k, DRAW_SHADOWS, at, to, lanes, count, &in->dir, ends);
    } else {
        ends[0] = grid_origin(from->light, from->grid, k);
        light_aim(ends, at, &in->dir);
    }
}

/* A view costs as much as the rays to so many points. */
enum { VIEW_FROM = 20 };

/* Light that something dims on its way, hidden or not, needs its rays; a view is of light that comes from points. */
static bool needs_rays(const scene_light *from)
{
    return from->grid->count < VIEW_FROM || from->class->parallel || from->light->through_count > 0 || (from->light->flags & LIGHT_ATTENUATED);
}

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

/* By ray, of points that follow one another, those that nothing hides, and those that it takes a ray to tell. */
typedef struct area_bits { uint64_t lit[BATCH_MAX], open[BATCH_MAX]; } area_bits;

static void find_bits(const light_grid *g, uint32_t k, const area_view *views, const uint8_t *open, uint32_t count, area_bits *out)
{
    area_parts parts;

    area_parts_find(g, k, &parts);
    for (uint32_t n = 0; n < count; n++)
        out->open[open[n]] = area_view_open(&views[open[n]], &parts, &out->lit[open[n]]);
}

/* Of the open rays those that it takes to tell whether something hides the k-th point. The others get its light, or none. */
static uint64_t choose_hidden(lighting *l, const light_grid *g, uint32_t k, const area_bits *bits, const uint8_t *open,
                              uint32_t count, uint8_t *which, colour *through)
{
    const uint32_t bit = k % AREA_PARTS;
    const float weight = g->points[k].weight;
    uint64_t lit = 0;

    l->count = 0;
    for (uint32_t n = 0; n < count; n++) {
        const uint8_t i = open[n];

        if (bits->lit[i] >> bit & 1) {
            through[i] = colour_add(through[i], colour_of(weight, weight, weight));
            lit |= (uint64_t)1 << i;
        } else if (bits->open[i] >> bit & 1) {
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
    const bool moves = from->grid->moves;
    const light_points at = lighting_points(l);
    light_origin ends[BATCH_MAX];
    colour some[BATCH_MAX];
    light_lanes in;
    uint64_t lit = 0;

    aim_at_point(from, k, &at, to, l->of, l->count, &in, ends);
    shadow_name_sides(l, l->of, l->count, &in.dir);
    for (uint32_t i = 0; i < l->count; i++)
        l->own[l->of[i]].dir = lanes_at(&in.dir, l->of[i]);
    for (uint64_t rest = shadow_trace(l, from->light, shadow_end(from, &in, ends, moves), some); rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);

        through[which[i]] = colour_add(through[which[i]], colour_scale(some[i], from->grid->points[k].weight));
        lit |= (uint64_t)1 << which[i];
    }
    return lit;
}

/* All rays to all points. */
static uint64_t trace_all(lighting *l, const scene_light *from, const vec_lanes *to, colour *through)
{
    uint8_t which[BATCH_MAX];
    uint64_t lit = 0;

    for (uint32_t i = 0; i < l->count; i++) {
        which[i] = (uint8_t)i;
        through[i] = colour_of(0.0f, 0.0f, 0.0f);
    }
    for (uint32_t k = 0; k < from->grid->count; k++)
        lit |= trace_point(l, from, k, to, which, through);
    return lit;
}

/* The rays to points that something may hide. */
static uint64_t trace_hidden(lighting *l, const scene_light *from, const vec_lanes *to, colour *through)
{
    const uint32_t count = l->count;
    area_view views[BATCH_MAX];
    uint8_t open[BATCH_MAX], which[BATCH_MAX];
    area_bits bits;
    uint64_t lit = 0;
    const uint32_t open_count = find_views(l, from, to, views, open, &lit, through);

    memcpy(l->seen, l->of, count);
    for (uint32_t k = 0; open_count > 0 && k < from->grid->count; k++) {
        if (k % AREA_PARTS == 0)
            find_bits(from->grid, k, views, open, open_count, &bits);
        lit |= choose_hidden(l, from->grid, k, &bits, open, open_count, which, through);
        if (l->count > 0)
            lit |= trace_point(l, from, k, to, which, through);
    }
    memcpy(l->of, l->seen, count);
    l->count = count;
    return lit;
}

/* The mean transmittance to all points of an area light; `to` are the directions to its middle. */
static uint64_t trace_area(lighting *l, const scene_light *from, const vec_lanes *to, colour *through)
{
    const uint64_t lit = needs_rays(from) ? trace_all(l, from, to, through) : trace_hidden(l, from, to, through);

    shadow_name_origins(l, NULL);
    return lit;
}

/* The direction from a lane's surface to a point of the area that is drawn for its path, and the point. */
static pov_vec3 aim_at_some(const lighting *l, const scene_light *from, uint32_t lane, const vec_lanes *to, light_origin *end)
{
    const path *p = l->on->at[lane].from;
    const shade_context *c = l->context;
    const uint32_t number = (uint32_t)(from - c->scene->lights);
    const sequence_point u = random_point_of_set(&c->samples[p->lane], p->draw, p->draws, p->branch * 0x85ebca6bu + number + 1);
    const uint32_t k = grid_draw(from->grid, u.x);
    const geometry *g = &l->on->geometry;
    vec_lanes point, low, middle;
    const light_points at = { &point, &low, 1 };
    light_lanes in;

    for (uint32_t i = 0; i < lanes_whole(1); i++) {
        lanes_put(&point, i, lanes_at(&g->to.point, lane));
        lanes_put(&low, i, lanes_at(&g->to.point_lo, lane));
        lanes_put(&middle, i, lanes_at(to, lane));
    }
    aim_at_point(from, k, &at, &middle, NULL, 1, &in, end);
    return lanes_at(&in.dir, 0);
}

/* The same for one point of the area each, drawn by the weights: where radiosity gathers light more would be lost time. */
static uint64_t trace_some(lighting *l, const scene_light *from, const light_lanes *in, colour *through)
{
    light_lanes to = *in;
    light_origin ends[BATCH_MAX];
    uint64_t lit;

    to.tmax = 1.0;
    for (uint32_t i = 0; i < l->count; i++)
        lanes_put(&to.dir, l->of[i], aim_at_some(l, from, l->of[i], &in->dir, &ends[i]));
    shadow_name_sides(l, l->of, l->count, &to.dir);
    for (uint32_t i = 0; i < l->count; i++)
        l->own[l->of[i]].dir = lanes_at(&to.dir, l->of[i]);
    lit = shadow_trace(l, from->light, shadow_end(from, &to, ends, true), through);
    shadow_name_origins(l, NULL);
    return lit;
}

uint64_t area_trace(lighting *l, const scene_light *from, const light_lanes *in, colour *through)
{
    return l->on->at[0].from->gathers > 0 ? trace_some(l, from, in, through) : trace_area(l, from, &in->dir, through);
}

/* The cone and the fading of points that move: those of the light's own place, as seen from where it lies as that point does. */
static void dim_moved(const scene_light *from, uint32_t n, light_lanes *in)
{
    const light_origin own = light_own_origin(from->light);
    vec_lanes point, low;
    const light_points at = { &point, &low, n };
    light_lanes dimmed;

    for (uint32_t i = 0; i < lanes_whole(n); i++) {
        lanes_put(&point, i, pov_sub(own.from, lanes_at(&in->dir, i)));
        lanes_put(&low, i, own.from_lo);
    }
    from->class->incident(from->light, &own, &at, &dimmed);
    dimmed.dir = in->dir;
    *in = dimmed;
}

/* Incident light from the k-th point of an area light. Of beams the cone and fading are those of the middle. */
static void find_incident(const scene_light *from, uint32_t k, const light_points *at, const light_lanes *middle,
                          light_lanes *in)
{
    if (from->grid->moves) {
        grid_aim(from->light, from->grid, k, DRAW_REFLECTED, at, &middle->dir, NULL, at->n, &in->dir, NULL);
        if (!in->uniform && !from->class->parallel)
            dim_moved(from, at->n, in);
    } else {
        const light_origin origin = grid_origin(from->light, from->grid, k);

        from->class->incident(from->light, &origin, at, in);
    }
}

/* Films are those of the light's middle, as in POV-Ray. */
void area_reflect(lighting *l, const scene_light *from, light_sample *s, const light_lanes *middle, uint32_t n)
{
    const bool highlights = l->glossy && !(from->light->flags & LIGHT_SHADOWLESS);
    const light_points at = lighting_points(l);
    const float share = 1.0f / (float)from->grid->count;
    const uint32_t kinds = l->finishes.kinds;
    light_lanes in = *middle;
    light_sample one;

    l->finishes.kinds = kinds & ~(uint32_t)FINISH_IRID;
    for (uint32_t i = 0; i < n; i++)
        s->red[i] = s->green[i] = s->blue[i] = 0.0f;
    for (uint32_t k = 0; k < from->grid->count; k++) {
        find_incident(from, k, &at, middle, &in);
        brdf_cosines(&one, &l->on->geometry, &in.dir, brdf_shines(&l->finishes), n);
        brdf_reflect(&l->finishes, l->context->scene->model, &one, &in, highlights, n);
        for (uint32_t i = 0; i < n; i++) {
            s->red[i] += one.front[i] ? share * one.red[i] : 0.0f;
            s->green[i] += one.front[i] ? share * one.green[i] : 0.0f;
            s->blue[i] += one.front[i] ? share * one.blue[i] : 0.0f;
        }
    }
    l->finishes.kinds = kinds;
    if (kinds & FINISH_IRID)
        brdf_films(&l->finishes, l->context->scene->model, s, n);
    for (uint32_t i = 0; i < n; i++)
        s->front[i] = s->contributes[i] = !colour_is_black(brdf_at(s, i));
}
