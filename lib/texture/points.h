/* points.h - points on their way to the spaces of patterns, and the patterns' values there. */
#ifndef TEXTURE_POINTS_H
#define TEXTURE_POINTS_H

#include "texture/pattern.h"
#include "texture/texture.h"

/* Points in the pattern's own space; lanes behind the last one, up to a whole vector of the processor, are like it. Low
 * parts are written where lo is not NULL. n is at least 1. */
void points_place(const model *m, const pattern *p, const texture_points *in, uint32_t n, vec_lanes *at, vec_lanes *lo);
/* The same for members of a blend, which begin where the pattern stands. */
void points_enter(const model *m, const pattern *p, const texture_points *in, uint32_t n, texture_points *out);
/* Some of `whole` lanes, in their order: in memory, or all of them as they are. */
const texture_points *points_pick(const texture_points *in, uint32_t whole, const uint8_t *lane, uint32_t n, texture_points *memory);
/* What a class is asked with, for points in the pattern's space. */
pattern_input points_input(const model *m, const pattern *p, const texture_points *in, const vec_lanes *at, uint32_t n);
/* The points that a class was asked with, for pigments that it asks. */
void points_begin(const pattern_input *in, texture_points *out);
/* Values from evaluate(), shaped by frequency, phase and wave form. */
void points_values(const pattern_input *in, double *value);

#endif
