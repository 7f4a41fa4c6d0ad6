#include "kit/ball_block.h"

#include "kit/floats.h"

/* Error bound. Points of a ray near the spheres, the point closest to a sphere included, are off by less than 23 e (1 +
 * S), S being the sum of the sizes of its origin's coordinates: docs/numerics.md has the count. Enlarging and shrinking
 * radii, and widening bounds by that much makes the result safe. */
#define BLUR (24.0f * KIT_E)
/* The same bound for the line of one ray of a packet, and for the differences of the other rays from it. */
#define BEAM_BLUR (32.0f * KIT_E)

/* Packets of this many rays or more are tested as a whole first. Rays of smaller packets mostly differ too much to
 * exclude spheres. */
enum { BEAM_LEAST = 24 };
/* Rays take the lanes when there are at least this many for each remaining sphere. */
enum { BEAM_RAYS = 4 };
/* The centre of a square of rays, by rows. */
enum { BEAM_MIDDLE = 28 };

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

/* A sphere of the block, and a ray, in the frame. */
typedef struct ball { kit_three centre; float radius; } ball;
typedef struct line { kit_three org, dir; float blur; } line;

KIT_INLINE ball ball_of(const kit_ball_block *s, size_t i)
{
    const ball b = { { s->x[i], s->y[i], s->z[i] }, s->radius[i] };

    return b;
}

KIT_INLINE line line_of(const pov_rays *rays, size_t at)
{
    const line l = { { rays->framed.org[0][at], rays->framed.org[1][at], rays->framed.org[2][at] },
                     { rays->framed.dir[0][at], rays->framed.dir[1][at], rays->framed.dir[2][at] },
                     BLUR * (1.0f + rays->framed.size[at]) };
    return l;
}

/* The point of a line closest to a centre: its distance along the line, and the squared distance to the centre. */
typedef struct nearest { float middle, ww; } nearest;

/* The distance to the centre is the length of a cross product, which does not wait for the distance along the line. */
KIT_INLINE nearest near_line(const ball *b, const line *l)
{
    const kit_three c = { b->centre.x - l->org.x, b->centre.y - l->org.y, b->centre.z - l->org.z };
    const kit_three w = { kit_float_sum(-c.z, l->dir.y, c.y * l->dir.z), kit_float_sum(-c.x, l->dir.z, c.z * l->dir.x),
                          kit_float_sum(-c.y, l->dir.x, c.x * l->dir.y) };
    const nearest n = { kit_dot(c, l->dir), kit_dot(w, w) };

    return n;
}

KIT_INLINE float square_of(float outer) { return outer * outer * (1.0f + 8.0f * KIT_E); }

/* May a line touch a sphere, and not before its start? The distance to the centre is known last, and is compared with
 * one limit. */
KIT_INLINE int may_touch(const ball *b, const line *l, const nearest *n)
{
    const float outer = b->radius + l->blur;

    return n->ww <= (n->middle >= -outer ? square_of(outer) : 0.0f);
}

/* Bounds along the ray on the chord of its line in a sphere, if there is one: on the entry, or on the exit if it starts
 * inside. */
KIT_INLINE void bound_chord(float radius, float blur, float smax, float middle, float ww, uint32_t i,
                            kit_chords *restrict out, kit_conditions *restrict say)
{
    const float sure = smax * (1.0f - 16.0f * KIT_E) - blur;   /* not beyond tmax */
    const float outer = radius + blur, inner = radius - blur;
    const float wide = sqrtf(square_of(outer) - ww) + blur;
    const float narrow = sqrtf(inner * inner * (1.0f - 8.0f * KIT_E) - ww) - blur;
    const float in = middle - wide, surely_in = middle - narrow;
    const float out_from = middle + narrow, out_to = middle + wide;
    const int known = (inner > 0.0f) & (narrow > 0.0f), within = known & (surely_in < 0.0f);
    const float lo = within ? out_from : in, hi = within ? out_to : surely_in;

    out->lo[i] = lo;
    out->hi[i] = hi;
    say->maybe.lane[i] = -((in <= smax) & (out_to >= 0.0f));
    say->surely.lane[i] = -(known & (lo > 0.0f) & (hi < sure));
    say->twice.lane[i] = -(known & (in > 0.0f) & (out_to < sure));
}

/* Most spheres are missed by all lanes: test that first. */
KIT_INLINE void meet_balls(const void *block, const pov_rays *rays, size_t at, uint32_t some, kit_chords *restrict out)
{
    const kit_ball_block *s = block;
    const line l = line_of(rays, at);
    const float smax = rays->framed.smax[at];
    float middle[POV_BLOCK_MAX], ww[POV_BLOCK_MAX];
    kit_conditions say;
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const ball b = ball_of(s, i);
        const nearest n = near_line(&b, &l);

        middle[i] = n.middle;
        ww[i] = n.ww;
        say.maybe.lane[i] = -may_touch(&b, &l, &n);
    }
    some &= kit_bits_of(&say.maybe, POV_BLOCK_MAX);
    out->maybe = 0;
    if (!some)
        return;
    for (i = 0; i < POV_BLOCK_MAX; i++)
        bound_chord(s->radius[i], l.blur, smax, middle[i], ww[i], i, out, &say);
    kit_gather(&say, POV_BLOCK_MAX, some, out);
}

KIT_INLINE void meet_rays(const void *block, uint32_t which, const pov_rays *rays, size_t from, uint32_t some,
                          kit_chords *restrict out)
{
    const ball b = ball_of(block, which);
    float middle[KIT_FLOATS], ww[KIT_FLOATS];
    kit_conditions say;
    uint32_t i;

    for (i = 0; i < KIT_FLOATS; i++) {
        const line l = line_of(rays, from + i);
        const nearest n = near_line(&b, &l);

        middle[i] = n.middle;
        ww[i] = n.ww;
        say.maybe.lane[i] = -may_touch(&b, &l, &n);
    }
    some &= kit_bits_of(&say.maybe, KIT_FLOATS);
    out->maybe = 0;
    if (!some)
        return;
    for (i = 0; i < KIT_FLOATS; i++)
        bound_chord(b.radius, line_of(rays, from + i).blur, rays->framed.smax[from + i], middle[i], ww[i], i, out, &say);
    kit_gather(&say, KIT_FLOATS, some, out);
}

/* Differences of rays from one of them: squared distances of origins and directions, and the largest size. */
typedef struct apart { float org, dir, size; } apart;

KIT_INLINE apart apart_of(const pov_rays *rays, size_t at, uint32_t in, const line *from)
{
    const line l = line_of(rays, at);
    const kit_three o = { l.org.x - from->org.x, l.org.y - from->org.y, l.org.z - from->org.z };
    const kit_three d = { l.dir.x - from->dir.x, l.dir.y - from->dir.y, l.dir.z - from->dir.z };
    const float oo = kit_dot(o, o), dd = kit_dot(d, d), size = rays->framed.size[at];
    const apart a = { in ? oo : 0.0f, in ? dd : 0.0f, in ? size : 0.0f };

    return a;
}

KIT_INLINE apart wider(apart a, apart b)
{
    const apart w = { kit_float_greater(a.org, b.org), kit_float_greater(a.dir, b.dir),
                      kit_float_greater(a.size, b.size) };

    return w;
}

KIT_INLINE void halve(const float *restrict v, float *restrict out, uint32_t n)
{
    uint32_t i;

    for (i = 0; i < n; i++)
        out[i] = kit_float_greater(v[i], v[i + n]);
}

KIT_INLINE float largest(const float *v)
{
    float eight[8], four[4];

    if (KIT_FLOATS > 8) {
        halve(v, eight, 8);
        v = eight;
    }
    halve(v, four, 4);
    return kit_float_greater(kit_float_greater(four[0], four[1]), kit_float_greater(four[2], four[3]));
}

/* Four vectors of lanes at a time, so that the results stay in registers. */
KIT_INLINE apart widest(const pov_rays *rays, uint64_t lanes, const line *from)
{
    float org[KIT_FLOATS] = { 0.0f }, dir[KIT_FLOATS] = { 0.0f }, size[KIT_FLOATS] = { 0.0f };
    uint32_t first, i;
    apart all;

    for (first = 0; first < POV_RAYS_MAX; first += 4 * KIT_FLOATS) {
        const uint32_t second = first + KIT_FLOATS, third = second + KIT_FLOATS, fourth = third + KIT_FLOATS;
        const uint32_t in[4] = { (uint32_t)(lanes >> first), (uint32_t)(lanes >> second), (uint32_t)(lanes >> third),
                                 (uint32_t)(lanes >> fourth) };

        for (i = 0; i < KIT_FLOATS; i++) {
            const apart before = { org[i], dir[i], size[i] };
            const apart a = wider(apart_of(rays, first + i, in[0] >> i & 1, from),
                                  apart_of(rays, second + i, in[1] >> i & 1, from));
            const apart b = wider(apart_of(rays, third + i, in[2] >> i & 1, from),
                                  apart_of(rays, fourth + i, in[3] >> i & 1, from));
            const apart w = wider(wider(a, b), before);

            org[i] = w.org;
            dir[i] = w.dir;
            size[i] = w.size;
        }
    }
    all.org = largest(org);
    all.dir = largest(dir);
    all.size = largest(size);
    return all;
}

/* The spheres that any ray of a packet may come near to. Suppose a ray touches a sphere at s. Then the middle ray at s
 * is no further than R = radius + org + s dir from the centre, and s is at most R beyond the middle ray's point closest
 * to the centre. So R (1 - dir) is at most radius + org + dir times the distance to that point. Where little is known
 * all spheres are returned. */
KIT_INLINE uint32_t near_beam(const kit_ball_block *s, const pov_rays *rays, uint64_t lanes)
{
    const uint64_t later = lanes >> BEAM_MIDDLE << BEAM_MIDDLE;
    const line l = line_of(rays, kit_first_lane64(later ? later : lanes));
    const apart w = widest(rays, lanes, &l);
    const float dir = sqrtf(w.dir) * (1.0f + 32.0f * KIT_E), keep = 1.0f - dir;
    const float pad = sqrtf(w.org) + BEAM_BLUR * (1.0f + w.size);
    kit_bits near;
    uint32_t i;

    if (!(dir < 0.5f))
        return (1u << POV_BLOCK_MAX) - 1;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const ball b = ball_of(s, i);
        const nearest n = near_line(&b, &l);
        const float outer = kit_float_sum(kit_float_greater(n.middle, 0.0f), dir, b.radius + pad);

        near.lane[i] = -((n.ww * (keep * keep) <= square_of(outer)) & (n.middle + outer + outer >= 0.0f));
    }
    return kit_gather_bits(&near);
}

KIT_INLINE uint32_t by_rays(const kit_ball_block *s, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                            pov_meeting *out)
{
    uint32_t n = 0;
    kit_chords c;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t at = kit_first_lane64(lanes);

        meet_balls(s, rays, at, ~kit_owned_by(owners, rays->away[at]), &c);
        n = kit_tell_chords(&c, rays, at, 0, false, out, n);
    }
    return n;
}

KIT_INLINE uint32_t by_balls(const kit_ball_block *s, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                             uint32_t near, pov_meeting *out)
{
    const uint64_t together = (UINT64_C(1) << KIT_FLOATS) - 1;
    uint32_t n = 0, from;
    kit_chords c;

    for (; near; near &= near - 1) {
        const uint32_t which = kit_first_lane(near);

        for (from = 0; from < POV_RAYS_MAX; from += KIT_FLOATS) {
            const uint32_t some = (uint32_t)(lanes >> from & together);
            const uint32_t stay = some & ~kit_rays_of(rays->away + from, owners[which]);

            if (!stay)
                continue;
            meet_rays(s, which, rays, from, stay, &c);
            n = kit_tell_chords(&c, rays, from, which, true, out, n);
        }
    }
    return n;
}

/* Static, because the names of clones would be exported. */
KIT_CLONES static uint32_t filter(const kit_ball_block *s, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                                  pov_meeting *out)
{
    const uint32_t count = kit_count(lanes);

    if (count >= BEAM_LEAST) {
        const uint32_t near = near_beam(s, rays, lanes);

        if (kit_count(near) * BEAM_RAYS <= count)
            return by_balls(s, owners, rays, lanes, near, out);
    }
    return by_rays(s, owners, rays, lanes, out);
}

uint32_t kit_ball_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    return filter(block, owners, rays, lanes, out);
}
