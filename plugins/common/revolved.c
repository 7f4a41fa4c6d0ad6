#include "common/revolved.h"

#include "base/elementary.h"

enum { N = COMMON_BEAMS };

void common_revolved_curve(common_revolved_part *p, double low, double high, const double b[4], uint32_t feature)
{
    const double per = 1.0 / (high - low), a1 = 3.0 * (b[1] - b[0]), a2 = 3.0 * (b[0] - 2.0 * b[1] + b[2]), a3 = b[3] - b[0] + 3.0 * (b[1] - b[2]);
    const double c1 = a1 * per, c2 = a2 * per * per, c3 = a3 * per * per * per;

    p->low = low;
    p->high = high;
    p->feature = feature;
    p->square[0] = b[0] - low * (c1 - low * (c2 - low * c3));
    p->square[1] = c1 - low * (2.0 * c2 - 3.0 * low * c3);
    p->square[2] = c2 - 3.0 * low * c3;
    p->square[3] = c3;
    p->size = 0.0;
    for (int k = 0; k < 4; k++)
        p->size += fabs(p->square[k]);
    /* What is lost where coefficients cancel. */
    p->size = pov_max(p->size, fabs(b[0]) + fabs(c1) + fabs(c2) + fabs(c3));
    p->inner = p->outer = p->loose = 0.0;
}

void common_revolved_ring(common_revolved_part *p, double height, double inner, double outer, uint32_t feature)
{
    const common_revolved_part ring = { height, height, { 0.0, 0.0, 0.0, 0.0 }, 0.0, inner * inner, outer * outer, 0.0, feature };

    *p = ring;
}

/* A straight piece between two radii and heights: its squared radius is a quadratic. */
static void make_straight(common_revolved_part *p, const double radius[2], const double height[2], uint32_t feature)
{
    const bool rises = height[0] < height[1];
    const double a = radius[!rises], b = radius[rises], third = (2.0 * a + b) / 3.0, other = (a + 2.0 * b) / 3.0;
    const double square[4] = { a * a, a * other, b * third, b * b };

    if (height[0] == height[1]) {
        common_revolved_ring(p, height[0], a * b > 0.0 ? pov_min(fabs(a), fabs(b)) : 0.0, pov_max(fabs(a), fabs(b)), feature);
    } else {
        common_revolved_curve(p, height[!rises], height[rises], square, feature);
        p->square[3] = 0.0;
    }
}

void common_revolved_outline(common_revolved *r, const common_outline *o, const pov_host *host, pov_reader *in)
{
    bool straight = true;

    for (uint32_t i = 0; i < o->count; i++)
        straight &= o->at[i].degree == 1;
    r->at = straight ? host->alloc(in, o->count * sizeof *r->at) : NULL;
    r->count = r->at ? o->count : 0;
    for (uint32_t i = 0; i < r->count; i++)
        make_straight(&r->at[i], o->at[i].x, o->at[i].y, i);
}

/* By lane: the square of the distance to the axis, a s^2 + 2 b s + c; 1 over the rise; how far off the ray is where it has a height; and the
 * feature that it starts on. */
typedef struct lines { common_beam a, b, c, turns, off, begin, own; } lines;

/* By lane: 1 where a part is hit for certain; where that is open; none is hit before `lo`, and one up to hi. */
typedef struct sums { common_beam hit, open, lo, hi; } sums;

COMMON_INLINE double greater(double a, double b) { return a > b ? a : b; }
COMMON_INLINE double lesser(double a, double b) { return a < b ? a : b; }
COMMON_INLINE double sum_of(double a, double b, double c) { return common_sum_of(a, b, c); }

COMMON_SEPARATE static void find_lines(const common_beams *restrict l, lines *restrict out, sums *restrict of)
{
    for (uint32_t i = 0; i < N; i++) {
        const double dx = l->dir[0][i], rise = l->dir[1][i], dz = l->dir[2][i], px = l->org[0][i], pz = l->org[2][i];

        out->a[i] = dx * dx + dz * dz;
        out->b[i] = px * dx + pz * dz;
        out->c[i] = px * px + pz * pz;
        out->turns[i] = 1.0 / (fabs(rise) > 0x1p-40 ? rise : 0x1p-40);
        out->off[i] = 16.0 * l->off[i] * (1.0 + fabs(out->turns[i]));
        out->begin[i] = greater(l->from[i], 0.0);
        of->hit[i] = 0.0;
        of->open[i] = 0.0;
        of->lo[i] = HUGE_VAL;
        of->hi[i] = HUGE_VAL;
    }
}

COMMON_INLINE void add(sums *restrict io, uint32_t i, double hit, double open, double lo, double hi)
{
    io->hit[i] = hit > 0.0 ? 1.0 : io->hit[i];
    io->open[i] = open > 0.0 ? 1.0 : io->open[i];
    io->lo[i] = hit + open > 0.0 ? lesser(lo, io->lo[i]) : io->lo[i];
    io->hi[i] = hit > 0.0 ? lesser(hi, io->hi[i]) : io->hi[i];
}

/* By lane: the stretch of a ray at a part's heights, 1 where there is one, 1 where the ray starts on the part; and what is known of the
 * coefficients' error. */
typedef struct stretches { common_beam from, to, reached, own, error, b[4]; } stretches;

COMMON_INLINE void find_stretch(const common_revolved_part *p, const common_beams *restrict l, const lines *restrict n, stretches *restrict out, uint32_t i)
{
    const double y = l->org[1][i], s = (p->low - y) * n->turns[i], t = (p->high - y) * n->turns[i];
    const double from = greater(lesser(s, t), n->begin[i]), to = lesser(greater(s, t), l->to[i]);

    out->from[i] = from;
    out->to[i] = to;
    out->reached[i] = to >= from - n->off[i] ? 1.0 : 0.0;
    out->own[i] = n->own[i] == (double)p->feature ? 1.0 : 0.0;
    out->error[i] = sum_of(n->off[i], 1.0 + p->size, p->loose);
}

/* By how much all are on one side of zero. */
COMMON_INLINE double one_sided(double least, double most) { return greater(least, -most); }

/* Is any below zero? */
COMMON_INLINE bool any_below(const double *restrict at)
{
    double least[N / 2];
    uint64_t any = 0;

    for (uint32_t i = 0; i < N / 2; i++)
        least[i] = lesser(at[i], at[i + N / 2]);
    for (uint32_t i = 0; i < N / 2; i++)
        any |= elementary_bits(least[i]);
    return any >> 63;
}

/* Along the stretch at its heights the square of the distance to the axis less that of the radius is a polynomial: its Bernstein coefficients.
 * Where the ray starts on the part, the first one is zero, and the signs of the others are those of the factor that is left. False: all rays
 * pass, as their coefficients are on one side. */
COMMON_SEPARATE static bool find_cubic(const common_revolved_part *restrict p, const common_beams *restrict l, const lines *restrict n,
                                     stretches *restrict out)
{
    const double r0 = p->square[0], r1 = p->square[1], r2 = p->square[2], r3 = p->square[3];
    common_beam clear;

    for (uint32_t i = 0; i < N; i++) {
        const double y = l->org[1][i], rise = l->dir[1][i], steep = rise * rise * r3, bend = sum_of(3.0 * y, r3, r2);
        double from, to, third, g0, g1, g2, g3, b0, b1, b2, b3, first;

        find_stretch(p, l, n, out, i);
        from = out->from[i];
        to = out->to[i];
        third = (to - from) * (1.0 / 3.0);
        g0 = n->c[i] - sum_of(y, sum_of(y, sum_of(y, r3, r2), r1), r0);
        g1 = 2.0 * n->b[i] - rise * sum_of(y, sum_of(3.0 * y, r3, 2.0 * r2), r1);
        g2 = n->a[i] - rise * rise * bend;
        g3 = -rise * steep;
        b0 = sum_of(from, sum_of(from, sum_of(from, g3, g2), g1), g0);
        b3 = sum_of(to, sum_of(to, sum_of(to, g3, g2), g1), g0);
        b1 = sum_of(third, sum_of(from, sum_of(3.0 * from, g3, 2.0 * g2), g1), b0);
        b2 = b3 - third * sum_of(to, sum_of(3.0 * to, g3, 2.0 * g2), g1);
        first = out->own[i] > 0.0 ? b1 : b0;
        out->b[0][i] = b0;
        out->b[1][i] = b1;
        out->b[2][i] = b2;
        out->b[3][i] = b3;
        clear[i] = one_sided(lesser(lesser(first, b1), lesser(b2, b3)), greater(greater(first, b1), greater(b2, b3))) - out->error[i];
        clear[i] = out->reached[i] > 0.0 ? clear[i] : 1.0;
    }
    return any_below(clear);
}

/* The same of second degree. */
COMMON_SEPARATE static bool find_quadratic(const common_revolved_part *restrict p, const common_beams *restrict l, const lines *restrict n,
                                         stretches *restrict out)
{
    const double r0 = p->square[0], r1 = p->square[1], r2 = p->square[2];
    common_beam clear;

    for (uint32_t i = 0; i < N; i++) {
        const double y = l->org[1][i], rise = l->dir[1][i], g0 = n->c[i] - sum_of(y, sum_of(y, r2, r1), r0);
        const double g1 = 2.0 * n->b[i] - rise * sum_of(2.0 * y, r2, r1), g2 = n->a[i] - rise * rise * r2;
        double from, to, b0, b1, b2, first;

        find_stretch(p, l, n, out, i);
        from = out->from[i];
        to = out->to[i];
        b0 = sum_of(from, sum_of(from, g2, g1), g0);
        b2 = sum_of(to, sum_of(to, g2, g1), g0);
        b1 = sum_of(0.5 * (to - from), sum_of(2.0 * from, g2, g1), b0);
        first = out->own[i] > 0.0 ? b1 : b0;
        out->b[0][i] = b0;
        out->b[1][i] = b1;
        out->b[2][i] = b2;
        clear[i] = one_sided(lesser(lesser(first, b1), b2), greater(greater(first, b1), b2)) - out->error[i];
        clear[i] = out->reached[i] > 0.0 ? clear[i] : 1.0;
    }
    return any_below(clear);
}

/* What is known by coefficients that are on one side, `all` or at most twice those of both halves; by those at the ends, of which `first` may be
 * that of what is left; and by the value in the middle, which may be beyond both. */
COMMON_INLINE void judge(const stretches *restrict s, double all, double half, double first, double last, double middle, const lines *restrict n,
                         sums *restrict io, uint32_t i)
{
    const double own = s->own[i], error = s->error[i], least = lesser(first, last), most = greater(first, last);
    const double turned = own > 0.0 ? -1.0 : greater(lesser(least, -middle), lesser(-most, middle));
    const double hit = greater(lesser(most, -least), turned) > error ? (s->to[i] > s->from[i] ? s->reached[i] : 0.0) : 0.0;
    const double clear = all > error ? 1.0 : half > 2.0 * error ? 1.0 - own : 0.0;

    add(io, i, hit, clear + hit > 0.0 ? 0.0 : s->reached[i], s->from[i] - n->off[i], s->to[i] + n->off[i]);
}

COMMON_SEPARATE static void add_cubic(const stretches *restrict s, const lines *restrict n, sums *restrict io)
{
    for (uint32_t i = 0; i < N; i++) {
        const double b0 = s->b[0][i], b1 = s->b[1][i], b2 = s->b[2][i], b3 = s->b[3][i], first = s->own[i] > 0.0 ? b1 : b0;
        const double c0 = b0 + b1, m = b1 + b2, c2 = b2 + b3, c1 = 0.5 * (c0 + m), d1 = 0.5 * (m + c2), middle = c1 + d1;
        const double half = one_sided(lesser(lesser(lesser(b0, b3), lesser(c0, c2)), lesser(lesser(c1, d1), middle)),
                                      greater(greater(greater(b0, b3), greater(c0, c2)), greater(greater(c1, d1), middle)));

        judge(s, one_sided(lesser(lesser(first, b1), lesser(b2, b3)), greater(greater(first, b1), greater(b2, b3))), half, first, b3, 0.25 * middle, n, io, i);
    }
}

COMMON_SEPARATE static void add_quadratic(const stretches *restrict s, const lines *restrict n, sums *restrict io)
{
    for (uint32_t i = 0; i < N; i++) {
        const double b0 = s->b[0][i], b1 = s->b[1][i], b2 = s->b[2][i], first = s->own[i] > 0.0 ? b1 : b0;
        const double c0 = b0 + b1, c1 = b1 + b2, middle = 0.5 * (c0 + c1);
        const double half = one_sided(lesser(lesser(c0, c1), lesser(lesser(b0, b2), middle)), greater(greater(c0, c1), greater(greater(b0, b2), middle)));

        judge(s, one_sided(lesser(lesser(first, b1), b2), greater(greater(first, b1), b2)), half, first, b2, 0.5 * middle, n, io, i);
    }
}

COMMON_SEPARATE static void add_ring(const common_revolved_part *p, const common_beams *restrict l, const lines *restrict n, sums *restrict io)
{
    const double height = p->low, inner = p->inner, outer = p->outer, feature = p->feature;

    for (uint32_t i = 0; i < N; i++) {
        const double s = (height - l->org[1][i]) * n->turns[i], off = n->off[i], square = n->c[i] + s * (2.0 * n->b[i] + s * n->a[i]);
        const double reached = s > n->begin[i] - off ? (s < l->to[i] + off ? (n->own[i] == feature ? 0.0 : 1.0) : 0.0) : 0.0;
        const double sure = s > l->sure_from[i] + off ? (s < l->sure_to[i] - off ? 1.0 : 0.0) : 0.0;
        const double error = 16.0 * off, clear = square > outer + error ? 1.0 : square < inner - error ? 1.0 : 0.0;
        const double within = square < outer - error ? (square > inner + error ? sure : inner > 0.0 ? 0.0 : sure) : 0.0;

        add(io, i, within * reached, (1.0 - clear) * (1.0 - within) * reached, s - off, s + off);
    }
}

static void look_at(const common_revolved_part *p, const common_beams *l, const lines *n, sums *io)
{
    stretches s;

    if (!(p->low < p->high)) {
        add_ring(p, l, n, io);
    } else if (p->square[3] != 0.0) {
        if (find_cubic(p, l, n, &s))
            add_cubic(&s, n, io);
    } else if (find_quadratic(p, l, n, &s)) {
        add_quadratic(&s, n, io);
    }
}

void common_revolved_look(const void *self, const common_beams *restrict l, common_verdicts *restrict out)
{
    const common_revolved *r = self;
    lines n;
    sums of;

    find_lines(l, &n, &of);
    for (uint32_t i = 0; i < N; i++)
        n.own[i] = l->feature[i] == UINT32_MAX ? -1.0 : l->feature[i];
    for (uint32_t k = 0; k < r->count; k++)
        look_at(&r->at[k], l, &n, &of);
    for (uint32_t i = 0; i < N; i++) {
        const bool known = n.off[i] < 0x1p-20;

        out->passed[i] = known && of.hit[i] + of.open[i] == 0.0 ? 1.0 : 0.0;
        out->hit[i] = known ? of.hit[i] : 0.0;
        out->lo[i] = of.lo[i];
        out->hi[i] = of.hi[i];
    }
}
