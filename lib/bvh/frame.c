#include "bvh/build.h"

/* Rounded down: the margin is more than the rounding of the subtraction before and the conversion after it. */
static inline float round_down(double x)
{
    return (float)(x - (fabs(x) * 0x1p-22 + 0x1p-120));
}

static inline float round_up(double x)
{
    return (float)(x + (fabs(x) * 0x1p-22 + 0x1p-120));
}

pov_box bvh_box_around(const bvh_input *in, const bvh_ref *refs, uint32_t begin, uint32_t end)
{
    pov_box all, b;
    uint32_t i;

    in->box(in->box_user, refs[begin].id, &all);
    for (i = begin + 1; i < end; i++) {
        in->box(in->box_user, refs[i].id, &b);
        all.lo = pov_vec3_of(fmin(all.lo.x, b.lo.x), fmin(all.lo.y, b.lo.y), fmin(all.lo.z, b.lo.z));
        all.hi = pov_vec3_of(fmax(all.hi.x, b.hi.x), fmax(all.hi.y, b.hi.y), fmax(all.hi.z, b.hi.z));
    }
    return all;
}

/* A power of two that brings half the box below 1; a box without extent counts as one of a few rounding errors. */
static double scale_for(const pov_box *all)
{
    double half = 0.5 * pov_largest(pov_sub(all->hi, all->lo));
    double least = fmax(fmax(pov_largest(all->lo), pov_largest(all->hi)) * 0x1p-50, 1e-300);
    int e;

    frexp(fmax(half, least), &e);
    return ldexp(1.0, -e);
}

bvh_frame bvh_frame_around(const pov_box *all)
{
    bvh_frame f;

    f.centre = pov_add(pov_scale(all->lo, 0.5), pov_scale(all->hi, 0.5));
    f.scale = scale_for(all);
    f.root = 0;
    return f;
}

void bvh_frame_convert(const bvh_frame *frame, const bvh_input *in, bvh_ref *refs, uint32_t begin, uint32_t end)
{
    pov_vec3 c = frame->centre;
    double s = frame->scale;
    uint32_t i;

    for (i = begin; i < end; i++) {
        bvh_ref *f = &refs[i];
        pov_box b;
        in->box(in->box_user, f->id, &b);
        f->lo[0] = round_down((b.lo.x - c.x) * s);
        f->lo[1] = round_down((b.lo.y - c.y) * s);
        f->lo[2] = round_down((b.lo.z - c.z) * s);
        f->hi[0] = round_up((b.hi.x - c.x) * s);
        f->hi[1] = round_up((b.hi.y - c.y) * s);
        f->hi[2] = round_up((b.hi.z - c.z) * s);
    }
}
