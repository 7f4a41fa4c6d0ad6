/* The disc of out_of_tree/ once more, claiming to be certified: rightly, unless an ERROR is added to its distances. */
#include <povtrace/shape.h>

#ifndef ERROR
#define ERROR 0.0
#endif


#define pov_cross(hits, t, t_lo, mark) \
    pov_cross(hits, (t) + (ERROR) / sqrt(pov_dot(ray->dir, ray->dir)), t_lo, mark)
#define keyword flags = POV_SHAPE_FACETED | POV_SHAPE_CERTIFIED, .keyword
#include "plugins/out_of_tree/disc.c"
