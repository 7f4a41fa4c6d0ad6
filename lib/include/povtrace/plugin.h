/* povtrace/plugin.h - the contract between libpovtrace and a plugin.
 *
 * A plugin is a shared object named after its scene keyword (primitives/torus.so) or file ending (images/png.so),
 * linked against nothing of povtrace, exporting one data symbol. Nothing in it runs when it is loaded. Growth is by
 * appending members: each side reads only as many bytes as the other side's `size` says are there.
 *
 * [load]   called on the thread that loads a scene; several scenes may load at once, each with instances of its own.
 * [render] called from many threads at once on the same const object: no writes, statics, locks, allocation. */
#ifndef POVTRACE_PLUGIN_H
#define POVTRACE_PLUGIN_H

#include <povtrace/base.h>
#include <povtrace/image.h>
#include <povtrace/math.h>
#include <povtrace/plot.h>

#define POV_PLUGIN_ABI 2u   /* raised only when an old plugin could not work */
#define POV_BLOCK_MAX 8u    /* most shapes one block holds */
#define POV_NOBODY 0xffffffffu
#define POV_PREPARED_MAX 1024u
#define POV_RAYS_MAX 64u    /* most rays that block_filter() is asked for */

/* ---- rays and crossings ------------------------------------------------ */

/* What names a crossing of a shape again: which part of it (face, cap, root), and what normal() wants to know. */
typedef struct pov_mark { uint32_t part, flags; double u, v; } pov_mark;
#define POV_MARK_DECIDED 0x80000000u   /* in flags: double left the crossing open, two-part arithmetic decided */
/* In a ray's left_mark: it goes outward, at an angle that is no matter of rounding. In a mark that a shape reports: whoever
 * leaves it there, to either side and at any angle, never comes back. */
#define POV_MARK_AWAY 0x40000000u
#define POV_MARK_INTO 0x20000000u      /* in a ray's left_mark: it goes inward, as surely */
#define POV_MARK_CLOSED 0x10000000u    /* in flags: of a shape that is bounded, convex and without gaps */

/* A ray starts at the unevaluated sum org + org_lo, so that a start on a small
 * object far from the origin is exact enough to be told from its surface. */
typedef struct pov_ray {
    pov_vec3 org, org_lo, dir;   /* dir need not be unit */
    uint32_t left;               /* the owner whose surface the ray starts on, or POV_NOBODY */
    pov_mark left_mark;          /* the mark of that crossing: intersect() leaves out that root by name */
    pov_vec3 dir_lo;             /* the direction is dir + dir_lo: zero, but where a map was applied to a ray */
} pov_ray;

/* A crossing lies at the unevaluated sum t + t_lo. */
typedef struct pov_crossing {
    double t, t_lo;
    uint32_t owner;          /* stamped by pov_cross() */
    pov_mark mark;
} pov_crossing;

typedef enum pov_want { POV_WANT_NEAREST, POV_WANT_ANY, POV_WANT_ALL } pov_want;

/* Where intersect() reports. tmin is fixed; tmax closes in as hits are found. */
typedef struct pov_hits {
    double tmin, tmax;             /* open interval */
    pov_want want;
    bool always_exact;             /* use two-part arithmetic throughout, whatever the filter says */
    bool count_only;               /* ALL: t may be off, as long as what is reported lies in the interval for certain */
    uint32_t owner;                /* whom the host asks: compare with ray->left */
    uint32_t count, capacity;
    uint32_t decided;              /* add one for each crossing or miss that two-part arithmetic had to decide */
    pov_crossing *at;              /* one slot, or `capacity` of them for POV_WANT_ALL */
    bool (*grow)(struct pov_hits *hits);
    void *user;                    /* the host's */
    bool crowded;                  /* NEAREST: another owner's crossing is as near, as far as doubles tell */
} pov_hits;

/* Distances that differ by less than this part of them may be the same: twice what crossings may be off by, and some. */
#define POV_NEAR (1.0 / 70368744177664.0)   /* 2^-46 */

/* Is the crossing nearer than the one found so far? Of equal ones the earlier object of the scene wins, so that
 * the answer does not depend on the order of asking. (The host looks again at what is as near: docs/numerics.md.) */
static inline bool pov_is_nearer(const pov_hits *h, double t, double t_lo)
{
    if (h->count == 0)
        return t < h->tmax;
    if (t != h->at->t)
        return t < h->at->t;
    if (t_lo != h->at->t_lo)
        return t_lo < h->at->t_lo;
    return h->owner < h->at->owner;
}

/* Take note of one that is about as near as the nearest so far, and of the first that is clearly nearer. */
static inline void pov_note_company(pov_hits *h, double t)
{
    if (fabs(t - h->at->t) <= POV_NEAR * fabs(t))
        h->crowded = h->crowded || h->owner != h->at->owner;
    else if (t < h->at->t)
        h->crowded = false;
}

/* Report a crossing. False: nothing more is wanted, return at once. */
static inline bool pov_cross(pov_hits *h, double t, double t_lo, pov_mark mark)
{
    pov_crossing *c = h->at;

    if (!(t > h->tmin || (t == h->tmin && t_lo > 0.0)))
        return true;
    if (h->want == POV_WANT_ALL) {
        if (!(t < h->tmax))
            return true;
        if (h->count == h->capacity && !h->grow(h))
            return false;
        c = &h->at[h->count++];
    } else {
        if (h->count)
            pov_note_company(h, t);
        if (!pov_is_nearer(h, t, t_lo))
            return true;
        h->count = 1;
        h->tmax = t + POV_NEAR * fabs(t);   /* open for company */
    }
    c->t = t;
    c->t_lo = t_lo;
    c->owner = h->owner;
    c->mark = mark;
    return h->want != POV_WANT_ANY;
}

/* Blocks may hold floats, in a frame: a point p of the world is (p - centre) * scale there, with a power of two for the
 * scale. All that a block holds lies in the cube -1..1. */
typedef struct pov_frame { pov_vec3 centre; double scale; } pov_frame;

/* Rays side by side for block_filter(), each in a lane of its own. The host puts only such rays there as are in the
 * range of squares: org below 1e100, components of dir zero or of 1e-80 to 1e80, dir_lo zero. */
typedef struct pov_rays {
    double org[3][POV_RAYS_MAX], org_lo[3][POV_RAYS_MAX], dir[3][POV_RAYS_MAX];
    double inverse[POV_RAYS_MAX];      /* 1 / dir.dir, rounded */
    double per_length[POV_RAYS_MAX];   /* its root: the t of a length of one */
    double size[POV_RAYS_MAX];         /* |org.x| + |org.y| + |org.z| */
    double tmax[POV_RAYS_MAX];
    uint32_t away[POV_RAYS_MAX];       /* whom the ray need not be asked of (POV_MARK_AWAY), or POV_NOBODY */
    /* The same in the frame of the block, rounded to floats; the point s along dir is at t = shift + s * unit. */
    struct {
        float org[3][POV_RAYS_MAX];
        float dir[3][POV_RAYS_MAX];    /* a unit vector */
        float size[POV_RAYS_MAX];      /* |org.x| + |org.y| + |org.z| + 2^-22 |shift| / unit; without end: nothing is known */
        float smax[POV_RAYS_MAX];      /* of tmax, rounded up by less than 2^-21 of it and 2^-44 |shift| / unit */
        double shift[POV_RAYS_MAX], unit[POV_RAYS_MAX];
    } framed;
} pov_rays;

/* A shape of a block that a ray may cross within its interval, with bounds on its nearest crossing there. Bounds may be
 * wide; they must never be wrong. Of the root that a ray leaves a block knows nothing. */
typedef struct pov_meeting {
    double lo, hi;               /* hi counts only where it is surely crossed */
    uint8_t ray, lane;           /* lanes of the rays, and of the block */
    bool surely;                 /* it is crossed for certain, */
    bool twice;                  /* and just twice */
} pov_meeting;
#define POV_MEETINGS_MAX (POV_RAYS_MAX * POV_BLOCK_MAX)

/* ---- what the host offers while a scene loads --------------------------- */

typedef struct pov_reader pov_reader;

/* Errors stick: after the first, every read gives zero, every accept() gives
 * false, more() gives false and warn() says nothing, so a parse function needs no checks. */
typedef struct pov_host {
    uint32_t abi, size;
    void *(*alloc)(pov_reader *in, size_t bytes);   /* zeroed, lives as long as the scene; NULL after an error */
    double (*number)(pov_reader *in);
    void (*vector)(pov_reader *in, pov_vec3 *out);
    bool (*accept)(pov_reader *in, const char *word);  /* a keyword or a mark */
    void (*expect)(pov_reader *in, const char *word);
    bool (*more)(pov_reader *in);                      /* does a value come next? */
    void (*fail)(pov_reader *in, const char *format, ...) POV_PRINTF(2, 3);   /* at the last value read */
    void (*warn)(pov_reader *in, const char *format, ...) POV_PRINTF(2, 3);
    /* abi 2 began with these. */
} pov_host;

/* ---- a primitive --------------------------------------------------------
 *
 * Order of calls: parse, prepare, absorb at most once, bounds, then only [render].
 * An instance is plain bytes: the host copies it with memcpy for every use of a
 * #declared object. So it has no destructor, memory it points to comes from
 * host->alloc and is never written after parse, and absorb changes only the
 * instance's own bytes. */

enum {
    POV_SHAPE_SOLID = 1u << 0,   /* inside() means something: may be a medium, may take part in CSG */
    POV_SHAPE_CONVEX = 1u << 1,  /* who leaves it outward never comes back: it lies on one side of each tangent plane */
    /* It fills its bounds, or is the ball within them, but for what rounding them outward adds: up to eight units in the
     * last place of the coordinates. Hosts that know better may look for more than bounds say. */
    POV_SHAPE_BOX = 1u << 2,
    POV_SHAPE_BALL = 1u << 3,
    POV_SHAPE_FACES = 1u << 4,   /* its sides are flat: normal() does not look at the ray */
    POV_SHAPE_TOGETHER = 1u << 5 /* block_filter takes as long for one shape of a block as for all: it should be full */
};

/* An ellipsoid: its centre, in two parts, and rows of the map that takes points seen from there to the ball of radius one
 * around zero. On the surface the length that comes of that is one within 2^-20. */
typedef struct pov_ellipsoid { pov_vec3 centre, centre_lo, row[3]; } pov_ellipsoid;

typedef struct pov_shape_class {
    uint32_t size, flags;
    const char *keyword;
    size_t instance_size;    /* the host reserves it: zeroed, aligned to 32 bytes */

    /* [load] Read what stands between the braces, up to the first object
     * modifier. The host eats the keyword, both braces and the modifiers. */
    void (*parse)(void *self, const pov_host *host, pov_reader *in);
    /* [load] A box that holds every point of the shape, rounded outward. False: no finite box. */
    bool (*bounds)(const void *self, pov_box *out);
    /* [render] Report every crossing of the open interval, in any order, but for the one the ray left. */
    void (*intersect)(const void *self, const pov_ray *ray, pov_hits *hits);
    /* [render] Unit normal, pointing out of a solid. Only for hits that count. The point is found
     * again from the ray, re-centred on the shape: a rounded world point would be too coarse far out. */
    void (*normal)(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);

    /* Any of these may be NULL. */

    /* [render] Needed for POV_SHAPE_SOLID. The point is the sum of both parts. */
    bool (*inside)(const void *self, pov_vec3 point, pov_vec3 point_lo);
    /* [load] Take the transform into the shape itself, as exactly as a fresh shape would be, or return false and
     * leave it be. */
    bool (*absorb)(void *self, const pov_affine *map);
    /* [load] [load] [render] Up to POV_BLOCK_MAX shapes of this class side by side in the plugin's own layout,
     * 64-byte aligned: a quick filter before intersect(), which the host asks for every lane still in question.
     * block_pack returns false to decline (values out of its range, or no gain); frame is NULL for shapes without bounds.
     * block_filter looks from 0 to its tmax along each ray that `lanes` has a bit for, one at least, puts whom it may
     * meet into out, in any order, no ray and lane twice, and gives how many. owners has room for POV_BLOCK_MAX; a convex
     * shape may be left out of what a ray goes away from it meets. */
    size_t block_size;
    bool (*block_pack)(void *block, const pov_frame *frame, const void *const *selves, uint32_t n);
    uint32_t (*block_filter)(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                             pov_meeting *out);
    /* [load] For classes whose instance is larger than what was written: parse gets text_size zeroed bytes in its
     * place, and prepare makes of them an instance of at most POV_PREPARED_MAX bytes, which comes zeroed. It is
     * called again, from several threads, wherever the host would have to keep one. */
    size_t text_size;
    void (*prepare)(void *self, const void *text);
    /* abi 2 began with these. */

    /* [render] As n calls of intersect(), and of normal(), to the bit: pair i is shape i with ray i. For rays that are
     * asked in company, where several side by side cost less than as many alone; n is at least one. */
    void (*intersect_many)(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
    void (*normal_many)(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                        pov_vec3 *const *out, uint32_t n);
    /* [load] Is it an ellipsoid, and bounded like one? Hosts may filter its rays by that where no block does. */
    bool (*ellipsoid)(const void *self, pov_ellipsoid *out);
    /* Bytes of a block that one shape was packed in alone, if they are fewer than block_size; else 0. */
    size_t lone_block_size;
    /* [render] As intersect_many() finds the nearest crossing, of pairs that a filter calls surely crossed: whether
     * there is one need not be asked. No ray starts on its shape. */
    void (*cross_many)(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
} pov_shape_class;

/* Does a class reach as far as this member, and is it there? */
#define POV_SHAPE_HAS(shape, member) \
    ((shape)->size >= offsetof(pov_shape_class, member) + sizeof (shape)->member && (shape)->member != NULL)

/* ---- an image format ---------------------------------------------------- */

typedef struct pov_image {
    size_t size;
    int width, height, bits;       /* three channels of 8 or 16 bits (native order), or of 32: float */
    pov_transfer transfer;         /* how the integers were encoded */
    size_t stride;                 /* bytes from row to row, top row first */
    const void *pixels;
} pov_image;

/* Whoever reads says what there is, and gets room for height rows of stride bytes; NULL: there is none. */
typedef struct pov_image_target { void *user; void *(*begin)(void *user, const pov_image *about); } pov_image_target;

enum { POV_IMAGE_8 = 1u << 0, POV_IMAGE_16 = 1u << 1, POV_IMAGE_FLOAT = 1u << 2 };

typedef struct pov_image_format {
    uint32_t size, depths;         /* the POV_IMAGE_* it can hold; the lowest set bit is the usual one */
    const char *ending;            /* "png" */
    /* Any thread. NULL when all was put, else what went wrong, static text. Stop when put says false. */
    const char *(*write)(const pov_image *image, const pov_output *output);
    /* abi 2 began with these. */
    /* Any thread. The bytes of a whole file to pixels; may be NULL. NULL when all went well, else what is wrong. */
    const char *(*read)(const void *bytes, size_t count, const pov_image_target *target);
} pov_image_format;

/* ---- plots --------------------------------------------------------------- */

typedef struct pov_plot_format {
    uint32_t size;
    const char *ending;          /* "svg" */
    /* Any thread. NULL when all was put, else what went wrong, static text. Stop when put says false. */
    const char *(*draw)(const pov_plot *plot, const pov_output *output);
} pov_plot_format;

/* ---- the one exported symbol -------------------------------------------- */

typedef struct pov_plugin {
    uint32_t abi, size;
    const char *name, *version;
    const pov_shape_class *const *shapes;            /* ends with NULL; or NULL */
    const pov_image_format *const *images;           /* ends with NULL; or NULL */
    /* abi 2 began with these; patterns, lights, cameras append their own lists */
    const pov_plot_format *const *plots;             /* ends with NULL; or NULL */
} pov_plugin;

#define POV_PLUGIN_SYMBOL "povtrace_plugin"
#ifdef POV_STATIC_PLUGINS
#define POV_PLUGIN(id) const pov_plugin povtrace_plugin_##id
#else
#define POV_PLUGIN(id) POV_EXPORT const pov_plugin povtrace_plugin; const pov_plugin povtrace_plugin
#endif

#endif
