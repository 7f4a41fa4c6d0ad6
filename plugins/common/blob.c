#include "common/blob.h"

#include "common/bernstein.h"
#include "common/simd.h"

/* d^2 / r^2 = a t^2 + 2 b t + c between two distances; the field adds no more than `most` there. */
typedef struct stretch { double lo, hi, a, b, c, strength, most; uint32_t number; } stretch;

typedef struct line { pov_vec3 o, d, inverse; double base; common_span span; common_wanted wanted; const common_ray *k; } line;

size_t common_blob_scratch(const void *self)
{
    const common_blob *b = self;

    return b->count * 3 * (sizeof(stretch) + 2 * sizeof(double) + sizeof(uint32_t)) + 64;
}

/* The part of a stretch where it is below one. */
static uint32_t keep(stretch *s, common_span within)
{
    const double d = s->b * s->b - s->a * (s->c - 1.0);
    double middle, half, depth;

    if (!(s->a > 0.0 && d > 0.0 && within.lo < within.hi))
        return 0;
    middle = -s->b / s->a;
    half = sqrt(d) / s->a;
    s->lo = common_greater(within.lo, middle - half);
    s->hi = common_lesser(within.hi, middle + half);
    depth = d / s->a;
    s->most = common_greater(s->strength, 0.0) * depth * depth;
    return s->lo < s->hi;
}

static uint32_t find_sphere(const common_blob_part *c, const line *n, stretch *out)
{
    const pov_vec3 o = pov_sub(n->o, c->centre);

    out->a = pov_dot(n->d, n->d) * c->per_square;
    out->b = pov_dot(o, n->d) * c->per_square;
    out->c = pov_dot(o, o) * c->per_square;
    out->strength = c->strength;
    out->number = c->number;
    return keep(out, n->span);
}

static uint32_t find_stretches(const common_blob_part *c, const line *n, stretch *out)
{
    const pov_vec3 o = common_blob_mapped(c, n->o, 1.0), d = common_blob_mapped(c, n->d, 0.0);
    const stretch near_end = { 0.0, 0.0, pov_dot(d, d), pov_dot(o, d), pov_dot(o, o), c->strength, 0.0, c->number };
    stretch tube = { 0.0, 0.0, d.x * d.x + d.y * d.y, o.x * d.x + o.y * d.y, o.x * o.x + o.y * o.y, c->strength, 0.0, c->number }, far = near_end;
    const double first = -o.z / d.z, second = (c->length - o.z) / d.z;
    common_span start = n->span, middle = n->span, end = n->span;
    uint32_t count = 0;

    out[0] = near_end;
    if (c->length == 0.0 || (d.z == 0.0 && o.z <= 0.0))
        return keep(out, n->span);
    if (tube.a > 0.0 && !(tube.b * tube.b - tube.a * (tube.c - 1.0) > 0.0))
        return 0;                /* it passes the endless cylinder, which holds the ends */
    far.b -= c->length * d.z;
    far.c += c->length * (c->length - 2.0 * o.z);
    if (d.z == 0.0) {
        out[0] = o.z < c->length ? tube : far;
        return keep(out, n->span);
    }
    start.hi = common_lesser(start.hi, d.z > 0.0 ? first : second);
    middle.lo = common_greater(middle.lo, d.z > 0.0 ? first : second);
    middle.hi = common_lesser(middle.hi, d.z > 0.0 ? second : first);
    end.lo = common_greater(end.lo, d.z > 0.0 ? second : first);
    out[0] = d.z > 0.0 ? near_end : far;
    count += keep(&out[0], start);
    out[count] = tube;
    /* Along the axis the tube is as wide everywhere. */
    if (tube.a > 0.0) {
        count += keep(&out[count], middle);
    } else if (tube.c < 1.0 && middle.lo < middle.hi) {
        out[count].lo = middle.lo;
        out[count].most = common_greater(c->strength, 0.0);
        out[count++].hi = middle.hi;
    }
    out[count] = d.z > 0.0 ? far : near_end;
    return count + keep(&out[count], end);
}

/* As in the text: sums depend on the order. */
static void order(stretch *s, uint32_t n)
{
    for (uint32_t i = 1; i < n; i++) {
        const stretch x = s[i];
        uint32_t j = i;

        for (; j > 0 && s[j - 1].number > x.number; j--)
            s[j] = s[j - 1];
        s[j] = x;
    }
}

static void sort(double *a, uint32_t n)
{
    for (uint32_t i = 1; i < n; i++) {
        const double x = a[i];
        uint32_t j = i;

        for (; j > 0 && a[j - 1] > x; j--)
            a[j] = a[j - 1];
        a[j] = x;
    }
}

/* 1 - d^2 / r^2 at t, and mixed between two distances; at the rim zero. */
static double depth_at(const stretch *s, double t, double u)
{
    if (t == u && ((t == s->lo && s->a * t + s->b < 0.0) || (t == s->hi && s->a * t + s->b > 0.0))) {
        const double depth = 1.0 - ((s->a * t + 2.0 * s->b) * t + s->c);

        return fabs(depth) < 0x1p-30 ? 0.0 : depth;
    }
    return 1.0 - (s->a * t * u + s->b * (t + u) + s->c);
}

static void add_field(const stretch *s, double from, double to, double *b)
{
    const double e = depth_at(s, from, from), f = depth_at(s, from, to), g = depth_at(s, to, to);

    b[0] += s->strength * e * e;
    b[1] += s->strength * e * f;
    b[2] += s->strength * (2.0 * f * f + e * g) / 3.0;
    b[3] += s->strength * f * g;
    b[4] += s->strength * g * g;
}

static bool report(const line *n, double t, pov_hits *hits)
{
    const pov_two at = pov_two_sum(n->base, t);
    const pov_mark mark = { 0, 0, 0.0, 0.0 };

    return pov_cross(hits, at.hi * n->k->unit, at.lo * n->k->unit, mark) && !(hits->want == POV_WANT_NEAREST && at.hi * n->k->unit > hits->tmin);
}

/* False: nothing more is wanted. */
static bool cross_between(const common_blob *b, const line *n, const stretch *s, uint32_t count, double from, double to, bool from_here,
                          pov_hits *hits)
{
    double c[5] = { -b->threshold, -b->threshold, -b->threshold, -b->threshold, -b->threshold }, root[4], most = 0.0;
    uint32_t found;

    for (uint32_t i = 0; i < count; i++)
        if (s[i].lo <= from && s[i].hi >= to)
            most += s[i].most;
    if (common_blob_stays_below(b, most))
        return true;
    for (uint32_t i = 0; i < count; i++)
        if (s[i].lo <= from && s[i].hi >= to)
            add_field(&s[i], from, to, c);
    if ((c[0] < 0.0 && c[1] < 0.0 && c[2] < 0.0 && c[3] < 0.0 && c[4] < 0.0))
        return true;
    found = common_bernstein_first(c, 4, common_bernstein_noise(c, 4), (n->wanted.enough - from) / (to - from),
                                   (n->wanted.within - from) / (to - from), root);
    for (uint32_t i = 0; i < found; i++) {
        const double t = from + root[i] * (to - from);

        if (!(from_here && fabs(t) < COMMON_BLOB_NEAR) && !report(n, t, hits))
            return false;
    }
    return true;
}

void common_blob_cross(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits)
{
    const common_blob *b = self;
    const bool from_here = ray->origin_surface == hits->owner;
    stretch *s = hits->scratch;
    double *ends = (double *)(void *)(s + 3 * b->count);
    double most = 0.0;
    uint32_t count = 0;
    line n;

    n.k = &e->k;
    n.base = from_here ? 0.0 : e->span.lo;
    n.o = common_along(n.k, n.base);
    n.d = n.k->d;
    n.inverse = pov_vec3_of(1.0 / n.d.x, 1.0 / n.d.y, 1.0 / n.d.z);
    n.span.lo = from_here ? -COMMON_BLOB_NEAR : 0.0;
    n.span.hi = e->span.hi - n.base;
    n.wanted = common_wants(n.k, n.base, from_here ? COMMON_BLOB_NEAR : -HUGE_VAL, hits);
    for (uint32_t i = 0; (i = common_runs_hit(&b->runs, i, n.o, n.inverse, n.span.lo, n.span.hi)) < b->count; i++)
        count += b->at[i].per_square > 0.0 ? find_sphere(&b->at[i], &n, s + count) : find_stretches(&b->at[i], &n, s + count);
    for (uint32_t i = 0; i < count; i++)
        most += s[i].most;
    if (common_blob_stays_below(b, most))
        return;
    if (b->by_number)
        order(s, count);
    for (uint32_t i = 0; i < count; i++) {
        ends[2 * i] = s[i].lo;
        ends[2 * i + 1] = s[i].hi;
    }
    sort(ends, 2 * count);
    for (uint32_t i = 0; i + 1 < 2 * count && ends[i] <= n.wanted.far; i++)
        if (ends[i] < ends[i + 1] && !cross_between(b, &n, s, count, ends[i], ends[i + 1], from_here, hits))
            return;
}
