/* lanes.h - the plainest block filter: the boxes of up to eight shapes, side by side. */
#ifndef METHODS_LANES_H
#define METHODS_LANES_H

#include "common/simd.h"

typedef struct lane_boxes { double lo[3][POV_BLOCK_MAX], hi[3][POV_BLOCK_MAX]; int64_t lanes; } lane_boxes;

static inline bool lanes_pack(lane_boxes *b, bool (*bounds)(const void *, pov_box *), const void *const *selves, uint32_t n)
{
    uint32_t i;

    b->lanes = (1 << n) - 1;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        pov_box box;

        if (!bounds(selves[i < n ? i : 0], &box))
            return false;
        b->lo[0][i] = box.lo.x, b->lo[1][i] = box.lo.y, b->lo[2][i] = box.lo.z;
        b->hi[0][i] = box.hi.x, b->hi[1][i] = box.hi.y, b->hi[2][i] = box.hi.z;
    }
    return true;
}

/* Widened by a few roundings, as any tree's boxes are. */
static inline void lanes_result(const lane_boxes *b, const pov_rays *rays, uint32_t at, common_result *out)
{
    const double o[3] = { rays->org[0][at], rays->org[1][at], rays->org[2][at] };
    const double d[3] = { rays->dir[0][at], rays->dir[1][at], rays->dir[2][at] }, tmax = rays->tmax[at];
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    double far[POV_BLOCK_MAX], inverse[3], pad[3];
    int64_t hit = 0;
    uint32_t i;
    int axis;

    for (axis = 0; axis < 3; axis++) {
        inverse[axis] = 1.0 / (fabs(d[axis]) > 1e-120 ? d[axis] : 1e-120);
        pad[axis] = 1e-14 * fabs(o[axis]);
    }
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        out->lo[i] = out->hi[i] = 0.0;
        far[i] = tmax;
    }
    for (axis = 0; axis < 3; axis++) {
        const bool down = inverse[axis] < 0.0;
        const double *first = down ? b->hi[axis] : b->lo[axis], *last = down ? b->lo[axis] : b->hi[axis];
        const double from = down ? o[axis] - pad[axis] : o[axis] + pad[axis];
        const double to = down ? o[axis] + pad[axis] : o[axis] - pad[axis];

        for (i = 0; i < POV_BLOCK_MAX; i++) {
            const double a = (first[i] - from) * inverse[axis], z = (last[i] - to) * inverse[axis];

            out->lo[i] = a > out->lo[i] ? a : out->lo[i];
            far[i] = z < far[i] ? z : far[i];
        }
    }
    for (i = 0; i < POV_BLOCK_MAX; i++)
        hit |= out->lo[i] <= far[i] * (1.0 + 1e-15) ? bit[i] : 0;
    out->maybe = (uint32_t)(hit & b->lanes);
    out->definite = out->definite_pair = 0;
}

static inline uint32_t lanes_filter(const lane_boxes *b, const pov_rays *rays, uint64_t lanes, pov_candidate *out)
{
    uint32_t n = 0;
    common_result a;

    for (; lanes; lanes &= lanes - 1) {
        lanes_result(b, rays, common_first_lane64(lanes), &a);
        n = common_candidates(&a, common_first_lane64(lanes), out, n);
    }
    return n;
}

/* The members of a fast extension for shapes that have boxes. */
#define METHODS_LANES(bounds)                                                                                       \
    static bool block_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)              \
    {                                                                                                               \
        (void)frame;                                                                                                \
        return lanes_pack(block, bounds, selves, n);                                                                \
    }                                                                                                               \
    COMMON_CLONES static uint32_t block_filter(const void *block, const uint32_t *owners, const pov_rays *rays,     \
                                               uint64_t lanes, pov_candidate *out)                                  \
    {                                                                                                               \
        (void)owners;                                                                                               \
        return lanes_filter(block, rays, lanes, out);                                                               \
    }

#endif
