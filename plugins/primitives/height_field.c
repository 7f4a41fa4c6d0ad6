/* height_field { image | function W, H { f } [smooth] [water_level w] }: heights over the unit square, in cells of two triangles.
 *
 * Rays ask the cells that they may meet (common/relief.h). Edges are those of common/triangle.h: no ray slips between two
 * triangles. What is below the water level is left out. Inside is below the surface or the water, down without end. */
#include "common/boxed.h"
#include "common/relief.h"
#include "common/steep.h"
#include "common/triangle.h"

typedef struct height_field {
    common_boxed boxed;
    uint32_t wide, deep;         /* corners along x and z */
    const uint16_t *height;      /* in 1/65536, rows from z = 0 */
    const double *column, *row;  /* x and z of corners, rounded once, alike for each face that has them */
    common_relief relief;
    common_steeps steeps;        /* of a smooth one */
    double water, low, high;
    bool smooth;
} height_field;

/* ---- loading ---- */

static uint16_t *room(const height_field *f, const pov_host *host, pov_reader *in)
{
    return host->alloc(in, (size_t)f->wide * f->deep * sizeof(uint16_t));
}

static void read_image(height_field *f, const pov_host *host, pov_reader *in)
{
    const uint16_t *at = host->heights(in, &f->wide, &f->deep);
    uint16_t *out = at ? room(f, host, in) : NULL;

    for (uint32_t z = 0; out && z < f->deep; z++)
        memcpy(out + (size_t)z * f->wide, at + (size_t)(f->deep - 1 - z) * f->wide, f->wide * sizeof *out);
    f->height = out;
}

static uint32_t read_count(const pov_host *host, pov_reader *in)
{
    const double n = host->number(in);

    if (!(n >= 2.0 && n <= 65536.0))
        host->fail(in, "a height_field needs 2 to 65536 points a side");
    return n >= 2.0 && n <= 65536.0 ? (uint32_t)n : 2;
}

/* Those from column x on. */
static void read_values(const height_field *f, const pov_function *of, double *memory, uint32_t x, uint32_t z, uint16_t *out)
{
    const uint32_t n = f->wide - x < POV_VALUES ? f->wide - x : POV_VALUES;
    double at[3][POV_VALUES], values[POV_VALUES];

    for (uint32_t i = 0; i < POV_VALUES; i++) {
        at[0][i] = (x + i) / (f->wide - 1.0);
        at[1][i] = 1.0 - z / (f->deep - 1.0);
        at[2][i] = 0.0;
    }
    of->values(of, at[0], n, memory, values);
    for (uint32_t i = 0; i < n; i++)
        out[i] = (uint16_t)(values[i] > 0.0 ? values[i] < 1.0 ? 65535.0 * values[i] : 65535.0 : 0.0);
}

/* As if it were an image of 16 bits, whose rows come from the top. */
static void read_function(height_field *f, const pov_host *host, pov_reader *in)
{
    const pov_function *of;
    double *memory;
    uint16_t *out;

    f->wide = read_count(host, in);
    host->accept(in, ",");
    f->deep = read_count(host, in);
    of = host->function(in, 3);
    memory = of ? host->alloc(in, of->memory_many * sizeof *memory) : NULL;
    out = memory ? room(f, host, in) : NULL;
    for (uint32_t z = 0; out && z < f->deep; z++)
        for (uint32_t x = 0; x < f->wide; x += POV_VALUES)
            read_values(f, of, memory, x, z, out + (size_t)z * f->wide + x);
    f->height = out;
}

static double height_at(const height_field *f, uint32_t x, uint32_t z) { return f->height[(size_t)z * f->wide + x] * 0x1p-16; }

static void find_range(height_field *f)
{
    uint16_t low = f->height[0], high = low;

    for (size_t i = 1; i < (size_t)f->wide * f->deep; i++) {
        low = f->height[i] < low ? f->height[i] : low;
        high = f->height[i] > high ? f->height[i] : high;
    }
    f->low = fmax(low * 0x1p-16, f->water);
    f->high = high * 0x1p-16;
}

static const double *make_places(uint32_t count, const pov_host *host, pov_reader *in)
{
    double *at = host->alloc(in, count * sizeof *at);

    for (uint32_t i = 0; at && i < count; i++)
        at[i] = i / (count - 1.0);
    return at;
}

static const pov_vec3 centre = { 0.5, 0.5, 0.5 };

static void make_cells(height_field *f, const pov_host *host, pov_reader *in)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };

    f->column = make_places(f->wide, host, in);
    f->row = make_places(f->deep, host, in);
    if (!f->column || !f->row || !common_relief_make(&f->relief, host, in, f->height, f->wide, f->deep, 65536.0 * f->water))
        return;
    find_range(f);
    f->boxed.anchor = pov_two3_of(centre, zero);
    f->boxed.scale = 1.0;
    f->boxed.lo = pov_vec3_of(-0.5, f->low - 0.5, -0.5);
    f->boxed.hi = pov_vec3_of(0.5, f->high - 0.5, 0.5);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    height_field *f = self;
    bool read = true;

    if (host->accept(in, "function"))
        read_function(f, host, in);
    else
        read_image(f, host, in);
    while (read) {
        read = false;
        if (host->accept(in, "smooth")) {
            f->smooth = !host->more(in) || host->boolean(in);
            read = true;
        } else if (host->accept(in, "water_level")) {
            f->water = host->number(in);
            read = true;
        } else if (host->accept(in, "hierarchy")) {
            read = !host->more(in) || (host->boolean(in), true);
        }
    }
    if (f->height && (f->wide < 2 || f->deep < 2))
        host->fail(in, "a height_field needs 2 points a side at least");
    else if (f->height)
        make_cells(f, host, in);
    if (f->relief.levels && f->smooth) {
        f->steeps.wide = f->wide;
        f->steeps.deep = f->deep;
        f->steeps.height = f->height;
        common_steeps_make(&f->steeps, host, in);
    }
}

static bool bounds(const void *self, pov_box *out)
{
    const height_field *f = self;

    out->lo = pov_vec3_of(0.0, fmin(f->low, f->high), 0.0);
    out->hi = pov_vec3_of(1.0, f->high, 1.0);
    return true;
}

/* ---- along a ray ---- */

typedef struct walk {
    const height_field *f;
    const pov_ray *ray;
    pov_hits *hits;
    common_triangle_ray through;   /* its view is made when it is asked for */
    double base;                 /* where distances are counted from */
    pov_vec3 at, by;             /* where the ray is there and how it goes on, in cells and 1/65536 */
    double off, most;            /* how much a height over a plane may be off, by far, infinite if all is to be exact; of a cell and its way */
    bool from_here, seen;
} walk;

static pov_vec3 corner(const height_field *f, uint32_t x, uint32_t z)
{
    return pov_vec3_of(f->column[x], height_at(f, x, z), f->row[z]);
}

static bool is_dry(const height_field *f, const walk *w, double t)
{
    return f->water <= 0.0 || pov_two_add(pov_two_sum(w->ray->org.y, w->ray->org_lo.y), pov_two_product(t, w->ray->dir.y)).hi >= f->water;
}

/* One of the two triangles of a cell, which the line of the ray passes through. False: nothing more is wanted. */
static bool cross_face(walk *w, uint32_t feature, const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c)
{
    pov_mark mark = { feature, 0, 0.0, 0.0 };

    if (w->from_here && w->ray->origin_mark.feature == feature)
        return true;
    if (w->f->water > 0.0) {
        pov_hits one = *w->hits;
        pov_crossing at;

        one.want = POV_WANT_NEAREST;
        one.count = 0;
        one.at = &at;
        common_triangle_cross(&w->through, a, b, c, mark, &one);
        if (one.count == 0 || !is_dry(w->f, w, at.t))
            return true;
    }
    return common_triangle_cross(&w->through, a, b, c, mark, w->hits);
}

/* Does the line of the ray pass through a triangle? */
typedef enum verdict { BESIDE, THROUGH, OPEN } verdict;

/* In double: at t the ray is `above` + t `rise` over the triangle's plane, and at u + t du, v + t dv in it; its sides are u = 0, v = 0
 * and u + v = 1. Where the ray crosses the plane these are, times `rise`, the three numbers below: it passes on one side of all edges
 * or on different ones. */
static inline verdict judge_face(double above, double rise, double u, double v, double du, double dv, double off)
{
    const double p = u * rise - above * du, q = v * rise - above * dv, r = rise - p - q;
    const double least = p < q ? p < r ? p : r : q < r ? q : r, most = p > q ? p > r ? p : r : q > r ? q : r;

    return least < -off && most > off ? BESIDE : least > off || most < -off ? THROUGH : OPEN;
}

static bool cross_faces(walk *w, uint32_t x, uint32_t z, verdict low, verdict high)
{
    const height_field *f = w->f;
    const pov_vec3 a = corner(f, x, z), b = corner(f, x + 1, z), c = corner(f, x, z + 1), d = corner(f, x + 1, z + 1);
    const uint32_t feature = 2 * (z * (f->wide - 1) + x);

    if (low == OPEN || high == OPEN) {
        common_triangle_ray *r = &w->through;
        common_seen p, q;

        if (!w->seen)
            common_triangle_look(r, w->hits->always_exact);
        w->seen = true;
        p = common_triangle_see(r, &b);
        q = common_triangle_see(r, &c);
        low = common_triangle_is_passed(r, &a, common_triangle_see(r, &a), &b, p, &c, q) ? THROUGH : BESIDE;
        high = common_triangle_is_passed(r, &b, p, &d, common_triangle_see(r, &d), &c, q) ? THROUGH : BESIDE;
    }
    return (low == BESIDE || cross_face(w, feature, &a, &b, &c)) && (high == BESIDE || cross_face(w, feature + 1, &b, &d, &c));
}

static bool visit_cell(void *user, uint32_t x, uint32_t z)
{
    walk *w = user;
    const uint16_t *h = w->f->height + (size_t)z * w->f->wide + x, *g = h + w->f->wide;
    const double a = h[0], b = h[1], c = g[0], d = g[1], u = w->at.x - x, v = w->at.z - z, du = w->by.x, dv = w->by.z, p = 1.0 - u, q = 1.0 - v;
    const double off = w->off * (w->most + fabs(u) + fabs(v));
    const verdict low = judge_face(w->at.y - a - u * (b - a) - v * (c - a), w->by.y - du * (b - a) - dv * (c - a), u, v, du, dv, off);
    const verdict high = judge_face(w->at.y - d - p * (c - d) - q * (b - d), w->by.y + du * (c - d) + dv * (b - d), p, q, -du, -dv, off);
    const double before = w->hits->tmax;

    if (low == BESIDE && high == BESIDE)
        return true;
    if (!cross_faces(w, x, z, low, high))
        return false;
    /* What comes behind a crossing well within the cell is farther. */
    return w->hits->want != POV_WANT_NEAREST || w->hits->tmax == before || low == OPEN || high == OPEN;
}

/* Where the interval ends. */
static double end_of(const walk *w)
{
    const pov_hits *h = w->hits;
    const double most = h->tmax * w->through.about.per_unit * (1.0 + 0x1p-40);

    return most - w->base + 0x1p-40 * (1.0 + fabs(w->base));
}

static pov_vec3 in_steps(const height_field *f, pov_vec3 v) { return pov_vec3_of(v.x * (f->wide - 1.0), v.y * 0x1p16, v.z * (f->deep - 1.0)); }

static void cross(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits)
{
    const height_field *f = self;
    pov_vec3 o;
    walk w;

    if (!f->relief.levels)
        return;
    w.f = f;
    w.ray = ray;
    w.hits = hits;
    w.through.about = e->k;
    w.base = fmax(e->span.lo, 0.0);
    w.from_here = ray->origin_surface == hits->owner;
    w.seen = false;
    common_triangle_place(&w.through, ray, centre, 1.0);
    o = pov_add(common_along(&e->k, w.base), centre);
    w.at = in_steps(f, o);
    w.by = in_steps(f, e->k.d);
    w.off = hits->always_exact || !(pov_largest(pov_two3_hi(e->k.f)) < COMMON_FAR) ? HUGE_VAL : 0x1p-10 * (1.0 + pov_largest(o));
    w.most = 2.0 + fabs(w.by.x) + fabs(w.by.z);
    common_relief_search(&f->relief, o, e->k.d, fmin(e->span.hi - w.base, end_of(&w)), visit_cell, &w);
    hits->escalated += w.through.view.escalated;
}

COMMON_BOXED_CLASS(height_field, cross)

/* ---- points ---- */

/* The cell of a point, and where it is in it. */
static void cell_of(const height_field *f, pov_vec3 p, uint32_t *x, uint32_t *z, double *u, double *v)
{
    const double across = fmin(fmax(p.x * (f->wide - 1.0), 0.0), f->wide - 1.0), along = fmin(fmax(p.z * (f->deep - 1.0), 0.0), f->deep - 1.0);

    *x = (uint32_t)across < f->wide - 2 ? (uint32_t)across : f->wide - 2;
    *z = (uint32_t)along < f->deep - 2 ? (uint32_t)along : f->deep - 2;
    *u = across - *x;
    *v = along - *z;
}

static double blend(double at, double by_u, double by_v, double u, double v) { return at + u * (by_u - at) + v * (by_v - at); }

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const height_field *f = self;
    const pov_vec3 p = pov_add(point, point_lo);
    double u, v, height;
    uint32_t x, z;

    if (!f->height || !(p.x >= 0.0 && p.x <= 1.0 && p.z >= 0.0 && p.z <= 1.0))
        return false;
    cell_of(f, p, &x, &z, &u, &v);
    height = u + v <= 1.0 ? blend(height_at(f, x, z), height_at(f, x + 1, z), height_at(f, x, z + 1), u, v)
                          : blend(height_at(f, x + 1, z + 1), height_at(f, x, z + 1), height_at(f, x + 1, z), 1.0 - u, 1.0 - v);
    return p.y < fmax(height, f->water);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const height_field *f = self;
    const uint32_t cell = at->mark.feature / 2, x = cell % (f->wide - 1), z = cell / (f->wide - 1);
    const pov_vec3 b = corner(f, x + 1, z), c = corner(f, x, z + 1);
    const pov_vec3 a = at->mark.feature % 2 == 0 ? corner(f, x, z) : corner(f, x + 1, z + 1);

    (void)ray;
    *out = pov_unit(pov_cross_product(pov_sub(b, a), pov_sub(c, a)));
    if (out->y < 0.0)
        *out = pov_scale(*out, -1.0);
}

/* What light sees of a smooth one. */
static uint32_t shading_normals(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark, pov_vec3 *normals,
                                double *share)
{
    const height_field *f = self;
    double u, v;
    uint32_t x, z;

    (void)mark;
    if (!f->smooth)
        return 0;
    cell_of(f, pov_add(point, point_lo), &x, &z, &u, &v);
    common_steeps_of_cell(&f->steeps, x, z, normals);
    for (uint32_t i = 0; i < 4; i++)
        share[i] = (i % 2 ? u : 1.0 - u) * (i / 2 ? v : 1.0 - v);
    return 4;
}

static bool open(const void *self)
{
    (void)self;
    return true;
}

static const pov_shape_class height_field_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_ENDLESS,
    .keyword = "height_field",
    .instance_size = sizeof(height_field),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .open = open,
    .shading_normals = shading_normals,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &height_field_class, NULL };

POV_PLUGIN(height_field) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "height_field",
    .version = "1",
    .shapes = shapes,
};
