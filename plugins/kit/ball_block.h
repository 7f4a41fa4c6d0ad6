/* ball_block.h - up to eight spheres at once, in plain double: which of them a ray may meet, which surely, where. */
#ifndef KIT_BALL_BLOCK_H
#define KIT_BALL_BLOCK_H

#include "kit/ball.h"

typedef struct kit_ball_block {
    double x[POV_BLOCK_MAX], y[POV_BLOCK_MAX], z[POV_BLOCK_MAX];
    double outer[POV_BLOCK_MAX];    /* the radius and what centre and radius lost */
    double square[POV_BLOCK_MAX];   /* of outer, rounded up; below all for lanes without a sphere */
    double most;    /* the largest outer */
    double band;    /* outer less this is the radius less what centre and radius lost, or below that */
    double reach;   /* no centre is further from the origin, by sum of sizes */
    int64_t lanes;  /* those that hold a sphere */
} kit_ball_block;

/* A sphere is to take less than 220 bytes of a process that draws a million of them: a seventh line would be too much. */
typedef char kit_ball_block_takes_six_lines[sizeof(kit_ball_block) <= 6 * 64 ? 1 : -1];

/* selves: each a kit_ball. False: out of range. */
bool kit_ball_pack(void *block, const void *const *selves, uint32_t n);
void kit_ball_filter(const void *block, const pov_ray *ray, double tmin, double tmax, pov_block_answer *out);
uint64_t kit_ball_filter_many(const void *block, const pov_rays *rays, uint64_t lanes, pov_block_answer *out);

#endif
