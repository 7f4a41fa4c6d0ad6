#include "common/sheet.h"

#include "common/simd.h"

static void include(pov_box *box, pov_vec3 p)
{
    box->lo = pov_vec3_of(fmin(box->lo.x, p.x), fmin(box->lo.y, p.y), fmin(box->lo.z, p.z));
    box->hi = pov_vec3_of(fmax(box->hi.x, p.x), fmax(box->hi.y, p.y), fmax(box->hi.z, p.z));
}

/* ---- made ---- */

static pov_box make_corners(common_sheet *s, common_sheet_corner *corner, void *user, pov_vec3 *at, pov_vec3 *normal)
{
    pov_box box = { { HUGE_VAL, HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };

    for (uint32_t v = 0; v < s->deep; v++)
        for (uint32_t u = 0; u < s->wide; u++) {
            const uint32_t i = v * s->wide + u;

            corner(user, u / (s->wide - 1.0), v / (s->deep - 1.0), &at[i], &normal[i]);
            include(&box, at[i]);
        }
    return box;
}

static void make_cells(common_sheet *s, const pov_host *host, pov_reader *in, const pov_vec3 *at)
{
    const uint32_t count = (s->wide - 1) * (s->deep - 1);
    pov_box *boxes = host->alloc(in, count * sizeof *boxes);

    for (uint32_t i = 0; boxes && i < count; i++) {
        const pov_vec3 *c = at + i / (s->wide - 1) * s->wide + i % (s->wide - 1);

        boxes[i].lo = boxes[i].hi = c[0];
        include(&boxes[i], c[1]);
        include(&boxes[i], c[s->wide]);
        include(&boxes[i], c[s->wide + 1]);
    }
    s->cells = boxes ? host->hierarchy(in, boxes, count) : NULL;
}

static void put_corner(common_sheet_cell *to, int i, pov_vec3 p)
{
    to->at[0][i] = p.x;
    to->at[1][i] = p.y;
    to->at[2][i] = p.z;
}

static void make_sides(common_sheet *s, const pov_host *host, pov_reader *in)
{
    const uint32_t count = (s->wide - 1) * (s->deep - 1);
    common_sheet_cell *cell = host->alloc(in, count * sizeof *cell);

    for (uint32_t i = 0; cell && i < count; i++) {
        const pov_vec3 *c = s->at + i / (s->wide - 1) * s->wide + i % (s->wide - 1);

        for (int k = 0; k < 4; k++)
            put_corner(&cell[i], k, pov_sub(c[k / 2 * s->wide + k % 2], s->anchor));
    }
    s->cell = cell;
}

static bool is_finite(pov_vec3 v) { return isfinite(v.x) && isfinite(v.y) && isfinite(v.z); }

void common_sheet_make(common_sheet *s, const pov_host *host, pov_reader *in, uint32_t wide, uint32_t deep,
                       common_sheet_corner *corner, void *user)
{
    const size_t bytes = (size_t)wide * deep * sizeof(pov_vec3);
    pov_vec3 *at = host->alloc(in, bytes), *normal = host->alloc(in, bytes);
    pov_box box;

    s->wide = wide;
    s->deep = deep;
    if (!at || !normal)
        return;
    box = make_corners(s, corner, user, at, normal);
    for (uint32_t i = 0; i < wide * deep; i++)
        if (!is_finite(at[i])) {
            host->fail(in, "a point of this surface has no place");
            return;
        }
    s->scale = pov_inverse_power(fmax(pov_largest(box.lo), pov_largest(box.hi)));
    s->anchor = pov_scale(pov_add(box.lo, box.hi), 0.5 * s->scale);
    if (!s->bounded)
        s->box = box;
    make_cells(s, host, in, at);
    for (uint32_t i = 0; i < wide * deep; i++)
        at[i] = pov_scale(at[i], s->scale);
    s->at = at;
    s->normal = normal;
    make_sides(s, host, in);
}

/* ---- rays ---- */

/* The corners of a face, by their numbers: two faces a cell, split from its least u and v to its greatest. */
static void corners_of(const common_sheet *s, uint32_t face, uint32_t which[3])
{
    const uint32_t cell = face / 2, first = cell / (s->wide - 1) * s->wide + cell % (s->wide - 1);

    which[0] = first;
    which[1] = face % 2 == 0 ? first + 1 : first + s->wide + 1;
    which[2] = face % 2 == 0 ? first + s->wide + 1 : first + s->wide;
}

typedef struct visit { const common_sheet *s; const pov_ray *ray; pov_hits *hits; common_triangle_ray through; bool entered; } visit;

/* Of a surface with a container: is the crossing within it? */
static bool is_within(visit *v, const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c)
{
    const pov_mark mark = { 0, 0, 0.0, 0.0 };
    const pov_box *box = &v->s->box;
    pov_hits one = *v->hits;
    pov_crossing at;
    pov_vec3 p;

    if (!v->s->bounded)
        return true;
    one.want = POV_WANT_NEAREST;
    one.count = 0;
    one.at = &at;
    common_triangle_cross(&v->through, a, b, c, mark, &one);
    if (one.count == 0)
        return false;
    p = pov_add(v->ray->org, pov_scale(v->ray->dir, at.t));
    return p.x >= box->lo.x && p.y >= box->lo.y && p.z >= box->lo.z && p.x <= box->hi.x && p.y <= box->hi.y && p.z <= box->hi.z;
}

/* A face by its corners, and as the ray sees them. False: nothing more is wanted. */
static bool cross_face(visit *v, uint32_t face, const pov_vec3 *const at[3], const common_seen seen[3])
{
    const pov_mark mark = { face, 0, 0.0, 0.0 };

    if (v->ray->origin_surface == v->hits->owner && v->ray->origin_mark.feature == face)
        return true;
    return !common_triangle_is_passed(&v->through, at[0], seen[0], at[1], seen[1], at[2], seen[2]) ||
           !is_within(v, at[0], at[1], at[2]) || common_triangle_cross(&v->through, at[0], at[1], at[2], mark, v->hits);
}

/* Are all four corners certainly on one side of the ray, or of its level? */
static bool is_beside(const common_view *v, const common_sheet_cell *c)
{
    const double *p = c->at[v->across], *q = c->at[v->up], *r = c->at[v->forward];
    const double from_p = v->w[v->across], from_q = v->w[v->up], from_r = v->w[v->forward];
    const double dp = v->d[v->across], dq = v->d[v->up], dr = v->d[v->forward];
    double across[4], up[4], least[2], most[2];

    for (int i = 0; i < 4; i++) {
        across[i] = (p[i] - from_p) * dr - (r[i] - from_r) * dp;
        up[i] = (q[i] - from_q) * dr - (r[i] - from_r) * dq;
    }
    least[0] = common_lesser(common_lesser(across[0], across[1]), common_lesser(across[2], across[3]));
    most[0] = common_greater(common_greater(across[0], across[1]), common_greater(across[2], across[3]));
    least[1] = common_lesser(common_lesser(up[0], up[1]), common_lesser(up[2], up[3]));
    most[1] = common_greater(common_greater(up[0], up[1]), common_greater(up[2], up[3]));
    return !v->exact && (least[0] > v->error || most[0] < -v->error || least[1] > v->error || most[1] < -v->error);
}

static void enter(visit *v)
{
    if (!v->entered)
        common_triangle_enter(&v->through, v->ray, v->s->anchor, v->s->scale, v->hits->always_exact);
    v->entered = true;
}

static bool cross_cell(visit *v, uint32_t cell)
{
    const uint32_t wide = v->s->wide;
    const pov_vec3 *a = v->s->at + cell / (wide - 1) * wide + cell % (wide - 1), *b = a + 1, *c = a + wide, *d = c + 1;
    const common_seen seen[4] = { common_triangle_see(&v->through, a), common_triangle_see(&v->through, b),
                                  common_triangle_see(&v->through, c), common_triangle_see(&v->through, d) };
    const pov_vec3 *const low[3] = { a, b, d }, *const high[3] = { a, d, c };
    const common_seen low_seen[3] = { seen[0], seen[1], seen[3] }, high_seen[3] = { seen[0], seen[3], seen[2] };

    return common_triangle_are_beside(&v->through, seen) ||
           (cross_face(v, 2 * cell, low, low_seen) && cross_face(v, 2 * cell + 1, high, high_seen));
}

static bool visit_cell(void *user, uint32_t cell)
{
    visit *v = user;

    enter(v);
    return is_beside(&v->through.view, &v->s->cell[cell]) || cross_cell(v, cell);
}

void common_sheet_intersect(const common_sheet *s, const pov_ray *ray, pov_hits *hits)
{
    visit v;

    if (!s->cells || !s->cell)
        return;
    v.s = s;
    v.ray = ray;
    v.hits = hits;
    v.entered = false;
    s->cells->visit(s->cells, ray, hits, visit_cell, &v);
}

/* ---- points ---- */

void common_sheet_normal(const common_sheet *s, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    uint32_t c[3];

    corners_of(s, at->mark.feature, c);
    *out = pov_unit(common_triangle_normal(&s->at[c[0]], &s->at[c[1]], &s->at[c[2]]));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

static void shares_of(const common_sheet *s, pov_vec3 point, pov_vec3 point_lo, const uint32_t c[3], double share[3])
{
    common_triangle_shares(&s->at[c[0]], &s->at[c[1]], &s->at[c[2]], pov_scale(point, s->scale), pov_scale(point_lo, s->scale), share);
}

uint32_t common_sheet_shading_normals(const common_sheet *s, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark,
                                      pov_vec3 *normal, double *share)
{
    uint32_t c[3];

    corners_of(s, mark->feature, c);
    shares_of(s, point, point_lo, c, share);
    for (int i = 0; i < 3; i++)
        normal[i] = s->normal[c[i]];
    return 3;
}

void common_sheet_uv(const common_sheet *s, pov_vec3 point, const pov_mark *mark, double out[2])
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    double share[3];
    uint32_t c[3];

    corners_of(s, mark->feature, c);
    shares_of(s, point, zero, c, share);
    out[0] = out[1] = 0.0;
    for (int i = 0; i < 3; i++) {
        out[0] += share[i] * (c[i] % s->wide) / (s->wide - 1.0);
        out[1] += share[i] * (c[i] / s->wide) / (s->deep - 1.0);
    }
}
