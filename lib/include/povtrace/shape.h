/* povtrace/shape.h - a primitive: its parsing, its bounds, its intersection with rays.
 *
 * A new primitive needs no other header. One that is to be as fast as the built-in ones adds shape_fast.h. */
#ifndef POVTRACE_SHAPE_H
#define POVTRACE_SHAPE_H

#include <povtrace/plugin.h>

#define POV_NO_OWNER 0xffffffffu
#define POV_PREPARED_MAX 1024u

/* ---- rays and crossings ------------------------------------------------ */

/* Identifies a crossing of a shape: its feature (face, cap, root), and data for normal(). */
typedef struct pov_mark { uint32_t feature, flags; double u, v; } pov_mark;
#define POV_MARK_ESCALATED 0x80000000u /* in flags: double left the crossing open, double-double decided it */
/* In a ray's origin_mark: it goes outward, at an angle beyond rounding. In a mark that a shape reports: a ray that
 * starts there, on either side and at any angle, never hits the shape again. */
#define POV_MARK_OUTWARD 0x40000000u
#define POV_MARK_INWARD 0x20000000u    /* in a ray's origin_mark: it goes inward, at an angle beyond rounding */
#define POV_MARK_CLOSED 0x10000000u    /* in flags: the shape is bounded, convex and without gaps */

/* A ray starts at the unevaluated sum org + org_lo, so that a start on a small object far from the origin is accurate
 * enough to be distinguished from its surface. */
typedef struct pov_ray {
    pov_vec3 org, org_lo, dir;   /* dir need not be unit */
    uint32_t origin_surface;     /* the owner whose surface the ray starts on, or POV_NO_OWNER */
    pov_mark origin_mark;        /* the mark of that crossing: intersect() leaves out that root */
    pov_vec3 dir_lo;             /* the direction is dir + dir_lo; zero unless the ray was transformed, or goes to a point */
} pov_ray;

/* A crossing lies at the unevaluated sum t + t_lo. */
typedef struct pov_crossing {
    double t, t_lo;
    uint32_t owner;          /* stamped by pov_cross() */
    pov_mark mark;
} pov_crossing;

typedef enum pov_want { POV_WANT_NEAREST, POV_WANT_ANY, POV_WANT_ALL } pov_want;

/* The sink of intersect(). tmin is fixed; tmax decreases as hits are found. */
typedef struct pov_hits {
    double tmin, tmax;             /* open interval */
    pov_want want;
    bool always_exact;             /* use double-double arithmetic throughout */
    bool count_only;               /* ALL: t may be inaccurate, as long as each crossing is definitely in the interval */
    uint32_t owner;                /* the tested object: compare with ray->origin_surface */
    uint32_t count, capacity;
    uint32_t escalated;            /* add one for each crossing or miss that double-double decided */
    pov_crossing *at;              /* one slot, or `capacity` of them for POV_WANT_ALL */
    bool (*grow)(struct pov_hits *hits);
    void *user;                    /* the host's */
    bool tied;                     /* NEAREST: another owner's crossing is as near within POV_COINCIDENT */
    void *scratch;                 /* working memory of this thread, of the size that scratch() returns */
    double slack;                  /* where above zero: crossings so near tmax only set near_end; the host decides */
    bool near_end;
    bool unfiltered;               /* with always_exact: sides of edges, too, though what filters say of them is certain */
} pov_hits;

/* Distances that differ by less than this fraction may be equal: twice the error of crossings, with a margin. */
#define POV_COINCIDENT (1.0 / 70368744177664.0)   /* 2^-46 */

/* Is a crossing before the end of the interval? Within the slack of it, that stays open. */
static inline bool pov_is_before_end(pov_hits *h, double t, double t_lo)
{
    if (!(h->slack > 0.0))
        return t < h->tmax;
    h->near_end = h->near_end || fabs((h->tmax - t) - t_lo) < h->slack;
    return (h->tmax - t) - t_lo > h->slack;
}

/* Is the crossing nearer than the one found so far? Of equal ones the earlier object of the scene wins, so that the
 * result does not depend on the order of tests. (The host compares again where it is tied: docs/numerics.md.) */
static inline bool pov_is_nearer(pov_hits *h, double t, double t_lo)
{
    if (h->count == 0)
        return pov_is_before_end(h, t, t_lo);
    if (t != h->at->t)
        return t < h->at->t;
    if (t_lo != h->at->t_lo)
        return t_lo < h->at->t_lo;
    return h->owner < h->at->owner;
}

/* Note a tie with the nearest crossing so far; a crossing that is clearly nearer ends it. */
static inline void pov_note_coincident(pov_hits *h, double t)
{
    if (fabs(t - h->at->t) <= POV_COINCIDENT * fabs(t))
        h->tied = h->tied || h->owner != h->at->owner;
    else if (t < h->at->t)
        h->tied = false;
}

/* Report a crossing. False: nothing more is wanted, return at once. */
static inline bool pov_cross(pov_hits *h, double t, double t_lo, pov_mark mark)
{
    pov_crossing *c = h->at;

    if (!(t > h->tmin || (t == h->tmin && t_lo > 0.0)))
        return true;
    if (h->want == POV_WANT_ALL) {
        if (!pov_is_before_end(h, t, t_lo))
            return true;
        if (h->count == h->capacity && !h->grow(h))
            return false;
        c = &h->at[h->count++];
    } else {
        if (h->count)
            pov_note_coincident(h, t);
        if (!pov_is_nearer(h, t, t_lo))
            return true;
        h->count = 1;
        h->tmax = t + POV_COINCIDENT * fabs(t);   /* keeps coincident crossings in the interval */
    }
    c->t = t;
    c->t_lo = t_lo;
    c->owner = h->owner;
    c->mark = mark;
    return h->want != POV_WANT_ANY;
}

/* ---- a primitive --------------------------------------------------------
 *
 * Order of calls: parse, prepare, absorb at most once, bounds, then only [render].
 * An instance is plain bytes: the host copies it with memcpy for every use of a
 * #declared object. So it has no destructor, memory it points to comes from
 * host->alloc and is never written after parse, and absorb changes only the
 * instance's own bytes. */

#define POV_NORMALS_MAX 4u              /* most normals that are blended into one */
#define POV_TEXTURES_MAX 8u             /* most textures of a point of a surface */
#define POV_OWN_TEXTURE 0xffffffffu     /* the object's, in place of a number */

enum {
    POV_SHAPE_SOLID = 1u << 0,   /* inside() is valid: it may be a dielectric and take part in CSG */
    POV_SHAPE_CONVEX = 1u << 1,  /* a ray that leaves it outward never meets it again: it lies on one side of each tangent plane */
    /* It fills its bounds, or is the sphere inscribed in them, except for the outward rounding of bounds: up to eight
     * units in the last place of the coordinates. Hosts that know better bounds may use them. */
    POV_SHAPE_BOX = 1u << 2,
    POV_SHAPE_SPHERE = 1u << 3,
    POV_SHAPE_FACETED = 1u << 4, /* its faces are planar: normal() ignores the ray */
    /* No hit or miss is wrong, and each distance t + t_lo is off by at most 32 units in the last place of t, the point
     * there by 2^-42 of the shape's size, from however far and at whatever scale (docs/numerics.md). The contract's
     * tests verify it. */
    POV_SHAPE_CERTIFIED = 1u << 5,
    POV_SHAPE_ENDLESS = 1u << 6  /* what is inside() of it reaches beyond its bounds */
};

/* A triangle, its unit normal, and what is at its corners: unit normals that light sees, surface coordinates. */
typedef struct pov_face { pov_vec3 corners[3], normal, normals[3]; double uv[3][2]; } pov_face;

typedef struct pov_shape_class {
    uint32_t size, flags;
    const char *keyword;
    size_t instance_size;    /* the host reserves it: zeroed, aligned to 32 bytes */

    /* [load] Parse the text between the braces, up to the first object modifier. The host reads the keyword, both
     * braces and the modifiers. */
    void (*parse)(void *self, const pov_host *host, pov_reader *in);
    /* [load] [render] A box that holds every point of the shape, rounded outward. False: no finite box. */
    bool (*bounds)(const void *self, pov_box *out);
    /* [render] Report every crossing of the open interval, in any order, except the one that the ray starts on. */
    void (*intersect)(const void *self, const pov_ray *ray, pov_hits *hits);
    /* [render] Unit normal, pointing out of a solid. Only for crossings that are used. The point is recomputed from the
     * ray, re-centred on the shape: a rounded world point would be too inaccurate far out. */
    void (*normal)(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);

    /* Any of these may be NULL or zero. */

    /* [render] Needed for POV_SHAPE_SOLID. The point is the sum of both parts. */
    bool (*inside)(const void *self, pov_vec3 point, pov_vec3 point_lo);
    /* [load] Absorb the transformation into the shape, as exactly as a shape written so, or return false and leave the
     * shape unchanged. */
    bool (*absorb)(void *self, const pov_affine *map);
    /* [load] For classes whose instance is larger than its parsed form: parse gets parsed_size zeroed bytes in its
     * place, and prepare makes an instance of at most POV_PREPARED_MAX bytes of them, which comes zeroed. It is called
     * again, from several threads, wherever the host would have to store one. */
    size_t parsed_size;
    void (*prepare)(void *self, const void *parsed);
    /* [render] Surface coordinates, usually 0 to 1, of a point on the surface in the space in which the shape was
     * written; mark is the crossing's. */
    void (*uv)(const void *self, pov_vec3 point, const pov_mark *mark, double out[2]);
    /* [load] Bytes that intersect() needs in hits->scratch, aligned to 64; their initial contents are undefined. */
    size_t (*scratch)(const void *self);
    /* Any thread. An extension by its name, or NULL: shape_fast.h has one. Valid while the plugin is loaded. */
    const void *(*extension)(const char *name);
    /* [load] For solids: has the surface gaps, through which a ray enters without a crossing? NULL: none has. */
    bool (*open)(const void *self);
    /* abi 4 began with these. The point of the following ones is the sum of both parts, in the space of the instance. */

    /* [load] For POV_SHAPE_SOLID: is this shape a solid? Of what parse() wrote. NULL: every one is. */
    bool (*solid)(const void *self);
    /* [render] Where light sees another normal than normal() gives: up to POV_NORMALS_MAX unit normals and their shares,
     * and how many. The host blends them in the space of the scene, where it makes them unit again. 0: it is that one. */
    uint32_t (*shading_normals)(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark,
                                pov_vec3 *normal, double *share);
    /* [render] Textures of a part of the surface: up to POV_TEXTURES_MAX numbers that host->texture() gave or
     * POV_OWN_TEXTURE, and their shares, which add up to one. Returns how many; 0: the object's own texture. NULL: every
     * part has that. */
    uint32_t (*textures)(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark, uint32_t *which,
                         double *share);
    /* [load] [render] For shapes made of triangles: the face of this number, from 0, in the order of the text. False: there is none. */
    bool (*face)(const void *self, uint32_t number, pov_face *out);
    /* [render] Is the front of the surface at a crossing, where interior_texture is not seen, the side that normal() points
     * away from? NULL: nowhere. */
    bool (*reversed)(const void *self, const pov_ray *ray, const pov_crossing *at);
} pov_shape_class;

#endif
