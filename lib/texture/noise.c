#include "texture/noise.h"

#include "texture/noise_sums.h"

#include <math.h>
#include <string.h>

/* ---- tables ---- */

/* 15 bits of a linear congruential generator. */
static uint32_t draw(uint32_t *seed)
{
    *seed = *seed * 1812433253u + 12345u;
    return *seed >> 16 & 0x7fff;
}

static void swap(uint16_t *a, uint16_t *b)
{
    const uint16_t t = *a;

    *a = *b;
    *b = t;
}

static void fill_hash(noise_tables *t)
{
    uint32_t seed = 0;

    for (uint32_t i = 0; i < NOISE_HASH; i++)
        t->hash[i] = (uint16_t)i;
    for (uint32_t i = NOISE_HASH; i-- > 0;)
        swap(&t->hash[i], &t->hash[draw(&seed) % NOISE_HASH]);
    t->hash[NOISE_HASH] = t->hash[0];
}

/* Copy k has the numbers from i on at a multiple of four, where i & 3 is k. */
static void fill_measured(noise_tables *t)
{
    for (uint32_t k = 0; k < NOISE_COPIES; k++)
        memcpy(t->measured[k] + (NOISE_COPIES - k) % NOISE_COPIES, noise_measured, sizeof noise_measured);
    for (uint32_t i = 0; i < NOISE_HASH; i++) {
        const uint32_t from = t->hash[i] & 0xff, k = from % NOISE_COPIES;

        t->last[i] = (uint16_t)(k * NOISE_COPY + from + (NOISE_COPIES - k) % NOISE_COPIES);
    }
}

static pov_vec3 draw_in_sphere(uint32_t *seed)
{
    pov_vec3 v;

    do {
        v.x = ((double)(draw(seed) % 4096) - 2048.0) / 2048.0;
        v.y = ((double)(draw(seed) % 4096) - 2048.0) / 2048.0;
        v.z = ((double)(draw(seed) % 4096) - 2048.0) / 2048.0;
    } while (v.x * v.x + v.y * v.y + v.z * v.z > 1.0);
    return v;
}

/* Only even places are swapped, one of them behind the end: the order is no permutation. */
static void fill_generator_3(noise_tables *t)
{
    uint16_t order[NOISE_GRADIENTS + 1] = { 0 };
    uint32_t seed = 1;

    for (int i = 0; i < NOISE_GRADIENTS; i++) {
        const pov_vec3 v = draw_in_sphere(&seed);
        const double size = sqrt(v.x * v.x + v.y * v.y + v.z * v.z);

        t->gradient[i][1] = v.x / size;
        t->gradient[i][2] = v.y / size;
        t->gradient[i][3] = v.z / size;
        order[i] = (uint16_t)i;
    }
    for (int i = NOISE_GRADIENTS; i > 0; i -= 2)
        swap(&order[i], &order[draw(&seed) % NOISE_GRADIENTS]);
    memcpy(t->order, order, sizeof t->order);
}

/* The Mersenne Twister of Matsumoto and Nishimura (1998), with its default seed. */
enum { TWISTER = 624 };
static void twist(uint32_t *state)
{
    for (int i = 0; i < TWISTER; i++) {
        const uint32_t y = (state[i] & 0x80000000u) | (state[(i + 1) % TWISTER] & 0x7fffffffu);

        state[i] = state[(i + 397) % TWISTER] ^ y >> 1 ^ (y & 1 ? 0x9908b0dfu : 0);
    }
}

static uint32_t temper(uint32_t y)
{
    y ^= y >> 11;
    y ^= y << 7 & 0x9d2c5680u;
    y ^= y << 15 & 0xefc60000u;
    return y ^ y >> 18;
}

static void fill_cells(noise_tables *t)
{
    uint32_t state[TWISTER] = { 5489 };

    for (uint32_t i = 1; i < TWISTER; i++)
        state[i] = 1812433253u * (state[i - 1] ^ state[i - 1] >> 30) + i;
    for (int i = 0; i < NOISE_CELLS; i++) {
        if (i % TWISTER == 0)
            twist(state);
        t->cell[i] = temper(state[i % TWISTER]) / 4294967296.0;
    }
}

/* ---- values ---- */

SIMD_INLINE double clamp(double v) { return !(v > 0.0) ? 0.0 : v < 1.0 ? v : 1.0; }

/* clamp((v + shift) * factor). */
SIMD_CLONES static void finish(double shift, double factor, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = clamp((value[i] + shift) * factor);
}

SIMD_CLONES static void finish_3(uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = clamp(0.4925 + 0.795 * value[i]);
}

static void find_values(const noise_tables *t, int generator, const vec_lanes *at, double scale, bool near, uint32_t n, double *value)
{
    lattice l;

    if (generator == 3) {
        locate_3(at, scale, lanes_whole(n), &l);
        sum_gradients(t, &l, n, value);
        finish_3(n, value);
        return;
    }
    locate(at, scale, near, lanes_whole(n), &l);
    sum_scalar(t, &l, n, value);
    finish(generator == 1 ? 0.5 : 1.05242, generator == 1 ? 1.0 : 0.48985582, n, value);
}

void noise_values(const noise_tables *t, int generator, const vec_lanes *at, double scale, uint32_t n, double *value)
{
    find_values(t, generator, at, scale, is_near(at, scale, lanes_whole(n)), n, value);
}

void noise_vectors(const noise_tables *t, const vec_lanes *at, double scale, uint32_t n, vec_lanes *value)
{
    const uint32_t whole = lanes_whole(n);
    lattice l;

    clear_behind(&l, whole);
    locate(at, scale, is_near(at, scale, whole), whole, &l);
    sum_vector(t, &l, n, value);
}

/* ---- sums over octaves ---- */

/* sum += factor * what noise counts for there. */
SIMD_CLONES static void add_terms(double factor, bool spreads, bool clamped, const double *restrict noise, uint32_t n,
                                  double *restrict sum)
{
    for (uint32_t i = 0; i < n; i++) {
        const double v = spreads ? 2.0 * noise[i] - 0.5 : noise[i];

        sum[i] += factor * (clamped ? clamp(v) : v);
    }
}

SIMD_CLONES static void add_folds(double factor, bool spreads, const double *restrict noise, uint32_t n, double *restrict sum)
{
    for (uint32_t i = 0; i < n; i++)
        sum[i] += factor * fabs(0.5 - clamp(spreads ? 2.0 * noise[i] - 0.5 : noise[i]));
}

void noise_octaves(const noise_tables *t, int generator, const vec_lanes *at, double scale, uint32_t count, bool folds, uint32_t n,
                   double *value)
{
    const bool near = is_near(at, ldexp(scale, (int)count), lanes_whole(n));
    SIMD_ALIGNED double noise[LANES_MAX];
    double octave = 1.0;

    memset(value, 0, n * sizeof *value);
    for (uint32_t i = 0; i < count; i++, octave *= 2.0) {
        find_values(t, generator, at, scale * octave, near, n, noise);
        if (folds)
            add_folds(1.0 / octave, generator != 1, noise, n, value);
        else
            add_terms(0.5 / octave, generator != 1, true, noise, n, value);
    }
}

SIMD_CLONES static void add(double factor, const double *restrict term, uint32_t n, double *restrict sum)
{
    for (uint32_t i = 0; i < n; i++)
        sum[i] += factor * term[i];
}

static bool are_octaves_near(const turbulence *of, const vec_lanes *at, uint32_t n)
{
    double scale = 1.0, most = 1.0;

    for (uint32_t octave = 1; octave < of->octaves; octave++) {
        scale *= of->lambda;
        most = !(fabs(scale) <= most) ? fabs(scale) : most;
    }
    return is_near(at, most, lanes_whole(n));
}

void noise_turbulence(const noise_tables *t, int generator, const turbulence *of, const vec_lanes *at, uint32_t n,
                      double *value)
{
    const bool near = are_octaves_near(of, at, n), spreads = generator != 1;
    SIMD_ALIGNED double noise[LANES_MAX];
    double scale = of->lambda, factor = of->omega;

    memset(value, 0, n * sizeof *value);
    find_values(t, generator, at, 1.0, near, n, noise);
    add_terms(1.0, spreads, true, noise, n, value);
    for (uint32_t octave = 1; octave < of->octaves; octave++) {
        find_values(t, generator, at, scale, near, n, noise);
        add_terms(factor, spreads, false, noise, n, value);
        scale *= of->lambda;
        factor *= of->omega;
    }
}

/* flat: of x and y alone. */
static void add_octaves(const noise_tables *t, const turbulence *of, const vec_lanes *at, uint32_t n, bool flat, vec_lanes *value)
{
    const bool near = are_octaves_near(of, at, n);
    double scale = 1.0, factor = 1.0;
    vec_lanes term;
    lattice l;

    clear_behind(&l, lanes_whole(n));
    for (uint32_t octave = 0; octave == 0 || octave < of->octaves; octave++) {
        vec_lanes *const to = octave == 0 ? value : &term;

        locate(at, scale, near, lanes_whole(n), &l);
        if (flat)
            sum_flat(t, &l, n, to);
        else
            sum_vector(t, &l, n, to);
        if (octave > 0) {
            add(factor, term.x, n, value->x);
            add(factor, term.y, n, value->y);
        }
        if (octave > 0 && !flat)
            add(factor, term.z, n, value->z);
        scale = octave == 0 ? of->lambda : scale * of->lambda;
        factor = octave == 0 ? of->omega : factor * of->omega;
    }
}

void noise_vector_turbulence(const noise_tables *t, const turbulence *of, const vec_lanes *at, uint32_t n,
                             vec_lanes *value)
{
    add_octaves(t, of, at, n, false, value);
}

void noise_flat_turbulence(const noise_tables *t, const turbulence *of, const vec_lanes *at, uint32_t n, vec_lanes *value)
{
    add_octaves(t, of, at, n, true, value);
}

/* ---- one point ---- */

static void fill_lanes(pov_vec3 at, vec_lanes *out)
{
    for (uint32_t i = 0; i < lanes_whole(1); i++)
        lanes_put(out, i, at);
}

double noise_value_at(const noise_tables *t, int generator, pov_vec3 at)
{
    double value[LANES_MAX];
    vec_lanes lanes;

    fill_lanes(at, &lanes);
    noise_values(t, generator, &lanes, 1.0, 1, value);
    return value[0];
}

double noise_turbulence_at(const noise_tables *t, int generator, const turbulence *of, pov_vec3 at)
{
    double value[LANES_MAX];
    vec_lanes lanes;

    fill_lanes(at, &lanes);
    noise_turbulence(t, generator, of, &lanes, 1, value);
    return value[0];
}

pov_vec3 noise_vector_turbulence_at(const noise_tables *t, const turbulence *of, pov_vec3 at)
{
    vec_lanes lanes, value;

    fill_lanes(at, &lanes);
    noise_vector_turbulence(t, of, &lanes, 1, &value);
    return lanes_at(&value, 0);
}

/* ---- ripples and waves ---- */

static void fill_waves(const noise_tables *t, uint32_t count, noise_wave *out)
{
    uint32_t seed = 0xde921401u;
    turbulence one = turbulence_default();

    one.octaves = 1;
    for (uint32_t i = 0; i < count; i++) {
        out[i].source = pov_unit(noise_vector_turbulence_at(t, &one, pov_vec3_of(i, 0.0, 0.0)));
        out[i].frequency = draw(&seed) * 0.000030518509476 + 0.01;
    }
}

bool noise_want_waves(noise_tables *t, arena *memory, uint32_t count)
{
    noise_wave *more;

    if (count <= t->waves)
        return true;
    more = arena_alloc(memory, count * sizeof *more, sizeof(double));
    if (!more)
        return false;
    fill_waves(t, count, more);
    t->wave = more;
    t->waves = count;
    return true;
}

/* ---- making ---- */

noise_tables *noise_create(const env *e)
{
    noise_tables *t = env_alloc_aligned(e, sizeof *t, SIMD_LINE);

    if (!t)
        return NULL;
    fill_hash(t);
    fill_measured(t);
    fill_generator_3(t);
    fill_cells(t);
    fill_waves(t, NOISE_WAVES, t->few);
    t->wave = t->few;
    t->waves = NOISE_WAVES;
    return t;
}
