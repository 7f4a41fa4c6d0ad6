#include "kit/box_block.h"

#include "kit/floats.h"

#include <string.h>

void kit_box_begin(kit_box_block *b, uint32_t n)
{
    memset(b, 0, sizeof *b);
    b->count = n;
}

void kit_box_put(kit_box_block *b, uint32_t lane, uint32_t p, double plane) { b->plane[p][lane] = (float)plane; }

/* Along an axis a plane at p is met at p * inverse + start, which is off by less than pad. */
typedef struct axis { float inverse, start, pad; } axis;

/* A ray. What lies before `sure` is no further away than its tmax for certain. */
typedef struct line { axis x, y, z; float smax, sure; } line;

/* Eight rays side by side. */
typedef struct lines {
    float inverse[3][KIT_FLOATS], start[3][KIT_FLOATS], pad[3][KIT_FLOATS], smax[KIT_FLOATS], sure[KIT_FLOATS];
} lines;

/* A ray moves so slowly along an axis that it stays between two planes, or beside them, as far as floats tell. */
#define SLOWEST 0x1p-40f

/* Planes are off by less than 8 e (1 + S), S being the sum of the sizes of the origin's coordinates, with all that is
 * lost in the distances to them: docs/numerics.md has the count. */
#define BLUR (8.0f * KIT_E)

static inline void put_axis(lines *restrict l, uint32_t i, int k, float o, float d, float blur)
{
    const float size = kit_float_greater(fabsf(d), SLOWEST), inverse = 1.0f / copysignf(size, d);

    l->inverse[k][i] = inverse;
    l->start[k][i] = -o * inverse;
    l->pad[k][i] = blur * fabsf(inverse);
}

static inline void put_lines(const pov_rays *rays, uint32_t from, lines *restrict l)
{
    uint32_t i;

    for (i = 0; i < KIT_FLOATS; i++) {
        const uint32_t at = from + i;
        const float size = rays->framed.size[at], blur = size < KIT_NEAR ? BLUR * (1.0f + size) : HUGE_VALF;

        put_axis(l, i, 0, rays->framed.org[0][at], rays->framed.dir[0][at], blur);
        put_axis(l, i, 1, rays->framed.org[1][at], rays->framed.dir[1][at], blur);
        put_axis(l, i, 2, rays->framed.org[2][at], rays->framed.dir[2][at], blur);
        l->smax[i] = rays->framed.smax[at];
        l->sure[i] = rays->framed.smax[at] * (1.0f - 16.0f * KIT_E) - blur;
    }
}

KIT_INLINE line line_of(const lines *l, uint32_t i)
{
    const line r = { { l->inverse[0][i], l->start[0][i], l->pad[0][i] }, { l->inverse[1][i], l->start[1][i], l->pad[1][i] },
                     { l->inverse[2][i], l->start[2][i], l->pad[2][i] }, l->smax[i], l->sure[i] };
    return r;
}

typedef struct planes { float lower[3], upper[3]; } planes;

KIT_INLINE planes planes_of(const kit_box_block *b, uint32_t i)
{
    const planes p = { { b->plane[0][i], b->plane[2][i], b->plane[4][i] }, { b->plane[1][i], b->plane[3][i], b->plane[5][i] } };
    return p;
}

/* For certain a ray is outside before `near` and after `far`, and inside from `last` to `first`. */
typedef struct span { float near, last, first, far; } span;

/* What is not a number comes of a ray that nothing is known of; it is passed over by the comparisons. */
KIT_INLINE void meet_axis(span *s, const axis *a, float lower, float upper)
{
    const float p = kit_float_sum(lower, a->inverse, a->start), q = kit_float_sum(upper, a->inverse, a->start);
    const float in = kit_float_lesser(p, q), out = kit_float_greater(p, q);

    s->near = kit_float_greater(in - a->pad, s->near);
    s->last = kit_float_greater(in + a->pad, s->last);
    s->first = kit_float_lesser(out - a->pad, s->first);
    s->far = kit_float_lesser(out + a->pad, s->far);
}

KIT_INLINE void meet(const planes *p, const line *r, uint32_t i, kit_chords *restrict out, kit_bits *restrict maybe,
                     kit_bits *restrict surely, kit_bits *restrict twice)
{
    span s = { -HUGE_VALF, -HUGE_VALF, HUGE_VALF, HUGE_VALF };
    int enters;

    meet_axis(&s, &r->x, p->lower[0], p->upper[0]);
    meet_axis(&s, &r->y, p->lower[1], p->upper[1]);
    meet_axis(&s, &r->z, p->lower[2], p->upper[2]);
    enters = (int)(s.near > 0.0f) & (int)(s.last < s.first);
    maybe->lane[i] = -(kit_float_greater(s.near, 0.0f) <= kit_float_lesser(s.far, r->smax));
    surely->lane[i] = -(enters & (int)(s.last < r->sure));
    twice->lane[i] = -(enters & (int)(s.far < r->sure));
    out->lo[i] = s.near;
    out->hi[i] = s.last;
}

static inline void gather(kit_chords *c, const kit_bits *maybe, const kit_bits *surely, const kit_bits *twice)
{
    c->maybe = kit_gather_bits(maybe);
    c->surely = kit_gather_bits(surely);
    c->twice = kit_gather_bits(twice);
}

/* Rays in the lanes. */
static inline void meet_rays(const planes *p, const lines *l, kit_chords *restrict out)
{
    kit_bits maybe, surely, twice;
    uint32_t i;

    for (i = 0; i < KIT_FLOATS; i++) {
        const line r = line_of(l, i);
        meet(p, &r, i, out, &maybe, &surely, &twice);
    }
    gather(out, &maybe, &surely, &twice);
}

/* Boxes in the lanes. */
static inline void meet_boxes(const kit_box_block *b, const line *r, kit_chords *restrict out)
{
    kit_bits maybe, surely, twice;
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const planes p = planes_of(b, i);
        meet(&p, r, i, out, &maybe, &surely, &twice);
    }
    gather(out, &maybe, &surely, &twice);
}

/* Static, since the names of clones would be seen from outside. */
KIT_CLONES static uint32_t filter(const kit_box_block *b, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                                  pov_meeting *out)
{
    const uint32_t all = (1u << b->count) - 1;
    uint32_t n = 0, from, which;
    kit_chords c;
    lines l;

    for (from = 0; from < POV_RAYS_MAX; from += KIT_FLOATS) {
        uint32_t some = (uint32_t)(lanes >> from) & 255u;

        if (!some)
            continue;
        put_lines(rays, from, &l);
        if (kit_are_more(some, b->count)) {
            for (which = 0; which < b->count; which++) {
                const uint32_t stay = some & ~kit_owned_by(rays->away + from, owners[which]);
                const planes p = planes_of(b, which);

                if (!stay)
                    continue;
                meet_rays(&p, &l, &c);
                c.maybe &= stay;
                n = kit_tell_rays_chords(&c, rays, from, which, out, n);
            }
            continue;
        }
        for (; some; some &= some - 1) {
            const uint32_t i = kit_first_lane(some), stay = all & ~kit_owned_by(owners, rays->away[from + i]);
            const line r = line_of(&l, i);

            if (!stay)
                continue;
            meet_boxes(b, &r, &c);
            c.maybe &= stay;
            n = kit_tell_shapes_chords(&c, rays, from + i, out, n);
        }
    }
    return n;
}

uint32_t kit_box_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    return filter(block, owners, rays, lanes, out);
}
