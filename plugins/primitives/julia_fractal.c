/* julia_fractal { <4 numbers> [quaternion | hypercomplex] [sqr | cube | ...] [max_iteration n] [precision p] [slice <4 numbers>, d] }:
 * points of a three-dimensional slice whose first n places under q -> f(q) + c stay within a sphere. */
#include "common/cell_box.h"
#include "common/julia.h"

/* ---- loading ---- */

typedef struct keyword { const char *word; common_julia_function *f; } keyword;

static const keyword keywords[] = {
    { "exp", disc_exp }, { "reciprocal", disc_reciprocal }, { "sin", disc_sin }, { "asin", disc_asin }, { "sinh", disc_sinh },
    { "asinh", disc_asinh }, { "cos", disc_cos }, { "acos", disc_acos }, { "cosh", disc_cosh }, { "acosh", disc_acosh },
    { "tan", disc_tan }, { "atan", disc_atan }, { "tanh", disc_tanh }, { "atanh", disc_atanh }, { "ln", disc_log },
};

/* What has been said, in any order. */
typedef struct wishes { common_julia_function *f; bool cube, hypercomplex, quaternion; } wishes;

static bool read_power(common_julia *j, wishes *w, const pov_host *host, pov_reader *in)
{
    if (!host->accept(in, "pwr"))
        return false;
    host->accept(in, "(");
    j->power.re = host->number(in);
    host->accept(in, ",");
    j->power.im = host->number(in);
    host->accept(in, ")");
    w->f = disc_log;
    return j->is_power = true;
}

static bool read_function(common_julia *j, wishes *w, const pov_host *host, pov_reader *in)
{
    for (size_t i = 0; i < sizeof keywords / sizeof *keywords; i++)
        if (host->accept(in, keywords[i].word)) {
            w->f = keywords[i].f;
            j->is_power = false;
            return true;
        }
    if (host->accept(in, "cube"))
        return w->cube = true;
    return host->accept(in, "sqr") || read_power(j, w, host, in);
}

static void read_slice(common_julia *j, const pov_host *host, pov_reader *in)
{
    double size = 0.0;

    host->vector_of(in, j->slice.v, 4);
    host->accept(in, ",");
    j->at = host->number(in);
    for (int i = 0; i < 4; i++)
        size += j->slice.v[i] * j->slice.v[i];
    size = sqrt(size);
    for (int i = 0; i < 4; i++)
        j->slice.v[i] /= size;
    if (!(fabs(j->slice.v[3]) > 0.0))
        host->fail(in, "the slice of a julia_fractal must not be along its fourth axis");
}

static bool read_item(common_julia *j, wishes *w, const pov_host *host, pov_reader *in)
{
    if (host->accept(in, "hypercomplex"))
        w->hypercomplex = true;
    else if (host->accept(in, "quaternion"))
        w->quaternion = true;
    else if (host->accept(in, "max_iteration"))
        j->places = (uint32_t)pov_min(pov_max(host->number(in), 1.0), 1e6);
    else if (host->accept(in, "precision"))
        j->shortest = 1.0 / pov_min(pov_max(host->number(in), 1.0), 1e5);
    else if (host->accept(in, "slice"))
        read_slice(j, host, in);
    else
        return host->accept(in, ",") || read_function(j, w, host, in);
    return true;
}

static double square_of(const common_number *q) { return q->v[0] * q->v[0] + q->v[1] * q->v[1] + q->v[2] * q->v[2] + q->v[3] * q->v[3]; }

/* ---- the box around it ---- */

enum { PLACES_OF_BOX = 20 };

/* Of the points whose numbers are up to `off` from the number of p, through so many places at most. */
static common_side side_of(const common_julia *j, pov_vec3 p, double off, uint32_t most)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    common_probes s;

    common_probe_put(&s, 0, p, zero, off, off > 0.0);
    common_julia_follow(j, j->places < most ? j->places : most, j->reach, &s, 1);
    return common_probe_side(&s, 0);
}

static bool may_hold(const void *self, const pov_box *cell)
{
    const common_julia *j = self;
    const pov_vec3 size = pov_sub(cell->hi, cell->lo);
    const double *n = j->slice.v, last = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / fabs(n[3]);   /* as fast the fourth number changes */
    const double rate = sqrt(1.0 + last * last);

    return side_of(j, pov_scale(pov_add(cell->lo, cell->hi), 0.5), 0.5 * sqrt(pov_dot(size, size)) * rate, PLACES_OF_BOX) != COMMON_OUT;
}

static void find_box(common_julia *j)
{
    const double r = j->reach * (1.0 + 0x1p-20);
    const pov_box cube = { { -r, -r, -r }, { r, r, r } };

    common_cell_box(j, &cube, may_hold, &j->box);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    wishes w = { NULL, false, false, false };
    common_julia *j = self;

    host->vector_of(in, j->c.v, 4);
    j->slice.v[3] = 1.0;
    j->places = 20;
    j->shortest = 1.0 / 20.0;
    while (read_item(j, &w, host, in))
        continue;
    if (w.f && w.quaternion)
        host->fail(in, "quaternions have the functions sqr and cube only");
    if (w.cube && w.hypercomplex)
        host->warn(in, "hypercomplex numbers have no \"cube\": \"sqr\" is taken, as by POV-Ray");
    j->cube = w.cube;
    j->f = w.f ? w.f : w.hypercomplex ? disc_squared : NULL;
    j->squares = j->f == disc_squared;
    j->reach = j->f ? 4.0 : pov_min(1.0 + sqrt(square_of(&j->c)), 2.0);
    j->shortest *= j->f ? 0x1p-4 : 0x1p-10;   /* of quaternions few stretches come near it */
    j->first = j->f ? 0.25 : 0.5;
    j->shrink = j->f ? 0.25 : 0.3;
    j->grow = j->f ? 2.0 : 1.4;
    find_box(j);
}

static bool bounds(const void *self, pov_box *out)
{
    *out = ((const common_julia *)self)->box;
    return true;
}

/* ---- points ---- */

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    return side_of(self, pov_add(point, point_lo), 0.0, UINT32_MAX) == COMMON_IN;
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);

    *out = pov_unit(common_julia_slope(self, pov_two3_hi(common_point(&k, at)), at->mark.feature));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

/* As POV-Ray has it: of the place after the last, where it was the last that left the sphere. */
static uint32_t shading_normals(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark, pov_vec3 *out,
                                double *share)
{
    const common_julia *j = self;

    if ((j->f && j->f != disc_squared) || mark->feature + 1 != j->places)
        return 0;
    *out = pov_unit(common_julia_slope(j, pov_add(point, point_lo), mark->feature + 1));
    *share = 1.0;
    return pov_largest(*out) > 0.0;
}

static const pov_shape_fast fast = { .size = sizeof(pov_shape_fast), .intersect_many = common_julia_intersect_many };
static const void *extension(const char *name) { return common_is_fast(name) ? &fast : NULL; }

static const pov_shape_class julia_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "julia_fractal",
    .instance_size = sizeof(common_julia),
    .parse = parse,
    .bounds = bounds,
    .intersect = common_julia_intersect,
    .normal = normal,
    .inside = inside,
    .extension = extension,
    .shading_normals = shading_normals,
};

static const pov_shape_class *const shapes[] = { &julia_class, NULL };

POV_PLUGIN(julia_fractal) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "julia_fractal",
    .version = "1",
    .shapes = shapes,
};
