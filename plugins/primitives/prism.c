/* prism { [linear_sweep | conic_sweep] [spline] low, high, n, <x, z>, ... [open] [sturm] }: a curve in the plane of x and z,
 * moved along y, or towards the origin as a cone. Rings within rings are holes. */
#include "common/curve.h"
#include "common/swept.h"

#include <string.h>

#include <stddef.h>

typedef struct prism {
    common_swept swept;
    common_boxed boxed;
} prism;

/* ---- reading ---- */

typedef struct reading {
    const pov_host *host;
    pov_reader *in;
    common_outline *outline;
    double (*at)[2];
    uint32_t count;
} reading;

static bool same(const double a[2], const double b[2]) { return a[0] == b[0] && a[1] == b[1]; }

static common_piece piece_at(const reading *r, common_spline kind, uint32_t i)
{
    return common_spline_piece(kind, (const double (*)[2])r->at + i);
}

static bool add(const reading *r, const common_piece *c) { return common_outline_add(r->outline, r->host, r->in, c); }

/* A ring ends where its first point comes again. Without that nothing is seen, as in POV-Ray. */
static void add_beziers(const reading *r)
{
    uint32_t first = 0;

    if (r->count % 4 != 0)
        r->host->fail(r->in, "a prism of bezier splines needs four points a piece");
    for (uint32_t i = 0; i + 3 < r->count; i += 4) {
        const common_piece c = piece_at(r, COMMON_BEZIER, i);

        if (!add(r, &c))
            return;
        if (same(r->at[i + 3], r->at[first]))
            first = i + 4;
    }
    if (first < r->count) {
        r->host->warn(r->in, "a ring of this prism is not closed: it is not seen");
        r->outline->count = 0;
    }
}

/* One ring whose first point is at `first`: it ends where that point comes again. Returns the point behind its end. */
static uint32_t add_ring(const reading *r, common_spline kind, uint32_t first, uint32_t end)
{
    uint32_t i = first;

    while (i + 1 < end) {
        const common_piece c = piece_at(r, kind, i++);

        if (!add(r, &c) || same(r->at[i], r->at[first]))
            return i + 1;
    }
    if (kind == COMMON_LINEAR)
        r->host->warn(r->in, "a ring of this prism is not closed: it is closed by a straight line");
    else
        r->host->fail(r->in, "a ring of this prism is not closed");
    if (i > first) {
        const common_piece c = { 1, { r->at[i][0], r->at[first][0] }, { r->at[i][1], r->at[first][1] } };

        add(r, &c);
    }
    return i + 1;
}

/* The first point of a ring only steers, unless it is linear; so does the last one of a cubic. */
static void add_rings(const reading *r, common_spline kind)
{
    const uint32_t before = kind == COMMON_LINEAR ? 0 : 1, behind = kind == COMMON_CUBIC ? 1 : 0;
    const uint32_t least = kind == COMMON_LINEAR ? 3 : kind == COMMON_QUADRATIC ? 5 : 6;

    if (r->count < least)
        r->host->fail(r->in, "a prism of this spline needs at least %u points", (unsigned)least);
    for (uint32_t i = before; i + 1 + behind < r->count; i += before + behind)
        i = add_ring(r, kind, i, r->count - behind);
}

static double reach_of(const prism *p)
{
    const common_outline *o = &p->swept.outline;

    return pov_max(pov_max(o->hi[0] - o->lo[0], o->hi[1] - o->lo[1]), p->swept.hi.hi - p->swept.lo.hi);
}

/* The cone's apex is at the origin, so that stays where it is. */
static void place(prism *p)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    common_outline *o = &p->swept.outline;
    double middle[2] = { 0.0, 0.0 };
    pov_vec3 anchor = zero;

    common_outline_bound(o);
    if (!p->swept.conic) {
        middle[0] = anchor.x = 0.5 * (o->lo[0] + o->hi[0]);
        anchor.y = 0.5 * (p->swept.lo.hi + p->swept.hi.hi);
        middle[1] = anchor.z = 0.5 * (o->lo[1] + o->hi[1]);
        p->boxed.scale = pov_inverse_power(reach_of(p));
        common_outline_place(o, middle, p->boxed.scale);
    } else {
        p->boxed.scale = pov_inverse_power(pov_max(fabs(p->swept.lo.hi), fabs(p->swept.hi.hi)));
    }
    p->boxed.anchor = pov_two3_of(anchor, zero);
    p->swept.lo = pov_two_scale(pov_two_sum(p->swept.lo.hi, -anchor.y), p->boxed.scale);
    p->swept.hi = pov_two_scale(pov_two_sum(p->swept.hi.hi, -anchor.y), p->boxed.scale);
}

static void read_heights(prism *p, const pov_host *host, pov_reader *in)
{
    const double a = host->number(in), b = (host->accept(in, ","), host->number(in));

    p->swept.lo = pov_two_of(pov_min(a, b), 0.0);
    p->swept.hi = pov_two_of(pov_max(a, b), 0.0);
}

static void read_flags(prism *p, const pov_host *host, pov_reader *in)
{
    bool read = true;

    while (read) {
        read = common_sturm_read(host, in);
        if (host->accept(in, "open"))
            read = p->swept.open = true;
    }
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    prism *p = self;
    reading r = { host, in, &p->swept.outline, NULL, 0 };
    common_spline kind = COMMON_LINEAR;
    bool read = true;

    p->swept.axis = 1;
    p->swept.upward = true;
    while (read) {
        read = common_spline_read(host, in, &kind) || host->accept(in, "linear_sweep");
        if (host->accept(in, "conic_sweep"))
            read = p->swept.conic = true;
    }
    p->swept.turned = kind == COMMON_BEZIER;
    read_heights(p, host, in);
    host->accept(in, ",");
    r.at = common_points_read(host, in, &r.count);
    if (!r.at)
        return;
    if (kind == COMMON_BEZIER)
        add_beziers(&r);
    else
        add_rings(&r, kind);
    common_outline_cancel(&p->swept.outline, host, in);
    read_flags(p, host, in);
    if (p->swept.outline.count > 0) {
        place(p);
        common_swept_close(&p->swept);
        p->boxed.lo = p->swept.least;
        p->boxed.hi = p->swept.most;
        common_outline_pack(&p->swept.outline, host, in);
    }
}

/* ---- the surface ---- */

static bool bounds(const void *self, pov_box *out)
{
    const prism *p = self;
    const double back = common_inverse(p->boxed.scale);
    pov_vec3 lo, hi;

    memset(out, 0, sizeof *out);
    if (p->swept.outline.count == 0)
        return true;
    common_swept_bounds(&p->swept, &lo, &hi);
    lo = pov_add(pov_scale(lo, back), pov_two3_hi(p->boxed.anchor));
    hi = pov_add(pov_scale(hi, back), pov_two3_hi(p->boxed.anchor));
    out->lo = pov_vec3_of(common_below(lo.x), common_below(lo.y), common_below(lo.z));
    out->hi = pov_vec3_of(common_above(hi.x), common_above(hi.y), common_above(hi.z));
    return true;
}

static size_t scratch(const void *self) { return 3 * ((const prism *)self)->swept.outline.count * sizeof(common_cross); }

static void cross(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits)
{
    common_swept_cross(&((const prism *)self)->swept, ray, e, hits->scratch, hits);
}

static void first(const void *self, const common_entries *restrict l, common_first_crossings *restrict out)
{
    common_swept_first(&((const prism *)self)->swept, l, out);
}

static uint32_t narrow(const void *self, const pov_own_map *map, uint32_t owner, const pov_rays *rays, pov_candidate *io, uint32_t n)
{
    const prism *p = self;

    return !common_swept_may_look(&p->swept) ? n : common_narrow(&p->boxed, common_swept_look, &p->swept, map, owner, rays, io, n);
}

COMMON_NARROW_CLASS(prism, cross, first, true, narrow)

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const prism *p = self;

    return common_swept_inside(&p->swept, common_offset(point, point_lo, p->boxed.anchor, p->boxed.scale));
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    common_swept_normal(&((const prism *)self)->swept, ray->dir, &at->mark, out);
}

static bool reversed(const void *self, const pov_ray *ray, const pov_crossing *at)
{
    return common_swept_reversed(&((const prism *)self)->swept, ray->dir, &at->mark);
}

static bool open(const void *self) { return ((const prism *)self)->swept.open; }

static const pov_shape_class prism_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "prism",
    .instance_size = sizeof(prism),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .scratch = scratch,
    .extension = extension,
    .open = open,
    .reversed = reversed,
};

static const pov_shape_class *const shapes[] = { &prism_class, NULL };

POV_PLUGIN(prism) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "prism",
    .version = "1",
    .shapes = shapes,
};
