#include "common/sheet.h"

#include "common/face_filter.h"
#include "common/simd.h"

/* Points are finite, or nothing is made of the box. */
static inline double lesser(double a, double b) { return a < b ? a : b; }
static inline double greater(double a, double b) { return a > b ? a : b; }

static void include(pov_box *box, pov_vec3 p)
{
    box->lo = pov_vec3_of(lesser(box->lo.x, p.x), lesser(box->lo.y, p.y), lesser(box->lo.z, p.z));
    box->hi = pov_vec3_of(greater(box->hi.x, p.x), greater(box->hi.y, p.y), greater(box->hi.z, p.z));
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

/* Of the corners of a cell the first; the others are beside it, and in the next row. */
static const pov_vec3 *first_corner(const common_sheet *s, uint32_t cell)
{
    return s->at + cell / (s->wide - 1) * s->wide + cell % (s->wide - 1);
}

static void box_of_cell(void *user, uint32_t cell, pov_box *out)
{
    const common_sheet *s = user;
    const pov_vec3 *c = first_corner(s, cell);
    const double per = common_inverse(s->scale);

    out->lo = out->hi = pov_scale(c[0], per);
    include(out, pov_scale(c[1], per));
    include(out, pov_scale(c[s->wide], per));
    include(out, pov_scale(c[s->wide + 1], per));
}

typedef struct filling { const common_sheet *s; float *blocks; } filling;

static bool fill_block(void *user, uint32_t first, uint32_t count)
{
    const filling *f = user;
    const common_sheet *s = f->s;

    for (uint32_t i = 0; i < count; i++) {
        const pov_vec3 *c = first_corner(s, s->order[first + i]);
        const pov_vec3 corner[4] = { pov_sub(c[0], s->anchor), pov_sub(c[1], s->anchor), pov_sub(c[s->wide], s->anchor),
                                     pov_sub(c[s->wide + 1], s->anchor) };

        common_cell_put(f->blocks + (size_t)COMMON_CELL_ROWS * first, count, i, corner);
    }
    return true;
}

static void make_cells(common_sheet *s, const pov_host *host, pov_reader *in)
{
    const uint32_t count = (s->wide - 1) * (s->deep - 1);
    uint32_t *order = host->alloc(in, count * sizeof *order);
    float *blocks = host->alloc(in, ((size_t)COMMON_CELL_ROWS * count + COMMON_FACE_PAD) * sizeof *blocks);
    const pov_hierarchy *cells = order && blocks ? host->hierarchy_in_order(in, count, box_of_cell, s, order) : NULL;
    filling f = { s, blocks };

    s->order = order;
    s->blocks = blocks;
    if (cells)
        cells->each_range(cells, fill_block, &f);
    s->cells = cells;
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
    s->scale = pov_inverse_power(pov_max(pov_largest(box.lo), pov_largest(box.hi)));
    s->anchor = pov_scale(pov_add(box.lo, box.hi), 0.5 * s->scale);
    if (!s->bounded)
        s->box = box;
    for (uint32_t i = 0; i < wide * deep; i++)
        at[i] = pov_scale(at[i], s->scale);
    s->at = at;
    s->normal = normal;
    make_cells(s, host, in);
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

typedef struct visit {
    const common_sheet *s;
    const pov_ray *ray;
    pov_hits *hits;
    common_triangle_ray through;
    common_face_view view;
    bool entered;
} visit;

static bool is_in_sphere(const common_sheet *s, pov_vec3 p)
{
    const pov_vec3 off = pov_sub(p, pov_scale(pov_add(s->box.lo, s->box.hi), 0.5));

    return s->radius == 0.0 || pov_dot(off, off) <= s->radius * s->radius;
}

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
    return p.x >= box->lo.x && p.y >= box->lo.y && p.z >= box->lo.z && p.x <= box->hi.x && p.y <= box->hi.y && p.z <= box->hi.z &&
           is_in_sphere(v->s, p);
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

static void enter(visit *v)
{
    if (v->entered)
        return;
    common_triangle_enter(&v->through, v->ray, v->s->anchor, v->s->scale, v->hits->unfiltered);
    v->view = common_face_view_of(&v->through.view);
    v->entered = true;
}

/* Those of its two faces that the ray may hit. */
static bool cross_cell(visit *v, uint32_t cell, bool first, bool second)
{
    const pov_vec3 *a = first_corner(v->s, cell), *b = a + 1, *c = a + v->s->wide, *d = c + 1;
    const common_seen p = common_triangle_see(&v->through, a), q = common_triangle_see(&v->through, d);
    const pov_vec3 *const low[3] = { a, b, d }, *const high[3] = { a, d, c };

    if (first) {
        const common_seen seen[3] = { p, common_triangle_see(&v->through, b), q };

        if (!cross_face(v, 2 * cell, low, seen))
            return false;
    }
    if (second) {
        const common_seen seen[3] = { p, q, common_triangle_see(&v->through, c) };

        return cross_face(v, 2 * cell + 1, high, seen);
    }
    return true;
}

static bool visit_cells(void *user, uint32_t first, uint32_t count)
{
    visit *v = user;
    const float *block = v->s->blocks + (size_t)COMMON_CELL_ROWS * first;

    enter(v);
    for (uint32_t i = 0; i < count; i += POV_BLOCK_MAX) {
        uint32_t high, low = common_cell_filter(block, count, i, &v->view, &high);

        for (uint32_t any = low | high; any; any &= any - 1) {
            const uint32_t lane = common_first_lane(any);

            if (!cross_cell(v, v->s->order[first + i + lane], low >> lane & 1, high >> lane & 1))
                return false;
        }
    }
    return true;
}

void common_sheet_intersect(const common_sheet *s, const pov_ray *ray, pov_hits *hits)
{
    visit v;

    if (!s->cells)
        return;
    v.s = s;
    v.ray = ray;
    v.hits = hits;
    v.entered = false;
    s->cells->visit_ranges(s->cells, ray, hits, visit_cells, &v);
    hits->escalated += v.entered && v.through.view.escalated;
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
