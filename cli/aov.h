/* aov.h - maps of what camera rays meet: how certain, which way it faces, how far it is. */
#ifndef CLI_AOV_H
#define CLI_AOV_H

#include "args.h"

/* Can the maps that were asked for be written, as far as their names tell? */
pov_status aov_check(pov_context *context, const args *a, pov_error *err);
/* Trace a ray through the centre of each pixel, and write the maps. */
pov_status aov_write(pov_context *context, const pov_scene *scene, const args *a, pov_error *err);

#endif
