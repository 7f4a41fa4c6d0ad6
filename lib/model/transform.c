#include "model/transform.h"

#include <povtrace/exact.h>

#include <string.h>

/* ---- the list ---- */

bool transform_changes_nothing(transform_kind kind, const double *v)
{
    static const double identity[12] = { 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0 };
    int i;

    switch (kind) {
    case TRANSFORM_TRANSLATE:
        return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0;
    case TRANSFORM_ROTATE:
        return fmod(v[0], 360.0) == 0.0 && fmod(v[1], 360.0) == 0.0 && fmod(v[2], 360.0) == 0.0;
    case TRANSFORM_SCALE:
        return v[0] == 1.0 && v[1] == 1.0 && v[2] == 1.0;
    case TRANSFORM_MATRIX:
        for (i = 0; i < 12; i++)
            if (v[i] != identity[i])
                return false;
        return true;
    }
    return false;
}

const transform *transform_append(arena *memory, const transform *before, transform_kind kind, const double *numbers)
{
    size_t bytes = (kind == TRANSFORM_MATRIX ? 12 : 3) * sizeof *numbers;
    transform *t;

    if (transform_changes_nothing(kind, numbers))
        return before;
    t = arena_alloc(memory, sizeof *t + bytes, sizeof(double));
    if (!t)
        return NULL;
    t->before = before;
    t->kind = kind;
    memcpy(t->v, numbers, bytes);
    return t;
}

/* ---- sine and cosine in two parts ---- */

/* Sum of the Taylor series first * (1 - x^2/((n+1)(n+2)) + ...) where `first` is x^n/n!, n = 0 or 1. */
static pov_two series(pov_two first, pov_two x2, int n)
{
    pov_two sum = first, term = first;

    /* |x| <= pi/4: 14 terms reach (pi/4)^28/28! < 2^-105 of the first. */
    for (; n < 30; n += 2) {
        term = pov_two_neg(pov_two_div(pov_two_mul(term, x2), pov_two_of((double)((n + 1) * (n + 2)), 0.0)));
        sum = pov_two_add(sum, term);
    }
    return sum;
}

void transform_sincos(double degrees, double *s, double *c)
{
    /* pi/180 in two parts. fmod and the subtraction of a multiple of 90 are exact, so that the reduction is. */
    const pov_two degree = { 0.017453292519943295, 2.9486522708701687e-19 };
    double rest = fmod(degrees, 360.0);
    int quarter = (int)floor(rest / 90.0 + 0.5);
    pov_two x = pov_two_mul_double(degree, rest - 90.0 * quarter), x2 = pov_two_mul(x, x);
    pov_two sine = series(x, x2, 1), cosine = series(pov_two_of(1.0, 0.0), x2, 0), swap = sine;

    quarter &= 3;
    if (quarter & 1) {
        sine = cosine;
        cosine = pov_two_neg(swap);
    }
    if (quarter & 2) {
        sine = pov_two_neg(sine);
        cosine = pov_two_neg(cosine);
    }
    s[0] = sine.hi;
    s[1] = sine.lo;
    c[0] = cosine.hi;
    c[1] = cosine.lo;
}

/* ---- composition ---- */

/* Rows of an affine map, the last column moves. */
typedef struct rows { pov_two at[3][4]; } rows;

static rows identity(void)
{
    rows r;
    int i;

    memset(&r, 0, sizeof r);
    for (i = 0; i < 3; i++)
        r.at[i][i].hi = 1.0;
    return r;
}

/* The map is built from the last written transformation to the first: each joins it on the right, and its inverse
 * joins the inverse on the left. Only what a transformation changes is touched, so that zeros stay exact. */
typedef struct composition { rows map, inverse; } composition;

static void translate(composition *c, const double *v)
{
    int i, k;

    for (i = 0; i < 3; i++) {
        for (k = 0; k < 3; k++)
            if (v[k] != 0.0)
                c->map.at[i][3] = pov_two_add(c->map.at[i][3], pov_two_mul_double(c->map.at[i][k], v[k]));
        c->inverse.at[i][3] = pov_two_add_double(c->inverse.at[i][3], -v[i]);
    }
}

static void scale(composition *c, const double *v)
{
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++)
            c->map.at[i][j] = pov_two_mul_double(c->map.at[i][j], v[j]);
    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++)
            c->inverse.at[i][j] = pov_two_div(c->inverse.at[i][j], pov_two_of(v[i], 0.0));
}

/* x cos + y sin, y cos - x sin. */
static void turn_pair(pov_two *x, pov_two *y, pov_two s, pov_two c)
{
    pov_two turned = pov_two_add(pov_two_mul(*x, c), pov_two_mul(*y, s));

    *y = pov_two_sub(pov_two_mul(*y, c), pov_two_mul(*x, s));
    *x = turned;
}

/* Turn by degrees about one axis; left-handed: about x, +y goes to +z. The inverse is the transpose. */
static void turn(composition *c, int axis, double degrees)
{
    int u = (axis + 1) % 3, v = (axis + 2) % 3, i;
    double sine[2], cosine[2];
    pov_two s, k;

    if (degrees == 0.0)
        return;
    transform_sincos(degrees, sine, cosine);
    s = pov_two_of(sine[0], sine[1]);
    k = pov_two_of(cosine[0], cosine[1]);
    for (i = 0; i < 3; i++)
        turn_pair(&c->map.at[i][u], &c->map.at[i][v], s, k);
    for (i = 0; i < 4; i++)
        turn_pair(&c->inverse.at[u][i], &c->inverse.at[v][i], s, k);
}

/* a after b: p -> a (b p). */
static rows after(const rows *a, const rows *b)
{
    rows r;
    int i, j, k;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++) {
            pov_two sum = j == 3 ? a->at[i][3] : pov_two_of(0.0, 0.0);
            for (k = 0; k < 3; k++)
                sum = pov_two_add(sum, pov_two_mul(a->at[i][k], b->at[k][j]));
            r.at[i][j] = sum;
        }
    return r;
}

/* matrix <...> multiplies row vectors, so it stands transposed here. */
static rows written(const double *v)
{
    rows r;
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++)
            r.at[i][j] = pov_two_of(v[3 * j + i], 0.0);
    return r;
}

/* The inverse of any matrix: cofactors over the determinant, after scaling rows by powers of two so that stiff ones
 * (a row of 1e9 beside one of 1e-9) neither overflow nor lose the small products. False: singular. */
static bool invert(const rows *m, rows *out)
{
    rows a = *m;
    double factor[3], largest;
    pov_two determinant = { 0.0, 0.0 };
    int i, j, e;

    for (i = 0; i < 3; i++) {
        largest = fmax(fabs(a.at[i][0].hi), fmax(fabs(a.at[i][1].hi), fabs(a.at[i][2].hi)));
        if (!(largest > 0.0) || largest > 1e300)
            return false;
        frexp(largest, &e);
        factor[i] = ldexp(1.0, -e);
        for (j = 0; j < 3; j++)
            a.at[i][j] = pov_two_of(a.at[i][j].hi * factor[i], a.at[i][j].lo * factor[i]);
    }
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++) {
            int r1 = (j + 1) % 3, r2 = (j + 2) % 3, c1 = (i + 1) % 3, c2 = (i + 2) % 3;
            out->at[i][j] = pov_two_sub(pov_two_mul(a.at[r1][c1], a.at[r2][c2]),
                                        pov_two_mul(a.at[r1][c2], a.at[r2][c1]));
        }
    for (i = 0; i < 3; i++)
        determinant = pov_two_add(determinant, pov_two_mul(a.at[0][i], out->at[i][0]));
    if (determinant.hi == 0.0)
        return false;
    for (i = 0; i < 3; i++) {
        pov_two sum = { 0.0, 0.0 };
        for (j = 0; j < 3; j++) {
            out->at[i][j] = pov_two_mul_double(pov_two_div(out->at[i][j], determinant), factor[j]);
            sum = pov_two_sub(sum, pov_two_mul(out->at[i][j], m->at[j][3]));
        }
        out->at[i][3] = sum;
    }
    return true;
}

static void store(const rows *r, double hi[3][4], double lo[3][4])
{
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++) {
            hi[i][j] = r->at[i][j].hi;
            lo[i][j] = r->at[i][j].lo;
        }
}

static bool join(composition *c, const transform *t)
{
    rows map, inverse;
    int axis;

    switch (t->kind) {
    case TRANSFORM_TRANSLATE:
        translate(c, t->v);
        break;
    case TRANSFORM_SCALE:
        scale(c, t->v);
        break;
    case TRANSFORM_ROTATE:
        for (axis = 2; axis >= 0; axis--)
            turn(c, axis, t->v[axis]);
        break;
    case TRANSFORM_MATRIX:
        map = written(t->v);
        if (!invert(&map, &inverse))
            return false;
        c->map = after(&c->map, &map);
        c->inverse = after(&inverse, &c->inverse);
        break;
    }
    return true;
}

static bool is_finite(const rows *r)
{
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++)
            if (!isfinite(r->at[i][j].hi) || !isfinite(r->at[i][j].lo))
                return false;
    return true;
}

bool transform_compose(const transform *list, pov_affine *out)
{
    composition c;
    const transform *t;

    c.map = c.inverse = identity();
    for (t = list; t; t = t->before)
        if (!join(&c, t))
            return false;
    store(&c.map, out->m, out->m_lo);
    store(&c.inverse, out->inv, out->inv_lo);
    return is_finite(&c.map) && is_finite(&c.inverse);
}

void transform_point(const pov_affine *map, pov_vec3 p, pov_vec3 *hi, pov_vec3 *lo)
{
    pov_two r[3];
    int i;

    for (i = 0; i < 3; i++) {
        r[i] = pov_two_mul_double(pov_two_of(map->m[i][0], map->m_lo[i][0]), p.x);
        r[i] = pov_two_add(r[i], pov_two_mul_double(pov_two_of(map->m[i][1], map->m_lo[i][1]), p.y));
        r[i] = pov_two_add(r[i], pov_two_mul_double(pov_two_of(map->m[i][2], map->m_lo[i][2]), p.z));
        r[i] = pov_two_add(r[i], pov_two_of(map->m[i][3], map->m_lo[i][3]));
    }
    *hi = pov_vec3_of(r[0].hi, r[1].hi, r[2].hi);
    *lo = pov_vec3_of(r[0].lo, r[1].lo, r[2].lo);
}
