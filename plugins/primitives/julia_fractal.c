/* julia_fractal { <4 numbers> [quaternion | hypercomplex] [sqr | cube | ...] [max_iteration n] [precision p] [slice <4 numbers>, d] }:
 * points of a three-dimensional slice whose first n places under q -> f(q) + c stay within a sphere.
 *
 * A stretch of a ray is a sphere of numbers. Its image under f lies in a sphere that is known, so that whole stretches are
 * found to be inside or outside; the others are halved. Hypercomplex numbers are pairs of complex ones, on which f acts
 * one by one. */
#include "common/clip.h"
#include "common/complex_disc.h"

typedef struct number { double v[4]; } number;
typedef disc function(disc);

typedef struct julia {
    number c, slice;             /* slice: a unit vector, the hyperplane's normal */
    double at;                   /* and its distance */
    double reach;                /* of the sphere */
    pov_box box;                 /* around it */
    double shortest;             /* stretches below this are searched no further */
    uint32_t places;             /* n */
    function *f;                 /* of hypercomplex numbers; NULL: of quaternions, sqr or cube */
    disc power;                  /* of pwr */
    bool is_power, cube;
} julia;

/* ---- loading ---- */

typedef struct keyword { const char *word; function *f; } keyword;

static const keyword keywords[] = {
    { "exp", disc_exp }, { "reciprocal", disc_reciprocal }, { "sin", disc_sin }, { "asin", disc_asin }, { "sinh", disc_sinh },
    { "asinh", disc_asinh }, { "cos", disc_cos }, { "acos", disc_acos }, { "cosh", disc_cosh }, { "acosh", disc_acosh },
    { "tan", disc_tan }, { "atan", disc_atan }, { "tanh", disc_tanh }, { "atanh", disc_atanh }, { "ln", disc_log },
};

/* What has been said, in any order. */
typedef struct wishes { function *f; bool cube, hypercomplex, quaternion; } wishes;

static bool read_power(julia *j, wishes *w, const pov_host *host, pov_reader *in)
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

static bool read_function(julia *j, wishes *w, const pov_host *host, pov_reader *in)
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

static void read_slice(julia *j, const pov_host *host, pov_reader *in)
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

static bool read_item(julia *j, wishes *w, const pov_host *host, pov_reader *in)
{
    if (host->accept(in, "hypercomplex"))
        w->hypercomplex = true;
    else if (host->accept(in, "quaternion"))
        w->quaternion = true;
    else if (host->accept(in, "max_iteration"))
        j->places = (uint32_t)fmin(fmax(host->number(in), 1.0), 1e6);
    else if (host->accept(in, "precision"))
        j->shortest = 1.0 / fmin(fmax(host->number(in), 1.0), 1e5);
    else if (host->accept(in, "slice"))
        read_slice(j, host, in);
    else
        return host->accept(in, ",") || read_function(j, w, host, in);
    return true;
}

static double square_of(const number *q) { return q->v[0] * q->v[0] + q->v[1] * q->v[1] + q->v[2] * q->v[2] + q->v[3] * q->v[3]; }

/* ---- the sequence of a sphere ---- */

/* Before its first place: a point, and how far others are from it. */
static number enter(const julia *j, pov_vec3 p)
{
    const double *n = j->slice.v;
    const number q = { { p.x, p.y, p.z, (j->at - n[0] * p.x - n[1] * p.y - n[2] * p.z) / n[3] } };

    return q;
}

/* All of it inside or outside, or some of it maybe. A sphere of radius 0 is one or the other. */
typedef enum side { SIDE_IN, SIDE_OUT, SIDE_OPEN } side;

/* The last place that was looked at, its square of size, and at which place the middle left. */
typedef struct trail { double square; uint32_t place; } trail;

static side judge(const julia *j, double lo, double hi, side before)
{
    const double most = j->reach * j->reach;

    return !(lo <= most) ? SIDE_OUT : hi <= most ? before : SIDE_OPEN;
}

/* q^2 = (a^2 - |v|^2, 2 a v), q^3 = (a (a^2 - 3 |v|^2), (3 a^2 - |v|^2) v). */
static void step_quaternion(const julia *j, number *q)
{
    double *p = q->v;
    const double a = p[0], a2 = a * a, v2 = p[1] * p[1] + p[2] * p[2] + p[3] * p[3];
    const double times = j->cube ? 3.0 * a2 - v2 : 2.0 * a;

    p[0] = (j->cube ? a * (a2 - 3.0 * v2) : a2 - v2) + j->c.v[0];
    for (int k = 1; k < 4; k++)
        p[k] = p[k] * times + j->c.v[k];
}

static double step_off(const julia *j, double size, double off)
{
    return j->cube ? ((3.0 * size + off) * off + 3.0 * size * size) * off : (2.0 * size + off) * off;
}

static side follow_quaternion(const julia *j, number q, double off, uint32_t places, trail *out)
{
    const double most = j->reach * j->reach;
    side now = SIDE_IN;

    for (uint32_t i = 0; i < places && now != SIDE_OUT; i++) {
        double size;

        if (i > 0)
            step_quaternion(j, &q);
        out->square = square_of(&q);
        out->place = i;
        if (!(off > 0.0)) {
            now = !(out->square <= most) && i < j->places ? SIDE_OUT : SIDE_IN;
            continue;
        }
        size = sqrt(out->square);
        now = judge(j, size > off ? (size - off) * (size - off) : 0.0, (size + off) * (size + off), now);
        off = step_off(j, size, off);
    }
    return now;
}

/* The square of a sum's size, where each part may be off. */
static double square_at_least(disc u, disc v)
{
    const double a = fmax(disc_size(u) - u.off, 0.0), b = fmax(disc_size(v) - v.off, 0.0);

    return 0.5 * (a * a + b * b);
}

static double square_at_most(disc u, disc v)
{
    const double a = disc_size(u) + u.off, b = disc_size(v) + v.off;

    return 0.5 * (a * a + b * b);
}

static disc step_complex(const julia *j, disc z, double re, double im)
{
    z = j->f(z);
    if (j->is_power)
        z = disc_exp(disc_times(z, j->power));
    return disc_of(z.re + re, z.im + im, z.off);
}

static side follow_pair(const julia *j, disc u, disc v, uint32_t places, trail *out)
{
    const double *c = j->c.v;
    const bool is_point = !(u.off + v.off > 0.0);
    side now = SIDE_IN;

    for (uint32_t i = 0; i < places && now != SIDE_OUT; i++) {
        if (i > 0) {
            u = step_complex(j, u, c[0] - c[3], c[1] + c[2]);
            v = step_complex(j, v, c[0] + c[3], c[1] - c[2]);
        }
        out->square = 0.5 * (disc_square(u) + disc_square(v));
        out->place = i;
        if (is_point)
            now = !(out->square <= j->reach * j->reach) && i < j->places ? SIDE_OUT : SIDE_IN;
        else
            now = judge(j, square_at_least(u, v), square_at_most(u, v), now);
    }
    return now;
}

/* Of the points whose numbers are up to `off` from the number of p. The hypercomplex a + b i + c j + d k is the pair
 * (a - d) + (b + c) i, (a + d) + (b - c) i. */
static side follow(const julia *j, pov_vec3 p, double off, uint32_t places, trail *out)
{
    const double sqrt_two = 1.4142135623730951;
    const number q = enter(j, p);
    const double *a = q.v;

    out->square = 0.0;
    out->place = 0;
    if (!j->f)
        return follow_quaternion(j, q, off, places, out);
    return follow_pair(j, disc_of(a[0] - a[3], a[1] + a[2], sqrt_two * off), disc_of(a[0] + a[3], a[1] - a[2], sqrt_two * off), places, out);
}

/* ---- the box around it ---- */

/* Halves of the cube around the sphere, one axis after the other. */
enum { HALVES = 12, PLACES_OF_BOX = 20 };

static bool is_boxed(const pov_box *all, const pov_box *b)
{
    return b->lo.x >= all->lo.x && b->lo.y >= all->lo.y && b->lo.z >= all->lo.z && b->hi.x <= all->hi.x && b->hi.y <= all->hi.y &&
           b->hi.z <= all->hi.z;
}

static void add_box(pov_box *all, const pov_box *b)
{
    all->lo = pov_vec3_of(fmin(all->lo.x, b->lo.x), fmin(all->lo.y, b->lo.y), fmin(all->lo.z, b->lo.z));
    all->hi = pov_vec3_of(fmax(all->hi.x, b->hi.x), fmax(all->hi.y, b->hi.y), fmax(all->hi.z, b->hi.z));
}

/* Cells that are not certainly outside. */
static void find_cells(julia *j, const pov_box *cell, double rate, uint32_t left)
{
    const pov_vec3 size = pov_sub(cell->hi, cell->lo), middle = pov_scale(pov_add(cell->lo, cell->hi), 0.5);
    pov_box part = *cell;
    trail at;

    if (is_boxed(&j->box, cell) ||
        follow(j, middle, 0.5 * sqrt(pov_dot(size, size)) * rate, j->places < PLACES_OF_BOX ? j->places : PLACES_OF_BOX, &at) == SIDE_OUT)
        return;
    if (left == 0) {
        add_box(&j->box, cell);
        return;
    }
    *(left % 3 == 0 ? &part.hi.x : left % 3 == 1 ? &part.hi.y : &part.hi.z) = left % 3 == 0 ? middle.x : left % 3 == 1 ? middle.y : middle.z;
    find_cells(j, &part, rate, left - 1);
    part = *cell;
    *(left % 3 == 0 ? &part.lo.x : left % 3 == 1 ? &part.lo.y : &part.lo.z) = left % 3 == 0 ? middle.x : left % 3 == 1 ? middle.y : middle.z;
    find_cells(j, &part, rate, left - 1);
}

static void find_box(julia *j)
{
    const double r = j->reach * (1.0 + 0x1p-20), *n = j->slice.v;
    const pov_box cube = { { -r, -r, -r }, { r, r, r } };
    /* How fast the fourth number changes. */
    const double last = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / fabs(n[3]);

    j->box.lo = cube.hi;
    j->box.hi = cube.lo;
    find_cells(j, &cube, sqrt(1.0 + last * last), HALVES);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    wishes w = { NULL, false, false, false };
    julia *j = self;

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
    j->reach = j->f ? 4.0 : fmin(1.0 + sqrt(square_of(&j->c)), 2.0);
    j->shortest *= 0x1p-4;
    find_box(j);
}

static bool bounds(const void *self, pov_box *out)
{
    *out = ((const julia *)self)->box;
    return true;
}

/* ---- along a ray ---- */

/* Points at o + t d; numbers change by `rate` t. */
typedef struct line {
    const julia *j;
    pov_vec3 o, d;
    double base, rate, unit;
    double near, side;           /* up to there the value is that of the start: rounding decides nothing */
    pov_hits *hits;
} line;

/* Above 0: outside. */
typedef struct sample { double t, value; uint32_t place; } sample;

static sample sample_at(const line *n, double t)
{
    sample a = { t, n->side, 0 };
    trail at;

    if (t < n->near)
        return a;
    follow(n->j, pov_add(n->o, pov_scale(n->d, t)), 0.0, n->j->places, &at);
    a.value = at.square - n->j->reach * n->j->reach;
    a.value = a.value == a.value ? a.value : HUGE_VAL;
    a.place = at.place;
    return a;
}

static bool is_out(sample a) { return a.value > 0.0; }

/* What is left of the value that stays, where the other one becomes `next` from `before` (Anderson and Bjorck). */
static double weight(double next, double before)
{
    const double rest = 1.0 - next / before;

    return rest > 0.0 ? rest : 0.5;
}

/* Between two points on different sides; a place beyond the last is none. The side whose value has stayed counts for less the next
 * time, and each guess goes a little beyond the root, so that both come near. */
static sample refine(const line *n, sample a, sample b)
{
    double from = a.value, to = b.value;

    for (int turn = 0; turn < 200; turn++) {
        const double least = 0x1p-50 * (fabs(a.t) + n->j->reach / n->rate), share = from / (from - to);
        const double guess = a.t + share * (b.t - a.t) + (share < 0.5 ? 0.5 : -0.5) * least;
        const sample c = sample_at(n, turn % 8 < 7 && guess > a.t && guess < b.t ? guess : 0.5 * (a.t + b.t));
        double *const kept = is_out(c) == is_out(a) ? &to : &from;

        if (!(c.t > a.t && c.t < b.t))
            break;
        *kept *= weight(c.value, kept == &to ? from : to);
        *(kept == &to ? &a : &b) = c;
        *(kept == &to ? &from : &to) = c.value;
        if (b.t - a.t <= least)
            break;
    }
    return is_out(a) ? a : b;
}

/* False: nothing more is wanted. */
static bool report(const line *n, sample at)
{
    const pov_two t = pov_two_sum(n->base, at.t);
    const pov_mark mark = { at.place, 0, 0.0, 0.0 };
    pov_hits *hits = n->hits;

    return pov_cross(hits, t.hi * n->unit, t.lo * n->unit, mark) && !(hits->want == POV_WANT_NEAREST && t.hi * n->unit > hits->tmin);
}

static side side_between(const line *n, double from, double to)
{
    trail at;

    return follow(n->j, pov_add(n->o, pov_scale(n->d, 0.5 * (from + to))), 0.5 * (to - from) * n->rate, n->j->places, &at);
}

/* From `a` to the distance `to`: long stretches where they are clear, short ones near the surface. Beyond `enough` nothing is
 * wanted; where stretches end does not depend on it, so that crossings keep their bits whatever else is in the scene. */
static void march(const line *n, sample a, double to, double enough)
{
    const double shortest = n->j->shortest / n->rate;
    double length = 0.25 * (to - a.t);

    while (a.t < to && a.t <= enough) {
        const double next = fmin(a.t + fmax(length, shortest), to);
        const side between = length > shortest ? side_between(n, a.t, next) : SIDE_OPEN;
        sample b = { next, a.value, a.place };

        if (length > shortest && between == SIDE_OPEN) {
            length *= 0.25;
            continue;
        }
        if (between == SIDE_OPEN || (between == SIDE_OUT) != is_out(a))
            b = sample_at(n, next);
        if (is_out(a) != is_out(b) && !report(n, refine(n, sample_at(n, a.t), b)))
            return;
        a = b;
        length = 2.0 * fmax(length, shortest);
    }
}

/* How the square of the number's size at a place changes. */
static pov_vec3 slope_at(const julia *j, pov_vec3 p, uint32_t place)
{
    const double h = 0x1p-24;
    double slope[3];

    for (int i = 0; i < 3; i++) {
        const pov_vec3 by = pov_vec3_of(i == 0 ? h : 0.0, i == 1 ? h : 0.0, i == 2 ? h : 0.0);
        julia all = *j;
        trail a, b;

        all.places = 0;   /* no point leaves */
        follow(&all, pov_add(p, by), 0.0, place + 1, &a);
        follow(&all, pov_sub(p, by), 0.0, place + 1, &b);
        slope[i] = a.square - b.square;
    }
    return pov_vec3_of(slope[0], slope[1], slope[2]);
}

/* A ray that starts on the surface: on which side it goes on. */
static double side_ahead(const line *n, const pov_ray *ray)
{
    const uint32_t flags = ray->origin_mark.flags;

    if (flags & (POV_MARK_OUTWARD | POV_MARK_INWARD))
        return flags & POV_MARK_OUTWARD ? 0x1p-1000 : 0.0;
    return pov_dot(slope_at(n->j, n->o, ray->origin_mark.feature), n->d) >= 0.0 ? 0x1p-1000 : 0.0;
}

/* Of the number, for a step of length 1 along the ray. */
static double rate_of(const julia *j, pov_vec3 d)
{
    const double *n = j->slice.v, last = (n[0] * d.x + n[1] * d.y + n[2] * d.z) / n[3];

    return sqrt(pov_dot(d, d) + last * last);
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const julia *j = self;
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    common_span span;
    line n;

    if (!common_clip(&k, j->box.lo, j->box.hi, &span) || span.hi <= 0.0 || span.lo * k.unit > hits->tmax)
        return;
    n.base = fmax(span.lo, 0.0);
    n.j = j;
    n.o = common_along(&k, n.base);
    n.d = k.d;
    n.rate = rate_of(j, k.d);
    n.unit = k.unit;
    n.hits = hits;
    n.near = n.side = 0.0;
    if (ray->origin_surface == hits->owner) {
        n.near = 0x1p-26 * j->reach / n.rate;
        n.side = side_ahead(&n, ray);
    }
    march(&n, sample_at(&n, 0.0), span.hi - n.base, hits->tmax * k.per_unit * (1.0 + 0x1p-20) - n.base);
}

/* ---- points ---- */

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const julia *j = self;
    trail at;

    return follow(j, pov_add(point, point_lo), 0.0, j->places, &at) == SIDE_IN;
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);

    *out = pov_unit(slope_at(self, pov_two3_hi(common_point(&k, at)), at->mark.feature));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

/* As POV-Ray has it: of the place after the last, where it was the last that left the sphere. */
static uint32_t shading_normals(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark, pov_vec3 *out,
                                double *share)
{
    const julia *j = self;

    if ((j->f && j->f != disc_squared) || mark->feature + 1 != j->places)
        return 0;
    *out = pov_unit(slope_at(j, pov_add(point, point_lo), mark->feature + 1));
    *share = 1.0;
    return pov_largest(*out) > 0.0;
}

static const pov_shape_class julia_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "julia_fractal",
    .instance_size = sizeof(julia),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
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
