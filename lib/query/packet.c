#include "query/packet.h"

#include <string.h>

/* Lanes are processed in groups of eight; a packet too small for packet traversal, in groups of four. */
static inline uint32_t width(uint32_t n) { return n <= 4 ? 4 : (n + 7) & ~7u; }

/* True: all are in the range that filters are promised. False: that has to be looked at. */
SIMD_CLONES static bool derive(pov_rays *restrict s, uint32_t n, double end, double *restrict length)
{
    int64_t all = -1;

    for (uint32_t i = 0; i < n; i++)
        all &= ray_soa_derive(s, i, end, length);
    return all != 0;
}

SIMD_CLONES static bool are_promised(const pov_rays *restrict s, uint32_t n)
{
    int64_t all = -1;

    for (uint32_t i = 0; i < n; i++)
        all &= ray_soa_is_promised(s, i);
    return all != 0;
}

/* Lanes outside that range. */
static uint64_t derive_all(bvh_traversal *t, double end)
{
    uint64_t odd = 0;

    if (!derive(&t->soa, width(t->count), end, t->length) && !are_promised(&t->soa, width(t->count)))
        for (uint32_t i = 0; i < t->count; i++)
            odd |= ray_soa_is_promised(&t->soa, i) ? 0 : bit_of(i);
    return odd;
}

static void take_rays(packet *p, const pov_ray *const *rays, uint64_t which)
{
    bvh_traversal *t = &p->traversal;
    uint32_t n = 0, i;

    if ((which & (which + 1)) == 0) {
        n = ~which ? first_of64(~which) : WORLD_MANY;
        memcpy(p->rays, rays, n * sizeof *rays);
        for (i = 0; i < n; i++)
            p->of[i] = (uint8_t)i;
        which = 0;
    }
    for (; which; which &= which - 1, n++) {
        i = first_of64(which);
        p->rays[n] = rays[i];
        p->of[n] = (uint8_t)i;
    }
    for (i = n; i < width(n); i++)
        p->rays[i] = p->rays[n - 1];
    for (i = 0; i < width(n); i += 4)
        ray_soa_put_four(&t->soa, i, p->rays + i);
    for (i = 0; i < width(n); i++)
        t->limit[i] = p->tmax;
    t->count = n;
    t->lanes = all_of(n);
}

void packet_begin(packet *p, const world *w, query_context *k, const pov_ray *const *rays, uint64_t which, double tmax,
                  double end)
{
    p->traversal.tree = &w->tree;
    p->traversal.rays = p->traversal.soa.rays = p->rays;
    p->traversal.in = NULL;
    p->traversal.lowered = 0;
    p->world = w;
    p->context = k;
    p->tmax = tmax;
    p->slack = 0.0;
    p->asked = p->deferred_lanes = 0;
    p->from = k->csg.from = NULL;
    k->csg.light = false;
    p->candidates_only = false;
    take_rays(p, rays, which);
    p->exact = derive_all(&p->traversal, end);
}

uint64_t packet_traverse(packet *p, bvh_traverse_fn *traverse, bool nearest)
{
    const world *w = p->world;
    bvh_traversal *t = &p->traversal;
    const uint64_t all = t->lanes;
    uint64_t ended = 0;

    if (w->infinite)
        ended = t->leaf(t, w->infinite, all);
    if (w->list && all & ~ended)
        ended |= t->leaf(t, w->list, all & ~ended);
    t->lowered = 0;
    t->lanes = all & ~ended & ~p->exact;
    if (w->has_tree && t->lanes)
        ended |= traverse(t);
    t->lanes = all & ~ended & p->exact;
    if (w->has_tree && t->lanes)
        ended |= (nearest ? w->kernels->nearest_single : w->kernels->any_single)(t);
    t->lanes = all;
    return ended;
}

/* ---- grouping rays into packets ---- */

/* Smaller groups of one octant are faster as single rays, and still smaller groups of any octants one after the
 * other. Shadow rays mostly go to one place: fewer of them are worth a packet. */
enum { PACKET_LEAST = 8, SHADOWS_LEAST = 5, INTERLEAVED_LEAST = 5 };

/* Rays of one octant form a packet for a tree; a list takes all. Most packets are of one octant. */
static void divide(const world *w, const pov_ray *const *rays, uint32_t n, uint64_t of[8])
{
    const uint32_t common = w->has_tree ? bvh_common_octant(rays, n) : 0;
    uint32_t i;

    for (i = 0; i < 8; i++)
        of[i] = 0;
    if (common < 8)
        of[common] = all_of(n);
    else
        for (i = 0; i < n; i++)
            of[bvh_octant(rays[i])] |= bit_of(i);
}

/* Are there at least so many lanes? */
static inline bool are_at_least(uint64_t lanes, uint32_t least)
{
#if defined(__POPCNT__)
    return (uint32_t)__builtin_popcountll(lanes) >= least;
#else
    uint32_t n;

    for (n = 1; n < least; n++)
        lanes &= lanes - 1;
    return lanes != 0;
#endif
}

uint32_t packet_divide(const world *w, const pov_ray *const *rays, uint32_t n, uint64_t which, bool nearest,
                       packet_group groups[PACKET_GROUPS])
{
    const bvh_kernels *by = w->kernels;
    const uint32_t least = nearest ? PACKET_LEAST : SHADOWS_LEAST;
    bvh_traverse_fn *const interleaved = nearest ? by->nearest_interleaved : by->any_interleaved;
    uint64_t of[8], rest = 0;
    uint32_t count = 0, octant;

    if (n < least)
        rest = which;
    else
        divide(w, rays, n, of);
    for (octant = 0; n >= least && octant < 8; octant++)
        if (are_at_least(of[octant] & which, least)) {
            groups[count].lanes = of[octant] & which;
            groups[count++].traverse = nearest ? by->nearest_packet : by->any_packet;
        } else {
            rest |= of[octant] & which;
        }
    if (!rest)
        return count;
    groups[count].lanes = rest;
    groups[count].traverse = nearest ? by->nearest_single : by->any_single;
    if (interleaved && w->has_tree && w->tree.frame_count == 1 && are_at_least(rest, INTERLEAVED_LEAST))
        groups[count].traverse = interleaved;
    return count + 1;
}

/* ---- shapes and rays that are asked side by side ---- */

void pairs_ask(query_context *k, const shape_class *shape, uint32_t class_number, pairs *some, bool crossed)
{
    uint32_t escalated = 0, i;

    for (i = 0; i < some->count; i++)
        escalated -= some->hits[i]->escalated;
    if (crossed && shape->cross_many != NULL)
        shape->cross_many(some->selves, some->rays, some->hits, some->count);
    else if (shape->intersect_many != NULL)
        shape->intersect_many(some->selves, some->rays, some->hits, some->count);
    else
        for (i = 0; i < some->count; i++)
            shape->intersect(some->selves[i], some->rays[i], some->hits[i]);
    for (i = 0; i < some->count; i++)
        escalated += some->hits[i]->escalated;
    query_context_count_class(k, class_number, some->count, escalated);
}
