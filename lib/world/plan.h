/* plan.h - the needs of a scene: parts that are compiled for it, and parts left out. */
#ifndef WORLD_PLAN_H
#define WORLD_PLAN_H

#include "model/model.h"

typedef struct plan_row { bool used; const char *subject, *state, *reason; } plan_row;
typedef struct plan_row_list { plan_row *items; size_t count, capacity; } plan_row_list;

typedef struct plan {
    bool lighting;               /* some light emits, and some surface has diffuse light or highlights */
    bool shadows;                /* ... and some object casts one */
    bool coloured_shadows;       /* ... and some of those is transparent */
    bool highlights, metallic;
    bool textures;               /* some texture varies from point to point */
    bool reflection;
    bool transmission;           /* some surface transmits rays */
    bool refraction;             /* ... into a dielectric of ior other than 1 */
    bool dielectrics_at_start;   /* some dielectric could contain the camera: tested once a picture */
    plan_row_list rows;          /* for --explain */
    arena memory;                /* memory of the rows' texts */
} plan;

/* Derive the needs from the model. world_create() adds rows on objects and trees. */
pov_status plan_make(plan *p, const model *m, pov_error *err);
/* A row; subject and state are static text, the reason is formatted and copied. */
pov_status plan_add(plan *p, pov_error *err, bool used, const char *subject, const char *state, const char *reason, ...)
    POV_PRINTF(6, 7);
void plan_free(plan *p);
/* Can rays be inside it? Any transparent solid: one without an interior { } is a bubble of ior 1. */
bool plan_is_dielectric(const model *m, const leaf_node *o);

#endif
