/* finish.h - how a surface reflects light. */
#ifndef MODEL_FINISH_H
#define MODEL_FINISH_H

#include "model/colour.h"

/* The coefficient of the mirrored ray goes from `min` for perpendicular rays to `max` for grazing ones. */
typedef struct reflection {
    colour min, max;
    float falloff;               /* power of its course; of no effect with fresnel */
    float exponent;              /* the mirrored colour is raised to the power 1 / exponent */
    float metallic;              /* share of the pigment's colour in it */
    bool fresnel;                /* its course is that of Fresnel's equations for the ior */
} reflection;

/* The effect of a thin film. */
typedef struct irid { float amount, thickness, turbulence; } irid;

typedef struct finish {
    colour ambient, emission;
    float diffuse, diffuse_back;   /* light from in front of the surface, and from behind */
    float written;               /* share of both that was written: what acts on light that radiosity gathers */
    float phong, phong_size, specular, metallic;
    double brilliance, roughness;
    float crand;
    colour translucency;         /* mean free path in millimetres of light below the surface; black: it does not go there */
    float refraction;            /* factor of the transmitted ray */
    bool conserve_energy;        /* what is reflected is not transmitted */
    irid irid;
    reflection reflection;
    double old_ior;              /* what old scenes say here of the interior; below 0: nothing */
    float old_caustics;
} finish;

/* The defaults of the language: ambient 0.1, diffuse 0.6, phong_size 40, roughness 0.05; 1 for brilliance, refraction,
 * falloff and exponent, -1 for what belongs to the interior; all else 0. */
void finish_init(finish *f);
bool finish_equal(const finish *a, const finish *b);

static inline bool finish_any_above_0(colour c) { return c.r > 0.0f || c.g > 0.0f || c.b > 0.0f; }

/* Is anything reflected under some angle? As in POV-Ray negative components take light away, but not all alone. */
static inline bool finish_is_mirror(const finish *f)
{
    return finish_any_above_0(f->reflection.min) || finish_any_above_0(f->reflection.max);
}

/* Does what is reflected or transmitted depend on the angle of the ray, or on what is reflected? */
static inline bool finish_is_angular(const finish *f)
{
    const reflection *r = &f->reflection;

    return !colour_equal(r->min, r->max) || (r->metallic != 0.0f && finish_is_mirror(f)) || f->conserve_energy ||
           f->refraction != 1.0f || f->irid.amount != 0.0f;
}

/* Is there a highlight? */
static inline bool finish_is_glossy(const finish *f) { return f->phong != 0.0f || f->specular != 0.0f; }

#endif
