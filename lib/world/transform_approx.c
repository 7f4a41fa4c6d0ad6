#include "world/transform_approx.h"

#include "base/simd.h"

/* docs/numerics.md ("Bounding boxes of instances") derives these. */
#define LOST_EACH 0x1p-46
#define MODERATE 1e100
#define NO_UNDERFLOW 0x1p-800   /* relative to a sum of squares */
enum { MOST_STEPS = 32, LANES = APPROX_MANY };

typedef double lanes[LANES];

/* ---- one transformation more ---- */

static void translate(approx_maps *restrict r, const lanes *restrict v)
{
    int i, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < LANES; k++)
            r->moved[i][k] += r->m[i][0][k] * v[0][k] + r->m[i][1][k] * v[1][k] + r->m[i][2][k] * v[2][k];
    for (k = 0; k < LANES; k++)
        r->excluded[k] += r->size[k] * (fabs(v[0][k]) + fabs(v[1][k]) + fabs(v[2][k]));
}

static void scale(approx_maps *restrict r, const lanes *restrict v)
{
    int i, j, k;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++)
            for (k = 0; k < LANES; k++)
                r->m[i][j][k] *= v[j][k];
    for (k = 0; k < LANES; k++) {
        const double x = fabs(v[0][k]), y = fabs(v[1][k]), z = fabs(v[2][k]);
        const double more = x > y ? x : y, less = x < y ? x : y;

        r->size[k] *= more > z ? more : z;
        r->least[k] *= less < z ? less : z;
    }
}

/* Sine is x (1 + the first sum), cosine is 1 + the other sum: 1/n! with its sign. */
enum { TERMS = 8 };
static const double for_sine[TERMS] = { -1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0, 1.0 / 362880.0, -1.0 / 39916800.0,
                                        1.0 / 6227020800.0, -1.0 / 1307674368000.0, 1.0 / 355687428096000.0 };
static const double for_cosine[TERMS] = { -1.0 / 2.0, 1.0 / 24.0, -1.0 / 720.0, 1.0 / 40320.0, -1.0 / 3628800.0,
                                          1.0 / 479001600.0, -1.0 / 87178291200.0, 1.0 / 20922789888000.0 };

SIMD_INLINE uint64_t bits_of(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

SIMD_INLINE double with_sign(double x, uint64_t sign)
{
    const uint64_t bits = bits_of(x) ^ sign;

    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Of an angle of less than a turn. Rounding to whole quarters leaves their number in the last bits. */
static void sincos_of(const double *restrict degrees, double *restrict s, double *restrict c)
{
    const double whole = 0x1.8p52, degree = 0.017453292519943295;
    int i, k;

    for (k = 0; k < LANES; k++) {
        const double quarters = degrees[k] * (1.0 / 90.0) + whole;
        const uint64_t number = bits_of(quarters), sign = (number & 2) << 62;
        const double x = (degrees[k] - 90.0 * (quarters - whole)) * degree, square = x * x;
        double sine = for_sine[TERMS - 1], cosine = for_cosine[TERMS - 1];

        for (i = TERMS - 2; i >= 0; i--) {
            sine = sine * square + for_sine[i];
            cosine = cosine * square + for_cosine[i];
        }
        sine = x + x * (sine * square);
        cosine = 1.0 + cosine * square;
        s[k] = with_sign(number & 1 ? cosine : sine, sign);
        c[k] = with_sign(number & 1 ? -sine : cosine, sign);
    }
}

static void rotate_pair(double *restrict x, double *restrict y, const double *restrict s, const double *restrict c)
{
    int k;

    for (k = 0; k < LANES; k++) {
        const double a = x[k], b = y[k];

        x[k] = a * c[k] + b * s[k];
        y[k] = b * c[k] - a * s[k];
    }
}

static void rotate(approx_maps *r, const lanes *v)
{
    lanes s, c;
    int axis, i, k;

    for (k = 0; k < LANES; k++)
        r->excluded[k] += 0.0 * (v[0][k] + v[1][k] + v[2][k]);   /* not moderate if an angle is NaN */

    for (axis = 2; axis >= 0; axis--) {
        sincos_of(v[axis], s, c);
        for (i = 0; i < 3; i++)
            rotate_pair(r->m[i][(axis + 1) % 3], r->m[i][(axis + 2) % 3], s, c);
    }
}

/* ---- all of them ---- */

static void start(approx_maps *r)
{
    int i, j, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < LANES; k++) {
            for (j = 0; j < 3; j++)
                r->m[i][j][k] = i == j;
            r->moved[i][k] = 0.0;
        }
    for (k = 0; k < LANES; k++) {
        r->size[k] = r->least[k] = 1.0;
        r->excluded[k] = 0.0;
    }
    r->lost = LOST_EACH;
}

/* The parameters of transformations of one kind; angles as fractions of a turn. */
static void take(const transform *const *t, lanes v[3])
{
    int j, k;

    for (k = 0; k < LANES; k++)
        for (j = 0; j < 3; j++)
            v[j][k] = t[k]->v[j];
    if (t[0]->kind != TRANSFORM_ROTATE)
        return;
    for (j = 0; j < 3; j++)
        for (k = 0; k < LANES; k++)
            if (!(fabs(v[j][k]) < 360.0))
                v[j][k] = fmod(v[j][k], 360.0);
}

static unsigned find_moderate(const approx_maps *r, int n)
{
    unsigned moderate = 0;
    int k;

    for (k = 0; k < n; k++)
        moderate |= (unsigned)(r->size[k] < MODERATE && r->excluded[k] < MODERATE && r->least[k] > 1.0 / MODERATE) << k;
    return moderate;
}

unsigned transform_approx(const transform *const *lists, int n, approx_maps *out)
{
    const transform *t[LANES];
    lanes v[3];
    int steps, k;

    start(out);
    for (k = 0; k < LANES; k++)
        t[k] = lists[k < n ? k : 0];
    for (steps = 0; t[0]; steps++) {
        if (t[0]->kind == TRANSFORM_MATRIX || steps == MOST_STEPS)
            return 0;
        take(t, v);
        if (t[0]->kind == TRANSFORM_TRANSLATE)
            translate(out, (const lanes *)v);
        else if (t[0]->kind == TRANSFORM_SCALE)
            scale(out, (const lanes *)v);
        else
            rotate(out, (const lanes *)v);
        out->lost += LOST_EACH;
        for (k = 0; k < LANES; k++)
            t[k] = t[k]->before;
    }
    return find_moderate(out, n);
}

/* Half extent of a transformed box, or of an ellipsoid within it, along one row. */
static double half_of(pov_vec3 row, pov_vec3 r, bool round)
{
    const double x = row.x * r.x, y = row.y * r.y, z = row.z * r.z, square = x * x + y * y + z * z;

    return round && square > NO_UNDERFLOW ? sqrt(square) : fabs(x) + fabs(y) + fabs(z);
}

bool transform_approx_box(const approx_maps *maps, int lane, const pov_box *box, bool round, pov_box *out)
{
    const pov_vec3 c = pov_add(pov_scale(box->lo, 0.5), pov_scale(box->hi, 0.5));
    const pov_vec3 above = pov_sub(box->hi, c), below = pov_sub(c, box->lo);
    const pov_vec3 r = { above.x > below.x ? above.x : below.x, above.y > below.y ? above.y : below.y,
                         above.z > below.z ? above.z : below.z };
    const double far = fabs(c.x) + fabs(c.y) + fabs(c.z) + r.x + r.y + r.z;
    const double reach = maps->excluded[lane] + maps->size[lane] * far, lost = maps->lost * reach;
    double lo[3], hi[3];
    int i;

    for (i = 0; i < 3; i++) {
        const pov_vec3 row = { maps->m[i][0][lane], maps->m[i][1][lane], maps->m[i][2][lane] };
        const double middle = maps->moved[i][lane] + pov_dot(row, c), half = half_of(row, r, round) + lost;

        lo[i] = middle - half;
        hi[i] = middle + half;
    }
    out->lo = pov_vec3_of(lo[0], lo[1], lo[2]);
    out->hi = pov_vec3_of(hi[0], hi[1], hi[2]);
    return reach < MODERATE;
}

/* ---- what becomes of shapes ---- */

/* One scale with different factors, rotated and translated in any way, leaves no sphere; two may cancel. */
bool transform_is_uneven(const transform *list)
{
    int uneven = 0;

    for (; list; list = list->before) {
        const double *v = list->v;

        if (list->kind == TRANSFORM_MATRIX)
            return false;
        uneven += list->kind == TRANSFORM_SCALE && (fabs(v[0]) != fabs(v[1]) || fabs(v[1]) != fabs(v[2]));
    }
    return uneven == 1;
}

static bool is_oblique(double degrees)
{
    const double quarters = degrees / 90.0;

    return quarters != floor(quarters);
}

/* One rotation about y by no whole quarters, or about one of the other axes only. Two of them, or those about x and z
 * with a quarter turn about y between them, may cancel. */
bool transform_is_turned(const transform *list)
{
    int rotations = 0;
    bool turned = false;

    for (; list; list = list->before) {
        if (list->kind == TRANSFORM_MATRIX)
            return false;
        if (list->kind == TRANSFORM_ROTATE) {
            rotations++;
            turned = is_oblique(list->v[1]) || is_oblique(list->v[0]) != is_oblique(list->v[2]);
        }
    }
    return rotations == 1 && turned;
}
