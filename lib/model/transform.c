#include "model/transform.h"

#include "model/sincos.h"

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

/* ---- composition ---- */

/* An affine map p -> m p; the last column is the translation. */
typedef struct rows { pov_two at[3][4]; } rows;

/* The map is built from the last written transformation to the first: each is multiplied on the right, and its inverse
 * on the left of the inverse. So a column of the map is treated like the same row of the inverse. Only entries that a
 * transformation changes are computed, so that zeros stay exact. */
typedef struct composition {
    two_lanes axis[3];           /* the map's column, then the inverse's row */
    two_lanes moved;             /* the map's last column */
} composition;

static void start(composition *c)
{
    static const composition identity = { { { { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 }, { 0.0 } },
                                            { { 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0 }, { 0.0 } },
                                            { { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0 }, { 0.0 } } },
                                          { { 0.0 }, { 0.0 } } };

    memcpy(c, &identity, sizeof *c);
}

static void move_along(two_lanes *restrict moved, const two_lanes *restrict axis, double by)
{
    int i;

    for (i = 0; i < TWO_LANES; i++)
        two_set_lane(moved, i, pov_two_add(two_lane(moved, i), pov_two_mul_double(two_lane(axis, i), by)));
}

static void translate(composition *c, const double *v)
{
    int k;

    for (k = 0; k < 3; k++)
        if (v[k] != 0.0)
            move_along(&c->moved, &c->axis[k], v[k]);
    for (k = 0; k < 3; k++)
        two_set_lane(&c->axis[k], TWO_LANES - 1, pov_two_add_double(two_lane(&c->axis[k], TWO_LANES - 1), -v[k]));
}

static void scale(composition *c, const double *v)
{
    int i, k;

    for (k = 0; k < 3; k++)
        for (i = 0; i < TWO_LANES; i++) {
            const pov_two a = two_lane(&c->axis[k], i), factor = pov_two_of(v[k], 0.0);
            const pov_two more = pov_two_mul_double(a, v[k]), less = pov_two_div(a, factor);
            c->axis[k].hi[i] = i < TWO_HALF ? more.hi : less.hi;
            c->axis[k].lo[i] = i < TWO_HALF ? more.lo : less.lo;
        }
}

/* x cos + y sin, y cos - x sin. */
static void rotate_pair(two_lanes *restrict x, two_lanes *restrict y, pov_two s, pov_two c)
{
    int i;

    for (i = 0; i < TWO_LANES; i++) {
        const pov_two a = two_lane(x, i), b = two_lane(y, i);
        two_set_lane(x, i, pov_two_add(pov_two_mul(a, c), pov_two_mul(b, s)));
        two_set_lane(y, i, pov_two_sub(pov_two_mul(b, c), pov_two_mul(a, s)));
    }
}

/* Left-handed: about x, +y goes to +z. The inverse is the transpose. */
static void rotate(composition *c, const double *const *degrees, int n)
{
    sincos_turns t[TRANSFORM_MANY];
    int axis, m;

    sincos_many(t, degrees, n);
    for (axis = 2; axis >= 0; axis--)
        for (m = 0; m < n; m++)
            if (degrees[m][axis] != 0.0)
                rotate_pair(&c[m].axis[(axis + 1) % 3], &c[m].axis[(axis + 2) % 3], t[m].sine[axis], t[m].cosine[axis]);
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

/* The inverse of any matrix: cofactors over the determinant, after scaling rows by powers of two. So stiff matrices (a
 * row of 1e9 beside one of 1e-9) neither overflow nor lose the small products. False: singular. */
static bool invert(const rows *m, rows *out)
{
    rows a = *m;
    double factor[3], largest;
    pov_two determinant = { 0.0, 0.0 };
    int i, j, e;

    for (i = 0; i < 3; i++) {
        largest = pov_max(fabs(a.at[i][0].hi), pov_max(fabs(a.at[i][1].hi), fabs(a.at[i][2].hi)));
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

static void add_product(two_lanes *restrict sum, const two_lanes *restrict a, const two_lanes *restrict b)
{
    int i;

    for (i = 0; i < TWO_LANES; i++)
        two_set_lane(sum, i, pov_two_add(two_lane(sum, i), pov_two_mul(two_lane(a, i), two_lane(b, i))));
}

/* p -> map (m p), and inverse of m after the inverse. False: m has none. */
static bool multiply(composition *c, const double *v)
{
    const composition old = *c;
    const rows m = written(v);
    rows inverse;
    two_lanes factor;
    int i, j, k;

    if (!invert(&m, &inverse))
        return false;
    for (j = 0; j < 4; j++) {
        two_lanes *out = j < 3 ? &c->axis[j] : &c->moved;
        if (j < 3) {
            memset(out, 0, sizeof *out);
            two_set_lane(out, TWO_LANES - 1, inverse.at[j][3]);
        }
        for (k = 0; k < 3; k++) {
            for (i = 0; i < TWO_HALF; i++) {
                two_set_lane(&factor, i, m.at[k][j]);
                two_set_lane(&factor, TWO_HALF + i, j < 3 ? inverse.at[j][k] : pov_two_of(0.0, 0.0));
            }
            add_product(out, &old.axis[k], &factor);
        }
    }
    return true;
}

/* Append one transformation to each of n. Returns the bits of those that have no inverse. */
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
            const two_lanes *column = j < 3 ? &c->axis[j] : &c->moved, *row = &c->axis[i];
            out->m[i][j] = column->hi[i];
            out->m_lo[i][j] = column->lo[i];
            out->inv[i][j] = row->hi[TWO_HALF + j];
            out->inv_lo[i][j] = row->lo[TWO_HALF + j];
        }
}

/* Zero times infinity or NaN is not zero. */
static bool is_finite(const pov_affine *map)
{
    double sum[4] = { 0.0 };
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++)
            sum[j] += 0.0 * map->m[i][j] + 0.0 * map->m_lo[i][j] + 0.0 * map->inv[i][j] + 0.0 * map->inv_lo[i][j];
    return sum[0] + sum[1] + sum[2] + sum[3] == 0.0;
}

/* Store all of them; returns the bits of usable ones. */
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

/* The end of a list; NULL: it is of another kind than the other list. */
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

pov_vec3 transform_direction(const pov_affine *map, pov_vec3 d)
{
    pov_vec3 at, at_lo, from, from_lo;

    transform_point(map, d, &at, &at_lo);
    transform_point(map, pov_vec3_of(0.0, 0.0, 0.0), &from, &from_lo);
    return pov_add(pov_sub(at, from), pov_sub(at_lo, from_lo));
}
