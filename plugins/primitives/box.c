/* box { <corner>, <opposite corner> }
 *
 * Three slabs. The order of planes along the ray is a comparison of quotients; where they are too close for doubles,
 * their cross products are compared in double-double, and exactly where that does not tell. The box is closed: edges
 * and corners belong to it. A planar one, without extent along an axis, is one surface: a ray is never inside. */
#include "common/affine.h"
#include "common/expansion.h"
#include "common/box_block.h"
#include "common/box_lanes.h"
#include "common/report.h"

#include <float.h>

typedef struct box {
    pov_two plane[6];      /* plane[2 * axis] is the lower one, and so is a mark's part */
} box;

/* State of one ray query. */
typedef struct slabs {
    const box *shape;
    double o[3], o_lo[3], d[3], d_lo[3];   /* the direction's largest component is in [1, 2) */
    double unit;           /* a local distance times unit is a distance along the ray */
    double t[6];           /* within 6 u of the exact quotients: a difference that low parts change much is exact */
    bool always_exact, escalated;
} slabs;

static void set_plane(pov_two plane[6], int axis, double a, double b)
{
    plane[2 * axis] = pov_two_of(a < b ? a : b, 0.0);
    plane[2 * axis + 1] = pov_two_of(a < b ? b : a, 0.0);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    box *b = self;
    pov_vec3 p, q;

    host->vector(in, &p);
    host->accept(in, ",");
    host->vector(in, &q);
    set_plane(b->plane, 0, p.x, q.x);
    set_plane(b->plane, 1, p.y, q.y);
    set_plane(b->plane, 2, p.z, q.z);
}

static bool bounds(const void *self, pov_box *out)
{
    const box *b = self;
    const pov_two *p = b->plane;
    double *lo[3] = { &out->lo.x, &out->lo.y, &out->lo.z }, *hi[3] = { &out->hi.x, &out->hi.y, &out->hi.z };
    int i;

    for (i = 0; i < 3; i++) {
        *lo[i] = p[2 * i].lo < 0.0 ? common_below(p[2 * i].hi) : p[2 * i].hi;
        *hi[i] = p[2 * i + 1].lo > 0.0 ? common_above(p[2 * i + 1].hi) : p[2 * i + 1].hi;
    }
    return true;
}

/* From the ray's origin to a plane. */
static pov_two distance_to(const slabs *s, int plane)
{
    return pov_two_neg(pov_two_offset(s->o[plane / 2], s->o_lo[plane / 2], s->shape->plane[plane]));
}

static void begin(slabs *s, const box *shape, const pov_ray *ray, bool always_exact)
{
    const double power = pov_inverse_power(pov_largest(ray->dir));
    const pov_vec3 d = pov_scale(ray->dir, power), d_lo = pov_scale(ray->dir_lo, power);
    int i;

    s->shape = shape;
    s->o[0] = ray->org.x, s->o[1] = ray->org.y, s->o[2] = ray->org.z;
    s->o_lo[0] = ray->org_lo.x, s->o_lo[1] = ray->org_lo.y, s->o_lo[2] = ray->org_lo.z;
    s->d[0] = d.x, s->d[1] = d.y, s->d[2] = d.z;
    s->d_lo[0] = d_lo.x, s->d_lo[1] = d_lo.y, s->d_lo[2] = d_lo.z;
    s->unit = power;
    s->always_exact = always_exact;
    s->escalated = false;
    for (i = 0; i < 6; i++) {
        const pov_two plane = shape->plane[i];

        s->t[i] = ((plane.hi - s->o[i / 2]) + (plane.lo - s->o_lo[i / 2])) / s->d[i / 2];
    }
}

/* Adds `factor` times the product of the distance to a plane and the direction along another axis. */
static void add_product(common_expansion *e, const slabs *s, int plane, int axis, double factor)
{
    const double distance[4] = { s->shape->plane[plane].hi, s->shape->plane[plane].lo, -s->o[plane / 2],
                                 -s->o_lo[plane / 2] };
    int i;

    for (i = 0; i < 4; i++) {
        common_expansion_add_product(e, distance[i], factor * s->d[axis]);
        common_expansion_add_product(e, distance[i], factor * s->d_lo[axis]);
    }
}

/* The product of the distance to a plane and the direction along another axis, within 2^-100 of *size. */
static pov_two cross_product(const slabs *s, int plane, int axis, double factor, double *size)
{
    const double d = factor * s->d[axis];

    *size = (fabs(s->shape->plane[plane].hi) + fabs(s->o[plane / 2])) * fabs(d);
    return pov_two_mul(distance_to(s, plane), pov_two_of(d, factor * s->d_lo[axis]));
}

/* The sign of the difference of both products: in double-double, and exactly where that leaves it open. */
static int compare_products(const slabs *s, int p, int q)
{
    const double power = pov_inverse_power(pov_max(fabs(s->d[p / 2]), fabs(s->d[q / 2])));
    double size_p, size_q;
    const pov_two difference = pov_two_sub(cross_product(s, p, q / 2, power, &size_p),
                                           cross_product(s, q, p / 2, power, &size_q));
    common_expansion e;

    if (fabs(difference.hi) > 0x1p-98 * (size_p + size_q) + 0x1p-900)
        return difference.hi > 0.0 ? 1 : -1;
    common_expansion_clear(&e);
    add_product(&e, s, p, q / 2, power);
    add_product(&e, s, q, p / 2, -power);
    return common_expansion_sign(&e);
}

/* The same of two planes of an axis, which are one where a box is planar. */
static int compare_planes(const slabs *s, int p, int q)
{
    const pov_two a = s->shape->plane[p], b = s->shape->plane[q];
    const int sign = a.hi != b.hi ? (a.hi > b.hi ? 1 : -1) : (a.lo > b.lo) - (a.lo < b.lo);

    return s->d[p / 2] < 0.0 ? -sign : sign;
}

/* Negative, zero or positive if the ray crosses plane p before, with or after plane q. Neither is parallel to it. */
static int compare(slabs *s, int p, int q)
{
    const double difference = s->t[p] - s->t[q], slack = 8.0 * COMMON_U * (fabs(s->t[p]) + fabs(s->t[q]));
    int sign;

    s->escalated = s->escalated || s->always_exact;
    if (p / 2 == q / 2)
        return compare_planes(s, p, q);
    /* A finite and an infinite distance need no slack. */
    if (difference > slack || difference == HUGE_VAL)
        return 1;
    if (difference < -slack || difference == -HUGE_VAL)
        return -1;
    s->escalated = true;
    sign = compare_products(s, p, q);
    return (s->d[p / 2] < 0.0) != (s->d[q / 2] < 0.0) ? -sign : sign;
}

/* The planes where the ray enters and leaves all three slabs, -1 for none. False: it is beside one of
 * them. */
static bool find(slabs *s, int *entry, int *exit)
{
    int i;

    *entry = *exit = -1;
    for (i = 0; i < 3; i++) {
        int near = s->d[i] < 0.0 ? 2 * i + 1 : 2 * i, far = near ^ 1;

        if (s->d[i] == 0.0) {
            if (distance_to(s, 2 * i).hi > 0.0 || distance_to(s, 2 * i + 1).hi < 0.0)
                return false;
            continue;
        }
        if (*entry < 0 || compare(s, near, *entry) > 0)
            *entry = near;
        if (*exit < 0 || compare(s, far, *exit) < 0)
            *exit = far;
    }
    return *entry >= 0;
}

static inline bool is_planar_along(const box *b, int axis)
{
    const pov_two *p = b->plane + 2 * axis;

    return p[0].hi == p[1].hi && p[0].lo == p[1].lo;
}

static bool is_planar(const void *self)
{
    return is_planar_along(self, 0) || is_planar_along(self, 1) || is_planar_along(self, 2);
}

/* A box that rounding makes planar is left where it is entered. */
static inline uint32_t mark_of(const box *b)
{
    const pov_two *p = b->plane;

    return p[0].hi < p[1].hi && p[2].hi < p[3].hi && p[4].hi < p[5].hi ? POV_MARK_CLOSED : 0;
}

/* The quotient in double-double: the remainder of the first division is divided again. */
static bool report(const slabs *s, pov_hits *hits, int plane)
{
    const double d = s->d[plane / 2];
    const pov_two distance = distance_to(s, plane);
    double t = distance.hi / d;
    pov_two p = pov_two_product(t, d), sum;
    double rest = ((distance.hi - p.hi) - p.lo) + (distance.lo - t * s->d_lo[plane / 2]);
    const int lost = is_lost(distance.hi, s->o[plane / 2]);

    sum = pov_fast_two_sum(t, rest / d);
    if (!isfinite(sum.lo))
        sum = pov_two_of(t, 0.0);
    return pov_cross(hits, sum.hi * s->unit, sum.lo * s->unit,
                     common_mark((uint32_t)plane, mark_of(s->shape) | (s->escalated || lost ? POV_MARK_ESCALATED : 0)));
}

static inline bool goes_inward(pov_vec3 d, int face)
{
    const double slope = face < 2 ? d.x : face < 4 ? d.y : d.z;

    return face % 2 ? slope < 0.0 : slope > 0.0;
}

/* A ray that left a face inward has entered already, whatever rounding says of an edge nearby; one that goes outward or
 * along the face has its exit behind it. */
static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const int left = ray->origin_surface == hits->owner ? (int)(ray->origin_mark.feature % 6) : -1;
    bool entered = false, gone = false;
    int entry, exit;
    slabs s;

    if (left >= 0 && ((hits->tmin >= 0.0 && !goes_inward(ray->dir, left)) || is_planar_along(self, left / 2)))
        return;
    begin(&s, self, ray, hits->always_exact);
    if (left >= 0) {
        entered = goes_inward(pov_vec3_of(s.d[0], s.d[1], s.d[2]), left);
        gone = !entered;
        if (gone && hits->tmin >= 0.0)
            return;
    }
    if (!find(&s, &entry, &exit))
        return;
    if (left < 0 && compare(&s, entry, exit) > 0) {
        hits->escalated += s.escalated;
        return;
    }
    hits->escalated += s.escalated;
    if (!entered && !report(&s, hits, entry))
        return;
    if (!gone && !(entry / 2 == exit / 2 && is_planar_along(self, entry / 2)))
        report(&s, hits, exit);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const double sign = at->mark.feature % 2 ? 1.0 : -1.0;

    (void)self;
    (void)ray;
    *out = pov_vec3_of(0.0, 0.0, 0.0);
    if (at->mark.feature < 2)
        out->x = sign;
    else if (at->mark.feature < 4)
        out->y = sign;
    else
        out->z = sign;
}

/* Faces belong to the box, as in POV-Ray: points of a grid often lie on them. */
static bool is_between(double p, double p_lo, const pov_two plane[2])
{
    return pov_two_offset(p, p_lo, plane[0]).hi >= 0.0 && pov_two_offset(p, p_lo, plane[1]).hi <= 0.0;
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const box *b = self;

    return is_between(point.x, point_lo.x, b->plane) && is_between(point.y, point_lo.y, b->plane + 2)
           && is_between(point.z, point_lo.z, b->plane + 4);
}

/* Translations, scalings along the axes and quarter turns keep a box a box. */
static bool absorb(void *self, const pov_affine *map)
{
    box *b = self;
    pov_two plane[6];
    int axis[3], i, j;

    if (!common_is_axial(map, axis))
        return false;
    for (i = 0; i < 3; i++) {
        const pov_two stretch = common_entry(map, i, axis[i]);

        for (j = 0; j < 2; j++) {
            const int to = 2 * i + (stretch.hi < 0.0 ? 1 - j : j);
            plane[to] = pov_two_add(pov_two_mul(stretch, b->plane[2 * axis[i] + j]), common_entry(map, i, 3));
        }
    }
    memcpy(b->plane, plane, sizeof plane);
    return true;
}

/* ---- many at once ---- */

/* Load n pairs; lanes past the end hold the last one again. */
COMMON_INLINE void put_pairs(box_lanes *l, const void *const *selves, const pov_ray *const *rays, uint32_t n)
{
    const void *shapes[COMMON_LANES];
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++)
        shapes[i] = selves[common_lane_of(i, n)];
    for (i = 0; i < COMMON_LANES; i += 4) {
        common_put_four_of(&l->rays, i, rays, n);
        common_put_four_shapes(l->plane[0] + i, COMMON_LANES, 12, shapes + i);
    }
}

/* Is a start that is not on the box between all of its planes? Its entry is behind then. */
static bool is_within(const box *b, pov_vec3 o)
{
    return (b->plane[0].hi < o.x) & (o.x < b->plane[1].hi) & (b->plane[2].hi < o.y) & (o.y < b->plane[3].hi) &
           (b->plane[4].hi < o.z) & (o.z < b->plane[5].hi);
}

static bool starts_inside(const box *b, const pov_ray *ray, const pov_hits *hits)
{
    return hits->owner != ray->origin_surface ? is_within(b, ray->org) : common_is_inward(ray, hits);
}

/* Of rays that definitely enter: where they leave again, for those of which all crossings are wanted. NaN: not certain, or not asked. */
static void find_exits(box_lanes *lanes, const pov_hits *const *hits, uint32_t n, end_lanes *out)
{
    bool any = false;

    for (uint32_t i = 0; i < n; i++)
        any = any || (hits[i]->want == POV_WANT_ALL && lanes->sign[i] > 0.0);
    for (uint32_t i = 0; i < COMMON_LANES; i++)
        lanes->sign[i] = -1.0, out->t[i] = NAN;
    if (any)
        find_ends(lanes, out);
}

/* The ends of one ray: its entry, and if more is wanted its exit; or, of one that is inside, its exit. False: open. */
static bool put_ends(const box *b, const pov_ray *ray, bool inside, const end_lanes *end, const end_lanes *exit, uint32_t i, pov_hits *h)
{
    const uint32_t mark = mark_of(b);
    const bool both = h->want == POV_WANT_ALL && !inside;

    if (!(end->t[i] > h->tmin) || h->always_exact || (h->owner == ray->origin_surface && !(inside && mark)) ||
        (both && !(exit->t[i] > end->t[i])))
        return false;
    if (pov_cross(h, end->t[i], end->t_lo[i], common_mark((uint32_t)end->feature[i], mark)) && both)
        pov_cross(h, exit->t[i], exit->t_lo[i], common_mark((uint32_t)exit->feature[i], mark));
    return true;
}

/* A ray that does not leave the box and definitely enters it needs no more, unless all is wanted: its exit is further away. The same holds
 * for a ray that goes inward from its start, or starts inside, which has no crossing but its exit. */
static void intersect_lanes(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    end_lanes end, exit;
    box_lanes lanes;
    uint32_t inside = 0;

    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const uint32_t k = common_lane_of(i, n);
        const bool starts = starts_inside(selves[k], rays[k], hits[k]);

        lanes.sign[i] = starts ? -1.0 : 1.0;
        inside |= (uint32_t)starts << i;
    }
    put_pairs(&lanes, selves, rays, n);
    find_ends(&lanes, &end);
    find_exits(&lanes, (const pov_hits *const *)hits, n, &exit);
    for (uint32_t i = 0; i < n; i++)
        if (!put_ends(selves[i], rays[i], inside >> i & 1, &end, &exit, i, hits[i]))
            intersect(selves[i], rays[i], hits[i]);
}

static void cross_lanes(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    end_lanes end;
    box_lanes lanes;
    uint32_t i;

    put_pairs(&lanes, selves, rays, n);
    find_entries(&lanes, &end);
    for (i = 0; i < n; i++)
        if (end.t[i] > hits[i]->tmin && !hits[i]->always_exact)
            pov_cross(hits[i], end.t[i], end.t_lo[i], common_mark((uint32_t)end.feature[i], mark_of(selves[i])));
        else
            intersect(selves[i], rays[i], hits[i]);
}

static void intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    common_intersect_pairs(selves, rays, hits, n, intersect_lanes, intersect);
}

static void cross_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    common_intersect_pairs(selves, rays, hits, n, cross_lanes, intersect);
}

static uint32_t cross_sure_lanes(const void *const *selves, const pov_ray *const *rays, pov_crossing *const *at, pov_contact *const *contacts,
                                 uint32_t n)
{
    common_contact_lanes found;
    uint32_t open = 0;
    end_lanes end;
    box_lanes lanes;

    put_pairs(&lanes, selves, rays, n);
    if (common_are_sure_inward(rays, at)) {
        for (uint32_t i = 0; i < COMMON_LANES; i++)
            lanes.sign[i] = -1.0;
        find_ends(&lanes, &end);
    } else {
        find_entries(&lanes, &end);
    }
    for (uint32_t i = 0; i < n; i++)
        if (end.t[i] > 0.0)
            common_cross_sure(at[i], end.t[i], end.t_lo[i], (uint32_t)end.feature[i], mark_of(selves[i]));
        else
            open |= 1u << i;
    if (contacts) {
        find_points(&lanes, &end, &found);
        common_get_contacts(&found, contacts, n);
    }
    return open;
}

static uint64_t cross_sure(const void *const *selves, const pov_ray *const *rays, pov_crossing *const *at, pov_contact *const *contacts, uint32_t n)
{
    uint64_t open = 0;

    for (uint32_t i = 0; i < n; i += COMMON_LANES)
        open |= (uint64_t)cross_sure_lanes(selves + i, rays + i, at + i, contacts ? contacts + i : NULL,
                                           n - i < COMMON_LANES ? n - i : COMMON_LANES) << i;
    return open;
}

static bool block_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    uint32_t i, p;

    if (!frame)
        return false;
    common_box_begin(block, n);
    for (i = 0; i < n; i++)
        for (p = 0; p < 6; p++) {
            const pov_two plane = ((const box *)selves[i])->plane[p];
            const double centre = p < 2 ? frame->centre.x : p < 4 ? frame->centre.y : frame->centre.z;

            common_box_put(block, i, p, (plane.hi - centre + plane.lo) * frame->scale);
        }
    return true;
}

/* How far a coordinate is from the lower plane to the upper one. */
static double share(const box *b, int axis, double at)
{
    const double lo = b->plane[2 * axis].hi, length = b->plane[2 * axis + 1].hi - lo;

    return length > 0.0 ? (at - lo) / length : 0.0;
}

/* The six faces unfolded to a cross, four columns by three rows. */
static void uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2])
{
    const double x = share(self, 0, point.x), y = share(self, 1, point.y), z = share(self, 2, point.z);
    const double columns[6] = { z, 3.0 - z, 1.0 + x, 1.0 + x, 4.0 - x, 1.0 + x };
    const double rows[6] = { 1.0 + y, 1.0 + y, z, 3.0 - z, 1.0 + y, 1.0 + y };

    out[0] = columns[mark->feature % 6] / 4.0;
    out[1] = rows[mark->feature % 6] / 3.0;
}

static bool outline(const void *self, pov_outline *out)
{
    const pov_two *p = ((const box *)self)->plane;
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    pov_outline c = { .centre = zero, .normal = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } }, .slabs = 3 };

    for (int i = 0; i < 3; i++) {
        c.lo[i] = p[2 * i].hi;
        c.hi[i] = p[2 * i + 1].hi;
    }
    *out = c;
    return true;
}

static const pov_shape_fast box_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(common_box_block),
    .single_block_size = COMMON_BOX_SINGLE,
    .block_pack = block_pack,
    .block_filter = common_box_filter,
    .intersect_many = intersect_many,
    .cross_many = cross_many,
    .cross_sure = cross_sure,
    .outline = outline,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &box_fast : NULL; }

static const pov_shape_class box_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CONVEX | POV_SHAPE_BOX | POV_SHAPE_FACETED | POV_SHAPE_CERTIFIED,
    .keyword = "box",
    .instance_size = sizeof(box),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .absorb = absorb,
    .open = is_planar,
    .uv = uv,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &box_class, NULL };

POV_PLUGIN(box) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "box",
    .version = "1",
    .shapes = shapes,
};
