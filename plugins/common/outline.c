#include "common/outline.h"

#include "common/bernstein.h"
#include "common/simd.h"

#include <string.h>

/* ---- made ---- */

bool common_outline_add(common_outline *o, const pov_host *host, pov_reader *in, const common_piece *piece)
{
    if (o->count == o->capacity) {
        const uint32_t capacity = o->capacity ? 2 * o->capacity : 16;
        common_piece *bigger = host->alloc(in, capacity * sizeof *bigger);

        if (!bigger)
            return false;
        if (o->count > 0)
            memcpy(bigger, o->at, o->count * sizeof *bigger);
        o->at = bigger;
        o->capacity = capacity;
    }
    o->at[o->count++] = *piece;
    return true;
}

static bool is_same(const common_piece *a, const common_piece *b)
{
    const uint32_t n = a->degree;
    bool along = true, back = true;

    for (uint32_t k = 0; k <= n; k++) {
        along &= a->x[k] == b->x[k] && a->y[k] == b->y[k];
        back &= a->x[k] == b->x[n - k] && a->y[k] == b->y[n - k];
    }
    return a->degree == b->degree && (along || back);
}

/* Alike from both ends, and of both zeros. */
static uint64_t hash_of(const common_piece *c)
{
    const double ends[4] = { c->x[0] + 0.0, c->x[c->degree] + 0.0, c->y[0] + 0.0, c->y[c->degree] + 0.0 };
    uint64_t bits[4];

    memcpy(bits, ends, sizeof bits);
    return ((bits[0] + bits[1]) * 0x9e3779b97f4a7c15u ^ (bits[2] + bits[3]) * 0xc2b2ae3d27d4eb4fu) * 0xff51afd7ed558ccdu >> 32;
}

/* Pieces without a degree are gone. */
static void close_gaps(common_outline *o)
{
    uint32_t left = 0;

    for (uint32_t i = 0; i < o->count; i++)
        if (o->at[i].degree > 0)
            o->at[left++] = o->at[i];
    o->count = left;
}

void common_outline_cancel(common_outline *o, const pov_host *host, pov_reader *in)
{
    uint32_t size = 16, *table;     /* numbers of pieces, from 1 on */

    while (size < 2 * o->count)
        size *= 2;
    table = host->alloc(in, size * sizeof *table);
    if (!table)
        return;
    memset(table, 0, size * sizeof *table);
    for (uint32_t i = 0; i < o->count; i++) {
        uint32_t place = (uint32_t)hash_of(&o->at[i]) & (size - 1);

        while (table[place] && !(o->at[table[place] - 1].degree > 0 && is_same(&o->at[table[place] - 1], &o->at[i])))
            place = (place + 1) & (size - 1);
        if (table[place])
            o->at[table[place] - 1].degree = o->at[i].degree = 0;
        else
            table[place] = i + 1;
    }
    close_gaps(o);
}

void common_outline_bound(common_outline *o)
{
    o->lo[0] = o->lo[1] = HUGE_VAL;
    o->hi[0] = o->hi[1] = -HUGE_VAL;
    for (uint32_t i = 0; i < o->count; i++) {
        common_bernstein_widen(o->at[i].x, (int)o->at[i].degree, &o->lo[0], &o->hi[0]);
        common_bernstein_widen(o->at[i].y, (int)o->at[i].degree, &o->lo[1], &o->hi[1]);
    }
}

void common_outline_place(common_outline *o, const double middle[2], double scale)
{
    for (uint32_t i = 0; i < o->count; i++)
        for (uint32_t k = 0; k <= o->at[i].degree; k++) {
            o->at[i].x[k] = (o->at[i].x[k] - middle[0]) * scale;
            o->at[i].y[k] = (o->at[i].y[k] - middle[1]) * scale;
        }
    common_outline_bound(o);
}

/* Pieces that are tested side by side. */
enum { SIDE = POV_BLOCK_MAX };

static void find_across(const common_piece *c, double out[2])
{
    const pov_vec3 unit = pov_unit(pov_vec3_of(c->y[1] - c->y[0], -(c->x[1] - c->x[0]), 0.0));

    out[0] = unit.x;
    out[1] = unit.y;
}

static void raise(const double *b, uint32_t degree, double out[4])
{
    for (uint32_t k = 0; k < 4; k++) {
        const double share = k / 3.0;

        out[k] = degree == 3 ? b[k] : k == 0 ? b[0] : share * b[k - 1] + (1.0 - share) * b[k < 3 ? k : 2];
    }
}

bool common_outline_pack(common_outline *o, const pov_host *host, pov_reader *in)
{
    o->stride = (o->count + SIDE - 1) / SIDE * SIDE;
    o->points = 0;
    for (uint32_t i = 0; i < o->count; i++)
        o->points = o->at[i].degree + 1 > o->points ? o->at[i].degree + 1 : o->points;
    o->rows = host->alloc(in, 2 * (size_t)o->points * o->stride * sizeof *o->rows);
    for (uint32_t k = 0; o->rows && k < o->points; k++)
        for (uint32_t i = 0; i < o->count; i++) {
            const common_piece *c = &o->at[i];

            o->rows[(2 * k) * o->stride + i] = c->x[k < c->degree ? k : c->degree];
            o->rows[(2 * k + 1) * o->stride + i] = c->y[k < c->degree ? k : c->degree];
        }
    o->across = host->alloc(in, o->count * sizeof *o->across);
    o->cubic = host->alloc(in, o->count * sizeof *o->cubic);
    for (uint32_t i = 0; o->across && o->cubic && i < o->count; i++)
        if (o->at[i].degree == 1) {
            find_across(&o->at[i], o->across[i]);
        } else {
            raise(o->at[i].x, o->at[i].degree, o->cubic[i][0]);
            raise(o->at[i].y, o->at[i].degree, o->cubic[i][1]);
        }
    return o->rows && o->across && o->cubic;
}

/* ---- pieces ---- */

static double blend(const double *b, uint32_t degree, double u, double *slope)
{
    const double v = 1.0 - u;

    if (degree == 1) {
        *slope = b[1] - b[0];
        return b[0] * v + b[1] * u;
    }
    if (degree == 2) {
        *slope = 2.0 * ((b[1] - b[0]) * v + (b[2] - b[1]) * u);
        return (b[0] * v + 2.0 * b[1] * u) * v + b[2] * u * u;
    }
    *slope = 3.0 * (((b[1] - b[0]) * v + 2.0 * (b[2] - b[1]) * u) * v + (b[3] - b[2]) * u * u);
    return ((b[0] * v + 3.0 * b[1] * u) * v + 3.0 * b[2] * u * u) * v + b[3] * u * u * u;
}

void common_piece_at(const common_piece *piece, double u, double point[2], double tangent[2])
{
    point[0] = blend(piece->x, piece->degree, u, &tangent[0]);
    point[1] = blend(piece->y, piece->degree, u, &tangent[1]);
}

/* Roots of a piece's Bernstein coefficients: none, where all lie on one side. */
static uint32_t roots_of(const double *b, uint32_t degree, double *root)
{
    bool above = b[0] >= 0.0, same = true;

    for (uint32_t i = 1; i <= degree; i++)
        same &= (b[i] >= 0.0) == above;
    return same ? 0 : common_bernstein_roots(b, (int)degree, common_bernstein_noise(b, (int)degree), root);
}

/* ---- along a line ---- */

/* Member by member: a structure that has just been stored so and is then read as a whole has to wait for it. */
static void put(common_cross *out, double s, double u, uint32_t piece)
{
    out->s = s;
    out->u = u;
    out->piece = piece;
}

static void sort_in(common_cross *out, uint32_t count, double s, double u, uint32_t piece)
{
    while (count > 0 && out[count - 1].s > s) {
        put(&out[count], out[count - 1].s, out[count - 1].u, out[count - 1].piece);
        count--;
    }
    put(&out[count], s, u, piece);
}

/* On which side of the line a point lies. */
static inline double side_of(double x, double y, const double p[2], const double d[2])
{
    return (x - p[0]) * d[1] - (y - p[1]) * d[0];
}

/* Of pieces side by side, of so many points each, those that have points on both sides of the line m.x x + m.y + m.z y = 0: the products first. */
COMMON_INLINE uint32_t find_straddling(const double *restrict x, size_t stride, uint32_t points, pov_vec3 m)
{
    common_bits both;

    COMMON_LOOP for (size_t l = 0; l < SIDE; l++) {
        double most = -HUGE_VAL, least = HUGE_VAL;

        COMMON_UNROLLED for (uint32_t k = 0; k < points; k++) {
            const double b = m.x * x[2 * k * stride + l] + m.y + m.z * x[(2 * k + 1) * stride + l];

            most = common_greater(b, most);
            least = common_lesser(b, least);
        }
        both.lane[l] = -((int)(most >= 0.0) & (int)(least < 0.0));
    }
    return common_gather_bits(&both);
}

/* Which of the pieces from `first` on have points on both sides: a bit each. */
static uint32_t straddling_plane(const common_outline *o, uint32_t first, pov_vec3 m)
{
    switch (o->points) {
    case 2: return find_straddling(o->rows + first, o->stride, 2, m);
    case 3: return find_straddling(o->rows + first, o->stride, 3, m);
    default: return find_straddling(o->rows + first, o->stride, 4, m);
    }
}

/* The same by side_of(). */
COMMON_INLINE uint32_t find_straddling_line(const double *restrict x, size_t stride, uint32_t points, const double p[2], const double d[2])
{
    const double px = p[0], py = p[1], dx = d[0], dy = d[1];
    common_bits both;

    COMMON_LOOP for (size_t l = 0; l < SIDE; l++) {
        double most = -HUGE_VAL, least = HUGE_VAL;

        COMMON_UNROLLED for (uint32_t k = 0; k < points; k++) {
            const double b = (x[2 * k * stride + l] - px) * dy - (x[(2 * k + 1) * stride + l] - py) * dx;

            most = common_greater(b, most);
            least = common_lesser(b, least);
        }
        both.lane[l] = -((int)(most >= 0.0) & (int)(least < 0.0));
    }
    return common_gather_bits(&both);
}

static uint32_t straddling(const common_outline *o, uint32_t first, const double p[2], const double d[2])
{
    if (o->points == 3)
        return find_straddling_line(o->rows + first, o->stride, 3, p, d);
    return find_straddling_line(o->rows + first, o->stride, 4, p, d);
}

/* The line, with what is needed of it: the range is wider by far more than places along it are off. */
typedef struct tested { double p[2], d[2], square, lo, hi; } tested;

static tested tested_of(const double p[2], const double d[2], const double range[2])
{
    const double square = d[0] * d[0] + d[1] * d[1], size = 0x1p-40 * (1.0 + fabs(p[0]) + fabs(p[1])) * (fabs(d[0]) + fabs(d[1]));
    const tested t = { { p[0], p[1] }, { d[0], d[1] }, square, range[0] * square - size - 0x1p-40 * fabs(range[0] * square),
                       range[1] * square + size + 0x1p-40 * fabs(range[1] * square) };

    return t;
}

/* Where all points of the piece lie: -1 before the range, 1 behind it. */
static int place_of(const common_piece *c, const tested *t)
{
    bool before = true, behind = true;

    for (uint32_t k = 0; k <= c->degree; k++) {
        const double s = (c->x[k] - t->p[0]) * t->d[0] + (c->y[k] - t->p[1]) * t->d[1];

        before &= s < t->lo;
        behind &= s > t->hi;
    }
    return behind - before;
}

/* Of a piece with points on both sides. */
static uint32_t cross_piece(const common_outline *o, uint32_t i, const tested *t, common_cross *out, uint32_t count)
{
    const common_piece *c = &o->at[i];
    double b[4], root[3], point[2], tangent[2];
    uint32_t n = 1;

    for (uint32_t k = 0; k <= c->degree; k++)
        b[k] = side_of(c->x[k], c->y[k], t->p, t->d);
    if (c->degree == 1)
        root[0] = b[0] / (b[0] - b[1]);
    else
        n = roots_of(b, c->degree, root);
    for (uint32_t k = 0; k < n; k++) {
        common_piece_at(c, root[k], point, tangent);
        sort_in(out, count++, ((point[0] - t->p[0]) * t->d[0] + (point[1] - t->p[1]) * t->d[1]) / t->square, root[k], i);
    }
    return count;
}

/* How often the line crosses a piece: even or odd. */
static bool is_crossed_oddly(const common_piece *c, const tested *t)
{
    return (side_of(c->x[0], c->y[0], t->p, t->d) >= 0.0) != (side_of(c->x[c->degree], c->y[c->degree], t->p, t->d) >= 0.0);
}

/* Of straight pieces side by side: on which sides of the line their ends lie, and a bit for each that is crossed, and is certainly before the
 * range, or may be in it. */
typedef struct straight_lanes { double from[SIDE], to[SIDE]; uint32_t before, open; } straight_lanes;

static void cross_lanes(const common_outline *o, uint32_t first, const tested *restrict t, straight_lanes *restrict out)
{
    const double *x = o->rows + first, *y = x + o->stride, *next_x = y + o->stride, *next_y = next_x + o->stride;
    const double px = t->p[0], py = t->p[1], dx = t->d[0], dy = t->d[1], lo = t->lo, hi = t->hi;
    common_bits before, open;

    for (int l = 0; l < SIDE; l++) {
        const double a = x[l] - px, b = y[l] - py, c = next_x[l] - px, d = next_y[l] - py, from = a * dy - b * dx, to = c * dy - d * dx;
        const double s = a * dx + b * dy, e = c * dx + d * dy;
        const int crossed = (int)(from >= 0.0) ^ (int)(to >= 0.0), early = (int)(s < lo) & (int)(e < lo), late = (int)(s > hi) & (int)(e > hi);

        out->from[l] = from;
        out->to[l] = to;
        before.lane[l] = -(crossed & early);
        open.lane[l] = -(crossed & (early ^ 1) & (late ^ 1));
    }
    out->before = common_gather_bits(&before);
    out->open = common_gather_bits(&open);
}

/* As cross_piece(), with the sides of its ends. */
static uint32_t cross_straight(const common_piece *c, uint32_t i, const tested *t, double from, double to, common_cross *out, uint32_t count)
{
    const double u = from / (from - to), v = 1.0 - u, x = c->x[0] * v + c->x[1] * u, y = c->y[0] * v + c->y[1] * u;

    sort_in(out, count, ((x - t->p[0]) * t->d[0] + (y - t->p[1]) * t->d[1]) / t->square, u, i);
    return count + 1;
}

static uint32_t cross_all_straight(const common_outline *o, const tested *t, common_cross *out, bool *odd)
{
    uint32_t count = 0;

    for (uint32_t first = 0; first < o->count; first += SIDE) {
        straight_lanes l;

        cross_lanes(o, first, t, &l);
        *odd ^= common_count(l.before) % 2;
        for (uint32_t bits = l.open; bits != 0; bits &= bits - 1) {
            const uint32_t k = common_first_lane(bits);

            count = cross_straight(&o->at[first + k], first + k, t, l.from[k], l.to[k], out, count);
        }
    }
    return count;
}

uint32_t common_outline_cross(const common_outline *o, const double p[2], const double d[2], const double range[2],
                              common_cross *out, bool *odd)
{
    const tested t = tested_of(p, d, range);
    uint32_t count = 0;

    if (o->points == 2)
        return cross_all_straight(o, &t, out, odd);
    for (uint32_t first = 0; first < o->count; first += SIDE) {
        for (uint32_t bits = straddling(o, first, p, d); bits != 0; bits &= bits - 1) {
            const uint32_t i = first + common_first_lane(bits);
            const int place = place_of(&o->at[i], &t);

            if (place < 0)
                *odd ^= is_crossed_oddly(&o->at[i], &t);
            else if (place == 0)
                count = cross_piece(o, i, &t, out, count);
        }
    }
    return count;
}

/* Of a piece with points on both sides. */
static uint32_t cross_piece_of_cone(const common_outline *o, uint32_t i, pov_vec3 w, pov_vec3 d, pov_vec3 m, common_cross *out, uint32_t count)
{
    const common_piece *c = &o->at[i];
    double b[4], root[3], point[2], tangent[2];
    uint32_t n;

    for (uint32_t k = 0; k <= c->degree; k++)
        b[k] = m.x * c->x[k] + m.y + m.z * c->y[k];
    n = roots_of(b, c->degree, root);
    for (uint32_t k = 0; k < n; k++) {
        pov_vec3 toward, across;

        common_piece_at(c, root[k], point, tangent);
        toward = pov_vec3_of(point[0], 1.0, point[1]);
        across = pov_cross_product(d, toward);
        sort_in(out, count++, -pov_dot(pov_cross_product(w, toward), across) / pov_dot(across, across), root[k], i);
    }
    return count;
}

/* The line and the apex span a plane; where the outline crosses it, the line crosses the ray from the apex through there. */
uint32_t common_outline_cross_cone(const common_outline *o, pov_vec3 w, pov_vec3 d, common_cross *out)
{
    const pov_vec3 m = pov_cross_product(w, d);
    uint32_t count = 0;

    for (uint32_t first = 0; first < o->count; first += SIDE)
        for (uint32_t bits = straddling_plane(o, first, m); bits != 0; bits &= bits - 1)
            count = cross_piece_of_cone(o, first + common_first_lane(bits), w, d, m, out, count);
    return count;
}

/* ---- inside ---- */

/* Crossings of the piece with the half-line from p along x, counted by the sign of the distance above it. */
static uint32_t count_right(const common_piece *c, const double p[2])
{
    double b[4], root[3], point[2], tangent[2];
    bool left = true, right = true;
    uint32_t n, sum = 0;

    for (uint32_t k = 0; k <= c->degree; k++) {
        b[k] = c->y[k] - p[1];
        left &= c->x[k] <= p[0];
        right &= c->x[k] > p[0];
    }
    if (left)
        return 0;
    if (right)
        return (b[0] >= 0.0) != (b[c->degree] >= 0.0);
    n = roots_of(b, c->degree, root);
    for (uint32_t k = 0; k < n; k++) {
        common_piece_at(c, root[k], point, tangent);
        sum += point[0] > p[0];
    }
    return sum;
}

bool common_outline_inside(const common_outline *o, const double p[2])
{
    uint32_t sum = 0;

    if (!(p[0] >= o->lo[0] && p[0] <= o->hi[0] && p[1] >= o->lo[1] && p[1] <= o->hi[1]))
        return false;
    for (uint32_t i = 0; i < o->count; i++)
        sum += count_right(&o->at[i], p);
    return sum % 2 == 1;
}
