/* node.h - the nodes of a scene: leaves, each one shape in its own space, and groups of them.
 *
 * Most scenes have leaves only, and each is an object of its own. A group is a solid made of its children. The leaves
 * of a group are consecutive, in the order of the text. */
#ifndef MODEL_NODE_H
#define MODEL_NODE_H

#include "model/transform.h"

#include <stdint.h>

struct shape_class;

enum {
    LEAF_NO_SHADOW = 1, LEAF_INVERSE = 2, LEAF_HOLLOW = 4,
    LEAF_DOUBLE_ILLUMINATE = 8,  /* light from behind counts as light from the front */
    LEAF_NO_IMAGE = 16, LEAF_NO_REFLECTION = 32,  /* unseen by camera rays, and by reflected rays */
    LEAF_UV = 64,                /* its texture asks for surface coordinates: the shape stays as it was written */
    LEAF_NO_RADIOSITY = 256,     /* unseen by rays that gather light for radiosity */
    LEAF_CUTAWAY = 128           /* its texture is that of the members that it cuts */
};

typedef struct leaf_node {
    const struct shape_class *shape;
    void *instance;              /* the parsed form, aligned to 32, in the model's memory; not prepared. Consecutive
                                  * objects of a class that are written alike share it */
    const transform *map;        /* NULL: none */
    uint32_t material;           /* index into the model's materials */
    uint32_t flags;              /* LEAF_* */
    uint32_t line, column;       /* of its keyword, 1-based */
} leaf_node;

/* A leaf by its index, or a group by its index and this bit. */
typedef uint32_t node_ref;
#define NODE_GROUP 0x80000000u

typedef enum node_op { NODE_UNION, NODE_MERGE, NODE_INTERSECTION, NODE_DIFFERENCE, NODE_CLIP } node_op;

/* A difference is its first child without the others; a clip the surface of its first child where all others are. */
typedef struct group_node {
    node_op op;
    bool inverse;                /* the complement of its solid */
    bool united;                 /* united: the children of the union share one dielectric, and are one object */
    uint32_t child, child_count; /* the first among the model's children */
    uint32_t leaf, leaf_count;   /* all leaves under it */
    uint32_t line, column;       /* of its keyword, 1-based */
} group_node;

/* A leaf whose faces have the textures of others, the givers that hold the point: a range of the model's. */
typedef struct cutaway { uint32_t leaf, giver, giver_count; } cutaway;

/* An object of several leaves with one dielectric: that of the first leaf's material. */
typedef struct solid_node {
    node_op op;                  /* NODE_CLIP: it is known by its first leaf */
    uint32_t leaf, leaf_count;
    uint32_t object;             /* its index among the objects of the scene */
    uint32_t line, column;
} solid_node;

#endif
