/* instance_parts.h - numbers of the filter before a placed shape: docs/numerics.md ("Block filters") derives them. */
#ifndef WORLD_INSTANCE_PARTS_H
#define WORLD_INSTANCE_PARTS_H

#include "world/instance.h"

#define PLACEMENT_LEAST 1e-30
#define PLACEMENT_LARGE 1e30       /* no half is larger: its inverse is a float */
#define PLACEMENT_SMALL 1e-20      /* nor smaller, of what is more than in its box */
#define PLACEMENT_FLAT 0x1p-24     /* no half is less of the sum of sizes of its row, for points of the box */
#define PLACEMENT_RANGE 1e100
#define PLACEMENT_ROUNDED 0x1p-48  /* of their coordinates bounds may be too wide */

#define PLACEMENT_E 0x1p-24f
#define PLACEMENT_LOST (48.0f * PLACEMENT_E)
#define PLACEMENT_MOST 0x1p20f     /* of what is lost; else no float would hold what comes of it */
#define PLACEMENT_UNSURE 0x1p-4f   /* with more lost than that nothing is certain */
#define PLACEMENT_SNUG (1.0 - 0x1p-18)
#define PLACEMENT_OUTER (1.0f + 0x1p-17f)   /* of a ball, whose centre is as far from the anchor as its sides tell */
#define PLACEMENT_INNER (1.0f - 0x1p-16f)

#endif
