/* csg_lanes.h - several rays and the outline of one tree: the rays in the tree's units, and where each is inside a column. */
#ifndef WORLD_CSG_LANES_H
#define WORLD_CSG_LANES_H

#include "base/simd.h"
#include "world/csg_outline.h"

enum { CSG_TOGETHER = 8 };
typedef double csg_lane[CSG_TOGETHER];

/* Rays as near_ray, and by column where each is inside that; CSG_NEAR_FROM: how far the start is from the middle, and more than one;
 * CSG_NEAR_OPEN: a number other than 0 where all that is not known. */
enum {
    CSG_NEAR_AT, CSG_NEAR_ALONG = CSG_NEAR_AT + 3, CSG_NEAR_SQUARE = CSG_NEAR_ALONG + 3, CSG_NEAR_START, CSG_NEAR_PER_UNIT, CSG_NEAR_FROM,
    CSG_NEAR_OPEN, CSG_NEAR_NUMBERS
};
typedef struct SIMD_ALIGNED csg_near_rays {
    csg_lane of[CSG_NEAR_NUMBERS], in[CSG_FEW], out[CSG_FEW];
    uint8_t ray[CSG_TOGETHER];   /* its lane */
} csg_near_rays;

/* The first crossing: its place, between which distances it is, twice its column and 1 if that is entered; numbers other than 0
 * if the tree is entered, where all that is open, and where there is none. */
typedef struct SIMD_ALIGNED csg_firsts { csg_lane at, lo, hi, crossing, inward, open, passed; } csg_firsts;

/* Of rays, with the columns that all of the tree lies within: the first crossing of a tree with chords, as csg_outline.c finds it for one
 * ray, */
void csg_lanes_first_chord(const csg_tree *t, const pov_rays *restrict rays, csg_near_rays *restrict k, csg_firsts *restrict out);
/* or of one with a table, as csg_sweep.c does. */
void csg_lanes_first_swept(const csg_tree *t, const pov_rays *restrict rays, csg_near_rays *restrict k, csg_firsts *restrict out);

/* The column that a ray starts on, or CSG_COLUMNS. */
static inline uint32_t csg_lanes_column(const csg_tree *t, uint32_t name)
{
    const uint32_t member = name - t->members[0].leaf;

    for (uint32_t i = 0; member < t->member_count && i < t->outline->count; i++)
        if (t->outline->member[i] == member)
            return i;
    return CSG_COLUMNS;
}

/* The columns that hold the tree: a ray that is never within all of them passes it. */
static inline uint32_t csg_lanes_within(const csg_tree *t)
{
    const csg_outline *of = t->outline;
    const uint32_t box = of->boxed ? 1u << of->count : 0;

    if (t->clipped.outlined)
        return box | (((1u << t->clipped.count) - 1) & ~t->clipped.hollows);
    return t->chords.all ? t->chords.within : box | of->within;
}

SIMD_INLINE double csg_lesser(double a, double b) { return a < b ? a : b; }
SIMD_INLINE double csg_greater(double a, double b) { return a > b ? a : b; }

SIMD_INLINE pov_vec3 csg_near_at(const csg_near_rays *restrict k, uint32_t i)
{
    return pov_vec3_of(k->of[CSG_NEAR_AT][i], k->of[CSG_NEAR_AT + 1][i], k->of[CSG_NEAR_AT + 2][i]);
}

SIMD_INLINE pov_vec3 csg_near_along(const csg_near_rays *restrict k, uint32_t i)
{
    return pov_vec3_of(k->of[CSG_NEAR_ALONG][i], k->of[CSG_NEAR_ALONG + 1][i], k->of[CSG_NEAR_ALONG + 2][i]);
}

/* What a slab or quadric and the column have in common. */
SIMD_INLINE void csg_lanes_narrow(csg_stretch s, uint32_t column, uint32_t i, csg_near_rays *restrict io)
{
    io->in[column][i] = csg_greater(s.in, io->in[column][i]);
    io->out[column][i] = csg_lesser(s.out, io->out[column][i]);
    io->of[CSG_NEAR_OPEN][i] = csg_greater(s.open, io->of[CSG_NEAR_OPEN][i]);
}

/* Crossings nearer than that to a place cannot be told from it. */
SIMD_INLINE double csg_lanes_near(const csg_near_rays *restrict k, uint32_t i, double at, bool endless)
{
    return endless ? CSG_OUTLINE_MARGIN * (k->of[CSG_NEAR_FROM][i] + fabs(at)) : CSG_OUTLINE_MARGIN;
}

/* Numbers of a slab or quadric in memory of their own: the outline's would have to be told from the rays' each time that a loop begins. */
SIMD_INLINE void csg_lanes_take(const double *restrict from, uint32_t n, double *restrict out)
{
    for (uint32_t i = 0; i < n; i++)
        out[CSG_FOUR * i] = from[CSG_FOUR * i];
}

SIMD_INLINE void csg_lanes_cross_slab(const double *restrict of, uint32_t column, csg_near_rays *restrict k, bool endless)
{
    const double least = endless ? HUGE_VAL : CSG_LEAST_HEIGHT;
    double number[CSG_FOUR * CSG_SLAB_NUMBERS];

    csg_lanes_take(of, CSG_SLAB_NUMBERS, number);
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++)
        csg_lanes_narrow(csg_cross_slab(number, csg_near_at(k, i), csg_near_along(k, i), least), column, i, k);
}

SIMD_INLINE void csg_lanes_cross_quadric(const double *restrict of, uint32_t column, csg_near_rays *restrict k, bool endless)
{
    double number[CSG_FOUR * CSG_QUADRIC_NUMBERS];

    csg_lanes_take(of, CSG_QUADRIC_NUMBERS, number);
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        csg_stretch s = csg_cross_quadric(number, csg_near_at(k, i), csg_near_along(k, i), endless ? k->of[CSG_NEAR_FROM][i] : 1.0);

        s.open = s.square < 0.0 ? 1.0 : s.open;
        csg_lanes_narrow(s, column, i, k);
    }
}

SIMD_INLINE void csg_lanes_cross_turned(const double *restrict of, const csg_turned *by, bool has_axis, uint32_t column,
                                        csg_near_rays *restrict k)
{
    double number[CSG_FOUR * CSG_QUADRIC_NUMBERS];

    csg_lanes_take(of, CSG_QUADRIC_NUMBERS, number);
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++)
        csg_lanes_narrow(csg_cross_turned(number, by, has_axis, csg_near_at(k, i), csg_near_along(k, i), k->of[CSG_NEAR_SQUARE][i]),
                         column, i, k);
}

SIMD_INLINE void csg_lanes_cross_round(const csg_outline *of, uint32_t column, uint32_t to, csg_near_rays *restrict k, bool endless)
{
    const uint32_t quadric = of->quadric[column];
    const double *restrict number = of->numbers + CSG_SLAB_NUMBERS * of->slabs + csg_number(CSG_QUADRIC_NUMBERS, quadric);
    const csg_turned turned = of->turned && !endless ? of->turned[quadric] : (csg_turned){ .kind = CSG_NOT_TURNED };

    if (turned.kind == CSG_SPHERE)
        csg_lanes_cross_turned(number, &turned, false, to, k);
    else if (turned.kind == CSG_TURNED)
        csg_lanes_cross_turned(number, &turned, true, to, k);
    else
        csg_lanes_cross_quadric(number, to, k, endless);
}

/* What is certainly missed has no ends: those of its slabs may lie where something else is crossed. */
SIMD_INLINE void csg_lanes_leave_missed(uint32_t column, csg_near_rays *restrict k, bool endless)
{
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        const double in = k->in[column][i], out = k->out[column][i];
        const double missed = in - out > csg_lanes_near(k, i, in, endless) ? 1.0 : endless && in == HUGE_VAL ? 1.0 : 0.0;

        k->in[column][i] = missed > 0.0 ? HUGE_VAL : in;
        k->out[column][i] = missed > 0.0 ? -HUGE_VAL : out;
    }
}

/* Of a column, noted as the one of number `to`. endless: as of the outline. */
SIMD_INLINE void csg_lanes_cross(const csg_outline *of, uint32_t column, uint32_t to, csg_near_rays *restrict k, bool endless)
{
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        k->in[to][i] = -HUGE_VAL;
        k->out[to][i] = HUGE_VAL;
    }
    for (uint32_t slab = of->first_slab[column]; slab < of->first_slab[column + 1]; slab++)
        csg_lanes_cross_slab(of->numbers + csg_number(CSG_SLAB_NUMBERS, slab), to, k, endless);
    if (of->round >> column & 1)
        csg_lanes_cross_round(of, column, to, k, endless);
    csg_lanes_leave_missed(to, k, endless);
}

#endif
