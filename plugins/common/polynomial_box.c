/* A box around what is inside a polynomial's surface, where its terms of the highest order keep one sign in all directions. */
#include "common/bernstein.h"
#include "common/polynomial.h"

#include <math.h>
#include <string.h>

/* Higher orders would take too long; cells get as small as 2^-DEPTH of a box of powers of two. */
enum { ORDER_MOST = 6, MANY = ORDER_MOST + 1, FACE = 12, DEPTH = 6 };

/* Coefficients of x^i y^j z^k. */
typedef struct tensor { double at[MANY][MANY][MANY]; } tensor;

static void take_orders(const common_polynomial *p, int least, tensor *out)
{
    uint32_t at = 0;

    memset(out, 0, sizeof *out);
    for (int i = p->order; i >= 0; i--)
        for (int j = p->order - i; j >= 0; j--)
            for (int k = p->order - i - j; k >= 0; k--, at++)
                if (i + j + k >= least)
                    out->at[i][j][k] = p->at[at];
}

static double size_of_order(const common_polynomial *p, int order)
{
    double sum = 0.0;
    uint32_t at = 0;

    for (int i = p->order; i >= 0; i--)
        for (int j = p->order - i; j >= 0; j--)
            for (int k = p->order - i - j; k >= 0; k--, at++)
                sum += i + j + k == order ? fabs(p->at[at]) : 0.0;
    return sum;
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
static void apply(int n, double map[MANY][MANY], double *at, int step)
{
    double sum[MANY];

    for (int i = 0; i <= n; i++) {
        sum[i] = 0.0;
        for (int k = 0; k <= n; k++)
            sum[i] += map[i][k] * at[k * step];
    }
    for (int i = 0; i <= n; i++)
        at[i * step] = sum[i];
}

typedef struct range { double least, most; } range;

static range range_in(const tensor *t, int n, const pov_box *box)
{
    double x[MANY][MANY], y[MANY][MANY], z[MANY][MANY];
    tensor b = *t;
    range out = { HUGE_VAL, -HUGE_VAL };

    find_map(n, box->lo.x, box->hi.x, x);
    find_map(n, box->lo.y, box->hi.y, y);
    find_map(n, box->lo.z, box->hi.z, z);
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++)
            apply(n, z, b.at[i][j], 1);
    for (int i = 0; i <= n; i++)
        for (int k = 0; k <= n; k++)
            apply(n, y, &b.at[i][0][k], MANY);
    for (int j = 0; j <= n; j++)
        for (int k = 0; k <= n; k++)
            apply(n, x, &b.at[0][j][k], MANY * MANY);
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++)
            for (int k = 0; k <= n; k++) {
                out.least = fmin(out.least, b.at[i][j][k]);
                out.most = fmax(out.most, b.at[i][j][k]);
            }
    return out;
}

/* ---- how far it reaches ---- */

/* The least value of the highest order where the largest of |x|, |y|, |z| is one. Even orders have it on three faces. */
static double least_outward(const common_polynomial *p)
{
    const double side = 2.0 / FACE;
    double least = HUGE_VAL;
    tensor t;

    take_orders(p, p->order, &t);
    for (int face = 0; face < 3; face++)
        for (int i = 0; i < FACE * FACE && least > 0.0; i++) {
            const double u = -1.0 + side * (i / FACE), v = -1.0 + side * (i % FACE);
            const pov_box at[3] = { { { 1.0, u, v }, { 1.0, u + side, v + side } }, { { u, 1.0, v }, { u + side, 1.0, v + side } },
                                    { { u, v, 1.0 }, { u + side, v + side, 1.0 } } };

            least = fmin(least, range_in(&t, p->order, &at[face]).least);
        }
    return least - 0x1p-40 * size_of_order(p, p->order);
}

/* A power of two, beyond which the highest order is larger than all others together. 0: none. */
static double find_reach(const common_polynomial *p)
{
    const double least = least_outward(p);

    for (int e = -60; least > 0.0 && e <= 60; e++) {
        const double r = ldexp(1.0, e);
        double power = 1.0, rest = 0.0;

        for (int k = 0; k < p->order; k++) {
            rest += power * size_of_order(p, k);
            power *= r;
        }
        if (least * power > 2.0 * rest)
            return r;
    }
    return 0.0;
}

/* ---- the box ---- */

typedef struct hunt { const common_polynomial *p; tensor all; double noise; pov_box found; } hunt;

static bool is_found(const hunt *h, const pov_box *b)
{
    return b->lo.x >= h->found.lo.x && b->lo.y >= h->found.lo.y && b->lo.z >= h->found.lo.z && b->hi.x <= h->found.hi.x &&
           b->hi.y <= h->found.hi.y && b->hi.z <= h->found.hi.z;
}

static void join(pov_box *a, const pov_box *b)
{
    a->lo = pov_vec3_of(fmin(a->lo.x, b->lo.x), fmin(a->lo.y, b->lo.y), fmin(a->lo.z, b->lo.z));
    a->hi = pov_vec3_of(fmax(a->hi.x, b->hi.x), fmax(a->hi.y, b->hi.y), fmax(a->hi.z, b->hi.z));
}

static pov_box part_of(const pov_box *b, int which)
{
    const pov_vec3 middle = pov_scale(pov_add(b->lo, b->hi), 0.5);
    const pov_box out = { { which & 1 ? middle.x : b->lo.x, which & 2 ? middle.y : b->lo.y, which & 4 ? middle.z : b->lo.z },
                          { which & 1 ? b->hi.x : middle.x, which & 2 ? b->hi.y : middle.y, which & 4 ? b->hi.z : middle.z } };

    return out;
}

/* Cells that are not certainly outside. */
static void find_cells(hunt *h, const pov_box *box, int depth)
{
    if (is_found(h, box) || range_in(&h->all, h->p->order, box).least > h->noise)
        return;
    for (int i = 0; depth < DEPTH && i < 8; i++) {
        const pov_box part = part_of(box, i);

        find_cells(h, &part, depth + 1);
    }
    if (depth == DEPTH)
        join(&h->found, box);
}

static double noise_at(const common_polynomial *p, double reach)
{
    double sum = 0.0, power = 1.0;

    for (int k = 0; k <= p->order; k++) {
        sum += power * size_of_order(p, k);
        power *= reach;
    }
    return 0x1p-40 * sum;
}

bool common_polynomial_find_box(const common_polynomial *p, pov_box *out)
{
    const double reach = p->order % 2 == 0 && p->order <= ORDER_MOST ? find_reach(p) : 0.0, margin = 0x1p-20 * reach;
    const pov_box all = { { -reach, -reach, -reach }, { reach, reach, reach } };
    hunt h = { p, { { { { 0.0 } } } }, noise_at(p, reach), { { HUGE_VAL, HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } } };

    if (reach == 0.0)
        return false;
    take_orders(p, 0, &h.all);
    find_cells(&h, &all, 0);
    if (!(h.found.lo.x < h.found.hi.x))
        return false;
    out->lo = pov_sub(h.found.lo, pov_vec3_of(margin, margin, margin));
    out->hi = pov_add(h.found.hi, pov_vec3_of(margin, margin, margin));
    return true;
}
