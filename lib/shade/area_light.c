#include "shade/area_light.h"

#include "light/aim.h"
#include "shade/area_view.h"
#include "shade/shadow.h"

#include <string.h>

/* A view costs as much as the rays to so many points. */
enum { VIEW_FROM = 20 };

/* Light that something dims on its way, hidden or not, needs its rays; a view is of light that comes from points. */
static bool needs_rays(const scene_light *from)
{
    return from->grid->count < VIEW_FROM || from->class->parallel || from->light->through_count > 0 || (from->light->flags & LIGHT_ATTENUATED);
}

static area_start start_of(const lighting *l, uint32_t lane)
{
    const shade_context *c = l->context;
    const surface *s = &l->on->at[lane];
    const area_start out = { s->at, lanes_at(&l->on->geometry.to.normal, lane), s->coincident ? &c->coincident_sets.items[s->coincident - 1] : NULL };

    return out;
}

/* Views by ray; `open`: rays from which something may hide a part of the light. The others get all of it or nothing; *lit:
 * those that do. */
static uint32_t find_views(const lighting *l, const scene_light *from, const vec_lanes *to, area_view *views, uint8_t *open,
                           uint64_t *lit, colour *through)
{
    const float sum = from->grid->sum;
    uint32_t n = 0;

    for (uint32_t i = 0; i < l->count; i++) {
        const area_start start = start_of(l, l->of[i]);
        bool is_clear;

        area_view_find(l->context->scene, from, &start, lanes_at(to, l->of[i]), &views[i]);
        is_clear = !views[i].dark && views[i].count == 0;
        through[i] = is_clear ? colour_of(sum, sum, sum) : colour_of(0.0f, 0.0f, 0.0f);
        *lit |= (uint64_t)is_clear << i;
        if (!views[i].dark && views[i].count > 0)
            open[n++] = (uint8_t)i;
    }
    return n;
}

/* ---- rays to points ---- */

/* By ray, of points that follow one another, those that nothing hides, those that it takes a ray to tell, and those whose light is dimmed
 * alike, which one ray tells: to `first`, and what it found. */
typedef struct area_bits { uint64_t lit[BATCH_MAX], open[BATCH_MAX], alike[BATCH_MAX]; uint32_t first[BATCH_MAX]; colour left[BATCH_MAX]; } area_bits;

/* The light of all points, by ray: those of l->seen. */
typedef struct area_tracing {
    lighting *l;
    const scene_light *from;
    const vec_lanes *to;
    colour *through;
    uint64_t lit;                /* rays that get any */
    uint32_t first;              /* the point of the first bit */
    area_bits bits;
    uint32_t count;              /* rays to trace, at once; each of one of the others, to a point */
    uint8_t which[BATCH_MAX];
    uint32_t point[BATCH_MAX];
} area_tracing;

static void add_point(area_tracing *t, uint32_t i, uint32_t k, colour left)
{
    t->through[i] = colour_add(t->through[i], colour_scale(left, t->from->grid->points[k].weight));
    t->lit |= (uint64_t)1 << i;
}

/* Add the points before this bit that took no ray: points are added in their order. */
static void add_known(area_tracing *t, uint32_t i, uint32_t bit)
{
    const uint64_t before = bit < AREA_PARTS ? ((uint64_t)1 << bit) - 1 : ~(uint64_t)0, alike = t->bits.alike[i];

    for (uint64_t rest = (t->bits.lit[i] | alike) & before; rest; rest &= rest - 1) {
        const uint32_t k = first_of64(rest);

        add_point(t, i, t->first + k, alike >> k & 1 ? t->bits.left[i] : colour_of(1.0f, 1.0f, 1.0f));
    }
    t->bits.lit[i] &= ~before;
    t->bits.alike[i] &= ~before;
}

/* What the ray to a point found. */
static void add_traced(area_tracing *t, uint32_t i, uint32_t k, bool lit, colour left)
{
    add_known(t, i, k - t->first);
    if (lit)
        add_point(t, i, k, left);
    if (k != t->bits.first[i])
        return;
    t->bits.left[i] = left;
    t->bits.alike[i] = lit ? t->bits.alike[i] : 0;
}

/* Their starts close together: what fills up a vector is the last one. */
typedef struct starts { vec_lanes point, point_lo, to; } starts;

static void find_starts(const area_tracing *t, starts *out)
{
    const geometry *g = &t->l->on->geometry;

    for (uint32_t n = 0; n < lanes_whole(t->count); n++) {
        const uint8_t lane = t->l->seen[t->which[n < t->count ? n : t->count - 1]];

        lanes_put(&out->point, n, lanes_at(&g->to.point, lane));
        lanes_put(&out->point_lo, n, lanes_at(&g->to.point_lo, lane));
        lanes_put(&out->to, n, lanes_at(t->to, lane));
    }
}

/* Put the rays in memory of their own, instead of those of the surfaces. */
static void put_rays(area_tracing *t, pov_ray *own, light_origin *ends)
{
    lighting *l = t->l;
    vec_lanes dir;
    starts s;
    const light_points at = { &s.point, &s.point_lo, t->count };

    find_starts(t, &s);
    grid_aim(t->from->light, t->from->grid, t->point, DRAW_SHADOWS, &at, &s.to, &dir, ends);
    for (uint32_t n = 0; n < t->count; n++) {
        l->of[n] = l->seen[t->which[n]];
        own[n] = l->own[l->of[n]];
        own[n].dir = lanes_at(&dir, n);
        l->rays[n] = &own[n];
    }
    l->count = t->count;
    l->own = own;
    shadow_name_rays(l, &dir);
}

static void trace_rays(area_tracing *t)
{
    lighting *l = t->l;
    pov_ray *const before = l->own, own[BATCH_MAX];
    light_origin ends[BATCH_MAX];
    const segment_end end = { 1.0, t->from->class->parallel ? NULL : ends, true };
    colour some[BATCH_MAX];
    uint64_t lit;

    put_rays(t, own, ends);
    lit = shadow_trace(l, t->from->light, end, some);
    l->own = before;
    for (uint32_t n = 0; n < t->count; n++)
        add_traced(t, t->which[n], t->point[n], lit >> n & 1, some[n]);
    t->count = 0;
}

/* Of these rays, those to the k-th point that it takes to tell. */
static void put_point(area_tracing *t, uint32_t k, const uint8_t *open, uint32_t count)
{
    for (uint32_t n = 0; n < count; n++) {
        if (!(t->bits.open[open[n]] >> (k - t->first) & 1))
            continue;
        if (t->count == BATCH_MAX)
            trace_rays(t);
        t->which[t->count] = open[n];
        t->point[t->count++] = k;
    }
}

/* The points from t->first on. */
static void trace_points(area_tracing *t, const uint8_t *open, uint32_t count)
{
    const uint32_t left = t->from->grid->count - t->first;

    for (uint32_t k = t->first; k < t->first + (left < AREA_PARTS ? left : AREA_PARTS); k++)
        put_point(t, k, open, count);
    if (t->count > 0)
        trace_rays(t);
    for (uint32_t n = 0; n < count; n++)
        add_known(t, open[n], AREA_PARTS);
}

static void put_bits(area_bits *b, uint32_t i, uint32_t first, area_states s)
{
    const uint64_t told = s.alike & (s.alike - 1);

    b->lit[i] = s.lit;
    b->open[i] = s.open & ~told;
    b->alike[i] = told;
    b->first[i] = s.alike ? first + first_of64(s.alike) : UINT32_MAX;
}

static void find_bits(area_tracing *t, const area_view *views, const uint8_t *open, uint32_t count)
{
    area_parts parts;

    area_parts_find(t->from->grid, t->first, &parts);
    for (uint32_t n = 0; n < count; n++)
        put_bits(&t->bits, open[n], t->first, area_view_open(&views[open[n]], &parts));
}

/* All rays to all points. */
static void trace_all(area_tracing *t)
{
    const area_states open = { ~(uint64_t)0, 0, 0 };
    const uint32_t count = t->l->count;
    uint8_t all[BATCH_MAX];

    for (uint32_t i = 0; i < count; i++) {
        all[i] = (uint8_t)i;
        t->through[i] = colour_of(0.0f, 0.0f, 0.0f);
        put_bits(&t->bits, i, 0, open);
    }
    for (; t->first < t->from->grid->count; t->first += AREA_PARTS)
        trace_points(t, all, count);
}

/* The rays to points that something may hide. */
static void trace_hidden(area_tracing *t)
{
    area_view views[BATCH_MAX];
    uint8_t open[BATCH_MAX];
    const uint32_t count = find_views(t->l, t->from, t->to, views, open, &t->lit, t->through);

    for (; count > 0 && t->first < t->from->grid->count; t->first += AREA_PARTS) {
        find_bits(t, views, open, count);
        trace_points(t, open, count);
    }
}

/* The mean transmittance to all points of an area light; `to` are the directions to its middle. */
static uint64_t trace_area(lighting *l, const scene_light *from, const vec_lanes *to, colour *through)
{
    const uint32_t count = l->count;
    area_tracing t;

    t.l = l;
    t.from = from;
    t.to = to;
    t.through = through;
    t.lit = 0;
    t.first = t.count = 0;
    memcpy(l->seen, l->of, count);
    (needs_rays(from) ? trace_all : trace_hidden)(&t);
    memcpy(l->of, l->seen, count);
    l->count = count;
    shadow_name_origins(l, NULL);
    return t.lit;
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
    vec_lanes dir;

    for (uint32_t i = 0; i < lanes_whole(1); i++) {
        lanes_put(&point, i, lanes_at(&g->to.point, lane));
        lanes_put(&low, i, lanes_at(&g->to.point_lo, lane));
        lanes_put(&middle, i, lanes_at(to, lane));
    }
    grid_aim(from->light, from->grid, &k, DRAW_SHADOWS, &at, &middle, &dir, end);
    return lanes_at(&dir, 0);
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
    uint32_t points[BATCH_MAX];

    if (from->grid->moves) {
        for (uint32_t i = 0; i < at->n; i++)
            points[i] = k;
        grid_aim(from->light, from->grid, points, DRAW_REFLECTED, at, &middle->dir, &in->dir, NULL);
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
