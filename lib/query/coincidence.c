#include "query/context.h"

#include <string.h>

/* Two crossings lie in one place when their distances differ by no more than two-part arithmetic can be off: some 2^-98
 * of the lengths that take part, over the cosine between ray and surface; with margin. Gaps that doubles can hold are
 * wider: half a unit in the last place of a coordinate is 2^-54 of it. */
static const double same_place = 0x1p-92;
/* Around a distance that double found, all that may be as near in truth: wider than POV_NEAR. */
static const double around = 0x1p-45;

/* ---- a query that leaves several surfaces by name ---- */

/* Slower than the usual ones: no filters, and two-part arithmetic. */
typedef struct asking {
    bvh_walk walk;               /* first: leaves are handed this */
    walker *walker;
    pov_ray ray;                 /* the walk's, with the name of what is left changing from object to object */
    const spot *from;            /* NULL: the ray's own name holds for all */
    pov_hits hits, tints;        /* tints: of transparent shapes, where `light` is asked for */
    bool light, any_blocks;
} asking;

static void begin(asking *a, const world *w, walker *k, const spot *from, const pov_ray *ray, double tmax)
{
    memset(a, 0, sizeof *a);
    a->walker = k;
    a->walk.tree = &w->tree;
    a->walk.at = w->has_tree ? w->tree.frames[0].root : 0;
    a->walk.ray = ray;
    a->walk.limit = tmax;
    a->walk.length = sqrt(pov_dot(ray->dir, ray->dir));
    a->walk.per_length = 1.0 / a->walk.length;
    a->ray = *ray;
    a->from = from;
    a->hits.tmax = tmax;
    a->hits.always_exact = true;
    a->hits.owner = POV_NOBODY;
    a->hits.user = &k->rooms[0];
    a->hits.capacity = k->rooms[0].capacity;
    a->hits.at = k->rooms[0].crossings;
    a->hits.grow = crossings_grow;
    a->hits.want = POV_WANT_ALL;
}

static void name(asking *a, uint32_t owner)
{
    uint32_t i;

    if (!a->from)
        return;
    a->ray.left = POV_NOBODY;
    for (i = 0; i < a->from->count; i++)
        if (a->from->at[i].object == owner) {
            a->ray.left = owner;
            a->ray.left_mark = a->from->at[i].crossing.mark;
        }
}

static void ask(asking *a, const run *r, uint32_t lane, pov_hits *hits)
{
    const uint32_t before = hits->decided;

    hits->owner = r->object[lane];
    name(a, hits->owner);
    run_intersect(r, lane, &a->ray, hits);
    walker_count(a->walker, r, 1, hits->decided - before);
}

static bool meet(bvh_walk *walk, const void *leaf)
{
    asking *a = (asking *)(void *)walk;
    const run *r;
    uint32_t lane;

    for (r = leaf; r; r = run_next(r))
        for (lane = 0; lane < r->count; lane++) {
            const bool blocks = a->any_blocks || (r->opaque >> lane & 1);

            if (a->light && !(r->casts >> lane & 1))
                continue;
            ask(a, r, lane, a->light && !blocks ? &a->tints : &a->hits);
            if (a->light && a->hits.count > 0)
                return true;
            if (a->hits.want == POV_WANT_NEAREST && a->hits.tmax < a->walk.limit)
                a->walk.limit = a->hits.tmax;
        }
    return false;
}

/* Adds to the walker's count what was decided. True: the light is blocked. */
static bool go(asking *a, const world *w, walker *k)
{
    bool ended;

    a->walk.leaf = meet;
    ended = (w->infinite && meet(&a->walk, w->infinite)) || (w->list && meet(&a->walk, w->list)) ||
            (w->has_tree && (a->light ? w->walks->any_order(&a->walk) : w->walks->nearest_first(&a->walk)));
    k->decided += a->hits.decided + a->tints.decided;
    return ended;
}

bool world_nearest_from(const world *w, walker *k, const spot *from, const pov_ray *ray, double tmax, hit *out)
{
    asking a;

    begin(&a, w, k, from, ray, tmax);
    a.hits.want = POV_WANT_NEAREST;
    a.hits.capacity = 1;
    a.hits.at = &out->crossing;
    go(&a, w, k);
    out->object = a.hits.count ? out->crossing.owner : POV_NOBODY;
    out->company = 0;
    if (a.hits.crowded)
        spot_choose(w, k, ray, from, out);
    return a.hits.count > 0;
}

/* ---- which surfaces share a place ---- */

static bool is_solid(const world *w, uint32_t which)
{
    return (w->model->leaves.items[which].shape->flags & POV_SHAPE_SOLID) != 0;
}

static bool is_crossed(const spot *s, uint32_t which, double rise)
{
    return s->above >> which & 1 ? rise < 0.0 : rise > 0.0;
}

uint32_t spot_crossed(const spot *s, pov_vec3 dir)
{
    uint32_t i, left = s->count;

    for (i = 0; i < s->count; i++) {
        const double rise = pov_dot(s->at[i].normal, dir);

        if (!is_crossed(s, i, rise))
            continue;
        if (!(rise > 0.0 && (s->solid >> i & 1)))
            return i;
        left = left == s->count ? i : left;
    }
    return left;
}

/* The lengths that take part in a crossing. */
static double size_of(const world *w, const pov_ray *ray, double t)
{
    double size = fabs(t) * pov_largest(ray->dir) + pov_largest(ray->org);

    if (w->has_bounds)
        size += fmax(pov_largest(w->bounds.lo), pov_largest(w->bounds.hi));
    return size;
}

/* The surface of a crossing. */
static void look(const world *w, const pov_ray *ray, const pov_crossing *at, hit *h)
{
    h->crossing = *at;
    h->object = at->owner;
    world_surface(w, ray, h);
}

static bool shares_place(const pov_ray *ray, const hit *first, const hit *h, double size)
{
    const double apart = (h->crossing.t - first->crossing.t) + (h->crossing.t_lo - first->crossing.t_lo);
    const double a = fabs(pov_dot(first->normal, ray->dir)), b = fabs(pov_dot(h->normal, ray->dir));

    return !(apart * a * b > same_place * size * (a + b));
}

/* A further one, kept in the order of objects. Of an object that is crossed twice here, at an edge, the way in counts. */
static void insert(spot *s, const hit *h)
{
    uint32_t at = s->count;

    for (uint32_t i = 0; i < s->count; i++)
        if (s->at[i].object == h->object) {
            if (h->entering && !s->at[i].entering)
                s->at[i] = *h;
            return;
        }
    if (s->count == SPOT_MAX)
        return;
    for (; at > 0 && s->at[at - 1].object > h->object; at--)
        s->at[at] = s->at[at - 1];
    s->at[at] = *h;
    s->count++;
}

void world_spot(const world *w, walker *k, const pov_ray *ray, const spot *from, const hit *h, spot *out)
{
    const double t = h->crossing.t, size = size_of(w, ray, t);
    hit first, next;
    asking a;
    uint32_t i;

    begin(&a, w, k, from, ray, t + around * fabs(t));
    a.hits.tmin = t - around * fabs(t);
    go(&a, w, k);
    out->count = out->above = out->solid = 0;
    if (k->failed || a.hits.count == 0)
        return;
    crossings_sort(a.hits.at, a.hits.count);
    look(w, ray, &a.hits.at[0], &first);
    insert(out, &first);
    for (i = 1; i < a.hits.count; i++) {
        look(w, ray, &a.hits.at[i], &next);
        if (!shares_place(ray, &first, &next, size))
            continue;
        next.point = first.point;
        next.point_lo = first.point_lo;
        insert(out, &next);
    }
    for (i = 0; i < out->count; i++) {
        out->at[i].company = (uint16_t)(out->count > 1 ? out->count : 0);
        out->above |= (uint32_t)out->at[i].entering << i;
        out->solid |= (uint32_t)is_solid(w, out->at[i].object) << i;
    }
}

void spot_choose(const world *w, walker *k, const pov_ray *ray, const spot *from, hit *out)
{
    spot s;
    uint32_t which;

    world_spot(w, k, ray, from, out, &s);
    if (s.count == 0)
        return;
    which = spot_crossed(&s, ray->dir);
    *out = s.at[which < s.count ? which : 0];
}

/* ---- light ---- */

/* What is crossed at once. False: nothing is left of the light. */
static bool leave_spot(const world *w, const spot *from, pov_vec3 dir, colour *through)
{
    const model *m = w->model;

    for (uint32_t i = 0; i < from->count; i++) {
        const leaf_node *o = &m->leaves.items[from->at[i].object];
        const material *surface = &m->materials.items[o->material];

        if ((o->flags & LEAF_NO_SHADOW) || !is_crossed(from, i, pov_dot(from->at[i].normal, dir)))
            continue;
        if (!material_is_transparent(surface))
            return false;
        *through = colour_mul(*through, material_filter(surface));
    }
    return !colour_is_black(*through);
}

bool world_light_path_from(const world *w, walker *k, const spot *from, const pov_ray *ray, double tmax,
                           colour *through)
{
    pov_crossing at;
    asking a;
    bool open;

    *through = colour_of(1.0f, 1.0f, 1.0f);
    begin(&a, w, k, from, ray, tmax);
    a.tints = a.hits;
    a.light = true;
    a.any_blocks = !w->plan.coloured_shadows;
    a.hits.want = POV_WANT_ANY;
    a.hits.capacity = 1;
    a.hits.at = &at;
    open = leave_spot(w, from, ray->dir, through) && !go(&a, w, k) &&
           (a.tints.count == 0 || crossings_multiply(w, a.tints.at, a.tints.count, through));
    if (!open)
        *through = colour_of(0.0f, 0.0f, 0.0f);
    return open;
}
