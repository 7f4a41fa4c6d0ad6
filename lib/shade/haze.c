#include "shade/haze.h"

#include "light/aim.h"
#include "shade/air.h"
#include "shade/fade.h"
#include "shade/photons.h"
#include "shade/spawn.h"
#include "shade/transmittance.h"

static double length_of(const pov_ray *ray, double from, double to) { return (to - from) * light_length(ray->dir); }

static media_segment segment_of(const pov_ray *ray, double from, double to)
{
    const media_segment s = { pov_add(ray->org, pov_scale(ray->dir, from)), pov_unit(ray->dir), length_of(ray, from, to) };

    return s;
}

/* ---- light on its way ---- */

/* Across a crossing of a ray. */
static void walk_over(const shading *scene, interior_walk *w, const pov_ray *ray, const pov_crossing *at)
{
    hit h = { .object = at->owner, .crossing = *at };

    if (shading_info(scene, at->owner)->filled)
        world_surface(scene->world, ray, &h);
    walk_cross(scene, w, at->owner, h.entering);
}

/* Pieces in the same media, which vary. */
typedef struct varied_pieces { uint32_t count; uint8_t at[MEDIA_TOGETHER]; media_segment on[MEDIA_TOGETHER]; media_set set; } varied_pieces;

/* What is still to be multiplied, by piece: those of one ray in their order. Pieces in media that are even are found side by side, and those
 * in media that vary, where these are the same. */
enum { VARIED_SETS = 4 };
typedef struct dims {
    const shading *scene;
    light_product *by;           /* by ray */
    uint32_t count, even;
    uint8_t ray[LANES_MAX], even_at[LANES_MAX];
    colour left[LANES_MAX];
    media_depths depths;         /* of even pieces */
    varied_pieces varied[VARIED_SETS];
} dims;

static void begin_dims(dims *d, const shading *scene, light_product *by)
{
    d->scene = scene;
    d->by = by;
    d->count = d->even = 0;
    for (uint32_t i = 0; i < VARIED_SETS; i++)
        d->varied[i].count = 0;
}

static void find_even(dims *d)
{
    const bool all = d->even == d->count;
    colour left[LANES_MAX];

    media_depths_left(&d->depths, d->even, all ? d->left : left);
    for (uint32_t i = 0; !all && i < d->even; i++)
        d->left[d->even_at[i]] = left[i];
    d->even = 0;
}

static void find_varied(dims *d, varied_pieces *v)
{
    colour left[MEDIA_TOGETHER];

    media_transmittances(d->scene->model, &v->set, v->on, v->count, left);
    for (uint32_t i = 0; i < v->count; i++)
        d->left[v->at[i]] = left[i];
    v->count = 0;
}

static void take_dims(dims *d)
{
    if (d->even > 0)
        find_even(d);
    for (uint32_t i = 0; i < VARIED_SETS; i++)
        if (d->varied[i].count > 0)
            find_varied(d, &d->varied[i]);
    for (uint32_t i = 0; i < d->count; i++)
        light_take(&d->by[d->ray[i]], d->left[i]);
    d->count = 0;
}

/* Where pieces in these media are, or may be. */
static varied_pieces *pieces_in(dims *d, const media_set *set)
{
    varied_pieces *out = d->varied;

    for (uint32_t i = 0; i < VARIED_SETS; i++) {
        if (d->varied[i].count > 0 && media_set_same(&d->varied[i].set, set))
            return &d->varied[i];
        if (d->varied[i].count < out->count)
            out = &d->varied[i];
    }
    if (out->count > 0)
        find_varied(d, out);
    out->set = *set;
    return out;
}

static void add_varied(dims *d, const media_set *set, media_segment s)
{
    varied_pieces *v = pieces_in(d, set);

    v->at[v->count] = (uint8_t)d->count;
    v->on[v->count++] = s;
    if (v->count == MEDIA_TOGETHER)
        find_varied(d, v);
}

static void dim(dims *d, const media_set *set, const pov_ray *ray, double from, double to, uint32_t which)
{
    if (d->count == LANES_MAX)
        take_dims(d);
    if (set->varies) {
        add_varied(d, set, segment_of(ray, from, to));
    } else {
        d->even_at[d->even] = (uint8_t)d->count;
        media_depths_put(d->scene->model, set, length_of(ray, from, to), d->even++, &d->depths);
    }
    d->ray[d->count++] = (uint8_t)which;
}

void haze_dim(const shading *scene, interior_walk *around, const pov_ray *const *rays, const occlusion *found, uint64_t which, light_product *by)
{
    dims d;

    begin_dims(&d, scene, by);
    for (; which; which &= which - 1) {
        const uint32_t i = first_of64(which);
        double before = 0.0;

        for (uint32_t k = 0; k < found->count[i]; k++) {
            const pov_crossing *at = &found->at[i][k];
            media_set set;

            walk_media(scene, &around[i], &set);
            if (set.dims && at->t > before)
                dim(&d, &set, rays[i], before, at->t, i);
            walk_over(scene, &around[i], rays[i], at);
            before = at->t;
        }
    }
    take_dims(&d);
}

/* Pieces of segments of light that fogs dim, those of one ray in their order. */
typedef struct fogged {
    const shading *scene;
    colour *through;             /* by ray */
    uint8_t ray[LANES_MAX];
    fog_segments on;
} fogged;

static void dim_by_fogs(fogged *f)
{
    fog_veils v;

    if (f->on.count == 0)
        return;
    fog_fill(&f->on);
    fog_find(f->scene->model, &f->on, &v);
    for (uint32_t i = 0; i < f->on.count; i++) {
        colour *through = &f->through[f->ray[i]];

        *through = colour_mul(*through, colour_of(v.by[0][i], v.by[1][i], v.by[2][i]));
    }
    f->on.count = 0;
}

static void add_to_fogs(fogged *f, uint32_t which, const interior_walk *w, const pov_ray *ray, double from, double to)
{
    const uint32_t n = f->on.count;
    media_segment s;

    if (f->scene->model->fogs.count == 0 || w->solids > 0 || !(to > from))
        return;
    s = segment_of(ray, from, to);
    lanes_put(&f->on.from, n, s.from);
    lanes_put(&f->on.dir, n, s.dir);
    f->on.length[n] = s.length;
    f->ray[n] = (uint8_t)which;
    f->on.count = n + 1;
    if (f->on.count == LANES_MAX)
        dim_by_fogs(f);
}

/* Add the pieces of a segment. Returns where the atmosphere ends: it dims each piece that ends at a surface, in solids too, and the
 * last one if that lies in none. */
static double add_pieces(fogged *f, uint32_t which, interior_walk *w, const pov_ray *ray, double tmax, const occlusion *found)
{
    const uint32_t count = found->crossed >> which & 1 ? found->count[which] : 0;
    double before = 0.0;

    if (count > 0)
        fade_sort(found->at[which], count);
    for (uint32_t i = 0; i < count; i++) {
        const pov_crossing *at = &found->at[which][i];

        add_to_fogs(f, which, w, ray, before, at->t);
        walk_over(f->scene, w, ray, at);
        before = at->t;
    }
    add_to_fogs(f, which, w, ray, before, tmax);
    return w->solids == 0 ? tmax : before;
}

static void dim_by_varied(const shading *scene, const media_set *set, const light_segments *on, const double *to, colour *through)
{
    media_segment some[MEDIA_TOGETHER];
    uint32_t of[MEDIA_TOGETHER], n = 0;
    colour left[MEDIA_TOGETHER];

    for (uint32_t i = 0; i < on->count; i++) {
        if (to[i] > 0.0) {
            some[n] = segment_of(on->rays[i], 0.0, to[i]);
            of[n++] = i;
        }
        if (n < MEDIA_TOGETHER && i + 1 < on->count)
            continue;
        media_transmittances(scene->model, set, some, n, left);
        while (n-- > 0)
            through[of[n]] = colour_mul(through[of[n]], left[n]);
        n = 0;
    }
}

/* A segment that ends where it begins leaves all. */
static void dim_by_even(const shading *scene, const media_set *set, const light_segments *on, const double *to, colour *through)
{
    colour left[BATCH_MAX];
    media_depths depths;

    for (uint32_t i = 0; i < on->count; i++)
        media_depths_put(scene->model, set, to[i] > 0.0 ? length_of(on->rays[i], 0.0, to[i]) : 0.0, i, &depths);
    media_depths_left(&depths, on->count, left);
    for (uint32_t i = 0; i < on->count; i++)
        through[i] = colour_mul(through[i], left[i]);
}

/* to: by ray, where its part in the air ends. */
static void attenuate_by_atmosphere(const shading *scene, const light_segments *on, const double *to, colour *through)
{
    media_set set;

    walk_atmosphere(scene, 0, &set);
    if (set.dims)
        (set.varies ? dim_by_varied : dim_by_even)(scene, &set, on, to, through);
}

/* As in POV-Ray fog dims what lies in no solid. */
static void attenuate(const shade_context *c, const light_segments *on, colour *through)
{
    const shading *scene = c->scene;
    double air[BATCH_MAX];
    occlusion found;
    interior_walk w;
    fogged f;

    f.scene = scene;
    f.through = through;
    f.on.count = 0;
    found.crossed = 0;
    if (scene->plan->transmission)
        query_occlusion(scene->world, c->context, on->rays, on->count, on->tmax, &found);
    for (uint32_t i = 0; i < on->count; i++) {
        walk_begin(c, on->from[i], &w);
        air[i] = add_pieces(&f, i, &w, on->rays[i], on->tmax, &found);
    }
    dim_by_fogs(&f);
    if (scene->model->atmosphere)
        attenuate_by_atmosphere(scene, on, air, through);
}

void haze_attenuate(const shade_context *c, const light *from, const light_segments *on, uint64_t lit, colour *through)
{
    const shading *scene = c->scene;
    const path *paths[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];
    light_segments some = { rays, paths, 0, on->tmax };
    colour left[BATCH_MAX];

    if (!(from->flags & LIGHT_ATTENUATED) || (scene->model->fogs.count == 0 && !scene->model->atmosphere))
        return;
    for (uint64_t rest = lit; rest; rest &= rest - 1, some.count++) {
        const uint32_t i = first_of64(rest);

        rays[some.count] = on->rays[i];
        paths[some.count] = on->from[i];
        left[some.count] = through[i];
    }
    if (some.count > 0)
        attenuate(c, &some, left);
    for (uint32_t n = 0; lit; lit &= lit - 1)
        through[first_of64(lit)] = left[n++];
}

/* ---- light that is scattered to a path ---- */

/* Samples on a path's segment, and their rays to a light. */
typedef struct beams {
    shade_context *context;
    const path *path;
    const scene_light *light;
    uint32_t number;             /* of the light */
    media_samples samples;
    pov_ray own[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];
    const path *from[BATCH_MAX];
} beams;

/* Points of an area light for each sample on a segment, each of an equal part of its weight. */
enum { AREA_POINTS = 4 };

/* The direction to a point of the light's area instead of that to its middle. */
static pov_vec3 aim_at_area(const beams *b, uint32_t i, uint32_t part, const media_random *random)
{
    const light_grid *g = b->light->grid;
    const light *l = b->light->light;
    const double turn = media_number(random, b->number) + 0.61803398874989485 * (double)i;
    const uint32_t k = grid_draw(g, ((turn - floor(turn)) + (double)part) / AREA_POINTS);
    vec_lanes point, low, to, dir;
    const light_points at = { &point, &low, 1 };

    for (uint32_t lane = 0; lane < lanes_whole(1); lane++) {
        lanes_put(&point, lane, lanes_at(&b->samples.point, i));
        lanes_put(&low, lane, lanes_at(&b->samples.point_lo, i));
        lanes_put(&to, lane, lanes_at(&b->samples.in.dir, i));
    }
    grid_aim(l, g, &k, DRAW_SCATTERED, &at, &to, &dir, NULL);
    return lanes_at(&dir, 0);
}

static void aim(beams *b, uint32_t part, const media_random *random)
{
    const media_samples *s = &b->samples;

    for (uint32_t i = 0; i < s->count; i++) {
        const pov_ray ray = { .org = lanes_at(&s->point, i), .org_lo = lanes_at(&s->point_lo, i),
                              .dir = b->light->grid ? aim_at_area(b, i, part, random) : lanes_at(&s->in.dir, i),
                              .origin_surface = POV_NO_OWNER };

        b->own[i] = ray;
        b->rays[i] = &b->own[i];
        b->from[i] = b->path;
    }
}

/* Rays that cross what a light is projected through end there. Bit i: ray i does. */
static uint64_t shorten(beams *b)
{
    uint64_t through = 0;

    for (uint32_t i = 0; i < b->samples.count; i++)
        through |= (uint64_t)transmittance_shorten(b->context, b->light->light, b->samples.in.tmax, &b->own[i]) << i;
    return through;
}

/* The light of the samples that is not occluded, on the way from one part of an area light. */
static colour add_visible(beams *b, uint32_t part, const media_random *random)
{
    shade_context *c = b->context;
    const light *l = b->light->light;
    const light_origin origin = light_own_origin(l);
    const bool at_one = !b->light->class->parallel && !b->light->grid && l->through_count == 0;
    const segment_end end = { b->samples.in.tmax, at_one ? &origin : NULL, 0 };
    const light_segments on = { b->rays, b->from, b->samples.count, end.tmax };
    colour through[BATCH_MAX], sum = colour_of(0.0f, 0.0f, 0.0f);
    uint64_t lit = ~(uint64_t)0;

    aim(b, part, random);
    if (l->through_count > 0)
        lit = shorten(b);
    c->counts.shadow += b->samples.count;
    lit &= transmittance_find(c, b->rays, b->from, b->samples.count, end, through);
    haze_attenuate(c, l, &on, lit, through);
    for (; lit; lit &= lit - 1) {
        const uint32_t i = first_of64(lit);

        sum = colour_add(sum, colour_mul(b->samples.value[i], through[i]));
    }
    return sum;
}

static colour add_light(beams *b, const media_random *random)
{
    colour sum = colour_of(0.0f, 0.0f, 0.0f);

    if (!b->light->grid)
        return add_visible(b, 0, random);
    for (uint32_t part = 0; part < AREA_POINTS; part++)
        sum = colour_add(sum, colour_scale(add_visible(b, part, random), 1.0f / AREA_POINTS));
    return sum;
}

/* All that lamps give to the segment. */
static colour gather(shade_context *c, const path *p, const media_march *march)
{
    const shading *scene = c->scene;
    const media_random areas = { mix_bits(march->random.key), march->random.turn };
    colour sum = colour_of(0.0f, 0.0f, 0.0f);
    beams b;

    b.context = c;
    b.path = p;
    for (uint32_t k = 0; k < scene->light_count && !c->failed; k++) {
        const light *l = scene->lights[k].light;

        if (l->flags & (LIGHT_NO_MEDIA | LIGHT_SHADOWLESS))
            continue;
        b.light = &scene->lights[k];
        b.number = k;
        if (scene->plan->photons)
            photons_aim(c, k);
        if (media_sample_light(march, l, b.light->class, k, &b.samples))
            sum = colour_add(sum, add_light(&b, &areas));
        c->failed = c->failed || query_context_failed(c->context);
    }
    return sum;
}

/* ---- photons that are scattered to a path ---- */

/* Photons near the segment, a handful at a time. */
typedef struct lit_photons { const media_march *march; media_light some; colour sum; } lit_photons;

static void empty(lit_photons *g)
{
    g->sum = colour_add(g->sum, media_scattered(g->march, &g->some));
    g->some.count = 0;
}

static void add_photon(void *user, const photon *p, double at, float density)
{
    lit_photons *g = user;
    media_light *some = &g->some;

    some->at[some->count] = at;
    some->from[some->count] = pov_vec3_of(-(double)p->dir[0], -(double)p->dir[1], -(double)p->dir[2]);
    some->light[some->count++] = colour_scale(p->flux, density);
    if (some->count == LANES_MAX)
        empty(g);
}

static colour gather_photons(const photon_map *map, const photon_view *view, const path *p, const media_march *march)
{
    const media_segment *on = &march->on;
    photon_cell cell;
    const bool straight = !p->mirrored && p->gathers == 0 && photon_view_along(view, on->from, on->dir, &cell);
    const photon_ray ray = { on->from, on->dir, on->length, view->least * photon_view_spacing(view, on->from), view->least * view->slope,
                             straight ? &cell : NULL };
    lit_photons g;

    g.march = march;
    g.some.count = 0;
    g.sum = colour_of(0.0f, 0.0f, 0.0f);
    photon_map_follow(map, &ray, add_photon, &g);
    if (g.some.count > 0)
        empty(&g);
    return g.sum;
}

/* ---- segments of paths ---- */

/* Random numbers of a path's segment. Those of a pixel's samples fill the strata evenly. */
static media_random random_of(const shade_context *c, const path *p, bool air)
{
    const sample_id *id = &c->samples[p->lane], half = { id->pixel, id->number & 1, 0, 0 };
    const uint32_t purpose = (p->branch + p->draw) * 0x9e3779b1u + (air ? TURN_AIR : TURN_MEDIA);
    const media_random r = { random_bits(&half, purpose), random_number(id, purpose) };

    return r;
}

/* Put the media of a set before what `by` and `given` say is seen behind. */
static void veil(shade_context *c, const path *p, const media_set *set, const media_segment *on, colour *by, colour *given)
{
    media_march march;

    if (set->count == 0 || !(on->length > 0.0))
        return;
    march.model = c->scene->model;
    march.set = set;
    march.on = *on;
    march.random = random_of(c, p, set->of[0].leaf == MEDIA_AIR);
    march.scale = c->scene->scale;
    march.weight = pov_min(1.0, (double)colour_weight(p->factor.by));
    media_march_begin(&march);
    if (set->scatters && c->scene->plan->scattering)
        march.given = colour_add(march.given, gather(c, p, &march));
    if (set->scatters && c->photons && c->photons[p->lane]->of[PHOTON_IN].node_count > 0 && set->of[0].leaf != MEDIA_AIR)
        march.given = colour_add(march.given, gather_photons(&c->photons[p->lane]->of[PHOTON_IN], &c->views[p->lane], p, &march));
    *by = colour_mul(*by, march.through);
    *given = colour_add(colour_mul(march.through, *given), march.given);
}

void haze_cross(shade_context *c, const path *p, const media_segment *on, bool ends, colour *by, colour *given)
{
    interior_walk w;
    media_set set;

    *by = colour_of(1.0f, 1.0f, 1.0f);
    *given = colour_of(0.0f, 0.0f, 0.0f);
    walk_begin(c, p, &w);
    walk_media(c->scene, &w, &set);
    if (ends)
        veil(c, p, &set, on, by, given);
    walk_atmosphere(c->scene, p->solids, &set);
    veil(c, p, &set, on, by, given);
}
