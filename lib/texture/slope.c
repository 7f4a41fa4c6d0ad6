#include "base/elementary.h"
#include "texture/pattern.h"
#include "texture/texture.h"

/* slope: the angle between the surface's normal and a direction, and a height if asked for; aoi: that between the
 * normal and the ray. */
typedef struct steepness {
    pov_vec3 direction, altitude;
    double low, high, low_altitude, high_altitude;
    pov_vec3 point_at;           /* of the world, instead of both vectors; NaN: none is given */
} steepness;

static const double pi = 3.14159265358979323846;

SIMD_INLINE double angle_value(double cosine)
{
    const double c = cosine < -1.0 ? -1.0 : cosine > 1.0 ? 1.0 : cosine;

    return 1.0 - elementary_acos(c) / pi;
}

/* Where both are alike, as those that are not given, values stay as they are. */
static double between(double value, double low, double high)
{
    return low == high ? value : (value - low) / (high - low);
}

/* What lies beyond 0..1 begins again before its wave is made, which other patterns' values do not. */
static double folded(double v)
{
    const double rest = v < 0.0 || v > 1.0 ? fmod(v, 1.0) : v;

    return rest < 0.0 ? rest + 1.0 : rest;
}

static bool is_given(pov_vec3 point) { return point.x == point.x; }

/* The angle to the way to a point, which nothing moves, as in POV-Ray. */
static void evaluate_about(const pattern_input *in, const steepness *s, double *value)
{
    const vec_lanes *at = in->points->has_world ? &in->points->world : in->at;

    for (uint32_t i = 0; i < in->n; i++) {
        const pov_vec3 dir = pov_unit(pov_sub(s->point_at, lanes_at(at, i)));

        value[i] = folded(between(angle_value(pov_dot(lanes_at(in->normal, i), dir)), s->low, s->high));
    }
}

/* The lengths of both vectors are weights of the angle and of the height. */
static void evaluate_along(const pattern_input *in, const steepness *s, double *value)
{
    const double steep = sqrt(pov_dot(s->direction, s->direction)), high = sqrt(pov_dot(s->altitude, s->altitude));
    const pov_vec3 direction = steep > 0.0 ? pov_unit(s->direction) : s->direction, up = pov_unit(s->altitude);

    for (uint32_t i = 0; i < in->n; i++) {
        double v = between(angle_value(pov_dot(lanes_at(in->normal, i), direction)), s->low, s->high);

        if (high > 0.0)
            v = (steep * v + high * between(pov_dot(lanes_at(in->at, i), up), s->low_altitude, s->high_altitude)) / (steep + high);
        value[i] = folded(v);
    }
}

static void evaluate_slope(const pattern_input *in, double *value)
{
    const steepness *s = in->of->self;

    if (is_given(s->point_at))
        evaluate_about(in, s, value);
    else
        evaluate_along(in, s, value);
}

static void evaluate_aoi(const pattern_input *in, double *value)
{
    for (uint32_t i = 0; i < in->n; i++)
        value[i] = angle_value(-pov_dot(lanes_at(in->normal, i), lanes_at(in->view, i)));
}

static const char *check(const void *self)
{
    const steepness *s = self;
    const bool has_direction = pov_largest(s->direction) > 0.0 || pov_largest(s->altitude) > 0.0;

    if (is_given(s->point_at))
        return has_direction ? "point_at takes the place of the direction of a slope, and of its altitude" : NULL;
    if (has_direction)
        return NULL;
    return "the direction of a slope must not be 0 where it has no altitude";
}

static const steepness steepness_default = { .point_at = { NAN, NAN, NAN } };

static const pattern_word words[] = {
    { NULL, PATTERN_VECTOR, offsetof(steepness, direction), true },
    { NULL, PATTERN_NUMBER, offsetof(steepness, low), true },
    { NULL, PATTERN_NUMBER, offsetof(steepness, high), true },
    { "altitude", PATTERN_VECTOR, offsetof(steepness, altitude), false },
    { NULL, PATTERN_NUMBER, offsetof(steepness, low_altitude), true },
    { NULL, PATTERN_NUMBER, offsetof(steepness, high_altitude), true },
    { "point_at", PATTERN_VECTOR, offsetof(steepness, point_at), false },
    { NULL, PATTERN_NUMBER, offsetof(steepness, low), true },
    { NULL, PATTERN_NUMBER, offsetof(steepness, high), true },
};

const pattern_class pattern_slope = {
    .keyword = "slope",
    .self_size = sizeof(steepness),
    .self = &steepness_default,
    .words = words,
    .word_count = sizeof words / sizeof words[0],
    .check = check,
    .flags = PATTERN_NEEDS_NORMAL | PATTERN_NEEDS_WORLD | PATTERN_BRACED,
    .evaluate = evaluate_slope,
};

const pattern_class pattern_aoi = {
    .keyword = "aoi",
    .flags = PATTERN_NEEDS_NORMAL | PATTERN_NEEDS_VIEW,
    .evaluate = evaluate_aoi,
};
