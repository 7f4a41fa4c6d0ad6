/* copy_path.h - from a name to what it stands for: in the world itself, or in the world of a part that a copy refers to,
 * which may hold copies again. */
#ifndef WORLD_COPY_PATH_H
#define WORLD_COPY_PATH_H

#include "world/internal.h"

/* Copies within each other; sdl makes no more than one. */
enum { COPY_DEPTH_MAX = 4 };

typedef struct copy_path {
    const world *world;
    uint32_t index;              /* the name there */
    uint32_t depth;
    const instance_xform *into[COPY_DEPTH_MAX];   /* of the copies, the outermost first; NULL: one is not moved */
} copy_path;

static inline bool world_is_own(const world *w, uint32_t name) { return name < w->own_names; }

void world_find(const world *w, uint32_t name, copy_path *out);
/* Is any of the copies moved? */
bool copy_path_moves(const copy_path *p);
/* The ray in the space of the part; it may be written to `own`. */
const pov_ray *copy_path_ray(const copy_path *p, const pov_ray *ray, pov_ray *own);
void copy_path_point(const copy_path *p, pov_vec3 *point, pov_vec3 *point_lo);
/* From there to the world. */
void copy_path_normal(const copy_path *p, pov_vec3 *normal);

/* The same of one copy. */
const instance_xform *copy_xform(const world *w, uint32_t copy);

#endif
