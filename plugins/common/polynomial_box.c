/* A box around what is inside a polynomial's surface, where its terms of the highest weight keep one sign in all directions. The weight of
 * a term x^i y^j z^k is a i + b j + c k: each coordinate grows by its own power of a reach, so that the highest power of each counts as
 * much as that of the others. So x^4 - x^2 + y^2 + z^2 is finite, with the weights 1, 2 and 2. */
#include "common/bernstein.h"
#include "common/polynomial.h"

#include <math.h>
#include <string.h>

/* Higher orders would take too long; cells get as small as 2^-DEPTH of a box of powers of two, or 2^-DEPTH_AGAIN of a smaller one. */
enum { ORDER_MOST = 6, MANY = ORDER_MOST + 1, FACE = 12, DEPTH = 6, DEPTH_AGAIN = 4, TURNS = 6 };

/* Coefficients of x^i y^j z^k, or Bernstein coefficients in a box, all powers up to the order: z changes first. */
typedef struct tensor { double at[MANY * MANY * MANY]; } tensor;

static void take_all(const common_polynomial *p, tensor *out)
{
    const int n = p->order, row = n + 1;
    uint32_t at = 0;

    memset(out, 0, sizeof *out);
    for (int i = n; i >= 0; i--)
        for (int j = n - i; j >= 0; j--)
            for (int k = n - i - j; k >= 0; k--, at++)
                out->at[(i * row + j) * row + k] = p->at[at];
}

/* The weights of the coordinates, and that of the highest powers of each. */
typedef struct weights { int of[3], most; } weights;

static bool find_weights(const common_polynomial *p, weights *out)
{
    const int n = p->order;
    int highest[3] = { 0, 0, 0 };

    for (int e = 2; e <= n; e += 2)
        for (int axis = 0; axis < 3; axis++)
            if (p->at[common_polynomial_place(n, axis == 0 ? e : 0, axis == 1 ? e : 0, axis == 2 ? e : 0)] > 0.0)
                highest[axis] = e;
    if (highest[0] == 0 || highest[1] == 0 || highest[2] == 0)
        return false;
    for (out->most = 2; out->most % highest[0] != 0 || out->most % highest[1] != 0 || out->most % highest[2] != 0; )
        out->most += 2;
    for (int axis = 0; axis < 3; axis++)
        out->of[axis] = out->most / highest[axis];
    return true;
}

static int weight_of(const weights *w, int i, int j, int k) { return w->of[0] * i + w->of[1] * j + w->of[2] * k; }

/* Of the coefficients of a weight: the sum of their sizes. */
static double size_of_weight(const common_polynomial *p, const weights *w, int weight)
{
    double sum = 0.0;
    uint32_t at = 0;

    for (int i = p->order; i >= 0; i--)
        for (int j = p->order - i; j >= 0; j--)
            for (int k = p->order - i - j; k >= 0; k--, at++)
                sum += weight_of(w, i, j, k) == weight ? fabs(p->at[at]) : 0.0;
    return sum;
}

/* Are there terms of a higher weight than the highest powers have? */
static bool has_more(const common_polynomial *p, const weights *w)
{
    uint32_t at = 0;

    for (int i = p->order; i >= 0; i--)
        for (int j = p->order - i; j >= 0; j--)
            for (int k = p->order - i - j; k >= 0; k--, at++)
                if (p->at[at] != 0.0 && weight_of(w, i, j, k) > w->most)
                    return true;
    return false;
}

/* ---- what a polynomial is in a box ---- */

/* Column k: Bernstein coefficients of x^k from lo to hi. */
static void find_map(int n, double lo, double hi, double map[MANY][MANY])
{
    double c[MANY] = { 1.0 }, b[MANY];

    for (int k = 0; k <= n; k++) {
        common_bernstein(c, n, b);
        for (int i = 0; i <= n; i++)
            map[i][k] = b[i];
        for (int i = n; i > 0; i--)
            c[i] = c[i] * lo + c[i - 1] * (hi - lo);
        c[0] *= lo;
    }
}

/* out[i] = the sum of map[i][k] in[k]; numbers lie `step` apart. */
static void apply(int n, double map[MANY][MANY], const double *in, double *out, int step)
{
    double sum[MANY];

    for (int i = 0; i <= n; i++) {
        sum[i] = 0.0;
        for (int k = 0; k <= n; k++)
            sum[i] += map[i][k] * in[k * step];
    }
    for (int i = 0; i <= n; i++)
        out[i * step] = sum[i];
}

static double least_of(const double *at, int count)
{
    double least = at[0];

    for (int i = 1; i < count; i++)
        least = at[i] < least ? at[i] : least;
    return least;
}

/* Bernstein coefficients in a box. */
static void find_bernstein(tensor *t, int n, const pov_box *in)
{
    const int row = n + 1, steps[3] = { row * row, row, 1 };
    const double lo[3] = { in->lo.x, in->lo.y, in->lo.z }, hi[3] = { in->hi.x, in->hi.y, in->hi.z };

    for (int axis = 2; axis >= 0; axis--) {
        double map[MANY][MANY];

        find_map(n, lo[axis], hi[axis], map);
        for (int from = 0; from < row * row * row; from += row * steps[axis])
            for (int i = from; i < from + steps[axis]; i++)
                apply(n, map, t->at + i, t->at + i, steps[axis]);
    }
}

/* De Casteljau's scheme at the middle of the lines along an axis: the part below it stays, `upper` is the other. */
static void halve(tensor *t, int n, int step, tensor *upper)
{
    const int row = n + 1;

    for (int from = 0; from < row * row * row; from += row * step)
        for (int k = 0; k <= n; k++) {
            for (int i = from; i < from + step; i++)
                upper->at[i + (n - k) * step] = t->at[i + n * step];
            for (int m = n; m > k; m--)
                for (int i = from + m * step; i < from + m * step + step; i++)
                    t->at[i] = 0.5 * (t->at[i] + t->at[i - step]);
        }
}

/* ---- how far it reaches ---- */

/* The terms of the highest weight where one coordinate is 1, or -1: a polynomial of the others, u^j v^k. */
static void take_face(const common_polynomial *p, const weights *w, int face, bool below, double out[MANY * MANY])
{
    const int n = p->order, row = n + 1;
    uint32_t at = 0;

    memset(out, 0, MANY * MANY * sizeof *out);
    for (int i = n; i >= 0; i--)
        for (int j = n - i; j >= 0; j--)
            for (int k = n - i - j; k >= 0; k--, at++) {
                const int power = face == 0 ? i : face == 1 ? j : k;
                double *to = &out[face == 0 ? j * row + k : face == 1 ? i * row + k : i * row + j];

                if (weight_of(w, i, j, k) == w->most)
                    *to += below && power % 2 != 0 ? -p->at[at] : p->at[at];
            }
}

static double least_on_face(const common_polynomial *p, const weights *w, int face, bool below, double maps[FACE][MANY][MANY])
{
    const int n = p->order, row = n + 1;
    double all[MANY * MANY], strip[MANY * MANY], cell[MANY * MANY], least = HUGE_VAL;

    take_face(p, w, face, below, all);
    for (int u = 0; u < FACE; u++) {
        for (int k = 0; k <= n; k++)
            apply(n, maps[u], all + k, strip + k, row);
        for (int v = 0; v < FACE && least > 0.0; v++) {
            for (int j = 0; j <= n; j++)
                apply(n, maps[v], strip + j * row, cell + j * row, 1);
            least = pov_min(least, least_of(cell, row * row));
        }
    }
    return least;
}

/* The least value of the highest weight where the largest of |x|, |y|, |z| is one. With weights of one it is the same on faces opposite
 * each other. */
static double least_outward(const common_polynomial *p, const weights *w)
{
    const double side = 2.0 / FACE;
    const int faces = w->of[0] == w->of[1] && w->of[1] == w->of[2] ? 3 : 6;
    double least = HUGE_VAL, maps[FACE][MANY][MANY];

    for (int i = 0; i < FACE; i++)
        find_map(p->order, -1.0 + side * i, -1.0 + side * i + side, maps[i]);
    for (int face = 0; face < faces && least > 0.0; face++)
        least = pov_min(least, least_on_face(p, w, face % 3, face >= 3, maps));
    return least - 0x1p-40 * size_of_weight(p, w, w->most);
}

/* A power of two, beyond which the highest weight is larger than all others together. 0: none. */
static double find_reach(const common_polynomial *p, const weights *w)
{
    const double least = least_outward(p, w);

    for (int e = -60; least > 0.0 && e <= 60; e++) {
        const double r = ldexp(1.0, e);
        double power = 1.0, rest = 0.0;

        for (int k = 0; k < w->most; k++) {
            rest += power * size_of_weight(p, w, k);
            power *= r;
        }
        if (least * power > 2.0 * rest)
            return r;
    }
    return 0.0;
}

/* ---- the box ---- */

typedef struct hunt { int order, depth; double noise; pov_box found; } hunt;

static bool is_found(const hunt *h, const pov_box *b)
{
    return b->lo.x >= h->found.lo.x && b->lo.y >= h->found.lo.y && b->lo.z >= h->found.lo.z && b->hi.x <= h->found.hi.x &&
           b->hi.y <= h->found.hi.y && b->hi.z <= h->found.hi.z;
}

static void join(pov_box *a, const pov_box *b)
{
    a->lo = pov_vec3_of(pov_min(a->lo.x, b->lo.x), pov_min(a->lo.y, b->lo.y), pov_min(a->lo.z, b->lo.z));
    a->hi = pov_vec3_of(pov_max(a->hi.x, b->hi.x), pov_max(a->hi.y, b->hi.y), pov_max(a->hi.z, b->hi.z));
}

/* Below or above the middle of an axis. */
static pov_box half_of(const pov_box *b, int axis, bool above)
{
    pov_box out = *b;
    double *const lo = axis == 0 ? &out.lo.x : axis == 1 ? &out.lo.y : &out.lo.z;
    double *const hi = axis == 0 ? &out.hi.x : axis == 1 ? &out.hi.y : &out.hi.z;

    *(above ? lo : hi) = 0.5 * (*lo + *hi);
    return out;
}

/* Cells that are not certainly outside; `t` is of the box, and is used up. */
static void find_cells(hunt *h, tensor *t, const pov_box *box, int depth)
{
    const int row = h->order + 1, axis = depth % 3;
    pov_box part;
    tensor upper;

    if (is_found(h, box) || least_of(t->at, row * row * row) > h->noise)
        return;
    if (depth == h->depth) {
        join(&h->found, box);
        return;
    }
    halve(t, h->order, axis == 0 ? row * row : axis == 1 ? row : 1, &upper);
    part = half_of(box, axis, true);
    find_cells(h, &upper, &part, depth + 1);
    part = half_of(box, axis, false);
    find_cells(h, t, &part, depth + 1);
}

/* The box of the cells of another one. False: there are none. */
static bool find_within(hunt *h, const common_polynomial *p, const pov_box *box)
{
    const pov_box none = { { HUGE_VAL, HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };
    tensor t;

    h->found = none;
    take_all(p, &t);
    find_bernstein(&t, p->order, box);
    find_cells(h, &t, box, 0);
    return h->found.lo.x < h->found.hi.x;
}

/* Is such a part of it as wide as what was found along some axis, or wider? */
static bool is_coarse(const pov_box *box, const pov_box *found, double part)
{
    const pov_vec3 all = pov_scale(pov_sub(box->hi, box->lo), part), some = pov_sub(found->hi, found->lo);

    return some.x <= all.x || some.y <= all.y || some.z <= all.z;
}

/* Where cells were large beside what was found that is divided again, into fewer. False: nothing is left. */
static bool divide_again(hunt *h, const common_polynomial *p, const pov_box *all)
{
    pov_box box = *all;
    bool coarse = is_coarse(&box, &h->found, 0.125);

    h->depth = 3 * DEPTH_AGAIN;
    for (int turn = 0; turn < TURNS && coarse; turn++) {
        box = h->found;
        if (!find_within(h, p, &box))
            return false;
        coarse = is_coarse(&box, &h->found, 0.5);
    }
    return true;
}

static double noise_at(const common_polynomial *p, const weights *w, double reach)
{
    double sum = 0.0, power = 1.0;

    for (int k = 0; k <= w->most; k++) {
        sum += power * size_of_weight(p, w, k);
        power *= reach;
    }
    return 0x1p-40 * sum;
}

bool common_polynomial_find_box(const common_polynomial *p, pov_box *out)
{
    weights w;
    const bool may = p->order % 2 == 0 && p->order <= ORDER_MOST && find_weights(p, &w) && !has_more(p, &w);
    const double reach = may ? find_reach(p, &w) : 0.0;
    hunt h = { .order = p->order, .depth = 3 * DEPTH };
    double of[3];
    pov_vec3 all, margin;
    pov_box box;

    if (reach == 0.0)
        return false;
    for (int axis = 0; axis < 3; axis++) {
        of[axis] = 1.0;
        for (int k = 0; k < w.of[axis]; k++)
            of[axis] *= reach;
    }
    all = pov_vec3_of(of[0], of[1], of[2]);
    box.lo = pov_scale(all, -1.0);
    box.hi = all;
    h.noise = noise_at(p, &w, reach);
    if (!find_within(&h, p, &box) || !divide_again(&h, p, &box))
        return false;
    margin = pov_scale(all, 0x1p-20);
    out->lo = pov_sub(h.found.lo, margin);
    out->hi = pov_add(h.found.hi, margin);
    return true;
}
