/* Where a ray crosses a tree first, about: the members' slabs and quadrics side by side, in doubles about the tree's middle, in
 * units of its size. Where two crossings, or a crossing and the ray's start, are nearer to each other than what roundings may
 * amount to, that stays open. docs/numerics.md ("Outlines") derives the constants. */
#include "world/csg_outline.h"

enum { SLABS = 3 * CSG_COLUMNS + CSG_FOUR, QUADRICS = CSG_COLUMNS, SLAB_NUMBERS = CSG_SLAB_NUMBERS, QUADRIC_NUMBERS = CSG_QUADRIC_NUMBERS, FOUR = CSG_FOUR };

static const double margin = CSG_OUTLINE_MARGIN, farthest = CSG_FARTHEST;

/* ---- a ray ---- */

/* A ray in the tree's units, from the point that is nearest to the tree's middle, with a unit vector. */
typedef struct near_ray { pov_vec3 at, along; } near_ray;

/* False: it comes from too far away. */
static bool come_near(const csg_outline *of, const pov_ray *ray, near_ray *out, csg_intervals *io)
{
    const pov_vec3 from = pov_scale(pov_sub(ray->org, of->centre), of->per_size);
    const double length = sqrt(pov_dot(ray->dir, ray->dir)), inverse = 1.0 / length;

    out->along = pov_scale(ray->dir, inverse);
    io->start = pov_dot(from, out->along);
    out->at = pov_sub(from, pov_scale(out->along, io->start));
    io->per_unit = inverse * of->size;
    io->from = of->endless ? 1.0 + pov_largest(from) : 1.0;
    return pov_largest(from) < farthest && length > 1e-100 && length < 1e100;
}

/* By slab and quadric: where a ray is within; a number other than 0 where that is open. */
typedef struct stretches {
    SIMD_ALIGNED double in[SLABS + QUADRICS], out[SLABS + QUADRICS], open[SLABS + QUADRICS];
    SIMD_ALIGNED double square[QUADRICS];   /* of quadrics: below zero a ray is within where it is not between */
} stretches;

SIMD_INLINE void cross_slabs(const double *restrict number, pov_vec3 p, pov_vec3 d, double least, double *restrict in,
                             double *restrict out, double *restrict open)
{
    for (uint32_t i = 0; i < FOUR; i++) {
        const csg_stretch s = csg_cross_slab(number + i, p, d, least);

        in[i] = s.in;
        out[i] = s.out;
        open[i] = s.open;
    }
}

SIMD_INLINE void cross_quadrics(const double *restrict number, pov_vec3 p, pov_vec3 d, double from, double *restrict in, double *restrict out,
                                double *restrict open, double *restrict square)
{
    for (uint32_t i = 0; i < FOUR; i++) {
        const csg_stretch s = csg_cross_quadric(number + i, p, d, from);

        in[i] = s.in;
        out[i] = s.out;
        open[i] = s.open;
        square[i] = s.square;
    }
}

SIMD_CLONES static void cross_all(const csg_outline *of, pov_vec3 p, pov_vec3 d, double from, stretches *restrict s)
{
    const double *quadrics = of->numbers + SLAB_NUMBERS * of->slabs, least = of->endless ? HUGE_VAL : CSG_LEAST_HEIGHT;

    for (uint32_t i = 0; i < of->slabs; i += FOUR)
        cross_slabs(of->numbers + SLAB_NUMBERS * i, p, d, least, s->in + i, s->out + i, s->open + i);
    for (uint32_t i = 0, k = of->slabs; i < of->quadrics; i += FOUR, k += FOUR)
        cross_quadrics(quadrics + QUADRIC_NUMBERS * i, p, d, from, s->in + k, s->out + k, s->open + k, s->square + i);
}

/* ---- the members' intervals ---- */

static bool is_near(double a, double b) { return fabs(a - b) <= margin; }

/* What all slabs and the quadric of a column have in common. False: open. */
static bool gather(const csg_outline *of, const near_ray *k, csg_intervals *io)
{
    uint32_t quadric = of->slabs;
    double open = 0.0;
    stretches s;

    cross_all(of, k->at, k->along, io->from, &s);
    io->outside = 0;
    for (uint32_t c = 0; c < of->count; c++) {
        double in = -HUGE_VAL, out = HUGE_VAL;

        for (uint32_t i = of->first_slab[c]; i < of->first_slab[c + 1]; i++) {
            in = s.in[i] > in ? s.in[i] : in;
            out = s.out[i] < out ? s.out[i] : out;
            open += s.open[i];
        }
        if (of->round >> c & 1) {
            in = s.in[quadric] > in ? s.in[quadric] : in;
            out = s.out[quadric] < out ? s.out[quadric] : out;
            open += s.open[quadric];
            io->outside |= (uint32_t)(s.square[quadric++ - of->slabs] < 0.0) << c;
        }
        io->in[c] = in;
        io->out[c] = out;
    }
    return open == 0.0 && !(io->outside & ~of->bare);
}

bool csg_outline_cross(const csg_outline *of, const pov_ray *ray, csg_intervals *out)
{
    near_ray k;

    return come_near(of, ray, &k, out) && gather(of, &k, out);
}

static void narrow(csg_stretch s, csg_stretch *io)
{
    io->in = s.in > io->in ? s.in : io->in;
    io->out = s.out < io->out ? s.out : io->out;
    io->open += s.square < 0.0 ? 1.0 : s.open;
}

/* What a column's slabs and quadric have in common with a stretch. */
static void narrow_column(const csg_outline *of, uint32_t c, const near_ray *k, double from, csg_stretch *io)
{
    const double *quadric = of->numbers + SLAB_NUMBERS * of->slabs + csg_number(QUADRIC_NUMBERS, of->quadric[c]);
    const double least = of->endless ? HUGE_VAL : CSG_LEAST_HEIGHT;

    for (uint32_t i = of->first_slab[c]; i < of->first_slab[c + 1]; i++)
        narrow(csg_cross_slab(of->numbers + csg_number(SLAB_NUMBERS, i), k->at, k->along, least), io);
    if (!(of->round >> c & 1))
        return;
    if (!of->endless && of->turned[of->quadric[c]].kind == CSG_SPHERE)
        narrow(csg_cross_turned(quadric, &of->turned[of->quadric[c]], false, k->at, k->along, pov_dot(k->at, k->at)), io);
    else
        narrow(csg_cross_quadric(quadric, k->at, k->along, from), io);
}

bool csg_outline_common(const csg_outline *of, uint32_t hollows, const pov_ray *ray, csg_intervals *out)
{
    const csg_stretch all = { -HUGE_VAL, HUGE_VAL, 0.0, 0.0 };
    csg_stretch s = all;
    uint32_t n = 0;
    near_ray k;

    if (!come_near(of, ray, &k, out))
        return false;
    for (uint32_t c = 0; c < of->count + of->boxed; c++)
        if (!(hollows >> c & 1))
            narrow_column(of, c, &k, out->from, &s);
    out->in[0] = s.in;
    out->out[0] = s.out;
    for (; hollows && s.open == 0.0; hollows &= hollows - 1) {
        csg_stretch hollow = all;

        narrow_column(of, first_of(hollows), &k, out->from, &hollow);
        out->in[++n] = hollow.in;
        out->out[n] = hollow.out;
        s.open = hollow.open;
    }
    return s.open == 0.0;
}

uint32_t csg_outline_column(const csg_traversal *w)
{
    const csg_outline *of = w->tree->outline;
    const uint32_t from = csg_which(w, w->ray->origin_surface);
    uint32_t i = 0;

    if (from >= w->tree->member_count)
        return CSG_COLUMNS;
    while (i < of->count && of->member[i] != from)
        i++;
    return i < of->count ? i : CSG_COLUMNS;
}

/* A member that is never entered ahead has the interval from infinity to minus infinity, one that the ray starts in begins at
 * minus infinity. `from`: the column that the ray starts on the surface of. False: open. */
static bool begin(uint32_t columns, uint32_t from, csg_intervals *io)
{
    const double start = io->start;

    for (uint32_t i = 0; i < columns; i++) {
        const bool enters = is_near(io->in[i], start), leaves = is_near(io->out[i], start);

        if (is_near(io->in[i], io->out[i]) || (i == from ? enters == leaves || io->in[i] > io->out[i]
                                                              : io->in[i] < io->out[i] && (enters || leaves)))
            return false;
        if (io->in[i] > io->out[i] || leaves || io->out[i] < start) {
            io->in[i] = HUGE_VAL;
            io->out[i] = -HUGE_VAL;
        } else if (enters || io->in[i] < start) {
            io->in[i] = -HUGE_VAL;
        }
    }
    return true;
}

/* ---- the first crossing ---- */

/* Which crossing is it, if no other one is near? */
static csg_found find_end(const csg_intervals *of, uint32_t columns, double at, csg_first *out)
{
    uint32_t times = 0;

    for (uint32_t i = 0; i < columns; i++) {
        if (of->in[i] == at || of->out[i] == at) {
            out->column = i;
            out->enters = of->in[i] == at;
        }
        times += (uint32_t)is_near(of->in[i], at) + (uint32_t)is_near(of->out[i], at);
    }
    return times == 1 ? CSG_CROSSED : CSG_OPEN;
}

/* The end of the hollows that hold the ray at `*at`. False: open. */
static bool leave_hollows(const csg_intervals *of, uint32_t hollows, double *at)
{
    for (uint32_t rest = hollows; rest; ) {
        const uint32_t i = first_of(rest);

        rest &= rest - 1;
        if (of->in[i] >= *at + margin || of->out[i] <= *at - margin || of->in[i] > of->out[i])
            continue;
        if (is_near(of->in[i], *at) || is_near(of->out[i], *at)) {
            if (of->out[i] != *at)
                return false;
            continue;
        }
        *at = of->out[i];
        rest = hollows;
    }
    return true;
}

static double find_exit(const csg_intervals *of, uint32_t hollows, double leave)
{
    for (; hollows; hollows &= hollows - 1) {
        const double in = of->in[first_of(hollows)];

        leave = in < leave && in > -HUGE_VAL ? in : leave;
    }
    return leave;
}

/* A ray that is never within all members that are no complements, or within hollows until it leaves these: nothing. */
static csg_found find(const csg_outline *by, const csg_intervals *of, double most, csg_first *out)
{
    const uint32_t hollows = ((1u << by->count) - 1) & ~by->factors;
    double enter = -HUGE_VAL, leave = HUGE_VAL, at;
    csg_found found;

    for (uint32_t left = by->factors; left; left &= left - 1) {
        enter = pov_max(enter, of->in[first_of(left)]);
        leave = pov_min(leave, of->out[first_of(left)]);
    }
    if (enter > leave + margin || (enter - of->start - margin) * of->per_unit > most)
        return CSG_NOTHING;
    at = enter > -HUGE_VAL ? enter : of->start;
    if (enter > leave - margin || !leave_hollows(of, hollows, &at))
        return CSG_OPEN;
    if (at > leave - margin)
        return at > leave + margin ? CSG_NOTHING : CSG_OPEN;
    if (at == of->start)
        at = find_exit(of, hollows, leave);
    found = find_end(of, by->count, at, out);
    out->t = (at - of->start) * of->per_unit;
    out->off = margin * of->per_unit;
    out->inward = out->enters == (by->factors >> out->column & 1);
    return found;
}

/* Is the ray ahead and before `most` certainly never within all members that are no complements? */
static bool is_nowhere(const csg_outline *by, const csg_intervals *of, double most)
{
    double enter = -HUGE_VAL, leave = HUGE_VAL;

    for (uint32_t left = by->factors; left; left &= left - 1) {
        const uint32_t i = first_of(left);

        enter = of->in[i] > enter ? of->in[i] : enter;
        leave = of->out[i] < leave ? of->out[i] : leave;
    }
    return enter > leave + margin || leave < of->start - margin || (enter - of->start - margin) * of->per_unit > most;
}

csg_found csg_outline_first(const csg_outline *by, csg_intervals *of, uint32_t from, double most, csg_first *out)
{
    if (is_nowhere(by, of, most))
        return CSG_NOTHING;
    return begin(by->count, from, of) ? find(by, of, most, out) : CSG_OPEN;
}
