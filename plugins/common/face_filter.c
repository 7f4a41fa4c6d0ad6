#include "common/face_filter.h"

#include "common/floats.h"
#include "common/lanes.h"

/* With W the largest coordinate of the point: a corner, below 2, and the point are rounded to floats, then their
 * difference is, which loses (4 + 2 W) e. The slope is at most one; it and its product lose (8 + 4 W) e. Their difference
 * is off by less than (16 + 8 W) e. What doubles lose is far less. */
common_face_view common_face_view_of(const common_view *v)
{
    const double w = pov_max(pov_max(fabs(v->w[0]), fabs(v->w[1])), fabs(v->w[2]));
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

/* ---- rays side by side ---- */

/* Starts nearer than this need no double-double: the point is then off by less than 2^-35. */
static const double far = 0x1p16;

/* Some rays, and how they see it. */
typedef struct view_lanes { common_rays rays; common_lane w[3], dir[3], near, size; } view_lanes;

/* The point of each ray that is nearest to the anchor, seen from there. */
COMMON_CLONES static void find_points(view_lanes *restrict l, pov_vec3 anchor, double scale)
{
    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const pov_vec3 d = pov_scale(common_get(&l->rays.dir, i), scale);
        const pov_vec3 o = pov_add(pov_sub(common_get(&l->rays.org, i), anchor), common_get(&l->rays.org_lo, i));
        const pov_vec3 f = pov_scale(o, scale);
        const double square = pov_dot(d, d), t = -pov_dot(f, d) / square;

        l->w[0][i] = f.x + t * d.x;
        l->w[1][i] = f.y + t * d.y;
        l->w[2][i] = f.z + t * d.z;
        l->dir[0][i] = d.x;
        l->dir[1][i] = d.y;
        l->dir[2][i] = d.z;
        l->near[i] = t;
        l->size[i] = square > 1e-200 && square < 1e200 ? common_greater(common_greater(fabs(f.x), fabs(f.y)), fabs(f.z)) : HUGE_VAL;
    }
}

COMMON_CLONES static void set_views(const view_lanes *restrict l, common_face_views *restrict v, uint32_t first)
{
    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const double x = l->dir[0][i], y = l->dir[1][i], z = l->dir[2][i];
        const bool is_x = (fabs(x) > fabs(y)) & (fabs(x) > fabs(z)), is_y = !is_x & (fabs(y) > fabs(z));
        const double per = 1.0 / (is_x ? x : is_y ? y : z);
        const double w = common_greater(common_greater(fabs(l->w[0][i]), fabs(l->w[1][i])), fabs(l->w[2][i]));

        v->point[0][first + i] = (float)(is_x ? l->w[1][i] : is_y ? l->w[2][i] : l->w[0][i]);
        v->point[1][first + i] = (float)(is_x ? l->w[2][i] : is_y ? l->w[0][i] : l->w[1][i]);
        v->point[2][first + i] = (float)(is_x ? l->w[0][i] : is_y ? l->w[1][i] : l->w[2][i]);
        v->slope_across[first + i] = (float)((is_x ? y : is_y ? z : x) * per);
        v->slope_up[first + i] = (float)((is_x ? z : is_y ? x : y) * per);
        v->error[first + i] = l->size[i] < far ? 24.0f * COMMON_E * (1.0f + (float)w) : HUGE_VALF;
        v->near[first + i] = l->near[i];
        v->pace[first + i] = per;
        v->forward[first + i] = is_x ? 0 : is_y ? 1 : 2;
    }
}

void common_face_views_make(common_face_views *v, const pov_ray *const *rays, uint32_t n, pov_vec3 anchor, double scale)
{
    const pov_vec3 middle = pov_scale(anchor, common_inverse(scale));
    view_lanes l;

    for (uint32_t i = 0; i < n; i += COMMON_LANES) {
        common_put_four_of(&l.rays, 0, rays + i, n - i);
        common_put_four_of(&l.rays, 4, rays + i, n - i);
        find_points(&l, middle, scale);
        set_views(&l, v, i);
    }
}

void common_face_views_set(common_face_views *v, uint32_t i, const common_view *view, double along, double unit)
{
    const common_face_view f = common_face_view_of(view);

    v->point[0][i] = f.point[f.across];
    v->point[1][i] = f.point[f.up];
    v->point[2][i] = f.point[f.forward];
    v->slope_across[i] = f.slope_across;
    v->slope_up[i] = f.slope_up;
    v->error[i] = f.error;
    v->near[i] = along * unit;
    v->pace[i] = unit / view->d[view->forward];
    v->forward[i] = view->forward;
}

/* What one ray needs of its view, and the rows of its axes. */
typedef struct line { float across, up, forward, slope_across, slope_up, error; const float *x, *y, *z; } line;

COMMON_INLINE line line_of(const float *a, size_t row, const common_face_views *v, uint32_t ray)
{
    const int32_t forward = v->forward[ray], across = forward < 2 ? forward + 1 : 0, up = forward > 0 ? forward - 1 : 2;
    const line l = { v->point[0][ray], v->point[1][ray], v->point[2][ray], v->slope_across[ray], v->slope_up[ray], v->error[ray],
                     a + (size_t)across * row, a + (size_t)up * row, a + (size_t)forward * row };

    return l;
}

COMMON_INLINE seen see_from(const line *l, size_t i)
{
    const float depth = l->z[i] - l->forward;
    const seen s = { (l->x[i] - l->across) - depth * l->slope_across, (l->y[i] - l->up) - depth * l->slope_up };

    return s;
}

/* On which sides of the edges the line passes: turns, their least and greatest, and what they may be off by. */
typedef struct sides { float one, two, three, least, most, doubt; } sides;

COMMON_INLINE sides sides_of(const line *l, size_t row, size_t i)
{
    const seen p = see_from(l, i), q = see_from(l, 3 * row + i), r = see_from(l, 6 * row + i);
    const float size = size_of(p) + size_of(q) + size_of(r);
    sides s = { .one = turn(p, q), .two = turn(q, r), .three = turn(r, p) };

    s.doubt = size * (l->error + 8.0f * COMMON_E * size) + 2.0f * l->error * l->error;
    s.least = common_float_lesser(common_float_lesser(s.one, s.two), s.three);
    s.most = common_float_greater(common_float_greater(s.one, s.two), s.three);
    return s;
}

typedef struct found_lanes { common_outcomes maybe, sure; } found_lanes;

/* The shares of the corners in the point are the turns by their sum. Each is off by less than six doubts by the sum, all
 * together by that too. A depth is off by less than the error. */
COMMON_CLONES static void find(const float *restrict a, size_t row, const common_face_views *restrict v, uint32_t ray,
                               found_lanes *restrict may, float *restrict lo, float *restrict hi)
{
    const line l = line_of(a, row, v, ray);

    for (uint32_t i = 0; i < POV_BLOCK_MAX; i++) {
        const sides s = sides_of(&l, row, i);
        const float pz = l.z[i] - l.forward, qz = l.z[3 * row + i] - l.forward, rz = l.z[6 * row + i] - l.forward;
        const float nearest = common_float_lesser(common_float_lesser(pz, qz), rz);
        const float farthest = common_float_greater(common_float_greater(pz, qz), rz);
        const float per = 1.0f / (s.one + s.two + s.three), depth = (s.two * pz + s.three * qz + s.one * rz) * per;
        const float off = 2.0f * l.error + 12.0f * s.doubt * (farthest - nearest) * fabsf(per);

        may->maybe.lane[i] = -!((int)(s.least < -s.doubt) & (int)(s.most > s.doubt));
        may->sure.lane[i] = -((int)(s.least > s.doubt) | (int)(s.most < -s.doubt));
        lo[i] = common_float_greater(depth - off, nearest - l.error);
        hi[i] = common_float_lesser(depth + off, farthest + l.error);
    }
}

COMMON_CLONES static uint32_t find_any(const float *restrict a, size_t row, const common_face_views *restrict v, uint32_t ray)
{
    const line l = line_of(a, row, v, ray);
    common_outcomes maybe;

    for (uint32_t i = 0; i < POV_BLOCK_MAX; i++) {
        const sides s = sides_of(&l, row, i);

        maybe.lane[i] = -!((int)(s.least < -s.doubt) & (int)(s.most > s.doubt));
    }
    return common_bits_of(&maybe, POV_BLOCK_MAX);
}

static uint32_t bits_left(uint32_t left) { return left < POV_BLOCK_MAX ? (1u << left) - 1 : (1u << POV_BLOCK_MAX) - 1; }

uint32_t common_face_find_any(const float *block, uint32_t count, uint32_t first, const common_face_views *v, uint32_t ray)
{
    return find_any(block + first, count, v, ray) & bits_left(count - first);
}

void common_face_find(const float *block, uint32_t count, uint32_t first, const common_face_views *v, uint32_t ray,
                      common_face_found *out)
{
    const uint32_t some = bits_left(count - first);
    found_lanes may;

    find(block + first, count, v, ray, &may, out->lo, out->hi);
    out->maybe = common_bits_of(&may.maybe, POV_BLOCK_MAX) & some;
    out->sure = common_bits_of(&may.sure, POV_BLOCK_MAX) & out->maybe;
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
