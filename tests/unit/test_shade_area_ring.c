/* What a ring is said to hide of an area light, each segment to it crosses, where the clip shows it; and what it is said to let pass, none. */
#include "shade/area_ring.h"
#include "support/check.h"

#include <math.h>

static uint64_t seed = 11;

static double uniform(double lo, double hi)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return lo + (hi - lo) * (double)(seed >> 11) * 0x1p-53;
}

static pov_vec3 anywhere(double size) { return pov_vec3_of(uniform(-size, size), uniform(-size, size), uniform(-size, size)); }

/* A ring in a space of its own, an area from a point, and a slab that clips, or one that is hollow, or none. */
typedef struct scene { double radii[2]; pov_own_map own; pov_vec3 from, to, axes[2]; pov_outline slab; bool clipped, hollowed; } scene;

static pov_vec3 turn(const scene *s, pov_vec3 v)
{
    const pov_vec3 *c = s->own.column;

    return pov_add(pov_add(pov_scale(c[0], v.x), pov_scale(c[1], v.y)), pov_scale(c[2], v.z));
}

static scene draw_scene(int n)
{
    const double size = pow(10.0, uniform(-3.0, 3.0)), far = pow(10.0, uniform(n % 7 ? 0.3 : -0.5, 1.5)) * size;
    const pov_vec3 way = pov_scale(pov_unit(anywhere(1.0)), far), centre = anywhere(n % 3 ? 0.0 : 10.0 * size), x = pov_unit(anywhere(1.0));
    const pov_vec3 y = pov_unit(pov_cross_product(x, anywhere(1.0))), z = pov_cross_product(x, y);
    scene s = { .radii = { uniform(0.5, 2.0), uniform(0.1, 0.5) }, .clipped = n % 2, .hollowed = n % 4 == 2 };

    s.own.anchor = centre;
    s.own.column[0] = pov_scale(pov_vec3_of(x.x, uniform(0.5, 1.5) * y.x, z.x), 1.0 / size);
    s.own.column[1] = pov_scale(pov_vec3_of(x.y, y.y, z.y), 1.0 / size);
    s.own.column[2] = pov_scale(pov_vec3_of(x.z, y.z, z.z), 1.0 / size);
    s.from = pov_add(pov_sub(centre, way), anywhere(size));
    s.to = pov_scale(way, uniform(0.5, 4.0));
    s.axes[0] = anywhere(4.0 * size);
    s.axes[1] = anywhere(4.0 * size);
    s.slab = (pov_outline){ .centre = centre, .normal = { pov_scale(n % 4 == 1 ? x : anywhere(1.0), 1.0 / size) }, .lo = { uniform(-3.0, 0.5) },
                            .hi = { uniform(0.6, 3.0) }, .slabs = 1 };
    return s;
}

/* How far outside of the ring a place along a segment is, and is it within the clip? */
static double height_at(const scene *s, pov_vec3 d, double t, bool *shown)
{
    const pov_vec3 w = pov_sub(pov_add(s->from, pov_scale(d, t)), s->own.anchor), p = pov_add(turn(s, w), s->own.from);
    const double across = sqrt(p.x * p.x + p.z * p.z) - s->radii[0], along = pov_dot(s->slab.normal[0], w);
    const bool within = along >= s->slab.lo[0] && along <= s->slab.hi[0];

    *shown = s->clipped ? within : !s->hollowed || !within;
    return sqrt(across * across + p.y * p.y) - s->radii[1];
}

/* Does the segment to a place cross the surface where it shows? From one place to the next, of its stretch around the ring. */
static bool crosses(const scene *s, double u, double v)
{
    enum { PLACES = 400 };
    const pov_vec3 d = pov_add(pov_add(s->to, pov_scale(s->axes[0], u)), pov_scale(s->axes[1], v));
    const pov_vec3 own = turn(s, d), from = pov_add(turn(s, pov_sub(s->from, s->own.anchor)), s->own.from);
    const double middle = -pov_dot(from, own) / pov_dot(own, own), half = 3.0 / sqrt(pov_dot(own, own));
    const double first = fmax(middle - half, 0.0), last = fmin(middle + half, 1.0);
    bool shown, was_shown;
    double before = height_at(s, d, first, &was_shown);

    for (int i = 1; i <= PLACES && first < last; i++) {
        const double now = height_at(s, d, first + (last - first) * i / PLACES, &shown);

        if ((before > 0.0) != (now > 0.0) && shown && was_shown)
            return true;
        before = now;
        was_shown = shown;
    }
    return false;
}

static bool has_place(const scene *s, const grid_part *p, bool crossed)
{
    for (int i = 0; i <= 2; i++)
        for (int k = 0; k <= 2; k++)
            if (crosses(s, p->lo[0] + (p->hi[0] - p->lo[0]) * i / 2, p->lo[1] + (p->hi[1] - p->lo[1]) * k / 2) == crossed)
                return true;
    return false;
}

static bool make(const scene *s, area_ring *r)
{
    area_cover slab;

    return area_cover_make(&slab, &s->slab, s->from, s->to, s->axes) &&
           area_ring_make(r, s->radii, &s->own, s->from, s->to, s->axes, s->clipped ? &slab : NULL, s->hollowed ? &slab : NULL);
}

static void what_is_said_of_a_ring_is_so(void **state)
{
    long hides = 0, passes = 0, said_hidden = 0, said_passed = 0;

    (void)state;
    for (int n = 0; n < 12000; n++) {
        const scene s = draw_scene(n);
        const double u = uniform(-0.5, 0.45), v = uniform(-0.5, 0.45);
        const grid_part part = { { u, v }, { u + uniform(0.0, 0.05), v + uniform(0.0, 0.05) } };
        const bool is_hidden = !has_place(&s, &part, false), is_passed = !has_place(&s, &part, true);
        area_ring r;
        bool hidden;

        if (!make(&s, &r))
            fail_msg("nothing can be told of scene %d", n);
        if (area_ring_misses(&r, &part, &hidden)) {
            said_passed++;
            if (!is_passed || hidden)
                fail_msg("ring %d is said to be passed by what crosses it", n);
        }
        if (hidden && !is_hidden)
            fail_msg("ring %d is said to hide a part that it does not", n);
        hides += is_hidden;
        passes += is_passed;
        said_hidden += hidden;
    }
    assert_true(hides > 1000);
    assert_true(said_hidden > 0.6 * hides);
    assert_true(said_passed > 0.7 * passes);
}

/* A clip that touches the ring cuts nothing off. */
static void a_clip_that_holds_the_ring_cuts_nothing(void **state)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 }, from = { 1.0, -5.0, 0.0 }, to = { 0.0, 10.0, 0.0 }, axes[2] = { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } };
    const double radii[2] = { 1.0, 0.3 };
    const pov_own_map same = { zero, { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } }, zero };
    const pov_outline box = { .centre = zero, .normal = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } }, .lo = { -1.3, -0.3, -1.3 },
                              .hi = { 1.3, 0.3, 1.3 }, .slabs = 3 };
    const grid_part part = { { -0.1, -0.1 }, { 0.1, 0.1 } };
    area_cover clip;
    area_ring r;
    bool hidden;

    (void)state;
    assert_true(area_cover_make(&clip, &box, from, to, axes));
    assert_true(area_ring_make(&r, radii, &same, from, to, axes, &clip, NULL));
    assert_int_equal(r.cuts, 0);
    assert_false(area_ring_misses(&r, &part, &hidden));
    assert_true(hidden);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_said_of_a_ring_is_so),
        cmocka_unit_test(a_clip_that_holds_the_ring_cuts_nothing),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
