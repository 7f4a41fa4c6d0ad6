#include "light/grid.h"

#include "base/elementary.h"
#include "base/simd.h"
#include "light/aim.h"

#include <povtrace/exact.h>

/* ---- weights ---- */

/* POV-Ray halves the grid again and again, and gives a quarter of the weight to each part; where a number of points is
 * odd those in the middle belong to two parts, or four. */
static void share_out(light_grid *g, const uint32_t *counts, const uint32_t *first, const uint32_t *last, double weight)
{
    const uint32_t middle[2][2] = { { (first[0] + last[0]) / 2, (first[0] + last[0] + 1) / 2 },
                                    { (first[1] + last[1]) / 2, (first[1] + last[1] + 1) / 2 } };
    const bool is_cell = last[0] - first[0] < 2 && last[1] - first[1] < 2;

    for (int part = 0; part < 4; part++) {
        const int far_u = part & 1, far_v = part >> 1;

        if (is_cell) {
            g->points[(far_v ? last[1] : first[1]) * counts[0] + (far_u ? last[0] : first[0])].weight += (float)(weight / 4.0);
        } else {
            const uint32_t from[2] = { far_u ? middle[0][1] : first[0], far_v ? middle[1][1] : first[1] };
            const uint32_t to[2] = { far_u ? last[0] : middle[0][0], far_v ? last[1] : middle[1][0] };

            share_out(g, counts, from, to, weight / 4.0);
        }
    }
}

/* From the square -1/2..1/2 to the disc of diameter 1: squares become circles. */
static void round_off(double *u, double *v)
{
    const double most = pov_max(fabs(*u), fabs(*v)), length = sqrt(*u * *u + *v * *v);

    if (length > 0.0) {
        *u *= most / length;
        *v *= most / length;
    }
}

static double along(uint32_t i, uint32_t count) { return count > 1 ? (double)i / (double)(count - 1) - 0.5 : 0.0; }

/* The points that the scene says. Those that jitter do so by half a step to both sides. The square that becomes a disc is a
 * little off the middle, as in POV-Ray. */
static void place_points(light_grid *g, const light *l)
{
    const uint32_t *counts = l->area.counts, first[2] = { 0, 0 }, last[2] = { counts[0] - 1, counts[1] - 1 };
    const bool jitters = (l->flags & LIGHT_JITTER) != 0;
    const double aside = g->rounded ? 1.0 / 1000.0 : 0.0;

    for (uint32_t k = 0; k < g->count; k++) {
        g->points[k].u = along(k % counts[0], counts[0]) + aside;
        g->points[k].v = along(k / counts[0], counts[1]) + aside;
        if (g->rounded && !jitters)
            round_off(&g->points[k].u, &g->points[k].v);
    }
    for (int axis = 0; axis < 2; axis++)
        g->cell[axis] = jitters && counts[axis] > 1 ? 1.0 / (double)(counts[axis] - 1) : 0.0;
    g->rounded = g->rounded && jitters;
    share_out(g, counts, first, last, 1.0);
}

/* The middles of equal cells that the area is divided into. */
static void place_cells(light_grid *g, const uint32_t counts[2])
{
    for (uint32_t k = 0; k < g->count; k++) {
        g->points[k].u = ((double)(k % counts[0]) + 0.5) / (double)counts[0] - 0.5;
        g->points[k].v = ((double)(k / counts[0]) + 0.5) / (double)counts[1] - 0.5;
        g->points[k].weight = 1.0f / (float)g->count;
    }
    for (int axis = 0; axis < 2; axis++)
        g->cell[axis] = counts[axis] > 1 ? 1.0 / (double)counts[axis] : 0.0;
}

/* ---- places ---- */

/* Points that are rounded off come nearer the middle, to this fraction at most. */
static const double most_rounded = 0.70;

grid_part grid_place(const light_grid *g, uint32_t k)
{
    const double at[2] = { g->points[k].u, g->points[k].v };
    grid_part p;

    for (int axis = 0; axis < 2; axis++) {
        const double lo = at[axis] - 0.5 * g->cell[axis], hi = at[axis] + 0.5 * g->cell[axis];

        p.lo[axis] = g->rounded && lo > 0.0 ? most_rounded * lo : lo;
        p.hi[axis] = g->rounded && hi < 0.0 ? most_rounded * hi : hi;
    }
    return p;
}

static grid_part all_places(const light_grid *g)
{
    grid_part all = grid_place(g, 0);

    for (uint32_t k = 1; k < g->count; k++) {
        const grid_part p = grid_place(g, k);

        for (int axis = 0; axis < 2; axis++) {
            all.lo[axis] = pov_min(all.lo[axis], p.lo[axis]);
            all.hi[axis] = pov_max(all.hi[axis], p.hi[axis]);
        }
    }
    return all;
}

/* ---- all of it ---- */

static bool has_beams(const light *l) { return l->type == LIGHT_PARALLEL || l->type == LIGHT_CYLINDER; }

/* Cells of a soft light along an axis: more would be fewer samples of the picture. */
enum { SOFT_CELLS = 2 };

light_grid *grid_create(const env *e, const light *l, bool soft)
{
    const uint32_t *counts = l->area.counts;
    const uint32_t cells[2] = { counts[0] > 1 ? SOFT_CELLS : 1, counts[1] > 1 ? SOFT_CELLS : 1 };
    const size_t count = soft ? (size_t)cells[0] * cells[1] : (size_t)counts[0] * counts[1];
    light_grid *g = env_alloc(e, 1, sizeof *g + count * sizeof *g->points);

    if (!g)
        return NULL;
    g->count = (uint32_t)count;
    g->rounded = (l->flags & (LIGHT_CIRCULAR | LIGHT_ORIENT)) != 0;
    g->moves = soft || (l->flags & (LIGHT_JITTER | LIGHT_ORIENT)) || has_beams(l);
    if (soft)
        place_cells(g, cells);
    else
        place_points(g, l);
    for (uint32_t k = 0; k < g->count; k++)
        g->sum += g->points[k].weight;
    g->all = all_places(g);
    return g;
}

/* ---- directions ---- */

/* The bits of a point, mixed: a number that is as good as random. */
SIMD_INLINE uint64_t mix_in(uint64_t bits, double number)
{
    bits = (bits ^ elementary_bits(number)) * 0x9E3779B97F4A7C15u;
    return bits ^ bits >> 29;
}

SIMD_INLINE uint64_t mix(double x, double y, double z, uint64_t seed)
{
    const uint64_t bits = mix_in(mix_in(mix_in(seed, x), y), z) * 0xBF58476D1CE4E5B9u;

    return bits ^ bits >> 32;
}

/* Anywhere in a cell around `at`. */
SIMD_INLINE double moved(double at, double cell, uint64_t bits)
{
    return at + cell * ((double)(int32_t)(bits & 0xffffff) * 0x1p-24 + (0x1p-25 - 0.5));
}

/* Places along both axes, and what they jitter by. */
typedef struct SIMD_ALIGNED places { double u[LANES_MAX], v[LANES_MAX]; uint64_t seed[LANES_MAX]; } places;

/* Places of points that jitter, for light on `n` points of surfaces. */
SIMD_CLONES static void jitter(const light_grid *g, const vec_lanes *restrict at, uint32_t n, places *restrict io)
{
    const double u_cell = g->cell[0], v_cell = g->cell[1];

    for (uint32_t i = 0; i < n; i++) {
        const uint64_t bits = mix(at->x[i], at->y[i], at->z[i], io->seed[i]);

        io->u[i] = moved(io->u[i], u_cell, bits);
        io->v[i] = moved(io->v[i], v_cell, bits >> 32);
    }
}

/* Directions closer to the z axis than this cosine have a frame by y. */
static const double along_z = 0.99;

/* Two axes across a direction, of the length of the first axis: the frame of POV-Ray, as its shadows show it. */
static void turn(const light *l, pov_vec3 to, pov_vec3 axes[2])
{
    const double size = sqrt(pov_dot(l->area.axes[0], l->area.axes[0]));
    const pov_vec3 across = fabs(to.z) < along_z ? pov_vec3_of(0.0, 0.0, 1.0) : pov_vec3_of(0.0, 1.0, 0.0);
    const pov_vec3 right = pov_unit(pov_cross_product(across, to));

    axes[0] = pov_scale(right, size);
    axes[1] = pov_scale(pov_cross_product(to, right), size);
}

/* The light's position, moved. */
static light_origin moved_origin(const light *l, pov_vec3 move)
{
    const pov_two3 p = pov_two3_of(l->position, l->position_lo);
    pov_two3 q;
    light_origin out;

    q.x = pov_two_add(p.x, pov_two_of(move.x, 0.0));
    q.y = pov_two_add(p.y, pov_two_of(move.y, 0.0));
    q.z = pov_two_add(p.z, pov_two_of(move.z, 0.0));
    out.from = pov_two3_hi(q);
    out.from_lo = pov_two3_lo(q);
    return out;
}

/* From a point of the area, moved from the middle, parallel light goes to where the middle's points at: each has a
 * direction of its own, as in POV-Ray. It begins in the plane across it through that point. */
static pov_vec3 against_beam(const light *l, pov_vec3 to_middle, pov_vec3 move)
{
    const double hardly = 0x1p-100;
    const pov_vec3 back = pov_unit(pov_sub(move, pov_scale(l->axis, l->aim)));
    const double distance = pov_dot(pov_add(to_middle, move), back);

    return pov_scale(back, distance > hardly ? distance : hardly);
}

/* Moves along axes that are the same for all. */
SIMD_CLONES static void move_along(const pov_vec3 axes[2], const double *restrict u, const double *restrict v, uint32_t n,
                                   vec_lanes *restrict move)
{
    const pov_vec3 a = axes[0], b = axes[1];

    for (uint32_t i = 0; i < n; i++) {
        move->x[i] = a.x * u[i] + b.x * v[i];
        move->y[i] = a.y * u[i] + b.y * v[i];
        move->z[i] = a.z * u[i] + b.z * v[i];
    }
}

/* As round_off(). */
SIMD_CLONES static void round_all(double *restrict u, double *restrict v, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const double a = fabs(u[i]), b = fabs(v[i]), length = sqrt(u[i] * u[i] + v[i] * v[i]), by = length > 0.0 ? (a > b ? a : b) / length : 1.0;

        u[i] *= by;
        v[i] *= by;
    }
}

/* Along axes across each direction, as turn() has them. False: some direction is out of the range of squares. */
SIMD_CLONES static bool move_across(double size, const vec_lanes *restrict to, const double *restrict u, const double *restrict v, uint32_t n,
                                    vec_lanes *restrict move)
{
    int64_t in_range = -1;

    for (uint32_t i = 0; i < n; i++) {
        const pov_vec3 t = lanes_at(to, i);
        const double square = pov_dot(t, t), length = sqrt(square);
        const pov_vec3 d = pov_vec3_of(t.x / length, t.y / length, t.z / length);
        const double up = fabs(d.z) < along_z ? 1.0 : 0.0;
        const pov_vec3 right = pov_cross_product(pov_vec3_of(0.0, 1.0 - up, up), d);
        const double by = sqrt(pov_dot(right, right));
        const pov_vec3 a = pov_vec3_of(right.x / by, right.y / by, right.z / by), b = pov_cross_product(d, a);

        lanes_put(move, i, pov_add(pov_scale(pov_scale(a, size), u[i]), pov_scale(pov_scale(b, size), v[i])));
        in_range &= ((square > 1e-238) & (square < 1e238)) ? -1 : 0;
    }
    return in_range != 0;
}

/* As POV-Ray's, grids that turn lie the other way round where their light is reflected: that shows as they are a little off the middle. */
static void turn_round(double *u, double *v, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        u[i] = -u[i];
        v[i] = -v[i];
    }
}

/* The points, from the first lane on. What fills up a vector is the last one. */
static void find_places(const light_grid *g, const uint32_t *k, uint32_t draw, uint32_t n, places *out)
{
    for (uint32_t i = 0; i < lanes_whole(n); i++) {
        const uint32_t point = k[i < n ? i : n - 1];

        out->u[i] = g->points[point].u;
        out->v[i] = g->points[point].v;
        out->seed[i] = (uint64_t)draw << 32 | (point + 1);
    }
}

/* From the middle to these points, for light on `n` points of surfaces; `to` are their directions to the light's position. Up to a
 * whole vector more are filled in. */
static void find_moves(const light *l, const light_grid *g, const uint32_t *k, uint32_t draw, const vec_lanes *at, const vec_lanes *to, uint32_t n,
                       vec_lanes *move)
{
    const uint32_t whole = lanes_whole(n);
    places p;

    find_places(g, k, draw, n, &p);
    if (g->cell[0] > 0.0 || g->cell[1] > 0.0)
        jitter(g, at, whole, &p);
    if (g->rounded)
        round_all(p.u, p.v, whole);
    if (!(l->flags & LIGHT_ORIENT)) {
        move_along(l->area.axes, p.u, p.v, whole, move);
        return;
    }
    if (draw == DRAW_REFLECTED)
        turn_round(p.u, p.v, whole);
    if (move_across(sqrt(pov_dot(l->area.axes[0], l->area.axes[0])), to, p.u, p.v, n, move))
        return;
    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 axes[2];

        turn(l, pov_unit(lanes_at(to, i)), axes);
        lanes_put(move, i, pov_add(pov_scale(axes[0], p.u[i]), pov_scale(axes[1], p.v[i])));
    }
}

/* The light's position along one axis, moved. */
SIMD_CLONES static void move_origins(double position, double position_lo, const double *restrict move, uint32_t n, double *restrict from,
                                     double *restrict from_lo)
{
    for (uint32_t i = 0; i < n; i++) {
        const pov_two q = pov_two_add(pov_two_of(position, position_lo), pov_two_of(move[i], 0.0));

        from[i] = q.hi;
        from_lo[i] = q.lo;
    }
}

/* Points of the area, in double-double. */
typedef struct ends { vec_lanes from, from_lo; } ends;

static void find_ends(const light *l, const vec_lanes *move, uint32_t n, ends *out)
{
    const pov_vec3 p = l->position, p_lo = l->position_lo;

    move_origins(p.x, p_lo.x, move->x, lanes_whole(n), out->from.x, out->from_lo.x);
    move_origins(p.y, p_lo.y, move->y, lanes_whole(n), out->from.y, out->from_lo.y);
    move_origins(p.z, p_lo.z, move->z, lanes_whole(n), out->from.z, out->from_lo.z);
}

/* Directions to points that move. */
static void aim_moved(const light *l, const light_points *at, const vec_lanes *to, const vec_lanes *move, vec_lanes *dir)
{
    const light_origin middle = light_own_origin(l);

    if (has_beams(l)) {
        light_aim(&middle, at, dir);
        for (uint32_t i = 0; i < at->n; i++)
            lanes_put(dir, i, against_beam(l, lanes_at(dir, i), lanes_at(move, i)));
        return;
    }
    for (uint32_t i = 0; i < lanes_whole(at->n); i++) {
        dir->x[i] = to->x[i] + move->x[i];
        dir->y[i] = to->y[i] + move->y[i];
        dir->z[i] = to->z[i] + move->z[i];
    }
}

void grid_aim(const light *l, const light_grid *g, const uint32_t *k, uint32_t draw, const light_points *at, const vec_lanes *to, vec_lanes *dir,
              light_origin *out)
{
    vec_lanes move;
    ends e;

    find_moves(l, g, k, draw, at->point, to, at->n, &move);
    if (out || !g->moves)
        find_ends(l, &move, at->n, &e);
    if (g->moves)
        aim_moved(l, at, to, &move, dir);
    else
        light_aim_each(&e.from, &e.from_lo, at, dir);
    for (uint32_t i = 0; out && i < at->n; i++)
        out[i] = (light_origin){ lanes_at(&e.from, i), lanes_at(&e.from_lo, i) };
}

light_origin grid_origin(const light *l, const light_grid *g, uint32_t k)
{
    return moved_origin(l, pov_add(pov_scale(l->area.axes[0], g->points[k].u), pov_scale(l->area.axes[1], g->points[k].v)));
}

uint32_t grid_draw(const light_grid *g, double u)
{
    double sum = 0.0;
    uint32_t k = 0;

    for (; k + 1 < g->count; k++) {
        sum += (double)g->points[k].weight;
        if (u < sum)
            break;
    }
    return k;
}

void grid_axes(const light *l, pov_vec3 to, pov_vec3 axes[2])
{
    axes[0] = l->area.axes[0];
    axes[1] = l->area.axes[1];
    if (l->flags & LIGHT_ORIENT)
        turn(l, pov_unit(to), axes);
}
