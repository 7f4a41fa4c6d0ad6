/* warp.h - what moves a point before a pattern is asked for its value, and what is done to that value. */
#ifndef MODEL_WARP_H
#define MODEL_WARP_H

#include <povtrace/math.h>

#include <stdbool.h>
#include <stdint.h>

/* Noise summed over octaves: each is the one before at lambda times the frequency and omega times the height. */
typedef struct turbulence {
    pov_vec3 amount;
    uint32_t octaves;            /* 1 to 10 */
    float lambda, omega;
} turbulence;

static inline turbulence turbulence_default(void)
{
    const turbulence t = { { 0.0, 0.0, 0.0 }, 6, 2.0f, 0.5f };

    return t;
}

/* 1 to 10, whatever is asked for. */
static inline uint32_t turbulence_octaves(double count)
{
    return count >= 10.0 ? 10 : count >= 1.0 ? (uint32_t)count : 1;
}

static inline bool turbulence_is_none(const turbulence *t)
{
    return t->amount.x == 0.0 && t->amount.y == 0.0 && t->amount.z == 0.0;
}

/* ---- warps ---- */

typedef enum warp_kind {
    WARP_REPEAT, WARP_BLACK_HOLE, WARP_TURBULENCE, WARP_CYLINDRICAL, WARP_SPHERICAL, WARP_TOROIDAL, WARP_PLANAR, WARP_CUBIC
} warp_kind;

typedef struct warp_repeat { int axis; double width; bool flip[3]; pov_vec3 offset; } warp_repeat;
typedef struct warp_black_hole {
    pov_vec3 center, repeat;     /* repeat: the length of the cells on each axis, 0: none */
    double radius, strength, falloff;
    bool is_inverse;
    pov_vec3 turbulence;         /* moves the hole of each cell */
} warp_black_hole;
/* The orientation is of unit length; <0, 0, 1> leaves the result as it is. */
typedef struct warp_mapping { pov_vec3 orientation; double dist_exp, major_radius, distance; } warp_mapping;

/* One warp and what stands before it in the text, which is applied after it. */
typedef struct warp {
    warp_kind kind;
    union {
        warp_repeat repeat;
        warp_black_hole black_hole;
        turbulence turbulence;
        warp_mapping mapping;
    } as;
    bool has_map;
    double map[3][4];            /* inverse of the transformations between this warp and the next */
    const struct warp *next;
} warp;

/* ---- waves ---- */

typedef enum wave_form { WAVE_RAMP, WAVE_TRIANGLE, WAVE_SINE, WAVE_SCALLOP, WAVE_CUBIC, WAVE_POLY } wave_form;
typedef struct wave {
    wave_form form;
    float frequency, phase, exponent;
} wave;

static inline wave wave_default(wave_form form)
{
    const wave w = { form, 1.0f, 0.0f, 1.0f };

    return w;
}

#endif
