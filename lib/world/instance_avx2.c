/* The rays of placed shapes with x, y and z side by side. The fourth lane holds what lies behind them, and counts for
 * nothing. Operations and their order are instance.c's. */
#include "world/instance.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(POV_PORTABLE)

#include <immintrin.h>

#define TARGET __attribute__((target("avx2,fma")))

typedef struct two4 { __m256d hi, lo; } two4;

TARGET static inline __m256d load(const pov_vec3 *v)
{
    return _mm256_loadu_pd(&v->x);
}

/* Of one that nothing stands behind. */
TARGET static inline __m256d load_last(const pov_vec3 *v)
{
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(&v->x)), _mm_load_sd(&v->z), 1);
}

TARGET static inline void store(pov_vec3 *out, __m256d v)
{
    _mm_storeu_pd(&out->x, _mm256_castpd256_pd128(v));
    _mm_store_sd(&out->z, _mm256_extractf128_pd(v, 1));
}

/* ---- two parts: exact.h has the names and the bounds ---- */

TARGET static inline two4 fast_sum(__m256d a, __m256d b)
{
    two4 r = { _mm256_add_pd(a, b), b };

    r.lo = _mm256_sub_pd(b, _mm256_sub_pd(r.hi, a));
    return r;
}

TARGET static inline two4 sum(__m256d a, __m256d b)
{
    __m256d s = _mm256_add_pd(a, b), bb = _mm256_sub_pd(s, a);
    two4 r = { s, _mm256_add_pd(_mm256_sub_pd(a, _mm256_sub_pd(s, bb)), _mm256_sub_pd(b, bb)) };

    return r;
}

TARGET static inline two4 add(two4 a, two4 b)
{
    two4 s = sum(a.hi, b.hi), t = sum(a.lo, b.lo);

    s = fast_sum(s.hi, _mm256_add_pd(s.lo, t.hi));
    return fast_sum(s.hi, _mm256_add_pd(s.lo, t.lo));
}

TARGET static inline two4 times(two4 a, two4 b)
{
    __m256d p = _mm256_mul_pd(a.hi, b.hi), e = _mm256_fmsub_pd(a.hi, b.hi, p);

    return fast_sum(p, _mm256_add_pd(e, _mm256_add_pd(_mm256_mul_pd(a.hi, b.lo), _mm256_mul_pd(a.lo, b.hi))));
}

TARGET static inline two4 times_double(two4 a, __m256d b)
{
    __m256d p = _mm256_mul_pd(a.hi, b), e = _mm256_fmsub_pd(a.hi, b, p);

    return fast_sum(p, _mm256_add_pd(e, _mm256_mul_pd(a.lo, b)));
}

/* ---- the own ray ---- */

TARGET static inline two4 column(const placement *p, int j)
{
    two4 r = { load(&p->column[j]), load(&p->column_lo[j]) };

    return r;
}

TARGET static inline two4 diagonal(const placement *p)
{
    two4 x = column(p, 0), y = column(p, 1), z = column(p, 2), r;

    r.hi = _mm256_blend_pd(_mm256_blend_pd(x.hi, y.hi, 2), z.hi, 4);
    r.lo = _mm256_blend_pd(_mm256_blend_pd(x.lo, y.lo, 2), z.lo, 4);
    return r;
}

/* Component j in all lanes. */
#define SPREAD(v, j) _mm256_permute4x64_pd(v, (j) * 0x55)

TARGET static inline two4 spread(two4 v, int j)
{
    two4 r;

    r.hi = j == 0 ? SPREAD(v.hi, 0) : j == 1 ? SPREAD(v.hi, 1) : SPREAD(v.hi, 2);
    r.lo = j == 0 ? SPREAD(v.lo, 0) : j == 1 ? SPREAD(v.lo, 1) : SPREAD(v.lo, 2);
    return r;
}

/* From the anchor to the start of the ray. */
TARGET static inline two4 start_of(const placement *p, const pov_ray *ray)
{
    two4 s = sum(load(&ray->org), _mm256_xor_pd(_mm256_set1_pd(-0.0), load(&p->anchor)));
    two4 t = sum(s.hi, load(&ray->org_lo));

    return fast_sum(t.hi, _mm256_add_pd(s.lo, t.lo));
}

TARGET void placement_ray_avx2(const placement *p, const pov_ray *ray, pov_ray *own)
{
    const two4 w = start_of(p, ray), anchor = { load(&p->own_anchor), load_last(&p->own_anchor_lo) };
    two4 o, d;

    if (p->axes) {
        const two4 factors = diagonal(p);
        o = times(factors, w);
        d = times_double(factors, load(&ray->dir));
    } else {
        const two4 x = column(p, 0), y = column(p, 1), z = column(p, 2);
        o = add(add(times(x, spread(w, 0)), times(y, spread(w, 1))), times(z, spread(w, 2)));
        d = add(times_double(x, _mm256_set1_pd(ray->dir.x)), times_double(y, _mm256_set1_pd(ray->dir.y)));
        d = add(d, times_double(z, _mm256_set1_pd(ray->dir.z)));
    }
    o = add(o, anchor);
    store(&own->org, o.hi);
    store(&own->org_lo, o.lo);
    store(&own->dir, d.hi);
    store(&own->dir_lo, d.lo);
    own->left = ray->left;
    own->left_mark = ray->left_mark;
}

#endif
