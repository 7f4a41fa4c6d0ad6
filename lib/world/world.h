/* world.h - a scene compiled for rays: what the plan found needed, and nothing else.
 *
 * Object indices are the model's. A world that is made never changes: many threads may ask it. */
#ifndef WORLD_WORLD_H
#define WORLD_WORLD_H

#include "model/model.h"
#include "world/plan.h"

typedef struct world world;

typedef struct world_options {
    pov_accel accel;
    int threads;                 /* for building; 0: one a core */
    bool always_exact;           /* double-double arithmetic for every intersection, and no filters before it */
    model *last;                 /* the model itself, if no other world is to come of it: its transformations go as soon
                                  * as shapes have their places, a quarter of a large scene's memory; else NULL */
} world_options;

/* The model must outlive the world and is not changed, but for what options->last says. */
pov_status world_create(world **out, const model *m, const world_options *options, pov_error *err);
void world_destroy(world *w);
const plan *world_plan(const world *w);
/* Box around all finite objects; false: there is none. */
bool world_bounds(const world *w, pov_box *out);
/* What is looked at of each object that is met, by object: in one line of memory, and in few pages. slot, group: the
 * world's own affair. */
typedef struct object_info {
    uint32_t slot, material;
    uint16_t group;
    bool inverse : 1, filters : 1, plain : 1, member : 1;
} object_info;
const object_info *world_object_info(const world *w);
/* Objects without a finite box, which every ray is asked for. */
size_t world_infinite_count(const world *w);
/* Were its options to use double-double arithmetic for every intersection? */
bool world_is_exact(const world *w);

/* What each class of primitives was asked, after boxes and filters, and what double-double arithmetic had to decide of
 * it. */
enum { WORLD_CLASSES = 16 };
typedef struct class_counts { struct { uint64_t asked, escalated; } of[WORLD_CLASSES]; } class_counts;

/* The keyword of a class by its number; NULL past the last. */
const char *world_class(const world *w, size_t number);

/* What an object of the scene is to those that ask for its dielectric: the first of its leaves. Of an object that is
 * one leaf it is the leaf. */
uint32_t world_solid(const world *w, uint32_t leaf);
/* Shapes that rays meet as one; csg.h. */
const struct csg_list *world_trees(const world *w);

/* The dielectrics (transparent solids) that a point lies in, the largest first. Calls see for each. Only of use
 * where the plan has dielectrics_at_start. */
void world_dielectrics_at(const world *w, pov_vec3 point, pov_vec3 point_lo, void (*visit)(void *user, uint32_t solid),
                          void *user);

#endif
