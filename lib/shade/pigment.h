/* pigment.h - what a surface's colour does to light. */
#ifndef SHADE_PIGMENT_H
#define SHADE_PIGMENT_H

#include "model/model.h"

/* What a highlight is multiplied by; cosine is the one between normal and light. */
colour pigment_highlight(const model *m, const material *surface, double cosine);

#endif
