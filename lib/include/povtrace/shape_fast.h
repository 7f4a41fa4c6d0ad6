/* povtrace/shape_fast.h - a primitive's fast extension: packets of rays and blocks of shapes.
 *
 * Unstable: it follows the renderer's own layout, and its name changes with each version. A host that does not know the
 * name does without; results must be bit-identical either way. A class returns it from extension(). */
#ifndef POVTRACE_SHAPE_FAST_H
#define POVTRACE_SHAPE_FAST_H

#include <povtrace/shape.h>

#define POV_SHAPE_FAST "povtrace.shape_fast.1"
#define POV_BLOCK_MAX 8u    /* most shapes one block holds */
#define POV_RAYS_MAX 64u    /* most rays that block_filter() is asked for */

/* Blocks may hold floats, in a frame: a world point p is (p - centre) * scale there, with a power of two for the scale.
 * All contents of a block lie in the cube -1..1. */
typedef struct pov_frame { pov_vec3 centre; double scale; } pov_frame;

/* Rays as a structure of arrays for block_filter(), one in each lane. The host stores only rays in the range of
 * squares: org below 1e100, components of dir zero or of 1e-80 to 1e80. The
 * low part of the direction, half a unit in the last place at most, is left out. */
typedef struct pov_rays {
    double org[3][POV_RAYS_MAX], org_lo[3][POV_RAYS_MAX], dir[3][POV_RAYS_MAX];
    double inverse[POV_RAYS_MAX];      /* 1 / dir.dir, rounded */
    double per_length[POV_RAYS_MAX];   /* its root: the t of a length of one */
    double size[POV_RAYS_MAX];         /* |org.x| + |org.y| + |org.z| */
    double tmax[POV_RAYS_MAX];
    uint32_t excluded[POV_RAYS_MAX];   /* the object that the ray cannot hit (POV_MARK_OUTWARD), or POV_NO_OWNER */
    /* The same in the frame of the block, rounded to floats; the point s along dir is at t = shift + s * unit. */
    struct {
        float org[3][POV_RAYS_MAX];
        float dir[3][POV_RAYS_MAX];    /* a unit vector */
        float size[POV_RAYS_MAX];      /* |org.x| + |org.y| + |org.z| + 2^-22 |shift| / unit; infinite: nothing is
                                        * known */
        float smax[POV_RAYS_MAX];      /* of tmax, rounded up by less than 2^-21 of it and 2^-44 |shift| / unit */
        double shift[POV_RAYS_MAX], unit[POV_RAYS_MAX];
    } local;
    const pov_ray *const *rays;        /* the host's, for what it filters itself */
} pov_rays;

/* A shape of a block that a ray may hit within its interval, with bounds on the nearest crossing there. Bounds may be
 * wide; they must never be wrong. Blocks do not know the root that a ray starts on. */
typedef struct pov_candidate {
    double lo, hi;               /* hi is valid for definite hits only */
    uint8_t ray, lane;           /* lanes of the rays, and of the block */
    bool definite;               /* a definite hit */
    bool definite_pair;          /* with exactly two crossings */
    uint32_t note;               /* the host's, of what it filters itself */
} pov_candidate;
#define POV_CANDIDATES_MAX (POV_RAYS_MAX * POV_BLOCK_MAX)

/* An ellipsoid: its centre, in double-double, and rows of the map from points relative to the centre to the unit
 * sphere. For points on the surface the mapped length is one within 2^-20. */
typedef struct pov_ellipsoid { pov_vec3 centre, centre_lo, row[3]; } pov_ellipsoid;

/* The points p with normal . p <= distance; the normal is a unit vector. */
typedef struct pov_half_space { pov_vec3 normal; double distance; } pov_half_space;
enum { POV_HULL_MAX = 6 };

/* A solid: what slabs, each of lo <= normal . w <= hi, and a quadric have in common, w from the centre. The quadric is
 * w . (square w) + 2 linear . w + constant <= 0, its square by xx, yy, zz, xy, xz, yz. Normals need not be unit vectors. All may be
 * rounded: surfaces of a bounded convex solid are where they are within 2^-44 of its size and of the centre's distance from the
 * origin. A half-space, by a slab with an infinite end, and a quadric are off by as much for points and a centre of that size. */
typedef struct pov_outline {
    pov_vec3 centre, normal[3];
    double lo[3], hi[3], square[6], constant;
    pov_vec3 linear;
    uint32_t slabs;
    bool round;                  /* it has a quadric */
} pov_outline;

/* The map to an instanced shape's own space, rounded: column (p - anchor) + from. */
typedef struct pov_own_map { pov_vec3 anchor, column[3], from; } pov_own_map;

/* Where a crossing is: the sum of both points, org + t dir in double-double, and the shape's normal there. */
typedef struct pov_contact { pov_vec3 point, point_lo, normal; } pov_contact;

typedef struct pov_shape_fast {
    uint32_t size;
    bool full_leaves;            /* block_filter takes as long for one shape of a block as for all: leaves should be
                                  * full */
    size_t block_size;
    size_t single_block_size;    /* bytes of a block with a single shape, if they are fewer; else 0 */
    /* Any of these may be NULL.
     *
     * [load] [render] Up to POV_BLOCK_MAX shapes of this class side by side in the plugin's own layout,
     * 64-byte aligned: a quick filter before intersect(), which the host calls for every candidate.
     * block_pack returns false to decline (values out of its range, or no gain); frame is NULL for shapes without bounds.
     * block_filter tests each ray that has a bit in `lanes`, at least one, from 0 to its tmax, writes the shapes that it
     * may hit to out, in any order, no pair of ray and lane twice, and returns their number. owners has POV_BLOCK_MAX
     * entries; a convex shape may be omitted for a ray that leaves it outward. */
    bool (*block_pack)(void *block, const pov_frame *frame, const void *const *selves, uint32_t n);
    uint32_t (*block_filter)(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                             pov_candidate *out);
    /* [render] As n calls of intersect(), and of normal(), bit for bit: pair i is shape i with ray i. For packets,
     * where several side by side cost less than single ones; n is at least one. */
    void (*intersect_many)(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
    void (*normal_many)(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                        pov_vec3 *const *out, uint32_t n);
    /* [render] As intersect_many() for the nearest crossing of definite hits: the test for a hit may be left out. No
     * ray starts on its shape. */
    void (*cross_many)(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
    /* [load] Is it an ellipsoid, with such bounds? Hosts may filter its rays by that if no block does. */
    bool (*ellipsoid)(const void *self, pov_ellipsoid *out);
    /* [load] [render] Is it a half-space? Rounded: hosts allow for that where they bound solids made of several. */
    bool (*half_space)(const void *self, pov_half_space *out);
    /* [load] Up to POV_HULL_MAX half-spaces that hold the part of an infinite solid that lies within the n given ones. */
    uint32_t (*hull)(const void *self, const pov_half_space *within, uint32_t n, pov_half_space *out);
    /* [load] [render] Is it such a solid? Solids made of several then look for a ray's crossing in all side by side. */
    bool (*outline)(const void *self, pov_outline *out);
    /* [render] As intersect(), where the interval comes from the scene around the shape and depends on nothing but the
     * ray: it may shorten the search, and last bits of crossings may depend on it. */
    void (*intersect_between)(const void *self, const pov_ray *ray, pov_hits *hits);
    /* [render] As n calls of intersect_between(), bit for bit, as intersect_many(). */
    void (*intersect_between_many)(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
    /* [render] A closer look at candidates of an instanced shape, by its box: leaves out those that certainly pass it, narrows the
     * bounds of others, and returns how many are left. A ray whose origin_surface is `owner` starts on it. */
    uint32_t (*narrow)(const void *self, const pov_own_map *map, uint32_t owner, const pov_rays *rays, pov_candidate *io, uint32_t n);
    /* [load] Of what parse() wrote, where several texts are one solid: makes it that of one of them, whichever it was. Hosts find so
     * which shapes are the same; nothing else is made of it. */
    void (*reorder)(void *parsed);
    /* [render] Normals at the points of crossings, for shapes that have absorbed all of their transformations: as normal() has them, but for the
     * last bit where that is a matter of rounding. A point is points[i][0] + points[i][1], in memory that goes on for another
     * two doubles at least; n is at least one. */
    void (*normal_at_many)(const void *const *selves, const pov_vec3 *const *points, pov_vec3 *const *out, uint32_t n);
    /* [render] As cross_many() without a sink, where a ray has nothing but its definite hit in an interval that begins at zero, or, if the first
     * ray's origin_surface is at[0]->owner, where each starts on its closed shape and goes into it, so that it has its exit: the crossing
     * of pair i is written to at[i], but for its owner, and if contacts is not NULL its point and normal to contacts[i], as normal_at_many()
     * has it if the class has that. n is 1 to POV_RAYS_MAX. Bit i: pair i is left open, whatever was written. */
    uint64_t (*cross_sure)(const void *const *selves, const pov_ray *const *rays, pov_crossing *const *at, pov_contact *const *contacts, uint32_t n);
    /* [load] [render] Is it all that lies at most radii[1] from a circle of the radius radii[0] around the y axis of its own space, and
     * its surface where that ends? Radii may be rounded, as an outline is. */
    bool (*ring)(const void *self, double radii[2]);
    /* [render] For classes whose shapes have one crossing with a ray, and none with one that starts on them: bounds on it for shape `lane` of a
     * block, for each ray that has a bit in `lanes`, all of which block_filter() may be asked for. It is not outside lo[i] to hi[i], and it is
     * there if 0 < lo[i]. lo and hi have POV_RAYS_MAX entries; entries of other rays may be written. */
    void (*block_bounds)(const void *block, uint32_t lane, const pov_rays *rays, uint64_t lanes, double *lo, double *hi);
    /* [render] As n calls of shading_normals(), bit for bit, for classes that blend one normal at most: out[i] and how many, 0 or 1; the
     * share is 1. Point i is points[i] + points_lo[i]; n is at least one. */
    void (*shading_normals_many)(const void *const *selves, const pov_vec3 *points, const pov_vec3 *points_lo, const pov_mark *const *marks,
                                 uint32_t n, pov_vec3 *out, uint32_t *count);
} pov_shape_fast;

#endif
