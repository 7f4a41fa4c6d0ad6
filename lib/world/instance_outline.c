/* The outline of an instanced shape, in the world. */
#include "world/instance.h"

#include "base/vec3.h"

#include <math.h>

/* The anchor, in object space, and the shape's middle must not be farther from the origin than this many of its smallest half extent. */
static const double farthest = 0x1p20;

/* A covector of object space: one of the world. */
static pov_vec3 pull(const instance_xform *p, pov_vec3 v)
{
    return pov_vec3_of(pov_dot(v, p->column[0]), pov_dot(v, p->column[1]), pov_dot(v, p->column[2]));
}

/* The square part of a quadric, times v. */
static pov_vec3 times(const double s[6], pov_vec3 v)
{
    return pov_vec3_of(s[0] * v.x + s[3] * v.y + s[4] * v.z, s[3] * v.x + s[1] * v.y + s[5] * v.z, s[4] * v.x + s[5] * v.y + s[2] * v.z);
}

static void move_quadric(const instance_xform *p, pov_vec3 from, pov_outline *io)
{
    const pov_vec3 at = times(io->square, from);
    pov_vec3 row[3];

    for (int i = 0; i < 3; i++)
        row[i] = pull(p, times(io->square, p->column[i]));
    io->constant += pov_dot(from, pov_add(at, pov_scale(io->linear, 2.0)));
    io->linear = pull(p, pov_add(at, io->linear));
    io->square[0] = row[0].x;
    io->square[1] = row[1].y;
    io->square[2] = row[2].z;
    io->square[3] = row[0].y;
    io->square[4] = row[0].z;
    io->square[5] = row[1].z;
}

bool instance_outline(const instance_xform *p, pov_outline *io)
{
    const pov_vec3 from = pov_sub(p->own_anchor, io->centre);
    const double size = vec3_sum(p->own_anchor) + vec3_sum(io->centre);
    const double largest = pov_max(pov_max((double)p->per_half[0], (double)p->per_half[1]), (double)p->per_half[2]);

    for (uint32_t i = 0; i < io->slabs; i++) {
        const double shift = pov_dot(io->normal[i], from);

        io->lo[i] -= shift;
        io->hi[i] -= shift;
        io->normal[i] = pull(p, io->normal[i]);
    }
    if (io->round)
        move_quadric(p, from, io);
    io->centre = p->anchor;
    return p->known != INSTANCE_UNKNOWN && size * largest < farthest;
}
