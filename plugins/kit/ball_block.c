#include "kit/ball_block.h"

#include "kit/floats.h"

/* Points of a ray near the spheres, the point that it is nearest to one among them, are off by less than 22 e (1 + S), S
 * being the sum of the sizes of its origin's coordinates: docs/numerics.md has the count. Radii that much smaller and
 * larger, and bounds that much wider, make the answer safe. */
#define BLUR (24.0f * KIT_E)

static double place(pov_two c, double centre, double scale) { return (c.hi - centre + c.lo) * scale; }

bool kit_ball_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    kit_ball_block *b = block;
    uint32_t i;

    if (!frame)
        return false;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const kit_ball *s = selves[i < n ? i : 0];

        b->x[i] = (float)place(s->centre.x, frame->centre.x, frame->scale);
        b->y[i] = (float)place(s->centre.y, frame->centre.y, frame->scale);
        b->z[i] = (float)place(s->centre.z, frame->centre.z, frame->scale);
        b->radius[i] = i < n ? (float)(s->radius.hi * frame->scale) : NAN;
    }
    return true;
}

/* The lanes whose spheres the line of a ray may come near to, how far it has gone there, and the square of how near. */
static inline uint32_t near_lines(const kit_ball_block *s, const pov_rays *rays, uint32_t at, float blur,
                                  float *restrict middle, float *restrict ww)
{
    const float ox = rays->framed.org[0][at], oy = rays->framed.org[1][at], oz = rays->framed.org[2][at];
    const float dx = rays->framed.dir[0][at], dy = rays->framed.dir[1][at], dz = rays->framed.dir[2][at];
    kit_bits met;
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const float x = s->x[i] - ox, y = s->y[i] - oy, z = s->z[i] - oz, outer = s->radius[i] + blur;
        const float m = kit_float_sum(z, dz, kit_float_sum(y, dy, x * dx));
        const float wx = kit_float_sum(-m, dx, x), wy = kit_float_sum(-m, dy, y), wz = kit_float_sum(-m, dz, z);

        middle[i] = m;
        ww[i] = kit_float_sum(wz, wz, kit_float_sum(wy, wy, wx * wx));
        met.lane[i] = -(ww[i] <= outer * outer * (1.0f + 8.0f * KIT_E));
    }
    return kit_gather_bits(&met);
}

/* Bounds along the ray on the chords that its line and the spheres share, as long as there is one: on where it comes in or,
 * where it starts within, leaves. */
typedef struct chords {
    float lo[POV_BLOCK_MAX], hi[POV_BLOCK_MAX];
    uint32_t maybe, surely, twice;   /* by lane, as of a meeting */
} chords;

static inline void bound_chords(const kit_ball_block *s, float blur, float smax, const float *restrict middle,
                                const float *restrict ww, chords *restrict out)
{
    const float sure = smax * (1.0f - 16.0f * KIT_E) - blur;   /* no further away than tmax */
    kit_bits maybe, surely, twice;
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const float outer = s->radius[i] + blur, inner = s->radius[i] - blur;
        const float wide = sqrtf(outer * outer * (1.0f + 8.0f * KIT_E) - ww[i]) + blur;
        const float narrow = sqrtf(inner * inner * (1.0f - 8.0f * KIT_E) - ww[i]) - blur;
        const float in = middle[i] - wide, surely_in = middle[i] - narrow;
        const float out_from = middle[i] + narrow, out_to = middle[i] + wide;
        const int known = (inner > 0.0f) & (narrow > 0.0f), within = known & (surely_in < 0.0f);
        const float lo = within ? out_from : in, hi = within ? out_to : surely_in;

        out->lo[i] = lo;
        out->hi[i] = hi;
        maybe.lane[i] = -((in <= smax) & (out_to >= 0.0f));
        surely.lane[i] = -(known & (lo > 0.0f) & (hi < sure));
        twice.lane[i] = -(known & (in > 0.0f) & (out_to < sure));
    }
    out->maybe = kit_gather_bits(&maybe);
    out->surely = kit_gather_bits(&surely);
    out->twice = kit_gather_bits(&twice);
}

static inline uint32_t tell(const chords *c, const pov_rays *rays, uint32_t at, pov_meeting *out, uint32_t n)
{
    const double shift = rays->framed.shift[at], unit = rays->framed.unit[at];
    uint32_t mask;

    for (mask = c->maybe; mask; mask &= mask - 1, n++) {
        const uint32_t i = kit_first_lane(mask);

        out[n].lo = shift + (double)c->lo[i] * unit;
        out[n].hi = shift + (double)c->hi[i] * unit;
        out[n].ray = (uint8_t)at;
        out[n].lane = (uint8_t)i;
        out[n].surely = c->surely >> i & 1;
        out[n].twice = c->twice >> i & 1;
    }
    return n;
}

/* Static, since the names of clones would be seen from outside. Most blocks are passed by on every lane: that is found
 * out first. */
KIT_CLONES static uint32_t filter(const kit_ball_block *s, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                                  pov_meeting *out)
{
    float middle[POV_BLOCK_MAX], ww[POV_BLOCK_MAX];
    uint32_t n = 0;
    chords c;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t at = kit_first_lane64(lanes);
        const float blur = BLUR * (1.0f + rays->framed.size[at]);

        const uint32_t near = near_lines(s, rays, at, blur, middle, ww) & ~kit_owned_by(owners, rays->away[at]);

        if (!near)
            continue;
        bound_chords(s, blur, rays->framed.smax[at], middle, ww, &c);
        c.maybe &= near;
        n = tell(&c, rays, at, out, n);
    }
    return n;
}

uint32_t kit_ball_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    return filter(block, owners, rays, lanes, out);
}
