/* blob { [threshold t] sphere { <centre>, radius, strength } cylinder { <end>, <end>, radius, strength } ... }: where the sum
 * of strength (1 - d^2 / r^2)^2 over the components within whose radius a point is reaches the threshold.
 *
 * Along a ray d^2 is a quadratic over each stretch within a component, a cylinder with its round ends being three of them.
 * Between the ends of all stretches the field is a quartic. Its Bernstein coefficients are sums of products of those of
 * the quadratics, so neighbours have the same value where they touch. */
#include "common/bernstein.h"
#include "common/boxed.h"
#include "common/cell_box.h"
#include "common/runs.h"
#include "common/simd.h"

/* A component in a space where it is the unit sphere, or what is nearer than one to the line from 0 to z = length. */
typedef struct component {
    double m[3][4];              /* from the blob's space, scaled */
    pov_vec3 centre;             /* of a sphere that nothing has moved, scaled, and 1 / radius^2; or 0 */
    double per_square;
    double length, strength;
    pov_vec3 lo, hi;             /* its box, scaled */
    uint32_t texture;
} component;

typedef struct blob {
    uint32_t count, capacity;
    component *at;
    double threshold;
    bool textured, written;      /* any component, be its radius 0 */
    common_boxed boxed;
    common_runs runs;
    pov_box box;                 /* around all that is inside, scaled */
} blob;

static const double NEAR = 0x1p-30;

/* ---- loading ---- */

/* As written: a transformation, and a capsule before it. */
typedef struct written { pov_vec3 from, to; double radius; pov_affine map; bool moved; } written;

static pov_vec3 perpendicular(pov_vec3 a)
{
    const pov_vec3 x = { 1.0, 0.0, 0.0 }, y = { 0.0, 1.0, 0.0 };

    return pov_unit(pov_cross_product(a, fabs(a.x) < fabs(a.y) ? x : y));
}

static void put_row(double row[4], pov_vec3 axis, pov_vec3 from, double radius)
{
    row[0] = axis.x / radius;
    row[1] = axis.y / radius;
    row[2] = axis.z / radius;
    row[3] = -pov_dot(axis, from) / radius;
}

/* The map to the component's own space: first back through its transformation. */
static void find_map(component *c, const written *w)
{
    const pov_vec3 along = pov_sub(w->to, w->from), z = { 0.0, 0.0, 1.0 };
    const pov_vec3 axis = pov_largest(along) > 0.0 ? pov_unit(along) : z, side = perpendicular(axis);
    double m[3][4];

    c->length = sqrt(pov_dot(along, along)) / w->radius;
    put_row(m[0], side, w->from, w->radius);
    put_row(m[1], pov_cross_product(axis, side), w->from, w->radius);
    put_row(m[2], axis, w->from, w->radius);
    memcpy(c->m, m, sizeof m);
    for (int i = 0; i < 3 && w->moved; i++)
        for (int j = 0; j < 4; j++)
            c->m[i][j] = m[i][0] * w->map.inv[0][j] + m[i][1] * w->map.inv[1][j] + m[i][2] * w->map.inv[2][j] + (j == 3 ? m[i][3] : 0.0);
}

/* Both ends are spheres, which a map makes ellipsoids. */
static void find_box(component *c, const written *w)
{
    pov_vec3 a = w->from, b = w->to, reach = { w->radius, w->radius, w->radius };
    double r[3];

    if (w->moved) {
        a = pov_affine_point(&w->map, a);
        b = pov_affine_point(&w->map, b);
        for (int i = 0; i < 3; i++)
            r[i] = w->radius * sqrt(w->map.m[i][0] * w->map.m[i][0] + w->map.m[i][1] * w->map.m[i][1] + w->map.m[i][2] * w->map.m[i][2]);
        reach = pov_vec3_of(r[0], r[1], r[2]);
    }
    reach = pov_scale(reach, 1.0 + 0x1p-40);
    c->lo = pov_sub(pov_vec3_of(fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z)), reach);
    c->hi = pov_add(pov_vec3_of(fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z)), reach);
}

static component *append(blob *b, const pov_host *host, pov_reader *in)
{
    if (b->count == b->capacity) {
        component *bigger = host->alloc(in, (2 * b->capacity + 8) * sizeof *bigger);

        if (!bigger)
            return NULL;
        if (b->count > 0)
            memcpy(bigger, b->at, b->count * sizeof *bigger);
        b->at = bigger;
        b->capacity = 2 * b->capacity + 8;
    }
    return &b->at[b->count++];
}

static void add(blob *b, const pov_host *host, pov_reader *in, const written *w, double strength, uint32_t texture)
{
    component *c = w->radius > 0.0 ? append(b, host, in) : NULL;

    b->written = true;
    if (!c)
        return;
    c->strength = strength;
    c->texture = texture;
    b->textured |= texture != POV_OWN_TEXTURE;
    c->centre = w->from;
    c->per_square = w->moved || pov_largest(pov_sub(w->to, w->from)) > 0.0 ? 0.0 : 1.0 / (w->radius * w->radius);
    find_map(c, w);
    find_box(c, w);
}

static void read_component(blob *b, const pov_host *host, pov_reader *in, bool is_cylinder)
{
    uint32_t texture = POV_OWN_TEXTURE;
    double strength;
    bool read;
    written w;

    memset(&w, 0, sizeof w);
    host->expect(in, "{");
    host->vector(in, &w.from);
    host->accept(in, ",");
    w.to = w.from;
    if (is_cylinder) {
        host->vector(in, &w.to);
        if (!(pov_largest(pov_sub(w.to, w.from)) > 0.0))
            host->fail(in, "a cylinder of a blob needs two different ends");
        host->accept(in, ",");
    }
    w.radius = fabs(host->number(in));
    host->accept(in, ",");
    host->accept(in, "strength");
    strength = host->number(in);
    do {
        read = host->component_texture && host->component_texture(in, &texture);
        if (host->transform && host->transform(in, &w.map))
            read = w.moved = true;
    } while (read);
    host->expect(in, "}");
    add(b, host, in, &w, strength, texture);
}

/* The form of old: `component strength, radius, <centre>`. */
static void read_old(blob *b, const pov_host *host, pov_reader *in)
{
    written w;
    double strength;

    memset(&w, 0, sizeof w);
    strength = host->number(in);
    host->accept(in, ",");
    w.radius = fabs(host->number(in));
    host->accept(in, ",");
    host->vector(in, &w.from);
    w.to = w.from;
    add(b, host, in, &w, strength, POV_OWN_TEXTURE);
}

static bool read_item(blob *b, const pov_host *host, pov_reader *in)
{
    if (host->accept(in, "threshold"))
        b->threshold = host->number(in);
    else if (host->accept(in, "sphere"))
        read_component(b, host, in, false);
    else if (host->accept(in, "cylinder"))
        read_component(b, host, in, true);
    else if (host->accept(in, "component"))
        read_old(b, host, in);
    else if (host->accept(in, "hierarchy") || host->accept(in, "sturm"))
        return !host->more(in) || (host->boolean(in), true);
    else
        return false;
    return true;
}

/* About the middle of all boxes, scaled to the order of one. */
static void place(blob *b)
{
    pov_vec3 lo = b->at[0].lo, hi = b->at[0].hi, middle;
    double back;

    for (uint32_t i = 1; i < b->count; i++) {
        const component *c = &b->at[i];

        lo = pov_vec3_of(fmin(lo.x, c->lo.x), fmin(lo.y, c->lo.y), fmin(lo.z, c->lo.z));
        hi = pov_vec3_of(fmax(hi.x, c->hi.x), fmax(hi.y, c->hi.y), fmax(hi.z, c->hi.z));
    }
    middle = pov_scale(pov_add(lo, hi), 0.5);
    b->boxed.anchor = pov_two3_of(middle, pov_vec3_of(0.0, 0.0, 0.0));
    b->boxed.scale = pov_inverse_power(pov_largest(pov_sub(hi, lo)));
    back = common_inverse(b->boxed.scale);
    b->boxed.lo = pov_scale(pov_sub(lo, middle), b->boxed.scale);
    b->boxed.hi = pov_scale(pov_sub(hi, middle), b->boxed.scale);
    for (uint32_t i = 0; i < b->count; i++) {
        component *c = &b->at[i];

        c->lo = pov_scale(pov_sub(c->lo, middle), b->boxed.scale);
        c->hi = pov_scale(pov_sub(c->hi, middle), b->boxed.scale);
        c->centre = pov_scale(pov_sub(c->centre, middle), b->boxed.scale);
        c->per_square *= back * back;
        for (int j = 0; j < 3; j++) {
            c->m[j][3] += c->m[j][0] * middle.x + c->m[j][1] * middle.y + c->m[j][2] * middle.z;
            for (int k = 0; k < 3; k++)
                c->m[j][k] *= back;
        }
        if (b->runs.box)
            common_runs_add(&b->runs, i, c->lo, c->hi);
    }
}

static pov_vec3 mapped(const component *c, pov_vec3 p, double one)
{
    return pov_vec3_of(c->m[0][0] * p.x + c->m[0][1] * p.y + c->m[0][2] * p.z + c->m[0][3] * one,
                       c->m[1][0] * p.x + c->m[1][1] * p.y + c->m[1][2] * p.z + c->m[1][3] * one,
                       c->m[2][0] * p.x + c->m[2][1] * p.y + c->m[2][2] * p.z + c->m[2][3] * one);
}

/* How near the cell comes to the component, in its own space. */
static double nearest_of(const component *c, const pov_box *cell)
{
    const pov_vec3 half = pov_scale(pov_sub(cell->hi, cell->lo), 0.5);
    pov_vec3 q = mapped(c, pov_add(cell->lo, half), 1.0);
    double reach = 0.0;

    q.z -= common_lesser(common_greater(q.z, 0.0), c->length);
    for (int i = 0; i < 3; i++) {
        const double by = fabs(c->m[i][0]) * half.x + fabs(c->m[i][1]) * half.y + fabs(c->m[i][2]) * half.z;

        reach += by * by;
    }
    return common_greater(sqrt(pov_dot(q, q)) - sqrt(reach), 0.0);
}

/* Far more than roundings. */
static bool stays_below(const blob *b, double most) { return most <= b->threshold * (1.0 - 0x1p-30) && b->threshold > 0.0; }

static bool may_hold(const void *self, const pov_box *cell)
{
    const blob *b = self;
    double most = 0.0;

    for (uint32_t i = 0; i < b->count; i++) {
        const double near = nearest_of(&b->at[i], cell), depth = 1.0 - near * near;

        most += near < 1.0 ? common_greater(b->at[i].strength, 0.0) * depth * depth : 0.0;
    }
    return !stays_below(b, most);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    enum { FEW = 64 };           /* where there are more components, to look for the box would take too long */
    blob *b = self;
    pov_box whole;

    b->threshold = 1.0;
    while (read_item(b, host, in))
        continue;
    if (b->count == 0 && b->written)
        add(b, host, in, &(written){ .radius = 1.0 }, 0.0, POV_OWN_TEXTURE);
    if (b->count == 0) {
        host->fail(in, "a blob needs at least one component");
        return;
    }
    b->runs.count = b->count;
    b->runs.box = b->count > 2 * COMMON_RUN ? host->alloc(in, (b->count / COMMON_RUN + 1) * sizeof *b->runs.box) : NULL;
    place(b);
    whole = (pov_box){ b->boxed.lo, b->boxed.hi };
    if (b->count > FEW || !common_cell_box(b, &whole, may_hold, &b->box))
        b->box = whole;
}

static bool bounds(const void *self, pov_box *out)
{
    const blob *b = self;
    const pov_vec3 middle = pov_two3_hi(b->boxed.anchor), lo = pov_add(pov_scale(b->box.lo, 1.0 / b->boxed.scale), middle);
    const pov_vec3 hi = pov_add(pov_scale(b->box.hi, 1.0 / b->boxed.scale), middle);

    out->lo = pov_vec3_of(common_below(lo.x), common_below(lo.y), common_below(lo.z));
    out->hi = pov_vec3_of(common_above(hi.x), common_above(hi.y), common_above(hi.z));
    return true;
}

/* ---- along a ray ---- */

/* d^2 / r^2 = a t^2 + 2 b t + c between two distances; the field adds no more than `most` there. */
typedef struct stretch { double lo, hi, a, b, c, strength, most; } stretch;

typedef struct line { pov_vec3 o, d, inverse; double base; common_span span; common_wanted wanted; const common_ray *k; } line;

static size_t scratch(const void *self)
{
    const blob *b = self;

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

static uint32_t find_sphere(const component *c, const line *n, stretch *out)
{
    const pov_vec3 o = pov_sub(n->o, c->centre);

    out->a = pov_dot(n->d, n->d) * c->per_square;
    out->b = pov_dot(o, n->d) * c->per_square;
    out->c = pov_dot(o, o) * c->per_square;
    out->strength = c->strength;
    return keep(out, n->span);
}

static uint32_t find_stretches(const component *c, const line *n, stretch *out)
{
    const pov_vec3 o = mapped(c, n->o, 1.0), d = mapped(c, n->d, 0.0);
    const stretch near_end = { 0.0, 0.0, pov_dot(d, d), pov_dot(o, d), pov_dot(o, o), c->strength, 0.0 };
    stretch tube = { 0.0, 0.0, d.x * d.x + d.y * d.y, o.x * d.x + o.y * d.y, o.x * o.x + o.y * o.y, c->strength, 0.0 }, far = near_end;
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
static bool cross_between(const blob *b, const line *n, const stretch *s, uint32_t count, double from, double to, bool from_here,
                          pov_hits *hits)
{
    double c[5] = { -b->threshold, -b->threshold, -b->threshold, -b->threshold, -b->threshold }, root[4], most = 0.0;
    uint32_t found;

    for (uint32_t i = 0; i < count; i++)
        if (s[i].lo <= from && s[i].hi >= to)
            most += s[i].most;
    if (stays_below(b, most))
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

        if (!(from_here && fabs(t) < NEAR) && !report(n, t, hits))
            return false;
    }
    return true;
}

static void cross(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits)
{
    const blob *b = self;
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
    n.span.lo = from_here ? -NEAR : 0.0;
    n.span.hi = e->span.hi - n.base;
    n.wanted = common_wants(n.k, n.base, from_here ? NEAR : -HUGE_VAL, hits);
    for (uint32_t i = 0; (i = common_runs_hit(&b->runs, i, n.o, n.inverse, n.span.lo, n.span.hi)) < b->count; i++)
        count += b->at[i].per_square > 0.0 ? find_sphere(&b->at[i], &n, s + count) : find_stretches(&b->at[i], &n, s + count);
    for (uint32_t i = 0; i < count; i++)
        most += s[i].most;
    if (stays_below(b, most))
        return;
    for (uint32_t i = 0; i < count; i++) {
        ends[2 * i] = s[i].lo;
        ends[2 * i + 1] = s[i].hi;
    }
    sort(ends, 2 * count);
    for (uint32_t i = 0; i + 1 < 2 * count && ends[i] <= n.wanted.far; i++)
        if (ends[i] < ends[i + 1] && !cross_between(b, &n, s, count, ends[i], ends[i + 1], from_here, hits))
            return;
}

COMMON_BOXED_CLASS(blob, cross)

/* ---- points ---- */

/* A component's part of the field, and its slope in the blob's space. */
static double field_of(const component *c, pov_vec3 p, pov_vec3 *slope)
{
    pov_vec3 q = mapped(c, p, 1.0);
    double depth, factor;

    q.z -= common_lesser(common_greater(q.z, 0.0), c->length);
    depth = 1.0 - pov_dot(q, q);
    if (!(depth > 0.0)) {
        *slope = pov_vec3_of(0.0, 0.0, 0.0);
        return 0.0;
    }
    factor = -4.0 * c->strength * depth;
    slope->x = factor * (c->m[0][0] * q.x + c->m[1][0] * q.y + c->m[2][0] * q.z);
    slope->y = factor * (c->m[0][1] * q.x + c->m[1][1] * q.y + c->m[2][1] * q.z);
    slope->z = factor * (c->m[0][2] * q.x + c->m[1][2] * q.y + c->m[2][2] * q.z);
    return c->strength * depth * depth;
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const blob *b = self;
    const pov_vec3 p = pov_two3_hi(common_offset(point, point_lo, b->boxed.anchor, b->boxed.scale));
    double sum = 0.0;
    pov_vec3 slope;

    for (uint32_t i = 0; (i = common_runs_near(&b->runs, i, p)) < b->count; i++)
        sum += field_of(&b->at[i], p, &slope);
    return sum > b->threshold;
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const blob *b = self;
    const common_ray k = common_enter(ray, b->boxed.anchor, b->boxed.scale);
    const pov_vec3 p = pov_two3_hi(common_point(&k, at));
    pov_vec3 sum = { 0.0, 0.0, 0.0 }, slope;

    for (uint32_t i = 0; (i = common_runs_near(&b->runs, i, p)) < b->count; i++) {
        field_of(&b->at[i], p, &slope);
        sum = pov_sub(sum, slope);
    }
    *out = pov_unit(sum);
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

/* Shares of the field so far, in falling order; the least gives way to a larger one. */
typedef struct shares { uint32_t *which; double *share; uint32_t count; } shares;

static void add_share(shares *s, uint32_t texture, double field)
{
    uint32_t i = 0;

    while (i < s->count && s->which[i] != texture)
        i++;
    if (i == POV_TEXTURES_MAX && s->share[--i] >= field)
        return;
    if (i < s->count && s->which[i] == texture)
        field += s->share[i];
    else if (i == s->count)
        s->count++;
    for (; i > 0 && s->share[i - 1] < field; i--) {
        s->share[i] = s->share[i - 1];
        s->which[i] = s->which[i - 1];
    }
    s->share[i] = field;
    s->which[i] = texture;
}

/* By the shares of the components in the field, whatever its sign; those without a texture have the blob's. */
static uint32_t textures(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark, uint32_t *which,
                         double *share)
{
    const blob *b = self;
    const pov_vec3 p = pov_two3_hi(common_offset(point, point_lo, b->boxed.anchor, b->boxed.scale));
    shares all = { which, share, 0 };
    double sum = 0.0;
    pov_vec3 slope;

    (void)mark;
    for (uint32_t i = 0; b->textured && (i = common_runs_near(&b->runs, i, p)) < b->count; i++) {
        const double field = fabs(field_of(&b->at[i], p, &slope));

        if (field > 0.0)
            add_share(&all, b->at[i].texture, field);
    }
    for (uint32_t i = 0; i < all.count; i++)
        sum += share[i];
    for (uint32_t i = 0; i < all.count; i++)
        share[i] /= sum;
    return all.count;
}

static const pov_shape_class blob_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "blob",
    .instance_size = sizeof(blob),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .scratch = scratch,
    .extension = extension,
    .textures = textures,
};

static const pov_shape_class *const shapes[] = { &blob_class, NULL };

POV_PLUGIN(blob) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "blob",
    .version = "1",
    .shapes = shapes,
};
