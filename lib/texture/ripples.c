/* ripples.c - waves on water: circles about ten or more places, of one length (ripples) or of many (waves). */
#include "texture/pattern.h"

#include "base/elementary.h"

/* Where the waves of one source stand at a point: `turns` of its sine. */
typedef struct source { pov_vec3 at; double frequency, phase; } source;

static source source_of(const pattern_input *in, uint32_t i, bool is_mixed)
{
    const noise_wave *of = &in->noise->wave[i];
    const double frequency = in->of->wave.frequency;
    const source s = { of->source, is_mixed ? frequency * of->frequency : frequency, in->of->wave.phase };

    return s;
}

/* sum += factor * sin(2 pi (frequency distance + phase)). */
SIMD_CLONES static void add_height(const source *s, double factor, const vec_lanes *restrict at, uint32_t n,
                                   double *restrict sum)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = at->x[i] - s->at.x, y = at->y[i] - s->at.y, z = at->z[i] - s->at.z;

        sum[i] += factor * elementary_sin_turns(s->frequency * sqrt(x * x + y * y + z * z) + s->phase);
    }
}

/* The same along the direction from the source. */
SIMD_CLONES static void add_push(const source *s, double factor, const vec_lanes *restrict at, uint32_t n,
                                 vec_lanes *restrict sum)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = at->x[i] - s->at.x, y = at->y[i] - s->at.y, z = at->z[i] - s->at.z;
        const double distance = sqrt(x * x + y * y + z * z), per = distance > 0.0 ? 1.0 / distance : 0.0;
        const double push = factor * elementary_sin_turns(s->frequency * distance + s->phase) * per;

        sum->x[i] += push * x;
        sum->y[i] += push * y;
        sum->z[i] += push * z;
    }
}

static void evaluate(const pattern_input *in, bool is_mixed, double height, double *value)
{
    const uint32_t count = in->waves, n = lanes_whole(in->n);

    for (uint32_t i = 0; i < n; i++)
        value[i] = 0.5;
    for (uint32_t k = 0; k < count; k++) {
        const source s = source_of(in, k, is_mixed);

        add_height(&s, height / (is_mixed ? count * in->noise->wave[k].frequency : count), in->at, n, value);
    }
}

static void perturb(const pattern_input *in, bool is_mixed, double amount, vec_lanes *normal)
{
    const uint32_t count = in->waves;

    for (uint32_t k = 0; k < count; k++) {
        const source s = source_of(in, k, is_mixed);

        add_push(&s, amount / (is_mixed ? count * in->noise->wave[k].frequency : count), in->at, lanes_whole(in->n), normal);
    }
}

static void evaluate_ripples(const pattern_input *in, double *value) { evaluate(in, false, 0.5, value); }
static void evaluate_waves(const pattern_input *in, double *value) { evaluate(in, true, 0.2, value); }

static void perturb_ripples(const pattern_input *in, double amount, vec_lanes *normal)
{
    perturb(in, false, amount, normal);
}

static void perturb_waves(const pattern_input *in, double amount, vec_lanes *normal)
{
    perturb(in, true, amount, normal);
}

const pattern_class pattern_ripples = { .keyword = "ripples", .flags = PATTERN_NEEDS_NOISE, .evaluate = evaluate_ripples,
                                        .perturb = perturb_ripples };
const pattern_class pattern_waves = { .keyword = "waves", .flags = PATTERN_NEEDS_NOISE, .evaluate = evaluate_waves,
                                      .perturb = perturb_waves };
