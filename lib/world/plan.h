/* plan.h - what a scene needs, and so what is compiled for it and what is left out. */
#ifndef WORLD_PLAN_H
#define WORLD_PLAN_H

#include "model/model.h"

typedef struct plan_row { bool used; const char *subject, *state, *reason; } plan_row;
typedef struct plan_row_list { plan_row *items; size_t count, capacity; } plan_row_list;

#define PLAN_VISIBLE 0x1p-8f
enum { PLAN_POWER_EASY = 255, PLAN_POWER_MAX = 1024 };

/* What of a material counts in this scene, worked out once and not at every hit. */
typedef struct plan_look {
    bool lit, mirrors, passes;   /* lights change something about it; rays go on from it, mirrored or through it */
    double dull;                 /* what a gloss (cosine between mirrored ray and light) of no more than that adds is
                                  * lost in any float of PLAN_VISIBLE or more */
    uint32_t power;              /* phong_size where that is a whole number from 1 to PLAN_POWER_MAX, or 0 */
    float phong;                 /* of highlights that are white and of a power from 1 to PLAN_POWER_EASY; 0: there is
                                  * none; not a number: there is another */
    colour pigment;
    float body;                  /* the part of its colour by which it gives light back all round */
    colour glow;                 /* what it sends by itself */
    coefficient mirror, filter;  /* what is mirrored, and what passes it, is multiplied by */
    const material *material;
} plan_look;

typedef struct plan {
    bool lighting;               /* some light shines and some surface answers it */
    bool shadows;                /* ... and some object throws one */
    bool coloured_shadows;       /* ... and some of those is transparent */
    bool highlights, metallic;
    bool reflection;
    bool transmission;           /* some surface lets rays through */
    bool refraction;             /* ... into a medium of ior other than 1 */
    bool media_at_start;         /* some medium could hold the camera: asked once a picture */
    plan_look *looks;            /* one a material */
    plan_row_list rows;          /* for people */
    arena memory;                /* of the looks and the rows' texts */
} plan;

/* Read the needs off the model. Rows on objects and trees are added by world_create(). */
pov_status plan_make(plan *p, const model *m, pov_error *err);
/* A row; subject and state are static text, the reason is formatted and copied. */
pov_status plan_add(plan *p, pov_error *err, bool used, const char *subject, const char *state, const char *reason, ...)
    POV_PRINTF(6, 7);
void plan_free(plan *p);
/* Can rays be in it? Any transparent solid: one without an interior { } is a bubble of ior 1. */
bool plan_is_medium(const model *m, const leaf_node *o);

#endif
