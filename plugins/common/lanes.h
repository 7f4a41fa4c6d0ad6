/* lanes.h - several pairs of a ray and a shape side by side. The arithmetic for one pair is inlined into a plain loop
 * over lanes that the compiler turns into vector code: so the bits are the same. A lane that is not certain is left to
 * the function for one pair. */
#ifndef COMMON_LANES_H
#define COMMON_LANES_H

#include "common/simd.h"

/* Unused lanes cost as much as others: fewer pairs than this minimum are cheaper one by one. */
enum { COMMON_LANES = 8, COMMON_LEAST = 3 };

typedef double common_lane[COMMON_LANES];
typedef struct common_lane3 { common_lane x, y, z; } common_lane3;
typedef struct common_rays { common_lane3 org, org_lo, dir, dir_lo; } common_rays;

static inline void common_put(common_lane3 *l, uint32_t i, pov_vec3 v)
{
    l->x[i] = v.x;
    l->y[i] = v.y;
    l->z[i] = v.z;
}

static inline pov_vec3 common_get(const common_lane3 *l, uint32_t i) { return pov_vec3_of(l->x[i], l->y[i], l->z[i]); }

/* Index of the pair in a lane: lanes past the end hold the last pair again. */
static inline uint32_t common_lane_of(uint32_t i, uint32_t n) { return i < n ? i : n - 1; }

static inline void common_put_ray(common_rays *l, uint32_t i, const pov_ray *ray)
{
    common_put(&l->org, i, ray->org);
    common_put(&l->org_lo, i, ray->org_lo);
    common_put(&l->dir, i, ray->dir);
    common_put(&l->dir_lo, i, ray->dir_lo);
}

/* Four structures at once. Numbers stored one by one would stall the vector loads that follow. */
#if defined(__AVX__) && defined(__GNUC__)
#define COMMON_TRANSPOSES 1
#include <immintrin.h>

typedef __m256d common_four;

/* Two doubles of each of two structures: the load inserts the upper half at no cost. */
static inline common_four common_load_pairs(const void *low, const void *high, size_t offset)
{
    const double *const l = (const double *)(const void *)((const char *)low + offset);
    const double *const h = (const double *)(const void *)((const char *)high + offset);

    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(l)), _mm_loadu_pd(h), 1);
}

/* Transpose four doubles at an offset of each structure. */
COMMON_INLINE void common_transpose(const void *const from[4], size_t offset, common_four to[4])
{
    const size_t behind = offset + 2 * sizeof(double);
    const common_four ac = common_load_pairs(from[0], from[2], offset),
        bd = common_load_pairs(from[1], from[3], offset);
    const common_four more_ac = common_load_pairs(from[0], from[2], behind);
    const common_four more_bd = common_load_pairs(from[1], from[3], behind);

    to[0] = _mm256_unpacklo_pd(ac, bd);
    to[1] = _mm256_unpackhi_pd(ac, bd);
    to[2] = _mm256_unpacklo_pd(more_ac, more_bd);
    to[3] = _mm256_unpackhi_pd(more_ac, more_bd);
}

static inline void common_store_four(double *lane, uint32_t i, common_four v) { _mm256_storeu_pd(lane + i, v); }
#endif

/* Load rays into four lanes from i on. */
COMMON_INLINE void common_put_four_rays(common_rays *l, uint32_t i, const pov_ray *const rays[4])
{
    uint32_t j;
#ifdef COMMON_TRANSPOSES
    const void *const from[4] = { rays[0], rays[1], rays[2], rays[3] };
    common_four v[4];

    common_transpose(from, offsetof(pov_ray, org), v);
    common_store_four(l->org.x, i, v[0]);
    common_store_four(l->org.y, i, v[1]);
    common_store_four(l->org.z, i, v[2]);
    common_store_four(l->org_lo.x, i, v[3]);
    common_transpose(from, offsetof(pov_ray, org_lo) + sizeof(double), v);
    common_store_four(l->org_lo.y, i, v[0]);
    common_store_four(l->org_lo.z, i, v[1]);
    common_store_four(l->dir.x, i, v[2]);
    common_store_four(l->dir.y, i, v[3]);
    common_transpose(from, offsetof(pov_ray, dir_lo) - sizeof(double), v);
    common_store_four(l->dir_lo.x, i, v[1]);
    common_store_four(l->dir_lo.y, i, v[2]);
    common_store_four(l->dir_lo.z, i, v[3]);
    for (j = 0; j < 4; j++)
        l->dir.z[i + j] = rays[j]->dir.z;
#else
    for (j = 0; j < 4; j++)
        common_put_ray(l, i + j, rays[j]);
#endif
}

/* Load the rays of n pairs into four lanes from i on. */
COMMON_INLINE void common_put_four_of(common_rays *l, uint32_t i, const pov_ray *const *rays, uint32_t n)
{
    const pov_ray *const some[4] = { rays[common_lane_of(i, n)], rays[common_lane_of(i + 1, n)],
                                     rays[common_lane_of(i + 2, n)], rays[common_lane_of(i + 3, n)] };

    common_put_four_rays(l, i, some);
}

/* Load the first n doubles of four shapes, n being a multiple of four: the k-th double of shape j is stored at position
 * j of row k, and rows have `width` elements. */
COMMON_INLINE void common_put_four_shapes(double *rows, size_t width, uint32_t n, const void *const shapes[4])
{
    uint32_t k, j;
#ifdef COMMON_TRANSPOSES
    common_four v[4];

    for (k = 0; k < n; k += 4) {
        common_transpose(shapes, k * sizeof(double), v);
        for (j = 0; j < 4; j++)
            common_store_four(rows + (k + j) * width, 0, v[j]);
    }
#else
    for (j = 0; j < 4; j++)
        for (k = 0; k < n; k++)
            memcpy(&rows[k * width + j], (const char *)shapes[j] + k * sizeof(double), sizeof(double));
#endif
}

/* Take up to COMMON_LANES pairs of the first one's shape out of `left`, at least one. */
static inline uint32_t common_take_same(const void *const *selves, uint64_t *left, uint8_t *which)
{
    const void *first = selves[common_first_lane64(*left)];
    uint64_t rest;
    uint32_t n = 0;

    for (rest = *left; rest && n < COMMON_LANES; rest &= rest - 1) {
        const uint32_t i = common_first_lane64(rest);

        if (selves[i] != first)
            continue;
        which[n++] = (uint8_t)i;
        *left &= ~((uint64_t)1 << i);
    }
    return n;
}

/* Load the distances of crossings into four lanes from i on. */
COMMON_INLINE void common_put_four_crossings(double *t, double *t_lo, uint32_t i, const pov_crossing *const at[4])
{
#ifdef COMMON_TRANSPOSES
    const void *const from[4] = { at[0], at[1], at[2], at[3] };
    common_four v[4];

    common_transpose(from, offsetof(pov_crossing, t), v);
    common_store_four(t, i, v[0]);
    common_store_four(t_lo, i, v[1]);
#else
    for (uint32_t j = 0; j < 4; j++) {
        t[i + j] = at[j]->t;
        t_lo[i + j] = at[j]->t_lo;
    }
#endif
}

/* Rays and their crossings into all lanes; the last pair fills those behind it. */
COMMON_INLINE void common_put_crossings_of(common_rays *l, double *t, double *t_lo, const pov_ray *const *rays,
                                           const pov_crossing *const *at, uint32_t n)
{
    for (uint32_t i = 0; i < COMMON_LANES; i += 4) {
        const pov_crossing *const some[4] = { at[common_lane_of(i, n)], at[common_lane_of(i + 1, n)], at[common_lane_of(i + 2, n)],
                                              at[common_lane_of(i + 3, n)] };

        common_put_four_of(l, i, rays, n);
        common_put_four_crossings(t, t_lo, i, some);
    }
}

#ifdef COMMON_TRANSPOSES
/* Store a double of each of four rows into four structures, the first four rows and so on. */
static inline void common_put_rows(const double *const rows[4], uint32_t first, double *const to[4])
{
    const void *const from[4] = { rows[0] + first, rows[1] + first, rows[2] + first, rows[3] + first };
    common_four v[4];

    common_transpose(from, 0, v);
    for (uint32_t j = 0; j < 4; j++)
        _mm256_storeu_pd(to[j], v[j]);
}
#endif

/* Points and normals by lane. */
typedef struct common_contact_lanes { common_lane3 point, point_lo, normal; } common_contact_lanes;

static inline pov_two common_advance(double o, double o_lo, pov_two t, double d)
{
    return pov_two_add(pov_two_add_double(pov_two_of(o, 0.0), o_lo), pov_two_mul_double(t, d));
}

/* The point of a lane's crossing, as hosts find it. */
COMMON_INLINE void common_put_point(common_contact_lanes *l, uint32_t i, const pov_ray *ray, double t_hi, double t_lo)
{
    const pov_two t = pov_fast_two_sum(t_hi, t_lo);
    const pov_two x = common_advance(ray->org.x, ray->org_lo.x, t, ray->dir.x);
    const pov_two y = common_advance(ray->org.y, ray->org_lo.y, t, ray->dir.y);
    const pov_two z = common_advance(ray->org.z, ray->org_lo.z, t, ray->dir.z);

    common_put(&l->point, i, pov_vec3_of(x.hi, y.hi, z.hi));
    common_put(&l->point_lo, i, pov_vec3_of(x.lo, y.lo, z.lo));
}

/* Write where the crossings of n pairs are. */
COMMON_INLINE void common_get_contacts(const common_contact_lanes *l, pov_contact *const *contacts, uint32_t n)
{
#ifdef COMMON_TRANSPOSES
    const double *const first[4] = { l->point.x, l->point.y, l->point.z, l->point_lo.x };
    const double *const second[4] = { l->point_lo.y, l->point_lo.z, l->normal.x, l->normal.y };

    for (uint32_t i = 0; i < n; i += 4) {
        double *to[4], *behind[4];

        for (uint32_t j = 0; j < 4; j++) {
            to[j] = &contacts[common_lane_of(i + j, n)]->point.x;
            behind[j] = to[j] + 4;
        }
        common_put_rows(first, i, to);
        common_put_rows(second, i, behind);
        for (uint32_t j = 0; j < 4; j++)
            to[j][8] = l->normal.z[i + j];
    }
#else
    for (uint32_t i = 0; i < n; i++) {
        contacts[i]->point = common_get(&l->point, i);
        contacts[i]->point_lo = common_get(&l->point_lo, i);
        contacts[i]->normal = common_get(&l->normal, i);
    }
#endif
}

/* The ray of a lane, without its origin surface. */
static inline pov_ray common_get_ray(const common_rays *l, uint32_t i)
{
    pov_ray ray;

    ray.org = common_get(&l->org, i);
    ray.org_lo = common_get(&l->org_lo, i);
    ray.dir = common_get(&l->dir, i);
    ray.dir_lo = common_get(&l->dir_lo, i);
    return ray;
}

/* intersect_many() of a class: eight pairs at a time as long as that pays, the rest one by one. */
COMMON_INLINE void common_intersect_pairs(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                          uint32_t n,
                                          void (*eight)(const void *const *selves, const pov_ray *const *rays,
                                                        pov_hits *const *hits, uint32_t n),
                                          void (*one)(const void *self, const pov_ray *ray, pov_hits *hits))
{
    uint32_t i;

    for (; n >= COMMON_LEAST; n -= i, selves += i, rays += i, hits += i) {
        i = n < COMMON_LANES ? n : COMMON_LANES;
        eight(selves, rays, hits, i);
    }
    for (i = 0; i < n; i++)
        one(selves[i], rays[i], hits[i]);
}

#endif
