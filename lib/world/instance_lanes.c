/* Several rays or normals, each with an instance transform: a single one waits for each of its sums, four side by side
 * do not. Operations and their order are those of instance.c. */
#include "base/simd.h"
#include "world/instance.h"

enum { LANES = 4 };

/* Offsets in doubles: of an instance transform's from the anchor on, where the fourth is unused, and of a ray's, with
 * three others. */
enum { COLUMN = 4, COLUMN_LO = 13, OWN = 22, OWN_LO = 25, NUMBERS = 28, ORG = 0, ORG_LO = 3, DIR = 6, COMPONENTS = 12 };

typedef struct pair_lanes { double xform[NUMBERS][LANES], ray[COMPONENTS][LANES]; } pair_lanes;

/* The first members of a pov_ray, and the lower part of the direction. */
typedef struct own_lanes { double component[COMPONENTS][LANES]; } own_lanes;

static inline void take_block(double (*to)[LANES], const void *const from[LANES], size_t offset)
{
    simd_transpose(from, offset, to[0], to[1], to[2], to[3]);
}

static inline void take_pairs(pair_lanes *l, const void *const xforms[LANES], const void *const rays[LANES])
{
    size_t i;

    take_block(l->xform, xforms, offsetof(instance_xform, anchor));
    for (i = COLUMN; i < NUMBERS; i += 4)
        take_block(l->xform + i, xforms, offsetof(instance_xform, column) + (i - COLUMN) * sizeof(double));
    take_block(l->ray, rays, offsetof(pov_ray, org));
    take_block(l->ray + 4, rays, offsetof(pov_ray, org_lo.y));
    take_block(l->ray + 8, rays, offsetof(pov_ray, dir.z));
}

SIMD_INLINE pov_two inverse(const pair_lanes *l, size_t lane, size_t i, size_t j)
{
    return pov_two_of(l->xform[COLUMN + 3 * j + i][lane], l->xform[COLUMN_LO + 3 * j + i][lane]);
}

/* Vector from the anchor to the start. */
SIMD_INLINE pov_two start(const pair_lanes *l, size_t lane, size_t j)
{
    return pov_two_add_double(pov_two_sum(l->ray[ORG + j][lane], -l->xform[j][lane]), l->ray[ORG_LO + j][lane]);
}

SIMD_INLINE void put_axis(const pair_lanes *l, size_t lane, size_t i, pov_two x, pov_two y, pov_two z, own_lanes *out)
{
    const pov_two a = inverse(l, lane, i, 0), b = inverse(l, lane, i, 1), c = inverse(l, lane, i, 2);
    const pov_two at = pov_two_add(pov_two_add(pov_two_mul(a, x), pov_two_mul(b, y)), pov_two_mul(c, z));
    const pov_two o = pov_two_add(at, pov_two_of(l->xform[OWN + i][lane], l->xform[OWN_LO + i][lane]));
    const double *const to_x = l->ray[DIR], *const to_y = l->ray[DIR + 1], *const to_z = l->ray[DIR + 2];
    const pov_two ab = pov_two_add(pov_two_mul_double(a, to_x[lane]), pov_two_mul_double(b, to_y[lane]));
    const pov_two d = pov_two_add(ab, pov_two_mul_double(c, to_z[lane]));

    out->component[i][lane] = o.hi;
    out->component[3 + i][lane] = o.lo;
    out->component[6 + i][lane] = d.hi;
    out->component[9 + i][lane] = d.lo;
}

SIMD_CLONES static void find_own(const pair_lanes *restrict l, own_lanes *restrict out)
{
    size_t i;

    for (i = 0; i < LANES; i++) {
        const pov_two x = start(l, i, 0), y = start(l, i, 1), z = start(l, i, 2);

        put_axis(l, i, 0, x, y, z, out);
        put_axis(l, i, 1, x, y, z, out);
        put_axis(l, i, 2, x, y, z, out);
    }
}

/* Four rows of four numbers, `stride` from each other, into as many rays. */
static inline void give_rows(const double *from, size_t stride, pov_ray *const to[LANES], size_t offset)
{
    const void *const rows[LANES] = { from, from + stride, from + 2 * stride, from + 3 * stride };
    double *out[LANES];
    size_t i;

    for (i = 0; i < LANES; i++)
        out[i] = (double *)(void *)((char *)to[i] + offset);
    simd_transpose(rows, 0, out[0], out[1], out[2], out[3]);
}

/* Up to four, none with a diagonal inverse. */
static void rays_some(const instance_xform *const *p, const pov_ray *const *rays, pov_ray *const *own, uint32_t n)
{
    const void *xforms[LANES], *from[LANES];
    pov_ray *to[LANES], unused;
    pair_lanes lanes;
    own_lanes out;
    uint32_t i;

    for (i = 0; i < LANES; i++) {
        xforms[i] = p[i < n ? i : n - 1];
        from[i] = rays[i < n ? i : n - 1];
        to[i] = i < n ? own[i] : &unused;
    }
    take_pairs(&lanes, xforms, from);
    find_own(&lanes, &out);
    give_rows(out.component[0], LANES, to, offsetof(pov_ray, org));
    give_rows(out.component[4], LANES, to, offsetof(pov_ray, org_lo.y));
    for (i = 0; i < n; i++) {
        own[i]->dir.z = out.component[8][i];
        own[i]->dir_lo = pov_vec3_of(out.component[9][i], out.component[10][i], out.component[11][i]);
        own[i]->origin_surface = rays[i]->origin_surface;
        own[i]->origin_mark = rays[i]->origin_mark;
    }
}

/* ---- rays of one instance ---- */

/* Twice as many: there are no numbers of instances to be laid out. Fewer than LEAST are not worth the empty lanes. */
#if defined(__AVX512F__)
enum { SAME = 2 * LANES, LEAST = 3 };
#else
enum { SAME = 2 * LANES, LEAST = LANES + 1 };
#endif

typedef struct same_lanes { double component[COMPONENTS][SAME]; } same_lanes;

SIMD_INLINE pov_two start_of(const same_lanes *l, size_t lane, size_t j, double anchor)
{
    return pov_two_add_double(pov_two_sum(l->component[ORG + j][lane], -anchor), l->component[ORG_LO + j][lane]);
}

/* As put_axis(), by a row of the inverse. */
typedef struct inverse_row { pov_two a, b, c, own; } inverse_row;

SIMD_INLINE inverse_row row_of(const instance_xform *p, int i)
{
    const pov_vec3 *c = p->column, *e = p->column_lo;
    const inverse_row x = { { c[0].x, e[0].x }, { c[1].x, e[1].x }, { c[2].x, e[2].x }, { p->own_anchor.x, p->own_anchor_lo.x } };
    const inverse_row y = { { c[0].y, e[0].y }, { c[1].y, e[1].y }, { c[2].y, e[2].y }, { p->own_anchor.y, p->own_anchor_lo.y } };
    const inverse_row z = { { c[0].z, e[0].z }, { c[1].z, e[1].z }, { c[2].z, e[2].z }, { p->own_anchor.z, p->own_anchor_lo.z } };

    return i == 0 ? x : i == 1 ? y : z;
}

/* Of a vector from the anchor. */
SIMD_INLINE pov_two start_by(const inverse_row *r, pov_two x, pov_two y, pov_two z)
{
    return pov_two_add(pov_two_add(pov_two_add(pov_two_mul(r->a, x), pov_two_mul(r->b, y)), pov_two_mul(r->c, z)), r->own);
}

SIMD_INLINE void put_start(const inverse_row *r, size_t lane, size_t i, pov_two x, pov_two y, pov_two z, same_lanes *out)
{
    const pov_two o = start_by(r, x, y, z);

    out->component[i][lane] = o.hi;
    out->component[3 + i][lane] = o.lo;
}

SIMD_INLINE void put_direction(const inverse_row *r, size_t lane, size_t i, const same_lanes *l, same_lanes *out)
{
    const pov_two ab = pov_two_add(pov_two_mul_double(r->a, l->component[DIR][lane]), pov_two_mul_double(r->b, l->component[DIR + 1][lane]));
    const pov_two d = pov_two_add(ab, pov_two_mul_double(r->c, l->component[DIR + 2][lane]));

    out->component[6 + i][lane] = d.hi;
    out->component[9 + i][lane] = d.lo;
}

SIMD_CLONES SIMD_NOINLINE static void find_starts(const instance_xform *restrict p, const same_lanes *restrict l, same_lanes *restrict out)
{
    const inverse_row r = row_of(p, 0), s = row_of(p, 1), t = row_of(p, 2);
    const pov_vec3 at = p->anchor;

    for (size_t i = 0; i < SAME; i++) {
        const pov_two x = start_of(l, i, 0, at.x), y = start_of(l, i, 1, at.y), z = start_of(l, i, 2, at.z);

        put_start(&r, i, 0, x, y, z, out);
        put_start(&s, i, 1, x, y, z, out);
        put_start(&t, i, 2, x, y, z, out);
    }
}

SIMD_CLONES SIMD_NOINLINE static void find_directions(const instance_xform *restrict p, const same_lanes *restrict l, same_lanes *restrict out)
{
    const inverse_row r = row_of(p, 0), s = row_of(p, 1), t = row_of(p, 2);

    for (size_t i = 0; i < SAME; i++) {
        put_direction(&r, i, 0, l, out);
        put_direction(&s, i, 1, l, out);
        put_direction(&t, i, 2, l, out);
    }
}

/* Camera rays mostly start at one point. */
SIMD_CLONES SIMD_NOINLINE static bool is_one_start(const same_lanes *restrict l)
{
    int64_t other = 0;

    for (size_t k = 0; k < DIR; k++) {
        int64_t bits[SAME];

        memcpy(bits, l->component[k], sizeof bits);
        for (size_t i = 0; i < SAME; i++)
            other |= bits[i] ^ bits[0];
    }
    return other == 0;
}

/* Starts in object space: one that is known already is not computed again. */
typedef struct known_start { const instance_xform *of; double from[DIR], own[DIR]; } known_start;

static void find_one_start(known_start *k, const instance_xform *p, const same_lanes *l, same_lanes *out)
{
    double from[DIR];

    for (size_t j = 0; j < DIR; j++)
        from[j] = l->component[j][0];
    if (k->of != p || memcmp(k->from, from, sizeof from) != 0) {
        const pov_two3 own = instance_point(p, pov_vec3_of(from[0], from[1], from[2]), pov_vec3_of(from[3], from[4], from[5]));
        const double components[DIR] = { own.x.hi, own.y.hi, own.z.hi, own.x.lo, own.y.lo, own.z.lo };

        k->of = p;
        memcpy(k->from, from, sizeof from);
        memcpy(k->own, components, sizeof components);
    }
    for (size_t j = 0; j < DIR; j++)
        for (size_t i = 0; i < SAME; i++)
            out->component[j][i] = k->own[j];
}

/* The same by a diagonal inverse. */
SIMD_INLINE void put_scaled(pov_two factor, pov_two own, size_t lane, size_t i, double anchor, const same_lanes *l, same_lanes *out)
{
    const pov_two o = pov_two_add(pov_two_mul(factor, start_of(l, lane, i, anchor)), own);
    const pov_two d = pov_two_mul_double(factor, l->component[DIR + i][lane]);

    out->component[i][lane] = o.hi;
    out->component[3 + i][lane] = o.lo;
    out->component[6 + i][lane] = d.hi;
    out->component[9 + i][lane] = d.lo;
}

SIMD_CLONES SIMD_NOINLINE static void scale_same(const instance_xform *restrict p, const same_lanes *restrict l, same_lanes *restrict out)
{
    const pov_vec3 *c = p->column, *e = p->column_lo, at = p->anchor, own = p->own_anchor, own_lo = p->own_anchor_lo;
    const pov_two x = pov_two_of(c[0].x, e[0].x), y = pov_two_of(c[1].y, e[1].y), z = pov_two_of(c[2].z, e[2].z);

    for (size_t i = 0; i < SAME; i++) {
        put_scaled(x, pov_two_of(own.x, own_lo.x), i, 0, at.x, l, out);
        put_scaled(y, pov_two_of(own.y, own_lo.y), i, 1, at.y, l, out);
        put_scaled(z, pov_two_of(own.z, own_lo.z), i, 2, at.z, l, out);
    }
}

/* The first components of four rays, to or from lanes from `at` on. */
static inline void take_four(const pov_ray *const *rays, uint32_t at, uint32_t n, same_lanes *l)
{
    const void *from[LANES];

    for (uint32_t i = 0; i < LANES; i++)
        from[i] = rays[at + i < n ? at + i : n - 1];
    simd_transpose(from, offsetof(pov_ray, org), l->component[0] + at, l->component[1] + at, l->component[2] + at, l->component[3] + at);
    simd_transpose(from, offsetof(pov_ray, org_lo.y), l->component[4] + at, l->component[5] + at, l->component[6] + at, l->component[7] + at);
    simd_transpose(from, offsetof(pov_ray, dir.z), l->component[8] + at, l->component[9] + at, l->component[10] + at, l->component[11] + at);
}

static inline void give_four(same_lanes *l, uint32_t at, uint32_t n, pov_ray *const *own)
{
    pov_ray *to[LANES], unused;

    for (uint32_t i = 0; i < LANES; i++)
        to[i] = at + i < n ? own[at + i] : &unused;
    give_rows(l->component[0] + at, SAME, to, offsetof(pov_ray, org));
    give_rows(l->component[4] + at, SAME, to, offsetof(pov_ray, org_lo.y));
}

/* Up to eight of one instance. */
static void rays_same(known_start *k, const instance_xform *p, const pov_ray *const *rays, pov_ray *const *own, uint32_t n)
{
    same_lanes l, out;

    take_four(rays, 0, n, &l);
    take_four(rays, LANES, n, &l);
    if (p->axes) {
        scale_same(p, &l, &out);
    } else {
        if (is_one_start(&l))
            find_one_start(k, p, &l, &out);
        else
            find_starts(p, &l, &out);
        find_directions(p, &l, &out);
    }
    give_four(&out, 0, n, own);
    if (n > LANES)
        give_four(&out, LANES, n, own);
    for (uint32_t i = 0; i < n; i++) {
        own[i]->dir.z = out.component[8][i];
        own[i]->dir_lo = pov_vec3_of(out.component[9][i], out.component[10][i], out.component[11][i]);
        own[i]->origin_surface = rays[i]->origin_surface;
        own[i]->origin_mark = rays[i]->origin_mark;
    }
}

/* How many are of the first one's instance, up to as many as there are lanes. */
static uint32_t count_same(const instance_xform *const *p, uint32_t n)
{
    uint32_t some = 1;

    while (some < SAME && some < n && p[some] == p[0])
        some++;
    return some;
}

/* ---- all ---- */

static bool any_axes(const instance_xform *const *p, uint32_t n)
{
    bool any = false;
    uint32_t i;

    for (i = 0; i < n; i++)
        any = any || p[i]->axes;
    return any;
}

void instance_rays(const instance_xform *const *p, const pov_ray *const *rays, pov_ray *const *own, uint32_t n)
{
    known_start known = { .of = NULL };
    uint32_t some, i;

    for (; n > 0; n -= some, p += some, rays += some, own += some) {
        some = count_same(p, n);
        if (some >= LEAST) {
            rays_same(&known, p[0], rays, own, some);
            continue;
        }
        some = n < LANES ? n : LANES;
        if (some > 1 && !any_axes(p, some))
            rays_some(p, rays, own, some);
        else
            for (i = 0; i < some; i++)
                instance_ray(p[i], rays[i], own[i]);
    }
}

/* ---- points ---- */

typedef struct point_lanes { double at[3][SAME], at_lo[3][SAME]; } point_lanes;

SIMD_INLINE pov_two from_anchor(const point_lanes *l, size_t lane, size_t j, double anchor)
{
    return pov_two_add_double(pov_two_sum(l->at[j][lane], -anchor), l->at_lo[j][lane]);
}

SIMD_INLINE void put_point(point_lanes *out, size_t lane, size_t i, pov_two o)
{
    out->at[i][lane] = o.hi;
    out->at_lo[i][lane] = o.lo;
}

SIMD_CLONES SIMD_NOINLINE static void rotate_points(const instance_xform *restrict p, const point_lanes *restrict l, point_lanes *restrict out)
{
    const inverse_row r = row_of(p, 0), s = row_of(p, 1), t = row_of(p, 2);
    const pov_vec3 anchor = p->anchor;

    for (size_t i = 0; i < SAME; i++) {
        const pov_two x = from_anchor(l, i, 0, anchor.x), y = from_anchor(l, i, 1, anchor.y), z = from_anchor(l, i, 2, anchor.z);

        put_point(out, i, 0, start_by(&r, x, y, z));
        put_point(out, i, 1, start_by(&s, x, y, z));
        put_point(out, i, 2, start_by(&t, x, y, z));
    }
}

/* The same where the inverse is diagonal. */
SIMD_CLONES SIMD_NOINLINE static void stretch_points(const instance_xform *restrict p, const point_lanes *restrict l, point_lanes *restrict out)
{
    const inverse_row r = row_of(p, 0), s = row_of(p, 1), t = row_of(p, 2);
    const pov_vec3 anchor = p->anchor;

    for (size_t i = 0; i < SAME; i++) {
        put_point(out, i, 0, pov_two_add(pov_two_mul(r.a, from_anchor(l, i, 0, anchor.x)), r.own));
        put_point(out, i, 1, pov_two_add(pov_two_mul(s.b, from_anchor(l, i, 1, anchor.y)), s.own));
        put_point(out, i, 2, pov_two_add(pov_two_mul(t.c, from_anchor(l, i, 2, anchor.z)), t.own));
    }
}

/* Up to eight of one instance. */
static void points_same(const instance_xform *p, pov_vec3 *const *points, pov_vec3 *const *points_lo, uint32_t n)
{
    point_lanes l, out;

    for (uint32_t i = 0; i < SAME; i++) {
        const pov_vec3 at = *points[i < n ? i : 0], at_lo = *points_lo[i < n ? i : 0];

        l.at[0][i] = at.x, l.at[1][i] = at.y, l.at[2][i] = at.z;
        l.at_lo[0][i] = at_lo.x, l.at_lo[1][i] = at_lo.y, l.at_lo[2][i] = at_lo.z;
    }
    if (p->axes)
        stretch_points(p, &l, &out);
    else
        rotate_points(p, &l, &out);
    for (uint32_t i = 0; i < n; i++) {
        *points[i] = pov_vec3_of(out.at[0][i], out.at[1][i], out.at[2][i]);
        *points_lo[i] = pov_vec3_of(out.at_lo[0][i], out.at_lo[1][i], out.at_lo[2][i]);
    }
}

void instance_points(const instance_xform *const *p, pov_vec3 *const *points, pov_vec3 *const *points_lo, uint32_t n)
{
    uint32_t some;

    for (; n > 0; n -= some, p += some, points += some, points_lo += some) {
        some = count_same(p, n);
        if (some >= LEAST) {
            points_same(p[0], points, points_lo, some);
            continue;
        }
        for (uint32_t i = 0; i < some; i++) {
            const pov_two3 own = instance_point(p[i], *points[i], *points_lo[i]);

            *points[i] = pov_two3_hi(own);
            *points_lo[i] = pov_two3_lo(own);
        }
    }
}

/* ---- normals ---- */

/* Range of squared normal lengths in which pov_unit() does not scale. */
#define LEAST_SQUARE 1e-238
#define MOST_SQUARE 1e238

/* Unit normals, and their squared lengths before normalisation. */
typedef struct unit_lanes { double normal[3][LANES], square[LANES]; } unit_lanes;

/* Normals are stored in place of a ray's start. */
SIMD_INLINE double rotate_axis(const pair_lanes *l, size_t lane, size_t i)
{
    const pov_two a = inverse(l, lane, 0, i), b = inverse(l, lane, 1, i), c = inverse(l, lane, 2, i);
    const double *const x = l->ray[ORG], *const y = l->ray[ORG + 1], *const z = l->ray[ORG + 2];
    const pov_two ab = pov_two_add(pov_two_mul_double(a, x[lane]), pov_two_mul_double(b, y[lane]));

    return pov_two_add(ab, pov_two_mul_double(c, z[lane])).hi;
}

SIMD_CLONES static void find_units(const pair_lanes *restrict l, unit_lanes *restrict out)
{
    size_t i;

    for (i = 0; i < LANES; i++) {
        const pov_vec3 n = pov_vec3_of(rotate_axis(l, i, 0), rotate_axis(l, i, 1), rotate_axis(l, i, 2));
        const double square = pov_dot(n, n), length = sqrt(square);

        out->normal[0][i] = n.x / length;
        out->normal[1][i] = n.y / length;
        out->normal[2][i] = n.z / length;
        out->square[i] = square;
    }
}

/* Up to four. */
static void rotate_some(const instance_xform *const *p, pov_vec3 *const *normals, uint32_t n)
{
    const void *xforms[LANES];
    pair_lanes lanes;
    unit_lanes out;
    uint32_t i;

    for (i = 0; i < LANES; i++) {
        const uint32_t j = i < n ? i : n - 1;

        xforms[i] = p[j];
        lanes.ray[ORG][i] = normals[j]->x;
        lanes.ray[ORG + 1][i] = normals[j]->y;
        lanes.ray[ORG + 2][i] = normals[j]->z;
    }
    for (i = COLUMN; i < OWN; i += 4)
        take_block(lanes.xform + i, xforms, offsetof(instance_xform, column) + (i - COLUMN) * sizeof(double));
    find_units(&lanes, &out);
    for (i = 0; i < n; i++)
        if (out.square[i] >= LEAST_SQUARE && out.square[i] <= MOST_SQUARE)
            *normals[i] = pov_vec3_of(out.normal[0][i], out.normal[1][i], out.normal[2][i]);
        else
            instance_world_normal(p[i], normals[i]);
}

/* ---- normals of one instance ---- */

typedef struct normal_lanes { double x[SAME], y[SAME], z[SAME]; } normal_lanes;

/* Unit normals, and their squared lengths before that. */
typedef struct same_units { double normal[3][SAME], square[SAME]; } same_units;

SIMD_INLINE double rotate_by_row(pov_vec3 row, pov_vec3 row_lo, const normal_lanes *n, size_t lane)
{
    const pov_two a = pov_two_of(row.x, row_lo.x), b = pov_two_of(row.y, row_lo.y), c = pov_two_of(row.z, row_lo.z);
    const pov_two ab = pov_two_add(pov_two_mul_double(a, n->x[lane]), pov_two_mul_double(b, n->y[lane]));

    return pov_two_add(ab, pov_two_mul_double(c, n->z[lane])).hi;
}

SIMD_CLONES SIMD_NOINLINE static void rotate_same(const instance_xform *restrict p, const normal_lanes *restrict from, same_units *restrict out)
{
    const pov_vec3 x = p->column[0], y = p->column[1], z = p->column[2];
    const pov_vec3 x_lo = p->column_lo[0], y_lo = p->column_lo[1], z_lo = p->column_lo[2];

    for (size_t i = 0; i < SAME; i++) {
        const pov_vec3 n = pov_vec3_of(rotate_by_row(x, x_lo, from, i), rotate_by_row(y, y_lo, from, i), rotate_by_row(z, z_lo, from, i));
        const double square = pov_dot(n, n), length = sqrt(square);

        out->normal[0][i] = n.x / length;
        out->normal[1][i] = n.y / length;
        out->normal[2][i] = n.z / length;
        out->square[i] = square;
    }
}

/* As rotate_same() where the inverse is diagonal. */
SIMD_CLONES SIMD_NOINLINE static void stretch_same(const instance_xform *restrict p, const normal_lanes *restrict from, same_units *restrict out)
{
    const pov_two x = row_of(p, 0).a, y = row_of(p, 1).b, z = row_of(p, 2).c;

    for (size_t i = 0; i < SAME; i++) {
        const pov_vec3 n = pov_vec3_of(pov_two_mul_double(x, from->x[i]).hi, pov_two_mul_double(y, from->y[i]).hi,
                                       pov_two_mul_double(z, from->z[i]).hi);
        const double square = pov_dot(n, n), length = sqrt(square);

        out->normal[0][i] = n.x / length;
        out->normal[1][i] = n.y / length;
        out->normal[2][i] = n.z / length;
        out->square[i] = square;
    }
}

/* Up to eight. */
static void rotate_all(const instance_xform *p, pov_vec3 *const *normals, uint32_t n)
{
    normal_lanes from;
    same_units out;

    for (uint32_t i = 0; i < SAME; i++) {
        const pov_vec3 of = *normals[i < n ? i : 0];

        from.x[i] = of.x;
        from.y[i] = of.y;
        from.z[i] = of.z;
    }
    if (p->axes)
        stretch_same(p, &from, &out);
    else
        rotate_same(p, &from, &out);
    for (uint32_t i = 0; i < n; i++)
        if (out.square[i] >= LEAST_SQUARE && out.square[i] <= MOST_SQUARE)
            *normals[i] = pov_vec3_of(out.normal[0][i], out.normal[1][i], out.normal[2][i]);
        else
            instance_world_normal(p, normals[i]);
}

void instance_rotate_normals(const instance_xform *p, pov_vec3 *normals, uint32_t n)
{
    pov_vec3 *all[SAME];

    for (uint32_t i = 0; i < n; i++)
        all[i] = &normals[i];
    rotate_all(p, all, n);
}

void instance_world_normals(const instance_xform *const *p, pov_vec3 *const *normals, uint32_t n)
{
    uint32_t some;

    for (; n > 1; n -= some, p += some, normals += some) {
        some = count_same(p, n);
        if (some >= LEAST) {
            rotate_all(p[0], normals, some);
            continue;
        }
        some = n < LANES ? n : LANES;
        rotate_some(p, normals, some);
    }
    if (n > 0)
        instance_world_normal(p[0], normals[0]);
}
