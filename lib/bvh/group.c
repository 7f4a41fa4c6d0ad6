#include "bvh/group.h"

#include "bvh/ray_soa.h"

#include <string.h>

static inline uint64_t bit_of(uint32_t i) { return (uint64_t)1 << i; }
static inline uint64_t all_of(uint32_t n) { return ~(uint64_t)0 >> (BVH_LANES - n); }

/* ---- rays in lanes ---- */

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

/* The lanes of n rays are there; what begins with them. Returns odd lanes. */
static uint64_t set_out(bvh_traversal *t, const pov_ray *const *rays, uint32_t n, double limit, double end)
{
    for (uint32_t i = 0; i < width(n); i++)
        t->limit[i] = limit;
    t->rays = t->soa.rays = rays;
    t->in = NULL;
    t->lowered = 0;
    t->count = n;
    t->lanes = all_of(n);
    return derive_all(t, end);
}

/* Does one of four rays start on a surface? */
static inline bool any_starts(const pov_ray *const rays[4])
{
    return (rays[0]->origin_surface & rays[1]->origin_surface & rays[2]->origin_surface & rays[3]->origin_surface) != POV_NO_OWNER;
}

uint64_t bvh_take(bvh_traversal *t, const pov_ray *taken[BVH_LANES], uint8_t of[BVH_LANES], const pov_ray *const *rays,
                  uint64_t which, double limit, double end)
{
    uint32_t n = 0, i;

    if ((which & (which + 1)) == 0) {
        n = ~which ? first_of64(~which) : BVH_LANES;
        memcpy(taken, rays, n * sizeof *rays);
        for (i = 0; i < n; i++)
            of[i] = (uint8_t)i;
        which = 0;
    }
    for (; which; which &= which - 1, n++) {
        i = first_of64(which);
        taken[n] = rays[i];
        of[n] = (uint8_t)i;
    }
    for (i = n; i < width(n); i++)
        taken[i] = taken[n - 1];
    t->start = false;
    for (i = 0; i < width(n); i += 4) {
        ray_soa_put_four(&t->soa, i, taken + i);
        t->start |= any_starts(taken + i);
    }
    return set_out(t, taken, n, limit, end);
}

/* Smaller groups of one octant are faster as single rays, and still smaller groups of any octants one after the
 * other. Shadow rays mostly go to one place: fewer of them are worth a packet. Where all come to one leaf, two are. */
enum { PACKET_LEAST = 8, SHADOWS_LEAST = 5, INTERLEAVED_LEAST = 5, LEAF_LEAST = 2 };

/* Has it nodes? Only these ask for rays of one octant. */
static inline bool has_nodes(const bvh *tree) { return tree && (tree->frames[0].root & BVH_KIND) != BVH_LEAF; }

/* Copied as a whole, whatever lanes past the end hold. */
enum { LANES_AGREE = 1 / (sizeof(vec_lanes) == sizeof(double[3][BVH_LANES]) && BVH_LANES == POV_RAYS_MAX) };

/* Lanes past the end hold the last ray again. */
static void repeat_last(pov_rays *to, uint32_t n)
{
    for (uint32_t i = n; i < width(n); i++) {
        for (int k = 0; k < 3; k++) {
            to->org[k][i] = to->org[k][n - 1];
            to->org_lo[k][i] = to->org_lo[k][n - 1];
            to->dir[k][i] = to->dir[k][n - 1];
        }
        to->excluded[i] = to->excluded[n - 1];
    }
}

/* Of what some have and of what all have the highest bits are the signs. */
SIMD_CLONES static bool is_one_sign(const double *restrict x, uint32_t n)
{
    int64_t any = 0, all = -1;

    for (uint32_t i = 0; i < n; i++) {
        int64_t bits;

        memcpy(&bits, &x[i], sizeof bits);
        any |= bits;
        all &= bits;
    }
    return (any ^ all) >= 0;
}

/* Bring n numbers of some lanes to the front. Whole vectors are stored, which never reach beyond where they come from. */
static void pick(const bvh_ray_lanes *rays, uint32_t n, const double *from, double *to)
{
#if defined(__AVX512F__) && defined(__GNUC__)
    (void)n;
    for (uint64_t rest = rays->which; rest; rest >>= 8, from += 8) {
        _mm512_storeu_pd(to, _mm512_maskz_compress_pd((__mmask8)rest, _mm512_loadu_pd(from)));
        to += __builtin_popcountll(rest & 0xff);
    }
#else
    for (uint32_t i = 0; i < n; i++)
        to[i] = from[rays->of[i]];
#endif
}

/* The same of the objects that they cannot hit. */
static void copy_excluded(const bvh_ray_lanes *rays, uint32_t n, uint32_t to[BVH_LANES])
{
    const uint32_t *from = rays->excluded;

    if (!rays->of) {
        memcpy(to, from, BVH_LANES * sizeof *from);
        return;
    }
#if defined(__AVX512F__) && defined(__GNUC__)
    (void)n;
    for (uint64_t rest = rays->which; rest; rest >>= 16, from += 16) {
        _mm512_storeu_si512(to, _mm512_maskz_compress_epi32((__mmask16)rest, _mm512_loadu_si512(from)));
        to += __builtin_popcountll(rest & 0xffff);
    }
#else
    for (uint32_t i = 0; i < n; i++)
        to[i] = from[rays->of[i]];
#endif
}

static void copy_axes(const bvh_ray_lanes *rays, uint32_t n, const vec_lanes *from, double to[3][BVH_LANES])
{
    if (!rays->of) {
        memcpy(to, from, sizeof *from);
        return;
    }
    pick(rays, n, from->x, to[0]);
    pick(rays, n, from->y, to[1]);
    pick(rays, n, from->z, to[2]);
}

bool bvh_copy_lanes(bvh_traversal *t, const bvh *tree, const bvh_ray_lanes *rays, uint32_t n)
{
    if (n < (has_nodes(tree) ? SHADOWS_LEAST : LEAF_LEAST))
        return false;
    copy_axes(rays, n, rays->dir, t->soa.dir);
    if (has_nodes(tree) && !(is_one_sign(t->soa.dir[0], n) && is_one_sign(t->soa.dir[1], n) && is_one_sign(t->soa.dir[2], n)))
        return false;
    copy_axes(rays, n, rays->org, t->soa.org);
    copy_axes(rays, n, rays->org_lo, t->soa.org_lo);
    copy_excluded(rays, n, t->soa.excluded);
    repeat_last(&t->soa, n);
    return true;
}

uint64_t bvh_take_copied(bvh_traversal *t, uint32_t n, double limit, double end)
{
    t->start = true;
    return set_out(t, NULL, n, limit, end);
}

/* ---- groups ---- */

/* Rays of one octant form a packet for a tree; a list takes all. Most packets are of one octant. */
static void divide(const bvh *tree, const pov_ray *const *rays, uint32_t n, uint64_t of[8])
{
    const uint32_t common = has_nodes(tree) ? bvh_common_octant(rays, n) : 0;
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

uint32_t bvh_divide(const bvh *tree, const bvh_kernels *by, const pov_ray *const *rays, uint32_t n, uint64_t which,
                    bool nearest, bvh_group groups[BVH_GROUPS])
{
    const uint32_t least = !has_nodes(tree) ? LEAF_LEAST : nearest ? PACKET_LEAST : SHADOWS_LEAST;
    bvh_traverse_fn *const interleaved = nearest ? by->nearest_interleaved : by->any_interleaved;
    uint64_t of[8], rest = 0;
    uint32_t count = 0, octant;

    if (n < least)
        rest = which;
    else
        divide(tree, rays, n, of);
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
    if (interleaved && tree && tree->frame_count == 1 && are_at_least(rest, INTERLEAVED_LEAST))
        groups[count].traverse = interleaved;
    return count + 1;
}
