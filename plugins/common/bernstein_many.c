/* The first roots of eight polynomials side by side, by the arithmetic of bernstein.c: of each the part of its interval that may hold the
 * first root is halved. Where it turns out to hold none, the lane goes back to the last part that was left behind. */
#include "common/bernstein.h"
#include "common/simd.h"

enum { N = COMMON_BERNSTEINS, MOST = COMMON_BERNSTEINS_DEGREE, HALVINGS = 8, TURNS = 80 };
typedef common_by_bernstein lane;

/* The part that is still to be decided; the least size of the coefficients that decided so far, where that is asked. none: above 0 where the
 * last halving left nothing to be decided. */
typedef struct parts { lane b[MOST + 1], lo, hi, going, least, none; } parts;

/* The right halves of one turn, and how many sign changes those have that were left behind. */
typedef struct halves { lane b[MOST + 1], lo, hi, changes; } halves;

/* Coefficients of a part of one lane. */
typedef struct part { double b[MOST + 1]; } part;

/* As in bernstein.c, with the sign as a factor. */
COMMON_INLINE double changes_of(const part *p, int degree, double noise)
{
    double side = p->b[0] >= 0.0 ? 1.0 : -1.0, changes = 0.0;

    COMMON_UNROLLED for (int i = 1; i < degree; i++) {
        const double turns = p->b[i] * side < -noise ? 1.0 : 0.0;

        changes += turns;
        side *= 1.0 - 2.0 * turns;
    }
    return changes + 0.5 * (1.0 - side * (p->b[degree] >= 0.0 ? 1.0 : -1.0));
}

COMMON_INLINE double least_of(const part *p, int degree, double least)
{
    COMMON_UNROLLED for (int i = 0; i <= degree; i++)
        least = fabs(p->b[i]) < least ? fabs(p->b[i]) : least;
    return least;
}

COMMON_INLINE void halve(const part *p, int degree, part *left, part *right)
{
    part w = *p;

    COMMON_UNROLLED for (int k = 0; k <= degree; k++) {
        left->b[k] = w.b[0];
        right->b[degree - k] = w.b[degree - k];
        COMMON_UNROLLED for (int i = 0; i < degree - k; i++)
            w.b[i] = 0.5 * (w.b[i] + w.b[i + 1]);
    }
}

COMMON_INLINE void begin(const common_bernsteins *of, int degree, bool certain, uint32_t i, parts *w, common_first_of_bernsteins *out)
{
    double changes;
    part p;

    COMMON_UNROLLED for (int k = 0; k <= degree; k++)
        w->b[k][i] = p.b[k] = of->b[k][i];
    changes = changes_of(&p, degree, of->noise[i]);
    w->lo[i] = 0.0;
    w->hi[i] = 1.0;
    w->going[i] = changes > 1.0 ? 1.0 : 0.0;
    if (certain)
        w->least[i] = least_of(&p, degree, HUGE_VAL);
    out->found[i] = changes == 1.0 ? 1.0 : 0.0;
    out->more[i] = 0.0;
    out->open[i] = out->before[i] = 0.0;
}

/* Looks at both halves of a lane's part. */
COMMON_INLINE void advance(const common_bernsteins *of, int degree, bool certain, uint32_t i, parts *w, halves *behind,
                           common_first_of_bernsteins *out)
{
    const double lo = w->lo[i], hi = w->hi[i], middle = 0.5 * (lo + hi), noise = of->noise[i], going = w->going[i];
    const double found = out->found[i], more = out->more[i];
    double left, right, here, one;
    part p, a, b;

    COMMON_UNROLLED for (int k = 0; k <= degree; k++)
        p.b[k] = w->b[k][i];
    halve(&p, degree, &a, &b);
    left = changes_of(&a, degree, noise);
    right = changes_of(&b, degree, noise);
    here = left > 0.0 ? left : right;
    one = here == 1.0 ? going : 0.0;
    COMMON_UNROLLED for (int k = 0; k <= degree; k++) {
        w->b[k][i] = going > 0.0 ? left > 0.0 ? a.b[k] : b.b[k] : p.b[k];
        behind->b[k][i] = b.b[k];
    }
    behind->lo[i] = middle;
    behind->hi[i] = hi;
    behind->changes[i] = left > 0.0 ? going * right : 0.0;
    w->lo[i] = going > 0.0 ? left > 0.0 ? lo : middle : lo;
    w->hi[i] = going > 0.0 ? left > 0.0 ? middle : hi : hi;
    w->going[i] = here > 1.0 ? going : 0.0;
    w->none[i] = here > 0.0 ? 0.0 : going;
    if (certain)
        w->least[i] = going > 0.0 ? least_of(&b, degree, least_of(&a, degree, w->least[i])) : w->least[i];
    out->found[i] = found + one;
    out->more[i] = left > 0.0 ? more + going * right : more;
}

/* What was left behind last lies before all else that was. */
static void go_back(int degree, uint32_t i, parts *w, halves *behind, int turn, common_first_of_bernsteins *out)
{
    while (turn >= 0 && !(behind[turn].changes[i] > 0.0))
        turn--;
    if (turn < 0)
        return;
    for (int k = 0; k <= degree; k++)
        w->b[k][i] = behind[turn].b[k][i];
    w->lo[i] = behind[turn].lo[i];
    w->hi[i] = behind[turn].hi[i];
    w->going[i] = behind[turn].changes[i] > 1.0 ? 1.0 : 0.0;
    out->found[i] = behind[turn].changes[i] == 1.0 ? 1.0 : 0.0;
    out->more[i] -= behind[turn].changes[i];
    behind[turn].changes[i] = 0.0;
}

static void go_back_some(int degree, parts *w, halves *behind, int turn, common_first_of_bernsteins *out)
{
    for (uint32_t i = 0; i < N; i++)
        if (w->none[i] > 0.0 && out->more[i] > 0.0)
            go_back(degree, i, w, behind, turn, out);
}

/* Where the line between the values at the ends crosses zero; how the curve goes there. A first root that is not beyond leaves others. */
typedef struct polishing { lane c[MOST + 1], slope[MOST], bend[MOST - 1], lo, hi, rise, going; } polishing;

/* Polynomials in u and 1 - u, as in bernstein.c. */
COMMON_INLINE double choose_of(int n, int k)
{
    double c = 1.0;

    COMMON_UNROLLED for (int i = 0; i < k; i++)
        c = c * (n - i) / (i + 1);
    return c;
}

COMMON_INLINE void place(const common_bernsteins *of, int degree, uint32_t i, const parts *w, common_first_of_bernsteins *out, polishing *p)
{
    const double first = w->b[0][i], last = w->b[degree][i], lo = w->lo[i], hi = w->hi[i], beyond = of->beyond[i], within = of->within[i];
    const double enough = lo > beyond ? hi < within ? 0.0 : 1.0 : 1.0, found = out->found[i];

    COMMON_UNROLLED for (int k = 0; k <= degree; k++) {
        const double b = of->b[k][i], n = choose_of(degree, k), next = of->b[k < degree ? k + 1 : k][i], third = of->b[k + 2 <= degree ? k + 2 : k][i];

        p->c[k][i] = n * b;
        if (k < degree)
            p->slope[k][i] = n * (degree - k) * (next - b);
        if (k + 1 < degree)
            p->bend[k][i] = 0.5 * n * (degree - k) * (degree - k - 1) * ((third - next) - (next - b));
    }
    p->lo[i] = lo;
    p->hi[i] = hi;
    p->rise[i] = last >= 0.0 ? 1.0 : -1.0;
    p->going[i] = found * enough;
    out->root[i] = lo + (hi - lo) * (first / (first - last));
}

COMMON_INLINE double sum_at(lane *c, int degree, uint32_t i, double u, double v)
{
    double sum = c[0][i], power = u;

    COMMON_UNROLLED for (int k = 1; k <= degree; k++) {
        sum = sum * v + c[k][i] * power;
        power *= u;
    }
    return sum;
}

COMMON_INLINE void step(int degree, uint32_t i, polishing *p, common_first_of_bernsteins *io)
{
    static const double SMALL = 0x1p-24, SMALLER = 0x1p-30, BESIDE = 0x1p-40;
    const double x = io->root[i], v = 1.0 - x, going = p->going[i], rise = p->rise[i], before = p->lo[i], behind = p->hi[i];
    const double value = sum_at(p->c, degree, i, x, v), slope = sum_at(p->slope, degree - 1, i, x, v), square = slope * slope;
    const double bend = value * sum_at(p->bend, degree - 2, i, x, v), straight = fabs(bend) <= 0.5 * square ? 1.0 : 0.0;
    const double newton = x - value * slope / (straight > 0.0 ? square - bend : square);
    const double side = value > 0.0 ? rise : -rise, hi = side > 0.0 ? x : behind, lo = side > 0.0 ? before : x, middle = 0.5 * (lo + hi);
    const double forward = slope > 0.0 ? rise : -rise, near = newton >= lo - BESIDE ? newton <= hi + BESIDE ? forward : -1.0 : -1.0;
    const double lower = newton < lo ? lo : newton, held = newton < lo ? lower : newton > hi ? hi : lower, next = near > 0.0 ? held : middle;

    p->lo[i] = lo;
    p->hi[i] = hi;
    io->root[i] = going > 0.0 ? next : x;
    p->going[i] = fabs(next - x) <= (straight > 0.0 ? SMALL : SMALLER) ? 0.0 : going;
}

COMMON_INLINE bool is_any(const double *flags)
{
    double sum[N / 2];

    for (uint32_t i = 0; i < N / 2; i++)
        sum[i] = flags[i] + flags[i + N / 2];
    return sum[0] + sum[1] + sum[2] + sum[3] > 0.0;
}

/* A function a degree, whose loops are unrolled. certain: it is asked for. */
#define OF_DEGREE(name, d, certain)                                                                                                   \
    COMMON_SEPARATE static void begin_##name(const common_bernsteins *restrict of, parts *restrict w, common_first_of_bernsteins *restrict out)\
    {                                                                                                                                 \
        for (uint32_t i = 0; i < N; i++)                                                                                              \
            begin(of, d, certain, i, w, out);                                                                                         \
    }                                                                                                                                 \
    COMMON_SEPARATE static void advance_##name(const common_bernsteins *restrict of, parts *restrict w, halves *restrict behind,     \
                                          common_first_of_bernsteins *restrict out)                                                   \
    {                                                                                                                                 \
        COMMON_LOOP for (uint32_t i = 0; i < N; i++)                                                                                  \
            advance(of, d, certain, i, w, behind, out);                                                                               \
    }                                                                                                                                 \
    COMMON_SEPARATE static void place_##name(const common_bernsteins *restrict of, const parts *restrict w,                           \
                                        common_first_of_bernsteins *restrict out, polishing *restrict p)                              \
    {                                                                                                                                 \
        for (uint32_t i = 0; i < N; i++)                                                                                              \
            place(of, d, i, w, out, p);                                                                                               \
    }                                                                                                                                 \
    COMMON_SEPARATE static void step_##name(polishing *restrict p, common_first_of_bernsteins *restrict io)                           \
    {                                                                                                                                 \
        COMMON_LOOP for (uint32_t i = 0; i < N; i++)                                                                                  \
            step(d, i, p, io);                                                                                                        \
    }                                                                                                                                 \
    static void first_##name(const common_bernsteins *of, common_first_of_bernsteins *out)                                            \
    {                                                                                                                                 \
        halves behind[HALVINGS];                                                                                                      \
        polishing p;                                                                                                                  \
        parts w;                                                                                                                      \
                                                                                                                                      \
        begin_##name(of, &w, out);                                                                                                    \
        for (int turn = 0; turn < HALVINGS && is_any(w.going); turn++) {                                                              \
            advance_##name(of, &w, &behind[turn], out);                                                                               \
            if (is_any(w.none))                                                                                                       \
                go_back_some(d, &w, behind, turn, out);                                                                               \
        }                                                                                                                             \
        for (uint32_t i = 0; i < N; i++)                                                                                              \
            out->open[i] = w.going[i] > 0.0 || (certain && !(w.least[i] > of->noise[i])) ? 1.0 : out->open[i];                        \
        if (!is_any(out->found))                                                                                                      \
            return;                                                                                                                   \
        place_##name(of, &w, out, &p);                                                                                                \
        for (int turn = 0; turn < TURNS && is_any(p.going); turn++)                                                                   \
            step_##name(&p, out);                                                                                                     \
        for (uint32_t i = 0; i < N; i++)                                                                                              \
            if (out->found[i] > 0.0 && !(out->root[i] > of->beyond[i])) {                                                             \
                out->found[i] = 0.0;                                                                                                  \
                out->before[i] = out->more[i] > 0.0 ? 0.0 : 1.0;                                                                      \
                out->open[i] = 1.0;                                                                                                   \
            }                                                                                                                         \
    }

OF_DEGREE(3, 3, false)
OF_DEGREE(4, 4, false)
OF_DEGREE(6, 6, false)
OF_DEGREE(certain_3, 3, true)
OF_DEGREE(certain_4, 4, true)

void common_bernstein_first_many(const common_bernsteins *of, int degree, common_first_of_bernsteins *out)
{
    switch (degree) {
    case 3: first_3(of, out); break;
    case 4: first_4(of, out); break;
    default: first_6(of, out); break;
    }
}

void common_bernstein_certain_many(const common_bernsteins *of, int degree, common_first_of_bernsteins *out)
{
    (degree == 3 ? first_certain_3 : first_certain_4)(of, out);
}
