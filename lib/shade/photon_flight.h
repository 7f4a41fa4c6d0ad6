/* photon_flight.h - photons on their way: from a light through mirrors and lenses to the surfaces that collect them. */
#ifndef SHADE_PHOTON_FLIGHT_H
#define SHADE_PHOTON_FLIGHT_H

#include "shade/photons.h"
#include "shade/tracer.h"

/* Trace a chunk by this tracer, between its own rays; a photon_trace. */
bool photon_flight_trace(void *tracer, const photon_chunk *chunk, photon_catch *out);
/* Does some photon of the chunk enter the target? */
bool photon_flight_enters(pov_tracer *t, const photon_chunk *chunk);

#endif
