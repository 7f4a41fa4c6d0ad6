/* aov.h - maps of what camera rays hit, and of time, as files. */
#ifndef CLI_AOV_H
#define CLI_AOV_H

#include "args.h"

/* Can the requested maps be written, as far as their names tell? */
pov_status aov_check(pov_context *context, const args *a, pov_error *err);
/* Is this map to be layers of the picture's own file? */
bool aov_is_layer(const args *a, int which);
/* Write the requested maps of the job, which has ended. */
pov_status aov_write(pov_context *context, pov_job *job, const args *a, pov_error *err);

#endif
