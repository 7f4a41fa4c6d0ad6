/* curve.h - splines in the plane as shapes write them: a keyword, and points that some pieces share. */
#ifndef COMMON_CURVE_H
#define COMMON_CURVE_H

#include "common/outline.h"

typedef enum common_spline { COMMON_LINEAR, COMMON_QUADRATIC, COMMON_CUBIC, COMMON_BEZIER } common_spline;

/* The keyword of a spline, if one is next. */
bool common_spline_read(const pov_host *host, pov_reader *in, common_spline *kind);
/* A number of points and as many of two components. NULL after an error. */
double (*common_points_read(const pov_host *host, pov_reader *in, uint32_t *count))[2];
/* From the point p to the next one; those before and behind steer. */
common_piece common_spline_piece(common_spline kind, const double (*p)[2]);
/* `sturm`, with `on` or `off`: a choice between methods that there are not here. */
bool common_sturm_read(const pov_host *host, pov_reader *in);

#endif
