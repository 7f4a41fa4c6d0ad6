/* object.h - one object of a scene, in its own space. */
#ifndef MODEL_OBJECT_H
#define MODEL_OBJECT_H

#include "model/transform.h"

#include <stdint.h>

struct pov_shape_class;

enum { OBJECT_NO_SHADOW = 1, OBJECT_INVERSE = 2, OBJECT_HOLLOW = 4 };

typedef struct object {
    const struct pov_shape_class *shape;
    void *instance;              /* as parse left it, aligned to 32, in the model's memory; not prepared. Objects written
                                  * alike, with none of the class between them that is not, share it */
    const transform *map;        /* NULL: none */
    uint32_t material;           /* index into the model's materials */
    uint32_t flags;              /* OBJECT_* */
    uint32_t line, column;       /* of its keyword, 1-based */
} object;

#endif
