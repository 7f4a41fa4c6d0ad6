/* film.h - thin films: waves reflected at both their faces add up or cancel out. */
#ifndef SHADE_FILM_H
#define SHADE_FILM_H

#include "model/model.h"

/* Turbulence makes a film thinner and thicker, as POV-Ray has it, in the space of the world. */
double film_thickness(const model *m, const finish *f, pov_vec3 point);
/* What a film makes of the light that it mirrors: the sum of the cosines to its normal of the ways to and from it. */
colour film_mirrored(const model *m, const finish *f, double cosines, pov_vec3 point);

#endif
