/* appearance.h - what a surface looks like at a point, as the lights and the rays that go on need it. Of a constant texture
 * it is computed once a material, before the first ray; of one that varies, for each surface. */
#ifndef SHADE_APPEARANCE_H
#define SHADE_APPEARANCE_H

#include "world/plan.h"

/* Diffuse light at least as bright as this hides highlights below the cut-off. */
#define APPEARANCE_VISIBLE 0x1p-8f
/* Powers of highlights that lanes compute by multiplication, and that single surfaces do. */
enum { APPEARANCE_POWER_LANES = 255, APPEARANCE_POWER_MAX = 1024 };

typedef struct appearance {
    bool varies;                 /* the texture does: what follows is of the material as far as it is constant, and true
                                  * of lit, reflective and transmissive if it may be so anywhere */
    bool lit;                    /* lights change something about it */
    bool reflective, transmissive;   /* rays go on from it */
    double highlight_cutoff;     /* a specular cosine of no more than that adds nothing to a float of APPEARANCE_VISIBLE
                                  * or more */
    uint32_t power;              /* phong_size where that is a whole number from 1 to APPEARANCE_POWER_MAX, or 0 */
    float phong;                 /* of highlights that are white and of a power from 1 to APPEARANCE_POWER_LANES; 0: there
                                  * is none; not a number: there is another */
    colour pigment;
    float diffuse_weight;        /* diffuse, times the opacity */
    colour emitted;              /* what it sends without any light */
    coefficient reflection, filter;  /* what the reflected and the transmitted ray are multiplied by */
    const material *material;
} appearance;

/* The appearance of a material in this scene. */
void appearance_make(appearance *out, const plan *p, const model *m, const material *of);
/* The same where the texture varies, from the material's and the pigment at a point. */
void appearance_paint(appearance *out, const plan *p, const model *m, const appearance *of, const pigment *at);

#endif
