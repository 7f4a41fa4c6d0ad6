#include "common/sides.h"

#include <math.h>

/* Sides are looked at in so many places of a piece; of outlines of more pieces, the area alone tells. */
enum { PLACES = 16, PIECES = 256, HALVINGS = 40 };

/* The integral of x dy over the piece: a share of x[i] (y[j + 1] - y[j]) for all i and j. */
static double area_of(const common_piece *c)
{
    static const double share[3][4][3] = {
        { { 1.0 / 2 }, { 1.0 / 2 } },
        { { 1.0 / 2, 1.0 / 6 }, { 1.0 / 3, 1.0 / 3 }, { 1.0 / 6, 1.0 / 2 } },
        { { 10.0 / 20, 4.0 / 20, 1.0 / 20 }, { 6.0 / 20, 6.0 / 20, 3.0 / 20 }, { 3.0 / 20, 6.0 / 20, 6.0 / 20 }, { 1.0 / 20, 4.0 / 20, 10.0 / 20 } },
    };
    double area = 0.0;

    for (uint32_t i = 0; i <= c->degree; i++)
        for (uint32_t j = 0; j < c->degree; j++)
            area += share[c->degree - 1][i][j] * c->x[i] * (c->y[j + 1] - c->y[j]);
    return area;
}

/* 0: it is the same on both sides. */
static double sign_at(const common_outline *o, uint32_t piece, double u)
{
    double p[2], tangent[2], left[2], right[2], unit;
    bool holds_left, holds_right;

    common_piece_at(&o->at[piece], u, p, tangent);
    unit = 0x1p-24 / sqrt(tangent[0] * tangent[0] + tangent[1] * tangent[1]);
    for (int i = 0; i < 2; i++) {
        const double across = (i == 0 ? tangent[1] : -tangent[0]) * unit;

        right[i] = p[i] + across;
        left[i] = p[i] - across;
    }
    holds_right = common_outline_inside(o, right);
    holds_left = common_outline_inside(o, left);
    return holds_left == holds_right ? 0.0 : holds_left ? 1.0 : -1.0;
}

/* Where the side changes between two places that have different ones. */
static double change_between(const common_outline *o, uint32_t piece, double lo, double hi, double sign)
{
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = 0.5 * (lo + hi);

        if (sign_at(o, piece, middle) == sign)
            lo = middle;
        else
            hi = middle;
    }
    return 0.5 * (lo + hi);
}

/* The sides of a piece, of which there is room for PLACES. Returns how many. */
static uint32_t find_piece(const common_outline *o, uint32_t piece, double usual, common_side *out)
{
    uint32_t count = 0;
    double sign = 0.0, last = 0.0;

    for (int k = 0; k < PLACES; k++) {
        const double u = (k + 0.5) / PLACES, now = sign_at(o, piece, u);

        if (now == 0.0 || now == sign)
            continue;
        if (sign != 0.0)
            out[count++] = (common_side){ change_between(o, piece, last, u, sign), sign };
        sign = now;
        last = u;
    }
    out[count++] = (common_side){ 1.0, sign == 0.0 ? usual : sign };
    return count;
}

void common_sides_find(common_sides *out, const common_outline *o, const pov_host *host, pov_reader *in)
{
    double area = 0.0;
    uint32_t count = 0;
    bool alike = true;

    for (uint32_t i = 0; i < o->count; i++)
        area += area_of(&o->at[i]);
    out->sign = area < 0.0 ? -1.0 : 1.0;
    if (o->count > PIECES)
        return;
    out->at = host->alloc(in, o->count * PLACES * sizeof *out->at);
    out->first = host->alloc(in, o->count * sizeof *out->first);
    for (uint32_t i = 0; out->at && out->first && i < o->count; i++) {
        out->first[i] = count;
        count += find_piece(o, i, out->sign, &out->at[count]);
    }
    for (uint32_t i = 1; out->at && i < count; i++)
        alike &= out->at[i].sign == out->at[0].sign;
    if (!out->at || !alike)
        return;
    out->sign = out->at[0].sign;
    out->at = NULL;
}

double common_sides_at(const common_sides *s, uint32_t piece, double u)
{
    const common_side *at = s->at ? &s->at[s->first[piece]] : NULL;

    while (at && at->until < u && at->until < 1.0)
        at++;
    return at ? at->sign : s->sign;
}
