/* interior.h - what a solid does to light inside it. */
#ifndef MODEL_INTERIOR_H
#define MODEL_INTERIOR_H

#include "model/media.h"

typedef struct interior {
    bool given;                  /* the solid is a dielectric */
    double ior;
    double dispersion;           /* ior of violet over that of red; 1: none */
    int dispersion_samples;
    double fade_distance, fade_power;   /* fade_distance 0: light does not fade */
    colour fade_color;
    float caustics;
    const media *media;          /* what fills it; NULL: nothing */
    bool has_ior;                /* the text gives one: without it there is no dispersion, whatever the text asks for */
    double asked_dispersion;
} interior;

/* The defaults of the language: ior and dispersion 1, 7 samples, all else 0. */
void interior_init(interior *i);
/* Does light on its way depend on where it crosses the surface? */
static inline bool interior_is_located(const interior *i)
{
    return i->fade_distance > 0.0 || i->caustics != 0.0f || media_dim(i->media);
}
void interior_set_ior(interior *i, double ior);
void interior_ask_dispersion(interior *i, double dispersion);
bool interior_equal(const interior *a, const interior *b);

#endif
