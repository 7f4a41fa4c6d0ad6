#include "texture/normal.h"
#include "texture/pattern.h"

/* Cushions in cubes of side 1; the controls bend the slope at their middle and at their rim. */
typedef struct quilted { double control0, control1; } quilted;

static const quilted straight = { 1.0, 1.0 };
static const pattern_word words[] = {
    { "control0", PATTERN_FLOAT, offsetof(quilted, control0), false },
    { "control1", PATTERN_FLOAT, offsetof(quilted, control1), false },
};

SIMD_INLINE double from_middle(double v) { return v - floor(v) - 0.5; }

SIMD_INLINE double height(const quilted *q, double radius)
{
    const double rest = 1.0 - radius;

    return 1.154700538 * (3.0 * q->control0 * radius * rest * rest + 3.0 * q->control1 * radius * radius * rest +
                          radius * radius * radius);
}

SIMD_CLONES static void find_bump(const quilted *q, const vec_lanes *restrict at, uint32_t n, vec_lanes *restrict bump)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = from_middle(at->x[i]), y = from_middle(at->y[i]), z = from_middle(at->z[i]);
        const double h = height(q, sqrt(x * x + y * y + z * z));

        bump->x[i] = h * x;
        bump->y[i] = h * y;
        bump->z[i] = h * z;
    }
}

SIMD_CLONES static void find(const quilted *q, const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = from_middle(at->x[i]), y = from_middle(at->y[i]), z = from_middle(at->z[i]);

        value[i] = fabs(height(q, sqrt(x * x + y * y + z * z))) * (fabs(x) + fabs(y) + fabs(z)) / 3.0;
    }
}

static void evaluate(const pattern_input *in, double *value)
{
    find(in->of->self, in->at, lanes_whole(in->n), value);
}

static void perturb(const pattern_input *in, double amount, vec_lanes *normal)
{
    vec_lanes bump;

    find_bump(in->of->self, in->at, lanes_whole(in->n), &bump);
    normal_add(&bump, amount, in->n, normal);
}

const pattern_class pattern_quilted = { .keyword = "quilted", .self_size = sizeof(quilted), .self = &straight, .words = words,
                                        .word_count = 2, .flags = PATTERN_UNFOLDED, .evaluate = evaluate, .perturb = perturb };
