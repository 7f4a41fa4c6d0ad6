/* photons.h - what a scene says of photons: light that mirrors and lenses send to other surfaces. */
#ifndef MODEL_PHOTONS_H
#define MODEL_PHOTONS_H

#include <stdbool.h>
#include <stdint.h>

/* Settings of the scene. Without `given` there are no photons. */
typedef struct photon_settings {
    bool given;
    int max_trace_level;         /* below 0: that of the scene */
    double adc_bailout;          /* below 0: that of the scene */
    bool media;                  /* photons light media, too */
} photon_settings;

/* What photons do at an object, or with those of a light, in the upper bits of its flags. What is neither on nor off is
 * left to the other of both. */
enum {
    PHOTON_TARGET = 1 << 16,
    PHOTON_REFLECTS = 1 << 17, PHOTON_REFLECTS_NOT = 1 << 18,
    PHOTON_REFRACTS = 1 << 19, PHOTON_REFRACTS_NOT = 1 << 20,
    PHOTON_IGNORES = 1 << 21,    /* it collects none: light comes to it straight */
    PHOTON_THROUGH = 1 << 22,     /* photons on their way to a target go through it */
    PHOTON_AREA = 1 << 23,       /* of an area light: they leave the points of its grid */
    PHOTON_OBJECT_FLAGS = PHOTON_AREA - PHOTON_TARGET
};

static inline bool photons_agree(uint32_t of_object, uint32_t of_light, uint32_t on, uint32_t off)
{
    return !((of_object | of_light) & off) && ((of_object | of_light) & on);
}

/* Are photons of the light reflected, or refracted, by the object? */
static inline bool photons_reflect(uint32_t of_object, uint32_t of_light)
{
    return photons_agree(of_object, of_light, PHOTON_REFLECTS, PHOTON_REFLECTS_NOT);
}

static inline bool photons_refract(uint32_t of_object, uint32_t of_light)
{
    return photons_agree(of_object, of_light, PHOTON_REFRACTS, PHOTON_REFRACTS_NOT);
}

#endif
