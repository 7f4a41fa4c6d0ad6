/* test_narrow.c - shapes that are turned, stretched and moved, their rays in packets: what narrow() leaves out, lets light end at
 * or bounds must be what each ray finds by itself without filters, bit for bit. Rays start far away, near the shapes and on them.
 * Without arguments a short run; test_narrow RAYS for a long one. */
#include "numerics/font.h"
#include "numerics/sides.h"

#include "support/fake_reader.h"

#include <stdlib.h>
#include <string.h>

enum { SHAPES = 4, RAYS_OF_A_SCENE = 1024 };

#define U families_uniform

static long rays = 40000;

typedef struct scene {
    model model;
    side filtered, plain;
    double size;
    kept of[8];                  /* rays by octant */
} scene;
typedef struct tally { long rays, hits, dark; } tally;

static pov_vec3 anywhere(double size) { return pov_vec3_of(size * (2.0 * U() - 1.0), size * (2.0 * U() - 1.0), size * (2.0 * U() - 1.0)); }

/* Random shapes of a size, as numbers and words between their braces. */
typedef void shape_maker(pov_reader *in, double size);

static void add_number(pov_reader *in, double value)
{
    fake_reader_number(in, value);
    fake_reader_word(in, ",");
}

static void add_point(pov_reader *in, double x, double y)
{
    fake_reader_word(in, ",");
    fake_reader_word(in, "<");
    add_number(in, x);
    fake_reader_number(in, y);
    fake_reader_word(in, ">");
}

static void make_torus(pov_reader *in, double size)
{
    const double major = size * (0.1 + U());

    add_number(in, major);
    fake_reader_number(in, U() < 0.2 ? size * (0.1 + U()) : major * (U() < 0.2 ? 1e-3 : U()));
}

/* A star of three to nine points; one with a hole, now and then. Splines have points that steer them before it and behind. */
static void make_sweep(pov_reader *in, double size, double low, double high)
{
    static const char *const words[] = { "linear_spline", "quadratic_spline", "cubic_spline" };
    const uint32_t spline = (uint32_t)(3.0 * U()), before = spline > 0, behind = spline > 1, rings = spline == 0 && U() < 0.5 ? 2 : 1;
    const uint32_t corners = 3 + (uint32_t)(7.0 * U());

    fake_reader_word(in, words[spline]);
    add_number(in, low);
    add_number(in, high);
    fake_reader_number(in, rings * (corners + 1) + before + behind);
    for (uint32_t ring = 0; ring < rings; ring++) {
        double at[16][2];

        for (uint32_t i = 0; i < corners; i++) {
            const double turn = 6.283185307179586 * (i + 0.5 * U()) / corners, reach = size * (0.4 + 0.6 * U()) * (ring ? 0.3 : 1.0);

            at[i][0] = reach * cos(turn);
            at[i][1] = reach * sin(turn);
        }
        for (uint32_t i = 0; i < corners + 1 + before + behind; i++) {
            const uint32_t k = (i + corners - before) % corners;

            add_point(in, at[k][0], at[k][1]);
        }
    }
    if (U() < 0.3)
        fake_reader_word(in, "open");
}

static void make_prism(pov_reader *in, double size) { make_sweep(in, size, -size * U(), size * U()); }

/* Its outline is as wide as the size at a height of that. */
static void make_cone(pov_reader *in, double size)
{
    const double low = size * (U() < 0.2 ? 1e-4 : 0.05 + 0.6 * U()), sign = U() < 0.5 ? -1.0 : 1.0;

    fake_reader_word(in, "conic_sweep");
    make_sweep(in, 1.0, sign * low, sign * (low + size * U()));
}

static void make_lathe(pov_reader *in, double size)
{
    const uint32_t points = 2 + (uint32_t)(6.0 * U());
    double y = 0.0;

    fake_reader_word(in, "linear_spline");
    fake_reader_number(in, points);
    for (uint32_t i = 0; i < points; i++) {
        add_point(in, U() < 0.2 ? 0.0 : size * U(), y);
        y = U() < 0.2 ? y : size * (2.0 * U() - 1.0);
    }
}

static void make_sor(pov_reader *in, double size)
{
    const uint32_t points = 4 + (uint32_t)(4.0 * U());
    double y = -size;

    fake_reader_number(in, points);
    for (uint32_t i = 0; i < points; i++) {
        add_point(in, size * (0.05 + U()), y);
        y += size * (0.01 + 0.7 * U());
    }
    if (U() < 0.3)
        fake_reader_word(in, "open");
}

static void make_ovus(pov_reader *in, double size)
{
    const double bottom = size * (0.2 + U());

    add_number(in, bottom);
    fake_reader_number(in, bottom * (0.05 + 2.2 * U()));
}

/* Its terms are of one size where the shape is. */
static void make_cubic(pov_reader *in, double size)
{
    fake_reader_word(in, "<");
    for (int i = 3; i >= 0; i--)
        for (int j = 3 - i; j >= 0; j--)
            for (int k = 3 - i - j; k >= 0; k--) {
                fake_reader_number(in, U() < 0.3 ? 0.0 : (2.0 * U() - 1.0) * pow(size, -(i + j + k)));
                fake_reader_word(in, i + j + k > 0 ? "," : ">");
            }
}

/* The same; every other one is finite. */
static void make_quartic(pov_reader *in, double size)
{
    const bool finite = U() < 0.5;

    fake_reader_word(in, "<");
    for (int i = 4; i >= 0; i--)
        for (int j = 4 - i; j >= 0; j--)
            for (int k = 4 - i - j; k >= 0; k--) {
                const bool highest = i + j + k == 4, own = i == 4 || j == 4 || k == 4;
                const double c = finite && highest ? own ? 1.0 + U() : 0.2 * U() : U() < 0.3 ? 0.0 : 2.0 * U() - 1.0;

                fake_reader_number(in, c * pow(size, -(i + j + k)));
                fake_reader_word(in, i + j + k > 0 ? "," : ">");
            }
}

static void add_corner(pov_reader *in, double least, double size)
{
    fake_reader_word(in, "<");
    for (int i = 0; i < 3; i++) {
        fake_reader_number(in, least + size * U());
        fake_reader_word(in, i < 2 ? "," : ">");
    }
}

static void make_sphere(pov_reader *in, double size)
{
    add_corner(in, 0.0, 0.3 * size);
    fake_reader_word(in, ",");
    fake_reader_number(in, size * (0.5 + U()));
}

static void make_box(pov_reader *in, double size)
{
    add_corner(in, -size, 0.8 * size);
    fake_reader_word(in, ",");
    add_corner(in, 0.2 * size, size);
}

/* Some glyphs of a font of one, whose outline is drawn by chance: of no size but its own. */
static void make_text(pov_reader *in, double size)
{
    static font one;

    (void)size;
    font_make(&one, U);
    fake_reader_file(in, one.bytes, one.size);
    fake_reader_text(in, U() < 0.3 ? "ttf font A" : "ttf font AAAAA");
    fake_reader_number(in, 0.1 + U());
    fake_reader_number(in, 0.0);
}

enum { CLIPPED = 5, QUARTIC, CONIC, TEXT, MAKERS, ROUND = MAKERS, BLOCK };
static const struct { const char *keyword; shape_maker *make; } kinds[] = {
    { "torus", make_torus }, { "prism", make_prism }, { "lathe", make_lathe }, { "sor", make_sor }, { "ovus", make_ovus },
    { "cubic", make_cubic }, { "quartic", make_quartic }, { "prism", make_cone }, { "text", make_text },
    { "sphere", make_sphere }, { "box", make_box },
};

static node_ref add(scene *s, pov_reader *in, uint32_t which, const transform *t)
{
    const shape_class *shape = fake_reader_shape(kinds[which].keyword);
    void *self = fake_reader_memory(in, shape->instance_size);

    fake_reader_clear(in);
    kinds[which].make(in, s->size);
    if (!fake_reader_parse_into(in, shape, self)) {
        char text[4096];

        fake_reader_print(in, text, sizeof text);
        fail_msg("%s { %s: %s", kinds[which].keyword, text, fake_reader_message(in));
    }
    return test_add(&s->model, shape, self, t, 0, 0);
}

/* What clips it moves with it, or does not turn. */
static void add_clipped(scene *s, pov_reader *in, uint32_t which, const transform *t)
{
    group_node all = { .op = NODE_CLIP, .line = 1, .column = 1 };
    const node_ref children[2] = { add(s, in, which, t), add(s, in, U() < 0.5 ? ROUND : BLOCK, U() < 0.7 ? t : NULL) };
    node_ref root;

    assert_true(model_add_group(&s->model, &all, children, 2, &root));
    assert_true(model_add_tree(&s->model, root));
}

static void add_shape(scene *s, pov_reader *in, uint32_t which)
{
    const double em = 0.5 * s->size;
    const transform *t = which == TEXT ? test_transform(&s->model, NULL, TRANSFORM_SCALE, em, em, em) : NULL;

    if (U() < 0.4)
        t = test_transform(&s->model, t, TRANSFORM_SCALE, 0.2 + U(), 0.2 + U(), 0.2 + U());
    t = test_transform(&s->model, t, TRANSFORM_ROTATE, 360.0 * U(), 360.0 * U(), 360.0 * U());
    t = test_transform(&s->model, t, TRANSFORM_TRANSLATE, s->size * U(), s->size * U(), s->size * U());
    if (which == CLIPPED || (which == QUARTIC && U() < 0.5))
        add_clipped(s, in, which, t);
    else
        add(s, in, which, t);
}

static void compare(const scene *s, const kept *of, uint32_t first, uint32_t n, tally *out)
{
    const double most = of->truth[first].object == POV_NO_OWNER ? HUGE_VAL : of->truth[first].crossing.t * (1.0 + U());
    hit hits[WORLD_MANY];

    out->dark += side_compare(&s->filtered, &s->plain, of, first, n, most, hits);
}

/* Ask a ray by itself, and with others of its octant as soon as these make a packet. */
static bool ask(scene *s, const pov_ray *ray, hit *h, tally *out)
{
    const bool met = test_nearest(s->plain.world, s->plain.context, ray, HUGE_VAL, h);
    kept *of = &s->of[bvh_octant(ray)];

    out->rays++;
    out->hits += met;
    if (side_keep(of, ray, h, met)) {
        compare(s, of, 0, WORLD_MANY, out);
        compare(s, of, 30, 11, out);
    }
    return met;
}

static void ask_all(scene *s, tally *out)
{
    for (int i = 0; i < RAYS_OF_A_SCENE; i++) {
        const pov_vec3 target = anywhere(s->size);
        pov_ray ray = side_ray(target, families_direction(), s->size);
        hit h;

        for (int turn = 0; turn < 4 && ask(s, &ray, &h, out); turn++) {
            world_surface(s->plain.world, &ray, &h);
            ray.org = h.point;
            ray.org_lo = h.point_lo;
            ray.dir = turn % 2 ? ray.dir : families_direction();
            memset(&ray.dir_lo, 0, sizeof ray.dir_lo);
            test_leave(&ray, &h);
        }
    }
}

static void ask_kind(uint32_t which)
{
    static const double sizes[] = { 1.0, 1e-6, 1e9 };
    tally all = { 0, 0, 0 };

    families_seed(20261126);
    for (int round = 0; all.rays < rays; round++) {
        pov_reader *in = fake_reader_create();
        scene s;

        memset(&s, 0, sizeof s);
        test_model_init(&s.model, NULL);
        s.size = sizes[round % 3];
        for (int i = 0; i < SHAPES; i++)
            add_shape(&s, in, which);
        side_compile(&s.filtered, &s.model, POV_ACCEL_TREE, false);
        side_compile(&s.plain, &s.model, POV_ACCEL_NONE, false);
        ask_all(&s, &all);
        side_discard(&s.filtered);
        side_discard(&s.plain);
        model_free(&s.model);
        fake_reader_destroy(in);
    }
    print_message("%s: %ld rays, %ld hits, %ld dark\n", kinds[which].keyword, all.rays, all.hits, all.dark);
    assert_true(all.hits > rays / 8 && all.dark > rays / 10);
}

static void filters_find_what_rays_find_alone(void **state)
{
    (void)state;
    for (uint32_t which = 0; which < MAKERS; which++)
        if (fake_reader_shape(kinds[which].keyword))
            ask_kind(which);
}

static void make_square(pov_reader *in, double size)
{
    add_number(in, -size);
    add_number(in, size);
    fake_reader_number(in, 5);
    for (int i = 0; i < 5; i++)
        add_point(in, i % 4 < 2 ? size : -size, i % 4 == 1 || i % 4 == 2 ? size : -size);
}

/* A square prism, from -1 to 1 across and from -2 to 2 along its sweep. */
static void begin_sweep(scene *s, pov_reader *in)
{
    const shape_class *shape = fake_reader_shape("prism");
    void *self = fake_reader_memory(in, shape->instance_size);

    memset(s, 0, sizeof *s);
    s->size = 1.0;
    test_model_init(&s->model, NULL);
    make_square(in, 1.0);
    assert_true(fake_reader_parse_into(in, shape, self));
    test_add(&s->model, shape, self, test_transform(&s->model, NULL, TRANSFORM_SCALE, 1.0, 2.0, 1.0), 0, 0);
    side_compile(&s->filtered, &s->model, POV_ACCEL_TREE, false);
    side_compile(&s->plain, &s->model, POV_ACCEL_NONE, false);
}

static void end_sweep(scene *s, pov_reader *in)
{
    side_discard(&s->filtered);
    side_discard(&s->plain);
    model_free(&s->model);
    fake_reader_destroy(in);
}

/* Of eight rays at its box half go straight along the sweep: in the plane of the outline they are points. */
static void rays_along_a_sweep_leave_others_as_they_are(void **state)
{
    pov_reader *in = fake_reader_create();
    tally out = { 0, 0, 0 };
    scene s;

    (void)state;
    begin_sweep(&s, in);
    for (int i = 0; i < WORLD_MANY; i++) {
        const double off = 0.01 * i;
        pov_ray ray = { .org = { -3.0, 2.5 - off, -0.2 }, .dir = { 1.0, -0.5, 0.1 }, .origin_surface = POV_NO_OWNER };
        hit h;

        if (i % 8 >= 4) {
            ray.org = pov_vec3_of(0.5 - off, 9.0, 0.5);
            ray.dir = pov_vec3_of(0.0, -1.0, 0.0);
        }
        ask(&s, &ray, &h, &out);
    }
    assert_int_equal(out.hits, WORLD_MANY);
    end_sweep(&s, in);
}

/* Rays from a plane above a cap down to the cap's plane or a little farther, or from that plane upward. */
static void compare_at_cap(const scene *s, double from, double rise, double most)
{
    static kept of;
    hit hits[WORLD_MANY];

    for (uint32_t i = 0; i < WORLD_MANY; i++) {
        pov_ray *ray = &of.rays[i];

        memset(ray, 0, sizeof *ray);
        ray->org = pov_vec3_of(0.01 * i - 0.3, from, 0.005 * i);
        ray->dir = pov_vec3_of(0.0625, rise, 0.03125);
        ray->origin_surface = POV_NO_OWNER;
        if (!test_nearest(s->plain.world, s->plain.context, ray, HUGE_VAL, &of.truth[i]))
            of.truth[i].object = POV_NO_OWNER;
    }
    side_compare(&s->filtered, &s->plain, &of, 0, WORLD_MANY, most, hits);
}

/* There it takes the exact distance of the plane to tell. */
static void rays_that_end_or_begin_in_the_plane_of_a_cap_are_left_open(void **state)
{
    pov_reader *in = fake_reader_create();
    scene s;

    (void)state;
    begin_sweep(&s, in);
    compare_at_cap(&s, 3.0, -1.0, 1.0);
    compare_at_cap(&s, 3.0, -1.0, 1.0 + 0x1p-50);
    compare_at_cap(&s, 2.0, 1.0, HUGE_VAL);
    end_sweep(&s, in);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(filters_find_what_rays_find_alone),
        cmocka_unit_test(rays_along_a_sweep_leave_others_as_they_are),
        cmocka_unit_test(rays_that_end_or_begin_in_the_plane_of_a_cap_are_left_open),
    };

    if (argc > 1)
        rays = strtol(argv[1], NULL, 10);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
