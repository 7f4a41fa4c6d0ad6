/* pigment.h - what a surface's colour does to light. */
#ifndef SHADE_PIGMENT_H
#define SHADE_PIGMENT_H

#include "model/model.h"

/* What a highlight is multiplied by; cosine is the one between normal and light. Of a metal: */
colour pigment_metal(const model *m, const material *of, double cosine);
/* Of any material: */
static inline colour pigment_highlight(const model *m, const material *of, double cosine)
{
    return of->metallic == 0.0f ? colour_of(1.0f, 1.0f, 1.0f) : pigment_metal(m, of, cosine);
}

#endif
