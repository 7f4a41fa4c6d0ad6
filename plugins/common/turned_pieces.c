/* Pieces of a curve that is turned about the y axis, and which of them a line may cross, side by side. */
#include "common/revolved.h"

#include "common/bernstein.h"

enum { N = COMMON_TURNED_LANES };

static const double choose[4][4] = { { 1.0 }, { 1.0, 1.0 }, { 1.0, 2.0, 1.0 }, { 1.0, 3.0, 3.0, 1.0 } };

static double choose_of(int n, int k)
{
    double c = 1.0;

    for (int i = 0; i < k; i++)
        c = c * (n - i) / (i + 1);
    return c;
}

void common_turned_multiply(int n, const double *a, const double *b, double *out)
{
    for (int k = 0; k <= 2 * n; k++) {
        out[k] = 0.0;
        for (int i = k > n ? k - n : 0; i <= n && i <= k; i++)
            out[k] += choose[n][i] * choose[n][k - i] * a[i] * b[k - i];
        out[k] /= choose_of(2 * n, k);
    }
}

void common_turned_make(common_turned *p, const common_piece *c)
{
    const int n = (int)c->degree;
    static const double ones[4] = { 1.0, 1.0, 1.0, 1.0 };
    double least = HUGE_VAL, most = -HUGE_VAL;

    p->curve = *c;
    p->order = 2 * n;
    common_turned_multiply(n, c->y, ones, p->y);
    common_turned_multiply(n, c->y, c->y, p->y_square);
    common_turned_multiply(n, c->x, c->x, p->r_square);
    p->low = HUGE_VAL;
    p->high = -HUGE_VAL;
    common_bernstein_widen(c->y, n, &p->low, &p->high);
    common_bernstein_widen(c->x, n, &least, &most);
    p->widest = pov_max(least * least, most * most);
    /* What both pieces at a joint have, in the same bits. */
    p->y[0] = c->y[0];
    p->y[2 * n] = c->y[n];
    p->y_square[2 * n] = c->y[n] * c->y[n];
    p->r_square[2 * n] = c->x[n] * c->x[n];
}

void common_turned_pack(const common_turned *parts, uint32_t count, common_turned_block *out)
{
    for (uint32_t i = 0; i < N; i++) {
        const common_turned *p = &parts[i < count ? i : 0];

        out->low[i] = p->low;
        out->high[i] = p->high;
        out->wide[i] = i < count ? p->widest * (1.0 + 0x1p-30) + 0x1p-60 : -HUGE_VAL;
        for (int k = 0; k <= p->order; k++) {
            out->y[k][i] = p->y[k];
            out->y_square[k][i] = p->y_square[k];
            out->r_square[k][i] = p->r_square[k];
        }
    }
}

COMMON_INLINE double lesser(double a, double b) { return a < b ? a : b; }
COMMON_INLINE double greater(double a, double b) { return a > b ? a : b; }

/* 1 where the line comes near enough to the axis at the heights of the piece. */
COMMON_SEPARATE static void find_near(const common_turned_block *restrict p, const common_turned_line *restrict n, double *restrict near)
{
    const double oy = n->oy, per = n->per_height, first = n->lo, last = n->hi, foot = n->foot, a = n->a, b = n->b, c = n->c;

    for (uint32_t i = 0; i < N; i++) {
        const double s = (p->low[i] - oy) * per, t = (p->high[i] - oy) * per;
        const double lo = greater(lesser(s, t), first), hi = lesser(greater(s, t), last), nearest = a > 0.0 ? lesser(greater(foot, lo), hi) : lo;
        const double within = (a * nearest + 2.0 * b) * nearest + c <= p->wide[i] ? 1.0 : 0.0;

        near[i] = lo <= hi + 0x1p-30 ? within : 0.0;
    }
}

/* The equations' coefficients; crossed: 1 where they are not on one side of zero. */
COMMON_INLINE void find_equations(const common_turned_block *restrict p, const common_turned_line *restrict n, int order,
                                  common_turned_equations *restrict out, double *restrict crossed)
{
    const double a = n->a, linear = n->linear, rest = n->rest, square = n->square;

    COMMON_LOOP for (uint32_t i = 0; i < N; i++) {
        double least = HUGE_VAL, most = -HUGE_VAL;

        COMMON_UNROLLED for (int k = 0; k <= order; k++) {
            const double b = a * p->y_square[k][i] + linear * p->y[k][i] + (rest - square * p->r_square[k][i]);

            out->b[k][i] = b;
            least = lesser(b, least);
            most = greater(b, most);
        }
        crossed[i] = least >= 0.0 ? 0.0 : most < 0.0 ? 0.0 : 1.0;
    }
}

COMMON_SEPARATE static void find_quartics(const common_turned_block *restrict p, const common_turned_line *restrict n,
                                          common_turned_equations *restrict out, double *restrict crossed)
{
    find_equations(p, n, 4, out, crossed);
}

COMMON_SEPARATE static void find_sextics(const common_turned_block *restrict p, const common_turned_line *restrict n,
                                         common_turned_equations *restrict out, double *restrict crossed)
{
    find_equations(p, n, 6, out, crossed);
}

COMMON_SEPARATE static void find_quadratics(const common_turned_block *restrict p, const common_turned_line *restrict n,
                                            common_turned_equations *restrict out, double *restrict crossed)
{
    find_equations(p, n, 2, out, crossed);
}

static uint32_t bits_of(const double *lanes)
{
    uint32_t bits = 0;

    for (uint32_t i = 0; i < N; i++)
        bits |= (uint32_t)(lanes[i] > 0.0) << i;
    return bits;
}

uint32_t common_turned_find(const common_turned_block *p, int order, const common_turned_line *n, common_turned_equations *out)
{
    common_by_turned near, crossed;
    uint32_t bits;

    find_near(p, n, near);
    bits = bits_of(near);
    if (!bits)
        return 0;
    (order == 2 ? find_quadratics : order == 4 ? find_quartics : find_sextics)(p, n, out, crossed);
    return bits & bits_of(crossed);
}
