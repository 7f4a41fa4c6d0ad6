#include "texture/points.h"

#include "texture/warp.h"
#include "texture/wave.h"

#include <povtrace/exact.h>

/* One coordinate: a row of the map times (x, y, z), in double-double. */
static inline pov_two turned(const inverse_map *map, int row, pov_two3 p)
{
    const double *hi = map->linear->m[row], *lo = map->linear->m_lo[row];
    const pov_two x = pov_two_mul(pov_two_of(hi[0], lo[0]), p.x), y = pov_two_mul(pov_two_of(hi[1], lo[1]), p.y);
    const pov_two z = pov_two_mul(pov_two_of(hi[2], lo[2]), p.z);

    return pov_two_add(pov_two_add(x, y), z);
}

/* The same times (x, y, z, 1). */
static inline pov_two along(const inverse_map *map, int row, pov_two3 p)
{
    const double *hi = map->linear->m[row], *lo = map->linear->m_lo[row];
    const pov_two x = pov_two_mul(pov_two_of(hi[0], lo[0]), p.x), y = pov_two_mul(pov_two_of(hi[1], lo[1]), p.y);
    const pov_two z = pov_two_mul(pov_two_of(hi[2], lo[2]), p.z);

    return pov_two_add(pov_two_add(x, y), pov_two_add(z, pov_two_of(map->move[row], map->move_lo[row])));
}

static inline pov_two3 to_space(const inverse_map *map, pov_two3 p)
{
    pov_two3 out;

    out.x = along(map, 0, p);
    out.y = along(map, 1, p);
    out.z = along(map, 2, p);
    return out;
}

/* Does each coordinate come of one alone, as where nothing is turned but by right angles? Then the other products are zeros,
 * and the sums without them the same. */
static bool is_straight(const linear_map *l, int from[3])
{
    double beside = 0.0;

    for (int i = 0; i < 3; i++) {
        from[i] = 0;
        for (int k = 1; k < 3; k++)
            from[i] = fabs(l->m[i][k]) > fabs(l->m[i][from[i]]) ? k : from[i];
        for (int k = 0; k < 3; k++)
            beside += k == from[i] ? 0.0 : fabs(l->m[i][k]) + fabs(l->m_lo[i][k]);
    }
    return beside == 0.0;
}

/* One coordinate, rounded once. There is at least one point. */
SIMD_CLONES SIMD_NOINLINE static void scale_axis(pov_two by, pov_two move, const double *restrict at, const double *restrict at_lo, uint32_t n,
                                   double *restrict out)
{
    uint32_t i = 0;

    do
        out[i] = pov_two_add(pov_two_mul(by, pov_two_of(at[i], at_lo[i])), move).hi;
    while (++i < n);
}

/* The same, with the rest. */
SIMD_CLONES SIMD_NOINLINE static void scale_axis_exactly(pov_two by, pov_two move, const double *restrict at, const double *restrict at_lo, uint32_t n,
                                                         double *restrict out, double *restrict out_lo)
{
    uint32_t i = 0;

    do {
        const pov_two p = pov_two_add(pov_two_mul(by, pov_two_of(at[i], at_lo[i])), move);

        out[i] = p.hi + 0.0;
        out_lo[i] = p.lo;
    } while (++i < n);
}

/* The same where nothing is moved. What would be added is 0, which makes of -0 a 0. */
SIMD_CLONES SIMD_NOINLINE static void scale_axis_only(pov_two by, const double *restrict at, const double *restrict at_lo, uint32_t n,
                                        double *restrict out)
{
    uint32_t i = 0;

    do
        out[i] = pov_two_mul(by, pov_two_of(at[i], at_lo[i])).hi + 0.0;
    while (++i < n);
}

static const double *axis_of(const vec_lanes *l, int axis) { return axis == 0 ? l->x : axis == 1 ? l->y : l->z; }

static void scale_points(const inverse_map *map, const int from[3], const vec_lanes *at, const vec_lanes *at_lo, uint32_t n, vec_lanes *out)
{
    double *const to[3] = { out->x, out->y, out->z };

    for (int i = 0; i < 3; i++) {
        const int k = from[i];
        const pov_two by = pov_two_of(map->linear->m[i][k], map->linear->m_lo[i][k]), move = pov_two_of(map->move[i], map->move_lo[i]);

        if (move.hi == 0.0 && move.lo == 0.0)
            scale_axis_only(by, axis_of(at, k), axis_of(at_lo, k), n, to[i]);
        else
            scale_axis(by, move, axis_of(at, k), axis_of(at_lo, k), n, to[i]);
    }
}

/* The points in the pattern's own space, rounded once. There is at least one: with a loop that tests first, compilers
 * without clones warn of uninitialised lanes. */
SIMD_CLONES SIMD_NOINLINE static void map_points(const inverse_map *restrict map, const vec_lanes *restrict at,
                                   const vec_lanes *restrict at_lo, uint32_t n, vec_lanes *restrict out)
{
    uint32_t i = 0;

    do
        lanes_put(out, i, pov_two3_hi(to_space(map, pov_two3_of(lanes_at(at, i), lanes_at(at_lo, i)))));
    while (++i < n);
}

SIMD_CLONES SIMD_NOINLINE static void map_points_exactly(const inverse_map *restrict map, const vec_lanes *restrict at,
                                           const vec_lanes *restrict at_lo, uint32_t n, vec_lanes *restrict out,
                                           vec_lanes *restrict out_lo)
{
    uint32_t i = 0;

    do {
        const pov_two3 p = to_space(map, pov_two3_of(lanes_at(at, i), lanes_at(at_lo, i)));

        lanes_put(out, i, pov_two3_hi(p));
        lanes_put(out_lo, i, pov_two3_lo(p));
    } while (++i < n);
}

static void copy_lanes(const vec_lanes *from, uint32_t first, uint32_t n, vec_lanes *to, uint32_t place)
{
    memcpy(to->x + place, from->x + first, n * sizeof(double));
    memcpy(to->y + place, from->y + first, n * sizeof(double));
    memcpy(to->z + place, from->z + first, n * sizeof(double));
}

static void scale_some(const inverse_map *map, const int from[3], uint32_t first, uint32_t n, vec_lanes *at, vec_lanes *at_lo)
{
    double *const to[3] = { at->x, at->y, at->z }, *const to_lo[3] = { at_lo->x, at_lo->y, at_lo->z };
    vec_lanes was, was_lo;

    copy_lanes(at, first, n, &was, 0);
    copy_lanes(at_lo, first, n, &was_lo, 0);
    for (int i = 0; i < 3; i++) {
        const int k = from[i];
        const pov_two by = pov_two_of(map->linear->m[i][k], map->linear->m_lo[i][k]), move = pov_two_of(map->move[i], map->move_lo[i]);

        scale_axis_exactly(by, move, axis_of(&was, k), axis_of(&was_lo, k), n, to[i] + first, to_lo[i] + first);
    }
}

/* From other memory: compilers make no vectors of loops that change what they read. */
static void map_some(const inverse_map *map, uint32_t first, uint32_t n, vec_lanes *at, vec_lanes *at_lo)
{
    vec_lanes was, was_lo, out, out_lo;

    copy_lanes(at, first, n, &was, 0);
    copy_lanes(at_lo, first, n, &was_lo, 0);
    map_points_exactly(map, &was, &was_lo, n, &out, &out_lo);
    copy_lanes(&out, 0, n, at, first);
    copy_lanes(&out_lo, 0, n, at_lo, first);
}

void texture_points_map(const inverse_map *map, uint32_t first, uint32_t end, texture_points *io)
{
    int from[3];

    if (map && is_straight(map->linear, from))
        scale_some(map, from, first, end - first, &io->at, &io->at_lo);
    else if (map)
        map_some(map, first, end - first, &io->at, &io->at_lo);
}

/* One coordinate where nothing is moved; 0 is added as it would be, which makes of -0 a 0. */
SIMD_CLONES SIMD_NOINLINE static void turn_axis(const inverse_map *restrict map, int row, const vec_lanes *restrict at,
                                                const vec_lanes *restrict at_lo, uint32_t n, double *restrict out)
{
    uint32_t i = 0;

    do
        out[i] = turned(map, row, pov_two3_of(lanes_at(at, i), lanes_at(at_lo, i))).hi + 0.0;
    while (++i < n);
}

/* The same of two coordinates, where the third counts for nothing: its product is zero, and the sum without it the same. */
SIMD_CLONES SIMD_NOINLINE static void turn_two(pov_two by_a, const double *restrict a, const double *restrict a_lo, pov_two by_b,
                                               const double *restrict b, const double *restrict b_lo, uint32_t n, double *restrict out)
{
    uint32_t i = 0;

    do
        out[i] = pov_two_add(pov_two_mul(by_a, pov_two_of(a[i], a_lo[i])), pov_two_mul(by_b, pov_two_of(b[i], b_lo[i]))).hi + 0.0;
    while (++i < n);
}

/* The columns of a row that count. Returns how many. */
static int find_columns(const linear_map *l, int row, int out[3])
{
    int count = 0;

    for (int k = 0; k < 3; k++) {
        out[count] = k;
        count += l->m[row][k] != 0.0 || l->m_lo[row][k] != 0.0;
    }
    return count;
}

static pov_two number_at(const linear_map *l, int row, int column) { return pov_two_of(l->m[row][column], l->m_lo[row][column]); }

static void turn_points(const inverse_map *map, const vec_lanes *at, const vec_lanes *at_lo, uint32_t n, vec_lanes *out)
{
    double *const to[3] = { out->x, out->y, out->z };
    const linear_map *l = map->linear;

    for (int i = 0; i < 3; i++) {
        int k[3];
        const int count = find_columns(l, i, k);

        if (count == 3)
            turn_axis(map, i, at, at_lo, n, to[i]);
        else if (count == 2)
            turn_two(number_at(l, i, k[0]), axis_of(at, k[0]), axis_of(at_lo, k[0]), number_at(l, i, k[1]), axis_of(at, k[1]),
                     axis_of(at_lo, k[1]), n, to[i]);
        else
            scale_axis_only(number_at(l, i, k[0]), axis_of(at, k[0]), axis_of(at_lo, k[0]), n, to[i]);
    }
}

static bool moves(const inverse_map *map)
{
    double sum = 0.0;

    for (int i = 0; i < 3; i++)
        sum += fabs(map->move[i]) + fabs(map->move_lo[i]);
    return sum != 0.0;
}

static void clear(vec_lanes *l) { memset(l, 0, sizeof *l); }

static void map_all(const inverse_map *map, const texture_points *in, bool uv, uint32_t n, vec_lanes *at, vec_lanes *lo)
{
    const vec_lanes *from = uv ? &in->uv : &in->at, *from_lo = &in->at_lo;
    vec_lanes zero;
    int axes[3];

    if (uv) {
        clear(&zero);
        from_lo = &zero;
    }
    if (map && lo) {
        map_points_exactly(map, from, from_lo, n, at, lo);
    } else if (map && is_straight(map->linear, axes)) {
        scale_points(map, axes, from, from_lo, n, at);
    } else if (map && !moves(map)) {
        turn_points(map, from, from_lo, n, at);
    } else if (map) {
        map_points(map, from, from_lo, n, at);
    } else {
        *at = *from;
        if (lo)
            *lo = *from_lo;
    }
}

void points_place(const model *m, const pattern *p, const texture_points *in, uint32_t n, vec_lanes *at, vec_lanes *lo)
{
    const bool displaces = !turbulence_is_none(&p->turbulence) && !(p->class->flags & PATTERN_OWN_TURBULENCE);

    map_all(map_table_at(&m->kept_maps, p->map), in, p->uv && in->has_surface, n, at, lo);
    for (uint32_t i = n; i < lanes_whole(n); i++)
        lanes_put(at, i, lanes_at(at, n - 1));
    if (p->warps)
        warp_apply(p->warps, m->noise, at, n);
    if (displaces)
        warp_displace(&p->turbulence, m->noise, at, n);
    if (lo && (p->warps || displaces))
        clear(lo);
}

static void copy_surface(const texture_points *in, uint32_t n, texture_points *out)
{
    out->has_surface = in->has_surface;
    if (!in->has_surface)
        return;
    out->has_world = in->has_world;
    if (in->has_world)
        out->world = in->world;
    out->has_uv = in->has_uv;
    if (in->has_uv)
        out->uv = in->uv;
    out->normal = in->normal;
    out->has_view = in->has_view;
    if (in->has_view)
        out->view = in->view;
    out->in_world = in->in_world;
    if (!in->in_world)
        memcpy(out->linear, in->linear, n * sizeof in->linear[0]);
}

void points_enter(const model *m, const pattern *p, const texture_points *in, uint32_t n, texture_points *out)
{
    points_place(m, p, in, n, &out->at, &out->at_lo);
    copy_surface(in, n, out);
}

static void pick(const vec_lanes *in, const uint8_t *lane, uint32_t n, vec_lanes *out)
{
    for (uint32_t i = 0; i < n; i++)
        lanes_put(out, i, lanes_at(in, lane[i]));
}

const texture_points *points_pick(const texture_points *in, uint32_t whole, const uint8_t *lane, uint32_t n, texture_points *memory)
{
    texture_points *const out = memory;

    if (n == whole)
        return in;
    pick(&in->at, lane, n, &out->at);
    pick(&in->at_lo, lane, n, &out->at_lo);
    out->has_surface = in->has_surface;
    if (!in->has_surface)
        return out;
    out->has_world = in->has_world;
    if (in->has_world)
        pick(&in->world, lane, n, &out->world);
    out->has_uv = in->has_uv;
    if (in->has_uv)
        pick(&in->uv, lane, n, &out->uv);
    pick(&in->normal, lane, n, &out->normal);
    out->has_view = in->has_view;
    if (in->has_view)
        pick(&in->view, lane, n, &out->view);
    out->in_world = in->in_world;
    for (uint32_t i = 0; !in->in_world && i < n; i++)
        out->linear[i] = in->linear[lane[i]];
    return out;
}

pattern_input points_input(const model *m, const pattern *p, const texture_points *in, const vec_lanes *at, uint32_t n)
{
    const pattern_input input = { at, n, p, in->has_surface ? &in->normal : NULL, in->has_surface ? &in->view : NULL,
                                  m->noise, p->noise_generator ? p->noise_generator : m->noise_generator,
                                  m->number_of_waves, m, in, NULL };

    return input;
}

void points_begin(const pattern_input *in, texture_points *out)
{
    out->at = *in->at;
    clear(&out->at_lo);
    copy_surface(in->points, in->n, out);
}

void points_values(const pattern_input *in, double *value)
{
    const pattern_class *class = in->of->class;

    if ((class->flags & PATTERN_NEEDS_NORMAL) && !in->normal)
        memset(value, 0, lanes_whole(in->n) * sizeof *value);
    else
        class->evaluate(in, value);
    if (class->flags & PATTERN_UNSHAPED)
        return;
    for (uint32_t i = in->n; i < lanes_whole(in->n); i++)
        value[i] = value[in->n - 1];
    if (class->count == 0 || in->of->wave.frequency != 0.0f || in->of->wave.form != WAVE_RAMP)
        wave_shape(&in->of->wave, in->n, value);
}
