#include "numerics/methods/number.h"

#include "common/affine.h"
#include "common/quadric.h"
#include "numerics/methods/lanes.h"

typedef struct quadric { double q[COEFFICIENTS]; } quadric;

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    double *q = ((quadric *)self)->q;
    pov_vec3 v;
    int i;

    for (i = 0; i < 3; i++) {
        host->vector(in, &v);
        host->accept(in, ",");
        q[3 * i] = v.x, q[3 * i + 1] = v.y, q[3 * i + 2] = v.z;
    }
    q[J] = host->number(in);
}

static bool bounds(const void *self, pov_box *out)
{
    common_quadric s;

    common_quadric_make(&s, ((const quadric *)self)->q);
    return common_quadric_bounds(&s, out);
}

/* Half the gradient, or without its constant part the matrix times p. */
static num3 half_gradient(const double *q, num3 p, double linear)
{
    const num half = num_of(0.5);
    const num d = num_of(q[D]), e = num_of(q[E]), f = num_of(q[F]);
    num3 g;

    g.x = num_add(num_mul(num_of(q[A]), p.x), num_mul(half, num_add(num_add(num_mul(d, p.y), num_mul(e, p.z)), num_of(linear * q[G]))));
    g.y = num_add(num_mul(num_of(q[B]), p.y), num_mul(half, num_add(num_add(num_mul(d, p.x), num_mul(f, p.z)), num_of(linear * q[H]))));
    g.z = num_add(num_mul(num_of(q[C]), p.z), num_mul(half, num_add(num_add(num_mul(e, p.x), num_mul(f, p.y)), num_of(linear * q[I]))));
    return g;
}

static num value(const double *q, num3 p)
{
    const num3 g = half_gradient(q, p, 2.0);   /* the linear terms count whole in the value */

    return num_add(num3_dot(p, g), num_of(q[J]));
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const double *q = ((const quadric *)self)->q;
    line l = { num3_of(ray->org, ray->org_lo), num3_of(ray->dir, ray->dir_lo), num_of(0.0) };
    const num a = num3_dot(l.dir, half_gradient(q, l.dir, 0.0));
    num b = num3_dot(l.dir, half_gradient(q, l.from, 1.0)), root[2];
    unsigned n, i;

    if (IS_RECENTRED && num_double(a) != 0.0) {
        l.middle = num_neg(num_div(b, a));
        l.from = line_at(&l, l.middle);
        b = num3_dot(l.dir, half_gradient(q, l.from, 1.0));
    }
    n = solve(a, b, value(q, l.from), root);
    for (i = 0; i < 2; i++) {
        /* With a negative first coefficient the other root is the entry; solve() puts the linear one where it belongs. */
        if (n >> i & 1 && !report(hits, ray, &l, root[i], num_double(a) < 0.0 ? !i : i))
            return;
    }
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const num3 p = point_of(ray, at, num3_planar(pov_vec3_of(0.0, 0.0, 0.0)));

    *out = pov_unit(num3_double(half_gradient(((const quadric *)self)->q, p, 1.0)));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    return num_double(value(((const quadric *)self)->q, num3_of(point, point_lo))) <= 0.0;
}

/* With the kit's own map of the coefficients, rounded, and written out about the origin again. */
static bool absorb(void *self, const pov_affine *map)
{
    double *q = ((quadric *)self)->q, m[4][4], n[4][4], w[4][4];
    int axis[3], i, j, k;

    if (!(common_condition(map) < 1024.0) && !common_is_axial(map, axis))
        return false;
    for (i = 0; i < 4; i++) {
        for (j = 0; j < 4; j++)
            w[i][j] = i < 3 ? map->inv[i][j] : j == 3;
    }
    m[0][0] = q[A], m[1][1] = q[B], m[2][2] = q[C], m[3][3] = q[J];
    m[0][1] = m[1][0] = 0.5 * q[D], m[0][2] = m[2][0] = 0.5 * q[E], m[1][2] = m[2][1] = 0.5 * q[F];
    m[0][3] = m[3][0] = 0.5 * q[G], m[1][3] = m[3][1] = 0.5 * q[H], m[2][3] = m[3][2] = 0.5 * q[I];
    for (i = 0; i < 4; i++) {
        for (j = 0; j < 4; j++) {
            n[i][j] = 0.0;
            for (k = 0; k < 16; k++)
                n[i][j] += w[k / 4][i] * m[k / 4][k % 4] * w[k % 4][j];
        }
    }
    q[A] = n[0][0], q[B] = n[1][1], q[C] = n[2][2], q[J] = n[3][3];
    q[D] = 2.0 * n[0][1], q[E] = 2.0 * n[0][2], q[F] = 2.0 * n[1][2];
    q[G] = 2.0 * n[0][3], q[H] = 2.0 * n[1][3], q[I] = 2.0 * n[2][3];
    return true;
}

METHODS_LANES(bounds)

static const pov_shape_fast quadric_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(lane_boxes),
    .block_pack = block_pack,
    .block_filter = block_filter,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &quadric_fast : NULL; }

static const pov_shape_class quadric_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "quadric",
    .instance_size = sizeof(quadric),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .absorb = absorb,
    .extension = extension,
};

METHODS_PLUGIN(quadric, quadric_class);
