/* film.h - thin films: waves reflected at both their faces add up or cancel out. */
#ifndef SHADE_FILM_H
#define SHADE_FILM_H

#include "base/lanes.h"
#include "model/model.h"

/* Films side by side. Turbulence makes a film thinner and thicker, as POV-Ray has it, in the space of the world. */
typedef struct films {
    uint32_t count;
    const finish *of[LANES_MAX];
    vec_lanes at;
    double thickness[LANES_MAX];
    double cosines[LANES_MAX];   /* to a film's normal, of the ways to and from it, added up */
    float factor[3][LANES_MAX];  /* what it makes of the light that it mirrors */
} films;

static inline void films_add(films *f, const finish *of, pov_vec3 point)
{
    f->of[f->count] = of;
    lanes_put(&f->at, f->count++, point);
}

void films_find(films *f, const model *m);
/* Their factors by thickness and cosines. */
void films_mirrored(films *f, const model *m);
double film_thickness(const model *m, const finish *f, pov_vec3 point);
/* The factor of one. */
colour film_mirrored(const model *m, const finish *f, double thickness, double cosines);

#endif
