/* emission.h - where photons leave the lights, and how much light each carries.
 *
 * An aim is one origin of a light, one target, and a rectangle that holds all rays between both: in a plane at distance 1
 * from the origin, or for parallel light across its axis. Emissions are spread evenly over the rectangle, by an additive
 * recurrence in two dimensions that each map of each seed shifts by numbers of its own. */
#ifndef PHOTON_EMISSION_H
#define PHOTON_EMISSION_H

#include "light/light.h"
#include "world/surface.h"

/* A target: the object's box, if it is finite. */
typedef struct photon_target { pov_box box; bool boxed; } photon_target;

typedef struct photon_aim {
    const light *light;          /* as it is, but it does not fade */
    light_origin from;
    uint32_t number;             /* of the aim */
    uint32_t light_number, target;   /* indices */
    pov_vec3 corner, sides[2];   /* of the rectangle: directions from the origin, or starts of parallel light */
    double area;                 /* of the rectangle */
    float share;                 /* of the light's colour */
} photon_aim;

typedef struct photon_aims {
    const env *env;
    photon_aim *items;
    size_t count, capacity;
    light *lights;               /* copies that do not fade */
} photon_aims;

/* Does the light send photons at all, if some target reflects or refracts them? */
bool emission_is_source(const light *l);
/* Aims of all lights at the targets that reflect or refract their photons: target_flags are by target. around: what
 * parallel light is sent to where a target is infinite, or NULL. False: no memory. */
bool emission_aim(photon_aims *out, const model *m, const photon_target *targets, const uint32_t *target_flags, size_t count,
                  const pov_box *around);
void emission_free(photon_aims *a);

/* Rays of emissions first .. first + n - 1 of `total` of a map of a seed, and the light that each carries: of parallel light per area, else
 * per solid angle. n: at most LANES_MAX. */
typedef struct emission_batch { pov_ray rays[LANES_MAX]; colour flux[LANES_MAX]; } emission_batch;
void emission_rays(const photon_aim *a, uint32_t seed, uint32_t map, uint32_t first, uint32_t n, uint32_t total, emission_batch *out);
/* What is left of light that fades over this distance, and for light that comes from a point what its flux is an
 * irradiance by: the square of the distance. */
double emission_factor(const light *l, double distance);

#endif
