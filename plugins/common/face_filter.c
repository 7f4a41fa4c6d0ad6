#include "common/face_filter.h"

#include "common/floats.h"

/* With W the largest coordinate of the point: a corner, below 2, and the point are rounded to floats, then their
 * difference is, which loses (4 + 2 W) e. The slope is at most one; it and its product lose (8 + 4 W) e. Their difference
 * is off by less than (16 + 8 W) e. What doubles lose is far less. */
common_face_view common_face_view_of(const common_view *v)
{
    const double w = fmax(fmax(fabs(v->w[0]), fabs(v->w[1])), fabs(v->w[2]));
    common_face_view f = { v->across, v->up, v->forward, { (float)v->w[0], (float)v->w[1], (float)v->w[2] },
                           (float)(v->d[v->across] / v->d[v->forward]), (float)(v->d[v->up] / v->d[v->forward]),
                           v->exact ? HUGE_VALF : 24.0f * COMMON_E * (1.0f + (float)w) };

    return f;
}

static void put_corner(float *row, uint32_t count, pov_vec3 v)
{
    row[0] = (float)v.x;
    row[count] = (float)v.y;
    row[2 * (size_t)count] = (float)v.z;
}

void common_face_put(float *block, uint32_t count, uint32_t i, pov_vec3 a, pov_vec3 b, pov_vec3 c)
{
    put_corner(block + i, count, a);
    put_corner(block + 3 * (size_t)count + i, count, b);
    put_corner(block + 6 * (size_t)count + i, count, c);
}

typedef struct seen { float across, up; } seen;

COMMON_INLINE seen see(const float *across, const float *up, const float *forward, const common_face_view *v)
{
    const float depth = *forward - v->point[v->forward];
    const seen s = { (*across - v->point[v->across]) - depth * v->slope_across,
                     (*up - v->point[v->up]) - depth * v->slope_up };

    return s;
}

COMMON_INLINE float turn(seen a, seen b) { return a.across * b.up - a.up * b.across; }

COMMON_INLINE float size_of(seen a) { return fabsf(a.across) + fabsf(a.up); }

/* Missed if one edge certainly passes on the left, and one on the right. */
COMMON_CLONES static uint32_t filter(const float *a, const float *b, const float *c, size_t across, size_t up,
                                     size_t forward, const common_face_view *v)
{
    const common_face_view view = *v;
    common_outcomes maybe;
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const seen p = see(a + across + i, a + up + i, a + forward + i, &view);
        const seen q = see(b + across + i, b + up + i, b + forward + i, &view);
        const seen r = see(c + across + i, c + up + i, c + forward + i, &view);
        const float size = size_of(p) + size_of(q) + size_of(r);
        const float doubt = size * (view.error + 8.0f * COMMON_E * size) + 2.0f * view.error * view.error;
        const float one = turn(p, q), two = turn(q, r), three = turn(r, p);
        const float least = common_float_lesser(common_float_lesser(one, two), three);
        const float most = common_float_greater(common_float_greater(one, two), three);

        maybe.lane[i] = -!((int)(least < -doubt) & (int)(most > doubt));
    }
    return common_bits_of(&maybe, POV_BLOCK_MAX);
}

uint32_t common_face_filter(const float *block, uint32_t count, uint32_t first, const common_face_view *v)
{
    const float *a = block + first;
    const size_t n = count;
    const uint32_t left = count - first;
    const uint32_t maybe = filter(a, a + 3 * n, a + 6 * n, (size_t)v->across * n, (size_t)v->up * n,
                                  (size_t)v->forward * n, v);

    return left < POV_BLOCK_MAX ? maybe & ((1u << left) - 1) : maybe;
}

/* ---- cells ---- */

void common_cell_put(float *block, uint32_t count, uint32_t i, const pov_vec3 corner[4])
{
    for (size_t k = 0; k < 4; k++)
        put_corner(block + 3 * k * count + i, count, corner[k]);
}

typedef struct cell_outcomes { common_outcomes first, second; } cell_outcomes;

COMMON_INLINE int32_t may_pass(float one, float two, float three, float doubt)
{
    const float least = common_float_lesser(common_float_lesser(one, two), three);
    const float most = common_float_greater(common_float_greater(one, two), three);

    return -!((int)(least < -doubt) & (int)(most > doubt));
}

COMMON_CLONES static void filter_cells(const float *restrict a, size_t row, const common_face_view *restrict v, cell_outcomes *restrict out)
{
    const common_face_view view = *v;
    const float *across = a + (size_t)v->across * row, *up = a + (size_t)v->up * row, *forward = a + (size_t)v->forward * row;

    for (uint32_t i = 0; i < POV_BLOCK_MAX; i++) {
        const seen p = see(across + i, up + i, forward + i, &view), q = see(across + 3 * row + i, up + 3 * row + i, forward + 3 * row + i, &view);
        const seen r = see(across + 6 * row + i, up + 6 * row + i, forward + 6 * row + i, &view);
        const seen s = see(across + 9 * row + i, up + 9 * row + i, forward + 9 * row + i, &view);
        const float size = size_of(p) + size_of(q) + size_of(r) + size_of(s);
        const float doubt = size * (view.error + 8.0f * COMMON_E * size) + 2.0f * view.error * view.error, shared = turn(p, s);

        out->first.lane[i] = may_pass(turn(p, q), turn(q, s), -shared, doubt);
        out->second.lane[i] = may_pass(shared, turn(s, r), turn(r, p), doubt);
    }
}

uint32_t common_cell_filter(const float *block, uint32_t count, uint32_t first, const common_face_view *v, uint32_t *second)
{
    const uint32_t left = count - first, some = left < POV_BLOCK_MAX ? (1u << left) - 1 : (1u << POV_BLOCK_MAX) - 1;
    cell_outcomes may;

    filter_cells(block + first, count, v, &may);
    *second = common_bits_of(&may.second, POV_BLOCK_MAX) & some;
    return common_bits_of(&may.first, POV_BLOCK_MAX) & some;
}
