/* polynomial.h - surfaces where a polynomial of x, y and z is zero; inside where it is below. */
#ifndef COMMON_POLYNOMIAL_H
#define COMMON_POLYNOMIAL_H

#include "common/local.h"

enum { COMMON_ORDER_MAX = 35 };

/* The terms with x^i y^j that are not zero: from first[row] on to first[row + 1]. */
typedef struct common_term { double c; int k; } common_term;

/* Coefficients by falling power of x, then of y, then of z. */
typedef struct common_polynomial {
    int order;
    uint32_t count;
    double *at;
    common_term *term;
    uint32_t *first;             /* by row, in the order of the coefficients */
    int *highest;                /* by i, the largest j that is there; -1: none */
    int highest_x, highest_z;
    bool bounded;                /* all of the surface, and of what is inside, is in the box */
    pov_box box;
} common_polynomial;

/* Memory for all coefficients, zero. False after an error. */
bool common_polynomial_make(common_polynomial *p, const pov_host *host, pov_reader *in, int order);
/* The place of a term: x^i y^j z^k. */
uint32_t common_polynomial_place(int order, int i, int j, int k);
/* All coefficients between < and >, and `sturm`. */
void common_polynomial_read(common_polynomial *p, const pov_host *host, pov_reader *in, int order);

/* To be called when all coefficients are there. */
void common_polynomial_close(common_polynomial *p, const pov_host *host, pov_reader *in);
/* Looks for a box around it. False: none was found. */
bool common_polynomial_find_box(const common_polynomial *p, pov_box *out);

/* Functions of the class. */
bool common_polynomial_bounds(const void *self, pov_box *out);
void common_polynomial_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void common_polynomial_intersect_between(const void *self, const pov_ray *ray, pov_hits *hits);
void common_polynomial_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
void common_polynomial_intersect_between_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
void common_polynomial_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                                   pov_vec3 *const *out, uint32_t n);
bool common_polynomial_inside(const void *self, pov_vec3 point, pov_vec3 point_lo);

#define COMMON_POLYNOMIAL_CLASS(word, reader)                                                                              \
    static const pov_shape_fast fast = { .size = sizeof(pov_shape_fast),                                                   \
                                         .normal_many = common_polynomial_normal_many,                                     \
                                         .intersect_between = common_polynomial_intersect_between,                         \
                                         .intersect_between_many = common_polynomial_intersect_between_many };             \
    static const void *extension(const char *name) { return common_is_fast(name) ? &fast : NULL; }                         \
    static const pov_shape_class word##_class = {                                                                          \
        .size = sizeof(pov_shape_class),                                                                                   \
        .flags = POV_SHAPE_SOLID,                                                                                          \
        .keyword = #word,                                                                                                  \
        .instance_size = sizeof(common_polynomial),                                                                        \
        .parse = reader,                                                                                                   \
        .bounds = common_polynomial_bounds,                                                                                \
        .intersect = common_polynomial_intersect,                                                                          \
        .normal = common_polynomial_normal,                                                                                \
        .inside = common_polynomial_inside,                                                                                \
        .extension = extension,                                                                                            \
    };                                                                                                                     \
    static const pov_shape_class *const shapes[] = { &word##_class, NULL };                                                \
    POV_PLUGIN(word) = { .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = #word, .version = "1", .shapes = shapes }

#endif
