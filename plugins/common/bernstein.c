#include "common/bernstein.h"

enum { DEPTH = 52 };

/* A root between lo and hi. */
typedef struct bracket { double lo, hi; bool rising; } bracket;
typedef struct brackets { uint32_t count; bracket at[COMMON_BERNSTEIN_MAX]; } brackets;

static void put(brackets *out, double lo, double hi, bool rising)
{
    const bracket one = { lo, hi, rising };

    if (out->count < COMMON_BERNSTEIN_MAX)
        out->at[out->count++] = one;
}

static double largest(const double *b, int degree)
{
    double most = 0.0;

    for (int i = 0; i <= degree; i++)
        most = fmax(most, fabs(b[i]));
    return most;
}

/* De Casteljau's scheme at the middle. */
static void halve(const double *b, int degree, double *left, double *right)
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

void common_bernstein(const double *a, int degree, double *b)
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
        put(out, lo, hi, b[degree] >= 0.0);
    if (changes <= 1 || depth == DEPTH)
        return;
    halve(b, degree, left, right);
    decide(left, degree, noise, lo, middle, depth + 1, out);
    decide(right, degree, noise, middle, hi, depth + 1, out);
}

static double bernstein_value(const double *b, int degree, double at, double *slope)
{
    double w[COMMON_BERNSTEIN_MAX + 1];

    for (int i = 0; i <= degree; i++)
        w[i] = b[i];
    for (int k = degree; k > 1; k--)
        for (int i = 0; i < k; i++)
            w[i] += at * (w[i + 1] - w[i]);
    *slope = degree * (w[1] - w[0]);
    return w[0] + at * (w[1] - w[0]);
}

/* Newton's method kept in the bracket. */
static double polish_bernstein(const double *b, int degree, const bracket *root)
{
    double lo = root->lo, hi = root->hi, x = 0.5 * (lo + hi);

    for (int turn = 0; turn < 80; turn++) {
        double slope, next;
        const double value = bernstein_value(b, degree, x, &slope);

        *((value > 0.0) == root->rising ? &hi : &lo) = x;
        next = x - value / slope;
        if (!(next >= lo && next <= hi))
            next = 0.5 * (lo + hi);
        if (fabs(next - x) <= 0x1p-50)
            return next;
        x = next;
    }
    return x;
}

uint32_t common_bernstein_roots(const double *b, int degree, double noise, double *root)
{
    brackets found;

    if (degree == 1) {
        root[0] = b[0] / (b[0] - b[1]);
        return (b[0] >= 0.0) != (b[1] >= 0.0);
    }
    found.count = 0;
    decide(b, degree, noise, 0.0, 1.0, 0, &found);
    for (uint32_t i = 0; i < found.count; i++)
        root[i] = polish_bernstein(b, degree, &found.at[i]);
    return found.count;
}
