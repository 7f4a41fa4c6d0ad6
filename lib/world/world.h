/* world.h - a scene compiled for rays, with the parts that its plan needs only.
 *
 * Object indices are the model's. A world never changes once made: many threads may query it. */
#ifndef WORLD_WORLD_H
#define WORLD_WORLD_H

#include "base/simd.h"
#include "model/model.h"
#include "world/plan.h"

typedef struct world world;

typedef struct world_options {
    pov_accel accel;
    int threads;                 /* for building; 0: one a core */
    bool always_exact;           /* double-double arithmetic for every intersection, without filters */
    model *last;                 /* the model itself, if no other world will be made of it: its transformations are
                                  * freed as soon as shapes have their positions, a quarter of a large scene's memory;
                                  * else NULL */
} world_options;

/* The model must outlive the world and is not changed, except as options->last says. */
pov_status world_create(world **out, const model *m, const world_options *options, pov_error *err);
void world_destroy(world *w);
const plan *world_plan(const world *w);
/* Numbers for --explain: objects whose transformation was absorbed, instances, objects in blocks, without and with a
 * finite box; and the size of the tree. */
typedef struct world_facts {
    size_t absorbed, composed, packed, infinite, finite, nodes, leaves, frames, tree_bytes, parts, copies;
    int depth;
    const char *kernels;         /* the code that traverses the tree; NULL: there is no tree */
} world_facts;
world_facts world_get_facts(const world *w);
/* Box around all finite objects; false: there is none. */
bool world_bounds(const world *w, pov_box *out);
/* Record of each object for hits, by object: in one cache line, and in few pages. slot, group: internal to the
 * world. */
typedef struct object_info {
    uint32_t slot, material;
    uint16_t group;
    bool inverse : 1, filters : 1, plain : 1, member : 1, smooth : 1;   /* smooth: it has shading normals */
    bool no_image : 1, no_reflection : 1;   /* rays from the camera, and those that were reflected, do not see it */
    bool no_radiosity : 1;       /* nor do rays that gather light */
    bool filled : 1;             /* it bounds a solid that is not hollow: there is no fog in it and no medium acts */
} object_info;
const object_info *world_object_info(const world *w);
/* The record of a name that is not among the first world_own_names(), which have theirs in that array: of what is in
 * copies. */
uint32_t world_own_names(const world *w);
SIMD_RARE const object_info *world_info_within(const world *w, uint32_t name);
/* As model_texture_map(), of a name of any copy; its linear part may be written to `linear`. */
SIMD_RARE const inverse_map *world_texture_map_within(const world *w, uint32_t name, inverse_map *space, linear_map *linear);
static inline const inverse_map *world_texture_map(const world *w, const model *m, uint32_t name, inverse_map *space,
                                                   linear_map *linear)
{
    return name < m->leaves.count ? model_texture_map(m, name, space) : world_texture_map_within(w, name, space, linear);
}
/* Where there is radiosity: the boxes of the finite objects that emit most, and what each gives, roughly. */
enum { WORLD_LAMPS_MAX = 16 };
typedef struct world_lamp { pov_box box; double power; } world_lamp;
typedef struct world_lamps { uint32_t count; world_lamp items[WORLD_LAMPS_MAX]; } world_lamps;
const world_lamps *world_get_lamps(const world *w);
/* By object: 0, or the number of its box, counted from 1. It is a transparent solid then, and between two points of it within
 * the box there is nothing else. NULL: unknown. */
typedef struct world_isolation { uint32_t *number; pov_box *boxes; } world_isolation;
/* Was it made with double-double arithmetic for every intersection? */
bool world_is_exact(const world *w);

/* Numbers of intersections of each class of primitives, after boxes and filters, and of those that escalated. */
enum { WORLD_CLASSES = 16 };
typedef struct class_counts { struct { uint64_t asked, escalated; } of[WORLD_CLASSES]; } class_counts;

/* The keyword of a class by its number; NULL past the last. */
const char *world_class(const world *w, size_t number);

/* The solid of an object, for dielectrics: the first of its leaves. An object of one leaf is its own solid. */
uint32_t world_solid(const world *w, uint32_t leaf);
/* The same by name for the first world_own_names(); NULL: each is its own. */
const uint32_t *world_own_solids(const world *w);
/* Shapes that rays intersect as one; see csg.h; and the memory for the largest, those of parts included. */
const struct csg_list *world_trees(const world *w);
struct csg_size;
void world_measure_trees(const world *w, struct csg_size *most);

/* How many solids that are not hollow contain a point, if the scene has fog or media; 0 without. */
uint32_t world_filled_at(const world *w, pov_vec3 point, pov_vec3 point_lo);
/* The dielectrics (transparent solids) that contain a point, the largest first. Calls visit for each. Only valid if the
 * plan has dielectrics_at_start. */
void world_dielectrics_at(const world *w, pov_vec3 point, pov_vec3 point_lo, void (*visit)(void *user, uint32_t solid),
                          void *user);

#endif
