/* The rays of placed shapes with x, y and z side by side. The fourth lane holds what lies behind them, and counts for
 * nothing. Operations and their order are placement.c's. */
#include "world/placement_parts.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(POV_PORTABLE)

#include <immintrin.h>

#define TARGET __attribute__((target("avx2,fma")))

typedef struct two4 { __m256d hi, lo; } two4;

TARGET static inline __m256d load(const pov_vec3 *v)
{
    return _mm256_loadu_pd(&v->x);
}

TARGET static inline void store(pov_vec3 *out, __m256d v)
{
    _mm_storeu_pd(&out->x, _mm256_castpd256_pd128(v));
    _mm_store_sd(&out->z, _mm256_extractf128_pd(v, 1));
}

TARGET static inline __m256d size_of(__m256d v)
{
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), v);
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

TARGET static void own_ray(const placement *p, const pov_ray *ray, pov_ray *own)
{
    const two4 w = start_of(p, ray), anchor = { load(&p->own_anchor), load(&p->own_anchor_lo) };
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

/* ---- the filter ---- */

TARGET static inline __m256d linear(__m256d x, __m256d y, __m256d z, __m256d v)
{
    __m256d s = _mm256_add_pd(_mm256_mul_pd(x, SPREAD(v, 0)), _mm256_mul_pd(y, SPREAD(v, 1)));

    return _mm256_add_pd(s, _mm256_mul_pd(z, SPREAD(v, 2)));
}

/* What comes second counts where the other is no number. */
TARGET static inline double greatest(__m256d v, double least)
{
    __m128d a = _mm256_castpd256_pd128(v), b = _mm256_extractf128_pd(v, 1), r = _mm_max_sd(a, _mm_set_sd(least));

    return _mm_cvtsd_f64(_mm_max_sd(b, _mm_max_sd(_mm_unpackhi_pd(a, a), r)));
}

TARGET static inline double smallest(__m256d v, double most)
{
    __m128d a = _mm256_castpd256_pd128(v), b = _mm256_extractf128_pd(v, 1), r = _mm_min_sd(a, _mm_set_sd(most));

    return _mm_cvtsd_f64(_mm_min_sd(b, _mm_min_sd(_mm_unpackhi_pd(a, a), r)));
}

TARGET static bool misses(const placement *p, const pov_ray *ray, double tmin, double tmax)
{
    const __m256d x = load(&p->column[0]), y = load(&p->column[1]), z = load(&p->column[2]), d = load(&ray->dir);
    const __m256d g = _mm256_sub_pd(load(&ray->org), load(&p->anchor)), low = load(&ray->org_lo);
    const __m256d at = linear(x, y, z, _mm256_add_pd(g, low)), size = _mm256_add_pd(size_of(g), size_of(low));
    const __m256d per = _mm256_div_pd(_mm256_set1_pd(1.0), linear(x, y, z, d));
    const __m256d lost = linear(size_of(x), size_of(y), size_of(z), size);
    const __m256d half = _mm256_add_pd(_mm256_cvtps_pd(_mm_loadu_ps(p->half)),
                                       _mm256_mul_pd(_mm256_set1_pd(PLACEMENT_LOST), lost));
    const __m256d a = _mm256_mul_pd(_mm256_sub_pd(_mm256_sub_pd(_mm256_setzero_pd(), half), at), per);
    const __m256d b = _mm256_mul_pd(_mm256_sub_pd(half, at), per);
    const double in = greatest(_mm256_min_pd(a, b), tmin - fabs(tmin) * PLACEMENT_LATE);
    const double out = smallest(_mm256_max_pd(a, b), tmax + fabs(tmax) * PLACEMENT_LATE);
    pov_vec3 sizes;

    store(&sizes, size);
    return in > out && placement_filters(p, sizes, ray->dir);
}

const placement_code placement_avx2 = { own_ray, misses };

#endif
