/* distance.c - distances from the origin, an axis or a plane: spherical, cylindrical, boxed, planar, onion. */
#include "texture/pattern.h"

/* 1 at distance 0, 0 from 1 on. */
SIMD_INLINE double near(double distance) { return distance < 1.0 ? 1.0 - distance : 0.0; }

SIMD_CLONES static void find_distance(const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = sqrt(at->x[i] * at->x[i] + at->y[i] * at->y[i] + at->z[i] * at->z[i]);
}

SIMD_CLONES static void to_near(uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = near(value[i]);
}

static void evaluate_spherical(const pattern_input *in, double *value)
{
    find_distance(in->at, lanes_whole(in->n), value);
    to_near(lanes_whole(in->n), value);
}

/* The rest of a division by 1. */
SIMD_CLONES static void to_shells(uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] -= floor(value[i]);
}

static void evaluate_onion(const pattern_input *in, double *value)
{
    find_distance(in->at, lanes_whole(in->n), value);
    to_shells(lanes_whole(in->n), value);
}

SIMD_CLONES static void find_cylindrical(const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = near(sqrt(at->x[i] * at->x[i] + at->z[i] * at->z[i]));
}

static void evaluate_cylindrical(const pattern_input *in, double *value)
{
    find_cylindrical(in->at, lanes_whole(in->n), value);
}

SIMD_CLONES static void find_planar(const double *restrict y, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = near(fabs(y[i]));
}

static void evaluate_planar(const pattern_input *in, double *value)
{
    find_planar(in->at->y, lanes_whole(in->n), value);
}

SIMD_CLONES static void find_boxed(const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = fabs(at->x[i]), y = fabs(at->y[i]), z = fabs(at->z[i]), most = x > y ? x : y;

        value[i] = near(most > z ? most : z);
    }
}

static void evaluate_boxed(const pattern_input *in, double *value)
{
    find_boxed(in->at, lanes_whole(in->n), value);
}

const pattern_class pattern_spherical = { .keyword = "spherical", .evaluate = evaluate_spherical };
const pattern_class pattern_onion = { .keyword = "onion", .evaluate = evaluate_onion };
const pattern_class pattern_cylindrical = { .keyword = "cylindrical", .evaluate = evaluate_cylindrical };
const pattern_class pattern_planar = { .keyword = "planar", .evaluate = evaluate_planar };
const pattern_class pattern_boxed = { .keyword = "boxed", .evaluate = evaluate_boxed };
