/* trace.h - rays as programs give them. */
#ifndef API_TRACE_H
#define API_TRACE_H

#include "world/surface.h"

pov_ray trace_ray(pov_vec3 org, pov_vec3 dir);
/* Are the ray's numbers valid? A direction of zero or NaN hits nothing. */
bool trace_is_ray(pov_vec3 org, pov_vec3 dir);

#endif
