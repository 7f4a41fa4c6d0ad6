#include "common/bernstein.h"
#include "common/local.h"

enum { DEPTH = 52, CERTAIN_DEPTH = 26, MANY = 64 };

/* A root between lo and hi; where a straight line between the values there crosses zero. */
typedef struct bracket { double lo, hi, start; bool rising; } bracket;
typedef struct brackets { uint32_t count; bracket at[COMMON_BERNSTEIN_MAX]; } brackets;

static void put(brackets *out, const double *b, int degree, double lo, double hi)
{
    const bracket one = { lo, hi, lo + (hi - lo) * (b[0] / (b[0] - b[degree])), b[degree] >= 0.0 };

    if (out->count < COMMON_BERNSTEIN_MAX)
        out->at[out->count++] = one;
}

COMMON_INLINE double largest_of(const double *b, int degree)
{
    double most = 0.0;

    for (int i = 0; i <= degree; i++)
        most = fabs(b[i]) > most ? fabs(b[i]) : most;
    return most;
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

double common_bernstein_noise(const double *b, int degree)
{
    switch (degree) {
    case 3: return 4.0 * 0x1p-53 * (3 + 1) * largest_of(b, 3);
    case 4: return 4.0 * 0x1p-53 * (4 + 1) * largest_of(b, 4);
    default: return 4.0 * 0x1p-53 * (degree + 1) * largest_of(b, degree);
    }
}

static double value_of(const double *b, int degree, double u)
{
    double w[4] = { b[0], b[1], b[2], b[degree] };

    for (int k = degree; k > 0; k--)
        for (int i = 0; i < k; i++)
            w[i] += (w[i + 1] - w[i]) * u;
    return w[0];
}

/* Where the slope is zero, one or two places. */
static void turning_points(const double *b, int degree, double u[2])
{
    const double first = b[1] - b[0], second = b[2] - b[1], third = b[degree] - b[2];
    const double bent = degree == 3 ? first - 2.0 * second + third : 0.0, half = degree == 3 ? second - first : 0.5 * (second - first);
    const double square = half * half - bent * first, q = -(half + copysign(sqrt(pov_max(square, 0.0)), half));

    u[0] = first / q;
    u[1] = q / bent;
}

void common_bernstein_widen(const double *b, int degree, double *lo, double *hi)
{
    const double least = pov_min(b[0], b[degree]), most = pov_max(b[0], b[degree]), noise = 0x1p-48 * largest_of(b, degree);
    double u[2];

    *lo = pov_min(*lo, least);
    *hi = pov_max(*hi, most);
    if (degree < 2 || (pov_min(b[1], b[degree - 1]) >= least && pov_max(b[1], b[degree - 1]) <= most))
        return;
    turning_points(b, degree, u);
    for (int i = 0; i < 2; i++) {
        if (!(u[i] > 0.0 && u[i] < 1.0))
            continue;
        *lo = pov_min(*lo, value_of(b, degree, u[i]) - noise);
        *hi = pov_max(*hi, value_of(b, degree, u[i]) + noise);
    }
}

/* From both ends, each up to where its own steps lose nothing. */
void common_bernstein_divide(const double *b, int degree, double at, double *q)
{
    for (int k = 0; k < degree * at && k < degree; k++)
        q[k] = ((k > 0 ? k * (1.0 - at) * q[k - 1] : 0.0) - degree * b[k]) / ((degree - k) * at);
    for (int k = degree; k >= degree * at + 1.0 && k > 0; k--)
        q[k - 1] = ((k < degree ? (degree - k) * at * q[k] : 0.0) + degree * b[k]) / (k * (1.0 - at));
}

/* The sign changes of the coefficients, where those within the noise change nothing. */
COMMON_INLINE int count_changes(const double *b, int degree, double noise)
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

/* A part of the interval that is still to be decided. */
typedef struct part { double b[COMMON_BERNSTEIN_MAX + 1], lo, hi; int depth; } part;

/* The whole. */
COMMON_INLINE void begin(part *p, const double *b, int degree)
{
    for (int i = 0; i <= degree; i++)
        p->b[i] = b[i];
    p->lo = 0.0;
    p->hi = 1.0;
    p->depth = 0;
}

/* De Casteljau's scheme at the middle: the left part follows, and the right one takes the place of both. */
COMMON_INLINE void halve(part *p, int degree)
{
    part *left = p + 1;
    double w[COMMON_BERNSTEIN_MAX + 1];

    for (int i = 0; i <= degree; i++)
        w[i] = p->b[i];
    for (int k = 0; k <= degree; k++) {
        left->b[k] = w[0];
        p->b[degree - k] = w[degree - k];
        for (int i = 0; i < degree - k; i++)
            w[i] = 0.5 * (w[i] + w[i + 1]);
    }
    left->lo = p->lo;
    left->hi = p->lo = 0.5 * (p->lo + p->hi);
    left->depth = ++p->depth;
}

/* Brackets of roots from left to right, up to the first that is certainly beyond a place. */
COMMON_INLINE void isolate_of(const double *b, int degree, double noise, double beyond, brackets *out)
{
    const int all = count_changes(b, degree, noise);
    part stack[DEPTH + 1], *top = stack;

    if (all == 1)
        put(out, b, degree, 0.0, 1.0);
    if (all <= 1)
        return;
    begin(top, b, degree);
    while (top >= stack) {
        const int changes = count_changes(top->b, degree, noise);

        if (changes == 1 || (top->depth == DEPTH && changes % 2 == 1)) {
            put(out, top->b, degree, top->lo, top->hi);
            if (top->lo > beyond)
                return;
        }
        if (changes <= 1 || top->depth == DEPTH)
            top--;
        else
            halve(top++, degree);
    }
}

/* The loops of small degrees are unrolled. */
static void isolate(const double *b, int degree, double noise, double beyond, brackets *out)
{
    switch (degree) {
    case 3: isolate_of(b, 3, noise, beyond, out); break;
    case 4: isolate_of(b, 4, noise, beyond, out); break;
    case 6: isolate_of(b, 6, noise, beyond, out); break;
    default: isolate_of(b, degree, noise, beyond, out); break;
    }
}

/* ---- certain brackets ---- */

/* Where some signs are open: a single one between two that differ changes nothing. */
static int count_around_open(const double *b, int degree, double noise)
{
    int changes = 0, open = 0, previous = 0;

    for (int i = 0; i <= degree; i++) {
        const int sign = (b[i] > noise) - (b[i] < -noise);

        if (sign == 0) {
            open++;
            continue;
        }
        changes += open > (previous == -sign) ? MANY : previous == -sign;
        previous = sign;
        open = 0;
    }
    return changes + open * MANY;
}

/* The most sign changes that the errors of the coefficients allow; MANY or more where they leave them open. */
COMMON_INLINE int count_certain(const double *b, int degree, double noise)
{
    double least = fabs(b[0]);
    int changes = 0;

    for (int i = 1; i <= degree; i++) {
        least = fabs(b[i]) < least ? fabs(b[i]) : least;
        changes += (b[i] > 0.0) != (b[i - 1] > 0.0);
    }
    return least > noise ? changes : count_around_open(b, degree, noise);
}

/* As isolate_of(), halved only where the value is certain. Each halving adds the roundings of so many sums. */
COMMON_INLINE bool isolate_certain_of(const double *b, int degree, double noise, double beyond, brackets *out)
{
    const int all = count_certain(b, degree, noise);
    double more;
    part stack[CERTAIN_DEPTH + 2], *top = stack;

    if (all == 1)
        put(out, b, degree, 0.0, 1.0);
    if (all <= 1)
        return true;
    if (!(fabs(b[0]) > noise && fabs(b[degree]) > noise))
        return false;
    more = COMMON_U * degree * largest_of(b, degree);
    begin(top, b, degree);
    while (top >= stack) {
        const double off = noise + top->depth * more;
        const int changes = count_certain(top->b, degree, off);

        if (changes == 1) {
            put(out, top->b, degree, top->lo, top->hi);
            if (top->lo >= beyond)
                return true;
        }
        if (changes <= 1) {
            top--;
            continue;
        }
        if (top->depth == CERTAIN_DEPTH)
            return false;
        halve(top++, degree);
        if (!(fabs(top->b[degree]) > off + more))
            return false;
    }
    return true;
}

static bool isolate_certain(const double *b, int degree, double noise, double beyond, brackets *out)
{
    switch (degree) {
    case 3: return isolate_certain_of(b, 3, noise, beyond, out);
    case 4: return isolate_certain_of(b, 4, noise, beyond, out);
    case 6: return isolate_certain_of(b, 6, noise, beyond, out);
    default: return isolate_certain_of(b, degree, noise, beyond, out);
    }
}

/* ---- the root ---- */

/* The value is the sum of c[i] u^i v^(n-i), v = 1 - u, and so are the slope and half the second derivative: stable on the whole
 * of 0..1. */
typedef struct weighted { double c[COMMON_BERNSTEIN_MAX + 1], slope[COMMON_BERNSTEIN_MAX], bend[COMMON_BERNSTEIN_MAX - 1]; } weighted;

COMMON_INLINE void weigh_of(const double *b, int degree, weighted *out)
{
    double binomial = 1.0;             /* degree over i */

    for (int i = 0; i <= degree; i++) {
        out->c[i] = binomial * b[i];
        if (i < degree)
            out->slope[i] = binomial * (degree - i) * (b[i + 1] - b[i]);
        if (i + 1 < degree)
            out->bend[i] = 0.5 * binomial * (degree - i) * (degree - i - 1) * ((b[i + 2] - b[i + 1]) - (b[i + 1] - b[i]));
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

/* Halley's method kept in the bracket, of which a step below SMALL leaves an error of its cube; where the curve bends much before the
 * root Newton's, of which a step below SMALLER leaves one of its square. Where the slope is not the root's, another root is nearer,
 * beyond the bracket. */
COMMON_INLINE double polish_of(const weighted *w, int degree, const bracket *root)
{
    static const double SMALL = 0x1p-24, SMALLER = 0x1p-30, BESIDE = 0x1p-40;
    double lo = root->lo, hi = root->hi, x = root->start;

    for (int turn = 0; turn < 80; turn++) {
        const double v = 1.0 - x, value = sum_at(w->c, degree, x, v), slope = sum_at(w->slope, degree - 1, x, v);
        const double square = slope * slope, bend = value * sum_at(w->bend, degree - 2, x, v);
        const bool is_behind = (value > 0.0) == root->rising, is_straight = fabs(bend) <= 0.5 * square;
        double next = x - value * slope / (is_straight ? square - bend : square);

        hi = is_behind ? x : hi;
        lo = is_behind ? lo : x;
        if ((slope > 0.0) == root->rising && next >= lo - BESIDE && next <= hi + BESIDE)
            next = next < lo ? lo : next > hi ? hi : next;
        else
            next = 0.5 * (lo + hi);
        if (fabs(next - x) <= (is_straight ? SMALL : SMALLER))
            return next;
        x = next;
    }
    return x;
}

static void weigh(const double *b, int degree, weighted *out)
{
    switch (degree) {
    case 3: weigh_of(b, 3, out); break;
    case 4: weigh_of(b, 4, out); break;
    case 6: weigh_of(b, 6, out); break;
    default: weigh_of(b, degree, out); break;
    }
}

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
    root[0] = pov_min(one, other);
    root[1] = pov_max(one, other);
    return 2;
}

uint32_t common_bernstein_first(const double *b, int degree, double noise, double beyond, double within, double *root)
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
    isolate(b, degree, noise, beyond, &found);
    for (uint32_t i = 0; i < found.count; i++) {
        const bracket *one = &found.at[i];
        const bool will_do = one->lo > beyond && one->hi < within;

        if (i == 0 && !will_do)
            weigh(b, degree, &w);
        root[i] = will_do ? one->start : polish(&w, degree, one);
        if (root[i] > beyond)
            return i + 1;
    }
    return found.count;
}

uint32_t common_bernstein_roots(const double *b, int degree, double noise, double *root)
{
    return common_bernstein_first(b, degree, noise, HUGE_VAL, -HUGE_VAL, root);
}

/* ---- certain roots ---- */

/* Between the ends of the interval, or one on either side of the place between where a quadratic turns. */
static bool certain_quadratic(const double *b, double noise, common_roots *out)
{
    const double square = b[1] * b[1], product = b[0] * b[2], d = square - product, turn = (b[0] - b[1]) / ((b[0] - b[1]) + (b[2] - b[1]));
    const double off = 2.0 * noise * (2.0 * fabs(b[1]) + fabs(b[0]) + fabs(b[2])) + 4.0 * COMMON_U * (square + fabs(product));
    const bool ends = fabs(b[0]) > noise && fabs(b[2]) > noise, middle = fabs(b[1]) > noise;
    double root[2];

    if (!ends || (product > 0.0 && !(middle && b[0] * b[1] > 0.0) && !(fabs(d) > off && (d < 0.0 || middle))))
        return false;
    out->count = solve_quadratic(b, noise, root);
    for (uint32_t i = 0; i < out->count; i++) {
        const common_root one = { root[i], i == 0 ? 0.0 : turn, i + 1 < out->count ? turn : 1.0, (i == 0) == (b[0] < 0.0), true };

        out->at[i] = one;
    }
    return true;
}

static bool certain_line(const double *b, double noise, common_roots *out)
{
    const common_root one = { b[0] / (b[0] - b[1]), 0.0, 1.0, b[0] < 0.0, true };

    out->at[0] = one;
    out->count = (b[0] > 0.0) != (b[1] > 0.0);
    return fabs(b[0]) > noise && fabs(b[1]) > noise;
}

bool common_bernstein_certain(const double *b, int degree, double noise, double beyond, double within, common_roots *out)
{
    brackets found;
    weighted w;

    out->count = 0;
    if (degree <= 2)
        return degree == 1 ? certain_line(b, noise, out) : certain_quadratic(b, noise, out);
    found.count = 0;
    if (!isolate_certain(b, degree, noise, beyond, &found))
        return false;
    for (uint32_t i = 0; i < found.count; i++) {
        const bracket *one = &found.at[i];
        common_root *to = &out->at[out->count++];

        to->lo = one->lo;
        to->hi = one->hi;
        to->rising = one->rising;
        to->known = !(one->lo > beyond && one->hi < within);
        if (i == 0 && to->known)
            weigh(b, degree, &w);
        to->x = to->known ? polish(&w, degree, one) : one->start;
        if (one->lo >= beyond)
            break;
    }
    return true;
}

COMMON_INLINE double slope_of(const double *b, int degree, double u)
{
    const double v = 1.0 - u;
    double sum = b[1] - b[0], power = u, binomial = degree - 1;

    for (int i = 1; i < degree; i++) {
        sum = sum * v + binomial * power * (b[i + 1] - b[i]);
        power *= u;
        binomial = binomial * (degree - 1 - i) / (i + 1);
    }
    return degree * sum;
}

double common_bernstein_slope(const double *b, int degree, double u)
{
    switch (degree) {
    case 3: return slope_of(b, 3, u);
    case 4: return slope_of(b, 4, u);
    case 6: return slope_of(b, 6, u);
    default: return slope_of(b, degree, u);
    }
}
