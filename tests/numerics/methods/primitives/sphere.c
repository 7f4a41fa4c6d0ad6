#include "numerics/methods/number.h"

#include "common/affine.h"
#include "common/simd.h"

typedef struct sphere { pov_vec3 centre; double radius; } sphere;

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    sphere *s = self;

    host->vector(in, &s->centre);
    host->accept(in, ",");
    s->radius = fabs(host->number(in));
}

static bool bounds(const void *self, pov_box *out)
{
    const sphere *s = self;
    const double r = s->radius * (1.0 + 1e-12) + 1e-15 * pov_largest(s->centre);

    out->lo = pov_sub(s->centre, pov_vec3_of(r, r, r));
    out->hi = pov_add(s->centre, pov_vec3_of(r, r, r));
    return true;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const sphere *s = self;
    const line l = line_from(ray, num3_planar(s->centre));
    const num r = num_of(s->radius);
    num root[2];
    const unsigned n = solve(num3_dot(l.dir, l.dir), num3_dot(l.from, l.dir),
                             num_sub(num3_dot(l.from, l.from), num_mul(r, r)), root);

    if (n && report(hits, ray, &l, root[0], 0))
        report(hits, ray, &l, root[1], 1);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    *out = pov_unit(num3_double(point_of(ray, at, num3_planar(((const sphere *)self)->centre))));
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const sphere *s = self;
    const pov_vec3 w = pov_add(pov_sub(point, s->centre), point_lo);

    return pov_dot(w, w) < s->radius * s->radius;
}

static bool absorb(void *self, const pov_affine *map)
{
    sphere *s = self;
    pov_two factor;

    if (!common_is_similarity(map, &factor))
        return false;
    s->centre = pov_affine_point(map, s->centre);
    s->radius *= factor.hi;
    return true;
}

/* ---- blocks: the textbook's own test, eight at once ---- */

typedef struct sphere_block {
    double x[POV_BLOCK_MAX], y[POV_BLOCK_MAX], z[POV_BLOCK_MAX], rr[POV_BLOCK_MAX];
    int64_t lanes;
} sphere_block;

static bool block_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    sphere_block *b = block;
    uint32_t i;

    (void)frame;
    b->lanes = (1 << n) - 1;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const sphere *s = selves[i < n ? i : 0];

        b->x[i] = s->centre.x, b->y[i] = s->centre.y, b->z[i] = s->centre.z;
        b->rr[i] = s->radius * s->radius;
    }
    return true;
}

static inline void result(const sphere_block *s, const pov_rays *rays, uint32_t at, common_result *out)
{
    const pov_vec3 o = common_origin(rays, at), d = common_dir(rays, at);
    const double a = pov_dot(d, d), inverse = 1.0 / a, tmax = rays->tmax[at];
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    double square[POV_BLOCK_MAX], b[POV_BLOCK_MAX];
    int64_t hit = 0;
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const double x = o.x - s->x[i], y = o.y - s->y[i], z = o.z - s->z[i];

        b[i] = x * d.x + y * d.y + z * d.z;
        square[i] = b[i] * b[i] - a * (x * x + y * y + z * z - s->rr[i]);
        hit |= square[i] >= 0.0 ? bit[i] : 0;
    }
    out->maybe = out->definite = out->definite_pair = 0;
    for (hit &= s->lanes; hit; hit &= hit - 1) {
        double root, far;

        i = common_first_lane((uint32_t)hit);
        root = sqrt(square[i]);
        out->lo[i] = (-b[i] - root) * inverse;
        far = (-b[i] + root) * inverse;
        out->hi[i] = out->lo[i];
        if (!(out->lo[i] <= tmax && far >= 0.0))
            continue;
        out->maybe |= 1u << i;
        if (out->lo[i] > 0.0 && out->lo[i] < tmax)
            out->definite |= 1u << i;
    }
}

COMMON_CLONES static uint32_t block_filter(const void *block, const uint32_t *owners, const pov_rays *rays,
                                           uint64_t lanes, pov_candidate *out)
{
    uint32_t n = 0;
    common_result a;

    (void)owners;
    for (; lanes; lanes &= lanes - 1) {
        result(block, rays, common_first_lane64(lanes), &a);
        n = common_candidates(&a, common_first_lane64(lanes), out, n);
    }
    return n;
}

static const pov_shape_fast sphere_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(sphere_block),
    .block_pack = block_pack,
    .block_filter = block_filter,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &sphere_fast : NULL; }

static const pov_shape_class sphere_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "sphere",
    .instance_size = sizeof(sphere),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .absorb = absorb,
    .extension = extension,
};

METHODS_PLUGIN(sphere, sphere_class);
