/* aov.h - maps of camera rays' hits (certainty, normal, depth), and of time. */
#ifndef CLI_AOV_H
#define CLI_AOV_H

#include "args.h"

/* Can the requested maps be written, as far as their names tell? */
pov_status aov_check(pov_context *context, const args *a, pov_error *err);
/* Write the requested maps, from rays through the centre of each pixel and from the processor time of the job, which
 * has ended. */
pov_status aov_write(pov_context *context, const pov_scene *scene, pov_job *job, const args *a, pov_error *err);

#endif
