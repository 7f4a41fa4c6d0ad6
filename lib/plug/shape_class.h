/* shape_class.h - a primitive as the host holds it: its class and its fast extension, complete.
 *
 * A plugin may have been built when the structs were shorter. Members that it lacks are NULL or zero here, so that no
 * other file checks sizes. shape.h and shape_fast.h describe the members. */
#ifndef PLUG_SHAPE_CLASS_H
#define PLUG_SHAPE_CLASS_H

#include <povtrace/shape_fast.h>

typedef struct shape_class {
    uint32_t flags;
    bool full_leaves;
    const char *keyword;
    size_t instance_size;
    void (*parse)(void *self, const pov_host *host, pov_reader *in);
    bool (*bounds)(const void *self, pov_box *out);
    void (*intersect)(const void *self, const pov_ray *ray, pov_hits *hits);
    void (*normal)(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
    bool (*inside)(const void *self, pov_vec3 point, pov_vec3 point_lo);
    bool (*absorb)(void *self, const pov_affine *map);
    size_t parsed_size;
    void (*prepare)(void *self, const void *parsed);
    void (*uv)(const void *self, pov_vec3 point, const pov_mark *mark, double out[2]);
    size_t (*scratch)(const void *self);
    bool (*open)(const void *self);
    bool (*solid)(const void *self);
    uint32_t (*shading_normals)(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark,
                                pov_vec3 *normal, double *share);
    uint32_t (*textures)(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark, uint32_t *which,
                         double *share);
    bool (*face)(const void *self, uint32_t number, pov_face *out);
    bool (*reversed)(const void *self, const pov_ray *ray, const pov_crossing *at);

    size_t block_size, single_block_size;
    bool (*block_pack)(void *block, const pov_frame *frame, const void *const *selves, uint32_t n);
    uint32_t (*block_filter)(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                             pov_candidate *out);
    void (*intersect_many)(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
    void (*normal_many)(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                        pov_vec3 *const *out, uint32_t n);
    void (*cross_many)(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
    bool (*ellipsoid)(const void *self, pov_ellipsoid *out);
    bool (*half_space)(const void *self, pov_half_space *out);
    uint32_t (*hull)(const void *self, const pov_half_space *within, uint32_t n, pov_half_space *out);
    void (*intersect_between)(const void *self, const pov_ray *ray, pov_hits *hits);
    void (*intersect_between_many)(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
    bool (*outline)(const void *self, pov_outline *out);
    void (*reorder)(void *parsed);
    uint32_t (*narrow)(const void *self, const pov_own_map *map, uint32_t owner, const pov_rays *rays, pov_candidate *io, uint32_t n);
    void (*normal_at_many)(const void *const *selves, const pov_vec3 *const *points, pov_vec3 *const *out, uint32_t n);
    uint64_t (*cross_sure)(const void *const *selves, const pov_ray *const *rays, pov_crossing *const *at, pov_contact *const *contacts, uint32_t n);
    bool (*ring)(const void *self, double radii[2]);
    void (*block_bounds)(const void *block, uint32_t lane, const pov_rays *rays, uint64_t lanes, double *lo, double *hi);
    void (*shading_normals_many)(const void *const *selves, const pov_vec3 *points, const pov_vec3 *points_lo, const pov_mark *const *marks,
                                 uint32_t n, pov_vec3 *out, uint32_t *count);
} shape_class;

/* Complete a class that shape_class_check() has accepted. */
void shape_class_fill(shape_class *out, const pov_shape_class *from);
/* NULL when the class keeps the form of the contract, else a message that says what is wrong. */
const char *shape_class_check(const pov_shape_class *c);

/* Patches have no inside, and normals that nothing inverts. A mesh without inside vector is not one of them. */
static inline bool shape_is_patch(const shape_class *c) { return !(c->flags & POV_SHAPE_SOLID); }

/* Of shapes with faces: one triangle, and no mesh of them. */
static inline bool shape_is_triangle(const shape_class *c) { return (c->flags & POV_SHAPE_CONVEX) && c->face; }
static inline bool shape_is_mesh(const shape_class *c) { return c->face && !shape_is_triangle(c); }

/* Has the shape that parse() wrote an inside? */
static inline bool shape_is_solid(const shape_class *c, const void *parsed)
{
    return (c->flags & POV_SHAPE_SOLID) && c->inside && (!c->solid || c->solid(parsed));
}

#endif
