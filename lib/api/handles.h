/* handles.h - public handles that belong to no other room. */
#ifndef API_HANDLES_H
#define API_HANDLES_H

#include "api/explain.h"
#include "base/env.h"
#include "base/thread.h"
#include "build/parts.h"
#include "model/model.h"
#include "plug/registry.h"
#include "shade/shading.h"

/* Lives until it is destroyed and its last scene is gone: scenes run code of its plugins. */
struct pov_context {
    env env;
    registry *plugins;
    mutex lock;                  /* guards users */
    int users;                   /* references: the program, and each scene */
};

struct pov_builder {
    pov_context *context;
    scene_parts parts;
    build_each each;             /* of the next shapes */
};

struct pov_scene {
    pov_context *context;
    model model;
    world *world;
    explanation explanation;
    shading *shading;
    double parse_seconds, build_seconds;
};

void context_retain(pov_context *context);
void context_release(pov_context *context);

#endif
