/* model.h - a parsed scene, plain data: the reader of scene language makes it, the ray tracer eats it. Everything
 * that the dialects differ in has been decided and stands here as a value. */
#ifndef MODEL_MODEL_H
#define MODEL_MODEL_H

#include "base/arena.h"
#include "model/light.h"
#include "model/material.h"
#include "model/node.h"

#include <povtrace/scene.h>

typedef struct leaf_list { leaf_node *items; size_t count, capacity; } leaf_list;
typedef struct material_list { material *items; size_t count, capacity; } material_list;
typedef struct light_list { light *items; size_t count, capacity; } light_list;

/* How computed values become linear light, and how that is stored. */
typedef struct gamma {
    double decode;               /* linear = value ^ decode; 1: as computed */
    pov_transfer transfer;       /* what integers the scene asks for */
} gamma;

typedef struct model {
    arena memory;                /* of instances and texts */
    arena maps;                  /* of transformations, which model_drop_maps() takes away before the rest */
    const env *env;
    leaf_list leaves;            /* in the order of the text: an object's index is its name everywhere */
    material_list materials;
    light_list lights;
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
/* Objects have no transformations any more. */
void model_drop_maps(model *m);

#endif
