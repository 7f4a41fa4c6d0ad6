#include "texture/normal.h"

#include "texture/blend.h"
#include "texture/points.h"

#include <povtrace/exact.h>

SIMD_CLONES static void add_lanes(const vec_lanes *restrict bump, double amount, uint32_t n, vec_lanes *restrict normal)
{
    for (uint32_t i = 0; i < n; i++) {
        normal->x[i] += amount * bump->x[i];
        normal->y[i] += amount * bump->y[i];
        normal->z[i] += amount * bump->z[i];
    }
}

void normal_add(const vec_lanes *bump, double amount, uint32_t n, vec_lanes *normal)
{
    add_lanes(bump, amount, n, normal);
}

/* ---- normals from space to space ---- */

/* The linear part of what takes points to a space, and its cofactors by the determinant: they take normals there. */
typedef struct normal_map { double to[3][3], with[3][3]; } normal_map;

static void multiply(const double a[3][3], double b[3][3])
{
    double product[3][3];

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            product[i][k] = a[i][0] * b[0][k] + a[i][1] * b[1][k] + a[i][2] * b[2][k];
    memcpy(b, product, sizeof product);
}

static double largest(double m[3][3])
{
    double most = 0.0;

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            most = fabs(m[i][k]) > most ? fabs(m[i][k]) : most;
    return most;
}

/* Of the map divided by its largest number, so that nothing leaves the range of double. */
static void invert(normal_map *map)
{
    const double size = largest(map->to);
    pov_vec3 row[3], cofactor[3];
    double determinant;

    for (int i = 0; i < 3; i++)
        row[i] = pov_vec3_of(map->to[i][0] / size, map->to[i][1] / size, map->to[i][2] / size);
    for (int i = 0; i < 3; i++)
        cofactor[i] = pov_cross_product(row[(i + 1) % 3], row[(i + 2) % 3]);
    determinant = pov_dot(row[0], cofactor[0]) * size;
    for (int i = 0; i < 3; i++) {
        map->with[i][0] = cofactor[i].x / determinant;
        map->with[i][1] = cofactor[i].y / determinant;
        map->with[i][2] = cofactor[i].z / determinant;
    }
}

static void map_of(const linear_map *from, normal_map *out)
{
    memcpy(out->to, from->m, sizeof out->to);
    invert(out);
}

/* Of a pattern's own transformations, those between warps too. False: there are none. */
static bool map_of_pattern(const model *m, const pattern *p, normal_map *out)
{
    const inverse_map *first = map_table_at(&m->kept_maps, p->turn ? p->turn : p->map);
    bool has_map = first != NULL;

    memset(out->to, 0, sizeof out->to);
    for (int i = 0; i < 3; i++)
        out->to[i][i] = 1.0;
    if (first)
        memcpy(out->to, first->linear->m, sizeof out->to);
    for (const warp *w = p->warps; w; w = w->next) {
        const double linear[3][3] = { { w->map[0][0], w->map[0][1], w->map[0][2] },
                                      { w->map[1][0], w->map[1][1], w->map[1][2] },
                                      { w->map[2][0], w->map[2][1], w->map[2][2] } };

        if (w->has_map)
            multiply(linear, out->to);
        has_map |= w->has_map;
    }
    if (has_map)
        invert(out);
    return has_map;
}

SIMD_INLINE pov_vec3 enter(const normal_map *map, pov_vec3 v)
{
    return pov_vec3_of(map->with[0][0] * v.x + map->with[0][1] * v.y + map->with[0][2] * v.z,
                       map->with[1][0] * v.x + map->with[1][1] * v.y + map->with[1][2] * v.z,
                       map->with[2][0] * v.x + map->with[2][1] * v.y + map->with[2][2] * v.z);
}

SIMD_INLINE pov_vec3 leave(const normal_map *map, pov_vec3 v)
{
    return pov_vec3_of(map->to[0][0] * v.x + map->to[1][0] * v.y + map->to[2][0] * v.z,
                       map->to[0][1] * v.x + map->to[1][1] * v.y + map->to[2][1] * v.z,
                       map->to[0][2] * v.x + map->to[1][2] * v.y + map->to[2][2] * v.z);
}

SIMD_CLONES static void enter_all(const normal_map *restrict map, uint32_t n, vec_lanes *restrict normal)
{
    for (uint32_t i = 0; i < n; i++)
        lanes_put(normal, i, enter(map, lanes_at(normal, i)));
}

SIMD_CLONES static void leave_all(const normal_map *restrict map, uint32_t n, vec_lanes *restrict normal)
{
    for (uint32_t i = 0; i < n; i++)
        lanes_put(normal, i, leave(map, lanes_at(normal, i)));
}

/* Unit vectors by lane, as pov_unit() makes them. False: some square or component is out of range. */
SIMD_CLONES static bool find_units(uint32_t n, const vec_lanes *restrict v, vec_lanes *restrict unit)
{
    int64_t plain = -1;

    for (uint32_t i = 0; i < n; i++) {
        const double x = v->x[i], y = v->y[i], z = v->z[i], square = x * x + y * y + z * z, length = sqrt(square), inverse = 1.0 / length;
        const int moderate = pov_is_moderate(x) & pov_is_moderate(y) & pov_is_moderate(z);

        plain &= ((square >= 1e-239) & (square <= 1e239) & moderate) ? -1 : 0;
        unit->x[i] = pov_quotient(x, length, inverse);
        unit->y[i] = pov_quotient(y, length, inverse);
        unit->z[i] = pov_quotient(z, length, inverse);
    }
    return plain != 0;
}

static void make_unit(uint32_t n, vec_lanes *normal)
{
    vec_lanes unit;

    if (!find_units(n, normal, &unit))
        for (uint32_t i = 0; i < n; i++)
            lanes_put(&unit, i, pov_unit(lanes_at(normal, i)));
    memcpy(normal->x, unit.x, n * sizeof *unit.x);
    memcpy(normal->y, unit.y, n * sizeof *unit.y);
    memcpy(normal->z, unit.z, n * sizeof *unit.z);
}

/* ---- the slope of values ---- */

/* Between two entries a cubic has their heights and slopes; beyond the ends it is constant. */
static double height_between(const slope_entry *a, const slope_entry *b, double t)
{
    const double rest = 1.0 - t;

    return (double)a->height * rest * rest * (1.0 + 2.0 * t) + (double)b->height * t * t * (3.0 - 2.0 * t) +
           (double)a->slope * t * rest * rest - (double)b->slope * t * t * rest;
}

static double height_of(const normal_node *of, double value)
{
    uint32_t i = of->count - 1;
    double start;

    if (!(value >= (double)of->values[0]))
        return of->slopes[0].height;
    while (i > 0 && value < (double)of->values[i])
        i--;
    if (i + 1 == of->count)
        return of->slopes[i].height;
    start = of->values[i];
    return height_between(&of->slopes[i], &of->slopes[i + 1], (value - start) / ((double)of->values[i + 1] - start));
}

/* The corners of a tetrahedron, at distance 1 from its centre. */
static const pov_vec3 corners[4] = {
    { 0.9428090415820634, -0.3333333333333333, 0.0 },
    { -0.4714045207910317, -0.3333333333333333, 0.816496580927726 },
    { -0.4714045207910317, -0.3333333333333333, -0.816496580927726 },
    { 0.0, 1.0, 0.0 },
};

SIMD_CLONES static void move_lanes(const vec_lanes *restrict at, pov_vec3 by, uint32_t n, vec_lanes *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        out->x[i] = at->x[i] + by.x;
        out->y[i] = at->y[i] + by.y;
        out->z[i] = at->z[i] + by.z;
    }
}

SIMD_CLONES static void add_along(const double *restrict height, pov_vec3 direction, uint32_t n, vec_lanes *restrict normal)
{
    for (uint32_t i = 0; i < n; i++) {
        normal->x[i] += height[i] * direction.x;
        normal->y[i] += height[i] * direction.y;
        normal->z[i] += height[i] * direction.z;
    }
}

/* Four values about each point. */
static void add_slope(const normal_node *of, const pattern_input *in, vec_lanes *normal)
{
    const double accuracy = of->accuracy, factor = -0.1 * (double)of->amount / accuracy;
    SIMD_ALIGNED double value[LANES_MAX];
    pattern_input moved = *in;
    vec_lanes at;

    moved.at = &at;
    for (int k = 0; k < 4; k++) {
        move_lanes(in->at, pov_scale(corners[k], accuracy), lanes_whole(in->n), &at);
        points_values(&moved, value);
        for (uint32_t i = 0; i < in->n && of->count > 0; i++)
            value[i] = height_of(of, value[i]);
        add_along(value, pov_scale(corners[k], factor), in->n, normal);
    }
}

/* ---- nodes: normals are in the space of the points. A list that is not scaled has no members that are ---- */

static void perturb(const model *m, const normal_node *of, const texture_points *points, uint32_t n, bool is_scaled,
                    vec_lanes *normal)
{
    const pattern_class *class = of->pattern->class;
    normal_map map;
    vec_lanes at;
    const bool has_map = map_of_pattern(m, of->pattern, &map);
    pattern_input in;

    points_place(m, of->pattern, points, n, &at, NULL);
    in = points_input(m, of->pattern, points, &at, n);
    if (has_map)
        enter_all(&map, n, normal);
    if (is_scaled)
        make_unit(n, normal);
    if (class->perturb)
        class->perturb(&in, of->amount, normal);
    else
        add_slope(of, &in, normal);
    if (has_map)
        leave_all(&map, n, normal);
    if (is_scaled)
        make_unit(n, normal);
}

static void eval(const model *m, const normal_node *of, const texture_points *points, uint32_t n, bool is_scaled,
                 vec_lanes *normal);

static void add_member(const model *m, const normal_node *member, const blending *b, uint32_t number,
                       const texture_points *points, bool is_scaled, const vec_lanes *normal, vec_lanes *sum)
{
    uint8_t lane[LANES_MAX];
    float share[LANES_MAX];
    texture_points picked;
    vec_lanes own;
    const uint32_t n = blend_lanes(b, number, lane, share);

    if (n == 0)
        return;
    for (uint32_t i = 0; i < n; i++)
        lanes_put(&own, i, lanes_at(normal, lane[i]));
    eval(m, member, points_pick(points, b->n, lane, n, &picked), n, is_scaled, &own);
    for (uint32_t i = 0; i < n; i++)
        lanes_put(sum, lane[i], pov_add(lanes_at(sum, lane[i]), pov_scale(lanes_at(&own, i), share[i])));
}

static void find(const model *m, const normal_node *of, const texture_points *inner, uint32_t n, blending *b)
{
    const pattern_input in = points_input(m, of->pattern, inner, &inner->at, n);
    SIMD_ALIGNED double value[LANES_MAX];

    if (of->blend != BLEND_AVERAGE)
        points_values(&in, value);
    blend_find(b, of->blend, of->values, of->count, value, n);
    blend_mark(b);
}

static void blend_members(const model *m, const normal_node *of, const texture_points *points, uint32_t n,
                          bool is_scaled, vec_lanes *normal)
{
    texture_points inner;
    vec_lanes sum;
    normal_map map;
    blending b;
    const bool has_map = map_of_pattern(m, of->pattern, &map);

    points_enter(m, of->pattern, points, n, &inner);
    find(m, of, &inner, n, &b);
    if (has_map)
        enter_all(&map, n, normal);
    if (is_scaled)
        make_unit(n, normal);
    memset(&sum, 0, sizeof sum);
    for (uint32_t k = 0; k < of->count; k++)
        add_member(m, of->normals[k], &b, k, &inner, is_scaled, normal, &sum);
    if (has_map)
        leave_all(&map, n, &sum);
    make_unit(n, &sum);
    *normal = sum;
}

static void eval(const model *m, const normal_node *of, const texture_points *points, uint32_t n, bool is_scaled,
                 vec_lanes *normal)
{
    if (!of || !of->pattern)
        return;
    is_scaled &= of->is_scaled;
    if (of->blend == BLEND_NONE)
        perturb(m, of, points, n, is_scaled, normal);
    else
        blend_members(m, of, points, n, is_scaled, normal);
}

/* ---- the world ---- */

/* Lanes may belong to several objects. The space of many is the world. */
static void to_objects(const texture_points *points, uint32_t n, vec_lanes *normal, bool back)
{
    const linear_map *last = NULL;
    normal_map map;

    for (uint32_t i = 0; i < n; i++) {
        const linear_map *own = points->linear[i];

        if (!own)
            continue;
        if (own != last)
            map_of(own, &map);
        last = own;
        lanes_put(normal, i, back ? leave(&map, lanes_at(normal, i)) : enter(&map, lanes_at(normal, i)));
    }
}

/* A blend of textures is scaled, whatever its members say: where it matters to them their normals come in as unit ones. */
static void enter_blends(const model *m, const normal_blend *b, uint32_t n, bool is_scaled, vec_lanes *normal)
{
    normal_map map;

    if (!b)
        return;
    enter_blends(m, b->around, n, is_scaled, normal);
    if (map_of_pattern(m, b->pattern, &map))
        enter_all(&map, n, normal);
    if (!is_scaled)
        make_unit(n, normal);
}

static void leave_blends(const model *m, const normal_blend *b, uint32_t n, vec_lanes *normal)
{
    normal_map map;

    for (; b; b = b->around)
        if (map_of_pattern(m, b->pattern, &map))
            leave_all(&map, n, normal);
}

/* Of the normal, or of the outermost blend that it is in. */
static const pattern *outermost(const normal_node *of, const normal_blend *around)
{
    const pattern *last = of ? of->pattern : NULL;

    for (; around; around = around->around)
        last = around->pattern;
    return last;
}

void normal_eval(const model *m, const normal_node *of, const normal_blend *around, const texture_points *points,
                 uint32_t n, vec_lanes *normal)
{
    /* As in POV-Ray. */
    const pattern *first = outermost(of, around);
    const bool turns = !(first && first->uv && !first->uv_turns && points->has_surface);

    if (turns && !points->in_world)
        to_objects(points, n, normal, false);
    enter_blends(m, around, n, !of || of->is_scaled, normal);
    eval(m, of, points, n, true, normal);
    leave_blends(m, around, n, normal);
    if (turns && !points->in_world)
        to_objects(points, n, normal, true);
    make_unit(n, normal);
}
