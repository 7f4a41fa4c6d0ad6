#include "kit/flat_block.h"

#include "kit/simd.h"

/* Edges are no shorter, and no corner is nearer to the line of an edge it is not on: then an edge's line is known all
 * over the figure to what 128 roundings of a corner make. */
static const double shortest = 0.125;

static double length(pov_vec3 a) { return sqrt(pov_dot(a, a)); }

/* Across the way in the plane, to the left seen from where the normal points. */
static pov_vec3 across(pov_vec3 normal, pov_vec3 way)
{
    const pov_vec3 side = pov_cross_product(normal, way);

    return pov_scale(side, 1.0 / length(side));
}

/* Are the other corners on the inner side of all edges, if that is the left one (way = 1) or the right one? */
static bool is_around(const pov_vec3 normal, const pov_vec3 *corner, uint32_t n, double way)
{
    uint32_t i, j;

    for (i = 0; i < n; i++) {
        const pov_vec3 edge = pov_sub(corner[(i + 1) % n], corner[i]), side = across(normal, pov_scale(edge, way));

        if (!(length(edge) >= shortest))
            return false;
        for (j = 2; j < n; j++)
            if (!(pov_dot(side, pov_sub(corner[(i + j) % n], corner[i])) >= shortest))
                return false;
    }
    return true;
}

bool kit_flat_outline(kit_flat *f, const pov_vec3 *corner, uint32_t n)
{
    const double way = is_around(f->normal, corner, n, 1.0) ? 1.0 : -1.0;
    uint32_t i;

    if (!is_around(f->normal, corner, n, way))
        return false;
    for (i = 0; i < KIT_SIDES; i++) {
        const pov_vec3 from = corner[i % n], edge = pov_sub(corner[(i + 1) % n], from);

        f->side[i] = across(f->normal, pov_scale(edge, way));
        f->offset[i] = pov_dot(f->side[i], from);
    }
    f->sure = true;
    return true;
}

void kit_flat_begin(kit_flat *f, pov_vec3 corner, pov_vec3 way)
{
    uint32_t i;

    f->side[0] = across(f->normal, way);
    f->side[1] = across(f->normal, f->side[0]);
    f->side[2] = pov_scale(f->side[0], -1.0);
    f->side[3] = pov_scale(f->side[1], -1.0);
    for (i = 0; i < KIT_SIDES; i++)
        f->offset[i] = pov_dot(f->side[i], corner);
    f->sure = false;
}

void kit_flat_extend(kit_flat *f, pov_vec3 corner)
{
    uint32_t i;

    for (i = 0; i < KIT_SIDES; i++)
        f->offset[i] = fmin(f->offset[i], pov_dot(f->side[i], corner));
}

/* ---- blocks ---- */

static bool is_ordinary(double size) { return size > 1e-40 && size < 1e40; }

static void put(double to[3][POV_BLOCK_MAX], uint32_t i, pov_vec3 v)
{
    to[0][i] = v.x;
    to[1][i] = v.y;
    to[2][i] = v.z;
}

bool kit_flat_pack(kit_flat_block *b, const kit_flat *figures, uint32_t n)
{
    uint32_t i, k;

    b->reach = 0.0;
    b->lanes = (1u << n) - 1;
    b->sure = 0;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const kit_flat *f = &figures[i < n ? i : 0];
        const double reach = kit_sum_of_components(f->anchor) + 8.0 / f->scale;

        if (!(is_ordinary(f->scale) && reach < 1e40))
            return false;
        put(b->anchor, i, f->anchor);
        put(b->normal, i, pov_scale(f->normal, f->scale));
        for (k = 0; k < KIT_SIDES; k++) {
            put(b->side[k], i, pov_scale(f->side[k], f->scale));
            b->offset[k][i] = f->offset[k];
        }
        b->scale[i] = f->scale;
        b->reach = kit_greater(b->reach, reach);
        b->sure |= (uint32_t)f->sure << i;
    }
    return true;
}

static inline double side_at(const kit_flat_block *b, uint32_t k, uint32_t i, double x, double y, double z)
{
    return b->side[k][0][i] * x + b->side[k][1][i] * y + b->side[k][2][i] * z - b->offset[k][i];
}

/* With F the scaled sum of sizes of the origin and the figure's furthest point, S the scaled sum of sizes of the
 * direction and s the slope of the plane along it: height and slope are off by 12 u F and 10 u S, the distance to the
 * plane by less than 64 u F / s, and what is reported by as much again. */
static inline void filter_some(const kit_flat_block *b, const pov_rays *rays, uint32_t at, uint32_t n,
                               kit_answer *restrict out)
{
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    const pov_vec3 o = kit_origin(rays, at), d = kit_way(rays, at);
    const double speed = kit_sum_of_components(d), blur = KIT_U * (rays->size[at] + b->reach), tmax = rays->tmax[at];
    int64_t missed = 0, met = 0;
    uint32_t i;

    for (i = 0; i < n; i++) {
        const double fx = o.x - b->anchor[0][i], fy = o.y - b->anchor[1][i], fz = o.z - b->anchor[2][i];
        const double slope = b->normal[0][i] * d.x + b->normal[1][i] * d.y + b->normal[2][i] * d.z;
        const double inverse = 1.0 / slope, size = b->scale[i] * speed;
        const double t = -(b->normal[0][i] * fx + b->normal[1][i] * fy + b->normal[2][i] * fz) * inverse;
        /* Along the plane nothing is certain. */
        const double pad = fabs(slope) > 0x1p-40 * size ? 128.0 * blur * b->scale[i] * fabs(inverse) : HUGE_VAL;
        /* A point of the plane is off by 58 u F S / s in each coordinate, an edge by what its corners may lie off the
         * plane, 111 u F S / s, and at the far end of the figure by 111 times that. */
        const double doubt = 128.0 * pad * size;
        const double x = fx + t * d.x, y = fy + t * d.y, z = fz + t * d.z;
        const double first = kit_lesser(side_at(b, 0, i, x, y, z), side_at(b, 1, i, x, y, z));
        const double second = kit_lesser(side_at(b, 2, i, x, y, z), side_at(b, 3, i, x, y, z));
        const double least = kit_lesser(first, second), lo = t - pad, hi = t + pad;

        missed |= ((least < -doubt) | (lo > tmax) | (hi < 0.0)) ? bit[i] : 0;
        met |= ((least > doubt) & (lo > 0.0) & (hi < tmax)) ? bit[i] : 0;
        out->lo[i] = lo > 0.0 ? lo : 0.0;
        out->hi[i] = hi;
    }
    out->maybe = ~(uint32_t)missed & b->lanes;
    out->surely = (uint32_t)met & b->lanes & b->sure;
    out->twice = 0;
}

/* Static, since the names of clones would be seen from outside. */
KIT_CLONES static uint32_t filter(const kit_flat_block *b, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    uint32_t n = 0;
    kit_answer a;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t at = kit_first_lane64(lanes);

        if (!(is_ordinary(kit_sum_of_components(kit_way(rays, at))) && rays->size[at] < 1e40))
            kit_decline(b->lanes, &a);
        else if (b->lanes < 16)
            filter_some(b, rays, at, POV_BLOCK_MAX / 2, &a);
        else
            filter_some(b, rays, at, POV_BLOCK_MAX, &a);
        n = kit_tell(&a, at, out, n);
    }
    return n;
}

uint32_t kit_flat_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    (void)owners;
    return filter(block, rays, lanes, out);
}
