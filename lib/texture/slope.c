#include "base/elementary.h"
#include "texture/pattern.h"

/* slope: the angle between the surface's normal and a direction, and a height if asked for; aoi: that between the
 * normal and the ray. */
typedef struct steepness {
    pov_vec3 direction, altitude;
    double low, high, low_altitude, high_altitude;
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

/* The lengths of both vectors are weights of the angle and of the height. */
static void evaluate_slope(const pattern_input *in, double *value)
{
    const steepness *s = in->of->self;
    const double steep = sqrt(pov_dot(s->direction, s->direction)), high = sqrt(pov_dot(s->altitude, s->altitude));
    const pov_vec3 direction = steep > 0.0 ? pov_unit(s->direction) : s->direction, up = pov_unit(s->altitude);

    for (uint32_t i = 0; i < in->n; i++) {
        double v = between(angle_value(pov_dot(lanes_at(in->normal, i), direction)), s->low, s->high);

        if (high > 0.0)
            v = (steep * v + high * between(pov_dot(lanes_at(in->at, i), up), s->low_altitude, s->high_altitude)) / (steep + high);
        value[i] = folded(v);
    }
}

static void evaluate_aoi(const pattern_input *in, double *value)
{
    for (uint32_t i = 0; i < in->n; i++)
        value[i] = angle_value(-pov_dot(lanes_at(in->normal, i), lanes_at(in->view, i)));
}

static const char *check(const void *self)
{
    const steepness *s = self;

    if (pov_largest(s->direction) > 0.0 || pov_largest(s->altitude) > 0.0)
        return NULL;
    return "the direction of a slope must not be 0 where it has no altitude";
}

static const pattern_word words[] = {
    { NULL, PATTERN_VECTOR, offsetof(steepness, direction), false },
    { NULL, PATTERN_NUMBER, offsetof(steepness, low), true },
    { NULL, PATTERN_NUMBER, offsetof(steepness, high), true },
    { "altitude", PATTERN_VECTOR, offsetof(steepness, altitude), false },
    { NULL, PATTERN_NUMBER, offsetof(steepness, low_altitude), true },
    { NULL, PATTERN_NUMBER, offsetof(steepness, high_altitude), true },
};

const pattern_class pattern_slope = {
    .keyword = "slope",
    .self_size = sizeof(steepness),
    .words = words,
    .word_count = sizeof words / sizeof words[0],
    .check = check,
    .flags = PATTERN_NEEDS_NORMAL | PATTERN_BRACED,
    .evaluate = evaluate_slope,
};

const pattern_class pattern_aoi = {
    .keyword = "aoi",
    .flags = PATTERN_NEEDS_NORMAL | PATTERN_NEEDS_VIEW,
    .evaluate = evaluate_aoi,
};
