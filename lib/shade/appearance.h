/* appearance.h - the appearance of a surface at a point, as needed for lighting and scattering. For a constant texture
 * it is computed once for each material, before the first ray; for a varying one at each hit. */
#ifndef SHADE_APPEARANCE_H
#define SHADE_APPEARANCE_H

#include "world/plan.h"

/* Diffuse light at least as bright as this hides highlights below the cut-off. */
#define APPEARANCE_VISIBLE 0x1p-8f
/* Powers of highlights that lanes compute by multiplication, and that single surfaces do. */
enum { APPEARANCE_POWER_LANES = 255, APPEARANCE_POWER_MAX = 1024 };

/* What a finish has besides diffuse light and white highlights of phong. */
enum {
    FINISH_BRILLIANCE = 1, FINISH_SPECULAR = 2, FINISH_METAL = 4, FINISH_BACK = 8, FINISH_IRID = 16, FINISH_CRAND = 32
};

/* Coefficients of the rays that go on from a surface. */
typedef struct onward {
    coefficient reflection, filter;   /* of the reflected and the transmitted one */
    bool dark;                   /* no ray goes through so dark a filter */
} onward;

typedef struct appearance {
    bool varies;                 /* the texture varies: the members below are those of the constant material, with lit,
                                  * reflective and transmissive true if they may be true anywhere */
    bool one_pigment;            /* of a texture that varies: only the normal does, and these are the members */
    bool lit;                    /* light changes its colour */
    bool gathers;                /* light from other surfaces is seen of it */
    bool reflective, transmissive;   /* reflected or transmitted rays continue */
    bool clear;                  /* rays go through as if nothing were there */
    bool powered;                /* what is reflected is raised to a power */
    bool angular;                /* what is reflected or transmitted depends on the angle: surfaces have an `onward` of their own */
    bool fresnel;                /* ... by the ior on both sides */
    bool even;                   /* of a material: it is the same from everywhere on one side */
    bool needs_point;            /* one of these: more than emission is seen of it */
    bool lasts;                  /* it is part of the scene: what stands at this address stays as it is */
    double highlight_cutoff;     /* at a specular cosine up to this the highlight adds nothing to a float of
                                  * APPEARANCE_VISIBLE or more */
    uint32_t power;              /* phong_size where that is a whole number from 1 to APPEARANCE_POWER_MAX, or 0 */
    float phong;                 /* for white highlights with a power from 1 to APPEARANCE_POWER_LANES; 0: no highlight;
                                  * NaN: another kind of highlight */
    colour pigment;
    float opacity;               /* fraction of its light that an opaque surface would give */
    float diffuse_weight;        /* diffuse, times the opacity */
    float below_weight;          /* the same, instead, of light that is scattered below the surface */
    colour emitted;              /* emitted and ambient light */
    onward onward;               /* what goes on, but for the angle */
    uint32_t kinds;              /* FINISH_* */
    const finish *finish;
    const material *material;
    const struct stack *stack;   /* what layers that are alike everywhere give; NULL: the texture is none of such */
} appearance;

/* The appearance of a finish and a pigment in this scene. */
void appearance_make(appearance *out, const plan *p, const model *m, const finish *f, const pigment *at);
/* What of it depends on the pigment. */
typedef struct appearance_light { float opacity; colour emitted, filter; } appearance_light;
/* What filter takes of the opacity of a pigment of this colour. */
static inline float appearance_covered(const model *m, colour c, float filter)
{
    return m->opacity_uses_filter_colour ? filter * pov_maxf(c.r, pov_maxf(c.g, c.b)) : filter;
}
void appearance_light_of(appearance_light *out, const model *m, const finish *f, const pigment *at);
/* Do rays go through this pigment? */
bool appearance_transmits(const plan *p, const pigment *at);
/* Is so little left that what lies below is not seen? Filters may be negative: by size. */
static inline bool appearance_is_dark(const model *m, colour left)
{
    return (m->opaque_dark_filters ? fabsf(colour_luminance(left)) : colour_weight(left)) < (float)m->adc_bailout;
}
/* Set the filter of the transmitted ray. */
void onward_set_filter(onward *out, const model *m, colour by);
/* Of an object with this material. */
void appearance_set_material(appearance *out, const material *of);
/* The same for another pigment. */
void appearance_paint(appearance *out, const plan *p, const model *m, const appearance *of, const pigment *at);
/* The same of one that has the finish, and is no layer: without the filter where no ray goes through. */
void appearance_repaint(appearance *out, const plan *p, const model *m, const pigment *at);
/* Where light does not go through the pigment, nor below it, and highlights are white: the same, with opacity 1. */
static inline bool appearance_is_plain(const appearance *of, const plan *p, const pigment *at)
{
    return at->filter == 0.0f && at->transmit == 0.0f && !p->subsurface && of->finish->metallic == 0.0f;
}
static inline void appearance_repaint_plain(appearance *out, const model *m, const pigment *at)
{
    const finish *f = out->finish;

    out->transmissive = false;
    out->pigment = at->color;
    out->opacity = 1.0f;
    out->diffuse_weight = f->diffuse;
    out->below_weight = 0.0f;
    out->emitted = colour_add(colour_mul(colour_mul(f->ambient, at->color), m->ambient_light), colour_mul(f->emission, at->color));
}

#endif
