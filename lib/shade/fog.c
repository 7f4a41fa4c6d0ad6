#include "shade/fog.h"

#include "base/elementary.h"
#include "texture/noise.h"

/* ---- length that counts: by the density along it ---- */

/* The integral of the density 1 below 0, 1/(1 + y^2) above. */
SIMD_INLINE double layered_integral(double y)
{
    const double above = elementary_atan(y);

    return y <= 0.0 ? y : above;
}

/* Mean density times length of a layered fog between two heights, in its units above the offset, that are the same. */
static double level_course(double y, double length)
{
    const double level = y <= 0.0 ? 1.0 : 1.0 / (1.0 + y * y);

    return length * level;
}

/* The same for a ray without end that rises by `slope` a unit of length, and the integral up to its start. */
static double endless_course(double before, double slope)
{
    const double quarter = 1.57079632679489661923, course = (quarter - before) / slope;

    return slope > 0.0 ? course : HUGE_VAL;
}

/* Without an `alt` the density is 1 below the offset and 0 above. */
SIMD_INLINE double stepped_course(double y0, double slope, double length)
{
    const double until = -y0 / slope;   /* length to the step */
    const double below = slope > 0.0 && until < length ? until : length;
    const double above = slope < 0.0 && until < length ? length - until : 0.0;

    return y0 <= 0.0 ? below : above;
}

SIMD_INLINE double height_of(const fog *f, const fog_segments *s, uint32_t i) { return pov_dot(f->up, lanes_at(&s->from, i)) - f->offset; }
SIMD_INLINE double slope_of(const fog *f, const fog_segments *s, uint32_t i) { return pov_dot(f->up, lanes_at(&s->dir, i)); }

SIMD_CLONES static void find_stepped(const fog *restrict f, const fog_segments *restrict s, uint32_t n, double *restrict course)
{
    for (uint32_t i = 0; i < n; i++)
        course[i] = stepped_course(height_of(f, s, i), slope_of(f, s, i), s->length[i]);
}

/* Where segments begin and end in a layered fog: heights in its units above the offset, and the integrals up to there. */
typedef struct SIMD_ALIGNED layers_crossed { double from[LANES_MAX], to[LANES_MAX], before[LANES_MAX], after[LANES_MAX]; } layers_crossed;

/* False: they begin at different heights. */
SIMD_CLONES static bool find_starts(const fog *restrict f, const fog_segments *restrict s, uint32_t n, double *restrict height)
{
    const double first = height_of(f, s, 0);
    int64_t alike = -1;

    for (uint32_t i = 0; i < n; i++) {
        height[i] = height_of(f, s, i);
        alike &= height[i] == first ? -1 : 0;
    }
    return alike != 0;
}

SIMD_CLONES static void find_ends(const fog *restrict f, const fog_segments *restrict s, uint32_t n, layers_crossed *restrict at)
{
    for (uint32_t i = 0; i < n; i++)
        at->to[i] = (at->from[i] + slope_of(f, s, i) * s->length[i]) / f->alt;
}

SIMD_CLONES static void divide(double by, uint32_t n, double *restrict x)
{
    for (uint32_t i = 0; i < n; i++)
        x[i] /= by;
}

static void fill(double with, uint32_t n, double *out)
{
    for (uint32_t i = 0; i < n; i++)
        out[i] = with;
}

/* Camera rays begin at one height. False: these do not. */
static bool find_heights(const fog *f, const fog_segments *s, uint32_t n, layers_crossed *out)
{
    const bool alike = find_starts(f, s, n, out->from);

    find_ends(f, s, n, out);
    if (alike)
        fill(out->from[0] / f->alt, n, out->from);
    else
        divide(f->alt, n, out->from);
    return alike;
}

SIMD_CLONES static bool any_above(const double *restrict y, uint32_t n)
{
    int64_t below = -1;

    for (uint32_t i = 0; i < n; i++)
        below &= y[i] <= 0.0 ? -1 : 0;
    return below == 0;
}

SIMD_CLONES static void find_integrals(const double *restrict y, uint32_t n, double *restrict out)
{
    for (uint32_t i = 0; i < n; i++)
        out[i] = layered_integral(y[i]);
}

/* What stands on the ground is often below the offset. */
static void integrate(const double *y, bool alike, uint32_t n, double *out)
{
    if (alike)
        fill(layered_integral(y[0]), n, out);
    else if (!any_above(y, n))
        memcpy(out, y, n * sizeof *out);
    else
        find_integrals(y, n, out);
}

/* False: some segment keeps its height. */
SIMD_CLONES static bool find_sloped(const fog_segments *restrict s, const layers_crossed *restrict at, uint32_t n, double *restrict course)
{
    int64_t sloped = -1;

    for (uint32_t i = 0; i < n; i++) {
        const double rise = at->to[i] - at->from[i];

        course[i] = s->length[i] * (at->after[i] - at->before[i]) / rise;
        sloped &= rise == 0.0 ? 0 : -1;
    }
    return sloped != 0;
}

static void find_layered(const fog *f, const fog_segments *s, uint32_t n, double *course)
{
    layers_crossed at;
    const bool alike = find_heights(f, s, n, &at);

    integrate(at.from, alike, n, at.before);
    integrate(at.to, false, n, at.after);
    if (!find_sloped(s, &at, n, course))
        for (uint32_t i = 0; i < n; i++)
            if (at.to[i] - at.from[i] == 0.0)
                course[i] = level_course(at.from[i], s->length[i]);
    for (uint32_t i = 0; i < s->count; i++)
        if (s->length[i] == HUGE_VAL)
            course[i] = endless_course(at.before[i], slope_of(f, s, i) / f->alt);
}

static void find_course(const fog *f, const fog_segments *s, uint32_t n, double *course)
{
    if (!f->layered) {
        memcpy(course, s->length, n * sizeof *course);
    } else if (f->alt == 0.0) {
        find_stepped(f, s, n, course);
    } else {
        find_layered(f, s, n, course);
    }
}

/* ---- depths ---- */

/* Where it is turbulent the fog is thinner, as POV-Ray has it by the middle of the segment. */
static void thin(const model *m, const fog *f, const fog_segments *s, double *depth)
{
    const pov_vec3 by = f->turbulence.amount;
    SIMD_ALIGNED double noise[LANES_MAX];
    vec_lanes at;

    for (uint32_t i = 0; i < lanes_whole(s->count); i++) {
        const double half = s->length[i] == HUGE_VAL ? 0.0 : 0.5 * s->length[i];
        const pov_vec3 middle = pov_add(lanes_at(&s->from, i), pov_scale(lanes_at(&s->dir, i), half));

        lanes_put(&at, i, pov_vec3_of(middle.x * by.x, middle.y * by.y, middle.z * by.z));
    }
    noise_turbulence(m->noise, m->noise_generator, &f->turbulence, &at, s->count, noise);
    for (uint32_t i = 0; i < s->count; i++) {
        const double thinner = f->depth * noise[i];

        if (s->length[i] != HUGE_VAL)
            depth[i] = depth[i] * (1.0 - elementary_exp(-s->length[i] / f->distance) * (thinner < 1.0 ? thinner : 1.0));
    }
}

/* ---- veils ---- */

SIMD_CLONES static void add_fog(const fog *restrict f, const double *restrict depth, uint32_t n, fog_veils *restrict out)
{
    const float filter = f->pigment.filter, least = f->pigment.transmit;
    const colour c = f->pigment.color;

    for (uint32_t i = 0; i < n; i++) {
        const double passed = elementary_exp(-depth[i]);
        const float t = (float)(passed > (double)least ? passed : (double)least);

        out->by[0][i] *= t * (1.0f - filter + filter * c.r);
        out->by[1][i] *= t * (1.0f - filter + filter * c.g);
        out->by[2][i] *= t * (1.0f - filter + filter * c.b);
        out->given[0][i] += c.r * (1.0f - t);
        out->given[1][i] += c.g * (1.0f - t);
        out->given[2][i] += c.b * (1.0f - t);
    }
}

void fog_find(const model *m, const fog_segments *s, fog_veils *out)
{
    const uint32_t n = lanes_whole(s->count);
    SIMD_ALIGNED double depth[LANES_MAX];

    for (int k = 0; k < 3; k++)
        for (uint32_t i = 0; i < n; i++) {
            out->by[k][i] = 1.0f;
            out->given[k][i] = 0.0f;
        }
    for (size_t k = 0; k < m->fogs.count; k++) {
        const fog *f = &m->fogs.items[k];

        find_course(f, s, n, depth);
        divide(f->distance, n, depth);
        if (f->turbulence.octaves > 0)
            thin(m, f, s, depth);
        add_fog(f, depth, n, out);
    }
}

void fog_fill(fog_segments *s)
{
    for (uint32_t i = s->count; i < lanes_whole(s->count); i++) {
        lanes_put(&s->from, i, lanes_at(&s->from, s->count - 1));
        lanes_put(&s->dir, i, lanes_at(&s->dir, s->count - 1));
        s->length[i] = s->length[s->count - 1];
    }
}
