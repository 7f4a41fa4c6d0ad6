/* placement_parts.h - the filter before a placed shape: what it is made of, and why it is right.
 *
 * With w from the anchor to the ray's start and A the inverse, a ray that meets the shape at t has |A (w + t d)| <= half
 * on each axis. What is lost, each in units of u = 2^-53 and with |A| taken entry by entry:
 *   - w: two roundings of terms no larger than `size`, the sum of their sizes; A's low parts; three products and two
 *     sums: less than 8 |A| size;
 *   - A d: less than 4 |A| |d|, which is seen at t. There |t d| <= size + reach, reach being the edges of the box in the
 *     world, whose middle is the anchor; and t itself may be off by 2^7: less than 2^8 |A| (size + reach);
 *   - the inverse of a component of A d, the products with it, and their sum: less than 8 (half + |A| size).
 * 2^13 of them are allowed for: |A| reach stands in `half`, |A| size is added for each ray. Within PLACEMENT_RANGE no
 * product overflows, and none that underflows moves a point by as much as PLACEMENT_LEAST. A component of A d that is
 * zero has distances without end, or what is no number, which compares with nothing: all of the axis or none.
 *
 * A shape that is its box, all sides of which are as far from the anchor as `half` says within 2^-18, holds each t for
 * which the filter sees the ray deeper in the box than 2^-16 of half and the largest of what is lost on the axes. That
 * has to be shown for |t d| without the bound above. As t d = M q - w for the point q that is met, M being the map,
 * v = |A| (size + |t d|) is at most 2 |A| size + |A| reach + 2^4 u N v with N = |A| |M|, the rows of which sum up to no
 * more than PLACEMENT_TAME = 2^20: all v are below 2^-28 of the largest of them and what is counted above.
 *
 * A ball's equation is taken about the ray's point nearest to the anchor. It and what the equation is off by are less
 * than 2^4 u of |A| size and the radius in each coordinate, along the ray as across it, and a radius that is larger by as
 * much makes each half of a chord longer by more. The centre is within 2^-18 of the radius from the anchor, since the
 * sides are; PLACEMENT_OUTER holds that, and PLACEMENT_INNER is less by as much and more. */
#ifndef WORLD_PLACEMENT_PARTS_H
#define WORLD_PLACEMENT_PARTS_H

#include "world/placement.h"

#define PLACEMENT_LOST 0x1p-40
#define PLACEMENT_LATE 0x1p-46     /* of a distance */
#define PLACEMENT_LEAST 1e-30
#define PLACEMENT_LARGE 1e30       /* no half is larger: they are floats */
#define PLACEMENT_SMALL 1e-20      /* nor smaller, of what is more than in its box */
#define PLACEMENT_RANGE 1e100
#define PLACEMENT_ROUNDED 0x1p-48  /* of their coordinates bounds may be too wide */
#define PLACEMENT_TAME 0x1p20
#define PLACEMENT_SNUG (1.0 - 0x1p-18)
#define PLACEMENT_INNER (1.0 - 0x1p-16)
#define PLACEMENT_OUTER (1.0 + 0x1p-17)

#endif
