/* isosurface { function { f } ... }: where f is the threshold, within a box or a sphere; inside where it is below.
 *
 * Where bounds of f over stretches of a line are known, they find all crossings (common/level.h), in the cells of a grid that
 * may hold some (common/cells.h). Else `max_gradient` bounds how fast f changes, and stretches shorter than `accuracy` are
 * searched no further (common/steps.h). Whatever is inside at the skin of the container is closed by it, unless `open`. */
#include "common/cells.h"
#include "common/clip.h"
#include "common/steps.h"

typedef struct isosurface {
    const pov_function *function;
    double threshold, gradient, accuracy;
    bool sphere, open;
    pov_vec3 lo, hi;             /* the box, or the box of the sphere */
    pov_vec3 centre;
    double radius, size;         /* of the sphere; the largest side of the box */
    const pov_function_bounds *exact;    /* NULL: none are known */
    common_cells cells;
} isosurface;

/* Doubles that a function may need, and registers of its bounds; rays that are asked together. */
enum { SURFACE, SKIN, TOGETHER = 64, SIDES = 6, MEMORY = 2048, REGISTERS = MEMORY * sizeof(double) / sizeof(pov_slope) };

/* ---- loading ---- */

static void read_container(isosurface *s, const pov_host *host, pov_reader *in)
{
    pov_vec3 a, b;

    host->expect(in, "{");
    s->sphere = host->accept(in, "sphere");
    if (!s->sphere)
        host->expect(in, "box");
    host->expect(in, "{");
    host->vector(in, &a);
    host->accept(in, ",");
    if (s->sphere) {
        s->radius = fabs(host->number(in));
        b = pov_add(a, pov_vec3_of(s->radius, s->radius, s->radius));
        s->centre = a;
        a = pov_sub(a, pov_vec3_of(s->radius, s->radius, s->radius));
    } else {
        host->vector(in, &b);
    }
    s->lo = pov_vec3_of(pov_min(a.x, b.x), pov_min(a.y, b.y), pov_min(a.z, b.z));
    s->hi = pov_vec3_of(pov_max(a.x, b.x), pov_max(a.y, b.y), pov_max(a.z, b.z));
    host->expect(in, "}");
    host->expect(in, "}");
}

/* `evaluate` and `max_trace` are of a method that there is not here; the least gradient of the former counts. */
static bool read_other(isosurface *s, const pov_host *host, pov_reader *in)
{
    if (host->accept(in, "evaluate")) {
        s->gradient = pov_max(s->gradient, host->number(in));
        for (int i = 0; i < 2; i++) {
            host->accept(in, ",");
            host->number(in);
        }
    } else if (host->accept(in, "max_trace")) {
        host->number(in);
    } else if (host->accept(in, "open")) {
        s->open = true;
    } else {
        return host->accept(in, "all_intersections");
    }
    return true;
}

static bool read_item(isosurface *s, const pov_host *host, pov_reader *in)
{
    if (host->accept(in, "function"))
        s->function = host->function(in, 3);
    else if (host->accept(in, "contained_by"))
        read_container(s, host, in);
    else if (host->accept(in, "threshold"))
        s->threshold = host->number(in);
    else if (host->accept(in, "accuracy"))
        s->accuracy = host->number(in);
    else if (host->accept(in, "max_gradient"))
        s->gradient = host->number(in);
    else
        return read_other(s, host, in);
    return true;
}

/* Does a box lie outside the container? */
static bool is_outside(const void *self, pov_vec3 middle, pov_vec3 half)
{
    const isosurface *s = self;
    const pov_vec3 from = pov_sub(middle, s->centre);
    const pov_vec3 near = { pov_max(fabs(from.x) - half.x, 0.0), pov_max(fabs(from.y) - half.y, 0.0), pov_max(fabs(from.z) - half.z, 0.0) };

    return s->sphere && pov_dot(near, near) > s->radius * s->radius * (1.0 + 0x1p-20);
}

/* Bounds of the function, and the cells where it may pass the threshold. */
static void find_cells(isosurface *s, const pov_host *host, pov_reader *in)
{
    const pov_box box = { s->lo, s->hi };
    const size_t appended = offsetof(pov_host, function_bounds) + sizeof host->function_bounds;

    s->exact = host->size >= appended && s->function ? host->function_bounds(in, s->function) : NULL;
    if (s->exact && (s->exact->registers > REGISTERS || !(s->size > 0.0)))
        s->exact = NULL;
    if (s->exact)
        common_cells_make(&s->cells, host, in, s->exact, s->threshold, box, is_outside, s);
    else
        host->warn(in, "bounds of this function are not known (it has noise, a pattern or an image, or is too long): "
                       "max_gradient must not be too low");
}

/* Where they are not given. */
static const double ACCURACY = 0x1p-10, GRADIENT = 1.1;

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    isosurface *s = self;

    s->lo = pov_vec3_of(-1.0, -1.0, -1.0);
    s->hi = pov_vec3_of(1.0, 1.0, 1.0);
    s->accuracy = ACCURACY;
    s->gradient = GRADIENT;
    while (read_item(s, host, in))
        continue;
    if (!s->function || s->function->parameters != 3)
        host->fail(in, "an isosurface needs a function of x, y and z");
    else if (s->function->memory > MEMORY)
        host->fail(in, "this function is too large for an isosurface");
    if (!(s->gradient > 0.0) || !(s->accuracy > 0.0))
        host->warn(in, "max_gradient and accuracy must be above 0: what is not is taken as if it were left out");
    s->gradient = s->gradient > 0.0 ? s->gradient : GRADIENT;
    s->accuracy = s->accuracy > 0.0 ? s->accuracy : ACCURACY;
    s->size = pov_largest(pov_sub(s->hi, s->lo));
    /* Doubles tell no more. */
    s->accuracy = pov_max(pov_min(s->accuracy, 0x1p-9 * s->size), 0x1p-46 * s->size);
    find_cells(s, host, in);
}

static bool bounds(const void *self, pov_box *out)
{
    const isosurface *s = self;
    pov_vec3 lo = s->lo, hi = s->hi;

    if (s->exact) {
        lo = pov_vec3_of(pov_max(lo.x, s->cells.from.x), pov_max(lo.y, s->cells.from.y), pov_max(lo.z, s->cells.from.z));
        hi = pov_vec3_of(pov_min(hi.x, s->cells.to.x), pov_min(hi.y, s->cells.to.y), pov_min(hi.z, s->cells.to.z));
        hi = pov_vec3_of(pov_max(lo.x, hi.x), pov_max(lo.y, hi.y), pov_max(lo.z, hi.z));
    }
    out->lo = pov_vec3_of(common_below(lo.x), common_below(lo.y), common_below(lo.z));
    out->hi = pov_vec3_of(common_above(hi.x), common_above(hi.y), common_above(hi.z));
    return true;
}

static size_t scratch(const void *self)
{
    const isosurface *s = self;

    if (s->exact)
        return s->exact->registers * sizeof(pov_form);
    return s->function ? common_steps_memory(s->function) * sizeof(double) : 0;
}

/* `memory`: of scratch(), or MEMORY doubles. */
static double value_at(const isosurface *s, pov_vec3 p, void *memory)
{
    const double at[3] = { p.x, p.y, p.z };

    if (s->exact)
        return common_level_value(s->exact, s->threshold, p, memory);
    return s->function->value(s->function, at, memory) - s->threshold;
}

/* ---- along a ray ---- */

/* Points at o + t d, lengths along d in the units of the function: t times `speed`. */
typedef struct line {
    const isosurface *s;
    pov_vec3 o, d;
    double base, speed, unit;
    void *memory;
    pov_hits *hits;
} line;

/* False: nothing more is wanted. */
static bool report(const line *n, double t, uint32_t feature)
{
    const pov_two at = pov_two_sum(n->base, t);
    const pov_mark mark = { feature, 0, 0.0, 0.0 };
    pov_hits *hits = n->hits;

    return pov_cross(hits, at.hi * n->unit, at.lo * n->unit, mark) && !(hits->want == POV_WANT_NEAREST && at.hi * n->unit > hits->tmin);
}

static bool clip_sphere(const isosurface *s, const common_ray *k, common_span *out)
{
    const pov_vec3 f = pov_sub(pov_two3_hi(k->f), s->centre);
    const double a = pov_dot(k->d, k->d), middle = -pov_dot(f, k->d) / a;
    const pov_vec3 w = pov_add(f, pov_scale(k->d, middle));
    const double rest = s->radius * s->radius - pov_dot(w, w);

    if (!(rest > 0.0))
        return false;
    out->lo = middle - sqrt(rest / a);
    out->hi = middle + sqrt(rest / a);
    return true;
}

/* Along the ray within the container. */
static bool clip(const isosurface *s, const common_ray *k, common_span *span)
{
    if (s->sphere)
        return clip_sphere(s, k, span);
    span->lo = -HUGE_VAL;
    span->hi = HUGE_VAL;
    common_clip_axis(span, k->f.x.hi, k->d.x, s->lo.x, s->hi.x, 0.0);
    common_clip_axis(span, k->f.y.hi, k->d.y, s->lo.y, s->hi.y, 0.0);
    common_clip_axis(span, k->f.z.hi, k->d.z, s->lo.z, s->hi.z, 0.0);
    return span->lo < span->hi;
}

static void values_at(const isosurface *s, const pov_vec3 at[SIDES], double *memory, double v[SIDES])
{
    double places[3 * POV_VALUES];

    if (s->exact || s->function->memory_many > MEMORY) {
        for (int i = 0; i < SIDES; i++)
            v[i] = value_at(s, at[i], memory);
        return;
    }
    for (int i = 0; i < SIDES; i++) {
        places[i] = at[i].x;
        places[POV_VALUES + i] = at[i].y;
        places[2 * POV_VALUES + i] = at[i].z;
    }
    s->function->values(s->function, places, SIDES, memory, v);
    for (int i = 0; i < SIDES; i++)
        v[i] -= s->threshold;
}

static pov_vec3 difference_at(const isosurface *s, pov_vec3 p, double *memory)
{
    const double h = 0x1p-17 * s->size;
    const pov_vec3 x = { h, 0.0, 0.0 }, y = { 0.0, h, 0.0 }, z = { 0.0, 0.0, h };
    const pov_vec3 at[SIDES] = { pov_add(p, x), pov_sub(p, x), pov_add(p, y), pov_sub(p, y), pov_add(p, z), pov_sub(p, z) };
    double v[SIDES];

    values_at(s, at, memory, v);
    return pov_vec3_of(v[0] - v[1], v[2] - v[3], v[4] - v[5]);
}

/* Where the function jumps past the threshold, its gradient says nothing of the surface. */
static pov_vec3 slope_at(const isosurface *s, pov_vec3 p, void *memory)
{
    pov_vec3 slope;
    double value;

    if (!s->exact)
        return difference_at(s, p, memory);
    slope = common_level_gradient(s->exact, p, memory, &value);
    if (fabs(value - s->threshold) <= 0x1p-20 * s->size * pov_largest(slope) && pov_largest(slope) < HUGE_VAL)
        return slope;
    return difference_at(s, p, memory);
}

/* A ray that starts on the surface: on which side it goes on. */
static double side_ahead(const line *n, const pov_ray *ray)
{
    const uint32_t flags = ray->origin_mark.flags;

    if (flags & (POV_MARK_OUTWARD | POV_MARK_INWARD))
        return flags & POV_MARK_OUTWARD ? 0.0 : -0x1p-1000;
    return pov_dot(slope_at(n->s, n->o, n->memory), n->d) >= 0.0 ? 0.0 : -0x1p-1000;
}

static bool found(void *user, double t) { return report(user, t, SURFACE); }

static bool is_below_at(const line *n, const common_level *level, double t)
{
    const common_cell kind = common_cells_kind(&n->s->cells, pov_add(n->o, pov_scale(n->d, t)));

    return kind == COMMON_CELL_OPEN ? common_level_is_below(level, t) : kind == COMMON_CELL_BELOW;
}

static void intersect_by_bounds(line *n, const pov_ray *ray, double end, bool from_surface, bool enters)
{
    const pov_hits *hits = n->hits;
    const isosurface *s = n->s;
    const bool is_approx = hits->want == POV_WANT_ANY || hits->count_only;
    common_level level = { .f = s->exact, .threshold = s->threshold, .o = n->o, .d = n->d, .memory = n->memory,
                           .shortest = 0x1p-46 * s->size / n->speed, .from_surface = from_surface, .found = found, .user = n };

    level.start = from_surface ? side_ahead(n, ray) : 0.0;
    level.approx_from = hits->tmin / n->unit - n->base;
    level.approx_to = is_approx ? hits->tmax / n->unit * (1.0 - 0x1p-40) - n->base : -HUGE_VAL;
    if (enters && is_below_at(n, &level, 0.0) && !report(n, 0.0, SKIN))
        return;
    if (common_cells_search(&s->cells, &level, 0.0, end) && !s->open && is_below_at(n, &level, end))
        report(n, end, SKIN);
}

/* What is asked of a ray within the container. False: nothing. */
typedef struct asked { line n; double end; bool from_surface, enters; } asked;

static bool begin(const isosurface *s, const pov_ray *ray, pov_hits *hits, asked *out)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    const bool from_here = ray->origin_surface == hits->owner, from_skin = from_here && ray->origin_mark.feature == SKIN;
    line *n = &out->n;
    common_span span;

    if (!clip(s, &k, &span) || span.hi <= 0.0 || span.lo * k.unit > hits->tmax)
        return false;
    n->s = s;
    n->base = pov_max(span.lo, 0.0);
    n->o = common_along(&k, n->base);
    n->d = k.d;
    n->speed = sqrt(pov_dot(k.d, k.d));
    n->unit = k.unit;
    n->memory = hits->scratch;
    n->hits = hits;
    out->end = pov_min(span.hi, hits->tmax * k.per_unit * (1.0 + 0x1p-20)) - n->base;
    out->from_surface = from_here && !from_skin;
    out->enters = !s->open && span.lo > 0.0 && !from_skin;
    /* A ray that starts on the skin goes in, or is at its end already. */
    return !from_skin || span.hi * n->speed > 0x1p-30 * s->size;
}

static bool found_step(void *user, common_steps_event event, double t)
{
    const asked *a = user;

    switch (event) {
    case COMMON_STEPS_BELOW_START: return !a->enters || report(&a->n, 0.0, SKIN);
    case COMMON_STEPS_BELOW_END: return a->n.s->open || report(&a->n, t, SKIN);
    default: return report(&a->n, t, SURFACE);
    }
}

/* By the gradient: several rays together. */
static void intersect_by_steps(const isosurface *s, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    const common_steps steps = { s->function, s->threshold, s->gradient, s->accuracy, s->size, found_step };
    common_steps_line lines[TOGETHER];
    asked all[TOGETHER];
    uint32_t count = 0;

    for (uint32_t i = 0; i < n; i++) {
        asked *a = &all[count];
        common_steps_line *l = &lines[count];

        if (!begin(s, rays[i], hits[i], a))
            continue;
        l->o = a->n.o;
        l->d = a->n.d;
        l->speed = a->n.speed;
        l->end = a->end;
        l->start_is_known = a->from_surface;
        l->start = a->from_surface ? side_ahead(&a->n, rays[i]) : 0.0;
        l->user = a;
        count++;
    }
    if (count > 0)
        common_steps_search(&steps, lines, count, hits[0]->scratch);
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const isosurface *s = self;
    asked a;

    if (!s->exact)
        intersect_by_steps(s, &ray, &hits, 1);
    else if (begin(s, ray, hits, &a))
        intersect_by_bounds(&a.n, ray, a.end, a.from_surface, a.enters);
}

static void intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    for (uint32_t i = 0, some; i < n; i += some) {
        const isosurface *s = selves[i];

        for (some = 1; !s->exact && some < TOGETHER && i + some < n && selves[i + some] == s;)
            some++;
        if (s->exact)
            intersect(s, rays[i], hits[i]);
        else
            intersect_by_steps(s, rays + i, hits + i, some);
    }
}

/* ---- points ---- */

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const isosurface *s = self;
    const pov_vec3 p = pov_add(point, point_lo), from = pov_sub(p, s->centre);
    double memory[MEMORY];

    if (s->sphere ? pov_dot(from, from) > s->radius * s->radius
                  : !(p.x >= s->lo.x && p.y >= s->lo.y && p.z >= s->lo.z && p.x <= s->hi.x && p.y <= s->hi.y && p.z <= s->hi.z))
        return false;
    return value_at(s, p, memory) < 0.0;
}

/* The side of the box, or of the sphere, that the point is nearest to. */
static pov_vec3 skin_normal(const isosurface *s, pov_vec3 p)
{
    const double off[6] = { p.x - s->lo.x, s->hi.x - p.x, p.y - s->lo.y, s->hi.y - p.y, p.z - s->lo.z, s->hi.z - p.z };
    double out[3] = { 0.0, 0.0, 0.0 };
    int best = 0;

    if (s->sphere)
        return pov_unit(pov_sub(p, s->centre));
    for (int i = 1; i < 6; i++)
        if (fabs(off[i]) < fabs(off[best]))
            best = i;
    out[best / 2] = best % 2 == 0 ? -1.0 : 1.0;
    return pov_vec3_of(out[0], out[1], out[2]);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const isosurface *s = self;
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    const pov_vec3 p = pov_two3_hi(common_point(&k, at));
    double memory[MEMORY];

    if (at->mark.feature == SKIN) {
        *out = skin_normal(s, p);
        return;
    }
    *out = pov_unit(slope_at(s, p, memory));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

static const pov_shape_fast fast = { .size = sizeof(pov_shape_fast), .intersect_many = intersect_many };
static const void *extension(const char *name) { return common_is_fast(name) ? &fast : NULL; }

static bool open(const void *self) { return ((const isosurface *)self)->open; }

static const pov_shape_class isosurface_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "isosurface",
    .instance_size = sizeof(isosurface),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .extension = extension,
    .scratch = scratch,
    .open = open,
};

static const pov_shape_class *const shapes[] = { &isosurface_class, NULL };

POV_PLUGIN(isosurface) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "isosurface",
    .version = "1",
    .shapes = shapes,
};
