/* Copies: a ray in the space of a part goes through the part's tree. */
#include "world/copy.h"

#include "bvh/ray_soa.h"
#include "world/internal.h"

/* State of one ray's traversal. */
typedef struct visit {
    bvh_traversal traversal;     /* first: passed to leaves */
    const pov_ray *ray;
    pov_hits *hits;
    csg_scratch *scratch;        /* its names are those of this copy */
    bool filters;                /* the ray's numbers are in the range of filters */
    pov_ray named;               /* the ray where it leaves several surfaces */
    pov_candidate candidates[POV_CANDIDATES_MAX];
} visit;

/* Leaves the surface of this owner only. */
static void name(visit *v, uint32_t owner)
{
    const coincident_set *from = v->scratch->from;

    v->named.origin_surface = POV_NO_OWNER;
    for (uint32_t i = 0; i < from->count; i++)
        if (from->at[i].object == owner) {
            v->named.origin_surface = owner;
            v->named.origin_mark = from->at[i].crossing.mark;
        }
}

/* Shapes of a batch that the ray may hit. */
static uint32_t possible_of(visit *v, const leaf_batch *r)
{
    uint32_t n, found = 0;

    if (!v->filters || !(r->flags & LEAF_PACKED))
        return leaf_batch_lanes(r);
    n = leaf_batch_filter(r, v->traversal.in, &v->traversal.soa, 1, v->candidates);
    for (uint32_t k = 0; k < n; k++)
        found |= 1u << v->candidates[k].lane;
    return found;
}

static inline double just_beyond(double limit) { return limit + limit * 0x1p-44 + 0x1p-1074; }

/* Does nothing more count? Of light that ends at an opaque surface no other crossing does. */
static inline bool is_over(const visit *v, const leaf_batch *r, uint32_t lane, uint32_t before)
{
    return v->hits->count > before &&
           (v->hits->want == POV_WANT_ANY || (v->scratch->light && (r->opaque >> lane & 1)));
}

static uint64_t visit_leaf(bvh_traversal *traversal, const void *leaf, uint64_t lanes)
{
    visit *v = (visit *)(void *)traversal;

    for (const leaf_batch *r = leaf; r; r = leaf_batch_next(r))
        for (uint32_t mask = possible_of(v, r); mask; mask &= mask - 1) {
            const uint32_t lane = first_of(mask), before = v->hits->count;

            v->hits->owner = v->scratch->names + r->object[lane];
            if (v->scratch->from)
                name(v, v->hits->owner);
            leaf_batch_intersect(r, lane, v->ray, v->hits);
            if (is_over(v, r, lane, before))
                return lanes;
        }
    if (v->hits->tmax < traversal->limit[0]) {
        traversal->limit[0] = v->hits->tmax;
        traversal->soa.tmax[0] = just_beyond(v->hits->tmax);
        traversal->lowered = 1;
    }
    return 0;
}

static void begin(visit *v, const world *w, const pov_ray *const *ray, pov_hits *hits)
{
    const pov_ray *const four[4] = { *ray, *ray, *ray, *ray };
    bvh_traversal *t = &v->traversal;

    v->ray = *ray;
    v->hits = hits;
    t->tree = &w->tree;
    t->rays = ray;
    t->count = 1;
    t->lanes = 1;
    t->in = NULL;
    t->limit[0] = hits->tmax;
    t->lowered = 0;
    t->leaf = visit_leaf;
    ray_soa_put_four(&t->soa, 0, four);
    t->soa.excluded[0] = POV_NO_OWNER;
    t->soa.rays = NULL;
    v->filters = true;
    for (uint32_t i = 0; i < 4; i++)
        v->filters &= ray_soa_derive(&t->soa, i, just_beyond(hits->tmax), t->length) || ray_soa_is_promised(&t->soa, i);
}

/* The lists first, as in other queries. */
static void traverse(visit *v, const world *w)
{
    bvh_traversal *t = &v->traversal;
    const bool any = v->hits->want == POV_WANT_ANY;

    if (w->infinite && visit_leaf(t, w->infinite, 1))
        return;
    if (w->list && visit_leaf(t, w->list, 1))
        return;
    t->lowered = 0;
    if (w->has_tree)
        (any ? w->kernels->any_single : w->kernels->nearest_single)(t);
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const copy_root *c = self;
    csg_scratch *s = ((const csg_user *)hits->user)->scratch;
    const uint32_t owner = hits->owner;
    visit v;

    if (s->from) {
        v.named = *ray;
        ray = &v.named;
    }
    v.scratch = s;
    begin(&v, c->of, &ray, hits);
    s->names += c->name;
    traverse(&v, c->of);
    s->names -= c->name;
    hits->owner = owner;
}

static bool bounds(const void *self, pov_box *out)
{
    const world *w = ((const copy_root *)self)->of;

    return w->infinite_count == 0 && world_bounds(w, out);
}

const shape_class copy_class = {
    .keyword = "copy",
    .instance_size = sizeof(copy_root),
    .bounds = bounds,
    .intersect = intersect,
};
