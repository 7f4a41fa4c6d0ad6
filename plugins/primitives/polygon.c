/* polygon { n, <v1>, ..., <vn> }: a planar figure under the even-odd rule. Repeating the first point of a loop closes
 * it, and the next point starts another loop.
 *
 * The side of an edge on which a ray passes depends on the ray and the edge only, and is decided exactly where doubles
 * leave it open. So polygons that share an edge leave no gap and no overlap along it. */
#include "common/edges.h"
#include "common/planar_block.h"
#include "common/polygon.h"

static bool same(pov_vec3 a, pov_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/* The parsed form of a small polygon are its corners; a larger one is made at once, and stays. */
enum { FEW = COMMON_POLYGON_SIDES + 1 };
typedef struct polygon_parsed {
    const common_polygon *large;   /* NULL: the polygon is small */
    uint32_t count;
    pov_vec3 corner[FEW];
} polygon_parsed;

/* ---- reading ---- */

typedef struct reading {
    const pov_host *host;
    pov_reader *in;
    common_corner few[FEW];
    common_corner *corners;     /* this array, or the host's memory */
    uint32_t likely;            /* memory for more, but not more than is plausible: a scene may give any number */
    uint32_t count, capacity, start;   /* start: begin of the current loop */
    bool open;                  /* a loop is open */
} reading;

static bool append(reading *r, pov_vec3 v, bool starts)
{
    if (r->count == r->capacity) {
        const uint32_t twice_area = 2 * r->capacity, capacity = twice_area > r->likely ? twice_area : r->likely;
        common_corner *bigger = r->host->alloc(r->in, capacity * sizeof *bigger);

        if (!bigger)
            return false;
        memcpy(bigger, r->corners, r->count * sizeof *bigger);
        r->corners = bigger;
        r->capacity = capacity;
    }
    r->corners[r->count].world = v;
    r->corners[r->count++].starts = starts;
    return true;
}

static bool close_loop(reading *r)
{
    if (r->count - r->start < 3) {
        r->host->fail(r->in, "a loop of a polygon needs at least 3 points");
        return false;
    }
    r->open = false;
    return true;
}

static bool take(reading *r, pov_vec3 v)
{
    if (!r->open) {
        r->start = r->count;
        r->open = true;
        return append(r, v, true);
    }
    if (!same(v, r->corners[r->start].world))
        return append(r, v, false);
    return close_loop(r) && append(r, v, false);
}

static bool read_corners(reading *r)
{
    const double n = r->host->number(r->in);
    uint32_t i;
    pov_vec3 v;

    if (!(n >= 3.0 && n <= 1e9 && n == floor(n))) {
        r->host->fail(r->in, "a polygon needs a whole number of at least 3 points");
        return false;
    }
    r->likely = n < 64.0 ? (uint32_t)n + 1 : 64;
    for (i = 0; i < (uint32_t)n; i++) {
        r->host->accept(r->in, ",");
        if (!r->host->more(r->in)) {
            r->host->vector(r->in, &v);
            r->host->fail(r->in, "a polygon has fewer points than it says");
            return false;
        }
        r->host->vector(r->in, &v);
        if (!take(r, v))
            return false;
    }
    if (r->open) {
        r->host->warn(r->in, "a polygon's last loop is not closed; its first point is added");
        v = r->corners[r->start].world;
        return close_loop(r) && append(r, v, false);
    }
    return true;
}

/* ---- the plane ---- */

static pov_two3 offset_of(const common_polygon *s, const common_corner *c)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };

    return common_offset(c->world, zero, s->anchor, s->scale);
}

/* The plane goes through the first corner, the corner farthest from it, and the corner farthest from the line of these
 * two. (The area vector would not do: that of a bow tie is zero.) Returns the length of their cross product. */
static double find_plane(common_polygon *s, const common_corner *corners)
{
    const common_corner *far = corners;
    pov_two3 across;
    double largest = 0.0;
    uint32_t i;

    for (i = 0; i < s->count; i++)
        if (pov_dot(corners[i].local, corners[i].local) > pov_dot(far->local, far->local))
            far = &corners[i];
    across = offset_of(s, far);
    for (i = 0; i < s->count; i++) {
        const pov_two3 cross = pov_two3_cross(across, offset_of(s, &corners[i]));

        if (pov_largest(pov_two3_hi(cross)) > largest) {
            largest = pov_largest(pov_two3_hi(cross));
            s->normal = cross;
        }
    }
    return largest;
}

/* The normal's side is that of the first three corners that are not on a line: clockwise, seen from it. */
static double choose_side(common_polygon *s, const common_corner *corners, double largest)
{
    const pov_vec3 n = pov_two3_hi(s->normal);
    double side = 0.0;
    uint32_t i;

    for (i = 2; largest > 0.0 && i < s->count && !(fabs(side) > 0x1p-40); i++) {
        const pov_vec3 a = pov_two3_hi(offset_of(s, &corners[i - 1])), b = pov_two3_hi(offset_of(s, &corners[i]));

        side = pov_dot(pov_unit(n), pov_cross_product(pov_unit(a), pov_unit(b)));
    }
    if (side < 0.0) {
        s->normal.x = pov_two_of(0.0 - s->normal.x.hi, 0.0 - s->normal.x.lo);
        s->normal.y = pov_two_of(0.0 - s->normal.y.hi, 0.0 - s->normal.y.lo);
        s->normal.z = pov_two_of(0.0 - s->normal.z.hi, 0.0 - s->normal.z.lo);
    }
    return largest;
}

/* Tolerance of a corner's distance from the plane if each coordinate was rounded once, which moves a corner by at most
 * sqrt(3) roundings. Relative to the first corner it is a b + c, with b and c the two others of the plane and |a| <= 2,
 * |c| <= 1 in their units by their choice. With the first corner's own error that makes 8 such moves; as much again is
 * margin. */
static double tolerance(const common_polygon *s)
{
    const double coordinate = pov_max(pov_max(pov_largest(s->box.lo), pov_largest(s->box.hi)) * s->scale, 1.0);

    return 32.0 * COMMON_U * coordinate;
}

static void scale_corners(common_polygon *s, common_corner *corners)
{
    double size = 0.0;
    uint32_t i;

    s->scale = 1.0;
    s->box.lo = s->box.hi = corners[0].world;
    for (i = 0; i < s->count; i++) {
        const pov_vec3 v = corners[i].world;

        size = pov_max(size, pov_largest(pov_two3_hi(offset_of(s, &corners[i]))));
        s->box.lo = pov_vec3_of(pov_min(s->box.lo.x, v.x), pov_min(s->box.lo.y, v.y), pov_min(s->box.lo.z, v.z));
        s->box.hi = pov_vec3_of(pov_max(s->box.hi.x, v.x), pov_max(s->box.hi.y, v.y), pov_max(s->box.hi.z, v.z));
    }
    s->scale = pov_inverse_power(size);
    for (i = 0; i < s->count; i++)
        corners[i].local = pov_two3_hi(offset_of(s, &corners[i]));
}

/* Copies the corners of a small polygon to where rays read them first. */
static void put_near(common_polygon *s, const common_corner *corners)
{
    uint32_t i;

    s->small = true;
    for (i = 0; i < FEW; i++) {
        s->near[i] = corners[i < s->count ? i : s->count - 1].local;
        s->world[i] = corners[i < s->count ? i : s->count - 1].world;
    }
}

/* The largest distance of a corner from the plane, in scaled lengths. */
static double measure(const common_polygon *s, const common_corner *corners)
{
    const pov_vec3 normal = pov_two3_hi(s->normal);
    const double length = sqrt(pov_dot(normal, normal));
    double largest = 0.0;
    uint32_t i;

    for (i = 0; i < s->count; i++)
        largest = pov_max(largest, fabs(pov_two3_dot(s->normal, offset_of(s, &corners[i])).hi) / length);
    return largest;
}

/* Computes all but the error margin from the corners: returns the result of find_plane(). Two loops have more than a
 * few corners. */
static double take_corners(common_polygon *s, common_corner *corners, uint32_t count)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };

    s->count = count;
    s->anchor = pov_two3_of(corners[0].world, zero);
    scale_corners(s, corners);
    if (count <= FEW)
        put_near(s, corners);
    else
        s->corners = corners;
    return choose_side(s, corners, find_plane(s, corners));
}

/* largest: the length of the normal so far; off: the largest distance of a corner from the plane. */
static void choose_anchor(common_polygon *s, double largest, double off)
{
    const double power = pov_inverse_power(largest), wider = off * (4.0 / s->scale);

    s->normal.x = pov_two_scale(s->normal.x, power);
    s->normal.y = pov_two_scale(s->normal.y, power);
    s->normal.z = pov_two_scale(s->normal.z, power);
    s->unit = pov_unit(pov_two3_hi(s->normal));
    s->box.lo = pov_sub(s->box.lo, pov_vec3_of(wider, wider, wider));
    s->box.hi = pov_add(s->box.hi, pov_vec3_of(wider, wider, wider));
}

/* Programs write coordinates with few digits: corners off the plane by less than this part of the polygon's size are moved. */
static const double most_off = 0x1p-10;

/* Move the corners to the nearest points of the plane. */
static void move_to_plane(const common_polygon *s, common_corner *corners)
{
    const pov_vec3 n = pov_two3_hi(s->normal);
    const double per_length = 1.0 / (pov_dot(n, n) * s->scale);

    for (uint32_t i = 0; i < s->count; i++) {
        const double off = pov_two3_dot(s->normal, offset_of(s, &corners[i])).hi;

        corners[i].world = pov_sub(corners[i].world, pov_scale(n, off * per_length));
    }
}

/* Warn of corners that do not lie in a plane, or that lie on a line. */
static void project_at(reading *r, common_polygon *s)
{
    double largest = take_corners(s, r->corners, r->count), off, part;

    if (!(largest > 0.0)) {
        r->host->warn(r->in, "the points of this polygon lie on a line: it is not seen");
        return;
    }
    off = measure(s, r->corners);
    part = off / pov_largest(pov_sub(s->box.hi, s->box.lo)) / s->scale;
    if (!(off <= tolerance(s)) && part <= most_off) {
        r->host->warn(r->in, "the points of this polygon do not lie in a plane, by %g of its size: it is flattened", part);
        move_to_plane(s, r->corners);
        largest = take_corners(s, r->corners, r->count);
        off = measure(s, r->corners);
    }
    if (!(off <= tolerance(s)))
        r->host->fail(r->in, "the points of this polygon do not lie in a plane: one is %g of its size off", part);
    choose_anchor(s, largest, off);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    polygon_parsed *parsed = self;
    common_polygon *large, s;
    reading r;
    uint32_t i;

    memset(&r, 0, sizeof r);
    memset(&s, 0, sizeof s);
    r.host = host;
    r.in = in;
    r.corners = r.few;
    r.capacity = FEW;
    if (!read_corners(&r))
        return;
    project_at(&r, &s);
    parsed->count = r.count;
    for (i = 0; i < r.count && s.small; i++)
        parsed->corner[i] = r.corners[i].world;
    if (s.small)
        return;
    large = host->alloc(in, sizeof *large);
    if (large)
        *large = s;
    parsed->large = large;
}

static void prepare(void *self, const void *parsed)
{
    const polygon_parsed *t = parsed;
    common_corner few[FEW];
    common_polygon *s = self;
    double largest;
    uint32_t i;

    if (t->large)
        *s = *t->large;
    if (t->large || t->count == 0 || t->count > FEW)
        return;
    for (i = 0; i < t->count; i++) {
        few[i].world = t->corner[i];
        few[i].starts = i == 0;
    }
    largest = take_corners(s, few, t->count);
    if (largest > 0.0)
        choose_anchor(s, largest, measure(s, few));
}

static bool bounds(const void *self, pov_box *out)
{
    const common_polygon *s = self;

    *out = s->box;
    return true;
}

/* ---- rays ---- */

static pov_vec3 local_of(const common_polygon *s, uint32_t i) { return s->small ? s->near[i] : s->corners[i].local; }

static bool is_within(const common_polygon *s, common_view *view)
{
    bool within = false;
    common_seen before = { 0.0, 0.0, 0 };
    const pov_vec3 *last = NULL;
    uint32_t i;

    for (i = 0; i < s->count; i++) {
        const pov_vec3 *corner = s->small ? &s->world[i] : &s->corners[i].world;
        const common_seen here = common_view_project(view, local_of(s, i), corner);
        const bool starts = s->small ? i == 0 : s->corners[i].starts;

        if (!starts && here.above != before.above && common_view_is_right(view, last, before, corner, here))
            within = !within;
        before = here;
        last = corner;
    }
    return within;
}

static pov_two escalate_distance(const common_polygon *s, const common_ray *k, double first)
{
    const pov_two slope = pov_two3_dot(s->normal, common_direction(k));
    const pov_two height = pov_two3_dot(s->normal, isfinite(first) ? common_along_two(k, first) : k->f);
    const pov_two t = pov_two_neg(pov_two_div(height, slope));

    return isfinite(first) ? pov_two_add_double(t, first) : t;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const common_polygon *s = self;
    common_ray k;
    pov_vec3 n, w;
    double slope, first;
    common_verdict verdict;
    common_root root;
    common_view view;

    if (s->count == 0 || ray->origin_surface == hits->owner)
        return;
    k = common_enter(ray, s->anchor, s->scale);
    n = pov_two3_hi(s->normal);
    slope = pov_dot(n, k.d);
    first = -pov_dot(n, pov_two3_hi(k.f)) / slope;
    w = common_along(&k, first);
    root = common_polygon_distance(n, &k, slope, 6.0 * COMMON_U * common_sum_of_sizes(n, k.d), first, w);
    verdict = common_judge(&root, k.unit, COMMON_FINE, hits);
    if (verdict == COMMON_OUTSIDE)
        return;
    view = common_view_make(ray->org, ray->org_lo, &k, w, hits->unfiltered);
    if (is_within(s, &view)) {
        if (verdict == COMMON_OPEN || hits->always_exact) {
            view.escalated = true;
            root.t = escalate_distance(s, &k, first);
        }
        if (isfinite(root.t.hi))
            pov_cross(hits, root.t.hi * k.unit, root.t.lo * k.unit,
                      common_mark(0, view.escalated ? COMMON_POLYGON_MARK | POV_MARK_ESCALATED : COMMON_POLYGON_MARK));
    }
    hits->escalated += view.escalated;
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)ray;
    (void)at;
    *out = ((const common_polygon *)self)->unit;
}

static void intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    common_polygon_intersect_many(selves, rays, hits, n, intersect);
}

static void cross_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    common_polygon_cross_many(selves, rays, hits, n, intersect);
}

/* ---- blocks ---- */

static void describe(const common_polygon *s, common_planar *f)
{
    const pov_vec3 n = pov_two3_hi(s->normal);
    pov_vec3 corners[COMMON_SIDES];
    uint32_t i;

    f->anchor = pov_two3_hi(s->anchor);
    f->normal = n;
    f->scale = s->scale;
    if (s->count <= COMMON_SIDES + 1 && s->small) {
        for (i = 0; i + 1 < s->count; i++)
            corners[i] = s->near[i];
        if (common_planar_outline(f, corners, s->count - 1))
            return;
    }
    common_planar_begin(f, local_of(s, 0), pov_vec3_of(fabs(n.x) < fabs(n.y), fabs(n.x) >= fabs(n.y), 0.0));
    for (i = 1; i < s->count; i++)
        common_planar_extend(f, local_of(s, i));
}

static bool block_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    common_planar figures[POV_BLOCK_MAX];
    uint32_t i;

    for (i = 0; i < n; i++) {
        const common_polygon *s = selves[i];

        if (s->count == 0 || !(pov_largest(pov_two3_hi(s->normal)) > 0.0))
            return false;
        describe(s, &figures[i]);
    }
    return common_planar_pack(block, frame, figures, n);
}

static const pov_shape_fast polygon_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(common_planar_block),
    .single_block_size = COMMON_PLANAR_SINGLE,
    .block_pack = block_pack,
    .block_filter = common_planar_filter,
    .intersect_many = intersect_many,
    .cross_many = cross_many,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &polygon_fast : NULL; }

static const pov_shape_class polygon_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_CONVEX | POV_SHAPE_FACETED | POV_SHAPE_CERTIFIED,
    .keyword = "polygon",
    .instance_size = sizeof(common_polygon),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .parsed_size = sizeof(polygon_parsed),
    .prepare = prepare,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &polygon_class, NULL };

POV_PLUGIN(polygon) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "polygon",
    .version = "1",
    .shapes = shapes,
};
