/* height_field { image | function W, H { f } [smooth] [water_level w] }: heights over the unit square, in cells of two triangles.
 *
 * Rays walk over the grid from cell to cell; levels of minima and maxima let them pass many cells at once. Edges are those
 * of common/triangle.h: no ray slips between two triangles. What is below the water level is left out. Inside is below the
 * surface or the water, down without end. */
#include "common/clip.h"
#include "common/triangle.h"

enum { LEVELS = 16 };

/* The least and greatest height of squares of 2^level cells. */
typedef struct level { uint32_t wide, deep; const float *lo, *hi; } level;

typedef struct height_field {
    uint32_t wide, deep;         /* corners along x and z */
    const float *height;         /* rows from z = 0 */
    uint32_t levels;
    const level *level;          /* level[0]: cells */
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

/* Of cells: their four corners. */
static bool make_cells(const height_field *f, const pov_host *host, pov_reader *in, level *out)
{
    float *lo, *hi;

    out->wide = f->wide - 1;
    out->deep = f->deep - 1;
    out->lo = lo = room(host, in, out->wide, out->deep);
    out->hi = hi = room(host, in, out->wide, out->deep);
    for (uint32_t z = 0; lo && hi && z < out->deep; z++)
        for (uint32_t x = 0; x < out->wide; x++) {
            const float *c = f->height + (size_t)z * f->wide + x, *d = c + f->wide;
            const size_t i = (size_t)z * out->wide + x;

            lo[i] = fminf(fminf(c[0], c[1]), fminf(d[0], d[1]));
            hi[i] = fmaxf(fmaxf(c[0], c[1]), fmaxf(d[0], d[1]));
        }
    return lo && hi;
}

static bool make_level(const level *below, const pov_host *host, pov_reader *in, level *out)
{
    float *lo, *hi;

    out->wide = (below->wide + 1) / 2;
    out->deep = (below->deep + 1) / 2;
    out->lo = lo = room(host, in, out->wide, out->deep);
    out->hi = hi = room(host, in, out->wide, out->deep);
    for (uint32_t z = 0; lo && hi && z < below->deep; z++)
        for (uint32_t x = 0; x < below->wide; x++) {
            const size_t from = (size_t)z * below->wide + x, to = (size_t)(z / 2) * out->wide + x / 2;
            const bool is_first = x % 2 == 0 && z % 2 == 0;

            lo[to] = is_first ? below->lo[from] : fminf(lo[to], below->lo[from]);
            hi[to] = is_first ? below->hi[from] : fmaxf(hi[to], below->hi[from]);
        }
    return lo && hi;
}

static void make_levels(height_field *f, const pov_host *host, pov_reader *in)
{
    level *at = host->alloc(in, (LEVELS + 1) * sizeof *at);
    uint32_t n = 0;

    if (!at || !make_cells(f, host, in, &at[0]))
        return;
    while (n < LEVELS && (at[n].wide > 1 || at[n].deep > 1)) {
        if (!make_level(&at[n], host, in, &at[n + 1]))
            return;
        n++;
    }
    f->level = at;
    f->levels = n + 1;
    f->low = fmaxf(at[n].lo[0], (float)f->water);
    f->high = at[n].hi[0];
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
    common_triangle_ray through;
    pov_vec3 o, d, inverse;      /* from where it comes near, at the distance `base` */
    double base, cell_x, cell_z;   /* sizes of a cell */
    double off_x, off_z;         /* how much a position may be off along the ray */
    bool from_here;
} walk;

/* Corners are rounded once, alike for each face that has them. */
static pov_vec3 corner(const height_field *f, uint32_t x, uint32_t z)
{
    return pov_vec3_of(x / (f->wide - 1.0), f->height[(size_t)z * f->wide + x], z / (f->deep - 1.0));
}

static bool is_dry(const height_field *f, const walk *w, double t)
{
    return f->water <= 0.0 || pov_two_add(pov_two_sum(w->ray->org.y, w->ray->org_lo.y), pov_two_product(t, w->ray->dir.y)).hi >= f->water;
}

/* One of the two triangles of a cell. */
static bool cross_face(walk *w, uint32_t feature, const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c)
{
    pov_mark mark = { feature, 0, 0.0, 0.0 };
    pov_crossing at;
    pov_hits one = *w->hits;

    if ((w->from_here && w->ray->origin_mark.feature == feature) || !common_triangle_is_hit(&w->through, a, b, c))
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

    return cross_face(w, feature, &a, &b, &c) && cross_face(w, feature + 1, &b, &d, &c);
}

/* What a position may be off, in the unit square: far more than roundings. */
static const double margin = 0x1p-30;

/* Keep of a stretch what is between the least and the greatest height of a square. */
static inline bool reaches(const walk *w, const level *l, uint32_t x, uint32_t z, common_span *s)
{
    const double low = l->lo[(size_t)z * l->wide + x], high = l->hi[(size_t)z * l->wide + x];

    common_clip_inverse(s, w->o.y, w->inverse.y, low > w->f->water ? low : w->f->water, high, margin);
    return s->lo <= s->hi;
}

/* Where the ray crosses from one half of a square to the other: on the near side before `near`, on the far side behind
 * `far`. Too near the line between them for a whole ray, it is on both sides everywhere. */
typedef struct halves { double near, far; } halves;

static inline halves halve(double from, double inverse, double off, double middle)
{
    const double gap = middle - from;
    const halves both = { HUGE_VAL, -HUGE_VAL }, cut = { gap * inverse + off, gap * inverse - off };
    const halves along = { gap * inverse, gap * inverse };

    return !(fabs(gap) > margin) ? both : off < HUGE_VAL ? cut : along;
}

/* Of a square whose heights the stretch reaches. False: nothing more is wanted. The nearer children come first. */
static bool descend(walk *w, uint32_t n, uint32_t x, uint32_t z, common_span span)
{
    const level *below = w->f->level + n - 1;
    const uint32_t flip_x = w->d.x < 0.0, flip_z = w->d.z < 0.0;
    double half;
    halves by_x, by_z;

    if (n == 0)
        return cross_cell(w, x, z);
    if (w->hits->want == POV_WANT_NEAREST && w->hits->count > 0 && (w->base + span.lo - 0x1p-20) * w->through.about.unit > w->hits->tmax)
        return true;
    half = (double)((uint64_t)1 << (n - 1));
    by_x = halve(w->o.x, w->inverse.x, w->off_x, (2 * x + 1) * half * w->cell_x);
    by_z = halve(w->o.z, w->inverse.z, w->off_z, (2 * z + 1) * half * w->cell_z);
    for (uint32_t i = 0; i < 4; i++) {
        const uint32_t u = 2 * x + ((i & 1) ^ flip_x), v = 2 * z + ((i >> 1) ^ flip_z);
        const double from_x = i & 1 ? by_x.far : -HUGE_VAL, from_z = i & 2 ? by_z.far : -HUGE_VAL;
        const double to_x = i & 1 ? HUGE_VAL : by_x.near, to_z = i & 2 ? HUGE_VAL : by_z.near;
        common_span part = span;

        common_clip_between(&part, from_x, to_x);
        common_clip_between(&part, from_z, to_z);
        if (part.lo <= part.hi && u < below->wide && v < below->deep && reaches(w, below, u, v, &part) && !descend(w, n - 1, u, v, part))
            return false;
    }
    return true;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const height_field *f = self;
    const pov_vec3 middle = { 0.5, 0.5, 0.5 };
    common_span span = { -HUGE_VAL, HUGE_VAL };
    common_ray k;
    double base;
    walk w;

    if (!f->level)
        return;
    k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    if (!common_clip(&k, pov_vec3_of(0.0, f->low, 0.0), pov_vec3_of(1.0, f->high, 1.0), &span) || span.hi < 0.0)
        return;
    base = fmax(span.lo, 0.0);
    w.f = f;
    w.ray = ray;
    w.hits = hits;
    w.from_here = ray->origin_surface == hits->owner;
    w.o = common_along(&k, base);
    w.d = k.d;
    w.inverse = pov_vec3_of(1.0 / (k.d.x + 0.0), 1.0 / (k.d.y + 0.0), 1.0 / (k.d.z + 0.0));   /* of -0 as of 0 */
    w.off_x = margin * fabs(w.inverse.x);
    w.off_z = margin * fabs(w.inverse.z);
    w.cell_x = 1.0 / (f->wide - 1.0);
    w.cell_z = 1.0 / (f->deep - 1.0);
    w.base = base;
    common_triangle_enter(&w.through, ray, middle, 1.0, hits->always_exact);
    span.lo = -0x1p-30;
    span.hi -= base;
    if (reaches(&w, &f->level[f->levels - 1], 0, 0, &span))
        descend(&w, f->levels - 1, 0, 0, span);
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

/* In POV-Ray's own units: cells, and the 65536 steps of heights. There means of unit normals lean to the flatter ones. */
static pov_vec3 step_normal(const height_field *f, uint32_t x, uint32_t z, uint32_t u, uint32_t v)
{
    const float *h = f->height;
    const double at = h[(size_t)z * f->wide + x], by_x = h[(size_t)z * f->wide + u] - at, by_z = h[(size_t)v * f->wide + x] - at;

    return pov_unit(pov_vec3_of(u > x ? -65536.0 * by_x : 65536.0 * by_x, 1.0, v > z ? -65536.0 * by_z : 65536.0 * by_z));
}

/* The mean of the normals between a corner and two of its neighbours, one along x, one along z. POV-Ray keeps it in 16 bits a
 * component, which steep corners show. */
static pov_vec3 corner_normal(const height_field *f, uint32_t x, uint32_t z)
{
    pov_vec3 sum = { 0.0, 0.0, 0.0 };

    for (int i = 0; i < 4; i++) {
        const uint32_t u = i & 1 ? x + 1 : x - 1, v = i & 2 ? z + 1 : z - 1;   /* below 0 is beyond all */

        if (u < f->wide && v < f->deep)
            sum = pov_add(sum, step_normal(f, x, z, u, v));
    }
    sum = pov_scale(pov_unit(sum), 32767.0);
    return pov_unit(pov_vec3_of(trunc(sum.x) * (f->wide - 1.0), trunc(sum.y) * 65536.0, trunc(sum.z) * (f->deep - 1.0)));
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
