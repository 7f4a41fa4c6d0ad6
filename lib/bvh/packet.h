/* packet.h - many rays through a tree at once.
 *
 * Rays that start and go alike meet nearly the same boxes. So all of them together are tested against the eight
 * children of a node first: over the intervals that their 1/d and o lie in, a plane at b is met no earlier than
 * the least of (b - o) r at both ends r of the first, with o the end of the second that makes it least. What
 * floats lose there is at most 4 + 5 |o| in the units of traverse.h: twice |b - o| for r, |b| for the product, |o|
 * twice for o and the offset, |b| + |o| for the difference; twice the single ray's slack covers it. Of the boxes that
 * remain each is tested against eight rays at once, with the single ray's formula. With the other end of o, and the
 * least of all limits, the same products say which boxes all rays surely meet, and these are not tested again; were that
 * said of a ray that does not, it would be asked about a box too many. What the group's test says for the order of boxes
 * is a hint; what a ray meets does not depend on it. */
#ifndef BVH_PACKET_H
#define BVH_PACKET_H

#include "bvh/traverse.h"

/* Directions of one company have the same signs. */
static inline uint32_t bvh_octant(const pov_ray *ray)
{
#if defined(__AVX__) && defined(__GNUC__)
    /* Behind the direction stand eight bytes more of the ray. */
    typedef double doubles __attribute__((vector_size(32)));
    doubles d;

    memcpy(&d, (const char *)ray + offsetof(pov_ray, dir), sizeof d);
    return (uint32_t)__builtin_ia32_movmskpd256(d) & 7;
#else
    return (signbit(ray->dir.x) ? 1u : 0u) | (signbit(ray->dir.y) ? 2u : 0u) | (signbit(ray->dir.z) ? 4u : 0u);
#endif
}

/* As bvh_walks. */
uint64_t bvh_company_nearest_portable(bvh_party *party);
uint64_t bvh_company_any_portable(bvh_party *party);
#if defined(__x86_64__) && defined(__GNUC__) && !defined(POV_PORTABLE)
uint64_t bvh_company_nearest_avx2(bvh_party *party);
uint64_t bvh_company_any_avx2(bvh_party *party);
uint64_t bvh_turns_nearest(bvh_party *party);   /* AVX-512 */
uint64_t bvh_turns_any(bvh_party *party);
#endif

#endif
