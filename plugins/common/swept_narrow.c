/* Rays at the box of a sweep, side by side: in the plane of the outline each is a line, and what counts of it lies between the
 * two planes. Crossings of the outline before that stretch tell whether it begins inside. Seen from the apex of a cone what counts is a
 * line too, in the plane at height 1. */
#include "common/swept.h"

#include "base/elementary.h"

enum { N = COMMON_BEAMS, LOW_CAP = 0, HIGH_CAP, PIECES };

/* What a ray starts on, where it is no piece. */
static const double FREE = -1.0, ON_LOW = -2.0, ON_HIGH = -3.0;

/* By lane, in the plane: a place x, y is x ey - y ex - side beside the line, and at x ex + y ey - place along it. What counts begins between
 * begin and sure_begin, and ends between sure_end and end, by the planes where enters or leaves is 1. Points nearer to the line than
 * `beside` may be on either side, and crossings are off by `off`. open: 1 where too little is known. */
typedef struct lines { common_beam ex, ey, side, place, begin, sure_begin, sure_end, end, enters, leaves, beside, off, own, u, open, per; } lines;

/* By lane: -1 where what counts begins within the outline, else 1; bounds on the first crossing, infinite where there is none. */
typedef struct sums { common_beam side, lo, hi, open; } sums;

COMMON_SEPARATE static void find_lines(const common_swept *s, const common_beams *restrict l, lines *restrict out)
{
    const uint32_t up = s->axis, other = 3 - up;
    const double low = s->lo.hi, high = s->hi.hi, caps = s->open ? 0.0 : 1.0;

    for (uint32_t i = 0; i < N; i++) {
        const double dx = l->dir[0][i], dy = l->dir[other][i], px = l->org[0][i], py = l->org[other][i], rise = l->dir[up][i];
        const double length = sqrt(dx * dx + dy * dy), per = 1.0 / length, turns = 1.0 / rise;
        const double ex = length > 0.0 ? dx * per : 1.0, ey = length > 0.0 ? dy * per : 0.0;   /* numbers, or other lanes would not be told of */
        const double off = l->off[i] * (2.0 + per), off_plane = 4.0 * l->off[i] * (1.0 + fabs(turns));
        const double a = (low - l->org[up][i]) * turns, b = (high - l->org[up][i]) * turns, near = common_lesser(a, b), far = common_greater(a, b);
        const double start_at = l->sure_from[i] > 0.0 ? 0.0 : -1.0, wide = sqrt(off), from_cap = out->own[i] == (rise > 0.0 ? ON_LOW : ON_HIGH) ? 1.0 : 0.0;
        const double to_cap = out->own[i] == (rise > 0.0 ? ON_HIGH : ON_LOW) ? 1.0 : 0.0;
        const double is_after = near - off_plane > start_at ? 1.0 : 0.0, is_before = near + off_plane < start_at ? 1.0 : from_cap;
        const double is_within = far + off_plane < l->sure_to[i] ? 1.0 : 0.0, is_beyond = far - off_plane > l->to[i] ? 1.0 : 0.0;
        const double is_reached = near + off_plane < l->sure_to[i] ? 1.0 : near - off_plane > l->to[i] ? 1.0 : 1.0 - is_after;
        const double is_left = far - off_plane > start_at ? 1.0 : far + off_plane < start_at ? 1.0 : to_cap;
        const double is_known = common_greater(is_after, is_before) * common_greater(is_within, is_beyond) * is_reached * is_left;

        out->ex[i] = ex;
        out->ey[i] = ey;
        out->side[i] = px * ey - py * ex;
        out->place[i] = px * ex + py * ey;
        out->begin[i] = (is_after > 0.0 ? near - off_plane : start_at) * length;
        out->sure_begin[i] = (is_after > 0.0 ? near + off_plane : start_at) * length;
        out->end[i] = to_cap > 0.0 ? -HUGE_VAL : (is_within > 0.0 ? far + off_plane : l->to[i]) * length;
        out->sure_end[i] = (is_within > 0.0 ? far - off_plane : l->sure_to[i]) * length;
        out->enters[i] = from_cap > 0.0 ? 0.0 : is_after * caps;
        out->leaves[i] = is_within * caps;
        out->beside[i] = wide;
        out->off[i] = 4.0 * wide;
        out->open[i] = wide < 0x1p-12 && off_plane < 0x1p-12 ? 1.0 - is_known : 1.0;
        out->per[i] = per;
    }
}

COMMON_INLINE double greater(double a, double b) { return a > b ? a : b; }

/* By lane, of a cone: where on the ray what counts begins and ends, and the heights there. */
typedef struct stretches { common_beam begin, end, from, to; } stretches;

/* Both ends are off by `off` and what the planes are, times the inverse of the height; points as far off as `extent` by that over the length. A ray
 * that comes to the box from outside is outside there, and where it leaves the box. */
COMMON_SEPARATE static void find_cone_lines(const common_swept *s, const common_beams *restrict l, double extent, lines *restrict out,
                                            stretches *restrict part)
{
    const double low = s->lo.hi, high = s->hi.hi, caps = s->open ? 0.0 : 1.0;

    for (uint32_t i = 0; i < N; i++) {
        const double px = l->org[0][i], py = l->org[2][i], height = l->org[1][i], dx = l->dir[0][i], dy = l->dir[2][i], rise = l->dir[1][i];
        const double turns = 1.0 / rise, off_plane = 4.0 * l->off[i] * (1.0 + fabs(turns)), last = l->to[i];
        const double a = (low - height) * turns, b = (high - height) * turns, near = common_lesser(a, b), far = common_greater(a, b);
        const double from_cap = out->own[i] == (rise > 0.0 ? ON_LOW : ON_HIGH) ? 1.0 : 0.0, to_cap = out->own[i] == (rise > 0.0 ? ON_HIGH : ON_LOW) ? 1.0 : 0.0;
        const double is_after = near - off_plane > 0.0 ? 1.0 - from_cap : 0.0, is_before = near + off_plane < 0.0 ? 1.0 : from_cap;
        const double is_within = far + off_plane < l->sure_to[i] ? 1.0 : 0.0, is_beyond = far - off_plane > last ? 1.0 : 0.0;
        const double begin = is_after > 0.0 ? near : 0.0, end = common_lesser(far, last), from = height + begin * rise, to = height + end * rise;
        const double v = 1.0 / from, w = 1.0 / to, x = (px + begin * dx) * v, y = (py + begin * dy) * v, ux = (px + end * dx) * w - x, uy = (py + end * dy) * w - y;
        const double length = sqrt(ux * ux + uy * uy), per = 1.0 / length;
        const double reach = 1.0 + fabs(x) + fabs(y) + length, most = common_greater(fabs(v), fabs(w));
        const double off = (l->off[i] + off_plane) * reach * most * (2.0 + (extent + reach) * per), wide = sqrt(off);
        const double none = end < begin - 2.0 * off_plane ? 1.0 : to_cap, known = wide < 0x1p-12 ? off_plane < 0x1p-12 ? 1.0 : 0.0 : 0.0;
        const double ex = known > 0.0 ? ux * per : 1.0, ey = known > 0.0 ? uy * per : 0.0;

        out->ex[i] = ex;
        out->ey[i] = ey;
        out->side[i] = known > 0.0 ? x * ey - y * ex : 0.0;
        out->place[i] = known > 0.0 ? x * ex + y * ey : 0.0;
        out->begin[i] = out->sure_begin[i] = 0.0;
        out->end[i] = none > 0.0 ? -HUGE_VAL : length;
        out->sure_end[i] = length;
        out->enters[i] = is_after * caps;
        out->leaves[i] = is_within * caps;
        out->beside[i] = known > 0.0 ? wide : 1.0;
        out->off[i] = known > 0.0 ? 4.0 * wide : 1.0;
        out->open[i] = 1.0 - known * common_greater(is_after, is_before) * common_greater(is_within, is_beyond);
        out->per[i] = per;
        part->begin[i] = begin;
        part->end[i] = end;
        part->from[i] = from;
        part->to[i] = to;
    }
}

/* On which side of each line a point is, and how far. */
COMMON_SEPARATE static void find_sides(const lines *restrict n, double x, double y, double *restrict out)
{
    for (uint32_t i = 0; i < N; i++)
        out[i] = common_sum_of(x, n->ey[i], -common_sum_of(y, n->ex[i], n->side[i]));
}

/* May any line cross the piece between two points? Of two numbers of one sign the size of their sum less that of their difference is twice
 * the smaller size; else it is below zero. */
COMMON_SEPARATE static bool any_crosses(const lines *restrict n, const double *restrict p, const double *restrict q)
{
    double clear[N], least[N / 2];
    uint64_t any = 0;

    for (uint32_t i = 0; i < N; i++)
        clear[i] = (fabs(p[i] + q[i]) - fabs(p[i] - q[i])) - 2.0 * n->beside[i];
    for (uint32_t i = 0; i < N / 2; i++)
        least[i] = common_lesser(clear[i], clear[i + N / 2]);
    for (uint32_t i = 0; i < N / 2; i++)
        any |= elementary_bits(least[i]);
    return any >> 63;
}

/* What a piece of the outline does to the sums: 1 where the line crosses it, an odd number of times; where that is before what counts; where
 * within it, between two places at least; and where that is not known. */
COMMON_INLINE void add(sums *restrict io, uint32_t i, double before, double within, double open, double lo, double hi)
{
    io->side[i] = before > 0.0 ? -io->side[i] : io->side[i];
    io->open[i] = greater(io->open[i], open);
    io->lo[i] = within > 0.0 ? common_lesser(lo, io->lo[i]) : io->lo[i];
    io->hi[i] = within > 0.0 ? common_lesser(hi, io->hi[i]) : io->hi[i];
}

/* A straight piece between two points, by their sides. */
COMMON_SEPARATE static void add_straight(const lines *restrict n, double number, const double *restrict a, const double *restrict b,
                                       const double *restrict p, const double *restrict q, sums *restrict io)
{
    const double ax = a[0], ay = a[1], bx = b[0], by = b[1];

    for (uint32_t i = 0; i < N; i++) {
        const double ex = n->ex[i], ey = n->ey[i], r = fabs(p[i]), t = fabs(q[i]), off = n->off[i];
        const double at = ((ax * ex + ay * ey) * t + (bx * ex + by * ey) * r) / (r + t) - n->place[i];
        const double crosses = (p[i] >= 0.0) != (q[i] >= 0.0) ? 1.0 : 0.0, own = n->own[i] == number ? 1.0 : 0.0;
        const double before = at < n->begin[i] - off ? 1.0 : own, behind = at > n->end[i] + off ? 1.0 : 0.0;
        const double within = at > n->sure_begin[i] + off ? at < n->sure_end[i] - off ? 1.0 - own : 0.0 : 0.0;
        const double unknown = before + behind + within > 0.0 ? 0.0 : crosses, open = common_lesser(r, t) > n->beside[i] ? unknown : 1.0;

        add(io, i, crosses * before, crosses * within, open, at, at);
    }
}

COMMON_INLINE double least_of(const double b[4]) { return common_lesser(common_lesser(b[0], b[1]), common_lesser(b[2], b[3])); }
COMMON_INLINE double most_of(const double b[4]) { return greater(greater(b[0], b[1]), greater(b[2], b[3])); }

/* A cubic without its root u, which is where the ray starts: are all coefficients on one side of zero? */
COMMON_INLINE double has_one_root(const double b[4], double u, double beside)
{
    const double turned = u > 0.5 ? 1.0 : 0.0, v = turned > 0.0 ? u : 1.0 - u, w = 1.0 - v, per = 1.0 / v;
    const double one = turned > 0.0 ? b[2] : b[1], two = turned > 0.0 ? b[1] : b[2], three = turned > 0.0 ? b[0] : b[3];
    const double q2 = three * per, q1 = (3.0 * two + w * q2) * 0.5 * per, q0 = (3.0 * one + 2.0 * w * q1) * per;

    return greater(common_lesser(common_lesser(q0, q1), q2), -greater(greater(q0, q1), q2)) > 8.0 * beside ? 1.0 : 0.0;
}

/* May any line come near to a cubic piece? Else there is nothing to add. */
COMMON_SEPARATE static bool any_nears(const lines *restrict n, const double *restrict x, const double *restrict y)
{
    const double x0 = x[0], y0 = y[0], x1 = x[1], y1 = y[1], x2 = x[2], y2 = y[2], x3 = x[3], y3 = y[3];
    double clear[N], least[N / 2];
    uint64_t any = 0;

    for (uint32_t i = 0; i < N; i++) {
        const double ex = n->ex[i], ey = n->ey[i], side = n->side[i];
        const double b[4] = { x0 * ey - y0 * ex - side, x1 * ey - y1 * ex - side, x2 * ey - y2 * ex - side, x3 * ey - y3 * ex - side };

        clear[i] = greater(least_of(b), -most_of(b)) - 1.0625 * n->beside[i];
    }
    for (uint32_t i = 0; i < N / 2; i++)
        least[i] = common_lesser(clear[i], clear[i + N / 2]);
    for (uint32_t i = 0; i < N / 2; i++)
        any |= elementary_bits(least[i]);
    return any >> 63;
}

/* A cubic piece, by the sides and the places of its points. */
COMMON_SEPARATE static void add_cubic(const lines *restrict n, double number, const double *restrict x, const double *restrict y, sums *restrict io)
{
    const double x0 = x[0], y0 = y[0], x1 = x[1], y1 = y[1], x2 = x[2], y2 = y[2], x3 = x[3], y3 = y[3];

    for (uint32_t i = 0; i < N; i++) {
        const double ex = n->ex[i], ey = n->ey[i], side = n->side[i], off = n->off[i], beside = n->beside[i];
        const double b[4] = { x0 * ey - y0 * ex - side, x1 * ey - y1 * ex - side, x2 * ey - y2 * ex - side, x3 * ey - y3 * ex - side };
        const double at[4] = { x0 * ex + y0 * ey, x1 * ex + y1 * ey, x2 * ex + y2 * ey, x3 * ex + y3 * ey };
        const double lo = least_of(at) - n->place[i], hi = most_of(at) - n->place[i], ends = common_lesser(fabs(b[0]), fabs(b[3]));
        const double clear = greater(least_of(b), -most_of(b)) > beside ? 1.0 : 0.0, odd = (b[0] >= 0.0) != (b[3] >= 0.0) ? 1.0 : 0.0;
        const double own = n->own[i] == number ? 1.0 : 0.0, single = own * has_one_root(b, n->u[i], beside);
        const double before = hi < n->begin[i] - off ? 1.0 - own : single, behind = lo > n->end[i] + off ? 1.0 : 0.0;
        const double within = lo > n->sure_begin[i] + off ? hi < n->sure_end[i] - off ? odd * (1.0 - own) : 0.0 : 0.0;
        const double open = before + behind + within > 0.0 ? 0.0 : 1.0 - clear;

        add(io, i, odd * before, within, ends > beside ? open : 1.0, lo, hi);
    }
}

COMMON_SEPARATE static void tell(const lines *restrict n, const sums *restrict of, common_verdicts *restrict out)
{
    for (uint32_t i = 0; i < N; i++) {
        const double inside = of->side[i] < 0.0 ? 1.0 : 0.0, crossed = of->hi[i] < HUGE_VAL ? 1.0 : 0.0, known = 1.0 - of->open[i];
        const double none = n->end[i] < n->begin[i] ? 1.0 - n->open[i] : 0.0, enters = inside * n->enters[i];
        const double leaves = (1.0 - crossed) * inside * n->leaves[i], off = 2.0 * n->off[i], hit = enters + crossed + leaves > 0.0 ? known : 0.0;
        const double lo = crossed > 0.0 ? of->lo[i] : n->sure_end[i], hi = crossed > 0.0 ? of->hi[i] : n->end[i];

        /* A stretch that begins inside ends with a crossing, or where the ray does. */
        out->passed[i] = none > 0.0 ? 1.0 : known - hit;
        out->hit[i] = none > 0.0 ? 0.0 : hit;
        out->lo[i] = ((enters > 0.0 ? n->begin[i] : lo) - off) * n->per[i];
        out->hi[i] = ((enters > 0.0 ? n->sure_begin[i] : hi) + off) * n->per[i];
    }
}

/* Where the ray is at a share of its line, as seen from the apex. */
COMMON_INLINE double place_in(const stretches *c, uint32_t i, double share)
{
    const double held = share > 0.0 ? share < 1.0 ? share : 1.0 : 0.0, by = held * c->from[i];

    return c->begin[i] + (c->end[i] - c->begin[i]) * (by / ((1.0 - held) * c->to[i] + by));
}

/* Of a cone: places of the line become places of the ray. */
COMMON_SEPARATE static void tell_of_cone(const lines *restrict n, const stretches *restrict c, const sums *restrict of, common_verdicts *restrict out)
{
    for (uint32_t i = 0; i < N; i++) {
        const double inside = of->side[i] < 0.0 ? 1.0 : 0.0, crossed = of->hi[i] < HUGE_VAL ? 1.0 : 0.0, known = 1.0 - of->open[i];
        const double none = n->end[i] < n->begin[i] ? 1.0 - n->open[i] : 0.0, enters = inside * n->enters[i];
        const double leaves = (1.0 - crossed) * inside * n->leaves[i], off = 2.0 * n->off[i], hit = enters + crossed + leaves > 0.0 ? known : 0.0;
        const double lo = place_in(c, i, (of->lo[i] - off) * n->per[i]), hi = place_in(c, i, (of->hi[i] + off) * n->per[i]), beside = n->beside[i];

        out->passed[i] = none > 0.0 ? 1.0 : known - hit;
        out->hit[i] = none > 0.0 ? 0.0 : hit;
        out->lo[i] = (enters > 0.0 ? c->begin[i] : crossed > 0.0 ? lo : c->end[i]) - beside;
        out->hi[i] = (enters > 0.0 ? c->begin[i] : crossed > 0.0 ? hi : c->end[i]) + beside;
    }
}

/* Points that two straight pieces share are looked at once. */
static void add_pieces(const common_outline *o, const lines *n, sums *io)
{
    common_beam sides[2];
    double *from = sides[0], *to = sides[1], last[2] = { HUGE_VAL, HUGE_VAL };

    for (uint32_t i = 0; i < o->count; i++) {
        const common_piece *c = &o->at[i];
        const double a[2] = { c->x[0], c->y[0] }, b[2] = { c->x[1], c->y[1] };
        double *const before = from;

        if (c->degree > 1) {
            if (any_nears(n, o->cubic[i][0], o->cubic[i][1]))
                add_cubic(n, i, o->cubic[i][0], o->cubic[i][1], io);
            continue;
        }
        if (!(a[0] == last[0] && a[1] == last[1]))
            find_sides(n, a[0], a[1], from);
        find_sides(n, b[0], b[1], to);
        if (any_crosses(n, from, to))
            add_straight(n, i, a, b, from, to, io);
        from = to;
        to = before;
        last[0] = b[0];
        last[1] = b[1];
    }
}

static double extent_of(const common_outline *o)
{
    return common_greater(common_greater(fabs(o->lo[0]), fabs(o->hi[0])), common_greater(fabs(o->lo[1]), fabs(o->hi[1])));
}

bool common_swept_may_look(const common_swept *s)
{
    const double low = s->lo.hi, high = s->hi.hi;

    return !s->conic || low > 0x1p-8 * high || high < 0x1p-8 * low;
}

void common_swept_look(const void *self, const common_beams *restrict l, common_verdicts *restrict out)
{
    const common_swept *s = self;
    stretches part;
    lines n;
    sums of;

    for (uint32_t i = 0; i < N; i++) {
        const uint32_t feature = l->feature[i] - s->first;

        n.own[i] = l->feature[i] == UINT32_MAX ? FREE : feature == LOW_CAP ? ON_LOW : feature == HIGH_CAP ? ON_HIGH : (double)(feature - PIECES);
        n.u[i] = l->u[i];
    }
    if (s->conic)
        find_cone_lines(s, l, extent_of(&s->outline), &n, &part);
    else
        find_lines(s, l, &n);
    for (uint32_t i = 0; i < N; i++) {
        of.side[i] = 1.0;
        of.lo[i] = of.hi[i] = HUGE_VAL;
        of.open[i] = n.open[i];
    }
    add_pieces(&s->outline, &n, &of);
    if (s->conic)
        tell_of_cone(&n, &part, &of, out);
    else
        tell(&n, &of, out);
}
