#include "shade/surface.h"

#include "base/simd.h"
#include "base/vec.h"
#include "query/passage.h"
#include "shade/accumulate.h"
#include "shade/air.h"
#include "shade/paint.h"
#include "shade/photons.h"
#include "shade/reflectance.h"
#include "world/detail.h"

/* ---- coincident surfaces ---- */

/* Record a surface's coincident set. */
static void set_coincident(shade_context *c, surface *s, const coincident_set *on)
{
    if (!VEC_PUSH(c->env, &c->coincident_sets, *on)) {
        c->failed = true;
        return;
    }
    s->coincident = (uint32_t)c->coincident_sets.count;
    s->above = on->above;
    s->on = passage_which(on, s->at->object);
}

static void find_coincident(shade_context *c, surface *s)
{
    coincident_set on;

    world_coincident(c->scene->world, c->context, s->ray, NULL, s->at, &on);
    set_coincident(c, s, &on);
}

/* A path that starts on coincident surfaces first hits those that it crosses at the start, then the next ones. */
static bool hit_single(shade_context *c, surface *s)
{
    coincident_set from = c->coincident_sets.items[s->from->coincident - 1], on;

    from.above = s->from->above;
    if (!passage_step(c->scene->world, c->context, s->ray, &from, s->at, &on))
        return false;
    if (on.count > 0)
        set_coincident(c, s, &on);
    return true;
}

static bool any_coincident(const batch *b)
{
    for (uint32_t i = 0; i < b->count; i++)
        if (b->paths[i].coincident)
            return true;
    return false;
}

/* ---- what rays hit ---- */

/* Set the n-th surface, which is `at`, to that of ray i. */
static inline void place(surfaces *s, surface *at, batch *b, uint32_t i, uint32_t n)
{
    at->from = &b->paths[i];
    at->ray = b->rays[i];
    at->at = &s->hits[i];
    at->coincident = 0;
    s->rays[n] = at->ray;
    s->found[n] = at->at;
}

/* Has the object no surface for this path? */
static bool is_unseen(const shading *scene, const path *p, uint32_t object)
{
    const object_info *o = shading_info(scene, object);

    if (p->gathering)
        return o->no_radiosity;
    return p->mirrored ? o->no_reflection : o->no_image;
}

/* Are there photons, surfaces that not all rays see, or samples that neighbours use? */
static inline bool is_special(const shade_context *c, const batch *b)
{
    return c->photons_fly || c->scene->plan->hidden || b->reuse;
}

/* Does the surface need more than its emission? special: see is_special(); a: what it looks like where it is seen. */
static bool is_kept(shade_context *c, const batch *b, surface *s, bool special, const appearance *a, colour *out)
{
    const shading *scene = c->scene;

    if (s->at->coincident && !s->coincident)
        find_coincident(c, s);
    s->appearance = a;
    if (special && c->photons_fly)
        return true;
    if (special && scene->plan->hidden && is_unseen(scene, s->from, s->at->object)) {
        s->appearance = &scene->unseen;
        return true;
    }
    if (!a->lit && scene->plan->lighting)
        c->counts.shadow_idle += scene->model->lights.count;
    if (a->needs_point || (special && b->reuse))
        return true;
    accumulate(s->from, a->emitted, out);
    return false;
}

/* Ray parameter of the surface. One of several that the ray starts on is where it starts. */
static double distance_of(const surface *s)
{
    const bool stays = s->coincident && s->from->coincident && passage_stays(s->ray->org, s->at->point);

    return stays ? 0.0 : s->at->crossing.t;
}

/* Fog, rainbows and media on the way to the surface, or to nothing (NULL); and what is seen of that. */
static void cross_air(shade_context *c, batch *b, uint32_t i, const surface *at, colour *out)
{
    air_segments on;

    air_begin(&on, b, i, 1);
    on.on.length[0] = at ? distance_of(at) : HUGE_VAL;
    air_measure(c, &on);
    if (at)
        air_cross(c, &on, 1, !is_unseen(c->scene, at->from, at->at->object), out);
    else
        air_background(c, b, (uint64_t)1 << i, &on, out);
}

/* The same for all rays, of which none starts on coincident surfaces. */
SIMD_APART static void cross_air_all(shade_context *c, const surfaces *s, batch *b, uint64_t found, uint64_t missed, colour *out)
{
    const bool hidden = c->scene->plan->hidden;
    uint64_t seen = found;
    air_segments on;

    air_begin(&on, b, 0, b->count);
    for (uint32_t i = 0; i < b->count; i++)
        on.on.length[i] = HUGE_VAL;
    for (uint64_t rest = found; rest; rest &= rest - 1)
        on.on.length[first_of64(rest)] = s->hits[first_of64(rest)].crossing.t;
    for (uint64_t rest = hidden ? found : 0; rest; rest &= rest - 1)
        if (is_unseen(c->scene, &b->paths[first_of64(rest)], s->hits[first_of64(rest)].object))
            seen &= ~(rest & (~rest + 1));
    air_measure(c, &on);
    if (found)
        air_cross(c, &on, found, seen, out);
    air_background(c, b, missed, &on, out);
}

/* Intersect those that do not start on coincident surfaces. Bit i: ray i hits. */
static uint64_t find_others(shade_context *c, surfaces *s, const batch *b)
{
    const pov_ray *rays[BATCH_MAX];
    uint8_t of[BATCH_MAX];
    hit hits[BATCH_MAX];
    uint64_t found, out = 0;
    uint32_t n = 0;

    for (uint32_t i = 0; i < b->count; i++) {
        if (b->paths[i].coincident)
            continue;
        of[n] = (uint8_t)i;
        rays[n++] = b->rays[i];
    }
    found = n > 0 ? query_nearest(c->scene->world, c->context, rays, n, HUGE_VAL, hits) : 0;
    for (; found; found &= found - 1) {
        const uint32_t k = first_of64(found);

        s->hits[of[k]] = hits[k];
        out |= (uint64_t)1 << of[k];
    }
    return out;
}

/* Intersect rays, some of which start on coincident surfaces. */
static uint32_t find_each(shade_context *c, surfaces *s, batch *b, bool dims, colour *out)
{
    const uint64_t found = find_others(c, s, b);
    uint32_t n = 0;

    for (uint32_t i = 0; i < b->count; i++) {
        bool hits;

        place(s, &s->at[n], b, i, n);
        hits = b->paths[i].coincident ? hit_single(c, &s->at[n]) : (found >> i & 1) != 0;
        if (dims)
            cross_air(c, b, i, hits ? &s->at[n] : NULL, out);
        if (hits)
            n += is_kept(c, b, &s->at[n], true, shading_constant(c->scene, s->at[n].at->object), out);
        else if (!dims && !c->photons_fly)
            air_background(c, b, (uint64_t)1 << i, NULL, out);
    }
    return n;
}

/* Add the background for rays that hit nothing. All camera rays see the same, and are the first to add to their
 * colours. */
static void add_background(shade_context *c, batch *b, uint64_t rays, colour *out)
{
    const colour background = c->scene->behind;
    colour seen = colour_of(0.0f, 0.0f, 0.0f);

    if (c->photons_fly)
        return;
    if (c->scene->air || c->alpha) {
        air_background(c, b, rays, NULL, out);
        return;
    }
    if (!b->camera) {
        for (; rays; rays &= rays - 1)
            accumulate(&b->paths[first_of64(rays)], background, out);
        return;
    }
    seen = colour_add(seen, accumulate_finite(colour_mul(b->paths[0].factor.by, background)));
    for (; rays; rays &= rays - 1)
        out[b->paths[first_of64(rays)].lane] = seen;
}

/* What appearances are found by, which stays in registers while surfaces are written. */
typedef struct names { const shading *scene; const object_info *known; const appearance *appearances; uint32_t own; } names;

static inline names names_of(const shading *s)
{
    const names out = { s, s->objects_info, s->appearances, s->own_names };

    return out;
}

/* As shading_constant(). */
static inline const appearance *names_appearance(const names *n, uint32_t which)
{
    return which < n->own ? &n->appearances[n->known[which].material] : shading_constant(n->scene, which);
}

static bool are_alike(const surfaces *s)
{
    bool others = false;

    for (uint32_t i = 1; i < s->count; i++)
        others |= s->at[i].appearance != s->at[0].appearance;
    return !others;
}

/* Place the surfaces of the first rays, as long as each hits one that is lit and lies alone: most do. Returns how many do; alike:
 * all are. */
static uint32_t place_first(const names *by_name, surfaces *s, batch *b, uint64_t found, bool *alike)
{
    const uint32_t end = ~found ? first_of64(~found) : BATCH_MAX;
    uint32_t n, last = POV_NO_OWNER;
    const appearance *a = NULL;

    for (n = 0; n < end; n++) {
        hit *h = &s->hits[n];

        if (h->object != last) {
            a = names_appearance(by_name, h->object);
            last = h->object;
            *alike &= n == 0 || a == s->at[0].appearance;
        }
        if (!a->lit || h->coincident)
            break;
        place(s, &s->at[n], b, n, n);
        s->at[n].appearance = a;
    }
    return n;
}

void surfaces_find(shade_context *c, surfaces *s, batch *b, colour *out)
{
    const bool special = is_special(c, b), dims = c->scene->dims && !c->photons_fly;
    const names by_name = names_of(c->scene);
    uint64_t found, missed, rest;
    uint32_t n = 0;
    bool alike = true;

    if (c->coincident_sets.count > 0 && any_coincident(b)) {
        s->count = find_each(c, s, b, dims, out);
        s->alike = are_alike(s);
        return;
    }
    found = query_nearest(c->scene->world, c->context, b->rays, b->count, HUGE_VAL, s->hits);
    missed = ~found & ~(uint64_t)0 >> (BATCH_MAX - b->count);
    if (dims)
        cross_air_all(c, s, b, found, missed, out);
    else
        add_background(c, b, missed, out);
    if (!special)
        n = place_first(&by_name, s, b, found, &alike);
    for (rest = n < BATCH_MAX ? found >> n << n : 0; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const appearance *a = names_appearance(&by_name, s->hits[i].object);
        surface *at = &s->at[n];

        place(s, at, b, i, n);
        at->appearance = a;
        /* Most surfaces are lit, and then kept. */
        if (special || !a->lit || s->hits[i].coincident) {
            if (!is_kept(c, b, at, special, a, out))
                continue;
            a = at->appearance;
        }
        alike &= a == s->at[0].appearance;
        n++;
    }
    s->count = n;
    s->alike = alike;
}

/* ---- points and normals ---- */

/* Complete surfaces, some of them coincident: the latter's points and normals are known. */
static void complete_some(const shade_context *c, surfaces *s)
{
    const pov_ray *rays[BATCH_MAX];
    hit *hits[BATCH_MAX];
    uint32_t count = 0, i;

    for (i = 0; i < s->count; i++) {
        if (s->at[i].coincident)
            continue;
        rays[count] = s->rays[i];
        hits[count++] = s->found[i];
    }
    if (count > 0)
        world_surface_many(c->scene->world, NULL, rays, hits, count, &s->geometry.to);
    for (i = 0; i < s->count; i++)
        world_incidence(&s->geometry.to, i, s->rays[i], s->found[i]);
}

/* Use the shading normals of surfaces that have some. */
static void set_shading_normals(const shading *scene, surfaces *s)
{
    geometry *g = &s->geometry;
    pov_vec3 normals[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];
    hit *hits[BATCH_MAX];
    uint8_t of[BATCH_MAX];
    uint32_t n = 0;
    uint64_t smooth;

    for (uint32_t i = 0; i < s->count; i++) {
        if (!shading_info(scene, s->found[i]->object)->smooth)
            continue;
        rays[n] = s->rays[i];
        hits[n] = s->found[i];
        of[n++] = (uint8_t)i;
    }
    smooth = n > 0 ? world_shading_normals(scene->world, rays, hits, n, normals) : 0;
    if (!smooth)
        return;
    g->smooth = g->to.normal;
    for (; smooth; smooth &= smooth - 1) {
        const uint32_t k = first_of64(smooth);

        lanes_put(&g->smooth, of[k], normals[k]);
    }
    g->shading = g->raw = &g->smooth;
}

/* Does no path go on from any of them, as all are at the last level? Rays that go straight on keep theirs. */
static bool all_end(const shade_context *c, const surfaces *s)
{
    const int level = photons_max_level(c);

    for (uint32_t i = 0; i < s->count; i++) {
        const surface *at = &s->at[i];

        if (at->from->level < level || (at->appearance->transmissive && (at->appearance->clear || !c->scene->model->opaque_last_level)))
            return false;
    }
    return true;
}

/* Are all of them seen alike from everywhere? Then nothing asks for the directions of view and mirror. */
static bool are_matt(const plan *p, const surfaces *s)
{
    const appearance *a = s->count > 0 ? s->at[0].appearance : NULL;

    return a && s->alike && !a->stack && !a->kinds && a->finish->phong == 0.0f && !a->reflective && !a->transmissive && !a->angular &&
           !p->photons && !p->subsurface && !p->refraction;
}

int surfaces_complete(shade_context *c, surfaces *s, painted *p)
{
    const shading *scene = c->scene;
    paint_kind kind = PAINT_SINGLE;
    const object_space_rays *own = scene->plan->scattering ? NULL : query_context_own(c->context);   /* light was asked for since */

    if (c->coincident_sets.count > 0)
        complete_some(c, s);
    else
        world_surface_many(scene->world, own, s->rays, s->found, s->count, &s->geometry.to);
    s->geometry.shading = s->geometry.raw = &s->geometry.to.normal;
    s->interfaces = 0;
    s->filmed = 0;
    s->coloured = NULL;
    s->layered = NULL;
    if (scene->plan->smooth)
        set_shading_normals(scene, s);
    if (scene->plan->textures)
        kind = paint_evaluate(scene, s, p);
    if (kind == PAINT_TERMS)
        return kind;
    if (scene->plan->textures) {
        paint_surfaces(scene, s, p);
        s->alike = are_alike(s);
    }
    if (!are_matt(scene->plan, s))
        geometry_turn(&s->geometry, s->count);
    s->ends = all_end(c, s);
    if ((scene->angular || scene->plan->fading) && !s->ends)
        reflectance_set(c, s);
    return kind;
}
