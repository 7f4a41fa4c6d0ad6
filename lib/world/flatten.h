/* flatten.h - from a model's objects to shapes that lie side by side, as rays want them. */
#ifndef WORLD_FLATTEN_H
#define WORLD_FLATTEN_H

#include "base/arena.h"
#include "model/model.h"
#include "world/run.h"

/* Where an object's shape is, for what is asked once a hit. */
typedef struct shape_place {
    const void *instance;
    const placement *placement;  /* NULL: own space is the world */
} shape_place;

/* Shapes of one class that are stored and asked alike. */
typedef struct shape_group {
    const pov_shape_class *shape;
    bool placed, packs;
    uint32_t count, used;        /* of `used` the final place is given out */
    uint32_t stride;             /* bytes from instance to instance */
    unsigned char *instances;
    placement *placements;
} shape_group;

/* All that is known of an object while the world is built. */
typedef struct flat_shape {
    const void *instance;        /* the model's; or a copy that has absorbed its transformation */
    placement *placement;
} flat_shape;

typedef struct flat {
    const env *env;
    const model *model;
    arena staging;               /* of what is copied again into its group */
    flat_shape *shapes;          /* by object */
    pov_box *boxes;              /* by object; of finite ones */
    uint16_t *group;             /* by object: which one */
    shape_group *groups;
    bool *packs;                 /* by group, as the tree wants it */
    size_t group_count, group_capacity;
    uint32_t *finite, *infinite; /* objects, in the order of the scene */
    uint32_t finite_count, infinite_count;
    size_t absorbed, composed, packed;
} flat;

/* use_blocks: whether shapes may share blocks. On failure nothing is left behind. */
pov_status flatten(flat *f, const model *m, bool use_blocks, pov_error *err);
/* Memory for the groups' final arrays, which outlive the flat. */
bool flat_allocate(flat *f);
/* All but those arrays. */
void flat_free(flat *f);
void groups_free(const env *e, shape_group *groups, size_t count);

/* How many bytes the runs of these objects take, and filling them in: instances are copied to their groups, and
 * places noted. ids are put in order. */
size_t flat_runs_size(flat *f, uint32_t *ids, uint32_t count);
void flat_runs_fill(flat *f, uint32_t *ids, uint32_t count, shape_place *places, void *at);

#endif
