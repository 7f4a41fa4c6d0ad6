#include "common/steep.h"

#include "common/simd.h"

/* In POV-Ray's own units: cells, and the 65536 steps of heights. There means of unit normals lean to the flatter ones. */
static pov_vec3 step_normal(const common_steeps *s, uint32_t x, uint32_t z, uint32_t u, uint32_t v)
{
    const uint16_t *h = s->height;
    const double at = h[(size_t)z * s->wide + x], by_x = h[(size_t)z * s->wide + u] - at, by_z = h[(size_t)v * s->wide + x] - at;

    return pov_unit(pov_vec3_of(u > x ? -by_x : by_x, 1.0, v > z ? -by_z : by_z));
}

/* The mean of the normals between a corner and two of its neighbours, one along x, one along z. POV-Ray keeps it in 16 bits a
 * component, which steep corners show. */
static common_steep find_steep(const common_steeps *s, uint32_t x, uint32_t z)
{
    pov_vec3 sum = { 0.0, 0.0, 0.0 };
    common_steep out;

    for (int i = 0; i < 4; i++) {
        const uint32_t u = i & 1 ? x + 1 : x - 1, v = i & 2 ? z + 1 : z - 1;   /* below 0 is beyond all */

        if (u < s->wide && v < s->deep)
            sum = pov_add(sum, step_normal(s, x, z, u, v));
    }
    sum = pov_scale(pov_unit(sum), 32767.0);
    out.x = (int16_t)sum.x;
    out.y = (int16_t)sum.y;
    out.z = (int16_t)sum.z;
    return out;
}

void common_steeps_make(common_steeps *s, const pov_host *host, pov_reader *in)
{
    const size_t count = (size_t)s->wide * s->deep;
    common_steep *at = count <= COMMON_STEEPS_MOST ? host->alloc(in, count * sizeof *at) : NULL;

    for (uint32_t z = 0; at && z < s->deep; z++)
        for (uint32_t x = 0; x < s->wide; x++)
            at[(size_t)z * s->wide + x] = find_steep(s, x, z);
    s->at = at;
}

typedef struct lanes { double x[4], y[4], z[4]; } lanes;

/* All have a component of one at least. */
COMMON_CLONES static void make_unit(lanes *l)
{
    for (int i = 0; i < 4; i++) {
        const double length = sqrt(l->x[i] * l->x[i] + l->y[i] * l->y[i] + l->z[i] * l->z[i]);

        l->x[i] /= length;
        l->y[i] /= length;
        l->z[i] /= length;
    }
}

void common_steeps_of_cell(const common_steeps *s, uint32_t x, uint32_t z, pov_vec3 normal[4])
{
    const double across = s->wide - 1.0, along = s->deep - 1.0;
    lanes l;

    for (uint32_t i = 0; i < 4; i++) {
        const uint32_t u = x + i % 2, v = z + i / 2;
        const common_steep at = s->at ? s->at[(size_t)v * s->wide + u] : find_steep(s, u, v);

        l.x[i] = at.x * across;
        l.y[i] = at.y * 65536.0;
        l.z[i] = at.z * along;
    }
    make_unit(&l);
    for (int i = 0; i < 4; i++)
        normal[i] = pov_vec3_of(l.x[i], l.y[i], l.z[i]);
}
