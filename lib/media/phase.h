/* phase.h - how much light media scatter in a direction. */
#ifndef MEDIA_PHASE_H
#define MEDIA_PHASE_H

#include "model/media.h"

/* By the cosine of the angle between the light's way and the way to the eye: 1 is straight on. The mean over all
 * directions is 1 for Henyey and Greenstein's function only, as POV-Ray has it. */
double media_phase(const medium *m, double cosine);

#endif
