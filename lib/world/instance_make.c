#include "world/instance.h"

#include <string.h>

static inline pov_two two_of(const double hi[4], const double lo[4], int j) { return pov_two_of(hi[j], lo[j]); }

/* ---- boxes ---- */

/* One bound of a row's sum of intervals, the lower one for a side of -1, the upper one for 1: the double-double sum of
 * its terms, moved outward by more than its error (relative to the terms, 2^-96 is many times what the additions lose) and
 * rounded outward. near, far: the corners of the box, far the one on that side. */
static double bound(const double hi[4], const double lo[4], const double near[3], const double far[3], double side)
{
    pov_two sum = two_of(hi, lo, 3);
    double size = fabs(sum.hi);
    int j;

    for (j = 0; j < 3; j++) {
        const pov_two term = pov_two_mul_double(two_of(hi, lo, j), hi[j] >= 0.0 ? far[j] : near[j]);

        sum = pov_two_add(sum, term);
        size += fabs(term.hi);
    }
    return side * pov_next(side * sum.hi + size * 0x1p-96);
}

static pov_vec3 corner(const pov_affine *map, const double near[3], const double far[3], double side)
{
    return pov_vec3_of(bound(map->m[0], map->m_lo[0], near, far, side),
                       bound(map->m[1], map->m_lo[1], near, far, side),
                       bound(map->m[2], map->m_lo[2], near, far, side));
}

void instance_box(const pov_affine *map, const pov_box *own, pov_box *out)
{
    const double lo[3] = { own->lo.x, own->lo.y, own->lo.z }, hi[3] = { own->hi.x, own->hi.y, own->hi.z };

    out->lo = corner(map, hi, lo, -1.0);
    out->hi = corner(map, lo, hi, 1.0);
}

/* Difference between a sphere of this radius, or a larger one, and the box around it on either side of a world axis:
 * there the sphere reaches as far as the length of the map's row, the box as far as the sum of its sizes. Three sums
 * and a root lose less than 11 u of that sum, with the row's low parts; squares that underflow need a sum that is
 * small. */
static double falls_short(const double row[4], double radius)
{
    const double sum = fabs(row[0]) + fabs(row[1]) + fabs(row[2]);
    const double length = sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);

    return sum > 1e-140 ? pov_max(radius * (sum - length - sum * 0x1p-49), 0.0) : 0.0;
}

static void draw_in(double *lo, double *hi, double by)
{
    *lo = pov_max(*lo, -pov_next(-(*lo + by)));
    *hi = pov_min(*hi, pov_next(*hi - by));
}

void instance_shrink_box(const pov_affine *map, const pov_box *own, pov_box *around)
{
    const pov_vec3 edge = pov_sub(own->hi, own->lo);
    const double wide = INSTANCE_ROUNDED * (pov_largest(own->lo) + pov_largest(own->hi));
    const double radius = pov_max(0.5 * pov_min(edge.x, pov_min(edge.y, edge.z)) - wide, 0.0);

    draw_in(&around->lo.x, &around->hi.x, falls_short(map->m[0], radius));
    draw_in(&around->lo.y, &around->hi.y, falls_short(map->m[1], radius));
    draw_in(&around->lo.z, &around->hi.z, falls_short(map->m[2], radius));
}

/* ---- instance transforms ---- */

static bool is_diagonal(const double m[3][4])
{
    return fabs(m[0][1]) + fabs(m[0][2]) + fabs(m[1][0]) + fabs(m[1][2]) + fabs(m[2][0]) + fabs(m[2][1]) == 0.0;
}

/* A component of the anchor in the shape's own space; moved: the anchor before it is turned back. */
static pov_two turned_back(const pov_affine *map, const pov_two moved[3], bool axes, int i)
{
    const double *hi = map->inv[i], *lo = map->inv_lo[i];

    if (axes)
        return pov_two_mul(two_of(hi, lo, i), moved[i]);
    return pov_two_add(pov_two_add(pov_two_mul(two_of(hi, lo, 0), moved[0]), pov_two_mul(two_of(hi, lo, 1), moved[1])),
                       pov_two_mul(two_of(hi, lo, 2), moved[2]));
}

static void set_anchor(instance_xform *p, const pov_affine *map)
{
    const double anchor[3] = { p->anchor.x, p->anchor.y, p->anchor.z };
    pov_two moved[3], own[3];
    int i;

    for (i = 0; i < 3; i++)
        moved[i] = pov_two_sub(pov_two_of(anchor[i], 0.0), two_of(map->m[i], map->m_lo[i], 3));
    for (i = 0; i < 3; i++)
        own[i] = turned_back(map, moved, p->axes, i);
    p->own_anchor = pov_vec3_of(own[0].hi, own[1].hi, own[2].hi);
    p->own_anchor_lo = pov_vec3_of(own[0].lo, own[1].lo, own[2].lo);
}

static inline double component(pov_vec3 v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

/* Of the shape, along the axes so far. known: a float holds all halves. snug: the box reaches as far on either side. */
typedef struct halves { bool known, snug; } halves;

/* Half extent: from the anchor to the further side of the box in object space, enlarged so that thin boxes stay within
 * the range of floats. Whether the nearer side is as far, as the filter sees it, and whether a float can hold it. */
static void set_half(instance_xform *p, const pov_affine *map, const pov_box *own, pov_vec3 reach, int i, halves *found)
{
    const pov_two at = pov_two_of(component(p->own_anchor, i), component(p->own_anchor_lo, i));
    const double lo = component(own->lo, i), hi = component(own->hi, i), *row = map->inv[i];
    const double above = pov_two_sub(pov_two_of(hi, 0.0), at).hi, below = pov_two_sub(at, pov_two_of(lo, 0.0)).hi;
    const double least = pov_min(above, below) - INSTANCE_ROUNDED * (fabs(lo) + fabs(hi));
    const double across = fabs(row[0]) * reach.x + fabs(row[1]) * reach.y + fabs(row[2]) * reach.z;
    const double half = pov_max(pov_max(above, below) + INSTANCE_LEAST, INSTANCE_THIN * across);

    p->per_half[i] = (float)((1.0 - 0x1p-20) / half);
    found->snug &= half > INSTANCE_SMALL && least * (double)p->per_half[i] >= INSTANCE_SNUG;
    found->known &= half < INSTANCE_LARGE && pov_largest(p->column[i]) < INSTANCE_RANGE;
}

static uint8_t what_is_known(halves found, uint32_t flags)
{
    if (!found.known)
        return INSTANCE_UNKNOWN;
    if (!(flags & (POV_SHAPE_BOX | POV_SHAPE_SPHERE)) || !found.snug)
        return INSTANCE_IN_BOX;
    return flags & POV_SHAPE_BOX ? INSTANCE_IS_BOX : INSTANCE_IS_SPHERE;
}

void instance_init(instance_xform *p, const pov_affine *map, const pov_box *own, const pov_box *around, uint32_t flags)
{
    static const pov_box none = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
    const pov_vec3 reach = around ? pov_sub(around->hi, around->lo) : none.lo;
    halves found = { around && reach.x < INSTANCE_RANGE && reach.y < INSTANCE_RANGE && reach.z < INSTANCE_RANGE, true };
    int i;

    memset(p, 0, sizeof *p);
    p->anchor = around ? pov_add(pov_scale(around->lo, 0.5), pov_scale(around->hi, 0.5))
                       : pov_vec3_of(map->m[0][3], map->m[1][3], map->m[2][3]);
    p->axes = is_diagonal(map->inv);
    for (i = 0; i < 3; i++) {
        p->column[i] = pov_vec3_of(map->inv[0][i], map->inv[1][i], map->inv[2][i]);
        p->column_lo[i] = pov_vec3_of(map->inv_lo[0][i], map->inv_lo[1][i], map->inv_lo[2][i]);
    }
    set_anchor(p, map);
    for (i = 0; i < 3; i++)
        set_half(p, map, around ? own : &none, reach, i, &found);
    p->known = what_is_known(found, flags);
}
