/* model.h - a parsed scene as plain data: the reader of the scene language makes it, the ray tracer compiles it. All
 * differences between the dialects are resolved here and stored as values. */
#ifndef MODEL_MODEL_H
#define MODEL_MODEL_H

#include "base/arena.h"
#include "base/simd.h"
#include "model/air.h"
#include "model/light.h"
#include "model/map_table.h"
#include "model/material.h"
#include "model/media.h"
#include "model/node.h"
#include "model/photons.h"
#include "model/radiosity.h"

#include <povtrace/scene.h>

struct noise_tables;

typedef struct group_list { group_node *items; size_t count, capacity; } group_list;
typedef struct solid_list { solid_node *items; size_t count, capacity; } solid_list;
typedef struct node_list { node_ref *items; size_t count, capacity; } node_list;
typedef struct leaf_list { leaf_node *items; size_t count, capacity; } leaf_list;
typedef struct material_list { material *items; size_t count, capacity; } material_list;
typedef struct light_list { light *items; size_t count, capacity; } light_list;
typedef struct fog_list { fog *items; size_t count, capacity; } fog_list;
typedef struct rainbow_list { rainbow *items; size_t count, capacity; } rainbow_list;
typedef struct light_group_list { light_group *items; size_t count, capacity; } light_group_list;
typedef struct cutaway_leaves { cutaway *items; size_t count, capacity; } cutaway_leaves;
typedef struct leaf_numbers { uint32_t *items; size_t count, capacity; } leaf_numbers;
typedef struct map_numbers { uint32_t *items; size_t count, capacity; } map_numbers;

struct model;

/* A solid that was declared and used often is stored once, as a part, and each use of it is a copy. What is in a copy has
 * a name too: names are indices of leaves, behind these of trees and of copies, and behind all of them the names in the
 * first copy's part, and so on. A leaf that no copy holds is named by its index. */
typedef struct model_copy {
    const struct model *of;      /* the part */
    const transform *map;        /* NULL: none */
    uint32_t leaf;               /* it stands before this one in the text */
    uint32_t name;               /* of what is first in it */
    uint32_t objects;            /* in all copies up to this one */
} model_copy;

typedef struct copy_list { model_copy *items; size_t count, capacity; } copy_list;
typedef struct part_models { struct model **items; size_t count, capacity; } part_models;

/* How computed values become linear light, and how that is stored. */
typedef struct gamma {
    bool decodes_srgb;           /* values are as sRGB encodes light, whatever `decode` says */
    double decode;               /* linear = value ^ decode; 1: as computed */
    pov_transfer transfer;       /* encoding of integers that the scene asks for */
} gamma;

/* Memory that the scene keeps for its plugins, and its destructor. */
typedef struct kept_item { void *item; void (*destroy)(void *item); } kept_item;
typedef struct kept_list { kept_item *items; size_t count, capacity; } kept_list;

typedef struct model {
    arena memory;                /* memory of instances and parsed forms */
    arena maps;                  /* memory of transformations, which model_drop_maps() frees before the rest */
    const env *env;
    leaf_list leaves;            /* in the order of the text: a leaf's index is its name everywhere */
    group_list groups;
    node_list children;          /* of the groups, side by side */
    node_list trees;             /* groups that rays intersect as one: no union, unless inverse or part of a tree */
    solid_list solids;           /* in the order of the text; leaves outside any solid are objects of their own */
    copy_list copies;            /* in the order of the text */
    part_models parts;           /* models of their own nodes and texture maps; all else is this one's */
    uint32_t part;               /* of a part: its index, and how many copies there are of it */
    uint32_t uses;
    material_list materials;
    light_list lights;
    light_group_list light_groups;
    const sky_sphere *sky;              /* NULL: only the background */
    fog_list fogs;
    rainbow_list rainbows;
    const media *atmosphere;     /* what fills the scene outside of solids that are not hollow; NULL: nothing */
    cutaway_leaves cutaways;     /* in the order of the leaves */
    leaf_numbers givers;         /* of textures, side by side */
    bool soft_lights;            /* area lights are lit all over, and not at the points of their grids only */
    map_table kept_maps;         /* of textures */
    struct noise_tables *noise;  /* from env_alloc_aligned(); NULL: no pattern needs them */
    int noise_generator;         /* 1 to 3 */
    uint32_t number_of_waves;
    kept_list kept;              /* in the order of being made */
    map_numbers texture_maps;    /* by leaf: number of the map of the transformations behind its texture; further leaves
                                  * have none */
    pov_camera camera;
    bool has_camera;             /* the scene gives one */
    const struct camera_mesh *camera_mesh;   /* of cameras of that type; NULL: they see nothing */
    const normal_node *camera_normal;   /* bends the rays of all cameras; NULL: none */
    colour ambient_light, background;
    pigment sky_colour;                 /* the background of pictures with alpha: what it lets through is transparent */
    bool sky_is_old;                    /* of versions before 3.7: transparent in pictures with alpha, opaque or not; what
                                         * layers filter and transmit is counted apart */
    colour irid_wavelength;
    double adc_bailout;
    int max_trace_level;
    uint64_t most_rays;          /* that follow from one camera ray; 0: the default */
    photon_settings photons;
    struct { bool given, used; double mm_per_unit; } subsurface;   /* used: some finish is translucent */
    radiosity_settings radiosity;
    bool opaque_last_level;      /* rays of the last level do not go through surfaces */
    bool opaque_dark_filters;    /* nor do any through filters whose luminance is below adc_bailout */
    gamma gamma;
    bool opacity_uses_filter_colour;  /* 1 - (filter*max(r,g,b) + transmit) instead of 1 - filter - transmit */
    bool fresnel_metallic;            /* metallic highlights by POV-Ray's factor, else 1 + m*(C - 1) */
    pov_dialect dialect;
    const char *dialect_reason;
    size_t warnings;
    uint64_t identity;           /* hash of all source texts */
} model;

void model_init(model *m, const env *e);
void model_free(model *m);
/* Add in the order of the text. A leaf outside a group is an object. False: no memory. */
bool model_add_leaf(model *m, const leaf_node *leaf);
/* Add a group of the children added before, and nothing after them. A group of one child becomes the child, an empty
 * one nothing. shape: the group's members other than its leaves and children. */
bool model_add_group(model *m, const group_node *shape, const node_ref *children, size_t count, node_ref *out);
/* Complete a tree of nodes: top-level unions dissolve into their children, which are objects of their own, unless they
 * are united. */
bool model_add_tree(model *m, node_ref root);

/* ---- copies ---- */

/* Exchange what a part has of its own: nodes and texture maps. */
void model_swap_nodes(model *a, model *b);
/* A part of the nodes that the model has; the model has none any more, and refers to the part. NULL: no memory. */
model *model_take_part(model *m);
/* When all has been read: parts share what is not theirs, and copies get names. False: there are more than there are
 * names. */
bool model_name_copies(model *m);
/* Names of what no copy holds; of all. */
static inline size_t model_own_names(const model *m) { return m->leaves.count + m->trees.count + m->copies.count; }
size_t model_all_names(const model *m);
/* The copy that holds a name, which becomes one of the part; NULL: none does, the name stays. */
const model_copy *model_copy_of(const model *m, uint32_t *name);
SIMD_RARE const leaf_node *model_leaf_within(const model *m, uint32_t name);
/* The leaf of a name. */
static inline const leaf_node *model_leaf(const model *m, uint32_t name)
{
    return name < m->leaves.count ? &m->leaves.items[name] : model_leaf_within(m, name);
}
/* Does the one leaf stand before the other in the text? */
bool model_is_before(const model *m, uint32_t a, uint32_t b);
/* The model's leaves stand in this order from now on: the one at i comes from order[i]. False: no memory. */
bool model_reorder(model *m, const uint32_t *order);

/* Objects of the scene: solids, and leaves that belong to none. */
size_t model_object_count(const model *m);
/* The object of a leaf, and the solid of an object, with the name of its first leaf; NULL: the object is that leaf. */
uint32_t model_object_of(const model *m, uint32_t leaf);
const solid_node *model_object(const model *m, uint32_t object, uint32_t *leaf);
const char *model_op_keyword(node_op op);

/* Does the light shine on the leaf, as light groups have it? The innermost group around it says which lights of groups do,
 * the outermost one whether those of none do. */
bool model_is_lit_by(const model *m, uint32_t leaf, const light *l);
/* Give the item to the model. False: no memory, and the item is destroyed. */
bool model_keep(model *m, void *item, void (*destroy)(void *item));

/* Set the map of the last leaf's texture. False: no memory. */
bool model_set_texture_map(model *m, const pov_affine *map);
/* A leaf's texture is in the world's space after all. */
void model_clear_texture_map(model *m, uint32_t leaf);
/* What a leaf with LEAF_CUTAWAY has. */
const cutaway *model_cutaway(const model *m, uint32_t leaf);
/* Equal numbers are of one map; 0: the texture is in the world's space. */
static inline uint32_t model_texture_map_number(const model *m, uint32_t leaf)
{
    return leaf < m->texture_maps.count ? m->texture_maps.items[leaf] : 0;
}
/* May be written to `space`. NULL: the texture is in the world's space. */
static inline const inverse_map *model_texture_map(const model *m, uint32_t leaf, inverse_map *space)
{
    return map_table_read(&m->kept_maps, model_texture_map_number(m, leaf), space);
}

/* Free all transformations: objects have none any more. */
void model_drop_maps(model *m);

#endif
