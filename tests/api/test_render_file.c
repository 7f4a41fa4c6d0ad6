#define _XOPEN_SOURCE 700   /* mkdtemp, setenv */
/* A scene file to an image file in one call: the same bytes as step by step, and errors of each step. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/image.h>
#include <povtrace/render.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char text[] = "#version 3.7; camera { location -4*z look_at 0 } light_source { <5, 9, -7> rgb 1 }\n"
                           "sphere { 0, W pigment { rgb <1, .5, .2> } }\n";

typedef struct folder { char name[64], scene[96], image[96]; } folder;

static folder make(void)
{
    folder f = { .name = "/tmp/povtrace-render-file.XXXXXX" };
    FILE *out;

    assert_non_null(mkdtemp(f.name));
    snprintf(f.scene, sizeof f.scene, "%s/s.pov", f.name);
    snprintf(f.image, sizeof f.image, "%s/s.pfm", f.name);
    out = fopen(f.scene, "w");
    assert_non_null(out);
    fputs(text, out);
    fclose(out);
    return f;
}

static void forget(const folder *f)
{
    remove(f->scene);
    remove(f->image);
    assert_int_equal(rmdir(f->name), 0);
}

static const char *const declares[] = { "W=1.2", NULL };

static void the_picture_is_that_of_the_steps(void **state)
{
    const folder f = make();
    pov_load_desc load = POV_INIT(load);
    pov_render_desc desc = POV_INIT(desc);
    pov_context *context = scenes_context();
    pov_bitmap seen = POV_INIT(seen);
    pov_scene *scene;
    float *wanted;

    (void)state;
    load.declares = declares;
    desc.width = 40;
    desc.height = 30;
    desc.crop = (pov_rect){ 10, 5, 20, 20 };
    assert_int_equal(pov_render_file(f.scene, f.image, &load, &desc, NULL), POV_OK);
    assert_int_equal(pov_image_read(context, f.image, &seen, NULL), POV_OK);
    assert_true(seen.width == 20 && seen.height == 20);
    assert_int_equal(pov_scene_load_file(&scene, context, f.scene, &load, NULL), POV_OK);
    wanted = scenes_render(scene, &desc);
    for (int i = 0; i < 4 * 20 * 20; i++)
        assert_true(i % 4 == 3 || seen.rgba[i] == wanted[i]);
    free(wanted);
    pov_image_free(context, &seen);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    forget(&f);
}

static bool refuse(void *user, double fraction, size_t objects)
{
    (void)user;
    (void)objects;
    return fraction < 0.9;
}

static void each_step_may_fail(void **state)
{
    const folder f = make();
    pov_load_desc load = POV_INIT(load);
    pov_render_desc desc = POV_INIT(desc);
    pov_error err = { 0 };

    (void)state;
    desc.width = desc.height = 8;
    assert_int_equal(pov_render_file(NULL, f.image, NULL, NULL, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_render_file(f.scene, NULL, NULL, NULL, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_render_file(f.scene, f.image, NULL, &desc, &err), POV_E_SYNTAX);   /* W is not declared */
    assert_int_equal(err.line, 2);
    load.declares = declares;
    assert_int_equal(pov_render_file(f.scene, "s.nosuch", &load, &desc, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_render_file("/nowhere/s.pov", f.image, &load, &desc, &err), POV_E_IO);
    desc.part = desc.parts = 1;
    assert_int_equal(pov_render_file(f.scene, f.image, &load, &desc, &err), POV_E_ARGUMENT);
    desc.part = desc.parts = 0;
    load.progress = refuse;
    assert_int_equal(pov_render_file(f.scene, f.image, &load, &desc, &err), POV_E_CANCELLED);
    assert_int_not_equal(access(f.image, F_OK), 0);
    forget(&f);
}

/* The text counts wherever it comes from. */
static void input_is_limited(void **state)
{
    const folder f = make();
    pov_context *context = scenes_context();
    pov_load_desc load = POV_INIT(load);
    pov_error err = { 0 };
    pov_scene *scene;

    (void)state;
    load.declares = declares;
    load.most_input = sizeof text - 2;
    assert_int_equal(pov_scene_load_text(&scene, context, text, sizeof text - 1, "s", &load, &err), POV_E_IO);
    assert_non_null(strstr(err.message, "larger than the"));
    assert_int_equal(pov_scene_load_file(&scene, context, f.scene, &load, &err), POV_E_IO);
    load.most_input = sizeof text - 1;
    assert_int_equal(pov_scene_load_text(&scene, context, text, sizeof text - 1, "s", &load, &err), POV_OK);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    forget(&f);
}

/* The one call has a context of its own, which finds plugins by the environment. */
int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_picture_is_that_of_the_steps),
        cmocka_unit_test(each_step_may_fail),
        cmocka_unit_test(input_is_limited),
    };

    setenv("POVTRACE_PLUGIN_PATH", TEST_PLUGINS, 1);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
