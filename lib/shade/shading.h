/* shading.h - a scene compiled for shading: the world, and the appearances of its materials. */
#ifndef SHADE_SHADING_H
#define SHADE_SHADING_H

#include "light/grid.h"
#include "shade/appearance.h"
#include "world/world.h"

/* grid NULL: it is no area light. */
typedef struct scene_light { const light_class *class; const light *light; light_grid *grid; } scene_light;

/* Never changes once it is made: many threads read one. */
typedef struct shading {
    const model *model;
    const world *world;
    const plan *plan;
    const object_info *objects_info;
    const uint32_t *solids;      /* see world_own_solids() */
    uint32_t own_names;          /* of these; shading_info() */
    appearance *appearances;     /* one a material */
    appearance *finishes;        /* one a finish of varying textures, in a hash table by their places in memory: a power of two of */
    size_t finish_slots;         /* slots, of which those without a finish are free */
    uint32_t most_terms;         /* of a texture at a point */
    bool angular;                /* some finish reflects or transmits by the angle of the ray */
    bool even;                   /* all materials are: see appearance.h */
    bool views, uvs, worlds;     /* some texture asks where it is seen from; for the surface's uv coordinates; for points in the world */
    struct stack **stacks;
    bool flat_stacks;            /* of these and of those at points there may be flat ones */
    size_t stack_count, stack_capacity;
    finish plain_finish;         /* the default */
    appearance unseen;           /* of objects that a ray does not see */
    scene_light *lights;
    size_t light_count;
    struct photon_scene *photons;   /* NULL: there are none */
    bool air, dims;              /* rays that hit nothing see more than one colour; rays change on their way */
    colour behind;               /* if not: that colour */
    double scale;                /* how far away the scene's objects are */
} shading;

/* The model and the world must outlive it. */
pov_status shading_create(shading **out, const model *m, const world *w, pov_error *err);
void shading_destroy(shading *s);

/* Appearance of a finish of a varying texture, but for its pigment. */
const appearance *shading_finish(const shading *s, const finish *of);
/* The record of a surface by its name. */
static inline const object_info *shading_info(const shading *s, uint32_t which)
{
    return which < s->own_names ? &s->objects_info[which] : world_info_within(s->world, which);
}
/* As world_solid(). */
static inline uint32_t shading_solid(const shading *s, uint32_t leaf)
{
    if (leaf >= s->own_names)
        return world_solid(s->world, leaf);
    return s->solids ? s->solids[leaf] : leaf;
}
/* Appearance of an object with a constant texture. */
static inline const appearance *shading_constant(const shading *s, uint32_t which)
{
    return &s->appearances[shading_info(s, which)->material];
}

#endif
