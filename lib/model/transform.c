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

static size_t count_of(transform_kind kind)
{
    return kind == TRANSFORM_MATRIX ? 12 : 3;
}

const transform *transform_append(arena *memory, const transform *before, transform_kind kind, const double *numbers)
{
    size_t bytes = count_of(kind) * sizeof *numbers;
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

/* Numbers on which the same is done, eight in plain loops, which compilers take as vectors. Four and four are of two
 * kinds; the last of each four means nothing, or little. */
enum { LANES = 8, HALF = LANES / 2 };
typedef struct lanes { double hi[LANES], lo[LANES]; } lanes;

static inline pov_two lane_of(const lanes *l, int k)
{
    return pov_two_of(l->hi[k], l->lo[k]);
}

static inline void set_lane(lanes *l, int k, pov_two to)
{
    l->hi[k] = to.hi;
    l->lo[k] = to.lo;
}

/* What x^2 is multiplied by in the Taylor series of sin(x) / x, for the first four lanes, and of cos(x), for the
 * others: 1/n! with its sign. */
#define FOUR(x) x, x, x, x
#define TERM(sine, sine_lo, cosine, cosine_lo) { { FOUR(sine), FOUR(cosine) }, { FOUR(sine_lo), FOUR(cosine_lo) } }
enum { TERMS = 15 };
static const lanes terms[TERMS] = {
    TERM(1.0, 0.0, 1.0, 0.0),
    TERM(-0.16666666666666666, -9.25185853854297e-18, -0.5, 0.0),
    TERM(0.008333333333333333, 1.1564823173178714e-19, 0.041666666666666664, 2.3129646346357427e-18),
    TERM(-0.0001984126984126984, -1.7209558293420705e-22, -0.001388888888888889, 5.300543954373577e-20),
    TERM(2.7557319223985893e-06, -1.858393274046472e-22, 2.48015873015873e-05, 2.1511947866775882e-23),
    TERM(-2.505210838544172e-08, 1.448814070935912e-24, -2.755731922398589e-07, -2.3767714622250297e-23),
    TERM(1.6059043836821613e-10, 1.2585294588752098e-26, 2.08767569878681e-09, -1.20734505911326e-25),
    TERM(-7.647163731819816e-13, -7.03872877733453e-30, -1.1470745597729725e-11, -2.0655512752830745e-28),
    TERM(2.8114572543455206e-15, 1.6508842730861433e-31, 4.779477332387385e-14, 4.399205485834081e-31),
    TERM(-8.22063524662433e-18, -2.2141894119604265e-34, -1.5619206968586225e-16, -1.1910679660273754e-32),
    TERM(1.9572941063391263e-20, -1.3643503830087908e-36, 4.110317623312165e-19, 1.4412973378659527e-36),
    TERM(-3.868170170630684e-23, 8.843177655482344e-40, -8.896791392450574e-22, 7.911402614872376e-38),
    TERM(6.446950284384474e-26, -1.9330404233703465e-42, 1.6117375710961184e-24, -3.6846573564509766e-41),
    TERM(-9.183689863795546e-29, -1.4303150396787322e-45, -2.4795962632247976e-27, 1.2953730964765229e-43),
    TERM(1.1309962886447716e-31, 1.0498015412959506e-47, 3.279889237069838e-30, 1.5117542744029879e-46)
};

/* The sums without their first terms, which are 1, so that the caller can add that exactly. |x| <= pi/4: the 15 terms
 * reach (pi/4)^28/28! < 2^-105. From the tenth on a term is below 2^-58 of the sum, so that the rounding of doubles does
 * no harm there. Each step waits for the one before, so n sums side by side cost little more than one. */
static void series(const lanes *restrict x2, lanes *restrict sum, int n)
{
    int i, k, m;

    for (m = 0; m < n; m++)
        for (k = 0; k < LANES; k++) {
            double tail = terms[TERMS - 1].hi[k];
            for (i = TERMS - 2; i >= 9; i--)
                tail = tail * x2[m].hi[k] + terms[i].hi[k];
            set_lane(&sum[m], k, pov_two_of(tail, 0.0));
        }
    for (i = 8; i >= 1; i--)
        for (m = 0; m < n; m++)
            for (k = 0; k < LANES; k++)
                set_lane(&sum[m], k,
                         pov_two_add(pov_two_mul(lane_of(&sum[m], k), lane_of(&x2[m], k)), lane_of(&terms[i], k)));
    for (m = 0; m < n; m++)
        for (k = 0; k < LANES; k++)
            set_lane(&sum[m], k, pov_two_mul(lane_of(&sum[m], k), lane_of(&x2[m], k)));
}

enum { ANGLES = 3 };

/* Of three angles each. */
typedef struct turns { pov_two x[ANGLES], sine[ANGLES], cosine[ANGLES]; int quarter[ANGLES]; } turns;

static void reduce(turns *t, const double *degrees, lanes *x2)
{
    /* pi/180 in two parts. fmod and the subtraction of a multiple of 90 are exact, so that the reduction is. */
    const pov_two degree = { 0.017453292519943295, 2.9486522708701687e-19 };
    int k;

    memset(x2, 0, sizeof *x2);
    for (k = 0; k < ANGLES; k++) {
        double rest = fabs(degrees[k]) < 360.0 ? degrees[k] : fmod(degrees[k], 360.0);
        pov_two square;
        t->quarter[k] = (int)floor(rest / 90.0 + 0.5);
        t->x[k] = pov_two_mul_double(degree, rest - 90.0 * t->quarter[k]);
        square = pov_two_mul(t->x[k], t->x[k]);
        set_lane(x2, k, square);
        set_lane(x2, HALF + k, square);
    }
}

static void finish(turns *t, const lanes *sum)
{
    int k;

    for (k = 0; k < ANGLES; k++) {
        pov_two sine = pov_two_add(t->x[k], pov_two_mul(t->x[k], lane_of(sum, k)));
        pov_two cosine = pov_two_add_double(lane_of(sum, HALF + k), 1.0), swap = sine;

        if (t->quarter[k] & 1) {
            sine = cosine;
            cosine = pov_two_neg(swap);
        }
        t->sine[k] = t->quarter[k] & 2 ? pov_two_neg(sine) : sine;
        t->cosine[k] = t->quarter[k] & 2 ? pov_two_neg(cosine) : cosine;
    }
}

static void sincos_of(turns *t, const double *const *degrees, int n)
{
    lanes x2[TRANSFORM_MANY], sum[TRANSFORM_MANY];
    int m;

    for (m = 0; m < n; m++)
        reduce(&t[m], degrees[m], &x2[m]);
    series(x2, sum, n);
    for (m = 0; m < n; m++)
        finish(&t[m], &sum[m]);
}

void transform_sincos(double degrees, double *s, double *c)
{
    const double angles[ANGLES] = { degrees, 0.0, 0.0 }, *all = angles;
    turns t;

    sincos_of(&t, &all, 1);
    s[0] = t.sine[0].hi;
    s[1] = t.sine[0].lo;
    c[0] = t.cosine[0].hi;
    c[1] = t.cosine[0].lo;
}

/* ---- composition ---- */

/* An affine map p -> m p, the last column moves. */
typedef struct rows { pov_two at[3][4]; } rows;

/* The map is built from the last written transformation to the first: each joins it on the right, and its inverse
 * joins the inverse on the left. So a column of the map has the fate of that row of the inverse. Only what a
 * transformation changes is touched, so that zeros stay exact. */
typedef struct composition {
    lanes axis[3];               /* the map's column, then the inverse's row */
    lanes moved;                 /* the map's last column */
} composition;

static void start(composition *c)
{
    static const composition identity = { { { { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 }, { 0.0 } },
                                            { { 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0 }, { 0.0 } },
                                            { { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0 }, { 0.0 } } },
                                          { { 0.0 }, { 0.0 } } };

    memcpy(c, &identity, sizeof *c);
}

static void move_along(lanes *restrict moved, const lanes *restrict axis, double by)
{
    int i;

    for (i = 0; i < LANES; i++)
        set_lane(moved, i, pov_two_add(lane_of(moved, i), pov_two_mul_double(lane_of(axis, i), by)));
}

static void translate(composition *c, const double *v)
{
    int k;

    for (k = 0; k < 3; k++)
        if (v[k] != 0.0)
            move_along(&c->moved, &c->axis[k], v[k]);
    for (k = 0; k < 3; k++)
        set_lane(&c->axis[k], LANES - 1, pov_two_add_double(lane_of(&c->axis[k], LANES - 1), -v[k]));
}

static void scale(composition *c, const double *v)
{
    int i, k;

    for (k = 0; k < 3; k++)
        for (i = 0; i < LANES; i++) {
            const pov_two a = lane_of(&c->axis[k], i), factor = pov_two_of(v[k], 0.0);
            const pov_two more = pov_two_mul_double(a, v[k]), less = pov_two_div(a, factor);
            c->axis[k].hi[i] = i < HALF ? more.hi : less.hi;
            c->axis[k].lo[i] = i < HALF ? more.lo : less.lo;
        }
}

/* x cos + y sin, y cos - x sin. */
static void turn_pair(lanes *restrict x, lanes *restrict y, pov_two s, pov_two c)
{
    int i;

    for (i = 0; i < LANES; i++) {
        const pov_two a = lane_of(x, i), b = lane_of(y, i);
        set_lane(x, i, pov_two_add(pov_two_mul(a, c), pov_two_mul(b, s)));
        set_lane(y, i, pov_two_sub(pov_two_mul(b, c), pov_two_mul(a, s)));
    }
}

/* Left-handed: about x, +y goes to +z. The inverse is the transpose. */
static void rotate(composition *c, const double *const *degrees, int n)
{
    turns t[TRANSFORM_MANY];
    int axis, m;

    sincos_of(t, degrees, n);
    for (axis = 2; axis >= 0; axis--)
        for (m = 0; m < n; m++)
            if (degrees[m][axis] != 0.0)
                turn_pair(&c[m].axis[(axis + 1) % 3], &c[m].axis[(axis + 2) % 3], t[m].sine[axis], t[m].cosine[axis]);
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

static void add_product(lanes *restrict sum, const lanes *restrict a, const lanes *restrict b)
{
    int i;

    for (i = 0; i < LANES; i++)
        set_lane(sum, i, pov_two_add(lane_of(sum, i), pov_two_mul(lane_of(a, i), lane_of(b, i))));
}

/* p -> map (m p), and inverse of m after the inverse. False: m has none. */
static bool multiply(composition *c, const double *v)
{
    const composition old = *c;
    const rows m = written(v);
    rows inverse;
    lanes factor;
    int i, j, k;

    if (!invert(&m, &inverse))
        return false;
    for (j = 0; j < 4; j++) {
        lanes *out = j < 3 ? &c->axis[j] : &c->moved;
        if (j < 3) {
            memset(out, 0, sizeof *out);
            set_lane(out, LANES - 1, inverse.at[j][3]);
        }
        for (k = 0; k < 3; k++) {
            for (i = 0; i < HALF; i++) {
                set_lane(&factor, i, m.at[k][j]);
                set_lane(&factor, HALF + i, j < 3 ? inverse.at[j][k] : pov_two_of(0.0, 0.0));
            }
            add_product(out, &old.axis[k], &factor);
        }
    }
    return true;
}

/* One transformation more for each of n. The bits of those that have no inverse are returned. */
static unsigned join(composition *c, transform_kind kind, const double *const *v, int n)
{
    unsigned flat = 0;
    int m;

    switch (kind) {
    case TRANSFORM_TRANSLATE:
        for (m = 0; m < n; m++)
            translate(&c[m], v[m]);
        break;
    case TRANSFORM_SCALE:
        for (m = 0; m < n; m++)
            scale(&c[m], v[m]);
        break;
    case TRANSFORM_ROTATE:
        rotate(c, v, n);
        break;
    case TRANSFORM_MATRIX:
        for (m = 0; m < n; m++)
            flat |= (unsigned)!multiply(&c[m], v[m]) << m;
        break;
    }
    return flat;
}

static void store(const composition *c, pov_affine *out)
{
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++) {
            const lanes *column = j < 3 ? &c->axis[j] : &c->moved, *row = &c->axis[i];
            out->m[i][j] = column->hi[i];
            out->m_lo[i][j] = column->lo[i];
            out->inv[i][j] = row->hi[HALF + j];
            out->inv_lo[i][j] = row->lo[HALF + j];
        }
}

/* Zero times anything else is no zero. */
static bool is_finite(const pov_affine *map)
{
    double sum[4] = { 0.0 };
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++)
            sum[j] += 0.0 * map->m[i][j] + 0.0 * map->m_lo[i][j] + 0.0 * map->inv[i][j] + 0.0 * map->inv_lo[i][j];
    return sum[0] + sum[1] + sum[2] + sum[3] == 0.0;
}

/* All of them to be stored; those that are fit for use. */
static unsigned store_all(const composition *c, unsigned flat, pov_affine *out, int n)
{
    unsigned good = 0;
    int m;

    for (m = 0; m < n; m++) {
        store(&c[m], &out[m]);
        good |= (unsigned)(!(flat >> m & 1) && is_finite(&out[m])) << m;
    }
    return good;
}

bool transform_are_alike(const transform *a, const transform *b)
{
    while (a && b && a->kind == b->kind) {
        a = a->before;
        b = b->before;
    }
    return !a && !b;
}

unsigned transform_compose_many(const transform *const *lists, int n, pov_affine *out)
{
    const transform *t[TRANSFORM_MANY];
    const double *v[TRANSFORM_MANY] = { NULL };
    composition c[TRANSFORM_MANY];
    unsigned flat = 0;
    int m;

    for (m = 0; m < n; m++) {
        start(&c[m]);
        t[m] = lists[m];
    }
    while (t[0]) {
        const transform_kind kind = t[0]->kind;
        for (m = 0; m < n; m++) {
            v[m] = t[m]->v;
            t[m] = t[m]->before;
        }
        flat |= join(c, kind, v, n);
    }
    return store_all(c, flat, out, n);
}

bool transform_compose(const transform *list, pov_affine *out)
{
    return transform_compose_many(&list, 1, out) != 0;
}

/* ---- lists one behind the other ---- */

typedef struct packed { transform_kind kind; int more; double v[]; } packed;

static const packed *next_of(const packed *p)
{
    return (const packed *)(const void *)(p->v + count_of(p->kind));
}

size_t transform_packed_bytes(const transform *list)
{
    size_t bytes = 0;

    for (; list; list = list->before)
        bytes += sizeof(packed) + count_of(list->kind) * sizeof *list->v;
    return bytes;
}

void transform_pack(const transform *list, void *at)
{
    packed *p = at;

    for (; list; list = list->before) {
        p->kind = list->kind;
        p->more = list->before != NULL;
        memcpy(p->v, list->v, count_of(list->kind) * sizeof *p->v);
        p = (packed *)(void *)(p->v + count_of(list->kind));
    }
}

/* The end of a list; NULL: it is not like the other. */
static const packed *end_if_alike(const packed *p, const packed *other)
{
    while (p->kind == other->kind && p->more == other->more) {
        if (!p->more)
            return next_of(p);
        p = next_of(p);
        other = next_of(other);
    }
    return NULL;
}

const void *transform_compose_packed(const void *at, const void *end, pov_affine *out, int *count)
{
    const packed *p[TRANSFORM_MANY], *next = end_if_alike(at, at);
    const double *v[TRANSFORM_MANY] = { NULL };
    composition c[TRANSFORM_MANY];
    int n = 1, m;
    bool more;

    p[0] = at;
    while (n < TRANSFORM_MANY && (const void *)next != end && end_if_alike(next, at)) {
        p[n++] = next;
        next = end_if_alike(next, at);
    }
    for (m = 0; m < n; m++)
        start(&c[m]);
    do {
        const transform_kind kind = p[0]->kind;
        more = p[0]->more != 0;
        for (m = 0; m < n; m++) {
            v[m] = p[m]->v;
            p[m] = next_of(p[m]);
        }
        join(c, kind, v, n);
    } while (more);
    store_all(c, 0, out, n);
    *count = n;
    return next;
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
