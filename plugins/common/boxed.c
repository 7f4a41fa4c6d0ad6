#include "common/boxed.h"

#include "common/lanes.h"

enum { N = COMMON_ENTRIES, HALF = N / 2, LEAST = 3 };

/* common_clip_axis() without a branch. */
COMMON_INLINE void clip_axis(double *lo, double *hi, double from, double d, double least, double most, double margin)
{
    const double a = (least - margin - from) / d, b = (most + margin - from) / d;
    const double inside = from >= least - margin ? from <= most + margin ? HUGE_VAL : -HUGE_VAL : -HUGE_VAL;
    const double near = d != 0.0 ? a < b ? a : b : -HUGE_VAL, far = d != 0.0 ? a < b ? b : a : inside;

    *lo = near > *lo ? near : *lo;
    *hi = far < *hi ? far : *hi;
}

COMMON_INLINE void enter(const common_rays *restrict l, const common_boxed *restrict b, uint32_t n, common_entries *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const pov_ray ray = common_get_ray(l, i);
        const common_ray k = common_enter(&ray, b->anchor, b->scale);
        const double margin = 0x1p-40 + 0x1p-48 * pov_largest(pov_two3_hi(k.f));
        double lo = -HUGE_VAL, hi = HUGE_VAL;

        clip_axis(&lo, &hi, k.f.x.hi, k.d.x, b->lo.x, b->hi.x, margin);
        clip_axis(&lo, &hi, k.f.y.hi, k.d.y, b->lo.y, b->hi.y, margin);
        clip_axis(&lo, &hi, k.f.z.hi, k.d.z, b->lo.z, b->hi.z, margin);
        out->f[0][i] = k.f.x.hi;
        out->f[1][i] = k.f.x.lo;
        out->f[2][i] = k.f.y.hi;
        out->f[3][i] = k.f.y.lo;
        out->f[4][i] = k.f.z.hi;
        out->f[5][i] = k.f.z.lo;
        out->d[0][i] = k.d.x;
        out->d[1][i] = k.d.y;
        out->d[2][i] = k.d.z;
        out->d_lo[0][i] = k.d_lo.x;
        out->d_lo[1][i] = k.d_lo.y;
        out->d_lo[2][i] = k.d_lo.z;
        out->unit[i] = k.unit;
        out->per_unit[i] = k.per_unit;
        out->lo[i] = lo;
        out->hi[i] = hi;
    }
}

COMMON_SEPARATE static void enter_half(const common_rays *restrict l, const common_boxed *restrict b, common_entries *restrict out)
{
    enter(l, b, HALF, out);
}

COMMON_SEPARATE static void enter_all(const common_rays *restrict l, const common_boxed *restrict b, common_entries *restrict out)
{
    enter(l, b, N, out);
}

common_entry common_boxed_entry(const common_entries *l, uint32_t i)
{
    common_entry e;

    e.k.f.x = pov_two_of(l->f[0][i], l->f[1][i]);
    e.k.f.y = pov_two_of(l->f[2][i], l->f[3][i]);
    e.k.f.z = pov_two_of(l->f[4][i], l->f[5][i]);
    e.k.d = pov_vec3_of(l->d[0][i], l->d[1][i], l->d[2][i]);
    e.k.d_lo = pov_vec3_of(l->d_lo[0][i], l->d_lo[1][i], l->d_lo[2][i]);
    e.k.unit = l->unit[i];
    e.k.per_unit = l->per_unit[i];
    e.span.lo = l->lo[i];
    e.span.hi = l->hi[i];
    return e;
}

/* Does it reach the box, within the interval? */
static inline bool reaches(double lo, double hi, double unit, const pov_hits *hits)
{
    return lo <= hi && !(hi < 0.0) && !(lo * unit > hits->tmax);
}

bool common_boxed_reaches(const common_entries *l, uint32_t i, const pov_hits *hits) { return reaches(l->lo[i], l->hi[i], l->unit[i], hits); }

void common_boxed_enter(const common_boxed *b, const pov_ray *const *rays, uint32_t n, common_entries *out)
{
    common_rays lanes;

    common_put_four_of(&lanes, 0, rays, n);
    if (n > HALF) {
        common_put_four_of(&lanes, HALF, rays, n);
        enter_all(&lanes, b, out);
    } else {
        enter_half(&lanes, b, out);
    }
}

void common_boxed_intersect(const common_boxed *b, common_cross_entry *cross, const void *self, const pov_ray *ray, pov_hits *hits)
{
    common_entry e;

    e.k = common_enter(ray, b->anchor, b->scale);
    if (common_clip(&e.k, b->lo, b->hi, &e.span) && reaches(e.span.lo, e.span.hi, e.k.unit, hits))
        cross(self, ray, &e, hits);
}

static inline bool is_own(const pov_ray *ray, const pov_hits *hits) { return ray->origin_surface == hits->owner; }

/* May its first crossing be found beside others'? That one decides where any will do, too: if it is not before the end, none is. */
static inline bool wants_first(const pov_ray *ray, const pov_hits *hits, bool starts)
{
    return hits->want != POV_WANT_ALL && (starts || !is_own(ray, hits));
}

static bool has_crossed(const common_entries *l, const common_first_crossings *of, uint32_t i, pov_hits *hits)
{
    const pov_mark mark = { (uint32_t)of->feature[i], 0, of->u[i], of->v[i] };

    if (!(of->known[i] > 0.0))
        return false;
    if (of->t[i] < HUGE_VAL)
        pov_cross(hits, of->t[i] * l->unit[i], of->t_lo[i] * l->unit[i], mark);
    return true;
}

/* Those that want their first crossings side by side, if there are several: a bit each. */
static uint32_t find_firsts(common_first_of_entries *first, bool starts, const void *self, common_entries *l, const pov_ray *const *rays,
                            pov_hits *const *hits, uint32_t n, common_first_crossings *out)
{
    uint32_t some = 0;

    for (uint32_t i = 0; i < N; i++) {
        const uint32_t k = common_lane_of(i, n);

        l->least[i] = hits[k]->tmin * l->per_unit[i];
        l->own[i] = is_own(rays[k], hits[k]) ? 1.0 + rays[k]->origin_mark.feature : 0.0;
    }
    for (uint32_t i = 0; i < n; i++)
        some |= (uint32_t)wants_first(rays[i], hits[i], starts) << i;
    if (common_count(some) < LEAST)
        return 0;
    first(self, l, out);
    return some;
}

/* Rays of one shape. */
static void intersect_some(const common_boxed *b, common_cross_entry *cross, common_first_of_entries *first, bool starts, const void *self,
                           const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    common_first_crossings of;
    common_rays lanes;
    common_entries all;
    uint32_t known = 0;

    common_put_four_of(&lanes, 0, rays, n);
    if (n > HALF || (first && n >= LEAST)) {
        common_put_four_of(&lanes, HALF, rays, n);
        enter_all(&lanes, b, &all);
    } else {
        enter_half(&lanes, b, &all);
    }
    if (first && n >= LEAST)
        known = find_firsts(first, starts, self, &all, rays, hits, n, &of);
    for (uint32_t i = 0; i < n; i++)
        if (reaches(all.lo[i], all.hi[i], all.unit[i], hits[i]) && !((known >> i & 1) && has_crossed(&all, &of, i, hits[i]))) {
            const common_entry e = common_boxed_entry(&all, i);

            cross(self, rays[i], &e, hits[i]);
        }
}

void common_boxed_intersect_many(size_t boxed_at, common_cross_entry *cross, common_first_of_entries *first, bool starts, const void *const *selves,
                                 const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    for (uint32_t i = 0, some; i < n; i += some) {
        const common_boxed *b = (const common_boxed *)(const void *)((const char *)selves[i] + boxed_at);

        for (some = 1; some < N && i + some < n && selves[i + some] == selves[i];)
            some++;
        if (some > 1)
            intersect_some(b, cross, first, starts, selves[i], rays + i, hits + i, some);
        else
            common_boxed_intersect(b, cross, selves[i], rays[i], hits[i]);
    }
}

/* ---- normals ---- */

COMMON_SEPARATE static void find_points(const common_boxed *restrict b, const common_rays *restrict l, const double *restrict t,
                                        const double *restrict t_lo, common_lane3 *restrict out)
{
    for (uint32_t i = 0; i < N; i++) {
        const pov_ray ray = common_get_ray(l, i);
        const common_ray k = common_enter(&ray, b->anchor, b->scale);

        common_put(out, i, pov_two3_hi(common_along_dd(&k, pov_two_of(t[i] * k.per_unit, t_lo[i] * k.per_unit))));
    }
}

static void normals_of(const common_boxed *b, common_normal_at *normal_at, const void *self, const pov_ray *const *rays,
                       const pov_crossing *const *at, pov_vec3 *const *out, uint32_t n)
{
    common_by_entry t, t_lo;
    common_lane3 points;
    common_rays lanes;

    common_put_crossings_of(&lanes, t, t_lo, rays, at, n);
    find_points(b, &lanes, t, t_lo, &points);
    for (uint32_t i = 0; i < n; i++)
        normal_at(self, common_get(&points, i), rays[i], at[i], out[i]);
}

void common_boxed_normal_many(size_t boxed_at, common_normal_at *normal_at, const void *const *selves, const pov_ray *const *rays,
                              const pov_crossing *const *at, pov_vec3 *const *out, uint32_t n)
{
    for (uint32_t i = 0, some; i < n; i += some) {
        const common_boxed *b = (const common_boxed *)(const void *)((const char *)selves[i] + boxed_at);

        for (some = 1; some < N && i + some < n && selves[i + some] == selves[i];)
            some++;
        normals_of(b, normal_at, selves[i], rays + i, at + i, out + i, some);
    }
}
