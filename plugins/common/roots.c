#include "common/roots.h"

#include "common/local.h"

/* Positions to divide an interval at, tried in turn until the polynomial has a certain sign there. */
static const double cuts[] = { 0.5, 0.4375, 0.5625, 0.375, 0.625, 0.46875 };
enum { CUTS = sizeof cuts / sizeof cuts[0], DEPTH = 26, DEPTH_TWO = 52 };

/* Bernstein coefficients of x^k on -1..1, by degree: row k. None is larger than one, so errors just add up. */
#define THIRD { 0x1.5555555555555p-2, 0x1.5555555555555p-56 }
#define MINUS_THIRD { -0x1.5555555555555p-2, -0x1.5555555555555p-56 }
#define ONE { 1.0, 0.0 }
#define MINUS_ONE { -1.0, 0.0 }
#define HALF { 0.5, 0.0 }
#define MINUS_HALF { -0.5, 0.0 }
#define ZERO { 0.0, 0.0 }
static const pov_two basis[2][5][5] = {
    { { ONE, ONE, ONE, ONE, ZERO },
      { MINUS_ONE, MINUS_THIRD, THIRD, ONE, ZERO },
      { ONE, MINUS_THIRD, MINUS_THIRD, ONE, ZERO },
      { MINUS_ONE, ONE, MINUS_ONE, ONE, ZERO },
      { ZERO, ZERO, ZERO, ZERO, ZERO } },
    { { ONE, ONE, ONE, ONE, ONE },
      { MINUS_ONE, MINUS_HALF, ZERO, HALF, ONE },
      { ONE, ZERO, MINUS_THIRD, ZERO, ONE },
      { MINUS_ONE, HALF, ZERO, MINUS_HALF, ONE },
      { ONE, MINUS_ONE, ONE, MINUS_ONE, ONE } },
};

/* The most sign changes that open signs (0) allow; more than one is MANY. */
enum { MANY = 9 };

static int changes_of(const int *sign, int degree)
{
    int sum = 0, previous = 0, open = 0, i;

    for (i = 0; i <= degree; i++) {
        if (sign[i] == 0) {
            open++;
            continue;
        }
        if (previous != 0 && sign[i] != previous)
            sum += open > 1 ? MANY : 1;
        else if (previous != 0 && open > 0)
            sum += MANY;
        else if (previous == 0 && open > 0)
            sum += MANY;
        previous = sign[i];
        open = 0;
    }
    return open > 0 ? sum + MANY : sum;
}

/* `part`: of the interval, where the root is about. */
static void put(common_brackets *out, double lo, double hi, double part, bool rising)
{
    const common_bracket one = { lo, hi, lo + (hi - lo) * part, rising };

    if (out->count < COMMON_ROOTS_MAX)
        out->at[out->count++] = one;
}

/* ---- in double ---- */

COMMON_INLINE double largest_of(const double *b, int degree)
{
    double most = 0.0;

    for (int i = 0; i <= degree; i++)
        most = fabs(b[i]) > most ? fabs(b[i]) : most;
    return most;
}

/* De Casteljau's scheme at a fraction of the interval. */
COMMON_INLINE void divide(const double *b, int degree, double at, double *left, double *right)
{
    double w[COMMON_DEGREE_MAX + 1];

    for (int i = 0; i <= degree; i++)
        w[i] = b[i];
    for (int k = 0; k <= degree; k++) {
        left[k] = w[0];
        right[degree - k] = w[degree - k];
        for (int i = 0; i < degree - k; i++)
            w[i] += at * (w[i + 1] - w[i]);
    }
}

/* The sign changes of certain signs are those of neighbours. */
COMMON_INLINE int count_changes(const double *b, int degree, double error)
{
    int sign[COMMON_DEGREE_MAX + 1], open = 0, changes = 0, i;

    for (i = 0; i <= degree; i++) {
        sign[i] = (b[i] > error) - (b[i] < -error);
        open += sign[i] == 0;
    }
    for (i = 0; i < degree; i++)
        changes += sign[i] != sign[i + 1];
    return open > 0 ? changes_of(sign, degree) : changes;
}

/* Where the polygon of the coefficients, which change their sign once, crosses zero. */
COMMON_INLINE double crossing_of(const double *b, int degree)
{
    int i = 0;

    while (i < degree - 1 && (b[i + 1] > 0.0) == (b[0] > 0.0))
        i++;
    return (i + b[i] / (b[i] - b[i + 1])) / degree;
}

/* A part of the interval that is still to be decided. */
typedef struct piece { double b[COMMON_DEGREE_MAX + 1], lo, hi, error; int depth; } piece;

/* Divide the piece in two: the left one takes its place, the right one follows it. False: there is no certain sign. */
COMMON_INLINE bool divide_piece(piece *p, int degree)
{
    double left[COMMON_DEGREE_MAX + 1], right[COMMON_DEGREE_MAX + 1];
    const double error = p->error + 0x1p-53 * (degree + 1) * largest_of(p->b, degree);

    for (int i = 0; p->depth < DEPTH && i < CUTS; i++) {
        divide(p->b, degree, cuts[i], left, right);
        if (!(fabs(left[degree]) > 2.0 * error))
            continue;
        for (int k = 0; k <= degree; k++) {
            p[1].b[k] = left[k];
            p[0].b[k] = right[k];
        }
        p[1].lo = p[0].lo;
        p[1].hi = p[0].lo = p[0].lo + (p[0].hi - p[0].lo) * cuts[i];
        p[0].error = p[1].error = error;
        p[1].depth = ++p[0].depth;
        return true;
    }
    return false;
}

/* Leave out what lies before the roots that are wanted, if there is certainly no root between the ends of that. */
COMMON_INLINE void begin_ahead(const double *a, int degree, common_range wanted, piece *p)
{
    double left[COMMON_DEGREE_MAX + 1], right[COMMON_DEGREE_MAX + 1];
    const double across = 2.0 * (wanted.ahead - wanted.from) + COMMON_ASIDE, cut = wanted.from + across;
    const double error = p->error + 0x1p-53 * (degree + 1) * largest_of(p->b, degree);
    double steepest = 0.0;

    if (!(wanted.first && wanted.ahead > -1.0 && cut < 1.0))
        return;
    for (int k = 1; k <= degree; k++)
        steepest += k * fabs(a[k]);
    divide(p->b, degree, 0.5 * (cut + 1.0), left, right);
    if (!(fabs(right[0]) > 2.0 * error + steepest * across))
        return;
    for (int k = 0; k <= degree; k++)
        p->b[k] = right[k];
    p->lo = cut;
    p->error = error;
}

COMMON_INLINE bool isolate(const double *a, double error, int degree, common_range wanted, common_brackets *out)
{
    piece stack[DEPTH + 2], *top = stack;
    double sum = 0.0;

    out->count = 0;
    for (int i = 0; i <= degree; i++) {
        top->b[i] = 0.0;
        sum += fabs(a[i]);
        for (int k = 0; k <= degree; k++)
            top->b[i] += a[k] * basis[degree - 3][k][i].hi;
    }
    top->error = error + (degree + 4) * 0x1p-53 * sum;
    top->lo = -1.0;
    top->hi = 1.0;
    top->depth = 0;
    begin_ahead(a, degree, wanted, top);
    while (top >= stack) {
        const bool aside = top->hi < wanted.from || top->lo > wanted.to;
        const int changes = aside ? 0 : count_changes(top->b, degree, top->error);

        if (changes == 1)
            put(out, top->lo, top->hi, crossing_of(top->b, degree), top->b[degree] > 0.0);
        if (changes == 1 && wanted.first && top->lo > wanted.ahead)
            return true;
        if (changes <= 1)
            top--;
        else if (divide_piece(top, degree))
            top++;
        else
            return false;
    }
    return true;
}

/* Loops of a constant degree are unrolled. */
bool common_isolate(const double *a, double error, int degree, common_range wanted, common_brackets *out)
{
    return degree == 4 ? isolate(a, error, 4, wanted, out) : isolate(a, error, 3, wanted, out);
}

/* ---- in double-double ---- */

static void divide_two(const pov_two *b, int degree, double at, pov_two *left, pov_two *right)
{
    pov_two w[COMMON_DEGREE_TWO_MAX + 1];

    for (int i = 0; i <= degree; i++)
        w[i] = b[i];
    for (int k = 0; k <= degree; k++) {
        left[k] = w[0];
        right[degree - k] = w[degree - k];
        for (int i = 0; i < degree - k; i++)
            w[i] = pov_two_add(w[i], pov_two_mul_double(pov_two_sub(w[i + 1], w[i]), at));
    }
}

/* What the coefficients are off by is divided as they are, with what the roundings of that add. */
static void divide_off(const pov_two *b, const double *off, int degree, double at, double *left, double *right)
{
    double w[COMMON_DEGREE_TWO_MAX + 1];

    for (int i = 0; i <= degree; i++)
        w[i] = off[i] + 0x1p-102 * (degree + 1) * fabs(b[i].hi);
    for (int k = 0; k <= degree; k++) {
        left[k] = w[0];
        right[degree - k] = w[degree - k];
        for (int i = 0; i < degree - k; i++)
            w[i] += (w[i + 1] - w[i]) * at;
    }
}

static void isolate_two(const pov_two *b, const double *off, int degree, double lo, double hi, int depth, common_brackets *out)
{
    pov_two left[COMMON_DEGREE_TWO_MAX + 1], right[COMMON_DEGREE_TWO_MAX + 1];
    double left_off[COMMON_DEGREE_TWO_MAX + 1], right_off[COMMON_DEGREE_TWO_MAX + 1];
    int sign[COMMON_DEGREE_TWO_MAX + 1], changes, i;

    for (i = 0; i <= degree; i++)
        sign[i] = b[i].hi > off[i] ? 1 : b[i].hi < -off[i] ? -1 : 0;
    changes = changes_of(sign, degree);
    if (changes == 1)
        put(out, lo, hi, 0.5, sign[degree] > 0);
    if (changes <= 1)
        return;
    for (i = 0; depth < DEPTH_TWO && i < CUTS; i++) {
        const double middle = lo + (hi - lo) * cuts[i];

        divide_two(b, degree, cuts[i], left, right);
        divide_off(b, off, degree, cuts[i], left_off, right_off);
        if (fabs(left[degree].hi) > 2.0 * left_off[degree]) {
            isolate_two(left, left_off, degree, lo, middle, depth + 1, out);
            isolate_two(right, right_off, degree, middle, hi, depth + 1, out);
            return;
        }
    }
    /* A double root, as far as can be told. If the signs at the ends are certain and differ, there is one crossing all
     * the same. */
    if (sign[0] * sign[degree] < 0)
        put(out, lo, hi, 0.5, sign[degree] > 0);
}

void common_isolate_bernstein_two(const pov_two *b, const double *off, int degree, common_brackets *out)
{
    out->count = 0;
    isolate_two(b, off, degree, 0.0, 1.0, 0, out);
}

void common_isolate_two(const pov_two *a, double error, int degree, common_brackets *out)
{
    pov_two b[COMMON_DEGREE_MAX + 1];
    double sum = 0.0, off[COMMON_DEGREE_MAX + 1];

    out->count = 0;
    for (int i = 0; i <= degree; i++) {
        b[i] = pov_two_of(0.0, 0.0);
        sum += fabs(a[i].hi);
        for (int k = 0; k <= degree; k++)
            b[i] = pov_two_add(b[i], pov_two_mul(a[k], basis[degree - 3][k][i]));
    }
    for (int i = 0; i <= degree; i++)
        off[i] = error + (degree + 4) * 0x1p-101 * sum;
    isolate_two(b, off, degree, -1.0, 1.0, 0, out);
}

/* ---- the root ---- */

/* Newton's method kept in the bracket. A step below SMALL leaves an error of its square. */
COMMON_INLINE double polish(const double *a, int degree, const common_bracket *root)
{
    static const double SMALL = 0x1p-24;
    double lo = root->lo, hi = root->hi, x = root->start;

    for (int turn = 0; turn < 64; turn++) {
        double value = a[degree], slope = 0.0, next;
        bool is_behind;

        for (int i = degree - 1; i >= 0; i--) {
            slope = slope * x + value;
            value = value * x + a[i];
        }
        is_behind = (value > 0.0) == root->rising;
        hi = is_behind ? x : hi;
        lo = is_behind ? lo : x;
        next = slope != 0.0 ? x - value / slope : lo;
        if (!(next > lo && next < hi))
            next = 0.5 * (lo + hi);
        if (fabs(next - x) <= SMALL)
            return next;
        x = next;
    }
    return x;
}

double common_polish(const double *a, int degree, const common_bracket *root)
{
    return degree == 4 ? polish(a, 4, root) : polish(a, 3, root);
}
