/* pigment.h - what a surface's colour does to light. */
#ifndef SHADE_PIGMENT_H
#define SHADE_PIGMENT_H

#include "model/model.h"

/* The part of ambient and diffuse light that a surface which lets light through still gives. Negative where filter
 * and transmit are more than 1 together, as in POV-Ray. */
float pigment_opacity(const model *m, const material *surface);
/* What a highlight is multiplied by; cosine is the one between normal and light. */
colour pigment_highlight(const model *m, const material *surface, double cosine);

#endif
