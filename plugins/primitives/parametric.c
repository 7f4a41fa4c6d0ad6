/* parametric { function { x } function { y } function { z } <u0, v0>, <u1, v1> [contained_by] ... }: a surface of two parameters,
 * drawn as a sheet of triangles whose corners lie on it and have its normals. */
#include "common/sheet.h"

enum { CORNERS = 257 };          /* along u, and along v */

typedef struct parametric {
    common_sheet sheet;
    double from[2], to[2];
} parametric;

/* ---- loading ---- */

typedef struct reading { const pov_function *of[3]; double *memory; const parametric *p; } reading;

static pov_vec3 point_at(const reading *r, double u, double v)
{
    const double at[3] = { u, v, 0.0 };

    return pov_vec3_of(r->of[0]->value(r->of[0], at, r->memory), r->of[1]->value(r->of[1], at, r->memory), r->of[2]->value(r->of[2], at, r->memory));
}

static void corner_at(void *user, double u, double v, pov_vec3 *at, pov_vec3 *normal)
{
    const reading *r = user;
    const parametric *p = r->p;
    const double du = p->to[0] - p->from[0], dv = p->to[1] - p->from[1], x = p->from[0] + u * du, y = p->from[1] + v * dv, h = 0x1p-16;

    *at = point_at(r, x, y);
    *normal = pov_unit(pov_cross_product(pov_sub(point_at(r, x + h * du, y), point_at(r, x - h * du, y)),
                                         pov_sub(point_at(r, x, y + h * dv), point_at(r, x, y - h * dv))));
}

static void read_container(parametric *p, const pov_host *host, pov_reader *in)
{
    const pov_vec3 one = { 1.0, 1.0, 1.0 };
    pov_vec3 a, b;
    bool is_sphere;

    p->sheet.radius = 0.0;
    host->expect(in, "{");
    is_sphere = host->accept(in, "sphere");
    if (!is_sphere)
        host->expect(in, "box");
    host->expect(in, "{");
    host->vector(in, &a);
    host->accept(in, ",");
    if (is_sphere) {
        p->sheet.radius = fabs(host->number(in));
        b = pov_add(a, pov_scale(one, p->sheet.radius));
        a = pov_sub(a, pov_scale(one, p->sheet.radius));
    } else {
        host->vector(in, &b);
    }
    host->expect(in, "}");
    host->expect(in, "}");
    p->sheet.bounded = true;
    p->sheet.box.lo = pov_vec3_of(pov_min(a.x, b.x), pov_min(a.y, b.y), pov_min(a.z, b.z));
    p->sheet.box.hi = pov_vec3_of(pov_max(a.x, b.x), pov_max(a.y, b.y), pov_max(a.z, b.z));
}

/* Words of a method that there is not here. */
static bool read_item(parametric *p, const pov_host *host, pov_reader *in)
{
    if (host->accept(in, "contained_by")) {
        read_container(p, host, in);
    } else if (host->accept(in, "accuracy") || host->accept(in, "max_gradient")) {
        host->number(in);
    } else if (host->accept(in, "precompute")) {
        host->number(in);
        while (host->accept(in, ",") || host->accept(in, "x") || host->accept(in, "y") || host->accept(in, "z"))
            continue;
    } else {
        return false;
    }
    return true;
}

static bool read_functions(reading *r, const pov_host *host, pov_reader *in)
{
    uint32_t memory = 1;

    for (int i = 0; i < 3; i++) {
        host->accept(in, ",");
        host->expect(in, "function");
        r->of[i] = host->function ? host->function(in, 2) : NULL;
        if (!r->of[i])
            return false;
        memory = r->of[i]->memory > memory ? r->of[i]->memory : memory;
    }
    r->memory = host->alloc(in, memory * sizeof *r->memory);
    return r->memory != NULL;
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    parametric *p = self;
    reading r = { { NULL, NULL, NULL }, NULL, p };
    const pov_vec3 one = { 1.0, 1.0, 1.0 };

    p->sheet.bounded = true;
    p->sheet.box.lo = pov_scale(one, -1.0);
    p->sheet.box.hi = one;
    if (!read_functions(&r, host, in)) {
        host->fail(in, "a parametric needs three functions of u and v");
        return;
    }
    host->accept(in, ",");
    host->vector_of(in, p->from, 2);
    host->accept(in, ",");
    host->vector_of(in, p->to, 2);
    while (read_item(p, host, in))
        continue;
    common_sheet_make(&p->sheet, host, in, CORNERS, CORNERS, corner_at, &r);
}

static bool bounds(const void *self, pov_box *out)
{
    *out = ((const parametric *)self)->sheet.box;
    return true;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    common_sheet_intersect(&((const parametric *)self)->sheet, ray, hits);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    common_sheet_normal(&((const parametric *)self)->sheet, ray, at, out);
    *out = pov_scale(*out, -1.0);
}

static uint32_t shading_normals(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark, pov_vec3 *normals,
                                double *share)
{
    return common_sheet_shading_normals(&((const parametric *)self)->sheet, point, point_lo, mark, normals, share);
}

static void uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2])
{
    const parametric *p = self;

    common_sheet_uv(&p->sheet, point, mark, out);
    for (int i = 0; i < 2; i++)
        out[i] = p->from[i] + out[i] * (p->to[i] - p->from[i]);
}

static const pov_shape_class parametric_class = {
    .size = sizeof(pov_shape_class),
    .keyword = "parametric",
    .instance_size = sizeof(parametric),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .uv = uv,
    .shading_normals = shading_normals,
};

static const pov_shape_class *const shapes[] = { &parametric_class, NULL };

POV_PLUGIN(parametric) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "parametric",
    .version = "1",
    .shapes = shapes,
};
