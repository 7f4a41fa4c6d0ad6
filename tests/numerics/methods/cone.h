/* cone.h - cylinders and cones as ray tracers have them: taken to an upright one of height one. */
#ifndef METHODS_CONE_H
#define METHODS_CONE_H

#include "numerics/methods/number.h"

#include "common/affine.h"
#include "numerics/methods/lanes.h"

/* The rows times (point - base): x^2 + y^2 <= (radius + slope z)^2, 0 <= z <= 1. */
typedef struct cone {
    num3 base, row[3];
    num radius, slope;
    bool open;
} cone;

enum { SIDE_IN, SIDE_OUT, CAP_BASE, CAP_TOP };

static void cone_make(cone *s, pov_vec3 base, double r0, pov_vec3 top, double r1, bool open)
{
    const num3 axis = num3_sub(num3_planar(top), num3_planar(base));
    const pov_vec3 a = num3_double(axis), size = pov_vec3_of(fabs(a.x), fabs(a.y), fabs(a.z));
    const bool x = size.x <= size.y && size.x <= size.z, y = !x && size.y <= size.z;
    const num3 least = num3_planar(pov_vec3_of(x, y, !x && !y));
    num3 e = num3_cross(axis, least), g;

    e = num3_scale(e, num_div(num_of(1.0), num_sqrt(num3_dot(e, e))));
    g = num3_cross(axis, e);
    s->row[0] = e;
    s->row[1] = num3_scale(g, num_div(num_of(1.0), num_sqrt(num3_dot(g, g))));
    s->row[2] = num3_scale(axis, num_div(num_of(1.0), num3_dot(axis, axis)));
    s->base = num3_planar(base);
    s->radius = num_of(r0);
    s->slope = num_sub(num_of(r1), num_of(r0));
    s->open = open;
}

static inline num3 cone_turn(const cone *s, num3 v)
{
    num3 r;

    r.x = num3_dot(s->row[0], v), r.y = num3_dot(s->row[1], v), r.z = num3_dot(s->row[2], v);
    return r;
}

static inline bool is_between_ends(num z) { return num_double(z) >= 0.0 && !num_less(num_of(1.0), z); }

static void cone_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const cone *s = self;
    const line world = line_from(ray, s->base);
    line l = { cone_turn(s, world.from), cone_turn(s, world.dir), world.middle };
    const num r = num_add(s->radius, num_mul(s->slope, l.from.z)), k = num_mul(s->slope, l.dir.z);
    const num a = num_sub(num_add(num_mul(l.dir.x, l.dir.x), num_mul(l.dir.y, l.dir.y)), num_mul(k, k));
    const num b = num_sub(num_add(num_mul(l.from.x, l.dir.x), num_mul(l.from.y, l.dir.y)), num_mul(r, k));
    const num c = num_sub(num_add(num_mul(l.from.x, l.from.x), num_mul(l.from.y, l.from.y)), num_mul(r, r));
    num root[2];
    const unsigned n = solve(a, b, c, root);
    uint32_t i;

    for (i = 0; i < 2; i++) {
        if (n >> i & 1 && is_between_ends(line_at(&l, root[i]).z) && !report(hits, ray, &l, root[i], i))
            return;
    }
    for (i = 0; i < 2 && !s->open && num_double(l.dir.z) != 0.0; i++) {
        const num t = num_div(num_sub(num_of(i), l.from.z), l.dir.z), edge = i ? num_add(s->radius, s->slope) : s->radius;
        const num3 p = line_at(&l, t);

        if (!num_less(num_mul(edge, edge), num_add(num_mul(p.x, p.x), num_mul(p.y, p.y)))
            && !report(hits, ray, &l, t, CAP_BASE + i))
            return;
    }
}

static void cone_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const cone *s = self;
    const num3 p = cone_turn(s, point_of(ray, at, s->base));
    const num r = num_add(s->radius, num_mul(s->slope, p.z));
    num3 n;

    if (at->mark.feature >= CAP_BASE) {
        *out = pov_scale(pov_unit(num3_double(s->row[2])), at->mark.feature == CAP_BASE ? -1.0 : 1.0);
        return;
    }
    n = num3_add(num3_scale(s->row[0], p.x), num3_scale(s->row[1], p.y));
    *out = pov_unit(num3_double(num3_sub(n, num3_scale(s->row[2], num_mul(s->slope, r)))));
}

static bool cone_inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const cone *s = self;
    const pov_vec3 p = num3_double(cone_turn(s, num3_sub(num3_of(point, point_lo), s->base)));
    const double r = num_double(s->radius) + num_double(s->slope) * p.z;

    return p.z > 0.0 && p.z < 1.0 && p.x * p.x + p.y * p.y < r * r;
}

/* The rows' inverse is their cross products over the determinant. */
static bool cone_bounds(const void *self, pov_box *out)
{
    const cone *s = self;
    const pov_vec3 r0 = num3_double(s->row[0]), r1 = num3_double(s->row[1]), r2 = num3_double(s->row[2]);
    const double volume = pov_dot(r0, pov_cross_product(r1, r2));
    const pov_vec3 e = pov_scale(pov_cross_product(r1, r2), 1.0 / volume), base = num3_double(s->base);
    const pov_vec3 g = pov_scale(pov_cross_product(r2, r0), 1.0 / volume);
    const pov_vec3 top = pov_add(base, pov_scale(pov_cross_product(r0, r1), 1.0 / volume));
    const double lower = num_double(s->radius) * (1.0 + 1e-9), upper = (num_double(s->radius) + num_double(s->slope)) * (1.0 + 1e-9);
    const pov_vec3 wide = pov_vec3_of(sqrt(e.x * e.x + g.x * g.x), sqrt(e.y * e.y + g.y * g.y), sqrt(e.z * e.z + g.z * g.z));
    const pov_vec3 a = pov_scale(wide, lower), b = pov_scale(wide, upper);

    out->lo = pov_vec3_of(fmin(base.x - a.x, top.x - b.x), fmin(base.y - a.y, top.y - b.y), fmin(base.z - a.z, top.z - b.z));
    out->hi = pov_vec3_of(fmax(base.x + a.x, top.x + b.x), fmax(base.y + a.y, top.y + b.y), fmax(base.z + a.z, top.z + b.z));
    return true;
}

static bool cone_absorb(void *self, const pov_affine *map)
{
    cone *s = self;
    int axis[3], i;

    if (!(common_condition(map) < 1024.0) && !common_is_axial(map, axis))
        return false;
    s->base = num3_planar(pov_affine_point(map, num3_double(s->base)));
    for (i = 0; i < 3; i++) {
        const pov_vec3 r = num3_double(s->row[i]);

        s->row[i] = num3_planar(pov_vec3_of(r.x * map->inv[0][0] + r.y * map->inv[1][0] + r.z * map->inv[2][0],
                                            r.x * map->inv[0][1] + r.y * map->inv[1][1] + r.z * map->inv[2][1],
                                            r.x * map->inv[0][2] + r.y * map->inv[1][2] + r.z * map->inv[2][2]));
    }
    return true;
}

METHODS_LANES(cone_bounds)

static const pov_shape_fast cone_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(lane_boxes),
    .block_pack = block_pack,
    .block_filter = block_filter,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &cone_fast : NULL; }

#define CONE_CLASS(word)                                                                                              \
    static const pov_shape_class word##_class = {                                                                     \
        .size = sizeof(pov_shape_class), .flags = POV_SHAPE_SOLID, .keyword = #word,                                  \
        .instance_size = sizeof(cone), .parse = parse, .bounds = cone_bounds,                                         \
        .intersect = cone_intersect, .normal = cone_normal, .inside = cone_inside,                                    \
        .absorb = cone_absorb, .extension = extension,                                                                \
    };                                                                                                                \
    METHODS_PLUGIN(word, word##_class)

#endif
