#include "common/bernstein.h"
#include "common/local.h"

enum { DEPTH = 52 };

/* A root between lo and hi; where a straight line between the values there crosses zero. */
typedef struct bracket { double lo, hi, start; bool rising; } bracket;
typedef struct brackets { uint32_t count; bracket at[COMMON_BERNSTEIN_MAX]; } brackets;

static void put(brackets *out, const double *b, int degree, double lo, double hi)
{
    const bracket one = { lo, hi, lo + (hi - lo) * (b[0] / (b[0] - b[degree])), b[degree] >= 0.0 };

    if (out->count < COMMON_BERNSTEIN_MAX)
        out->at[out->count++] = one;
}

static double largest(const double *b, int degree)
{
    double most = 0.0;

    for (int i = 0; i <= degree; i++)
        most = fabs(b[i]) > most ? fabs(b[i]) : most;
    return most;
}

/* De Casteljau's scheme at the middle. */
COMMON_INLINE void halve_of(const double *b, int degree, double *left, double *right)
{
    double w[COMMON_BERNSTEIN_MAX + 1];

    for (int i = 0; i <= degree; i++)
        w[i] = b[i];
    for (int k = 0; k <= degree; k++) {
        left[k] = w[0];
        right[degree - k] = w[degree - k];
        for (int i = 0; i < degree - k; i++)
            w[i] = 0.5 * (w[i] + w[i + 1]);
    }
}

static void halve(const double *b, int degree, double *left, double *right)
{
    switch (degree) {
    case 3: halve_of(b, 3, left, right); break;
    case 4: halve_of(b, 4, left, right); break;
    case 6: halve_of(b, 6, left, right); break;
    default: halve_of(b, degree, left, right); break;
    }
}

COMMON_INLINE void bernstein_of(const double *a, int degree, double *b)
{
    double binomial = 1.0;             /* degree over i*/

    for (int i = 0; i <= degree; i++) {
        b[i] = a[i] / binomial;
        binomial = binomial * (degree - i) / (i + 1);
    }
    for (int k = 1; k <= degree; k++)
        for (int i = degree; i >= k; i--)
            b[i] += b[i - 1];
}

void common_bernstein(const double *a, int degree, double *b)
{
    switch (degree) {
    case 2: bernstein_of(a, 2, b); break;
    case 3: bernstein_of(a, 3, b); break;
    case 4: bernstein_of(a, 4, b); break;
    case 6: bernstein_of(a, 6, b); break;
    default: bernstein_of(a, degree, b); break;
    }
}

double common_bernstein_noise(const double *b, int degree) { return 4.0 * 0x1p-53 * (degree + 1) * largest(b, degree); }

/* The sign changes of the coefficients, where those within the noise change nothing. */
static int count_changes(const double *b, int degree, double noise)
{
    bool above = b[0] >= 0.0;
    int changes = 0;

    for (int i = 1; i < degree; i++)
        if (fabs(b[i]) > noise && (b[i] > 0.0) != above) {
            above = !above;
            changes++;
        }
    return changes + ((b[degree] >= 0.0) != above);
}

static void decide(const double *b, int degree, double noise, double lo, double hi, int depth, brackets *out)
{
    double left[COMMON_BERNSTEIN_MAX + 1], right[COMMON_BERNSTEIN_MAX + 1];
    const int changes = count_changes(b, degree, noise);
    const double middle = 0.5 * (lo + hi);

    if (changes == 1 || (depth == DEPTH && changes % 2 == 1))
        put(out, b, degree, lo, hi);
    if (changes <= 1 || depth == DEPTH)
        return;
    halve(b, degree, left, right);
    decide(left, degree, noise, lo, middle, depth + 1, out);
    decide(right, degree, noise, middle, hi, depth + 1, out);
}

/* ---- the root ---- */

/* The value is the sum of c[i] u^i v^(n-i), v = 1 - u, and so is the slope: stable on the whole of 0..1. */
typedef struct weighted { double c[COMMON_BERNSTEIN_MAX + 1], slope[COMMON_BERNSTEIN_MAX]; } weighted;

static void weigh(const double *b, int degree, weighted *out)
{
    double binomial = 1.0;             /* degree over i */

    for (int i = 0; i <= degree; i++) {
        out->c[i] = binomial * b[i];
        if (i < degree)
            out->slope[i] = binomial * (degree - i) * (b[i + 1] - b[i]);
        binomial = binomial * (degree - i) / (i + 1);
    }
}

COMMON_INLINE double sum_at(const double *c, int degree, double u, double v)
{
    double sum = c[0], power = u;

    for (int i = 1; i <= degree; i++) {
        sum = sum * v + c[i] * power;
        power *= u;
    }
    return sum;
}

/* Newton's method kept in the bracket. A step below SMALL leaves an error of its square. */
COMMON_INLINE double polish_of(const weighted *w, int degree, const bracket *root)
{
    static const double SMALL = 0x1p-30, BESIDE = 0x1p-40;
    double lo = root->lo, hi = root->hi, x = root->start;

    for (int turn = 0; turn < 80; turn++) {
        const double v = 1.0 - x, value = sum_at(w->c, degree, x, v);
        double next = x - value / sum_at(w->slope, degree - 1, x, v);

        *((value > 0.0) == root->rising ? &hi : &lo) = x;
        if (next >= lo - BESIDE && next <= hi + BESIDE)
            next = next < lo ? lo : next > hi ? hi : next;
        else
            next = 0.5 * (lo + hi);
        if (fabs(next - x) <= SMALL)
            return next;
        x = next;
    }
    return x;
}

/* The loops of small degrees are unrolled. */
static double polish(const weighted *w, int degree, const bracket *root)
{
    switch (degree) {
    case 3: return polish_of(w, 3, root);
    case 4: return polish_of(w, 4, root);
    case 6: return polish_of(w, 6, root);
    default: return polish_of(w, degree, root);
    }
}

/* ---- of second degree ---- */

/* w / (1 + w) for w = a / b, both of one sign. */
static double fraction_of(double a, double b) { return a + b != 0.0 ? a / (a + b) : a; }

/* With w = u / (1 - u) it is b2 w^2 + 2 b1 w + b0 = 0: the products of its roots and of q are known. */
static uint32_t solve_quadratic(const double *b, double noise, double *root)
{
    const bool from = b[0] >= 0.0, to = b[2] >= 0.0;
    const double d = b[1] * b[1] - b[0] * b[2];
    double q, one, other;

    if (from == to && !(d > 0.0 && fabs(b[1]) > noise && (b[1] > 0.0) != from))
        return 0;
    q = b[1] > 0.0 ? -b[1] - sqrt(d) : sqrt(d) - b[1];
    if (from != to) {
        root[0] = (q > 0.0) == to ? fraction_of(q, b[2]) : fraction_of(b[0], q);
        return 1;
    }
    one = fraction_of(q, b[2]);
    other = fraction_of(b[0], q);
    root[0] = fmin(one, other);
    root[1] = fmax(one, other);
    return 2;
}

uint32_t common_bernstein_roots(const double *b, int degree, double noise, double *root)
{
    brackets found;
    weighted w;

    if (degree == 1) {
        root[0] = b[0] / (b[0] - b[1]);
        return (b[0] >= 0.0) != (b[1] >= 0.0);
    }
    if (degree == 2)
        return solve_quadratic(b, noise, root);
    found.count = 0;
    decide(b, degree, noise, 0.0, 1.0, 0, &found);
    if (found.count > 0)
        weigh(b, degree, &w);
    for (uint32_t i = 0; i < found.count; i++)
        root[i] = polish(&w, degree, &found.at[i]);
    return found.count;
}
