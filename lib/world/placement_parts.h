/* placement_parts.h - the filter before a placed shape: what its copies for different processors share.
 *
 * With w from the anchor to the ray's start and A the inverse, a ray that meets the shape at t has |A (w + t d)| <= half
 * on each axis. What is lost, each in units of u = 2^-53 and with |A| taken entry by entry:
 *   - w: two roundings of terms no larger than `size`, the sum of their sizes; A's low parts; three products and two
 *     sums: less than 8 |A| size;
 *   - A d: less than 4 |A| |d|, which is seen at t. There |t d| <= size + reach, reach being the edges of the box in the
 *     world, whose middle is the anchor; and t itself may be off by 2^7: less than 2^8 |A| (size + reach);
 *   - the inverse of a component of A d, and the products with it: less than 4 (half + |A| size).
 * 2^13 of them are allowed for: |A| reach stands in `half`, |A| size is added for each ray. Within PLACEMENT_RANGE no
 * product overflows, and none that underflows moves a point by as much as PLACEMENT_LEAST. A component of A d that is
 * zero has two infinite distances, or one infinity and a NaN, which compares with nothing: all of the axis or none. */
#ifndef WORLD_PLACEMENT_PARTS_H
#define WORLD_PLACEMENT_PARTS_H

#include "world/placement.h"

#define PLACEMENT_LOST 0x1p-40
#define PLACEMENT_LATE 0x1p-46     /* of a distance */
#define PLACEMENT_LEAST 1e-30
#define PLACEMENT_LARGE 1e30       /* no half is larger: they are floats */
#define PLACEMENT_RANGE 1e100

/* Are ray and shape in the range of the filter? size: of the start seen from the anchor. */
static inline bool placement_filters(const placement *p, pov_vec3 size, pov_vec3 d)
{
    const double speed = fabs(d.x) + fabs(d.y) + fabs(d.z);

    return p->boxed && speed > 1.0 / PLACEMENT_RANGE && speed < PLACEMENT_RANGE &&
           size.x + size.y + size.z < PLACEMENT_RANGE;
}

#endif
