/* Scenes from arrays: bit for bit those of their texts, and errors of bad arguments. */
#include "support/builders.h"
#include "support/check.h"
#include "support/failing.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COUNT = 40, BYTES = BUILT_NUMBERS * (int)sizeof(float) };

static const char head[] = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                           "#include \"colors.inc\"\n"
                           "camera { location <0, 1, -6> look_at 0 } light_source { <5, 9, -7> rgb 1 }\n"
                           "#declare Shiny = finish { phong .8 reflection .2 };\n";
static const char tail[] = "plane { y, -2 pigment { checker rgb 1, Red } }\n";

/* Materials that are read in different ways: constant, moved with the object, clipped, none. */
static const char *const materials[] = {
    "pigment { rgb <.9, .3, .2> } finish { Shiny }",
    "texture { pigment { granite scale .3 } } rotate 30*y translate .1*x no_shadow",
    "pigment { Green } clipped_by { sphere { 0, 1.5 } }",
    "texture { pigment { rgbt .8 } finish { Shiny } } interior { ior 1.3 }",
    "",
};

typedef struct values { pov_vec3 a[3 * COUNT], b[3 * COUNT]; double r[COUNT], s[COUNT]; } values;

static void fill(values *v)
{
    uint32_t state = 7;

    for (int i = 0; i < 3 * COUNT; i++) {
        v->a[i] = pov_vec3_of(4.0 * built_next(&state) - 2.0, 3.0 * built_next(&state) - 1.5, 4.0 * built_next(&state) - 2.0);
        v->b[i] = pov_add(v->a[i], pov_vec3_of(0.9 * built_next(&state), 0.1 + 0.9 * built_next(&state), 0.9 * built_next(&state)));
    }
    for (int i = 0; i < COUNT; i++) {
        v->r[i] = 0.1 + 0.3 * built_next(&state);
        v->s[i] = 0.1 + 0.3 * built_next(&state);
    }
}

/* ---- the equivalent text ---- */

static void put_vector(built_text *t, pov_vec3 v, const char *behind) { built_put(t, "<%.17g, %.17g, %.17g>%s", v.x, v.y, v.z, behind); }
static void put_number(built_text *t, double v, const char *behind) { built_put(t, "%.17g%s", v, behind); }

typedef struct kind {
    const char *word;
    void (*put)(built_text *t, const values *v, int i);
    pov_status (*add)(pov_builder *b, const values *v, size_t count, uint32_t material, pov_error *err);
} kind;

static void put_sphere(built_text *t, const values *v, int i)
{
    put_vector(t, v->a[i], ", ");
    put_number(t, v->r[i], " ");
}

static pov_status add_spheres(pov_builder *b, const values *v, size_t count, uint32_t material, pov_error *err)
{
    return pov_builder_add_spheres(b, count, v->a, v->r, material, err);
}

static void put_cylinder(built_text *t, const values *v, int i)
{
    put_vector(t, v->a[i], ", ");
    put_vector(t, v->b[i], ", ");
    put_number(t, v->r[i], " ");
}

static pov_status add_cylinders(pov_builder *b, const values *v, size_t count, uint32_t material, pov_error *err)
{
    return pov_builder_add_cylinders(b, count, v->a, v->b, v->r, material, err);
}

static void put_cone(built_text *t, const values *v, int i)
{
    put_vector(t, v->a[i], ", ");
    put_number(t, v->r[i], ", ");
    put_vector(t, v->b[i], ", ");
    put_number(t, v->s[i], " ");
}

static pov_status add_cones(pov_builder *b, const values *v, size_t count, uint32_t material, pov_error *err)
{
    return pov_builder_add_cones(b, count, v->a, v->r, v->b, v->s, material, err);
}

static void put_box(built_text *t, const values *v, int i)
{
    put_vector(t, v->a[i], ", ");
    put_vector(t, v->b[i], " ");
}

static pov_status add_boxes(pov_builder *b, const values *v, size_t count, uint32_t material, pov_error *err)
{
    return pov_builder_add_boxes(b, count, v->a, v->b, material, err);
}

static void put_triangle(built_text *t, const values *v, int i)
{
    for (int k = 0; k < 3; k++)
        put_vector(t, v->a[3 * i + k], k < 2 ? ", " : " ");
}

static pov_status add_triangles(pov_builder *b, const values *v, size_t count, uint32_t material, pov_error *err)
{
    return pov_builder_add_triangles(b, count, v->a, NULL, material, err);
}

static void put_smooth_triangle(built_text *t, const values *v, int i)
{
    for (int k = 0; k < 3; k++) {
        put_vector(t, v->a[3 * i + k], ", ");
        put_vector(t, v->b[3 * i + k], k < 2 ? ", " : " ");
    }
}

static pov_status add_smooth_triangles(pov_builder *b, const values *v, size_t count, uint32_t material, pov_error *err)
{
    return pov_builder_add_triangles(b, count, v->a, v->b, material, err);
}

static const kind kinds[] = {
    { "sphere", put_sphere, add_spheres },
    { "cylinder", put_cylinder, add_cylinders },
    { "cone", put_cone, add_cones },
    { "box", put_box, add_boxes },
    { "triangle", put_triangle, add_triangles },
    { "smooth_triangle", put_smooth_triangle, add_smooth_triangles },
};

static const size_t kind_count = sizeof kinds / sizeof *kinds, material_count = sizeof materials / sizeof *materials;

/* ---- both ---- */

static float *draw_arrays(const kind *k, const values *v, const char *material)
{
    pov_context *context = scenes_context();
    pov_builder *b = built_create(context);
    float *pixels;

    built_add_text(b, head);
    assert_int_equal(k->add(b, v, COUNT, built_material(b, material), NULL), POV_OK);
    built_add_text(b, tail);
    pixels = built_draw(b);
    pov_builder_destroy(b);
    pov_context_destroy(context);
    return pixels;
}

static float *draw_text(const kind *k, const values *v, const char *material)
{
    static built_text t;

    t.length = 0;
    built_put(&t, "%s", head);
    for (int i = 0; i < COUNT; i++) {
        built_put(&t, "%s { ", k->word);
        k->put(&t, v, i);
        built_put(&t, "%s }\n", material);
    }
    built_put(&t, "%s", tail);
    return scenes_draw(t.at, BUILT_WIDTH, BUILT_HEIGHT, 0, 0);
}

static bool is_one_colour(const float *pixels)
{
    for (int i = 4; i < BUILT_NUMBERS; i++)
        if (pixels[i] != pixels[i % 4])
            return false;
    return true;
}

static void arrays_are_bit_for_bit_as_their_text(void **state)
{
    static values v;

    (void)state;
    fill(&v);
    for (size_t k = 0; k < kind_count; k++)
        for (size_t m = 0; m < material_count; m++) {
            float *arrays = draw_arrays(&kinds[k], &v, materials[m]), *written = draw_text(&kinds[k], &v, materials[m]);

            if (memcmp(arrays, written, BYTES) != 0)
                fail_msg("%s with the material \"%s\" is not as its text", kinds[k].word, materials[m]);
            assert_false(is_one_colour(arrays));
            free(arrays);
            free(written);
        }
}

static void a_builder_loads_again_and_arrays_alone_are_a_scene(void **state)
{
    pov_context *context = scenes_context();
    pov_builder *b = built_create(context);
    static values v;

    (void)state;
    fill(&v);
    assert_int_equal(pov_builder_add_spheres(b, COUNT, v.a, v.r, POV_NO_MATERIAL, NULL), POV_OK);
    for (int i = 0; i < 2; i++) {
        pov_scene *scene = built_load(b);

        assert_int_equal(pov_scene_object_count(scene), COUNT);
        pov_scene_destroy(scene);
    }
    pov_builder_destroy(b);
    pov_context_destroy(context);
}

/* ---- errors ---- */

static void bad_numbers_are_refused_at_once(void **state)
{
    static const double bad[] = { NAN, HUGE_VAL, -HUGE_VAL };
    pov_context *context = scenes_context();
    pov_builder *b = built_create(context);
    pov_error err;
    static values v;

    (void)state;
    for (size_t k = 0; k < kind_count; k++)
        for (int i = 0; i < 3; i++) {
            fill(&v);
            v.a[kinds[k].add == add_triangles ? 3 * COUNT - 1 : COUNT - 1].z = bad[i];
            assert_int_equal(kinds[k].add(b, &v, COUNT, POV_NO_MATERIAL, &err), POV_E_ARGUMENT);
            assert_non_null(strstr(err.message, kinds[k].word));
        }
    assert_int_equal(pov_scene_object_count(NULL), 0);
    pov_builder_destroy(b);
    pov_context_destroy(context);
}

static void missing_arguments_are_refused(void **state)
{
    pov_context *context = scenes_context();
    pov_builder *b = built_create(context), *none;
    const pov_vec3 at = { 0.0, 0.0, 0.0 };
    const double r = 1.0;
    pov_scene *scene;
    uint32_t number;

    (void)state;
    assert_int_equal(pov_builder_create(NULL, context, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_create(&none, NULL, NULL), POV_E_ARGUMENT);
    assert_null(none);
    assert_int_equal(pov_builder_add_text(b, NULL, 3, NULL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_text(NULL, "", 0, NULL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_material(b, NULL, &number, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_material(b, "", NULL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_spheres(NULL, 1, &at, &r, POV_NO_MATERIAL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_spheres(b, 1, NULL, &r, POV_NO_MATERIAL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_spheres(b, 1, &at, NULL, POV_NO_MATERIAL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_spheres(b, 1, &at, &r, 1, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_spheres(b, SIZE_MAX, &at, &r, POV_NO_MATERIAL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_spheres(b, 0, NULL, NULL, POV_NO_MATERIAL, NULL), POV_OK);
    assert_int_equal(pov_scene_load_builder(&scene, NULL, NULL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_scene_load_builder(NULL, b, NULL, NULL), POV_E_ARGUMENT);
    pov_builder_destroy(NULL);
    pov_builder_destroy(b);
    pov_context_destroy(context);
}

static pov_error error_of(pov_builder *b)
{
    pov_scene *scene;
    pov_error err = { .status = POV_OK };

    assert_true(pov_scene_load_builder(&scene, b, NULL, &err) < 0);
    assert_null(scene);
    return err;
}

static void errors_of_loading_say_where_they_are(void **state)
{
    const pov_vec3 ends[2] = { { 0.0, 1.0, 0.0 }, { 1.0, 1.0, 1.0 } }, same[2] = { { 2.0, 1.0, 0.0 }, { 1.0, 1.0, 1.0 } };
    const double r[2] = { 1.0, 1.0 };
    pov_context *context = scenes_context();
    pov_builder *b = built_create(context);
    pov_error err;

    (void)state;
    assert_int_equal(pov_builder_add_cylinders(b, 2, ends, same, r, POV_NO_MATERIAL, NULL), POV_OK);
    err = error_of(b);
    assert_int_equal(err.status, POV_E_ARGUMENT);
    assert_string_equal(err.message, "cylinder 1 of 2: a cylinder needs two different ends");
    pov_builder_destroy(b);

    b = built_create(context);
    assert_int_equal(pov_builder_add_spheres(b, 2, ends, r, built_material(b, "pigment { rgb 1 }\n pigmet { }"), NULL), POV_OK);
    err = error_of(b);
    assert_int_equal(err.status, POV_E_SYNTAX);
    assert_int_equal(err.line, 2);
    assert_string_equal(err.hint, "pigment");
    pov_builder_destroy(b);

    b = built_create(context);
    built_add_text(b, "#if (1) sphere { 0, 1 }");
    assert_int_equal(pov_builder_add_spheres(b, 2, ends, r, POV_NO_MATERIAL, NULL), POV_OK);
    built_add_text(b, "#end");
    err = error_of(b);
    assert_int_equal(err.status, POV_E_SYNTAX);
    assert_string_equal(err.message, "there is no \"#end\" for this");
    pov_builder_destroy(b);
    pov_context_destroy(context);
}

/* ---- memory that ends ---- */

static pov_status whole_way(failing *f, const values *v)
{
    pov_context_desc d = POV_INIT(d);
    pov_context *context = NULL;
    pov_builder *b = NULL;
    pov_scene *scene = NULL;
    pov_status status;
    uint32_t number = 0;

    d.allocator = failing_allocator(f);
    d.plugin_path = TEST_PLUGINS;
    status = pov_context_create(&context, &d, NULL);
    if (status == POV_OK)
        status = pov_builder_create(&b, context, NULL);
    if (status == POV_OK)
        status = pov_builder_add_text(b, head, strlen(head), NULL, NULL);
    if (status == POV_OK)
        status = pov_builder_material(b, materials[1], &number, NULL);
    if (status == POV_OK)
        status = pov_builder_add_cones(b, COUNT, v->a, v->r, v->b, v->s, number, NULL);
    if (status == POV_OK)
        status = pov_scene_load_builder(&scene, b, NULL, NULL);
    pov_scene_destroy(scene);
    pov_builder_destroy(b);
    pov_context_destroy(context);
    return status;
}

static void every_allocation_may_fail(void **state)
{
    pov_status status = POV_E_MEMORY;
    static values v;
    long n;

    (void)state;
    fill(&v);
    for (n = 1; status != POV_OK; n++) {
        failing f;

        failing_init(&f, n);
        status = whole_way(&f, &v);
        if (status != POV_OK && status != POV_E_MEMORY)
            fail_msg("allocation %ld: %s", n, pov_status_name(status));
        assert_int_equal(f.blocks, 0);
    }
    assert_true(n > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrays_are_bit_for_bit_as_their_text),
        cmocka_unit_test(a_builder_loads_again_and_arrays_alone_are_a_scene),
        cmocka_unit_test(bad_numbers_are_refused_at_once),
        cmocka_unit_test(missing_arguments_are_refused),
        cmocka_unit_test(errors_of_loading_say_where_they_are),
        cmocka_unit_test(every_allocation_may_fail),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
