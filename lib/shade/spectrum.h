/* spectrum.h - the colours of dispersed light. */
#ifndef SHADE_SPECTRUM_H
#define SHADE_SPECTRUM_H

#include "model/colour.h"

/* The part of white light between i/n and (i + 1)/n of the spectrum, from red to violet. */
colour spectrum_of(int i, int n);

#endif
