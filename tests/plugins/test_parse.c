/* What the primitives read, warn of and refuse: the rules of docs/language.md. */
#include "support/check.h"
#include "support/fake_reader.h"

#include <math.h>
#include <string.h>

typedef struct wanted { const char *keyword, *text; int warnings; const char *message; } wanted;

static void hold(const wanted *table, size_t count)
{
    size_t i;

    for (i = 0; i < count; i++) {
        const shape_class *shape = fake_reader_shape(table[i].keyword);
        pov_reader *in = fake_reader_create();
        void *self;

        assert_non_null(shape);
        fake_reader_text(in, table[i].text);
        self = fake_reader_parse(in, shape);
        if ((self != NULL) != (table[i].message == NULL) || fake_reader_warnings(in) != table[i].warnings
            || (table[i].message && !strstr(fake_reader_message(in), table[i].message)))
            fail_msg("%s { %s }: %d warnings, \"%s\"", table[i].keyword, table[i].text, fake_reader_warnings(in),
                     fake_reader_message(in));
        fake_reader_destroy(in);
    }
}

static void what_the_language_allows_is_read(void **state)
{
    static const wanted table[] = {
        { "sphere", "<1, 2, 3>, 4", 0, NULL },
        { "sphere", "<1 2 3> 4", 0, NULL },
        { "sphere", "0, 1", 0, NULL },
        { "sphere", "2", 1, NULL },
        { "sphere", "<0, 0, 0>, -1", 1, NULL },
        { "box", "<1, 1, 1>, <-1, -1, -1>", 0, NULL },
        { "box", "-1, 1", 0, NULL },
        { "cylinder", "<0, 0, 0>, <0, 1, 0>, 1", 0, NULL },
        { "cylinder", "<0, 0, 0>, <0, 1, 0>, -1 open", 1, NULL },
        { "cone", "<0, 0, 0>, 1, <0, 1, 0>, 0 open", 0, NULL },
        { "cone", "<0, 0, 0>, -1, <0, 1, 0>, -2", 2, NULL },
        { "quadric", "<1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -1", 0, NULL },
        { "quadric", "1, 0, 0, -1", 0, NULL },
        { "polygon", "4, <0, 0, 0>, <1, 0, 0>, <0, 1, 0>, <0, 0, 0>", 0, NULL },
        { "polygon", "3, <0, 0, 0>, <1, 0, 0>, <0, 1, 0>", 1, NULL },
        { "polygon", "4, <0, 0, 0>, <1, 1, 1>, <2, 2, 2>, <0, 0, 0>", 1, NULL },
        { "prism", "0, 1, 3, <0,0>, <1,0>, <0,1>", 1, NULL },
        { "prism", "0, 1, 4.5, <0,0>, <1,0>, <0,1>, <0,0>", 0, NULL },
        { "prism", "bezier_spline 0, 1, 4, <0,0>, <1,0>, <0,1>, <0,0>", 0, NULL },
        { "prism", "bezier_spline 0, 1, 8, <0,0>, <1,0>, <0,1>, <0,0>, <0,0>, <1,0>, <0,1>, <1,1>", 1, NULL },
        { "prism", "quadratic_spline 0, 1, 5, <0,0>, <1,0>, <0,1>, <1,1>, <1,0>", 0, NULL },
        { "prism", "cubic_spline 0, 1, 6, <0,0>, <1,0>, <0,1>, <1,1>, <1,0>, <0,0>", 0, NULL },
        { "sor", "4, <0,9>, <.5,.2>, <.5,.5>, <.3,-4>", 0, NULL },
        { "sphere_sweep", "linear_spline, 2, 0, 1, <1,0,0>, 1", 0, NULL },
        { "blob", "threshold .5 sphere { 0, 0, 1 }", 0, NULL },
        { "disc", "<0, 0, 0>, <0, 1, 0>, 1", 0, NULL },
        { "disc", "<0, 0, 0> <0, 1, 0> -1 .5", 1, NULL },
        { "disc", "0, 0, 1", 1, NULL },
        { "disc", "0, <0, 1, 0>, 1, 2", 1, NULL },
        { "triangle", "<0, 0, 0> <1, 0, 0> <0, 1, 0>", 0, NULL },
        { "triangle", "<0, 0, 0>, <1, 1, 1>, <2, 2, 2>", 1, NULL },
        { "smooth_triangle", "<0, 0, 0>, <0, 0, 1>, <1, 0, 0>, <0, 1, 1>, <0, 1, 0>, <0, 0, 1>", 0, NULL },
        { "mesh", "triangle { <0,0,0>, <1,0,0>, <0,1,0> uv_vectors <0,0>, <1,0>, <0,1> texture { 0 } }", 0, NULL },
        { "mesh", "triangle { <0,0,0>, <1,0,0>, <2,0,0> } triangle { <0,0,0>, <1,0,0>, <0,1,0> texture_list { "
                  "texture { 0 } texture { 1 } texture { 0 } } } inside_vector <0, 1, 0>", 1, NULL },
        { "mesh2", "vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0>, } face_indices { 1, <0,1,2> }", 0, NULL },
        { "mesh2", "vertex_vectors { 3 <0,0,0> <1,0,0> <0,1,0> } texture_list { 2, texture { 0 }, texture { 1 } } "
                   "face_indices { 2 <0,1,2> 1, <0,1,2>, 0, 1, 0 } normal_vectors { 1, <0,0,1> } "
                   "normal_indices { 2, <0,0,0>, <0,0,0> }", 0, NULL },
    };

    (void)state;
    hold(table, sizeof table / sizeof *table);
}

static void what_makes_no_shape_is_refused(void **state)
{
    static const wanted table[] = {
        { "sphere", "", 0, "expected" },
        { "sphere", "<1, 2>, 3", 0, "expected" },
        { "box", "<1, 2, 3>", 0, "expected" },
        { "cylinder", "<1, 2, 3>, <1, 2, 3>, 1", 0, "two different ends" },
        { "cone", "<1, 2, 3>, 1, <1, 2, 3>, 0", 0, "two different ends" },
        { "polygon", "2, <0, 0, 0>, <1, 0, 0>", 0, "at least 3 points" },
        { "prism", "quadratic_spline 0, 1, 5, <0,0>, <1,0>, <0,1>, <1,1>, <1,.1>", 0, "not closed" },
        { "prism", "cubic_spline 0, 1, 5, <0,0>, <1,0>, <0,1>, <1,0>, <0,1>", 0, "at least 6" },
        { "sor", "4, <0,.5>, <.5,.2>, <.5,.5>, <.3,.9>", 0, "heights that rise" },
        { "blob", "threshold .5 sphere { 0, 1 }", 0, "expected" },
        { "blob", "threshold .5 cylinder { 0, 0, 1, 1 }", 0, "two different ends" },
        { "mesh", "", 0, "no triangles" },
        { "mesh", "triangle { <0,0,0>, <1,0,0>, <2,0,0> }", 1, "no triangles" },
        { "mesh", "triangle { <0,0,0>, <1,0,0> }", 0, "expected" },
        { "mesh2", "vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> }", 0, "needs face_indices" },
        { "mesh2", "face_indices { 1, <0,1,2> }", 0, "needs vertex_vectors" },
        { "mesh2", "vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } face_indices { 1, <0,1,3> }", 0, "out of range" },
        { "mesh2", "vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } face_indices { 1, <0,-1,2> }", 0, "out of range" },
        { "mesh2", "vertex_vectors { 4, <0,0,0>, <1,0,0>, <0,1,0> } face_indices { 1, <0,1,2> }", 0, "expected" },
        { "mesh2", "vertex_vectors { 1e99, <0,0,0> } face_indices { 1, <0,1,2> }", 0, "whole number" },
        { "mesh2", "vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } normal_vectors { 1, <0,0,1> } "
                   "face_indices { 1, <0,1,2> }", 0, "normal indices are missing" },
        { "mesh2", "vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } face_indices { 1, <0,1,2> } normal_indices { 1, <0,1,2> }", 0,
                   "there are normal indices, but no normal vectors" },
        { "mesh2", "vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } face_indices { 1, <0,1,2> } uv_indices { 1, <0,1,2> }", 0,
                   "there are uv indices, but no uv vectors" },
        { "mesh2", "vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } texture_list { 1, texture { 0 } } "
                   "face_indices { 1, <0,1,2>, 1 }", 0, "no number 1" },
        { "polygon", "3.5, <0, 0, 0>, <1, 0, 0>, <0, 1, 0>", 0, "whole number" },
        { "polygon", "4, <0, 0, 0>, <1, 0, 0>, <0, 1, 0>", 0, "expected" },
        { "polygon", "3, <0, 0, 0>, <1, 0, 0>, <0, 0, 0>", 0, "at least 3 points" },
        { "polygon", "5, <0, 0, 0>, <1, 0, 0>, <1, 1, .1>, <0, 1, 0>, <0, 0, 0>", 0, "in a plane" },
        { "polygon", "5, <0, 0, 0>, <1e-6, 0, 0>, <1e-6, 1e-6, 1e-8>, <0, 1e-6, 0>, <0, 0, 0>", 0, "in a plane" },
    };

    (void)state;
    hold(table, sizeof table / sizeof *table);
}

/* A figure that was turned in space and rounded to doubles is as flat as a figure can be. */
static void a_polygon_may_be_off_its_plane_by_rounding(void **state)
{
    const shape_class *shape = fake_reader_shape("polygon");
    const double places[] = { 0.0, 1.0, 1e3, 1e6, 1e9 };
    pov_reader *in = fake_reader_create();
    size_t p;
    int turn, i;

    (void)state;
    for (p = 0; p < sizeof places / sizeof *places; p++) {
        for (turn = 0; turn < 200; turn++) {
            const double a = 0.1 * turn, b = 0.37 * turn;

            fake_reader_clear(in);
            fake_reader_number(in, 9.0);
            for (i = 0; i < 9; i++) {
                const double angle = 0.785398163397448 * (i % 8), x = cos(angle), y = sin(angle);

                fake_reader_word(in, "<");
                fake_reader_number(in, places[p] + x * cos(a) - y * sin(a) * cos(b));
                fake_reader_number(in, places[p] + x * sin(a) + y * cos(a) * cos(b));
                fake_reader_number(in, y * sin(b) - places[p]);
                fake_reader_word(in, ">");
            }
            if (!fake_reader_parse(in, shape))
                fail_msg("at %g, turned by %g: %s", places[p], a, fake_reader_message(in));
        }
    }
    fake_reader_destroy(in);
}

/* The text of a shape in the order of its class. */
static const void *reordered(pov_reader *in, const char *keyword, const char *text, size_t *size)
{
    shape_class as_written = *fake_reader_shape(keyword);
    void *self;

    as_written.prepare = NULL;
    *size = as_written.instance_size = as_written.parsed_size;
    fake_reader_clear(in);
    fake_reader_text(in, text);
    self = fake_reader_parse(in, &as_written);
    assert_non_null(self);
    as_written.reorder(self);
    return self;
}

static void ends_may_be_written_either_way(void **state)
{
    static const struct { const char *keyword, *one, *other; bool same; } table[] = {
        { "cylinder", "<1, 2, 3>, <4, 5, 6>, 1", "<4, 5, 6>, <1, 2, 3>, 1", true },
        { "cylinder", "<1, 2, 3>, <1, 2, -3>, 1 open", "<1, 2, -3>, <1, 2, 3>, 1 open", true },
        { "cylinder", "<1, 2, 3>, <4, 5, 6>, 1", "<4, 5, 6>, <1, 2, 3>, 1 open", false },
        { "cylinder", "<1, 2, 3>, <4, 5, 6>, 1", "<4, 5, 3>, <1, 2, 6>, 1", false },
        { "cone", "<1, 2, 3>, 1, <4, 5, 6>, 2", "<4, 5, 6>, 2, <1, 2, 3>, 1", true },
        { "cone", "<1, 2, 3>, 0, <1, 5, 3>, 2", "<1, 5, 3>, 2, <1, 2, 3>, 0", true },
        { "cone", "<1, 2, 3>, 1, <4, 5, 6>, 2", "<4, 5, 6>, 1, <1, 2, 3>, 2", false },
    };
    pov_reader *in = fake_reader_create();

    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        size_t size;
        const void *one = reordered(in, table[i].keyword, table[i].one, &size);
        const void *other = reordered(in, table[i].keyword, table[i].other, &size);

        assert_int_equal(memcmp(one, other, size) == 0, table[i].same);
    }
    fake_reader_destroy(in);
}

static void corners_in_one_place_are_bounded_by_it(void **state)
{
    static const wanted table[] = { { "triangle", "<3, 4, 5>, <3, 4, 5>, <3, 4, 5>", 1, NULL },
                                    { "smooth_triangle", "<3, 4, 5>, <1, 0, 0>, <3, 4, 5>, <0, 1, 0>, <3, 4, 5>, <0, 0, 1>", 1, NULL } };

    (void)state;
    for (int i = 0; i < 2; i++) {
        const shape_class *shape = fake_reader_shape(table[i].keyword);
        pov_reader *in = fake_reader_create();
        pov_box box;
        void *self;

        fake_reader_text(in, table[i].text);
        self = fake_reader_parse(in, shape);
        assert_non_null(self);
        assert_true(shape->bounds(self, &box));
        assert_true(box.lo.x == 3.0 && box.hi.x == 3.0 && box.lo.y == 4.0 && box.hi.y == 4.0 && box.lo.z == 5.0 && box.hi.z == 5.0);
        fake_reader_destroy(in);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_the_language_allows_is_read),
        cmocka_unit_test(what_makes_no_shape_is_refused),
        cmocka_unit_test(a_polygon_may_be_off_its_plane_by_rounding),
        cmocka_unit_test(ends_may_be_written_either_way),
        cmocka_unit_test(corners_in_one_place_are_bounded_by_it),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
