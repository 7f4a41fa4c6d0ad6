/* shapes.h - shape classes of the tests' own, so that the world is tested without plugins, and models made of them. */
#ifndef SUPPORT_SHAPES_H
#define SUPPORT_SHAPES_H

#include "model/model.h"
#include "query/query.h"

#include "plug/shape_class.h"

typedef struct test_sphere_shape { pov_vec3 centre; double radius; } test_sphere_shape;
typedef struct test_brick { pov_vec3 lo, hi; } test_brick;
typedef struct test_ground { double height; } test_ground;

extern const shape_class test_sphere_class;     /* blocks, absorbs similar maps */
extern const shape_class test_loose_sphere_class; /* blocks, but no box: as if infinite */
extern const shape_class test_plain_sphere_class; /* neither */
extern const shape_class test_brick_class;      /* no blocks; absorbs moves */
extern const shape_class test_ground_class;     /* y < height, infinite */

/* Random numbers that are the same on every machine. */
typedef struct test_random { uint64_t state; } test_random;
double test_uniform(test_random *r, double lo, double hi);
uint32_t test_below(test_random *r, uint32_t n);
pov_vec3 test_direction(test_random *r);

/* Name what a ray leaves that starts where h is: it goes to either side. */
void test_leave(pov_ray *ray, const hit *h);

/* The nearest hit of one ray. */
bool test_nearest(const world *w, query_context *k, const pov_ray *ray, double tmax, hit *out);
/* Is light not blocked? count: how many transparent surfaces it crosses; of the first TEST_CROSSINGS, whose they are. */
enum { TEST_CROSSINGS = 64 };
bool test_light(const world *w, query_context *k, const pov_ray *ray, double tmax, uint32_t owners[TEST_CROSSINGS],
                uint32_t *count);

/* A model of one opaque white material (index 0). NULL env: malloc. */
void test_model_init(model *m, const env *e);
/* Each asserts that memory sufficed, and gives the index. */
uint32_t test_add_material(model *m, colour c, float filter, float transmit, bool has_interior);
uint32_t test_add(model *m, const shape_class *shape, const void *instance, const transform *map, uint32_t surface,
                  uint32_t flags);
void test_add_light(model *m, float brightness);
uint32_t test_add_sphere(model *m, pov_vec3 centre, double radius, uint32_t surface);
const transform *test_transform(model *m, const transform *before, transform_kind kind, double x, double y, double z);

#endif
