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

/* What x^2 is multiplied by in the Taylor series of sin(x) / x and of cos(x): 1/n! with its sign. */
enum { TERMS = 15 };
static const pov_two of_sine[TERMS] = {
    { 1.0, 0.0 }, { -0.16666666666666666, -9.25185853854297e-18 },
    { 0.008333333333333333, 1.1564823173178714e-19 }, { -0.0001984126984126984, -1.7209558293420705e-22 },
    { 2.7557319223985893e-06, -1.858393274046472e-22 }, { -2.505210838544172e-08, 1.448814070935912e-24 },
    { 1.6059043836821613e-10, 1.2585294588752098e-26 }, { -7.647163731819816e-13, -7.03872877733453e-30 },
    { 2.8114572543455206e-15, 1.6508842730861433e-31 }, { -8.22063524662433e-18, -2.2141894119604265e-34 },
    { 1.9572941063391263e-20, -1.3643503830087908e-36 }, { -3.868170170630684e-23, 8.843177655482344e-40 },
    { 6.446950284384474e-26, -1.9330404233703465e-42 }, { -9.183689863795546e-29, -1.4303150396787322e-45 },
    { 1.1309962886447716e-31, 1.0498015412959506e-47 }
};
static const pov_two of_cosine[TERMS] = {
    { 1.0, 0.0 }, { -0.5, 0.0 },
    { 0.041666666666666664, 2.3129646346357427e-18 }, { -0.001388888888888889, 5.300543954373577e-20 },
    { 2.48015873015873e-05, 2.1511947866775882e-23 }, { -2.755731922398589e-07, -2.3767714622250297e-23 },
    { 2.08767569878681e-09, -1.20734505911326e-25 }, { -1.1470745597729725e-11, -2.0655512752830745e-28 },
    { 4.779477332387385e-14, 4.399205485834081e-31 }, { -1.5619206968586225e-16, -1.1910679660273754e-32 },
    { 4.110317623312165e-19, 1.4412973378659527e-36 }, { -8.896791392450574e-22, 7.911402614872376e-38 },
    { 1.6117375710961184e-24, -3.6846573564509766e-41 }, { -2.4795962632247976e-27, 1.2953730964765229e-43 },
    { 3.279889237069838e-30, 1.5117542744029879e-46 }
};

/* Three angles at once cost hardly more than one. */
enum { ANGLES = 3, LANES = 4 };
typedef struct lanes { double hi[LANES], lo[LANES]; } lanes;

/* The sum without its first term, which is 1, so that the caller can add that exactly. |x| <= pi/4: the 15 terms reach
 * (pi/4)^28/28! < 2^-105. From the tenth on a term is below 2^-58 of the sum, so that the rounding of doubles does no
 * harm there. */
static void series(const pov_two *of, const lanes *x2, lanes *out)
{
    double hi[LANES], lo[LANES];
    int i, k;

    for (k = 0; k < LANES; k++) {
        hi[k] = of[TERMS - 1].hi;
        lo[k] = 0.0;
    }
    for (i = TERMS - 2; i >= 9; i--)
        for (k = 0; k < LANES; k++)
            hi[k] = hi[k] * x2->hi[k] + of[i].hi;
    for (i = 8; i >= 1; i--) {
        const pov_two term = of[i];
        for (k = 0; k < LANES; k++) {
            pov_two t = pov_two_mul(pov_two_of(hi[k], lo[k]), pov_two_of(x2->hi[k], x2->lo[k]));
            t = pov_two_add(t, term);
            hi[k] = t.hi;
            lo[k] = t.lo;
        }
    }
    for (k = 0; k < LANES; k++) {
        pov_two t = pov_two_mul(pov_two_of(hi[k], lo[k]), pov_two_of(x2->hi[k], x2->lo[k]));
        out->hi[k] = t.hi;
        out->lo[k] = t.lo;
    }
}

static pov_two lane_of(const lanes *l, int k)
{
    return pov_two_of(l->hi[k], l->lo[k]);
}

static void sincos_of(const double *degrees, pov_two *s, pov_two *c)
{
    /* pi/180 in two parts. fmod and the subtraction of a multiple of 90 are exact, so that the reduction is. */
    const pov_two degree = { 0.017453292519943295, 2.9486522708701687e-19 };
    lanes x2 = { { 0.0 }, { 0.0 } }, sines, cosines;
    pov_two x[ANGLES];
    int quarter[ANGLES], k;

    for (k = 0; k < ANGLES; k++) {
        double rest = fmod(degrees[k], 360.0);
        pov_two square;
        quarter[k] = (int)floor(rest / 90.0 + 0.5);
        x[k] = pov_two_mul_double(degree, rest - 90.0 * quarter[k]);
        square = pov_two_mul(x[k], x[k]);
        x2.hi[k] = square.hi;
        x2.lo[k] = square.lo;
    }
    series(of_sine, &x2, &sines);
    series(of_cosine, &x2, &cosines);
    for (k = 0; k < ANGLES; k++) {
        pov_two sine = pov_two_add(x[k], pov_two_mul(x[k], lane_of(&sines, k)));
        pov_two cosine = pov_two_add_double(lane_of(&cosines, k), 1.0), swap = sine;

        if (quarter[k] & 1) {
            sine = cosine;
            cosine = pov_two_neg(swap);
        }
        s[k] = quarter[k] & 2 ? pov_two_neg(sine) : sine;
        c[k] = quarter[k] & 2 ? pov_two_neg(cosine) : cosine;
    }
}

void transform_sincos(double degrees, double *s, double *c)
{
    const double angles[ANGLES] = { degrees, 0.0, 0.0 };
    pov_two sine[ANGLES], cosine[ANGLES];

    sincos_of(angles, sine, cosine);
    s[0] = sine[0].hi;
    s[1] = sine[0].lo;
    c[0] = cosine[0].hi;
    c[1] = cosine[0].lo;
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

/* Turn about one axis; left-handed: about x, +y goes to +z. The inverse is the transpose. */
static void turn(composition *c, int axis, pov_two sine, pov_two cosine)
{
    int u = (axis + 1) % 3, v = (axis + 2) % 3, i;

    for (i = 0; i < 3; i++)
        turn_pair(&c->map.at[i][u], &c->map.at[i][v], sine, cosine);
    for (i = 0; i < 4; i++)
        turn_pair(&c->inverse.at[u][i], &c->inverse.at[v][i], sine, cosine);
}

static void rotate(composition *c, const double *degrees)
{
    pov_two sine[ANGLES], cosine[ANGLES];
    int axis;

    sincos_of(degrees, sine, cosine);
    for (axis = 2; axis >= 0; axis--)
        if (degrees[axis] != 0.0)
            turn(c, axis, sine[axis], cosine[axis]);
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

    switch (t->kind) {
    case TRANSFORM_TRANSLATE:
        translate(c, t->v);
        break;
    case TRANSFORM_SCALE:
        scale(c, t->v);
        break;
    case TRANSFORM_ROTATE:
        rotate(c, t->v);
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
