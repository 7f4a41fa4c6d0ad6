#include "common/sphere_block.h"

#include "common/floats.h"

/* Error bound. Points of a ray near the spheres, the point closest to a sphere included, are off by less than 23 e (1 +
 * S), S being the sum of the sizes of its origin's coordinates: docs/numerics.md has the count. Enlarging and shrinking
 * radii, and widening bounds by that much makes the result safe. */
#define BLUR (24.0f * COMMON_E)
/* The same bound for the line of one ray of a packet, and for the differences of the other rays from it. */
#define BEAM_BLUR (32.0f * COMMON_E)

/* Packets of this many rays or more are tested as a whole first. Rays of smaller packets mostly differ too much to
 * exclude spheres. */
enum { BEAM_LEAST = 24 };
/* Rays take the lanes when there are at least this many for each remaining sphere. */
enum { BEAM_RAYS = 4 };
/* The centre of a square of rays, by rows. */
enum { BEAM_MIDDLE = 28 };

static double to_frame(pov_two c, double centre, double scale) { return (c.hi - centre + c.lo) * scale; }

bool common_sphere_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    common_sphere_block *b = block;
    uint32_t i;

    if (!frame)
        return false;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const common_sphere *s = selves[i < n ? i : 0];

        b->x[i] = (float)to_frame(s->centre.x, frame->centre.x, frame->scale);
        b->y[i] = (float)to_frame(s->centre.y, frame->centre.y, frame->scale);
        b->z[i] = (float)to_frame(s->centre.z, frame->centre.z, frame->scale);
        b->radius[i] = i < n ? (float)(s->radius.hi * frame->scale) : NAN;
    }
    return true;
}

/* A sphere of the block, and a ray, in the frame. */
typedef struct lane_sphere { common_three centre; float radius; } lane_sphere;
typedef struct line { common_three org, dir; float blur; } line;

COMMON_INLINE lane_sphere sphere_of(const common_sphere_block *s, size_t i)
{
    const lane_sphere b = { { s->x[i], s->y[i], s->z[i] }, s->radius[i] };

    return b;
}

COMMON_INLINE line line_of(const pov_rays *rays, size_t at)
{
    const line l = { { rays->local.org[0][at], rays->local.org[1][at], rays->local.org[2][at] },
                     { rays->local.dir[0][at], rays->local.dir[1][at], rays->local.dir[2][at] },
                     BLUR * (1.0f + rays->local.size[at]) };
    return l;
}

/* The point of a line closest to a centre: its distance along the line, and the squared distance to the centre. */
typedef struct nearest { float middle, ww; } nearest;

/* The distance to the centre is the length of a cross product, which does not wait for the distance along the line. */
COMMON_INLINE nearest near_line(const lane_sphere *b, const line *l)
{
    const common_three c = { b->centre.x - l->org.x, b->centre.y - l->org.y, b->centre.z - l->org.z };
    const common_three w = { common_float_sum(-c.z, l->dir.y, c.y * l->dir.z),
                             common_float_sum(-c.x, l->dir.z, c.z * l->dir.x),
                          common_float_sum(-c.y, l->dir.x, c.x * l->dir.y) };
    const nearest n = { common_dot(c, l->dir), common_dot(w, w) };

    return n;
}

COMMON_INLINE float square_of(float outer) { return outer * outer * (1.0f + 8.0f * COMMON_E); }

/* May a line touch a sphere, and not before its start? The distance to the centre is known last, and is compared with
 * one limit. */
COMMON_INLINE int may_touch(const lane_sphere *b, const line *l, const nearest *n)
{
    const float outer = b->radius + l->blur;

    return n->ww <= (n->middle >= -outer ? square_of(outer) : 0.0f);
}

/* Bounds along the ray on the chord of its line in a sphere, if there is one: on the entry, or on the exit if it starts
 * inside. Rays within a sphere that they do not leave, as below a sky, cross nothing. */
COMMON_INLINE void bound_chord(float radius, float blur, float smax, float middle, float ww, uint32_t i,
                               common_chords *restrict out, common_conditions *restrict say)
{
    const float sure = smax * (1.0f - 16.0f * COMMON_E) - blur;   /* not beyond tmax */
    const float outer = radius + blur, inner = radius - blur;
    const float wide = sqrtf(square_of(outer) - ww) + blur;
    const float narrow = sqrtf(inner * inner * (1.0f - 8.0f * COMMON_E) - ww) - blur;
    const float in = middle - wide, definite_in = middle - narrow;
    const float out_from = middle + narrow, out_to = middle + wide;
    const int known = (inner > 0.0f) & (narrow > 0.0f), within = known & (definite_in < 0.0f);
    const float lo = within ? out_from : in, hi = within ? out_to : definite_in;

    out->lo[i] = lo;
    out->hi[i] = hi;
    say->maybe.lane[i] = -((lo <= smax) & (out_to >= 0.0f));
    say->definite.lane[i] = -(known & (lo > 0.0f) & (hi < sure));
    say->definite_pair.lane[i] = -(known & (in > 0.0f) & (out_to < sure));
}

/* Most spheres are missed by all lanes: test that first. */
COMMON_INLINE void filter_spheres(const void *block, const pov_rays *rays, size_t at, uint32_t some,
                                  common_chords *restrict out)
{
    const common_sphere_block *s = block;
    const line l = line_of(rays, at);
    const float smax = rays->local.smax[at];
    float middle[POV_BLOCK_MAX], ww[POV_BLOCK_MAX];
    common_conditions say;
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const lane_sphere b = sphere_of(s, i);
        const nearest n = near_line(&b, &l);

        middle[i] = n.middle;
        ww[i] = n.ww;
        say.maybe.lane[i] = -may_touch(&b, &l, &n);
    }
    some &= common_bits_of(&say.maybe, POV_BLOCK_MAX);
    out->maybe = 0;
    if (!some)
        return;
    for (i = 0; i < POV_BLOCK_MAX; i++)
        bound_chord(s->radius[i], l.blur, smax, middle[i], ww[i], i, out, &say);
    common_gather(&say, POV_BLOCK_MAX, some, out);
}

COMMON_INLINE void filter_rays(const void *block, uint32_t which, const pov_rays *rays, size_t from, uint32_t some,
                               common_chords *restrict out)
{
    const lane_sphere b = sphere_of(block, which);
    float middle[COMMON_FLOATS], ww[COMMON_FLOATS];
    common_conditions say;
    uint32_t i;

    for (i = 0; i < COMMON_FLOATS; i++) {
        const line l = line_of(rays, from + i);
        const nearest n = near_line(&b, &l);

        middle[i] = n.middle;
        ww[i] = n.ww;
        say.maybe.lane[i] = -may_touch(&b, &l, &n);
    }
    some &= common_bits_of(&say.maybe, COMMON_FLOATS);
    out->maybe = 0;
    if (!some)
        return;
    for (i = 0; i < COMMON_FLOATS; i++)
        bound_chord(b.radius, line_of(rays, from + i).blur, rays->local.smax[from + i], middle[i], ww[i], i, out, &say);
    common_gather(&say, COMMON_FLOATS, some, out);
}

/* Differences of rays from one of them: squared distances of origins and directions, and the largest size. */
typedef struct separation { float org, dir, size; } separation;

COMMON_INLINE separation separation_of(const pov_rays *rays, size_t at, uint32_t in, const line *from)
{
    const line l = line_of(rays, at);
    const common_three o = { l.org.x - from->org.x, l.org.y - from->org.y, l.org.z - from->org.z };
    const common_three d = { l.dir.x - from->dir.x, l.dir.y - from->dir.y, l.dir.z - from->dir.z };
    const float oo = common_dot(o, o), dd = common_dot(d, d), size = rays->local.size[at];
    const separation a = { in ? oo : 0.0f, in ? dd : 0.0f, in ? size : 0.0f };

    return a;
}

COMMON_INLINE separation wider(separation a, separation b)
{
    const separation w = { common_float_greater(a.org, b.org), common_float_greater(a.dir, b.dir),
                      common_float_greater(a.size, b.size) };

    return w;
}

COMMON_INLINE void halve(const float *restrict v, float *restrict out, uint32_t n)
{
    uint32_t i;

    for (i = 0; i < n; i++)
        out[i] = common_float_greater(v[i], v[i + n]);
}

COMMON_INLINE float largest(const float *v)
{
    float eight[8], four[4];

    if (COMMON_FLOATS > 8) {
        halve(v, eight, 8);
        v = eight;
    }
    halve(v, four, 4);
    return common_float_greater(common_float_greater(four[0], four[1]), common_float_greater(four[2], four[3]));
}

/* Four vectors of lanes at a time, so that the results stay in registers. */
COMMON_INLINE separation widest(const pov_rays *rays, uint64_t lanes, const line *from)
{
    float org[COMMON_FLOATS] = { 0.0f }, dir[COMMON_FLOATS] = { 0.0f }, size[COMMON_FLOATS] = { 0.0f };
    uint32_t first, i;
    separation all;

    for (first = 0; first < POV_RAYS_MAX; first += 4 * COMMON_FLOATS) {
        const uint32_t second = first + COMMON_FLOATS, third = second + COMMON_FLOATS, fourth = third + COMMON_FLOATS;
        const uint32_t in[4] = { (uint32_t)(lanes >> first), (uint32_t)(lanes >> second), (uint32_t)(lanes >> third),
                                 (uint32_t)(lanes >> fourth) };

        for (i = 0; i < COMMON_FLOATS; i++) {
            const separation before = { org[i], dir[i], size[i] };
            const separation a = wider(separation_of(rays, first + i, in[0] >> i & 1, from),
                                       separation_of(rays, second + i, in[1] >> i & 1, from));
            const separation b = wider(separation_of(rays, third + i, in[2] >> i & 1, from),
                                       separation_of(rays, fourth + i, in[3] >> i & 1, from));
            const separation w = wider(wider(a, b), before);

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
COMMON_INLINE uint32_t near_beam(const common_sphere_block *s, const pov_rays *rays, uint64_t lanes)
{
    const uint64_t later = lanes >> BEAM_MIDDLE << BEAM_MIDDLE;
    const line l = line_of(rays, common_first_lane64(later ? later : lanes));
    const separation w = widest(rays, lanes, &l);
    const float dir = sqrtf(w.dir) * (1.0f + 32.0f * COMMON_E), keep = 1.0f - dir;
    const float pad = sqrtf(w.org) + BEAM_BLUR * (1.0f + w.size);
    common_bits near;
    uint32_t i;

    if (!(dir < 0.5f))
        return (1u << POV_BLOCK_MAX) - 1;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const lane_sphere b = sphere_of(s, i);
        const nearest n = near_line(&b, &l);
        const float outer = common_float_sum(common_float_greater(n.middle, 0.0f), dir, b.radius + pad);

        near.lane[i] = -((n.ww * (keep * keep) <= square_of(outer)) & (n.middle + outer + outer >= 0.0f));
    }
    return common_gather_bits(&near);
}

COMMON_INLINE uint32_t by_rays(const common_sphere_block *s, const uint32_t *owners, const pov_rays *rays,
                               uint64_t lanes, pov_candidate *out)
{
    uint32_t n = 0;
    common_chords c;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t at = common_first_lane64(lanes);

        filter_spheres(s, rays, at, ~common_owned_by(owners, rays->excluded[at]), &c);
        n = common_chord_candidates(&c, rays, at, 0, false, out, n);
    }
    return n;
}

COMMON_INLINE uint32_t by_spheres(const common_sphere_block *s, const uint32_t *owners, const pov_rays *rays,
                                  uint64_t lanes, uint32_t near, pov_candidate *out)
{
    const uint64_t together = (UINT64_C(1) << COMMON_FLOATS) - 1;
    uint32_t n = 0, from;
    common_chords c;

    for (; near; near &= near - 1) {
        const uint32_t which = common_first_lane(near);

        for (from = 0; from < POV_RAYS_MAX; from += COMMON_FLOATS) {
            const uint32_t some = (uint32_t)(lanes >> from & together);
            const uint32_t kept_lanes = some & ~common_rays_of(rays->excluded + from, owners[which]);

            if (!kept_lanes)
                continue;
            filter_rays(s, which, rays, from, kept_lanes, &c);
            n = common_chord_candidates(&c, rays, from, which, true, out, n);
        }
    }
    return n;
}

/* Static, because the names of clones would be exported. */
COMMON_CLONES static uint32_t filter(const common_sphere_block *s, const uint32_t *owners, const pov_rays *rays,
                                     uint64_t lanes, pov_candidate *out)
{
    const uint32_t count = common_count(lanes);

    if (count >= BEAM_LEAST) {
        const uint32_t near = near_beam(s, rays, lanes);

        if (common_count(near) * BEAM_RAYS <= count)
            return by_spheres(s, owners, rays, lanes, near, out);
    }
    return by_rays(s, owners, rays, lanes, out);
}

uint32_t common_sphere_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                              pov_candidate *out)
{
    return filter(block, owners, rays, lanes, out);
}
