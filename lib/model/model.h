/* model.h - a parsed scene, plain data: the reader of scene language makes it, the ray tracer eats it. Everything
 * that the dialects differ in has been decided and stands here as a value. */
#ifndef MODEL_MODEL_H
#define MODEL_MODEL_H

#include "base/arena.h"
#include "model/light.h"
#include "model/map_table.h"
#include "model/material.h"
#include "model/node.h"

#include <povtrace/scene.h>

typedef struct group_list { group_node *items; size_t count, capacity; } group_list;
typedef struct solid_list { solid_node *items; size_t count, capacity; } solid_list;
typedef struct node_list { node_ref *items; size_t count, capacity; } node_list;
typedef struct leaf_list { leaf_node *items; size_t count, capacity; } leaf_list;
typedef struct material_list { material *items; size_t count, capacity; } material_list;
typedef struct light_list { light *items; size_t count, capacity; } light_list;
typedef struct map_numbers { uint32_t *items; size_t count, capacity; } map_numbers;

/* How computed values become linear light, and how that is stored. */
typedef struct gamma {
    double decode;               /* linear = value ^ decode; 1: as computed */
    pov_transfer transfer;       /* what integers the scene asks for */
} gamma;

/* What the scene keeps for its plugins, and how it goes. */
typedef struct kept_item { void *item; void (*destroy)(void *item); } kept_item;
typedef struct kept_list { kept_item *items; size_t count, capacity; } kept_list;

typedef struct model {
    arena memory;                /* of instances and texts */
    arena maps;                  /* of transformations, which model_drop_maps() takes away before the rest */
    const env *env;
    leaf_list leaves;            /* in the order of the text: a leaf's index is its name everywhere */
    group_list groups;
    node_list children;          /* of the groups, side by side */
    node_list trees;             /* groups that rays meet as one: no union, unless inverse or of what is in a tree */
    solid_list solids;           /* in the order of the text; leaves of none are objects by themselves */
    material_list materials;
    light_list lights;
    map_table kept_maps;         /* of textures */
    kept_list kept;              /* in the order of being made */
    map_numbers texture_maps;    /* by leaf: the number of the map of the transformations behind its texture; leaves past
                                  * the end have none */
    pov_camera camera;
    colour ambient_light, background;
    double adc_bailout;
    int max_trace_level;
    gamma gamma;
    bool opacity_uses_filter_colour;  /* 1 - (filter*max(r,g,b) + transmit) instead of 1 - filter - transmit */
    bool fresnel_metallic;            /* highlights of metal after POV-Ray's factor, else 1 + m*(C - 1) */
    pov_dialect dialect;
    const char *dialect_reason;
    size_t warnings;
    uint64_t identity;           /* hash of all texts it was read from */
} model;

void model_init(model *m, const env *e);
void model_free(model *m);
/* What is added comes in the order of the text. A leaf alone is an object. False: no memory. */
bool model_add_leaf(model *m, const leaf_node *leaf);
/* A group of children that have been added, and nothing after them. Of one child that is the child, and of none there is
 * none. shape: what is given of it but for its leaves and children. */
bool model_add_group(model *m, const group_node *shape, const node_ref *children, size_t count, node_ref *out);
/* A tree of nodes is complete: unions that nothing stands above dissolve into their children, which are objects by
 * themselves, unless they are united. */
bool model_add_tree(model *m, node_ref root);

/* Objects of the scene: solids, and leaves that belong to none. */
size_t model_object_count(const model *m);
/* The object that a leaf belongs to, and the solid that an object is; NULL: it is the leaf that is put out. */
uint32_t model_object_of(const model *m, uint32_t leaf);
const solid_node *model_object(const model *m, uint32_t object, uint32_t *leaf);
const char *model_op_keyword(node_op op);

/* From now on the model owns the item. False: no memory, and the item is destroyed. */
bool model_keep(model *m, void *item, void (*destroy)(void *item));

/* The map of the last leaf's texture. False: no memory. */
bool model_set_texture_map(model *m, const pov_affine *map);
/* NULL: the texture is in the world's space. */
static inline const inverse_map *model_texture_map(const model *m, uint32_t leaf)
{
    return leaf < m->texture_maps.count ? map_table_at(&m->kept_maps, m->texture_maps.items[leaf]) : NULL;
}

/* Objects have no transformations any more. */
void model_drop_maps(model *m);

#endif
