/* What a solid is said to hide of an area light, each segment to it enters, and what it is said to let pass, none; and most of both is
 * said. */
#include "shade/area_cover.h"
#include "support/check.h"

#include <math.h>

static uint64_t seed = 7;

static double uniform(double lo, double hi)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return lo + (hi - lo) * (double)(seed >> 11) * 0x1p-53;
}

static pov_vec3 anywhere(double size) { return pov_vec3_of(uniform(-size, size), uniform(-size, size), uniform(-size, size)); }

/* x, y, z: an orthogonal frame of some size. */
static void draw_frame(pov_vec3 frame[3], double size)
{
    frame[0] = pov_unit(anywhere(1.0));
    frame[1] = pov_unit(pov_cross_product(frame[0], anywhere(1.0)));
    frame[2] = pov_cross_product(frame[0], frame[1]);
    for (int i = 0; i < 3; i++)
        frame[i] = pov_scale(frame[i], 1.0 / size);
}

static void add_slab(pov_outline *o, pov_vec3 normal)
{
    o->normal[o->slabs] = normal;
    o->lo[o->slabs] = uniform(-1.5, -0.2);
    o->hi[o->slabs++] = uniform(0.2, 1.5);
}

static void add_square(pov_outline *o, pov_vec3 n, double by)
{
    o->square[0] += by * n.x * n.x;
    o->square[1] += by * n.y * n.y;
    o->square[2] += by * n.z * n.z;
    o->square[3] += by * n.x * n.y;
    o->square[4] += by * n.x * n.z;
    o->square[5] += by * n.y * n.z;
}

/* Spheres, boxes, cylinders and cones. */
static pov_outline draw_solid(int kind, pov_vec3 centre, double size)
{
    pov_outline o = { .centre = centre, .round = kind != 1 };
    pov_vec3 frame[3];

    draw_frame(frame, size);
    for (int i = 0; i < 3 && kind != 1; i++)
        add_square(&o, frame[i], kind == 0 || i < 2 ? 1.0 : kind == 3 ? -0.25 : 0.0);
    if (o.round)
        o.constant = -1.0;
    if (kind == 3)
        o.linear = pov_scale(frame[2], 0.5);
    for (int i = kind == 1 ? 0 : 2; i < 3 && kind > 0; i++)
        add_slab(&o, frame[i]);
    return o;
}

typedef struct wide { long double x, y, z; } wide;
static wide wide_of(pov_vec3 v) { return (wide){ (long double)v.x, (long double)v.y, (long double)v.z }; }
static long double dot(wide a, wide b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static wide along(wide a, long double t, wide d) { return (wide){ a.x + t * d.x, a.y + t * d.y, a.z + t * d.z }; }

static wide times(const pov_outline *o, wide v)
{
    const double *s = o->square;
    const long double xx = (long double)s[0], yy = (long double)s[1], zz = (long double)s[2], xy = (long double)s[3], xz = (long double)s[4], yz = (long double)s[5];

    return (wide){ xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z };
}

/* How much of a segment is within: `ENTERS`: it starts outside. */
typedef enum contact { ENTERS, TOUCHES } contact;

static bool is_entry(long double first, long double last, contact w)
{
    return (w == ENTERS ? first > 0.0L : last > 0.0L) && first < 1.0L && first < last;
}

/* Does the segment from `at`, as the solid has it, enter the solid before its end, or is any of it within? */
static bool enters(const pov_outline *o, wide at, wide d, contact w)
{
    long double first = -1.0L / 0.0L, last = 1.0L / 0.0L;

    for (uint32_t i = 0; i < o->slabs; i++) {
        const wide n = wide_of(o->normal[i]);
        const long double a = ((long double)o->lo[i] - dot(n, at)) / dot(n, d), b = ((long double)o->hi[i] - dot(n, at)) / dot(n, d);

        first = fmaxl(first, fminl(a, b));
        last = fminl(last, fmaxl(a, b));
    }
    if (o->round) {
        const wide linear = wide_of(o->linear);
        const long double a = dot(times(o, d), d), b = dot(times(o, at), d) + dot(linear, d);
        const long double c = dot(times(o, at), at) + 2.0L * dot(linear, at) + (long double)o->constant, square = b * b - a * c;

        const long double less = (-b - sqrtl(square)) / a, more = (-b + sqrtl(square)) / a;

        if (a > 0.0L)
            return square > 0.0L && is_entry(fmaxl(first, less), fminl(last, more), w);
        return square > 0.0L ? is_entry(first, fminl(last, more), w) || is_entry(fmaxl(first, less), last, w) : is_entry(first, last, w);
    }
    return is_entry(first, last, w);
}

/* An area, from a point. */
typedef struct area { pov_vec3 from, to, axes[2]; } area;

static bool is_entered(const pov_outline *o, const area *a, double u, double v, contact w)
{
    const wide from = along(wide_of(a->from), -1.0L, wide_of(o->centre));

    return enters(o, from, along(along(wide_of(a->to), (long double)u, wide_of(a->axes[0])), (long double)v, wide_of(a->axes[1])), w);
}

static double within(const grid_part *p, int axis, int step) { return p->lo[axis] + (p->hi[axis] - p->lo[axis]) * step / 4; }

/* Is there a place of the part to which a segment enters, or not? */
static bool has_place(const pov_outline *o, const area *a, const grid_part *p, contact w, bool entered)
{
    for (int i = 0; i <= 4; i++)
        for (int k = 0; k <= 4; k++)
            if (is_entered(o, a, within(p, 0, i), within(p, 1, k), w) == entered)
                return true;
    return false;
}

static grid_part draw_part(void)
{
    const double broad = uniform(0.0, 0.3), high = uniform(0.0, 0.3), u = uniform(-0.5, 0.5 - broad), v = uniform(-0.5, 0.5 - high);

    return (grid_part){ { u, v }, { u + broad, v + high } };
}

static void what_is_said_to_be_hidden_is(void **state)
{
    long hidden = 0, said = 0;

    (void)state;
    for (int n = 0; n < 60000; n++) {
        const double size = pow(10.0, uniform(-6.0, 6.0)), far = pow(10.0, uniform(0.2, 3.0)) * size;
        const pov_vec3 centre = pov_scale(anywhere(1.0), n % 3 ? 0.0 : 10.0 * far);
        const pov_outline o = draw_solid(n % 4, centre, size);
        const pov_vec3 way = pov_scale(pov_unit(anywhere(1.0)), far);
        const area a = { pov_sub(centre, way), pov_scale(way, uniform(0.9, 4.0)), { pov_scale(anywhere(1.0), 4.0 * size), pov_scale(anywhere(1.0), 4.0 * size) } };
        const grid_part part = draw_part();
        area_cover c;
        const bool is_hidden = !has_place(&o, &a, &part, ENTERS, false);
        const bool is_said = area_cover_make(&c, &o, a.from, a.to, a.axes) && area_cover_hides(&c, &part);

        hidden += is_hidden;
        said += is_said;
        if (is_said && !is_hidden)
            fail_msg("solid %d of kind %d is said to hide a part that it does not", n, n % 4);
    }
    assert_true(hidden > 6000);
    assert_true(said > 0.9 * hidden);
}

/* Parts are small, as those of a grid are; some points are so near that they are within some slab, or its solid. */
static void what_is_said_to_pass_does(void **state)
{
    long passing = 0, said = 0;

    (void)state;
    for (int n = 0; n < 60000; n++) {
        const double size = pow(10.0, uniform(-6.0, 6.0)), far = pow(10.0, uniform(n % 7 ? 0.2 : -0.5, 2.0)) * size;
        const pov_vec3 centre = pov_scale(anywhere(1.0), n % 3 ? 0.0 : 10.0 * far);
        const pov_outline o = draw_solid(n % 4, centre, size);
        const pov_vec3 way = pov_scale(pov_unit(anywhere(1.0)), far);
        const area a = { pov_sub(centre, way), pov_scale(way, uniform(0.5, 4.0)), { pov_scale(anywhere(1.0), 4.0 * size), pov_scale(anywhere(1.0), 4.0 * size) } };
        const double u = uniform(-0.5, 0.45), v = uniform(-0.5, 0.45);
        const grid_part part = { { u, v }, { u + uniform(0.0, 0.05), v + uniform(0.0, 0.05) } };
        area_cover c;
        const bool passes = !has_place(&o, &a, &part, TOUCHES, true);
        const bool is_said = area_cover_make(&c, &o, a.from, a.to, a.axes) && area_cover_misses(&c, &part);

        passing += passes;
        said += is_said;
        if (is_said && !passes)
            fail_msg("solid %d of kind %d is said to be passed by what enters it", n, n % 4);
    }
    assert_true(passing > 6000);
    assert_true(said > 0.75 * passing);
}

/* When a segment from `at`, as the solid has it, leaves the solid; from within, or its surface. */
static long double exit_of(const pov_outline *o, wide at, wide d)
{
    const long double never = 1.0L / 0.0L;
    long double last = never;

    for (uint32_t i = 0; i < o->slabs; i++) {
        const wide n = wide_of(o->normal[i]);
        const long double rate = dot(n, d);

        last = fminl(last, ((long double)(rate > 0.0L ? o->hi[i] : o->lo[i]) - dot(n, at)) / rate);
    }
    if (o->round) {
        const wide linear = wide_of(o->linear);
        const long double a = dot(times(o, d), d), b = dot(times(o, at), d) + dot(linear, d);
        const long double c = dot(times(o, at), at) + 2.0L * dot(linear, at) + (long double)o->constant, square = b * b - a * c;

        last = fminl(last, a > 0.0L ? (-b + sqrtl(fmaxl(square, 0.0L))) / a : never);
    }
    return last;
}

static bool is_held(const pov_outline *o, const pov_outline *other, const area *a, const grid_part *p)
{
    const wide from = along(wide_of(a->from), -1.0L, wide_of(o->centre)), other_from = along(wide_of(a->from), -1.0L, wide_of(other->centre));

    for (int i = 0; i <= 4; i++)
        for (int k = 0; k <= 4; k++) {
            const wide d = along(along(wide_of(a->to), (long double)within(p, 0, i), wide_of(a->axes[0])), (long double)within(p, 1, k), wide_of(a->axes[1]));

            if (!(exit_of(other, other_from, d) < exit_of(o, from, d)))
                return false;
        }
    return true;
}

/* A place on the surface, of which the centre is within. */
static pov_vec3 draw_start(const pov_outline *o)
{
    const pov_vec3 d = pov_unit(anywhere(1.0));
    const wide zero = { 0.0L, 0.0L, 0.0L };

    return pov_add(o->centre, pov_scale(d, (double)exit_of(o, zero, wide_of(d))));
}

static void what_is_said_to_leave_another_solid_first_does(void **state)
{
    long held = 0, said = 0;

    (void)state;
    for (int n = 0; n < 60000; n++) {
        const double size = pow(10.0, uniform(-6.0, 6.0));
        const pov_vec3 centre = pov_scale(anywhere(1.0), n % 3 ? 0.0 : 10.0 * size);
        const pov_outline o = draw_solid(n % 4, centre, size);
        const pov_vec3 from = draw_start(&o);
        const pov_outline other = draw_solid(n / 4 % 4, pov_add(from, anywhere(0.1 * size)), 0.5 * size);
        const area a = { from, pov_scale(pov_unit(anywhere(1.0)), uniform(1.0, 4.0) * size), { anywhere(2.0 * size), anywhere(2.0 * size) } };
        const grid_part part = draw_part();
        area_cover c, clip;
        const bool is_true = is_held(&o, &other, &a, &part);
        const bool is_said = area_cover_make(&c, &o, a.from, a.to, a.axes) && area_cover_make(&clip, &other, a.from, a.to, a.axes) &&
                             area_cover_holds(&c, &clip, &part);

        held += is_true;
        said += is_said;
        if (is_said && !is_true)
            fail_msg("solid %d of kind %d is said to be left late", n, n % 4);
    }
    assert_true(held > 6000);
    assert_true(said > 0.1 * held);
}

static void nothing_is_told_from_within(void **state)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 }, to = { 5.0, 0.0, 0.0 }, axes[2] = { { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
    const grid_part part = { { -0.1, -0.1 }, { 0.1, 0.1 } };
    area_cover c;

    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        const pov_outline o = draw_solid(kind, zero, 1.0);

        assert_true(area_cover_make(&c, &o, zero, to, axes));
        assert_false(area_cover_hides(&c, &part));
        assert_false(area_cover_misses(&c, &part));
    }
}

static void parts_side_by_side_are_as_one_by_one(void **state)
{
    const pov_vec3 to = { 9.0, 0.0, 0.0 }, from = { -5.0, 0.0, 0.0 }, zero = { 0.0, 0.0, 0.0 }, axes[2] = { { 0.0, 9.0, 0.0 }, { 0.0, 0.0, 9.0 } };
    const pov_outline o = draw_solid(0, zero, 1.0);
    const grid_part other = { { -0.2, 0.0 }, { 0.1, 0.4 } };
    area_parts parts = { .count = AREA_PARTS };
    grid_part one[AREA_PARTS];
    area_cover c;
    uint64_t hides, passes, overlap;

    (void)state;
    assert_true(area_cover_make(&c, &o, from, to, axes));
    for (int i = 0; i < AREA_PARTS; i++) {
        one[i] = draw_part();
        for (int axis = 0; axis < 2; axis++) {
            parts.lo[axis][i] = one[i].lo[axis];
            parts.hi[axis][i] = one[i].hi[axis];
        }
    }
    hides = area_cover_hides_of(&c, &parts, ~(uint64_t)0);
    passes = area_cover_misses_of(&c, &parts, ~(uint64_t)0);
    overlap = area_parts_overlap(&parts, &other);
    for (int i = 0; i < AREA_PARTS; i++) {
        assert_int_equal(hides >> i & 1, area_cover_hides(&c, &one[i]));
        assert_int_equal(passes >> i & 1, area_cover_misses(&c, &one[i]));
        assert_int_equal(overlap >> i & 1, grid_parts_overlap(&one[i], &other));
    }
    assert_int_equal(area_cover_hides_of(&c, &parts, 0xff00ff00ff) ^ area_cover_misses_of(&c, &parts, 0xff00ff00ff), (hides ^ passes) & 0xff00ff00ff);
    assert_true(hides && ~hides && passes && ~passes && !(hides & passes) && overlap && ~overlap);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(what_is_said_to_be_hidden_is), cmocka_unit_test(what_is_said_to_pass_does),
                                        cmocka_unit_test(what_is_said_to_leave_another_solid_first_does), cmocka_unit_test(nothing_is_told_from_within),
                                        cmocka_unit_test(parts_side_by_side_are_as_one_by_one) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
