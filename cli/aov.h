/* aov.h - maps of what camera rays meet: how certain, which way it faces, how far it is; and of the time that it took. */
#ifndef CLI_AOV_H
#define CLI_AOV_H

#include "args.h"

/* Can the maps that were asked for be written, as far as their names tell? */
pov_status aov_check(pov_context *context, const args *a, pov_error *err);
/* Write the maps that were asked for: of rays through the centre of each pixel, and of the time that the job, which has
 * ended, took. */
pov_status aov_write(pov_context *context, const pov_scene *scene, pov_job *job, const args *a, pov_error *err);

#endif
