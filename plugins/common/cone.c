#include "common/cone_internal.h"

#include "common/affine.h"

/* ---- making one ---- */

static pov_two3 unit(pov_two3 a, pov_two *length)
{
    pov_two3 r;

    *length = pov_two_sqrt(pov_two3_dot(a, a));
    r.x = pov_two_div(a.x, *length);
    r.y = pov_two_div(a.y, *length);
    r.z = pov_two_div(a.z, *length);
    return r;
}

/* Unit vectors perpendicular to an axis: exact if it is a coordinate axis. */
static void make_frame(pov_two3 axis, pov_two3 *across, pov_two3 *over)
{
    const pov_vec3 size = pov_vec3_of(fabs(axis.x.hi), fabs(axis.y.hi), fabs(axis.z.hi));
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    pov_vec3 pick = zero;
    pov_two length;

    if (size.x <= size.y && size.x <= size.z)
        pick.x = 1.0;
    else if (size.z <= size.y)
        pick.z = 1.0;
    else
        pick.y = 1.0;
    *across = unit(pov_two3_cross(axis, pov_two3_of(pick, zero)), &length);
    *over = pov_two3_cross(axis, *across);
}

/* Length and direction of an axis; exact if it is a coordinate axis. */
static pov_two3 measure(pov_two3 axis, pov_two *length)
{
    const pov_two zero = { 0.0, 0.0 };
    const int entries = (axis.x.hi != 0.0) + (axis.y.hi != 0.0) + (axis.z.hi != 0.0);
    pov_two3 dir = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    pov_two sum;

    if (entries != 1)
        return unit(axis, length);
    sum = axis.x.hi != 0.0 ? axis.x : axis.y.hi != 0.0 ? axis.y : axis.z;
    dir.x.hi = (axis.x.hi > 0.0) - (axis.x.hi < 0.0);
    dir.y.hi = (axis.y.hi > 0.0) - (axis.y.hi < 0.0);
    dir.z.hi = (axis.z.hi > 0.0) - (axis.z.hi < 0.0);
    *length = sum.hi < 0.0 ? pov_two_sub(zero, sum) : sum;
    return dir;
}

static double largest_of(pov_two3 a) { return pov_largest(pov_two3_hi(a)); }

/* Axis along a coordinate axis, with a power of two for its length: products with it are exact. */
static bool is_axial(pov_two3 row)
{
    const double largest = largest_of(row);

    return (row.x.hi != 0.0) + (row.y.hi != 0.0) + (row.z.hi != 0.0) == 1 && row.x.lo == 0.0 && row.y.lo == 0.0
           && row.z.lo == 0.0 && largest * pov_inverse_power(largest) == 1.0;
}

/* Scale by powers of two to the order of one: radii, height, and the rows for scaled points. */
static void normalise(common_cone *s)
{
    double largest_radius = pov_max(s->radius.hi, pov_two_add(s->radius, pov_two_mul(s->slope, s->height)).hi);
    double across = pov_inverse_power(largest_radius), along = pov_inverse_power(s->height.hi), largest;
    int i;

    s->radius = pov_two_scale(s->radius, across);
    s->height = pov_two_scale(s->height, along);
    s->slope = pov_two_scale(s->slope, across / along);
    s->row[0] = scaled(s->row[0], across);
    s->row[1] = scaled(s->row[1], across);
    s->row[2] = scaled(s->row[2], along);
    largest = pov_max(largest_of(s->row[0]), pov_max(largest_of(s->row[1]), largest_of(s->row[2])));
    /* The rows are divided by a power of two that points will be multiplied by. */
    largest = pov_inverse_power(largest);
    for (i = 0; i < 3; i++)
        s->row[i] = scaled(s->row[i], largest);
    s->scale /= largest;
    for (i = 0; i < 3; i++)
        s->loss[i] = is_axial(s->row[i]) ? 2.0 * COMMON_U : 7.0 * COMMON_U;
    s->slender = largest_of(s->row[0]) > 4096.0 * largest_of(s->row[2]);
}

void common_cone_prepare(void *self, const void *parsed)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_cone_parsed *t = parsed;
    const bool turned = t->top_radius < t->base_radius;   /* the narrower end comes first */
    const pov_vec3 base = turned ? t->top : t->base, top = turned ? t->base : t->top;
    const double base_radius = turned ? t->top_radius : t->base_radius;
    const double top_radius = turned ? t->base_radius : t->top_radius;
    const double power = pov_inverse_power(pov_largest(pov_sub(top, base)));
    common_cone *s = self;
    pov_two3 axis, dir;
    pov_two length;

    axis.x = pov_two_sum(top.x, -base.x);
    axis.y = pov_two_sum(top.y, -base.y);
    axis.z = pov_two_sum(top.z, -base.z);
    dir = measure(scaled(axis, power), &length);
    s->anchor = pov_two3_of(base, zero);
    s->axis = axis;
    s->height = pov_two_scale(length, 1.0 / power);
    s->radius = pov_two_of(base_radius, 0.0);
    s->slope = pov_two_div(pov_two_sum(top_radius, -base_radius), s->height);
    s->row[2] = dir;
    make_frame(dir, &s->row[0], &s->row[1]);
    s->of.written.radii[0] = base_radius;
    s->of.written.radii[1] = top_radius;
    s->of.written.length = s->height.hi;
    s->open = t->open;
    s->empty = !(base_radius > 0.0) && !(top_radius > 0.0);
    s->scale = 1.0;
    if (!s->empty)
        normalise(s);
}

static bool comes_first(pov_vec3 a, pov_vec3 b)
{
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

void common_cone_reorder(void *parsed)
{
    common_cone_parsed *t = parsed;
    const common_cone_parsed as_written = *t;

    if (t->top_radius > t->base_radius || (t->top_radius == t->base_radius && comes_first(t->base, t->top)))
        return;
    t->base = as_written.top;
    t->top = as_written.base;
    t->base_radius = as_written.top_radius;
    t->top_radius = as_written.base_radius;
}

/* For a shape that has absorbed no map: a row as before normalise(), of length one, so that its largest entry is above
 * one half and at most one. The columns of the inverse are the rows then. */
static pov_two3 unit_row(pov_two3 row)
{
    const double largest = largest_of(row), power = pov_inverse_power(largest);

    return scaled(row, largest * power < 1.125 ? power : 0.5 * power);   /* no unit vector has its largest component
                                                                          * between 0.5 and 0.57 */
}

/* The box of two discs (ellipses, if a map squeezed them), widened by all roundings here. */
static void extend(const common_cone_size *s, double anchor, double x, double y, double z, double *lo, double *hi)
{
    const double across = sqrt(x * x + y * y), shift = z * s->length;
    const double slack = 32.0 * COMMON_U * (across * pov_max(s->radii[0], s->radii[1]) + fabs(shift));
    const double low = pov_min(-across * s->radii[0], shift - across * s->radii[1]);
    const double high = pov_max(across * s->radii[0], shift + across * s->radii[1]);

    *lo = common_below(anchor + common_below(low - slack));
    *hi = common_above(anchor + common_above(high + slack));
}

/* c: columns of the inverse map, not scaled. */
static pov_box box_of(const common_cone_size *s, pov_two3 anchor, const pov_vec3 c[3])
{
    pov_box box;

    extend(s, anchor.x.hi, c[0].x, c[1].x, c[2].x, &box.lo.x, &box.hi.x);
    extend(s, anchor.y.hi, c[0].y, c[1].y, c[2].y, &box.lo.y, &box.hi.y);
    extend(s, anchor.z.hi, c[0].z, c[1].z, c[2].z, &box.lo.z, &box.hi.z);
    return box;
}

bool common_cone_open(const void *self)
{
    return ((const common_cone *)self)->open;
}

bool common_cone_bounds(const void *self, pov_box *out)
{
    const common_cone *s = self;
    pov_vec3 columns[3];
    int i;

    if (s->moved) {
        *out = s->of.box;
        return true;
    }
    for (i = 0; i < 3; i++)
        columns[i] = pov_two3_hi(unit_row(s->row[i]));
    *out = box_of(&s->of.written, s->anchor, columns);
    return true;
}

/* Of the local coordinates x, y, z: x^2 + y^2 - (radius + slope z)^2 <= 0 within 0 <= z <= height. */
bool common_cone_outline(const void *self, pov_outline *out)
{
    const common_cone *s = self;
    const double steep = s->slope.hi, radius = s->radius.hi;
    pov_vec3 row[3];
    pov_outline c = { .centre = pov_two3_hi(s->anchor), .slabs = 1, .constant = -radius * radius, .round = true };

    for (int i = 0; i < 3; i++)
        row[i] = pov_scale(pov_two3_hi(s->row[i]), s->scale);
    for (int i = 0; i < 3; i++) {
        const pov_vec3 r = row[i];
        const double by = i == 2 ? -steep * steep : 1.0;

        c.square[0] += by * r.x * r.x;
        c.square[1] += by * r.y * r.y;
        c.square[2] += by * r.z * r.z;
        c.square[3] += by * r.x * r.y;
        c.square[4] += by * r.x * r.z;
        c.square[5] += by * r.y * r.z;
    }
    c.linear = pov_scale(row[2], -radius * steep);
    c.normal[0] = row[2];
    c.hi[0] = s->height.hi;
    *out = c;
    return !s->empty;
}

/* The new rows are the old ones times the inverse map. Any affine map could be absorbed. One that changes angles much
 * would lose precision in the products, unless it is axial. */
bool common_cone_absorb(void *self, const pov_affine *map)
{
    common_cone *s = self;
    const common_cone_size written = s->of.written;
    pov_two3 inverse[3], columns[3], rows[3];
    pov_vec3 back[3];
    int axis[3], i;

    if (!(common_condition(map) < 1024.0) && !common_is_axial(map, axis))
        return false;
    common_inverse_linear(map, inverse);
    columns[0].x = inverse[0].x, columns[0].y = inverse[1].x, columns[0].z = inverse[2].x;
    columns[1].x = inverse[0].y, columns[1].y = inverse[1].y, columns[1].z = inverse[2].y;
    columns[2].x = inverse[0].z, columns[2].y = inverse[1].z, columns[2].z = inverse[2].z;
    s->anchor = common_map_point(map, s->anchor);
    common_linear(map, rows);
    s->axis = times_vector(rows, s->axis);
    for (i = 0; i < 3; i++) {
        const pov_two3 row = s->row[i];

        s->row[i].x = pov_two3_dot(row, columns[0]);
        s->row[i].y = pov_two3_dot(row, columns[1]);
        s->row[i].z = pov_two3_dot(row, columns[2]);
        back[i] = pov_two3_hi(times_vector(rows, unit_row(row)));
    }
    s->of.box = box_of(&written, s->anchor, back);
    s->moved = true;
    if (!s->empty)
        normalise(s);
    return true;
}

/* ---- points ---- */

common_residual common_cone_residual(const void *self, const common_ray *k, pov_two3 w, uint32_t feature)
{
    const common_cone *s = self;
    const view v = view_of(s, k, w);
    common_residual r = feature >= CAP_BASE ? cap_residual(s, &v, feature == CAP_BASE) : side_residual(s, &v);

    r.error = cone_value_error(w);
    return r;
}

/* The crossing's point in local coordinates, and the radius there. On the side it is moved onto the surface by a Newton
 * step, because near an apex the distance alone is too inaccurate for a normal. A point that is off by much is not
 * moved. */
static view surface_point(const common_cone *s, const common_ray *k, const pov_crossing *at)
{
    view v = view_of(s, k, common_point(k, at));
    const double step = side_step(s, &v);

    if (is_step(step))
        take_step(s, &v, step);
    return v;
}

static void cap_normal(const common_cone *s, uint32_t feature, pov_vec3 *out)
{
    *out = pov_scale(pov_unit(pov_two3_hi(s->row[2])), feature == CAP_BASE ? -1.0 : 1.0);
}

void common_cone_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const common_cone *s = self;
    common_ray k;
    view v;

    if (at->mark.feature >= CAP_BASE) {
        cap_normal(s, at->mark.feature, out);
        return;
    }
    k = common_enter(ray, s->anchor, s->scale);
    v = surface_point(s, &k, at);
    if (v.p.x.hi == 0.0 && v.p.y.hi == 0.0) {
        cap_normal(s, CAP_TOP, out);
        return;
    }
    *out = pov_unit(side_normal(s, &v));
}

bool common_cone_inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const common_cone *s = self;
    const pov_two3 p = cone_local(s, common_offset(point, point_lo, s->anchor, s->scale));
    const pov_two r = radius_at(s, p.z);

    return !s->empty && p.z.hi > 0.0 && pov_two_less(p.z, s->height)
           && pov_two_less(sum2(p.x, p.x, p.y, p.y), pov_two_mul(r, r));
}
