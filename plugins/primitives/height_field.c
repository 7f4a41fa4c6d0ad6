/* height_field { image | function W, H { f } [smooth] [water_level w] }: heights over the unit square, in cells of two triangles.
 *
 * Rays walk over squares of many cells and then over the cells of those whose least and greatest heights they reach. Edges are those
 * of common/triangle.h: no ray slips between two triangles. What is below the water level is left out. Inside is below the
 * surface or the water, down without end. */
#include "common/clip.h"
#include "common/triangle.h"

enum { SIDE_BITS = 4, SIDE = 1 << SIDE_BITS, LEVELS = 16 / SIDE_BITS };

/* The least and greatest height above the water of squares of SIDE^level cells. */
typedef struct level { uint32_t wide, deep; const float *lo, *hi; } level;

/* The normal at a corner, as POV-Ray keeps it. */
typedef struct steep { int16_t x, y, z; } steep;
/* More corners than rays will see are not worth keeping. */
enum { STEEPS_MOST = 1 << 20 };

typedef struct height_field {
    uint32_t wide, deep;         /* corners along x and z */
    const float *height;         /* rows from z = 0 */
    uint32_t levels;             /* the last one has at most SIDE squares a side */
    const level *level;          /* level[0]: cells */
    const steep *steeps;         /* of a smooth one; NULL: there are too many */
    double water;
    bool smooth;
    float low, high;
} height_field;

/* ---- loading ---- */

static void *room(const pov_host *host, pov_reader *in, uint32_t wide, uint32_t deep)
{
    return host->alloc(in, (size_t)wide * deep * sizeof(float));
}

static void read_image(height_field *f, const pov_host *host, pov_reader *in)
{
    const uint16_t *at = host->heights(in, &f->wide, &f->deep);
    float *out = at ? room(host, in, f->wide, f->deep) : NULL;

    for (uint32_t z = 0; out && z < f->deep; z++)
        for (uint32_t x = 0; x < f->wide; x++)
            out[(size_t)z * f->wide + x] = (float)at[(size_t)(f->deep - 1 - z) * f->wide + x] * 0x1p-16f;
    f->height = out;
}

static uint32_t read_count(const pov_host *host, pov_reader *in)
{
    const double n = host->number(in);

    if (!(n >= 2.0 && n <= 65536.0))
        host->fail(in, "a height_field needs 2 to 65536 points a side");
    return n >= 2.0 && n <= 65536.0 ? (uint32_t)n : 2;
}

/* As if it were an image of 16 bits, whose rows come from the top. */
static void read_function(height_field *f, const pov_host *host, pov_reader *in)
{
    const pov_function *of;
    double *memory;
    float *out;

    f->wide = read_count(host, in);
    host->accept(in, ",");
    f->deep = read_count(host, in);
    of = host->function(in, 3);
    memory = of ? host->alloc(in, of->memory * sizeof *memory) : NULL;
    out = memory ? room(host, in, f->wide, f->deep) : NULL;
    for (uint32_t z = 0; out && z < f->deep; z++)
        for (uint32_t x = 0; x < f->wide; x++) {
            const double at[3] = { x / (f->wide - 1.0), 1.0 - z / (f->deep - 1.0), 0.0 };
            const double value = of->value(of, at, memory);

            out[(size_t)z * f->wide + x] = (float)(value > 0.0 ? value < 1.0 ? floor(65535.0 * value) * 0x1p-16 : 65535.0 / 65536.0 : 0.0);
        }
    f->height = out;
}

/* What is under water is where no ray comes. */
static const float nowhere = 1e30f;

/* Of cells: their four corners. */
static bool make_cells(const height_field *f, const pov_host *host, pov_reader *in, level *out)
{
    const float water = (float)f->water;
    float *lo, *hi;

    out->wide = f->wide - 1;
    out->deep = f->deep - 1;
    out->lo = lo = room(host, in, out->wide, out->deep);
    out->hi = hi = room(host, in, out->wide, out->deep);
    for (uint32_t z = 0; lo && hi && z < out->deep; z++)
        for (uint32_t x = 0; x < out->wide; x++) {
            const float *c = f->height + (size_t)z * f->wide + x, *d = c + f->wide;
            const size_t i = (size_t)z * out->wide + x;
            const float least = fminf(fminf(c[0], c[1]), fminf(d[0], d[1])), most = fmaxf(fmaxf(c[0], c[1]), fmaxf(d[0], d[1]));

            lo[i] = most < water ? nowhere : least;
            hi[i] = most < water ? -nowhere : most;
        }
    return lo && hi;
}

static bool make_level(const level *below, const pov_host *host, pov_reader *in, level *out)
{
    float *lo, *hi;

    out->wide = (below->wide + SIDE - 1) / SIDE;
    out->deep = (below->deep + SIDE - 1) / SIDE;
    out->lo = lo = room(host, in, out->wide, out->deep);
    out->hi = hi = room(host, in, out->wide, out->deep);
    for (uint32_t z = 0; lo && hi && z < below->deep; z++)
        for (uint32_t x = 0; x < below->wide; x++) {
            const size_t from = (size_t)z * below->wide + x, to = (size_t)(z / SIDE) * out->wide + x / SIDE;
            const bool is_first = x % SIDE == 0 && z % SIDE == 0;

            lo[to] = is_first ? below->lo[from] : fminf(lo[to], below->lo[from]);
            hi[to] = is_first ? below->hi[from] : fmaxf(hi[to], below->hi[from]);
        }
    return lo && hi;
}

static void make_levels(height_field *f, const pov_host *host, pov_reader *in)
{
    level *at = host->alloc(in, LEVELS * sizeof *at);
    uint32_t n = 0;

    if (!at || !make_cells(f, host, in, &at[0]))
        return;
    for (; n + 1 < LEVELS && (at[n].wide > SIDE || at[n].deep > SIDE); n++)
        if (!make_level(&at[n], host, in, &at[n + 1]))
            return;
    f->level = at;
    f->levels = n + 1;
    f->low = f->high = f->height[0];
    for (size_t i = 1; i < (size_t)f->wide * f->deep; i++) {
        f->low = fminf(f->low, f->height[i]);
        f->high = fmaxf(f->high, f->height[i]);
    }
    f->low = fmaxf(f->low, (float)f->water);
}

/* In POV-Ray's own units: cells, and the 65536 steps of heights. There means of unit normals lean to the flatter ones. */
static pov_vec3 step_normal(const height_field *f, uint32_t x, uint32_t z, uint32_t u, uint32_t v)
{
    const float *h = f->height;
    const double at = h[(size_t)z * f->wide + x], by_x = h[(size_t)z * f->wide + u] - at, by_z = h[(size_t)v * f->wide + x] - at;

    return pov_unit(pov_vec3_of(u > x ? -65536.0 * by_x : 65536.0 * by_x, 1.0, v > z ? -65536.0 * by_z : 65536.0 * by_z));
}

/* The mean of the normals between a corner and two of its neighbours, one along x, one along z. POV-Ray keeps it in 16 bits a
 * component, which steep corners show. */
static steep find_steep(const height_field *f, uint32_t x, uint32_t z)
{
    pov_vec3 sum = { 0.0, 0.0, 0.0 };
    steep out;

    for (int i = 0; i < 4; i++) {
        const uint32_t u = i & 1 ? x + 1 : x - 1, v = i & 2 ? z + 1 : z - 1;   /* below 0 is beyond all */

        if (u < f->wide && v < f->deep)
            sum = pov_add(sum, step_normal(f, x, z, u, v));
    }
    sum = pov_scale(pov_unit(sum), 32767.0);
    out.x = (int16_t)sum.x;
    out.y = (int16_t)sum.y;
    out.z = (int16_t)sum.z;
    return out;
}

static void make_steeps(height_field *f, const pov_host *host, pov_reader *in)
{
    const size_t count = (size_t)f->wide * f->deep;
    steep *at = count <= STEEPS_MOST ? host->alloc(in, count * sizeof *at) : NULL;

    for (uint32_t z = 0; at && z < f->deep; z++)
        for (uint32_t x = 0; x < f->wide; x++)
            at[(size_t)z * f->wide + x] = find_steep(f, x, z);
    f->steeps = at;
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
        make_levels(f, host, in);
    if (f->level && f->smooth)
        make_steeps(f, host, in);
}

static bool bounds(const void *self, pov_box *out)
{
    const height_field *f = self;

    out->lo = pov_vec3_of(0.0, fmin(f->low, f->high), 0.0);
    out->hi = pov_vec3_of(1.0, f->high, 1.0);
    return true;
}

/* ---- along a ray ---- */

/* One coordinate: from where the ray comes near, and its direction; sizes of squares and their inverses by level. */
typedef struct track { double o, d, size[LEVELS], per_size[LEVELS]; } track;

/* Columns of squares lie one behind the other along the axis of which the ray passes more cells; rows along the other one. */
typedef struct walk {
    const height_field *f;
    const pov_ray *ray;
    pov_hits *hits;
    common_triangle_ray through;   /* made for the first cell */
    track column, row, height;
    double inverse, inverse_height;   /* of the columns' direction, and of that of heights */
    double off, row_off, height_off;   /* how much a distance may be off, and a place for that */
    double base, unit;           /* where it comes near */
    bool by_x;                   /* columns lie along x */
    bool from_here, entered;
} walk;

static const pov_vec3 centre = { 0.5, 0.5, 0.5 };

/* Corners are rounded once, alike for each face that has them. */
static pov_vec3 corner(const height_field *f, uint32_t x, uint32_t z)
{
    return pov_vec3_of(x / (f->wide - 1.0), f->height[(size_t)z * f->wide + x], z / (f->deep - 1.0));
}

static bool is_dry(const height_field *f, const walk *w, double t)
{
    return f->water <= 0.0 || pov_two_add(pov_two_sum(w->ray->org.y, w->ray->org_lo.y), pov_two_product(t, w->ray->dir.y)).hi >= f->water;
}

/* One of the two triangles of a cell: its corners, and as the ray sees them. */
static bool cross_face(walk *w, uint32_t feature, const pov_vec3 *a, common_seen p, const pov_vec3 *b, common_seen q, const pov_vec3 *c,
                       common_seen s)
{
    pov_mark mark = { feature, 0, 0.0, 0.0 };
    pov_crossing at;
    pov_hits one = *w->hits;

    if ((w->from_here && w->ray->origin_mark.feature == feature) || !common_triangle_is_passed(&w->through, a, p, b, q, c, s))
        return true;
    if (w->f->water > 0.0) {
        one.want = POV_WANT_NEAREST;
        one.count = 0;
        one.at = &at;
        common_triangle_cross(&w->through, a, b, c, mark, &one);
        if (one.count == 0 || !is_dry(w->f, w, at.t))
            return true;
    }
    return common_triangle_cross(&w->through, a, b, c, mark, w->hits);
}

static bool cross_cell(walk *w, uint32_t x, uint32_t z)
{
    const height_field *f = w->f;
    const pov_vec3 a = corner(f, x, z), b = corner(f, x + 1, z), c = corner(f, x, z + 1), d = corner(f, x + 1, z + 1);
    const uint32_t feature = 2 * (z * (f->wide - 1) + x);
    common_seen seen[4];

    if (!w->entered)
        common_triangle_enter(&w->through, w->ray, centre, 1.0, w->hits->always_exact);
    w->entered = true;
    seen[0] = common_triangle_see(&w->through, &a);
    seen[1] = common_triangle_see(&w->through, &b);
    seen[2] = common_triangle_see(&w->through, &c);
    seen[3] = common_triangle_see(&w->through, &d);
    return common_triangle_are_beside(&w->through, seen) || (cross_face(w, feature, &a, seen[0], &b, seen[1], &c, seen[2]) &&
                                                           cross_face(w, feature + 1, &b, seen[1], &d, seen[3], &c, seen[2]));
}

/* What a position may be off, in the unit square: far more than roundings. */
static const double margin = 0x1p-30;

/* Squares from `first` to `last`. */
typedef struct some { uint32_t first, last; } some;

static inline some at_most(some s, uint32_t count)
{
    const some some_of = { s.first, s.last < count ? s.last : count - 1 };

    return some_of;
}

static inline uint32_t square_of(double at, double per_size, some within)
{
    const double n = at * per_size;

    return !(n > within.first) ? within.first : n < within.last ? (uint32_t)n : within.last;
}

/* Those between two places, and as much beside them. */
static inline some between(const track *a, uint32_t n, double p, double q, double beside, some within)
{
    const some both = { square_of((p < q ? p : q) - beside, a->per_size[n], within), square_of((p < q ? q : p) + beside, a->per_size[n], within) };

    return both;
}

static inline double at(const track *a, double t) { return a->o + a->d * t; }

static bool walk_squares(walk *w, uint32_t n, some columns, some rows, const common_span *s);

/* A square that the stretch reaches: those in it, where the stretch is between its least and its greatest height. */
static bool enter_square(walk *w, uint32_t n, uint32_t i, uint32_t j, const common_span *s)
{
    const some columns = { SIDE * i, SIDE * i + SIDE - 1 }, rows = { SIDE * j, SIDE * j + SIDE - 1 };
    const uint32_t x = w->by_x ? i : j, z = w->by_x ? j : i;
    const level *l = &w->f->level[n];
    common_span part = *s;

    if (n == 0)
        return cross_cell(w, x, z);
    common_clip_inverse(&part, w->height.o, w->inverse_height, l->lo[(size_t)z * l->wide + x], l->hi[(size_t)z * l->wide + x], margin);
    return !(part.lo <= part.hi) || walk_squares(w, n - 1, columns, rows, &part);
}

/* Squares of a column, and heights there. False: nothing more is wanted. */
static inline bool walk_column(walk *w, uint32_t n, uint32_t i, some rows, double low, double high, double from, double to)
{
    const level *l = &w->f->level[n];
    const size_t across = w->by_x ? l->wide : 1, along = w->by_x ? 1 : l->wide;
    const common_span part = { from - w->off, to + w->off };

    for (uint32_t j = rows.first; j <= rows.last; j++)
        if (l->lo[i * along + j * across] <= high && l->hi[i * along + j * across] >= low && !enter_square(w, n, i, j, &part))
            return false;
    return true;
}

/* The nearer columns come first. Where the ray goes from one to the next may be off by a little. */
static bool walk_squares(walk *w, uint32_t n, some columns, some rows, const common_span *s)
{
    const level *l = &w->f->level[n];
    const bool back = w->column.d < 0.0;
    const double size = w->column.size[n], step = size * fabs(w->inverse);
    double t = s->lo, place = at(&w->row, t), height = at(&w->height, t), edge;
    uint32_t i;

    columns = between(&w->column, n, at(&w->column, s->lo), at(&w->column, s->hi), margin, at_most(columns, w->by_x ? l->wide : l->deep));
    rows = at_most(rows, w->by_x ? l->deep : l->wide);
    i = back ? columns.last : columns.first;
    edge = ((back ? i : i + 1) * size - w->column.o) * w->inverse;
    for (uint32_t left = columns.last - columns.first + 1; left > 0; left--, i += back ? UINT32_MAX : 1, edge += step) {
        const double end = left > 1 && edge < s->hi ? edge > t ? edge : t : s->hi;
        const double to = at(&w->row, end), top = at(&w->height, end);

        if (w->hits->want == POV_WANT_NEAREST && w->hits->count > 0 && (w->base + t - w->off - 0x1p-20) * w->unit > w->hits->tmax)
            return true;
        if (!walk_column(w, n, i, between(&w->row, n, place, to, w->row_off, rows), (height < top ? height : top) - w->height_off,
                         (height < top ? top : height) + w->height_off, t, end))
            return false;
        t = end;
        place = to;
        height = top;
    }
    return true;
}

static void set_track(track *a, double o, double d, uint32_t corners, uint32_t levels)
{
    const double cells = corners - 1.0;

    a->o = o;
    a->d = d;
    for (uint32_t n = 0; n < levels; n++) {
        const double side = (double)((uint64_t)1 << SIDE_BITS * n);

        a->size[n] = side / cells;
        a->per_size[n] = cells / side;
    }
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    static const some all = { 0, UINT32_MAX };
    const height_field *f = self;
    common_span span = { -HUGE_VAL, HUGE_VAL };
    common_ray k;
    pov_vec3 o;
    walk w;

    if (!f->level)
        return;
    k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    if (!common_clip(&k, pov_vec3_of(0.0, f->low, 0.0), pov_vec3_of(1.0, f->high, 1.0), &span) || span.hi < 0.0)
        return;
    w.base = fmax(span.lo, 0.0);
    w.f = f;
    w.ray = ray;
    w.hits = hits;
    w.entered = false;
    w.unit = k.unit;
    w.from_here = ray->origin_surface == hits->owner;
    w.by_x = fabs(k.d.x) * (f->wide - 1.0) >= fabs(k.d.z) * (f->deep - 1.0);
    o = common_along(&k, w.base);
    set_track(w.by_x ? &w.column : &w.row, o.x, k.d.x, f->wide, f->levels);
    set_track(w.by_x ? &w.row : &w.column, o.z, k.d.z, f->deep, f->levels);
    w.height.o = o.y;
    w.height.d = k.d.y;
    w.inverse = 1.0 / (w.column.d + 0.0);
    w.inverse_height = 1.0 / (k.d.y + 0.0);   /* of -0 as of 0 */
    w.off = fmin(margin * fabs(w.inverse), 1e30);
    w.row_off = margin + fabs(w.row.d) * w.off;
    w.height_off = margin + fabs(w.height.d) * w.off;
    span.lo = -0x1p-30;
    span.hi -= w.base;
    walk_squares(&w, f->levels - 1, all, all, &span);
}

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

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const height_field *f = self;
    const pov_vec3 p = pov_add(point, point_lo);
    const float *c, *d;
    double u, v, height;
    uint32_t x, z;

    if (!f->height || !(p.x >= 0.0 && p.x <= 1.0 && p.z >= 0.0 && p.z <= 1.0))
        return false;
    cell_of(f, p, &x, &z, &u, &v);
    c = f->height + (size_t)z * f->wide + x;
    d = c + f->wide;
    height = u + v <= 1.0 ? c[0] + u * (c[1] - c[0]) + v * (d[0] - c[0])
                          : d[1] + (1.0 - u) * (d[0] - d[1]) + (1.0 - v) * (c[1] - d[1]);
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

/* ---- what light sees of a smooth one ---- */

static pov_vec3 corner_normal(const height_field *f, uint32_t x, uint32_t z)
{
    const steep s = f->steeps ? f->steeps[(size_t)z * f->wide + x] : find_steep(f, x, z);

    return pov_unit(pov_vec3_of(s.x * (f->wide - 1.0), s.y * 65536.0, s.z * (f->deep - 1.0)));
}

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
    for (uint32_t i = 0; i < 4; i++) {
        normals[i] = corner_normal(f, x + i % 2, z + i / 2);
        share[i] = (i % 2 ? u : 1.0 - u) * (i / 2 ? v : 1.0 - v);
    }
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
};

static const pov_shape_class *const shapes[] = { &height_field_class, NULL };

POV_PLUGIN(height_field) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "height_field",
    .version = "1",
    .shapes = shapes,
};
