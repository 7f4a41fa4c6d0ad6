#include "common/narrow.h"

#include "common/lanes.h"

#include <stddef.h>

enum { N = COMMON_BEAMS };

/* With more than this nothing is known. Boxes are so much wider, far more than places are off. */
static const double MOST_OFF = 0x1p-24, WIDER = 0x1p-12;

/* Rays of the scene. */
typedef struct ray_lanes { common_beam org[3], dir[3], size, tmax; } ray_lanes;

/* The map to the local space, and the error of a ray there: of its start `off` and `off_far` times its size, of its direction
 * `off_far` times that. */
typedef struct space { pov_vec3 anchor, column[3], from, lo, hi; double off, off_far; } space;

/* Of lanes: a place at s is at t = base + s unit along the ray. */
typedef struct placed { common_beam base, unit; } placed;

static void find_space(const common_boxed *b, const pov_own_map *map, space *out)
{
    const pov_vec3 wider = pov_vec3_of(WIDER, WIDER, WIDER), middle = pov_two3_hi(b->anchor);
    double most = 0.0;

    out->anchor = map->anchor;
    out->from = pov_scale(pov_sub(map->from, middle), b->scale);
    for (int i = 0; i < 3; i++) {
        out->column[i] = pov_scale(map->column[i], b->scale);
        most = common_greater(most, pov_largest(out->column[i]));
    }
    out->lo = pov_sub(b->lo, wider);
    out->hi = pov_add(b->hi, wider);
    out->off_far = 0x1p-48 * most;
    out->off = out->off_far * common_sum_of_components(out->anchor)
               + 0x1p-48 * b->scale * (common_sum_of_components(map->from) + common_sum_of_components(middle)) + 0x1p-48;
}

COMMON_INLINE pov_vec3 turn(const space *to, double x, double y, double z)
{
    const pov_vec3 *c = to->column;

    return pov_vec3_of(c[0].x * x + c[1].x * y + c[2].x * z, c[0].y * x + c[1].y * y + c[2].y * z, c[0].z * x + c[1].z * y + c[2].z * z);
}

COMMON_INLINE void clip_to(double *near, double *far, double o, double d, double lo, double hi)
{
    const double inverse = 1.0 / (fabs(d) > 1e-200 ? d : 1e-200), a = (lo - o) * inverse, b = (hi - o) * inverse;

    *near = common_greater(common_lesser(a, b), *near);
    *far = common_lesser(common_greater(a, b), *far);
}

COMMON_SEPARATE static void enter(const space *to, const ray_lanes *restrict l, common_beams *restrict out, placed *restrict where)
{
    for (uint32_t i = 0; i < N; i++) {
        const double dx = l->dir[0][i], dy = l->dir[1][i], dz = l->dir[2][i], tmax = l->tmax[i];
        const pov_vec3 p = turn(to, l->org[0][i] - to->anchor.x, l->org[1][i] - to->anchor.y, l->org[2][i] - to->anchor.z);
        const pov_vec3 o = pov_add(p, to->from), d = turn(to, dx, dy, dz);
        const double square = pov_dot(d, d), length = sqrt(square), unit = 1.0 / length, off_dir = to->off_far * (fabs(dx) + fabs(dy) + fabs(dz));
        double near = -HUGE_VAL, far = HUGE_VAL, base, end, off;

        clip_to(&near, &far, o.x, d.x, to->lo.x, to->hi.x);
        clip_to(&near, &far, o.y, d.y, to->lo.y, to->hi.y);
        clip_to(&near, &far, o.z, d.z, to->lo.z, to->hi.z);
        base = common_greater(near, 0.0);
        end = common_lesser(far, tmax * (1.0 + 0x1p-40));
        off = 4.0 * (to->off + to->off_far * l->size[i] + common_greater(far, 0.0) * off_dir + 4.0 * off_dir * unit);
        out->org[0][i] = o.x + base * d.x;
        out->org[1][i] = o.y + base * d.y;
        out->org[2][i] = o.z + base * d.z;
        out->dir[0][i] = d.x * unit;
        out->dir[1][i] = d.y * unit;
        out->dir[2][i] = d.z * unit;
        out->from[i] = -off;
        out->to[i] = end >= base ? (end - base) * length + off : -HUGE_VAL;
        out->sure_from[i] = near > 0.0 ? -1.0 : off;
        out->sure_to[i] = (tmax * (1.0 - 0x1p-40) - base) * length - off;
        out->off[i] = square > 1e-200 ? square < 1e200 ? off : HUGE_VAL : HUGE_VAL;
        where->base[i] = base;
        where->unit[i] = unit;
    }
}

static void put(ray_lanes *l, uint32_t i, const pov_rays *rays, uint32_t ray)
{
    for (int k = 0; k < 3; k++) {
        l->org[k][i] = rays->org[k][ray];
        l->dir[k][i] = rays->dir[k][ray];
    }
    l->size[i] = rays->size[ray];
    l->tmax[i] = rays->tmax[ray];
}

/* Rays that follow each other. */
static void put_row(ray_lanes *l, const pov_rays *rays, uint32_t first)
{
    for (int k = 0; k < 3; k++) {
        memcpy(l->org[k], rays->org[k] + first, sizeof l->org[k]);
        memcpy(l->dir[k], rays->dir[k] + first, sizeof l->dir[k]);
    }
    memcpy(l->size, rays->size + first, sizeof l->size);
    memcpy(l->tmax, rays->tmax + first, sizeof l->tmax);
}

static void put_all(ray_lanes *l, common_beams *beams, const pov_rays *rays, uint32_t owner, const pov_candidate *of, uint32_t n)
{
    if (n == N && of[N - 1].ray - of[0].ray == N - 1)
        put_row(l, rays, of[0].ray);
    else
        for (uint32_t i = 0; i < N; i++)
            put(l, i, rays, of[common_lane_of(i, n)].ray);
    for (uint32_t i = 0; i < N; i++) {
        const pov_ray *ray = rays->rays[of[common_lane_of(i, n)].ray];

        beams->feature[i] = ray->origin_surface == owner ? ray->origin_mark.feature : UINT32_MAX;
        beams->u[i] = ray->origin_mark.u;
    }
}

/* Keeps a candidate, with what is known of it. False: it passes. */
static bool keep(const common_beams *l, const placed *where, const common_verdicts *of, uint32_t i, pov_candidate *m)
{
    const double base = where->base[i], unit = where->unit[i], slack = 2.0 * l->off[i] * unit;

    if (!(l->off[i] < MOST_OFF))
        return true;
    if (l->to[i] < l->from[i] || of->passed[i] > 0.0)
        return false;
    if (of->hit[i] > 0.0) {
        m->definite = true;
        m->lo = common_greater(m->lo, base + of->lo[i] * unit - slack);
        m->hi = base + of->hi[i] * unit + slack;
    }
    return true;
}

uint32_t common_narrow(const common_boxed *b, common_look *look, const void *self, const pov_own_map *map, uint32_t owner,
                       const pov_rays *rays, pov_candidate *io, uint32_t n)
{
    uint32_t kept = 0;
    space to;

    find_space(b, map, &to);
    for (uint32_t from = 0; from < n; from += N) {
        const uint32_t some = n - from < N ? n - from : N;
        common_verdicts of;
        common_beams beams;
        ray_lanes l;
        placed where;

        put_all(&l, &beams, rays, owner, io + from, some);
        enter(&to, &l, &beams, &where);
        look(self, &beams, &of);
        for (uint32_t i = 0; i < some; i++) {
            pov_candidate m = io[from + i];

            if (keep(&beams, &where, &of, i, &m))
                io[kept++] = m;
        }
    }
    return kept;
}

/* ---- shapes that nothing has moved ---- */

bool common_narrow_pack(common_narrow_block *out, common_narrow_of *narrow, const void *const *selves, uint32_t n)
{
    out->narrow = narrow;
    out->count = n;
    for (uint32_t i = 0; i < n; i++)
        out->self[i] = selves[i];
    return true;
}

/* Without their own rays nothing is known of them. */
uint32_t common_narrow_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_candidate *out)
{
    static const pov_own_map same = { { 0.0, 0.0, 0.0 }, { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } }, { 0.0, 0.0, 0.0 } };
    const common_narrow_block *b = block;
    uint32_t count = 0;

    for (uint32_t k = 0; k < b->count; k++) {
        uint32_t n = 0;

        for (uint64_t left = lanes; left; left &= left - 1) {
            const pov_candidate one = { 0.0, HUGE_VAL, (uint8_t)common_first_lane64(left), (uint8_t)k, false, false, 0 };

            out[count + n++] = one;
        }
        count += rays->rays ? b->narrow(b->self[k], &same, owners[k], rays, out + count, n) : n;
    }
    return count;
}
