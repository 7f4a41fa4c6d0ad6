/* tiny.h - scenes built by hand for the rooms that do not read text: spheres and infinite planes of the tests' own. */
#ifndef SUPPORT_TINY_H
#define SUPPORT_TINY_H

#include "plug/shape_class.h"
#include "shade/tracer.h"

typedef struct tiny { env env; model model; world *world; shading *shading; pov_tracer *tracer; } tiny;

/* Five levels, black background, white ambient light, no gamma, a camera at 0 that looks along z; and no objects. */
void tiny_begin(tiny *s, const pov_allocator *memory);
void tiny_end(tiny *s);
/* The language's default material of this colour, with ambient light only. */
material tiny_emitted(float r, float g, float b);
/* The default material, white, without ambient light. */
material tiny_matt(void);
/* A material that only transmits. */
material tiny_glass(double ior);
void tiny_sphere(tiny *s, double x, double y, double z, double radius, material m);
/* The points p with p.n = d, n of unit length; seen from both sides, with no inside. */
void tiny_plane(tiny *s, double x, double y, double z, double d, material m);
/* An object of any class. */
void tiny_add(tiny *s, const shape_class *shape, const void *instance, material m);
void tiny_light(tiny *s, double x, double y, double z, float r, float g, float b);
/* Compile it: after the last object. */
void tiny_build(tiny *s);
/* Colour seen from a point in a direction. */
colour tiny_trace(tiny *s, pov_vec3 from, double x, double y, double z);
void assert_colour(colour c, double r, double g, double b, double tolerance);

#endif
