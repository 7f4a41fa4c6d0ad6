#include "texture/noise.h"

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
    for (uint32_t i = 0; i < NOISE_HASH; i++)
        t->last[i] = (uint8_t)t->hash[i];
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

/* ---- the cubes that points stand in ---- */

/* Numbers of a point that are added up side by side: one of four terms at each corner. */
enum { CORNERS = 8, PARTS = 4 };

/* The lattice's cells, the smooth weights of their upper sides, and 1/2 with the places in them. */
typedef struct SIMD_ALIGNED lattice {
    double s[3][LANES_MAX];
    double place[LANES_MAX][PARTS];
    int32_t cell[3][LANES_MAX];
} lattice;

/* What a place is seen from at each corner. */
static const double corner[CORNERS][PARTS] = {
    { 0.0, 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0, 0.0 }, { 0.0, 1.0, 1.0, 0.0 },
    { 0.0, 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0, 1.0 }, { 0.0, 1.0, 1.0, 1.0 },
};

SIMD_INLINE double smooth(double u) { return u * u * (3.0 - 2.0 * u); }

/* What no 32-bit integer holds counts as the lowest one, as POV-Ray's conversion gives. */
SIMD_INLINE double limit(double whole) { return whole >= -2147483648.0 && whole < 2147483648.0 ? whole : -2147483648.0; }

SIMD_INLINE void locate_along(int axis, const double *restrict at, double scale, uint32_t n, lattice *restrict out)
{
    double *restrict s = out->s[axis];
    int32_t *restrict cell = out->cell[axis];

    for (uint32_t i = 0; i < n; i++) {
        const double v = at[i] * scale, whole = limit(floor(v)), u = v - whole;

        s[i] = smooth(u);
        out->place[i][1 + axis] = u;
        cell[i] = (int32_t)whole;
    }
}

SIMD_CLONES static void locate(const vec_lanes *restrict at, double scale, uint32_t n, lattice *restrict out)
{
    for (uint32_t i = 0; i < n; i++)
        out->place[i][0] = 0.5;
    locate_along(0, at->x, scale, n, out);
    locate_along(1, at->y, scale, n, out);
    locate_along(2, at->z, scale, n, out);
}

/* ---- generators 1 and 2, vector noise ---- */

/* The corners' weights. */
SIMD_INLINE void weigh(const lattice *l, uint32_t lane, double w[CORNERS])
{
    const double x = l->s[0][lane], y = l->s[1][lane], z = l->s[2][lane];

    for (int c = 0; c < CORNERS; c++)
        w[c] = (c & 1 ? x : 1.0 - x) * (c & 2 ? y : 1.0 - y) * (c & 4 ? z : 1.0 - z);
}

/* Where the numbers of each corner begin. */
SIMD_INLINE void find_corners(const noise_tables *t, const lattice *l, uint32_t lane, const double *from[CORNERS])
{
    enum { MASK = NOISE_HASH - 1, SHIFT = 10000 };
    const uint32_t x = (uint32_t)l->cell[0][lane] + SHIFT, y = (uint32_t)l->cell[1][lane] + SHIFT;
    const uint32_t z = (uint32_t)l->cell[2][lane] + SHIFT;
    const uint32_t hx[2] = { t->hash[x & MASK], t->hash[(x + 1) & MASK] };

    for (int c = 0; c < CORNERS; c++) {
        const uint32_t hxy = t->hash[hx[c & 1] ^ ((y + (c >> 1 & 1)) & MASK)];

        from[c] = noise_measured + t->last[hxy ^ ((z + (c >> 2)) & MASK)];
    }
}

/* One component: 0, 4 or 8 numbers behind where the corners' begin. Its four parts are yet to be added up: stored side
 * by side, they become one vector. */
SIMD_INLINE void sum_corners(const double w[CORNERS], const double *const from[CORNERS], int offset,
                             const double place[PARTS], double out[PARTS])
{
    double sum[PARTS];

    for (int k = 0; k < PARTS; k++)
        sum[k] = (place[k] - corner[0][k]) * w[0] * from[0][offset + k];
    for (int c = 1; c < CORNERS; c++)
        for (int k = 0; k < PARTS; k++)
            sum[k] += (place[k] - corner[c][k]) * w[c] * from[c][offset + k];
    for (int k = 0; k < PARTS; k++)
        out[k] = sum[k];
}

SIMD_INLINE void join(double parts[][PARTS], uint32_t n, double *restrict out)
{
    for (uint32_t i = 0; i < n; i++)
        out[i] = (parts[i][0] + parts[i][1]) + (parts[i][2] + parts[i][3]);
}

SIMD_CLONES static void sum_scalar(const noise_tables *t, const lattice *l, uint32_t n, double *restrict out)
{
    SIMD_ALIGNED double parts[LANES_MAX][PARTS];

    for (uint32_t i = 0; i < n; i++) {
        const double *from[CORNERS];
        double w[CORNERS];

        find_corners(t, l, i, from);
        weigh(l, i, w);
        sum_corners(w, from, 0, l->place[i], parts[i]);
    }
    join(parts, n, out);
}

SIMD_CLONES static void sum_vector(const noise_tables *t, const lattice *l, uint32_t n, vec_lanes *restrict out)
{
    SIMD_ALIGNED double parts[3][LANES_MAX][PARTS];

    for (uint32_t i = 0; i < n; i++) {
        const double *from[CORNERS];
        double w[CORNERS];

        find_corners(t, l, i, from);
        weigh(l, i, w);
        sum_corners(w, from, 0, l->place[i], parts[0][i]);
        sum_corners(w, from, 4, l->place[i], parts[1][i]);
        sum_corners(w, from, 8, l->place[i], parts[2][i]);
    }
    join(parts[0], n, out->x);
    join(parts[1], n, out->y);
    join(parts[2], n, out->z);
}

/* ---- generator 3 ---- */

/* The shift is so large that it rounds the points: values keep steps of 2^-29 in them. */
SIMD_INLINE void locate_along_3(int axis, const double *restrict at, double scale, uint32_t n, lattice *restrict out)
{
    double *restrict s = out->s[axis];
    int32_t *restrict cell = out->cell[axis];

    for (uint32_t i = 0; i < n; i++) {
        const double v = at[i] * scale + 10000000.023157213, down = floor(v);
        const double whole = limit(v < 0.0 && down < v ? down + 1.0 : down), u = v - whole;

        s[i] = smooth(u);
        out->place[i][1 + axis] = u;
        cell[i] = (int32_t)whole;
    }
}

SIMD_CLONES static void locate_3(const vec_lanes *restrict at, double scale, uint32_t n, lattice *restrict out)
{
    for (uint32_t i = 0; i < n; i++)
        out->place[i][0] = 0.0;
    locate_along_3(0, at->x, scale, n, out);
    locate_along_3(1, at->y, scale, n, out);
    locate_along_3(2, at->z, scale, n, out);
}

SIMD_INLINE void find_corners_3(const noise_tables *t, const lattice *l, uint32_t lane, const double *from[CORNERS])
{
    enum { MASK = NOISE_GRADIENTS - 1 };
    const uint32_t x = (uint32_t)l->cell[0][lane], y = (uint32_t)l->cell[1][lane], z = (uint32_t)l->cell[2][lane];

    for (uint32_t c = 0; c < CORNERS; c++) {
        const uint32_t a = t->order[(x + (c & 1)) & MASK], b = t->order[(a + y + (c >> 1 & 1)) & MASK];

        from[c] = t->gradient[(b + z + (c >> 2)) & MASK];
    }
}

SIMD_CLONES static void sum_gradients(const noise_tables *t, const lattice *l, uint32_t n, double *restrict out)
{
    SIMD_ALIGNED double parts[LANES_MAX][PARTS];

    for (uint32_t i = 0; i < n; i++) {
        const double *from[CORNERS];
        double w[CORNERS];

        find_corners_3(t, l, i, from);
        weigh(l, i, w);
        sum_corners(w, from, 0, l->place[i], parts[i]);
    }
    join(parts, n, out);
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

SIMD_CLONES static void spread(bool clamped, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double v = 2.0 * value[i] - 0.5;

        value[i] = clamped ? clamp(v) : v;
    }
}

void noise_values(const noise_tables *t, int generator, const vec_lanes *at, double scale, uint32_t n, double *value)
{
    const uint32_t whole = lanes_whole(n);
    lattice l;

    if (generator == 3) {
        locate_3(at, scale, whole, &l);
        sum_gradients(t, &l, n, value);
        finish_3(n, value);
        return;
    }
    locate(at, scale, whole, &l);
    sum_scalar(t, &l, n, value);
    finish(generator == 1 ? 0.5 : 1.05242, generator == 1 ? 1.0 : 0.48985582, n, value);
}

void noise_terms(const noise_tables *t, int generator, const vec_lanes *at, double scale, bool clamped, uint32_t n,
                 double *value)
{
    noise_values(t, generator, at, scale, n, value);
    if (generator != 1)
        spread(clamped, n, value);
}

void noise_vectors(const noise_tables *t, const vec_lanes *at, double scale, uint32_t n, vec_lanes *value)
{
    lattice l;

    locate(at, scale, lanes_whole(n), &l);
    sum_vector(t, &l, n, value);
}

/* ---- turbulence ---- */

SIMD_CLONES static void add(double factor, const double *restrict term, uint32_t n, double *restrict sum)
{
    for (uint32_t i = 0; i < n; i++)
        sum[i] += factor * term[i];
}

void noise_turbulence(const noise_tables *t, int generator, const turbulence *of, const vec_lanes *at, uint32_t n,
                      double *value)
{
    SIMD_ALIGNED double term[LANES_MAX];
    double scale = of->lambda, factor = of->omega;

    noise_terms(t, generator, at, 1.0, true, n, value);
    for (uint32_t octave = 1; octave < of->octaves; octave++) {
        noise_terms(t, generator, at, scale, false, n, term);
        add(factor, term, n, value);
        scale *= of->lambda;
        factor *= of->omega;
    }
}

void noise_vector_turbulence(const noise_tables *t, const turbulence *of, const vec_lanes *at, uint32_t n,
                             vec_lanes *value)
{
    double scale = of->lambda, factor = of->omega;
    vec_lanes term;

    noise_vectors(t, at, 1.0, n, value);
    for (uint32_t octave = 1; octave < of->octaves; octave++) {
        noise_vectors(t, at, scale, n, &term);
        add(factor, term.x, n, value->x);
        add(factor, term.y, n, value->y);
        add(factor, term.z, n, value->z);
        scale *= of->lambda;
        factor *= of->omega;
    }
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
    fill_generator_3(t);
    fill_cells(t);
    fill_waves(t, NOISE_WAVES, t->few);
    t->wave = t->few;
    t->waves = NOISE_WAVES;
    return t;
}
