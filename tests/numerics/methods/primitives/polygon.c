#include "numerics/methods/number.h"

#include "numerics/methods/lanes.h"

typedef struct corner { pov_vec3 at; bool starts; } corner;   /* starts: no edge leads to it */

typedef struct polygon {
    corner *corners;
    uint32_t count;
    num3 normal;
} polygon;

static bool same(pov_vec3 a, pov_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/* Every loop is closed by its first corner, or by us. The plane's normal: of the largest triangle with the first corner
 * and the one farthest from it. */
static void parse(void *self, const pov_host *host, pov_reader *in)
{
    polygon *s = self;
    const uint32_t n = (uint32_t)host->number(in);
    uint32_t start = 0, i, far = 0;
    bool open = false;
    double most = 0.0;

    s->corners = host->alloc(in, (n + 1) * sizeof *s->corners);
    for (i = 0; s->corners && i < n; i++) {
        corner *c = &s->corners[s->count++];

        host->accept(in, ",");
        host->vector(in, &c->at);
        c->starts = !open;
        if (!open)
            start = i;
        open = c->starts || !same(c->at, s->corners[start].at);
    }
    if (open && s->corners)
        s->corners[s->count++].at = s->corners[start].at;
    for (i = 0; i < s->count; i++) {
        const pov_vec3 v = pov_sub(s->corners[i].at, s->corners[0].at), w = pov_sub(s->corners[far].at, s->corners[0].at);
        far = pov_dot(v, v) > pov_dot(w, w) ? i : far;
    }
    for (i = 0; i < s->count; i++) {
        const num3 first = num3_planar(s->corners[0].at);
        const num3 cross = num3_cross(num3_sub(num3_planar(s->corners[far].at), first),
                                      num3_sub(num3_planar(s->corners[i].at), first));
        const double size = pov_largest(num3_double(cross));

        if (size > most) {
            most = size;
            s->normal = cross;
        }
    }
}

static bool bounds(const void *self, pov_box *out)
{
    const polygon *s = self;
    const double largest = 1e-14 * pov_largest(s->corners[0].at);
    uint32_t i;

    out->lo = out->hi = s->corners[0].at;
    for (i = 0; i < s->count; i++) {
        const pov_vec3 v = s->corners[i].at;

        out->lo = pov_vec3_of(fmin(out->lo.x, v.x), fmin(out->lo.y, v.y), fmin(out->lo.z, v.z));
        out->hi = pov_vec3_of(fmax(out->hi.x, v.x), fmax(out->hi.y, v.y), fmax(out->hi.z, v.z));
    }
    out->lo = pov_sub(out->lo, pov_vec3_of(largest, largest, largest));
    out->hi = pov_add(out->hi, pov_vec3_of(largest, largest, largest));
    return true;
}

static num component(num3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/* Even-odd in the plane of the two axes that the normal points along least. */
static bool is_within(const polygon *s, num3 p)
{
    const pov_vec3 n = num3_double(s->normal);
    const int forward = fabs(n.x) > fabs(n.y) ? (fabs(n.x) > fabs(n.z) ? 0 : 2) : fabs(n.y) > fabs(n.z) ? 1 : 2;
    const int u = (forward + 1) % 3, v = (forward + 2) % 3;
    const num3 origin = num3_planar(s->corners[0].at);
    const num pu = component(p, u), pv = component(p, v);
    bool within = false;
    uint32_t i;

    for (i = 1; i < s->count; i++) {
        const num3 a = num3_sub(num3_planar(s->corners[i - 1].at), origin),
            b = num3_sub(num3_planar(s->corners[i].at), origin);
        const num au = component(a, u), av = component(a, v), bu = component(b, u), bv = component(b, v);

        if (s->corners[i].starts || num_less(pv, av) == num_less(pv, bv))
            continue;
        if (num_less(pu, num_add(au, num_div(num_mul(num_sub(pv, av), num_sub(bu, au)), num_sub(bv, av)))))
            within = !within;
    }
    return within;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const polygon *s = self;
    line l;
    num slope, t;

    if (s->count == 0)
        return;
    l = line_from(ray, num3_planar(s->corners[0].at));
    slope = num3_dot(s->normal, l.dir);
    if (num_double(slope) == 0.0)
        return;
    t = num_neg(num_div(num3_dot(s->normal, l.from), slope));
    if (is_within(s, line_at(&l, t)))
        report(hits, ray, &l, t, 0);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)ray;
    (void)at;
    *out = pov_unit(num3_double(((const polygon *)self)->normal));
}

METHODS_LANES(bounds)

static const pov_shape_fast polygon_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(lane_boxes),
    .block_pack = block_pack,
    .block_filter = block_filter,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &polygon_fast : NULL; }

static const pov_shape_class polygon_class = {
    .size = sizeof(pov_shape_class),
    .keyword = "polygon",
    .instance_size = sizeof(polygon),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .extension = extension,
};

METHODS_PLUGIN(polygon, polygon_class);
