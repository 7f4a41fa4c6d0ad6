/* segment_end.h - what lies at the end of a segment, and so not on it. */
#ifndef QUERY_SEGMENT_END_H
#define QUERY_SEGMENT_END_H

#include "query/packet.h"

/* Crossings in double-double that are so near the end lie there, whatever the angle at which the surface is met. */
double segment_end_slack(const world *w, const pov_ray *ray, double tmax);
/* Packets of one lane: find what blocks light with crossings in double-double, but for surfaces that lie at the end. As
 * packet_occlusion(). */
uint64_t segment_end_occlusion(packet *p);

#endif
