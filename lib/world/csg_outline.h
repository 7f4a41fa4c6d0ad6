/* csg_outline.h - where a ray crosses the slabs and quadrics of an outline: of one ray with several of them side by side, and of
 * several rays with one. docs/numerics.md ("Outlines") derives the constants; lengths are in units of the tree's size. */
#ifndef WORLD_CSG_OUTLINE_H
#define WORLD_CSG_OUTLINE_H

#include "base/simd.h"
#include "world/csg_traversal.h"

#define CSG_FARTHEST 0x1p26        /* rays from beyond, and trees as far from the origin, are left to others */
#define CSG_LEAST_SLOPE 0x1p-22    /* a ray along a slab crosses it far from the tree, */
#define CSG_LEAST_HEIGHT 0x1p-17   /* unless it runs this near to one of its ends */
#define CSG_LEAST_SQUARE 0x1p-20
#define CSG_LEAST_CHORD 0x1p-22
#define CSG_LEAST_MISS 0x1p-40

/* Numbers stand side by side by four slabs, or four quadrics: the index of the first of one, whose others follow four by four. */
enum { CSG_SLAB_NUMBERS = 5, CSG_QUADRIC_NUMBERS = 10, CSG_FOUR = 4 };
static inline uint32_t csg_number(uint32_t each, uint32_t i) { return i / CSG_FOUR * CSG_FOUR * each + i % CSG_FOUR; }

/* A candidate's note: the column of its crossing, and bits that say which one it is, of the member and of the tree. */
enum { CSG_NOTE_COLUMN = 0xff, CSG_NOTE_ENTERS = 0x100, CSG_NOTE_INWARD = 0x200 };

/* Where a ray is within; open is not 0 where that is not known. square, of a quadric: below zero a ray is within where it is not
 * between the two. */
typedef struct csg_stretch { double in, out, open, square; } csg_stretch;

/* least: a ray along the slab must be so far from both ends. */
SIMD_INLINE csg_stretch csg_cross_slab(const double *of, pov_vec3 p, pov_vec3 d, double least)
{
    const double x = of[0], y = of[CSG_FOUR], z = of[2 * CSG_FOUR];
    const double height = x * p.x + y * p.y + z * p.z, along = x * d.x + y * d.y + z * d.z, size = fabs(along);
    const double slope = size > 1e-30 ? along : 1e-30, lo = of[3 * CSG_FOUR] - height, hi = of[4 * CSG_FOUR] - height;
    const double inverse = 1.0 / slope, a = lo * inverse, b = hi * inverse;
    const double nearest = fabs(lo) < fabs(hi) ? fabs(lo) : fabs(hi);
    const csg_stretch s = { a < b ? a : b, a < b ? b : a, size < CSG_LEAST_SLOPE ? nearest < least ? 1.0 : 0.0 : 0.0, 0.0 };

    return s;
}

/* A quadric a t^2 + 2 b t + c along a ray. from: how far the ray's start is from the middle, where that matters. */
SIMD_INLINE csg_stretch csg_cross_roots(double a, double b, double c, double from)
{
    const double within = b * b - a * c, root = sqrt(within > 0.0 ? within : 0.0), size = fabs(a);
    const double inverse = 1.0 / (size > CSG_LEAST_SQUARE ? size : 1.0), middle = (a > 0.0 ? -b : b) * inverse;
    const double missed = within < -CSG_LEAST_MISS * from * from ? HUGE_VAL : 0.0;
    const double clear = root * size + missed;
    const double known = size > CSG_LEAST_SQUARE ? clear - CSG_LEAST_CHORD * from : -1.0;
    const csg_stretch s = { middle - root * inverse + missed, middle + root * inverse - missed, known > 0.0 ? 0.0 : 1.0, a };

    return s;
}

SIMD_INLINE csg_stretch csg_cross_quadric(const double *of, pov_vec3 p, pov_vec3 d, double from)
{
    enum { N = CSG_FOUR };
    const double xx = of[0], yy = of[N], zz = of[2 * N], xy = of[3 * N], xz = of[4 * N], yz = of[5 * N];
    const double lx = of[6 * N], ly = of[7 * N], lz = of[8 * N];
    const double dx = xx * d.x + xy * d.y + xz * d.z, dy = xy * d.x + yy * d.y + yz * d.z, dz = xz * d.x + yz * d.y + zz * d.z;
    const double px = xx * p.x + xy * p.y + xz * p.z, py = xy * p.x + yy * p.y + yz * p.z, pz = xz * p.x + yz * p.y + zz * p.z;
    const double a = dx * d.x + dy * d.y + dz * d.z, b = dx * p.x + dy * p.y + dz * p.z + lx * d.x + ly * d.y + lz * d.z;
    const double c = (px + 2.0 * lx) * p.x + (py + 2.0 * ly) * p.y + (pz + 2.0 * lz) * p.z + of[9 * N];

    return csg_cross_roots(a, b, c, from);
}

/* Of one that is a sphere, or turned about an axis. square: of p, which is square to d. */
SIMD_INLINE csg_stretch csg_cross_turned(const double *of, const csg_turned *by, bool has_axis, pov_vec3 p, pov_vec3 d, double square)
{
    enum { N = CSG_FOUR };
    const double lx = of[6 * N], ly = of[7 * N], lz = of[8 * N];
    double a = by->all, b = lx * d.x + ly * d.y + lz * d.z;
    double c = by->all * square + 2.0 * (lx * p.x + ly * p.y + lz * p.z) + of[9 * N];
    csg_stretch s;

    if (has_axis) {
        const double along = by->axis.x * d.x + by->axis.y * d.y + by->axis.z * d.z;
        const double height = by->axis.x * p.x + by->axis.y * p.y + by->axis.z * p.z;

        a += by->of_axis * along * along;
        b += by->of_axis * along * height;
        c += by->of_axis * height * height;
    }
    s = csg_cross_roots(a, b, c, 1.0);
    s.open = a < 0.0 ? 1.0 : s.open;
    return s;
}

#endif
