/* bicubic_patch { type t [flatness f] [u_steps n] [v_steps n] [uv_vectors ...] 16 points }: a Bezier surface, drawn as
 * 2^v_steps by 2^u_steps cells of two triangles, whose corners lie on it and have its normals. */
#include "common/sheet.h"

enum { STEPS_MAX = 8 };

typedef struct patch {
    common_sheet sheet;
    double uv[4][2];             /* at u and v 0 0, 1 0, 1 1, 0 1 */
} patch;

/* ---- loading ---- */

/* Points fill up vectors with a fourth coordinate of zero. */
typedef struct reading { const pov_host *host; pov_reader *in; double point[16][4]; uint32_t steps[2]; } reading;

static uint32_t read_steps(reading *r)
{
    const double n = r->host->number(r->in);

    return n >= 0.0 && n <= STEPS_MAX ? (uint32_t)n : n > STEPS_MAX ? STEPS_MAX : 0;
}

static void read_uv(patch *p, reading *r)
{
    for (int i = 0; i < 4; i++) {
        r->host->accept(r->in, ",");
        r->host->vector_of(r->in, p->uv[i], 2);
    }
}

static void read_words(patch *p, reading *r)
{
    bool typed = false, read = true;

    while (read) {
        read = true;
        if (r->host->accept(r->in, "type"))
            typed = (r->host->number(r->in), true);
        else if (r->host->accept(r->in, "flatness"))
            r->host->number(r->in);
        else if (r->host->accept(r->in, "u_steps"))
            r->steps[0] = read_steps(r);
        else if (r->host->accept(r->in, "v_steps"))
            r->steps[1] = read_steps(r);
        else if (r->host->accept(r->in, "uv_vectors"))
            read_uv(p, r);
        else
            read = r->host->accept(r->in, "accuracy") && (r->host->number(r->in), true);
        r->host->accept(r->in, ",");
    }
    if (!typed)
        r->host->fail(r->in, "a bicubic_patch needs its type, 0 or 1");
}

/* Bernstein polynomials and their slopes. */
static void blend(double u, double b[4], double slope[4])
{
    const double v = 1.0 - u;

    b[0] = v * v * v;
    b[1] = 3.0 * u * v * v;
    b[2] = 3.0 * u * u * v;
    b[3] = u * u * u;
    slope[0] = -v * v;
    slope[1] = v * v - 2.0 * u * v;
    slope[2] = 2.0 * u * v - u * u;
    slope[3] = u * u;
}

static void surface_at(void *user, double u, double v, pov_vec3 *at, pov_vec3 *normal)
{
    const reading *r = user;
    double a[4], b[4], da[4], db[4], sum[4] = { 0.0, 0.0, 0.0, 0.0 }, by_u[4] = { 0.0, 0.0, 0.0, 0.0 }, by_v[4] = { 0.0, 0.0, 0.0, 0.0 };

    blend(u, a, da);
    blend(v, b, db);
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 4; i++) {
            const double *p = r->point[4 * j + i], weight = a[i] * b[j], along_u = da[i] * b[j], along_v = a[i] * db[j];

            for (int k = 0; k < 4; k++)
                sum[k] += p[k] * weight;
            for (int k = 0; k < 4; k++)
                by_u[k] += p[k] * along_u;
            for (int k = 0; k < 4; k++)
                by_v[k] += p[k] * along_v;
        }
    *at = pov_vec3_of(sum[0], sum[1], sum[2]);
    *normal = pov_unit(pov_cross_product(pov_vec3_of(by_v[0], by_v[1], by_v[2]), pov_vec3_of(by_u[0], by_u[1], by_u[2])));
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    static const double square[4][2] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
    reading r = { host, in, { { 0.0, 0.0, 0.0, 0.0 } }, { 0, 0 } };
    patch *p = self;

    memcpy(p->uv, square, sizeof square);
    read_words(p, &r);
    for (int i = 0; i < 16; i++) {
        pov_vec3 at = { 0.0, 0.0, 0.0 };

        host->accept(in, ",");
        host->vector(in, &at);
        r.point[i][0] = at.x;
        r.point[i][1] = at.y;
        r.point[i][2] = at.z;
    }
    /* In POV-Ray v_steps are those along a row of points. */
    common_sheet_make(&p->sheet, host, in, (1u << r.steps[1]) + 1, (1u << r.steps[0]) + 1, surface_at, &r);
}

static bool bounds(const void *self, pov_box *out)
{
    *out = ((const patch *)self)->sheet.box;
    return true;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    common_sheet_intersect(&((const patch *)self)->sheet, ray, hits);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    common_sheet_normal(&((const patch *)self)->sheet, ray, at, out);
}

static uint32_t shading_normals(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark, pov_vec3 *normals,
                                double *share)
{
    return common_sheet_shading_normals(&((const patch *)self)->sheet, point, point_lo, mark, normals, share);
}

static void uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2])
{
    const patch *p = self;
    double at[2];

    common_sheet_uv(&p->sheet, point, mark, at);
    for (int i = 0; i < 2; i++)
        out[i] = (p->uv[0][i] * (1.0 - at[0]) + p->uv[1][i] * at[0]) * (1.0 - at[1]) +
                 (p->uv[3][i] * (1.0 - at[0]) + p->uv[2][i] * at[0]) * at[1];
}

static const pov_shape_class bicubic_patch_class = {
    .size = sizeof(pov_shape_class),
    .keyword = "bicubic_patch",
    .instance_size = sizeof(patch),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .uv = uv,
    .shading_normals = shading_normals,
};

static const pov_shape_class *const shapes[] = { &bicubic_patch_class, NULL };

POV_PLUGIN(bicubic_patch) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "bicubic_patch",
    .version = "1",
    .shapes = shapes,
};
