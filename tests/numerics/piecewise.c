#include "numerics/piecewise.h"

poly_real poly_of(real constant)
{
    poly_real p;

    p.degree = 0;
    p.c[0] = constant;
    return p;
}

poly_real poly_line(real at_zero, real slope)
{
    poly_real p;

    p.degree = 1;
    p.c[0] = at_zero;
    p.c[1] = slope;
    return p;
}

poly_real poly_add(const poly_real *a, const poly_real *b)
{
    const poly_real *more = a->degree > b->degree ? a : b, *less = a->degree > b->degree ? b : a;
    poly_real p = *more;

    for (int i = 0; i <= less->degree; i++)
        p.c[i] = real_add(more->c[i], less->c[i]);
    return p;
}

poly_real poly_sub(const poly_real *a, const poly_real *b)
{
    const poly_real minus = poly_scale(b, real_of(-1.0));

    return poly_add(a, &minus);
}

poly_real poly_mul(const poly_real *a, const poly_real *b)
{
    poly_real p;

    p.degree = a->degree + b->degree;
    for (int i = 0; i <= p.degree; i++)
        p.c[i] = real_of(0.0);
    for (int i = 0; i <= a->degree; i++)
        for (int k = 0; k <= b->degree; k++)
            p.c[i + k] = real_add(p.c[i + k], real_mul(a->c[i], b->c[k]));
    return p;
}

poly_real poly_scale(const poly_real *a, real by)
{
    poly_real p = *a;

    for (int i = 0; i <= p.degree; i++)
        p.c[i] = real_mul(a->c[i], by);
    return p;
}

poly_real poly_slope(const poly_real *p)
{
    poly_real s = poly_of(real_of(0.0));

    s.degree = p->degree > 0 ? p->degree - 1 : 0;
    for (int i = 0; i < p->degree; i++)
        s.c[i] = real_mul(p->c[i + 1], real_of(i + 1.0));
    return s;
}

real poly_at(const poly_real *p, real t)
{
    real sum = p->c[p->degree];

    for (int i = p->degree - 1; i >= 0; i--)
        sum = real_add(real_mul(sum, t), p->c[i]);
    return sum;
}

/* ---- Sturm's sequence ---- */

typedef struct sequence { int count; poly_real at[PIECE_DEGREE + 2]; } sequence;

/* Less the highest powers that are zero; degree -1 for zero itself. */
static void trim(poly_real *p)
{
    while (p->degree >= 0 && real_sign(p->c[p->degree]) == 0)
        p->degree--;
}

/* The remainder of a division, with the other sign. */
static poly_real rest_of(const poly_real *a, const poly_real *b)
{
    poly_real r = *a;

    while (r.degree >= b->degree) {
        const real by = real_div(r.c[r.degree], b->c[b->degree]);
        const int shift = r.degree - b->degree;

        for (int i = 0; i < b->degree; i++)
            r.c[i + shift] = real_sub(r.c[i + shift], real_mul(by, b->c[i]));
        r.degree--;
        trim(&r);
    }
    for (int i = 0; i <= r.degree; i++)
        r.c[i] = real_neg(r.c[i]);
    return r;
}

static void make_sequence(const poly_real *p, sequence *s)
{
    s->at[0] = *p;
    trim(&s->at[0]);
    s->count = 1;
    if (s->at[0].degree < 1)
        return;
    s->at[1] = poly_slope(&s->at[0]);
    s->count = 2;
    while (s->at[s->count - 1].degree > 0) {
        s->at[s->count] = rest_of(&s->at[s->count - 2], &s->at[s->count - 1]);
        if (s->at[s->count].degree < 0)
            return;
        s->count++;
    }
}

static int changes_at(const sequence *s, real t)
{
    const int mark = real_mark();
    int changes = 0, before = 0;

    for (int i = 0; i < s->count; i++) {
        const int sign = real_sign(poly_at(&s->at[i], t));

        changes += sign != 0 && before != 0 && sign != before;
        before = sign != 0 ? sign : before;
    }
    real_release(mark);
    return changes;
}

typedef struct hunt { const sequence *s; double *out; int count, room; } hunt;

static int sign_at(const poly_real *p, real t)
{
    const int mark = real_mark(), sign = real_sign(poly_at(p, t));

    real_release(mark);
    return sign;
}

/* The only root; one that only touches is none. */
static void bisect(hunt *h, real from, real to)
{
    const int before = sign_at(&h->s->at[0], from);
    real middle = from;

    if (before == sign_at(&h->s->at[0], to) || h->count == h->room)
        return;
    for (int turn = 0; turn < 80; turn++) {
        middle = real_mul(real_add(from, to), real_of(0.5));
        if (sign_at(&h->s->at[0], middle) == before)
            from = middle;
        else
            to = middle;
    }
    h->out[h->count++] = real_double(middle);
}

/* Halves until no more than one root is left. */
static void divide(hunt *h, real from, int changes_from, real to, int changes_to, int depth)
{
    const int mark = real_mark();

    if (changes_from - changes_to == 1) {
        bisect(h, from, to);
    } else if (changes_from != changes_to && depth > 0) {
        const real middle = real_mul(real_add(from, to), real_of(0.5));
        const int changes = changes_at(h->s, middle);

        divide(h, from, changes_from, middle, changes, depth - 1);
        divide(h, middle, changes, to, changes_to, depth - 1);
    }
    real_release(mark);
}

int poly_roots(const poly_piece *piece, double *out, int room)
{
    sequence s;
    hunt h = { &s, out, 0, room };

    make_sequence(&piece->p, &s);
    if (s.at[0].degree >= 1)
        divide(&h, piece->from, changes_at(&s, piece->from), piece->to, changes_at(&s, piece->to), 100);
    return h.count;
}
