/* narrow.h - rays that come to the box of a shape, several side by side in doubles in the shape's local space: which of them
 * certainly pass it, and which certainly hit it. docs/numerics.md ("Rays at a box") has the bounds. */
#ifndef COMMON_NARROW_H
#define COMMON_NARROW_H

#include "common/boxed.h"
#include "common/simd.h"

enum { COMMON_BEAMS = 8 };
typedef double common_beam[COMMON_BEAMS];

/* By lane: the ray is at org + s dir, a unit vector, and begins at s = 0, or comes to the box there. What counts for it is between
 * `from` and `to`, and certainly does between sure_from and sure_to. Places are off by `off` at most, and lengths too. */
typedef struct common_beams {
    common_beam org[3], dir[3], from, to, sure_from, sure_to, off;
    uint32_t feature[COMMON_BEAMS];    /* that it starts on, or UINT32_MAX; and the u of its mark */
    common_beam u;
} common_beams;

/* 1 where the shape is certainly passed, or certainly hit between lo and hi; it is not hit before lo. */
typedef struct common_verdicts { common_beam passed, hit, lo, hi; } common_verdicts;

/* What a shape says of them; its crossings at the very start of a ray on it do not count. */
typedef void common_look(const void *self, const common_beams *restrict l, common_verdicts *restrict out);

/* narrow() of a class. */
typedef uint32_t common_narrow_of(const void *self, const pov_own_map *map, uint32_t owner, const pov_rays *rays, pov_candidate *io, uint32_t n);

/* What shapes that nothing has moved have for a block: themselves, each of which is asked by its class's narrow(). */
typedef struct common_narrow_block { common_narrow_of *narrow; uint64_t count; const void *self[POV_BLOCK_MAX]; } common_narrow_block;
enum { COMMON_NARROW_SINGLE = offsetof(common_narrow_block, self[1]) };
bool common_narrow_pack(common_narrow_block *out, common_narrow_of *narrow, const void *const *selves, uint32_t n);
uint32_t common_narrow_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_candidate *out);

/* block_pack() of a class. */
#define COMMON_NARROW_PACK(closer)                                                                                           \
    static bool block_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)                       \
    {                                                                                                                        \
        (void)frame;                                                                                                         \
        return common_narrow_pack(block, closer, selves, n);                                                                 \
    }
/* And what a class has of that. */
#define COMMON_NARROW_BLOCKS(closer)                                                                                         \
    .block_size = sizeof(common_narrow_block), .single_block_size = COMMON_NARROW_SINGLE, .block_pack = block_pack,          \
    .block_filter = common_narrow_filter, .narrow = closer

/* narrow() of a shape in a box. */
uint32_t common_narrow(const common_boxed *b, common_look *look, const void *self, const pov_own_map *map, uint32_t owner,
                       const pov_rays *rays, pov_candidate *io, uint32_t n);

#endif
