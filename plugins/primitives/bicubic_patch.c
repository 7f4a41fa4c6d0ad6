/* bicubic_patch { type t [flatness f] [u_steps n] [v_steps n] [uv_vectors ...] 16 points }: a Bezier surface, drawn as
 * 2^u_steps times 2^v_steps cells of two triangles, whose corners lie on it and have its normals. */
#include "common/triangle.h"

enum { STEPS_MAX = 8 };

typedef struct patch {
    uint32_t wide, deep;         /* corners along u and v */
    const pov_vec3 *at, *normal; /* of corners: scaled; unit */
    const pov_hierarchy *cells;
    pov_vec3 anchor;             /* scaled */
    double scale;
    pov_box box;
    double uv[4][2];             /* at u and v 0 0, 1 0, 1 1, 0 1 */
} patch;

/* ---- loading ---- */

typedef struct reading { const pov_host *host; pov_reader *in; pov_vec3 point[16]; uint32_t steps[2]; } reading;

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

static void surface_at(const reading *r, double u, double v, pov_vec3 *at, pov_vec3 *normal)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    double a[4], b[4], da[4], db[4];
    pov_vec3 by_u = zero, by_v = zero;

    blend(u, a, da);
    blend(v, b, db);
    *at = zero;
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 4; i++) {
            *at = pov_add(*at, pov_scale(r->point[4 * j + i], a[i] * b[j]));
            by_u = pov_add(by_u, pov_scale(r->point[4 * j + i], da[i] * b[j]));
            by_v = pov_add(by_v, pov_scale(r->point[4 * j + i], a[i] * db[j]));
        }
    *normal = pov_unit(pov_cross_product(by_u, by_v));
}

static void include(pov_box *box, pov_vec3 p)
{
    box->lo = pov_vec3_of(fmin(box->lo.x, p.x), fmin(box->lo.y, p.y), fmin(box->lo.z, p.z));
    box->hi = pov_vec3_of(fmax(box->hi.x, p.x), fmax(box->hi.y, p.y), fmax(box->hi.z, p.z));
}

static void make_corners(patch *p, reading *r, pov_vec3 *at, pov_vec3 *normal)
{
    p->box.lo = p->box.hi = r->point[0];
    for (uint32_t v = 0; v < p->deep; v++)
        for (uint32_t u = 0; u < p->wide; u++) {
            const uint32_t i = v * p->wide + u;

            surface_at(r, u / (p->wide - 1.0), v / (p->deep - 1.0), &at[i], &normal[i]);
            include(&p->box, at[i]);
        }
    p->scale = pov_inverse_power(fmax(pov_largest(p->box.lo), pov_largest(p->box.hi)));
    p->anchor = pov_scale(pov_add(p->box.lo, p->box.hi), 0.5 * p->scale);
}

static void make_cells(patch *p, reading *r, const pov_vec3 *at)
{
    pov_box *boxes = r->host->alloc(r->in, (p->wide - 1) * (p->deep - 1) * sizeof *boxes);

    for (uint32_t v = 0; boxes && v + 1 < p->deep; v++)
        for (uint32_t u = 0; u + 1 < p->wide; u++) {
            const pov_vec3 *c = at + v * p->wide + u;
            pov_box *box = &boxes[v * (p->wide - 1) + u];

            box->lo = box->hi = c[0];
            include(box, c[1]);
            include(box, c[p->wide]);
            include(box, c[p->wide + 1]);
        }
    p->cells = boxes ? r->host->hierarchy(r->in, boxes, (p->wide - 1) * (p->deep - 1)) : NULL;
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    static const double square[4][2] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
    reading r = { host, in, { { 0.0, 0.0, 0.0 } }, { 0, 0 } };
    pov_vec3 *at, *normal;
    patch *p = self;

    memcpy(p->uv, square, sizeof square);
    read_words(p, &r);
    for (int i = 0; i < 16; i++) {
        host->accept(in, ",");
        host->vector(in, &r.point[i]);
    }
    p->wide = (1u << r.steps[0]) + 1;
    p->deep = (1u << r.steps[1]) + 1;
    at = host->alloc(in, p->wide * p->deep * sizeof *at);
    normal = host->alloc(in, p->wide * p->deep * sizeof *normal);
    if (!at || !normal)
        return;
    make_corners(p, &r, at, normal);
    make_cells(p, &r, at);
    for (uint32_t i = 0; i < p->wide * p->deep; i++)
        at[i] = pov_scale(at[i], p->scale);
    p->at = at;
    p->normal = normal;
}

static bool bounds(const void *self, pov_box *out)
{
    *out = ((const patch *)self)->box;
    return true;
}

/* ---- rays ---- */

/* The corners of a face, by their numbers: two faces a cell. */
static void corners_of(const patch *p, uint32_t face, uint32_t which[3])
{
    const uint32_t cell = face / 2, first = cell / (p->wide - 1) * p->wide + cell % (p->wide - 1);

    which[0] = face % 2 == 0 ? first : first + p->wide + 1;
    which[1] = face % 2 == 0 ? first + 1 : first + p->wide;
    which[2] = face % 2 == 0 ? first + p->wide : first + 1;
}

typedef struct visit { const patch *p; const pov_ray *ray; pov_hits *hits; common_triangle_ray through; } visit;

static bool visit_cell(void *user, uint32_t cell)
{
    visit *v = user;

    for (uint32_t face = 2 * cell; face < 2 * cell + 2; face++) {
        const pov_mark mark = { face, 0, 0.0, 0.0 };
        uint32_t c[3];

        corners_of(v->p, face, c);
        if (v->ray->origin_surface == v->hits->owner && v->ray->origin_mark.feature == face)
            continue;
        if (common_triangle_is_hit(&v->through, &v->p->at[c[0]], &v->p->at[c[1]], &v->p->at[c[2]]) &&
            !common_triangle_cross(&v->through, &v->p->at[c[0]], &v->p->at[c[1]], &v->p->at[c[2]], mark, v->hits))
            return false;
    }
    return true;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    visit v;

    v.p = self;
    v.ray = ray;
    v.hits = hits;
    if (!v.p->cells)
        return;
    common_triangle_enter(&v.through, ray, v.p->anchor, v.p->scale, hits->always_exact);
    v.p->cells->visit(v.p->cells, ray, hits, visit_cell, &v);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const patch *p = self;
    uint32_t c[3];

    corners_of(p, at->mark.feature, c);
    *out = pov_unit(common_triangle_normal(&p->at[c[0]], &p->at[c[1]], &p->at[c[2]]));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

static void shares_of(const patch *p, pov_vec3 point, pov_vec3 point_lo, const uint32_t c[3], double share[3])
{
    common_triangle_shares(&p->at[c[0]], &p->at[c[1]], &p->at[c[2]], pov_scale(point, p->scale), pov_scale(point_lo, p->scale), share);
}

static bool shading_normal(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark, pov_vec3 *out)
{
    const patch *p = self;
    double share[3];
    uint32_t c[3];

    corners_of(p, mark->feature, c);
    shares_of(p, point, point_lo, c, share);
    *out = pov_add(pov_scale(p->normal[c[0]], share[0]), pov_add(pov_scale(p->normal[c[1]], share[1]), pov_scale(p->normal[c[2]], share[2])));
    return pov_largest(*out) > 0.0;
}

static void uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2])
{
    const patch *p = self;
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    double share[3], u = 0.0, v = 0.0;
    uint32_t c[3];

    corners_of(p, mark->feature, c);
    shares_of(p, point, zero, c, share);
    for (int i = 0; i < 3; i++) {
        u += share[i] * (c[i] % p->wide) / (p->wide - 1.0);
        v += share[i] * (c[i] / p->wide) / (p->deep - 1.0);
    }
    for (int i = 0; i < 2; i++)
        out[i] = (p->uv[0][i] * (1.0 - u) + p->uv[1][i] * u) * (1.0 - v) + (p->uv[3][i] * (1.0 - u) + p->uv[2][i] * u) * v;
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
    .shading_normal = shading_normal,
};

static const pov_shape_class *const shapes[] = { &bicubic_patch_class, NULL };

POV_PLUGIN(bicubic_patch) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "bicubic_patch",
    .version = "1",
    .shapes = shapes,
};
