/* Scenes from arrays: bit for bit those of the text that the calls name, and what a builder refuses. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/build.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 48, HEIGHT = 36, COUNT = 5, TEXT = 1 << 14 };

#define HEAD "#version 3.7; camera { location <1, 2, -6> look_at <0, .5, 0> } light_source { <4, 9, -7> rgb 1 }\n" \
             "#declare Red = texture { pigment { rgb <1, .2, .1> } finish { phong .5 } }\n"
#define TAIL "plane { y, -.7 pigment { checker rgb 1 rgb .6 } }\n"

static const char *const materials[] = {
    "", "texture { Red }", "pigment { rgb <.1, .8, .3> } rotate 20*y translate .1*x", "pigment { granite scale .4 } finish { reflection .3 }",
    "pigment { rgbt <.8, .9, 1, .7> } interior { ior 1.4 } no_shadow",
};

typedef struct arrays { pov_vec3 a[COUNT], b[COUNT], corners[3 * COUNT], normals[3 * COUNT]; double r[COUNT], s[COUNT]; } arrays;

static double place(int i, double step) { return fmod((i + 1) * step, 1.0) * 3.0 - 1.5; }

static void fill(arrays *v)
{
    for (int i = 0; i < COUNT; i++) {
        v->a[i] = pov_vec3_of(place(i, 0.618), place(i, 0.414), place(i, 0.732));
        v->b[i] = pov_add(v->a[i], pov_vec3_of(0.3 + 0.1 * i, 0.7, 0.2));
        v->r[i] = 0.1 + 0.07 * i;
        v->s[i] = 0.31 / (i + 1);
    }
    for (int i = 0; i < 3 * COUNT; i++) {
        v->corners[i] = pov_vec3_of(place(i, 0.37), place(i, 0.71), place(i, 0.53));
        v->normals[i] = pov_vec3_of(place(i, 0.11), 2.0, place(i, 0.29));
    }
}

static int put(char *out, size_t at, pov_vec3 p)
{
    return snprintf(out + at, TEXT - at, "<%.17g, %.17g, %.17g>", p.x, p.y, p.z);
}

#define PUT(...) (at += (size_t)snprintf(text + at, TEXT - at, __VA_ARGS__))
#define PUT_VEC(v) (at += (size_t)put(text, at, v))

/* The text that the calls of build() name. */
static void write_text(const arrays *v, const char *material, char *text)
{
    size_t at = 0;

    PUT("%s", HEAD);
    for (int i = 0; i < COUNT; i++)
        PUT("sphere { "), PUT_VEC(v->a[i]), PUT(", %.17g %s }\n", v->r[i], material);
    for (int i = 0; i < COUNT; i++)
        PUT("cylinder { "), PUT_VEC(v->a[i]), PUT(", "), PUT_VEC(v->b[i]), PUT(", %.17g %s }\n", v->s[i], material);
    PUT("%s", TAIL);
    for (int i = 0; i < COUNT; i++)
        PUT("cone { "), PUT_VEC(v->a[i]), PUT(", %.17g, ", v->r[i]), PUT_VEC(v->b[i]), PUT(", %.17g %s }\n", v->s[i], material);
    for (int i = 0; i < COUNT; i++)
        PUT("box { "), PUT_VEC(v->a[i]), PUT(", "), PUT_VEC(v->b[i]), PUT(" %s }\n", material);
    for (int i = 0; i < 3 * COUNT; i += 3)
        PUT("triangle { "), PUT_VEC(v->corners[i]), PUT(", "), PUT_VEC(v->corners[i + 1]), PUT(", "), PUT_VEC(v->corners[i + 2]), PUT(" %s }\n", material);
    for (int i = 0; i < 3 * COUNT; i += 3) {
        PUT("smooth_triangle { ");
        for (int k = i; k < i + 3; k++)
            PUT_VEC(v->corners[k]), PUT(", "), PUT_VEC(v->normals[k]), PUT(k < i + 2 ? ", " : " ");
        PUT("%s }\n", material);
    }
    assert_true(at < TEXT - 1);
}

static pov_builder *build(pov_context *context, const arrays *v, const char *text)
{
    pov_builder *b;
    uint32_t m = POV_NO_MATERIAL;

    assert_int_equal(pov_builder_create(&b, context, NULL), POV_OK);
    assert_int_equal(pov_builder_add_text(b, HEAD, strlen(HEAD), NULL, NULL), POV_OK);
    if (*text)
        assert_int_equal(pov_builder_material(b, text, &m, NULL), POV_OK);
    assert_int_equal(pov_builder_add_spheres(b, COUNT, v->a, v->r, m, NULL), POV_OK);
    assert_int_equal(pov_builder_add_cylinders(b, COUNT, v->a, v->b, v->s, m, NULL), POV_OK);
    assert_int_equal(pov_builder_add_text(b, TAIL, strlen(TAIL), "floor", NULL), POV_OK);
    assert_int_equal(pov_builder_add_cones(b, COUNT, v->a, v->r, v->b, v->s, m, NULL), POV_OK);
    assert_int_equal(pov_builder_add_boxes(b, COUNT, v->a, v->b, m, NULL), POV_OK);
    assert_int_equal(pov_builder_add_triangles(b, COUNT, v->corners, NULL, m, NULL), POV_OK);
    assert_int_equal(pov_builder_add_triangles(b, COUNT, v->corners, v->normals, m, NULL), POV_OK);
    return b;
}

static float *draw(pov_scene *scene)
{
    pov_render_desc desc = POV_INIT(desc);
    float *picture;

    desc.width = WIDTH;
    desc.height = HEIGHT;
    picture = scenes_render(scene, &desc);
    pov_scene_destroy(scene);
    return picture;
}

static void arrays_give_the_scene_of_the_text(void **state)
{
    pov_context *context = scenes_context();
    static char text[TEXT];
    arrays v;

    (void)state;
    fill(&v);
    for (size_t i = 0; i < sizeof materials / sizeof materials[0]; i++) {
        pov_builder *b = build(context, &v, materials[i]);
        pov_scene *built;
        pov_error err;
        float *by_arrays, *by_text;

        if (pov_scene_load_builder(&built, b, NULL, &err) != POV_OK)
            fail_msg("%s: %s", materials[i], err.message);
        write_text(&v, materials[i], text);
        by_arrays = draw(built);
        by_text = draw(scenes_text(context, text));
        assert_memory_equal(by_arrays, by_text, sizeof(float[4]) * WIDTH * HEIGHT);
        free(by_arrays);
        free(by_text);
        pov_builder_destroy(b);
    }
    pov_context_destroy(context);
}

static void bad_arguments_are_refused_and_add_nothing(void **state)
{
    pov_context *context = scenes_context();
    pov_builder *b;
    pov_scene *scene;
    uint32_t m;
    pov_error err;
    arrays v;

    (void)state;
    fill(&v);
    assert_int_equal(pov_builder_create(NULL, context, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_create(&b, NULL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_create(&b, context, NULL), POV_OK);
    assert_int_equal(pov_builder_add_text(b, NULL, 0, NULL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_material(b, NULL, &m, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_material(b, "no_shadow", NULL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_spheres(b, COUNT, NULL, v.r, 0, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_spheres(b, COUNT, v.a, NULL, 0, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_spheres(b, COUNT, v.a, v.r, 7, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_spheres(NULL, COUNT, v.a, v.r, 0, NULL), POV_E_ARGUMENT);
    v.r[3] = NAN;
    assert_int_equal(pov_builder_add_spheres(b, COUNT, v.a, v.r, 0, &err), POV_E_ARGUMENT);
    assert_non_null(strstr(err.message, "sphere 3 of 5"));
    assert_int_equal(pov_builder_add_spheres(b, 0, NULL, NULL, 0, NULL), POV_OK);
    assert_int_equal(pov_builder_add_text(b, TAIL, strlen(TAIL), NULL, NULL), POV_OK);
    assert_int_equal(pov_scene_load_builder(&scene, b, NULL, &err), POV_OK);
    pov_scene_destroy(scene);
    v.b[2] = v.a[2];
    assert_int_equal(pov_builder_add_cylinders(b, COUNT, v.a, v.b, v.s, 0, NULL), POV_OK);
    assert_int_not_equal(pov_scene_load_builder(&scene, b, NULL, &err), POV_OK);
    assert_non_null(strstr(err.message, "cylinder 2 of 5"));
    assert_null(scene);
    pov_builder_destroy(b);
    pov_builder_destroy(NULL);
    pov_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrays_give_the_scene_of_the_text),
        cmocka_unit_test(bad_arguments_are_refused_and_add_nothing),
    };

    return cmocka_run_group_tests_name("builders", tests, NULL, NULL);
}
