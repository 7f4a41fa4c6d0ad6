/* Instance transforms are made several at once: one alone waits for each of its sums, eight side by side do not. */
#include "base/simd.h"
#include "world/instance.h"

#include <string.h>

enum { LANES = INSTANCE_MANY, HALF = LANES / 2 };

typedef double lanes[LANES];
typedef struct two_lanes { lanes hi, lo; } two_lanes;

/* Rows of four, of which the last is a movement. */
typedef struct row_lanes { lanes hi[4], lo[4]; } row_lanes;

SIMD_INLINE pov_two lane_of(const two_lanes *l, int k) { return pov_two_of(l->hi[k], l->lo[k]); }
SIMD_INLINE pov_two entry(const row_lanes *row, int j, int k) { return pov_two_of(row->hi[j][k], row->lo[j][k]); }

/* Lanes that have no map of their own take the first. */
static void take_rows(const pov_affine *const *maps, int n, size_t hi, size_t lo, row_lanes rows[3])
{
    const void *from[LANES];
    int i, k;

    for (k = 0; k < LANES; k++)
        from[k] = maps[k < n ? k : 0];
    for (i = 0; i < 3; i++)
        for (k = 0; k < LANES; k += HALF) {
            const size_t row = (size_t)i * sizeof maps[0]->m[0];
            lanes *const h = rows[i].hi, *const l = rows[i].lo;

            simd_transpose(from + k, hi + row, h[0] + k, h[1] + k, h[2] + k, h[3] + k);
            simd_transpose(from + k, lo + row, l[0] + k, l[1] + k, l[2] + k, l[3] + k);
        }
}

static void put_box(lanes lo[3], lanes hi[3], int k, const pov_box *box)
{
    lo[0][k] = box->lo.x;
    lo[1][k] = box->lo.y;
    lo[2][k] = box->lo.z;
    hi[0][k] = box->hi.x;
    hi[1][k] = box->hi.y;
    hi[2][k] = box->hi.z;
}

/* ---- boxes ---- */

/* One bound of a row's sum of intervals, the lower one for a side of -1, the upper one for 1: the terms' double-double
 * sum, moved outward by more than its error (relative to the terms, 2^-96 is many times what the additions lose) and
 * rounded outward. near, far: the corners of the box, far the one on that side. */
SIMD_INLINE double bound(const row_lanes *row, const lanes near[3], const lanes far[3], double side, int k)
{
    pov_two sum = entry(row, 3, k);
    double size = fabs(sum.hi);
    int j;

    for (j = 0; j < 3; j++) {
        const double a = near[j][k], b = far[j][k], v = row->hi[j][k] >= 0.0 ? b : a;
        const pov_two term = pov_two_mul_double(entry(row, j, k), v);

        sum = pov_two_add(sum, term);
        size += fabs(term.hi);
    }
    return side * pov_next(side * sum.hi + size * 0x1p-96);
}

static void bounds_of(const row_lanes *restrict row, const lanes near[3], const lanes far[3], double side,
                      double *restrict out)
{
    int k;

    for (k = 0; k < LANES; k++)
        out[k] = bound(row, near, far, side, k);
}

void instance_boxes(const pov_affine *const *maps, const pov_box *own, int n, pov_box *out)
{
    row_lanes rows[3];
    lanes lo[3], hi[3], around_lo[3], around_hi[3];
    int i, k;

    take_rows(maps, n, offsetof(pov_affine, m), offsetof(pov_affine, m_lo), rows);
    for (k = 0; k < LANES; k++)
        put_box(lo, hi, k, &own[k < n ? k : 0]);
    for (i = 0; i < 3; i++) {
        bounds_of(&rows[i], (const lanes *)hi, (const lanes *)lo, -1.0, around_lo[i]);
        bounds_of(&rows[i], (const lanes *)lo, (const lanes *)hi, 1.0, around_hi[i]);
    }
    for (k = 0; k < n; k++) {
        out[k].lo = pov_vec3_of(around_lo[0][k], around_lo[1][k], around_lo[2][k]);
        out[k].hi = pov_vec3_of(around_hi[0][k], around_hi[1][k], around_hi[2][k]);
    }
}

void instance_box(const pov_affine *map, const pov_box *own, pov_box *out)
{
    instance_boxes(&map, own, 1, out);
}

/* By how much a sphere of that radius, or a larger one, falls short of the box around it on either side of an axis of
 * the world: there it reaches as far as the row of the map is long, the box as far as the sum of sizes. Three sums and
 * a root lose less than 11 u of that sum, the row's low parts with them; squares that underflow need a sum that is
 * small. */
static double falls_short(const double row[4], double radius)
{
    const double sum = fabs(row[0]) + fabs(row[1]) + fabs(row[2]);
    const double length = sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);

    return sum > 1e-140 ? fmax(radius * (sum - length - sum * 0x1p-49), 0.0) : 0.0;
}

static void draw_in(double *lo, double *hi, double by)
{
    *lo = fmax(*lo, -pov_next(-(*lo + by)));
    *hi = fmin(*hi, pov_next(*hi - by));
}

void instance_shrink_box(const pov_affine *map, const pov_box *own, pov_box *around)
{
    const pov_vec3 edge = pov_sub(own->hi, own->lo);
    const double wide = INSTANCE_ROUNDED * (pov_largest(own->lo) + pov_largest(own->hi));
    const double radius = fmax(0.5 * fmin(edge.x, fmin(edge.y, edge.z)) - wide, 0.0);

    draw_in(&around->lo.x, &around->hi.x, falls_short(map->m[0], radius));
    draw_in(&around->lo.y, &around->hi.y, falls_short(map->m[1], radius));
    draw_in(&around->lo.z, &around->hi.z, falls_short(map->m[2], radius));
}

/* ---- instance transforms ---- */

typedef struct making {
    row_lanes inverse[3];
    two_lanes move[3];           /* of the map */
    lanes lo[3], hi[3];          /* own box */
    lanes reach[3];              /* edges of the one in the world */
    lanes anchor[3], off_diagonal;   /* off_diagonal: not zero, the inverse has more than a diagonal */
    two_lanes own_anchor[3];
    lanes per_half[3], known, snug;   /* known: not zero, there are halves; snug: the box reaches as far on either side */
} making;

static void take(making *m, const instance_desc *wishes, int n)
{
    static const pov_box none = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
    const pov_affine *maps[LANES];
    int i, k;

    for (k = 0; k < LANES; k++) {
        const instance_desc *w = &wishes[k < n ? k : 0];
        const pov_affine *map = maps[k] = w->map;
        const pov_box *around = w->around;
        pov_vec3 anchor = pov_vec3_of(map->m[0][3], map->m[1][3], map->m[2][3]), reach = none.lo;

        if (around) {
            anchor = pov_add(pov_scale(around->lo, 0.5), pov_scale(around->hi, 0.5));
            reach = pov_sub(around->hi, around->lo);
        }
        put_box(m->anchor, m->reach, k, &(const pov_box){ anchor, reach });
        put_box(m->lo, m->hi, k, around ? w->own : &none);
        for (i = 0; i < 3; i++) {
            m->move[i].hi[k] = map->m[i][3];
            m->move[i].lo[k] = map->m_lo[i][3];
        }
    }
    take_rows(maps, LANES, offsetof(pov_affine, inv), offsetof(pov_affine, inv_lo), m->inverse);
}

static void find_off_diagonal(const making *restrict m, double *restrict off_diagonal)
{
    const row_lanes *a = &m->inverse[0], *b = &m->inverse[1], *c = &m->inverse[2];
    int k;

    for (k = 0; k < LANES; k++)
        off_diagonal[k] = fabs(a->hi[1][k]) + fabs(a->hi[2][k]) + fabs(b->hi[0][k]) + fabs(b->hi[2][k])
            + fabs(c->hi[0][k]) +
                          fabs(c->hi[1][k]);
}

static void rotate_back(const row_lanes *restrict row, const two_lanes *restrict moved,
                        const double *restrict off_diagonal, int i, two_lanes *restrict out)
{
    int k;

    for (k = 0; k < LANES; k++) {
        const pov_two x = pov_two_mul(entry(row, 0, k), lane_of(&moved[0], k));
        const pov_two y = pov_two_mul(entry(row, 1, k), lane_of(&moved[1], k));
        const pov_two z = pov_two_mul(entry(row, 2, k), lane_of(&moved[2], k));
        const pov_two all = pov_two_add(pov_two_add(x, y), z);
        const pov_two single = pov_two_mul(entry(row, i, k), lane_of(&moved[i], k));

        out->hi[k] = off_diagonal[k] != 0.0 ? all.hi : single.hi;
        out->lo[k] = off_diagonal[k] != 0.0 ? all.lo : single.lo;
    }
}

/* The anchor in the shape's own space. */
static void find_own_anchor(making *m)
{
    two_lanes moved[3];
    int i, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < LANES; k++) {
            const pov_two d = pov_two_sub(pov_two_of(m->anchor[i][k], 0.0), lane_of(&m->move[i], k));
            moved[i].hi[k] = d.hi;
            moved[i].lo[k] = d.lo;
        }
    for (i = 0; i < 3; i++)
        rotate_back(&m->inverse[i], moved, m->off_diagonal, i, &m->own_anchor[i]);
}

/* As fmin() and fmax(). */
SIMD_INLINE double lesser(double a, double b) { return a < b || b != b ? a : b; }
SIMD_INLINE double greater(double a, double b) { return a > b || b != b ? a : b; }

/* From the anchor to the further side of the own box, and some: what is flat stays within the range of floats. Whether the
 * nearer side is as far, as the filter sees it, and whether a float holds all that. */
static void find_half(const making *restrict m, int i, double *restrict per_half, double *restrict snug,
                      double *restrict known)
{
    const row_lanes *row = &m->inverse[i];
    int k;

    for (k = 0; k < LANES; k++) {
        const pov_two at = lane_of(&m->own_anchor[i], k);
        const double lo = m->lo[i][k], hi = m->hi[i][k];
        const double above = pov_two_sub(pov_two_of(hi, 0.0), at).hi, below = pov_two_sub(at, pov_two_of(lo, 0.0)).hi;
        const double least = lesser(above, below) - INSTANCE_ROUNDED * (fabs(lo) + fabs(hi));
        const double across = fabs(row->hi[0][k]) * m->reach[0][k] + fabs(row->hi[1][k]) * m->reach[1][k] +
                              fabs(row->hi[2][k]) * m->reach[2][k];
        const double half = greater(greater(above, below) + INSTANCE_LEAST, INSTANCE_THIN * across);
        const double inverse = (double)(float)((1.0 - 0x1p-20) / half);
        const pov_vec3 column = { m->inverse[0].hi[i][k], m->inverse[1].hi[i][k], m->inverse[2].hi[i][k] };

        per_half[k] = inverse;
        snug[k] = half > INSTANCE_SMALL && least * inverse >= INSTANCE_SNUG ? snug[k] : 0.0;
        known[k] = half < INSTANCE_LARGE && pov_largest(column) < INSTANCE_RANGE ? known[k] : 0.0;
    }
}

static uint8_t what_is_known(const making *m, int k, uint32_t flags)
{
    if (m->known[k] == 0.0)
        return INSTANCE_UNKNOWN;
    if (!(flags & (POV_SHAPE_BOX | POV_SHAPE_SPHERE)) || m->snug[k] == 0.0)
        return INSTANCE_IN_BOX;
    return flags & POV_SHAPE_BOX ? INSTANCE_IS_BOX : INSTANCE_IS_SPHERE;
}

static void put(const making *m, int k, const instance_desc *w, instance_xform *out)
{
    const pov_affine *map = w->map;
    const two_lanes *own = m->own_anchor;
    int i;

    out->anchor = pov_vec3_of(m->anchor[0][k], m->anchor[1][k], m->anchor[2][k]);
    for (i = 0; i < 3; i++) {
        out->per_half[i] = (float)m->per_half[i][k];
        out->column[i] = pov_vec3_of(map->inv[0][i], map->inv[1][i], map->inv[2][i]);
        out->column_lo[i] = pov_vec3_of(map->inv_lo[0][i], map->inv_lo[1][i], map->inv_lo[2][i]);
    }
    out->own_anchor = pov_vec3_of(own[0].hi[k], own[1].hi[k], own[2].hi[k]);
    out->own_anchor_lo = pov_vec3_of(own[0].lo[k], own[1].lo[k], own[2].lo[k]);
    out->known = what_is_known(m, k, w->flags);
    out->axes = m->off_diagonal[k] == 0.0;
}

void instance_init_many(instance_xform *out, const instance_desc *wishes, int n)
{
    making m;
    int i, k;

    take(&m, wishes, n);
    find_off_diagonal(&m, m.off_diagonal);
    find_own_anchor(&m);
    for (k = 0; k < LANES; k++) {
        const bool finite = wishes[k < n ? k : 0].around != NULL;

        m.snug[k] = 1.0;
        m.known[k] = finite && m.reach[0][k] < INSTANCE_RANGE && m.reach[1][k] < INSTANCE_RANGE &&
                     m.reach[2][k] < INSTANCE_RANGE;
    }
    for (i = 0; i < 3; i++)
        find_half(&m, i, m.per_half[i], m.snug, m.known);
    memset(out, 0, (size_t)n * sizeof *out);
    for (k = 0; k < n; k++)
        put(&m, k, &wishes[k], &out[k]);
}

void instance_init(instance_xform *p, const pov_affine *map, const pov_box *own, const pov_box *around, uint32_t flags)
{
    const instance_desc wish = { map, own, around, flags };

    instance_init_many(p, &wish, 1);
}
