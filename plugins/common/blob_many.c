/* The first crossings of rays with a blob, side by side: by the operations of blob.c. Each lane goes through its own intervals between the ends
 * of stretches, to the next one whose field may cross the threshold; there it waits for the others, and all ask for their roots together. */
#include "common/blob.h"

#include "common/bernstein.h"
#include "common/simd.h"

enum { N = COMMON_ENTRIES, MOST = 32 };
typedef common_by_entry lane;

/* By lane: the ray from its base on, as far as the box. A root up to `enough` may not count, one up to `least` does not. */
typedef struct lines { lane ox, oy, oz, dx, dy, dz, ix, iy, iz, base, lo, hi, enough, least, own; } lines;

/* By lane, as the stretch of blob.c; where there is none it ends before it begins. */
typedef struct stretches { lane lo, hi, a, b, c, most; double strength; uint32_t number; } stretches;
typedef struct all_stretches { stretches at[MOST]; const stretches *in_order[MOST]; uint32_t count; } all_stretches;

/* The interval that a lane is at, infinite behind the last; above 0 where it may hold a root, where what it holds is open, and the root. */
typedef struct places { lane from, to, may, open, root; } places;

COMMON_SEPARATE static void find_lines(const common_entries *restrict l, lines *restrict n)
{
    for (uint32_t i = 0; i < N; i++) {
        const double own = l->own[i], base = own > 0.0 ? 0.0 : l->lo[i], dx = l->d[0][i], dy = l->d[1][i], dz = l->d[2][i];
        const double off = 0x1p-40 * (1.0 + fabs(base)), least = l->least[i] - base, enough = least + off;
        const double near = own > 0.0 ? COMMON_BLOB_NEAR : -HUGE_VAL;

        n->ox[i] = pov_along(pov_two_of(l->f[0][i], l->f[1][i]), base, dx, l->d_lo[0][i]);
        n->oy[i] = pov_along(pov_two_of(l->f[2][i], l->f[3][i]), base, dy, l->d_lo[1][i]);
        n->oz[i] = pov_along(pov_two_of(l->f[4][i], l->f[5][i]), base, dz, l->d_lo[2][i]);
        n->dx[i] = dx;
        n->dy[i] = dy;
        n->dz[i] = dz;
        n->ix[i] = 1.0 / dx;
        n->iy[i] = 1.0 / dy;
        n->iz[i] = 1.0 / dz;
        n->base[i] = base;
        n->lo[i] = own > 0.0 ? -COMMON_BLOB_NEAR : 0.0;
        n->hi[i] = l->hi[i] - base;
        n->enough[i] = enough > near ? enough : near;
        n->least[i] = least - off;
        n->own[i] = own;
    }
}

COMMON_INLINE bool is_any(const double *flags)
{
    double sum[N / 2];

    for (uint32_t i = 0; i < N / 2; i++)
        sum[i] = flags[i] + flags[i + N / 2];
    return sum[0] + sum[1] + sum[2] + sum[3] > 0.0;
}

/* ---- stretches ---- */

/* The line in the space of a part that is what is near a piece of the z axis; of others the quadratic of d^2 / r^2. Above 0 where it comes
 * within the part, or the endless tube. */
typedef struct views { lane ox, oy, oz, dx, dy, dz, a, b, c, may; } views;

COMMON_INLINE pov_vec3 mapped(double m[3][4], double x, double y, double z, double one)
{
    return pov_vec3_of(m[0][0] * x + m[0][1] * y + m[0][2] * z + m[0][3] * one, m[1][0] * x + m[1][1] * y + m[1][2] * z + m[1][3] * one,
                       m[2][0] * x + m[2][1] * y + m[2][2] * z + m[2][3] * one);
}

COMMON_INLINE void put(views *v, uint32_t i, double a, double b, double c, double lo, double hi)
{
    v->a[i] = a;
    v->b[i] = b;
    v->c[i] = c;
    v->may[i] = lo < hi ? a > 0.0 ? b * b - a * (c - 1.0) > 0.0 ? 1.0 : 0.0 : 0.0 : 0.0;
}

/* Most parts are passed by all lanes, which is known without roots and divisions. */
COMMON_SEPARATE static bool look_at_tube(const common_blob_part *restrict part, const lines *restrict n, views *restrict out)
{
    double m[3][4];

    memcpy(m, part->m, sizeof m);
    for (uint32_t i = 0; i < N; i++) {
        const pov_vec3 o = mapped(m, n->ox[i], n->oy[i], n->oz[i], 1.0), d = mapped(m, n->dx[i], n->dy[i], n->dz[i], 0.0);
        const double a = d.x * d.x + d.y * d.y, lo = n->lo[i], hi = n->hi[i];

        out->ox[i] = o.x;
        out->oy[i] = o.y;
        out->oz[i] = o.z;
        out->dx[i] = d.x;
        out->dy[i] = d.y;
        out->dz[i] = d.z;
        put(out, i, a, o.x * d.x + o.y * d.y, o.x * o.x + o.y * o.y, lo, hi);
        out->may[i] = a > 0.0 ? out->may[i] : lo < hi ? 1.0 : 0.0;
    }
    return is_any(out->may);
}

COMMON_SEPARATE static bool look_at_moved(const common_blob_part *restrict part, const lines *restrict n, views *restrict out)
{
    double m[3][4];

    memcpy(m, part->m, sizeof m);
    for (uint32_t i = 0; i < N; i++) {
        const pov_vec3 o = mapped(m, n->ox[i], n->oy[i], n->oz[i], 1.0), d = mapped(m, n->dx[i], n->dy[i], n->dz[i], 0.0);

        put(out, i, pov_dot(d, d), pov_dot(o, d), pov_dot(o, o), n->lo[i], n->hi[i]);
    }
    return is_any(out->may);
}

COMMON_SEPARATE static bool look_at_sphere(const common_blob_part *restrict part, const lines *restrict n, views *restrict out)
{
    const double x = part->centre.x, y = part->centre.y, z = part->centre.z, per = part->per_square;

    for (uint32_t i = 0; i < N; i++) {
        const pov_vec3 o = pov_vec3_of(n->ox[i] - x, n->oy[i] - y, n->oz[i] - z), d = pov_vec3_of(n->dx[i], n->dy[i], n->dz[i]);

        put(out, i, pov_dot(d, d) * per, pov_dot(o, d) * per, pov_dot(o, o) * per, n->lo[i], n->hi[i]);
    }
    return is_any(out->may);
}

/* The part where d^2 / r^2 is below one. */
COMMON_INLINE void keep(stretches *s, double strength, uint32_t i, double lo, double hi, double a, double b, double c, double may)
{
    const double d = b * b - a * (c - 1.0), middle = -b / a, half = sqrt(common_greater(d, 0.0)) / a, depth = d / a;
    const double first = common_greater(lo, middle - half), last = common_lesser(hi, middle + half);
    const double crossed = a > 0.0 ? d > 0.0 ? lo < hi ? may : 0.0 : 0.0 : 0.0, any = first < last ? crossed : 0.0;

    s->lo[i] = any > 0.0 ? first : HUGE_VAL;
    s->hi[i] = any > 0.0 ? last : -HUGE_VAL;
    s->most[i] = any > 0.0 ? strength * depth * depth : 0.0;
    s->a[i] = a;
    s->b[i] = b;
    s->c[i] = c;
}

COMMON_SEPARATE static void find_sphere(const lines *restrict n, const views *restrict v, stretches *restrict out)
{
    const double most = common_greater(out->strength, 0.0);

    for (uint32_t i = 0; i < N; i++)
        keep(out, most, i, n->lo[i], n->hi[i], v->a[i], v->b[i], v->c[i], v->may[i]);
}

/* Of an end: the sphere about the place `at` on the axis, the origin moved there. */
COMMON_SEPARATE static void find_end(const lines *restrict n, const views *restrict v, double at, bool is_far, stretches *restrict out)
{
    const double most = common_greater(out->strength, 0.0), side = is_far ? 1.0 : -1.0;

    for (uint32_t i = 0; i < N; i++) {
        const pov_vec3 o = pov_vec3_of(v->ox[i], v->oy[i], v->oz[i]), d = pov_vec3_of(v->dx[i], v->dy[i], v->dz[i]);
        const double lo = n->lo[i], hi = n->hi[i], up = d.z * side > 0.0 ? 1.0 : 0.0, plane = (at - o.z) / d.z;
        /* A line that is level stays on one side of the plane. */
        const double beyond = is_far ? o.z < at ? 0.0 : 1.0 : o.z <= at ? 1.0 : 0.0, level = beyond > 0.0 ? -HUGE_VAL : HUGE_VAL;
        const double from = d.z == 0.0 ? level : up > 0.0 ? plane : -HUGE_VAL, to = d.z == 0.0 ? HUGE_VAL : up > 0.0 ? HUGE_VAL : plane;

        keep(out, most, i, common_greater(lo, from), common_lesser(hi, to), pov_dot(d, d), is_far ? pov_dot(o, d) - at * d.z : pov_dot(o, d),
             is_far ? pov_dot(o, o) + at * (at - 2.0 * o.z) : pov_dot(o, o), v->may[i]);
    }
}

COMMON_SEPARATE static void find_tube(const lines *restrict n, const views *restrict v, double length, stretches *restrict out)
{
    const double most = common_greater(out->strength, 0.0);

    for (uint32_t i = 0; i < N; i++) {
        const double oz = v->oz[i], dz = v->dz[i], a = v->a[i], c = v->c[i], may = v->may[i], first = -oz / dz, second = (length - oz) / dz;
        const double stays = oz > 0.0 ? oz < length ? -HUGE_VAL : HUGE_VAL : HUGE_VAL;
        const double lo = common_greater(n->lo[i], dz == 0.0 ? stays : dz > 0.0 ? first : second);
        const double hi = common_lesser(n->hi[i], dz == 0.0 ? HUGE_VAL : dz > 0.0 ? second : first);
        /* Along the axis it is as wide everywhere. */
        const double along = a > 0.0 ? 0.0 : c < 1.0 ? lo < hi ? may : 0.0 : 0.0;

        keep(out, most, i, lo, hi, a, v->b[i], c, may);
        out->lo[i] = along > 0.0 ? lo : out->lo[i];
        out->hi[i] = along > 0.0 ? hi : out->hi[i];
        out->most[i] = along > 0.0 ? most : out->most[i];
    }
}

/* Has any lane a place of the run's box? */
COMMON_SEPARATE static bool is_near(const pov_box *restrict box, const lines *restrict n)
{
    const pov_vec3 lo = box->lo, hi = box->hi;
    lane any;

    for (uint32_t i = 0; i < N; i++) {
        const double ax = (lo.x - n->ox[i]) * n->ix[i], bx = (hi.x - n->ox[i]) * n->ix[i], ay = (lo.y - n->oy[i]) * n->iy[i];
        const double by = (hi.y - n->oy[i]) * n->iy[i], az = (lo.z - n->oz[i]) * n->iz[i], bz = (hi.z - n->oz[i]) * n->iz[i];
        const double x = common_greater(common_lesser(ax, bx), n->lo[i]), y = common_greater(common_lesser(ay, by), x);
        const double u = common_lesser(common_greater(ax, bx), n->hi[i]), v = common_lesser(common_greater(ay, by), u);
        const double from = common_greater(common_lesser(az, bz), y), to = common_lesser(common_greater(az, bz), v);

        any[i] = from > to ? 0.0 : 1.0;
    }
    return is_any(any);
}

/* False: there are too many. */
static bool add_part(const common_blob_part *part, const lines *n, all_stretches *io)
{
    const uint32_t parts = part->length > 0.0 ? 3 : 1;
    stretches *const out = &io->at[io->count];
    views v;

    if (!(parts == 3 ? look_at_tube : part->per_square > 0.0 ? look_at_sphere : look_at_moved)(part, n, &v))
        return true;
    if (io->count + parts > MOST)
        return false;
    for (uint32_t k = 0; k < parts; k++) {
        out[k].strength = part->strength;
        out[k].number = part->number;
    }
    if (parts == 1) {
        find_sphere(n, &v, out);
    } else {
        find_end(n, &v, 0.0, false, out);
        find_tube(n, &v, part->length, &out[1]);
        find_end(n, &v, part->length, true, &out[2]);
    }
    io->count += parts;
    return true;
}

static bool find_stretches(const common_blob *b, const lines *n, all_stretches *out)
{
    const common_runs *r = &b->runs;

    out->count = 0;
    for (uint32_t i = 0; i < b->count;)
        if (r->box && i % COMMON_RUNS == 0 && !is_near(&r->around[i / COMMON_RUNS], n))
            i += COMMON_RUNS;
        else if (r->box && i % COMMON_RUN == 0 && !is_near(&r->box[i / COMMON_RUN], n))
            i += COMMON_RUN;
        else if (!add_part(&b->at[i++], n, out))
            return false;
    for (uint32_t k = 0; k < out->count; k++) {
        const stretches *const s = &out->at[k];
        uint32_t j = k;

        for (; b->by_number && j > 0 && out->in_order[j - 1]->number > s->number; j--)
            out->in_order[j] = out->in_order[j - 1];
        out->in_order[j] = s;
    }
    return true;
}

/* ---- intervals ---- */

COMMON_SEPARATE static void begin(const all_stretches *restrict s, places *restrict p)
{
    for (uint32_t i = 0; i < N; i++) {
        p->from[i] = p->root[i] = HUGE_VAL;
        p->open[i] = 0.0;
    }
    for (uint32_t k = 0; k < s->count; k++)
        for (uint32_t i = 0; i < N; i++)
            p->from[i] = common_lesser(s->at[k].lo[i], p->from[i]);
}

/* How far the interval goes; false: the field stays below the threshold in all of them. */
COMMON_SEPARATE static bool find_ends(const common_blob *restrict b, const all_stretches *restrict s, places *restrict p)
{
    const double limit = b->threshold > 0.0 ? b->threshold * (1.0 - 0x1p-30) : -HUGE_VAL;
    lane most, may;

    for (uint32_t i = 0; i < N; i++) {
        p->to[i] = HUGE_VAL;
        most[i] = 0.0;
    }
    for (uint32_t k = 0; k < s->count; k++)
        for (uint32_t i = 0; i < N; i++) {
            const double lo = s->at[k].lo[i], hi = s->at[k].hi[i], from = p->from[i];

            p->to[i] = common_lesser(lo > from ? lo : HUGE_VAL, p->to[i]);
            p->to[i] = common_lesser(hi > from ? hi : HUGE_VAL, p->to[i]);
            most[i] += lo <= from ? hi > from ? s->at[k].most[i] : 0.0 : 0.0;
        }
    for (uint32_t i = 0; i < N; i++)
        may[i] = most[i] > limit ? p->to[i] < HUGE_VAL ? 1.0 : 0.0 : 0.0;
    return is_any(may);
}

COMMON_INLINE double between(const stretches *restrict s, uint32_t i, double t, double u) { return 1.0 - (s->a[i] * t * u + s->b[i] * (t + u) + s->c[i]); }

/* At an end of the interval: at the rim zero. `side` is 1 where the stretch begins, and -1 where it ends. */
COMMON_INLINE double depth_at(const stretches *restrict s, uint32_t i, double t, double rim, double side)
{
    const double a = s->a[i], b = s->b[i], depth = 1.0 - ((a * t + 2.0 * b) * t + s->c[i]);

    return t == rim ? side * (a * t + b) < 0.0 ? fabs(depth) < 0x1p-30 ? 0.0 : depth : between(s, i, t, t) : between(s, i, t, t);
}

/* The field less the threshold, as blob.c has it: where all of its coefficients are on one side there is no root. */
COMMON_SEPARATE static void find_fields(const common_blob *restrict blob, const all_stretches *restrict s, const places *restrict p,
                                        common_bernsteins *restrict out)
{
    const double threshold = blob->threshold;

    for (int k = 0; k < 5; k++)
        for (uint32_t i = 0; i < N; i++)
            out->b[k][i] = -threshold;
    for (uint32_t k = 0; k < s->count; k++) {
        const stretches *restrict const one = s->in_order[k];
        const double strength = one->strength;

        for (uint32_t i = 0; i < N; i++) {
            const double from = p->from[i], to = p->to[i], lo = one->lo[i], hi = one->hi[i], here = lo <= from ? hi >= to ? 1.0 : 0.0 : 0.0;
            const double e = depth_at(one, i, from, lo, 1.0), f = between(one, i, from, to), g = depth_at(one, i, to, hi, -1.0);
            const double b0 = out->b[0][i], b1 = out->b[1][i], b2 = out->b[2][i], b3 = out->b[3][i], b4 = out->b[4][i];

            out->b[0][i] = here > 0.0 ? b0 + strength * e * e : b0;
            out->b[1][i] = here > 0.0 ? b1 + strength * e * f : b1;
            out->b[2][i] = here > 0.0 ? b2 + strength * (2.0 * f * f + e * g) / 3.0 : b2;
            out->b[3][i] = here > 0.0 ? b3 + strength * f * g : b3;
            out->b[4][i] = here > 0.0 ? b4 + strength * g * g : b4;
        }
    }
}

COMMON_SEPARATE static void judge(const lines *restrict n, places *restrict p, common_bernsteins *restrict io)
{
    for (uint32_t i = 0; i < N; i++) {
        const double b0 = io->b[0][i], b1 = io->b[1][i], b2 = io->b[2][i], b3 = io->b[3][i], b4 = io->b[4][i], from = p->from[i], to = p->to[i];
        const double least = common_lesser(common_lesser(common_lesser(b0, b1), common_lesser(b2, b3)), b4);
        const double most = common_greater(common_greater(common_greater(b0, b1), common_greater(b2, b3)), b4);
        const double may = to < HUGE_VAL ? least < 0.0 ? most >= 0.0 ? 1.0 : 0.0 : 0.0 : 0.0;

        p->may[i] = may;
        io->b[0][i] = may > 0.0 ? b0 : 1.0;
        io->b[1][i] = may > 0.0 ? b1 : 1.0;
        io->b[2][i] = may > 0.0 ? b2 : 1.0;
        io->b[3][i] = may > 0.0 ? b3 : 1.0;
        io->b[4][i] = may > 0.0 ? b4 : 1.0;
        io->noise[i] = 4.0 * 0x1p-53 * (4 + 1) * common_greater(-least, most);
        io->beyond[i] = may > 0.0 ? (n->enough[i] - from) / (to - from) : 0.0;
        io->within[i] = -HUGE_VAL;
    }
}

/* To the next intervals that may hold roots, with what may cross zero there. False: none does. */
static bool find_next(const common_blob *b, const all_stretches *s, const lines *n, places *p, common_bernsteins *out)
{
    lane going;

    do {
        const bool any = find_ends(b, s, p);

        if (any) {
            find_fields(b, s, p, out);
            judge(n, p, out);
        }
        for (uint32_t i = 0; i < N; i++) {
            p->may[i] = any ? p->may[i] : 0.0;
            going[i] = p->may[i] > 0.0 ? 0.0 : p->from[i] < HUGE_VAL ? 1.0 : 0.0;
            p->from[i] = going[i] > 0.0 ? p->to[i] : p->from[i];
        }
    } while (is_any(going));
    return is_any(p->may);
}

/* A root is the end of a lane, unless it lies before all that counts. */
COMMON_SEPARATE static void conclude(const lines *restrict n, const common_first_of_bernsteins *restrict at, places *restrict p)
{
    for (uint32_t i = 0; i < N; i++) {
        const double from = p->from[i], to = p->to[i], may = p->may[i], t = from + at->root[i] * (to - from), found = may > 0.0 ? at->found[i] : 0.0;
        const double start = n->own[i] > 0.0 ? fabs(t) < COMMON_BLOB_NEAR ? 1.0 : 0.0 : 0.0, before = t < n->least[i] ? 1.0 : start;
        const double open = may > 0.0 ? at->before[i] > 0.0 ? 1.0 - before : at->open[i] : 0.0, next = may > 0.0 ? to : from;

        p->root[i] = found > 0.0 ? t : p->root[i];
        p->open[i] = open > 0.0 ? 1.0 : p->open[i];
        p->from[i] = found + open > 0.0 ? HUGE_VAL : next;
    }
}

COMMON_SEPARATE static void tell(const lines *restrict n, const places *restrict p, common_first_crossings *restrict out)
{
    for (uint32_t i = 0; i < N; i++) {
        const double root = p->root[i];
        const pov_two t = pov_two_sum(n->base[i], root);

        out->known[i] = 1.0 - p->open[i];
        out->t[i] = root < HUGE_VAL ? t.hi : HUGE_VAL;
        out->t_lo[i] = t.lo;
        out->feature[i] = 0.0;
        out->u[i] = 0.0;
        out->v[i] = 0.0;
    }
}

void common_blob_first(const void *self, const common_entries *restrict l, common_first_crossings *restrict out)
{
    const common_blob *b = self;
    common_first_of_bernsteins at;
    common_bernsteins fields;
    all_stretches s;
    places p;
    lines n;

    find_lines(l, &n);
    if (!find_stretches(b, &n, &s)) {
        for (uint32_t i = 0; i < N; i++)
            out->known[i] = 0.0;
        return;
    }
    begin(&s, &p);
    while (find_next(b, &s, &n, &p, &fields)) {
        common_bernstein_first_many(&fields, 4, &at);
        conclude(&n, &at, &p);
    }
    tell(&n, &p, out);
}
