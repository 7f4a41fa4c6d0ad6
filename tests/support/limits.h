/* limits.h - scenes written once and then scaled and moved, and comparisons of pictures. */
#ifndef SUPPORT_LIMITS_H
#define SUPPORT_LIMITS_H

#include <povtrace/povtrace.h>

/* A point p of the scene is placed at scale p + move. */
typedef struct limits_frame { double scale; pov_vec3 move; } limits_frame;

extern const limits_frame limits_home;

/* Templates are scene text with these marks, filled in for a frame: @p{x,y,z} a point, @v{x,y,z} a vector of lengths,
 * @l{x} a length, @s{x} a square of lengths, @n{x} a number that stays. The caller frees the text. */
char *limits_text(const char *template, const limits_frame *frame);
/* Load the same; the test fails on any error. */
pov_scene *limits_scene(pov_context *context, const char *template, const limits_frame *frame,
                        const pov_load_desc *desc);
/* Render the same, linear float RGBA; the caller frees it. */
float *limits_picture(pov_context *context, const char *template, const limits_frame *frame, int width, int height);

/* Number of pixels with a channel that differs by more than `tolerance` (0: in any bit). */
long limits_count(const float *a, const float *b, int width, int height, float tolerance);
/* Number of pixels that match the colour in all channels within the tolerance. */
long limits_count_colour(const float *a, int width, int height, const float colour[3], float tolerance);

/* Colour seen along a ray. */
void limits_trace(const pov_scene *scene, pov_vec3 from, pov_vec3 direction, float rgba[4]);

/* Every primitive, two lights, shadows, a mirror, glass, transformations. Coordinates are multiples of 1/64 below 64,
 * so that moves by whole numbers below 2^46 are exact. */
extern const char limits_everything[];

#endif
