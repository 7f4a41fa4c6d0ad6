/* cone_lanes.h - several pairs of a cylinder or cone and a ray, side by side. */
#ifndef COMMON_CONE_LANES_H
#define COMMON_CONE_LANES_H

#include "common/cone_approx.h"
#include "common/lanes.h"

/* Fewer lanes than COMMON_LANES: a shape has many numbers to copy, so unused lanes cost much. */
enum { TOGETHER = 4 };

/* Number of doubles at the start of a shape that rays need, rounded up to a multiple of four. */
#define NUMBER_OF(member) (offsetof(common_cone, member) / sizeof(double))
enum { NUMBERS = (NUMBER_OF(open) + 3) / 4 * 4 };

typedef struct cone_lanes {
    common_rays rays;
    double number[NUMBERS][TOGETHER];
} cone_lanes;

COMMON_INLINE void put_pairs(cone_lanes *l, const void *const shapes[TOGETHER], const pov_ray *const rays[TOGETHER])
{
    common_put_four_shapes(l->number[0], TOGETHER, NUMBERS, shapes);
    common_put_four_rays(&l->rays, 0, rays);
}

static inline pov_two get_two(const cone_lanes *l, uint32_t i, size_t number)
{
    return pov_two_of(l->number[number][i], l->number[number + 1][i]);
}

static inline pov_two3 get_two3(const cone_lanes *l, uint32_t i, size_t number)
{
    return two3_of(get_two(l, i, number), get_two(l, i, number + 2), get_two(l, i, number + 4));
}

/* The shape of a lane, without the members behind its numbers. */
static inline common_cone get_shape(const cone_lanes *l, uint32_t i)
{
    common_cone s;

    s.anchor = get_two3(l, i, NUMBER_OF(anchor));
    s.row[0] = get_two3(l, i, NUMBER_OF(row));
    s.row[1] = get_two3(l, i, NUMBER_OF(row) + 6);
    s.row[2] = get_two3(l, i, NUMBER_OF(row) + 12);
    s.loss[0] = l->number[NUMBER_OF(loss)][i];
    s.loss[1] = l->number[NUMBER_OF(loss) + 1][i];
    s.loss[2] = l->number[NUMBER_OF(loss) + 2][i];
    s.radius = get_two(l, i, NUMBER_OF(radius));
    s.slope = get_two(l, i, NUMBER_OF(slope));
    s.height = get_two(l, i, NUMBER_OF(height));
    s.scale = l->number[NUMBER_OF(scale)][i];
    return s;
}

#endif
