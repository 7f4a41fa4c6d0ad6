/* The first crossings of rays with a sweep, side by side: by the arithmetic of swept.c and outline.c. A lane in which anything is
 * near anything else is not known. */
#include "common/swept.h"

#include "base/elementary.h"
#include "common/bernstein.h"

enum { N = COMMON_ENTRIES, LOW_CAP = 0, HIGH_CAP, PIECES };

/* As in swept.c. */
static const double NEAR = 0x1p-30;
typedef common_by_entry lane;

/* By lane, in the plane: the line p + s d at base + s of the ray, and the square of d. Crossings up to `begin`, which is the near plane or where
 * the ray begins, tell what is inside there; `end` is at the far plane. Distances are certain beyond before and after. `own`: the piece that the ray starts on,
 * below 0 a cap, or infinitely far below. */
typedef struct lines { lane px, py, dx, dy, square, base, begin, end, before, after, near, far, own, leaves; } lines;

/* By lane: the first crossing of the outline beyond `begin`, -1 where what begins there is inside, and above 0 where that is open. */
typedef struct sums { lane s, u, piece, side, open, starts; } sums;

COMMON_INLINE pov_two height_of(const common_entries *l, uint32_t axis, uint32_t i) { return pov_two_of(l->f[2 * axis][i], l->f[2 * axis + 1][i]); }

COMMON_INLINE double about(pov_two height, pov_two from, double along) { return pov_two_sub(height, from).hi / along; }

COMMON_SEPARATE static void find_lines(const common_swept *s, const common_entries *restrict l, lines *restrict n, sums *restrict of)
{
    const uint32_t up = s->axis, other = 3 - up;
    const pov_two low = s->lo, high = s->hi;
    const double first = s->first, count = PIECES + s->outline.count;

    for (uint32_t i = 0; i < N; i++) {
        const double feature = l->own[i] - 1.0 - first, own = feature >= 0.0 ? feature < count ? feature - PIECES : -HUGE_VAL : -HUGE_VAL;
        const double base = own > -HUGE_VAL ? 0.0 : l->lo[i], dx = l->d[0][i], dy = l->d[other][i], along = l->d[up][i], least = l->least[i];
        const pov_two from = height_of(l, up, i), x = height_of(l, 0, i), y = height_of(l, other, i);
        const double a = about(low, from, along), b = about(high, from, along);
        const double near = along > 0.0 ? a : b, far = along > 0.0 ? b : a, begin = near > least ? near : least;
        /* On the near plane, which it does not cross again, or on the far one. */
        const double upward = along > 0.0 ? LOW_CAP - HIGH_CAP : 0.0, enters = own == upward - 1.0 ? 1.0 : 0.0, leaves = own == -2.0 - upward ? 1.0 : 0.0;
        const double before = 0x1p-40 * (1.0 + fabs(base) + fabs(begin)), after = 0x1p-40 * (1.0 + fabs(base) + fabs(far));
        const double parallel = fabs(dx) + fabs(dy) > 0x1p-100 ? fabs(along) > 0x1p-100 ? 0.0 : 1.0 : 1.0;

        n->px[i] = pov_two_along(x, base, dx, l->d_lo[0][i]).hi;
        n->py[i] = pov_two_along(y, base, dy, l->d_lo[other][i]).hi;
        n->dx[i] = dx;
        n->dy[i] = dy;
        n->square[i] = dx * dx + dy * dy;
        n->base[i] = base;
        n->begin[i] = begin;
        n->end[i] = far;
        n->before[i] = before;
        n->after[i] = after;
        n->near[i] = near > least ? 1.0 - enters : 0.0;
        n->own[i] = own;
        n->leaves[i] = leaves;
        n->far[i] = far > begin + before + after ? 1.0 : 0.0;
        of->s[i] = HUGE_VAL;
        of->u[i] = 0.0;
        of->piece[i] = 0.0;
        of->side[i] = 1.0;
        of->open[i] = fabs(near - least) > before ? parallel : enters > 0.0 ? parallel : 1.0;
        of->starts[i] = 0.0;
    }
}

COMMON_SEPARATE static void find_sides(const lines *restrict n, double x, double y, double *restrict out)
{
    for (uint32_t i = 0; i < N; i++)
        out[i] = (x - n->px[i]) * n->dy[i] - (y - n->py[i]) * n->dx[i];
}

COMMON_INLINE bool any_of(const double *flags)
{
    double most[N / 2];

    for (uint32_t i = 0; i < N / 2; i++)
        most[i] = common_greater(flags[i], flags[i + N / 2]);
    return common_greater(common_greater(most[0], most[1]), common_greater(most[2], most[3])) > 0.0;
}

/* Does any line cross the piece between two points, and which? */
COMMON_SEPARATE static bool find_crossed(const double *restrict from, const double *restrict to, double *restrict out)
{
    for (uint32_t i = 0; i < N; i++)
        out[i] = (from[i] >= 0.0) != (to[i] >= 0.0) ? 1.0 : 0.0;
    return any_of(out);
}

/* The line crosses a piece at s, and at u of it, where `crossed`. */
COMMON_INLINE void add(const lines *restrict n, uint32_t i, double crossed, double s, double u, double piece, sums *restrict io)
{
    const double t = n->base[i] + s, begin = n->begin[i], before = n->before[i], own = n->own[i] == piece ? fabs(s) <= NEAR ? crossed : 0.0 : 0.0;
    const double starts = fabs(s) <= before ? own * (1.0 - io->starts[i]) : 0.0, others = crossed - own;
    const double is_before = t < begin - before ? others : starts, is_ahead = t > begin + before ? others : 0.0;
    const double first = s < io->s[i] ? is_ahead : 0.0;

    io->side[i] *= 1.0 - 2.0 * is_before;
    io->open[i] += crossed - (is_before + is_ahead);
    io->starts[i] += starts;
    io->s[i] = first > 0.0 ? s : io->s[i];
    io->u[i] = first > 0.0 ? u : io->u[i];
    io->piece[i] = first > 0.0 ? piece : io->piece[i];
}

COMMON_INLINE double place_of(const lines *restrict n, uint32_t i, double x, double y)
{
    return ((x - n->px[i]) * n->dx[i] + (y - n->py[i]) * n->dy[i]) / n->square[i];
}

COMMON_SEPARATE static void add_straight(const lines *restrict n, const common_piece *c, double piece, const double *restrict from,
                                       const double *restrict to, const double *restrict crossed, sums *restrict io)
{
    const double x0 = c->x[0], y0 = c->y[0], x1 = c->x[1], y1 = c->y[1];

    for (uint32_t i = 0; i < N; i++) {
        const double u = from[i] / (from[i] - to[i]), v = 1.0 - u;

        add(n, i, crossed[i], place_of(n, i, x0 * v + x1 * u, y0 * v + y1 * u), u, piece, io);
    }
}

/* ---- curved pieces ---- */

/* The sides of its points, and where the line may cross it behind `begin`; where that is clearly before it, this is counted. */
COMMON_INLINE void find_curve(const lines *restrict n, const common_piece *c, int degree, uint32_t i, common_bernsteins *restrict out,
                              double *restrict may, sums *restrict io)
{
    const double px = n->px[i], py = n->py[i], dx = n->dx[i], dy = n->dy[i], square = n->square[i];
    const double off = 0x1p-40 * (1.0 + fabs(px) + fabs(py)) * (fabs(dx) + fabs(dy));
    double least = HUGE_VAL, most = -HUGE_VAL, first = HUGE_VAL, last = -HUGE_VAL, largest = 0.0, crossed, is_before, is_behind, odd;

    COMMON_UNROLLED for (int k = 0; k <= degree; k++) {
        const double x = c->x[k] - px, y = c->y[k] - py, b = x * dy - y * dx, a = x * dx + y * dy;

        out->b[k][i] = b;
        least = common_lesser(least, b);
        most = common_greater(most, b);
        first = common_lesser(first, a);
        last = common_greater(last, a);
        largest = common_greater(largest, fabs(b));
    }
    crossed = least < 0.0 ? most >= 0.0 ? 1.0 : 0.0 : 0.0;
    is_before = last < (n->begin[i] - n->before[i] - n->base[i]) * square - off ? crossed : 0.0;
    is_behind = first > (n->end[i] + n->after[i] - n->base[i]) * square + off ? crossed : 0.0;
    odd = (out->b[0][i] >= 0.0) != (out->b[degree][i] >= 0.0) ? is_before : 0.0;
    out->noise[i] = 4.0 * 0x1p-53 * (degree + 1) * largest;
    io->side[i] *= 1.0 - 2.0 * odd;
    may[i] = is_before + is_behind > 0.0 ? 0.0 : crossed;
}

/* Returns whether any line may cross it. */
COMMON_SEPARATE static bool find_cubic(const lines *restrict n, const common_piece *c, common_bernsteins *restrict out, double *restrict may, sums *restrict io)
{
    for (uint32_t i = 0; i < N; i++) {
        find_curve(n, c, 3, i, out, may, io);
        out->beyond[i] = out->within[i] = -HUGE_VAL;
    }
    return any_of(may);
}

COMMON_SEPARATE static bool find_quadratic(const lines *restrict n, const common_piece *c, common_bernsteins *restrict out, double *restrict may,
                                         sums *restrict io)
{
    for (uint32_t i = 0; i < N; i++)
        find_curve(n, c, 2, i, out, may, io);
    return any_of(may);
}

/* As common_piece_at(). */
COMMON_INLINE double blend(const double *b, double u, double v)
{
    return ((b[0] * v + 3.0 * b[1] * u) * v + 3.0 * b[2] * u * u) * v + b[3] * u * u * u;
}

COMMON_SEPARATE static void add_cubic(const lines *restrict n, const common_piece *c, double piece, const double *restrict may,
                                    const common_first_of_bernsteins *restrict at, sums *restrict io)
{
    const double x[4] = { c->x[0], c->x[1], c->x[2], c->x[3] }, y[4] = { c->y[0], c->y[1], c->y[2], c->y[3] };

    for (uint32_t i = 0; i < N; i++) {
        const double u = at->root[i], v = 1.0 - u, crossed = at->found[i] > 0.0 ? may[i] : 0.0;

        io->open[i] += may[i] * (at->open[i] + at->more[i]);
        add(n, i, crossed, place_of(n, i, blend(x, u, v), blend(y, u, v)), u, piece, io);
    }
}

COMMON_INLINE double fraction_of(double a, double b) { return a + b != 0.0 ? a / (a + b) : a; }

COMMON_INLINE double blend_quadratic(const double *b, double u, double v) { return (b[0] * v + 2.0 * b[1] * u) * v + b[2] * u * u; }

/* Both roots at once, as bernstein.c finds them: u, and where `both` v. */
typedef struct two_roots { double u, v, one, both; } two_roots;

COMMON_INLINE two_roots solve_quadratic(const common_bernsteins *restrict of, uint32_t i, double may)
{
    const double b0 = of->b[0][i], b1 = of->b[1][i], b2 = of->b[2][i], d = b1 * b1 - b0 * b2, size = sqrt(d);
    const double from = b0 >= 0.0 ? 1.0 : 0.0, to = b2 >= 0.0 ? 1.0 : 0.0, turns = b1 > 0.0 ? 1.0 - from : from;
    const double both = from == to ? d > 0.0 ? fabs(b1) > of->noise[i] ? turns * may : 0.0 : 0.0 : 0.0, one = from == to ? 0.0 : may;
    const double q = b1 > 0.0 ? -b1 - size : size - b1, positive = q > 0.0 ? 1.0 : 0.0;
    const double p = fraction_of(q, b2), r = fraction_of(b0, q);

    return (two_roots){ both > 0.0 ? common_lesser(p, r) : positive == to ? p : r, common_greater(p, r), one, both };
}

COMMON_SEPARATE static void add_quadratic(const lines *restrict n, const common_piece *c, double piece, const double *restrict may,
                                        const common_bernsteins *restrict of, sums *restrict io)
{
    const double x[3] = { c->x[0], c->x[1], c->x[2] }, y[3] = { c->y[0], c->y[1], c->y[2] };

    for (uint32_t i = 0; i < N; i++) {
        const two_roots r = solve_quadratic(of, i, may[i]);
        const double w = 1.0 - r.u, z = 1.0 - r.v;

        add(n, i, r.both + r.one, place_of(n, i, blend_quadratic(x, r.u, w), blend_quadratic(y, r.u, w)), r.u, piece, io);
        add(n, i, r.both, place_of(n, i, blend_quadratic(x, r.v, z), blend_quadratic(y, r.v, z)), r.v, piece, io);
    }
}

/* ---- all ---- */

static void add_curve(const lines *n, const common_piece *c, double piece, sums *io)
{
    common_first_of_bernsteins at;
    common_bernsteins all;
    lane may;

    if (c->degree == 2 && find_quadratic(n, c, &all, may, io)) {
        add_quadratic(n, c, piece, may, &all, io);
    } else if (c->degree == 3 && find_cubic(n, c, &all, may, io)) {
        common_bernstein_first_many(&all, 3, &at);
        add_cubic(n, c, piece, may, &at, io);
    }
}

static void add_pieces(const common_outline *o, const lines *n, sums *io)
{
    lane sides[2], crossed;
    double *from = sides[0], *to = sides[1], last[2] = { HUGE_VAL, HUGE_VAL };

    for (uint32_t i = 0; i < o->count; i++) {
        const common_piece *c = &o->at[i];
        double *const before = from;

        if (c->degree > 1) {
            add_curve(n, c, i, io);
            continue;
        }
        if (!(c->x[0] == last[0] && c->y[0] == last[1]))
            find_sides(n, c->x[0], c->y[0], from);
        find_sides(n, c->x[1], c->y[1], to);
        if (find_crossed(from, to, crossed))
            add_straight(n, c, i, from, to, crossed, io);
        from = to;
        to = before;
        last[0] = c->x[1];
        last[1] = c->y[1];
    }
}

/* ---- cones ---- */

/* By lane: the ray from its base on, the plane through it and the apex, and where it passes the height of that. */
typedef struct cones { lane wx, wy, wz, dx, dy, dz, mx, my, mz, apex; } cones;

COMMON_SEPARATE static void find_cones(const common_entries *restrict l, const lines *restrict n, cones *restrict c, sums *restrict of)
{
    for (uint32_t i = 0; i < N; i++) {
        const double base = n->base[i], dx = l->d[0][i], dy = l->d[1][i], dz = l->d[2][i];
        const double wx = pov_two_along(height_of(l, 0, i), base, dx, l->d_lo[0][i]).hi, wy = pov_two_along(height_of(l, 1, i), base, dy, l->d_lo[1][i]).hi;
        const double wz = pov_two_along(height_of(l, 2, i), base, dz, l->d_lo[2][i]).hi;
        const pov_vec3 m = pov_cross_product(pov_vec3_of(wx, wy, wz), pov_vec3_of(dx, dy, dz));

        c->wx[i] = wx;
        c->wy[i] = wy;
        c->wz[i] = wz;
        c->dx[i] = dx;
        c->dy[i] = dy;
        c->dz[i] = dz;
        c->mx[i] = m.x;
        c->my[i] = m.y;
        c->mz[i] = m.z;
        c->apex[i] = base - wy / dy;
        of->open[i] = wx == wy * (dx / dy) ? wz == wy * (dz / dy) ? 1.0 : of->open[i] : of->open[i];
    }
}

COMMON_INLINE double place_in(const cones *restrict c, uint32_t i, double x, double y)
{
    const pov_vec3 d = pov_vec3_of(c->dx[i], c->dy[i], c->dz[i]), w = pov_vec3_of(c->wx[i], c->wy[i], c->wz[i]), toward = pov_vec3_of(x, 1.0, y);
    const pov_vec3 across = pov_cross_product(d, toward);

    return -pov_dot(pov_cross_product(w, toward), across) / pov_dot(across, across);
}

/* A line is outside at the height of the apex: what it crosses on one side of that tells where it begins. */
COMMON_INLINE void add_of_cone(const lines *restrict n, const cones *restrict c, uint32_t i, double crossed, double s, double u, double piece, sums *restrict io)
{
    io->side[i] *= n->base[i] + s < c->apex[i] ? 1.0 - 2.0 * crossed : 1.0;
    add(n, i, crossed, s, u, piece, io);
}

/* Returns whether any plane may cross the piece. */
COMMON_INLINE bool cut(const cones *restrict c, const common_piece *p, int degree, common_bernsteins *restrict out, double *restrict may)
{
    const double x[4] = { p->x[0], p->x[1], p->x[2], p->x[3] }, y[4] = { p->y[0], p->y[1], p->y[2], p->y[3] };

    for (uint32_t i = 0; i < N; i++) {
        const double mx = c->mx[i], my = c->my[i], mz = c->mz[i];
        double least = HUGE_VAL, most = -HUGE_VAL;

        COMMON_UNROLLED for (int k = 0; k <= degree; k++) {
            const double b = mx * x[k] + my + mz * y[k];

            out->b[k][i] = b;
            least = common_lesser(least, b);
            most = common_greater(most, b);
        }
        out->noise[i] = 4.0 * 0x1p-53 * (degree + 1) * common_greater(most, -least);
        out->beyond[i] = out->within[i] = -HUGE_VAL;
        may[i] = least < 0.0 ? most >= 0.0 ? 1.0 : 0.0 : 0.0;
    }
    return any_of(may);
}

COMMON_SEPARATE static bool cut_straight(const cones *restrict c, const common_piece *restrict p, common_bernsteins *restrict out, double *restrict may)
{
    return cut(c, p, 1, out, may);
}

COMMON_SEPARATE static bool cut_quadratic(const cones *restrict c, const common_piece *restrict p, common_bernsteins *restrict out, double *restrict may)
{
    return cut(c, p, 2, out, may);
}

COMMON_SEPARATE static bool cut_cubic(const cones *restrict c, const common_piece *restrict p, common_bernsteins *restrict out, double *restrict may)
{
    return cut(c, p, 3, out, may);
}

COMMON_SEPARATE static void add_straight_of_cone(const lines *restrict n, const cones *restrict c, const common_piece *p, double piece,
                                                 const common_bernsteins *restrict of, const double *restrict may, sums *restrict io)
{
    const double x0 = p->x[0], y0 = p->y[0], x1 = p->x[1], y1 = p->y[1];

    for (uint32_t i = 0; i < N; i++) {
        const double b = of->b[0][i], u = b / (b - of->b[1][i]), v = 1.0 - u;

        add_of_cone(n, c, i, may[i], place_in(c, i, x0 * v + x1 * u, y0 * v + y1 * u), u, piece, io);
    }
}

COMMON_SEPARATE static void add_quadratic_of_cone(const lines *restrict n, const cones *restrict c, const common_piece *p, double piece,
                                                  const common_bernsteins *restrict of, const double *restrict may, sums *restrict io)
{
    const double x[3] = { p->x[0], p->x[1], p->x[2] }, y[3] = { p->y[0], p->y[1], p->y[2] };

    for (uint32_t i = 0; i < N; i++) {
        const two_roots r = solve_quadratic(of, i, may[i]);
        const double w = 1.0 - r.u, z = 1.0 - r.v;

        add_of_cone(n, c, i, r.both + r.one, place_in(c, i, blend_quadratic(x, r.u, w), blend_quadratic(y, r.u, w)), r.u, piece, io);
        add_of_cone(n, c, i, r.both, place_in(c, i, blend_quadratic(x, r.v, z), blend_quadratic(y, r.v, z)), r.v, piece, io);
    }
}

COMMON_SEPARATE static void add_cubic_of_cone(const lines *restrict n, const cones *restrict c, const common_piece *p, double piece,
                                              const common_first_of_bernsteins *restrict at, const double *restrict may, sums *restrict io)
{
    const double x[4] = { p->x[0], p->x[1], p->x[2], p->x[3] }, y[4] = { p->y[0], p->y[1], p->y[2], p->y[3] };

    for (uint32_t i = 0; i < N; i++) {
        const double u = at->root[i], v = 1.0 - u, crossed = at->found[i] > 0.0 ? may[i] : 0.0;

        io->open[i] += may[i] * (at->open[i] + at->more[i]);
        add_of_cone(n, c, i, crossed, place_in(c, i, blend(x, u, v), blend(y, u, v)), u, piece, io);
    }
}

static void add_pieces_of_cone(const common_outline *o, const lines *n, const cones *c, sums *io)
{
    for (uint32_t i = 0; i < o->count; i++) {
        const common_piece *const p = &o->at[i];
        common_first_of_bernsteins at;
        common_bernsteins all;
        lane may;

        if (p->degree == 1 && cut_straight(c, p, &all, may)) {
            add_straight_of_cone(n, c, p, i, &all, may, io);
        } else if (p->degree == 2 && cut_quadratic(c, p, &all, may)) {
            add_quadratic_of_cone(n, c, p, i, &all, may, io);
        } else if (p->degree == 3 && cut_cubic(c, p, &all, may)) {
            common_bernstein_first_many(&all, 3, &at);
            add_cubic_of_cone(n, c, p, i, &at, may, io);
        }
    }
}

/* ---- the solid ---- */

/* The near plane, the piece, or the far plane. */
COMMON_SEPARATE static void tell(const common_swept *s, const common_entries *restrict l, const lines *restrict n, const sums *restrict of,
                               common_first_crossings *restrict out)
{
    const uint32_t up = s->axis;
    const pov_two low = s->lo, high = s->hi;
    const double first = s->first;

    for (uint32_t i = 0; i < N; i++) {
        const double inside = of->side[i] < 0.0 ? 1.0 : 0.0, enters = inside * n->near[i], t = n->base[i] + of->s[i], end = n->end[i], off = n->after[i];
        const double leaves = t > end + off ? inside * (1.0 - enters) : 0.0, crosses = t < end - off ? 1.0 - enters : 0.0, upward = l->d[up][i] > 0.0 ? 1.0 : 0.0;
        const double misses = n->far[i] > 0.0 ? t > end + off ? 1.0 - inside : 0.0 : end + off < n->begin[i] - n->before[i] ? 1.0 : n->leaves[i];
        const double to_high = enters > 0.0 ? 1.0 - upward : upward, cap = enters + leaves;
        const pov_two from = height_of(l, up, i), along = pov_two_of(l->d[up][i], l->d_lo[up][i]);
        const pov_two height = pov_two_of(to_high > 0.0 ? high.hi : low.hi, to_high > 0.0 ? high.lo : low.lo);
        const pov_two plane = pov_two_div(pov_two_sub(height, from), along), piece = pov_two_sum(n->base[i], of->s[i]);

        out->known[i] = of->open[i] > 0.0 ? 0.0 : n->far[i] * (cap + crosses) + misses;
        out->t[i] = misses > 0.0 ? HUGE_VAL : cap > 0.0 ? plane.hi : piece.hi;
        out->t_lo[i] = cap > 0.0 ? plane.lo : piece.lo;
        out->feature[i] = first + (cap > 0.0 ? to_high : PIECES + of->piece[i]);
        out->u[i] = cap > 0.0 ? 0.0 : of->u[i];
        out->v[i] = leaves > 0.0 ? 0.0 : enters > 0.0 ? 1.0 : 1.0 - inside;
    }
}

void common_swept_first(const common_swept *s, const common_entries *restrict l, common_first_crossings *restrict out)
{
    cones c;
    lines n;
    sums of;

    if (s->open) {
        for (uint32_t i = 0; i < N; i++)
            out->known[i] = 0.0;
        return;
    }
    find_lines(s, l, &n, &of);
    if (s->conic) {
        find_cones(l, &n, &c, &of);
        add_pieces_of_cone(&s->outline, &n, &c, &of);
    } else {
        add_pieces(&s->outline, &n, &of);
    }
    tell(s, l, &n, &of, out);
}
