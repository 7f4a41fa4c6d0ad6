/* One picture, however it comes about: for every scene of scenes/test and scenes/gallery the bits are the same for any
 * number of threads, any preview, tree or list, whole or in parts. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdlib.h>
#include <string.h>

enum { WIDTH = 64, HEIGHT = 48 };

static pov_scene *load(pov_context *context, const char *path, pov_accel accel)
{
    pov_load_desc d = POV_INIT(d);
    pov_scene *scene;
    pov_error err;

    d.accel = accel;
    if (pov_scene_load_file(&scene, context, path, &d, &err) < 0)
        fail_msg("%s:%d:%d: %s", err.file, err.line, err.column, err.message);
    return scene;
}

static pov_render_desc desc_of(int threads, int preview)
{
    pov_render_desc d = POV_INIT(d);

    d.width = WIDTH;
    d.height = HEIGHT;
    d.threads = threads;
    d.preview = preview;
    return d;
}

static void assert_same(const char *path, const char *what, const float *a, float *b)
{
    if (memcmp(a, b, sizeof *a * WIDTH * HEIGHT * 4) != 0)
        fail_msg("%s: another picture with %s", path, what);
    free(b);
}

static void compare_ways(pov_context *context, const char *path)
{
    pov_scene *tree = load(context, path, POV_ACCEL_TREE), *list = load(context, path, POV_ACCEL_NONE);
    pov_render_desc one = desc_of(1, 0), two = desc_of(2, 16), three = desc_of(3, 4), eight = desc_of(8, 2);
    float *picture = scenes_render(tree, &one);

    assert_same(path, "2 threads and a preview of 16", picture, scenes_render(tree, &two));
    assert_same(path, "3 threads and a preview of 4", picture, scenes_render(tree, &three));
    assert_same(path, "8 threads and a preview of 2", picture, scenes_render(tree, &eight));
    assert_same(path, "no tree", picture, scenes_render(list, &two));
    free(picture);
    pov_scene_destroy(tree);
    pov_scene_destroy(list);
}

static void compare_folder(const char *folder)
{
    pov_context *context = scenes_context();
    char **list = scenes_list(folder);
    size_t i;

    for (i = 0; list[i]; i++)
        compare_ways(context, list[i]);
    print_message("%zu scenes\n", i);
    scenes_free(list);
    pov_context_destroy(context);
}

static void test_scenes_have_one_picture(void **state)
{
    (void)state;
    compare_folder("test");
}

static void gallery_scenes_have_one_picture(void **state)
{
    (void)state;
    compare_folder("gallery");
}

static void a_crop_is_the_part_of_the_whole(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, "camera { location <0,1,-4> look_at 0 } light_source { <5,8,-6> rgb 1 }"
                                            "sphere { <0,0,0>, 1 pigment { color red 1 } finish { reflection .3 } }"
                                            "box { <-9,-2,-9>, <9,-1,9> pigment { color green 1 } }");
    pov_render_desc d = desc_of(2, 8);
    float *whole = scenes_render(scene, &d), *feature;
    int y;

    (void)state;
    d.crop.x = 13;
    d.crop.y = 7;
    d.crop.width = 33;
    d.crop.height = 29;
    feature = scenes_render(scene, &d);
    for (y = 0; y < 29; y++)
        assert_memory_equal(feature + 33 * 4 * y, whole + 4 * (WIDTH * (7 + y) + 13), 33 * 4 * sizeof *feature);
    free(feature);
    free(whole);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scenes_have_one_picture),
        cmocka_unit_test(gallery_scenes_have_one_picture),
        cmocka_unit_test(a_crop_is_the_part_of_the_whole),
    };

    return cmocka_run_group_tests_name("pictures", tests, NULL, NULL);
}
