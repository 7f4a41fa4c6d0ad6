/* node.h - what a scene is made of: leaves, each one shape in its own space. */
#ifndef MODEL_NODE_H
#define MODEL_NODE_H

#include "model/transform.h"

#include <stdint.h>

struct shape_class;

enum { LEAF_NO_SHADOW = 1, LEAF_INVERSE = 2, LEAF_HOLLOW = 4 };

typedef struct leaf_node {
    const struct shape_class *shape;
    void *instance;              /* as parse left it, aligned to 32, in the model's memory; not prepared. Objects written
                                  * alike, with none of the class between them that is not, share it */
    const transform *map;        /* NULL: none */
    uint32_t material;           /* index into the model's materials */
    uint32_t flags;              /* LEAF_* */
    uint32_t line, column;       /* of its keyword, 1-based */
} leaf_node;

#endif
