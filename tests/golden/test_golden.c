/* Pictures of this folder, drawn by POV-Ray (make.py), against povtrace's of the same scenes: linear light, clamped to
 * 0..1 as POV-Ray stores it. */
#include "support/check.h"
#include "support/scenes.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 64, HEIGHT = 48, PIXELS = WIDTH * HEIGHT, PICTURES = 13 };

/* Where a pixel's centre lies on an edge the programs may take either side: they do in two pixels of the pool. Everywhere
 * else they agree to the steps of 16 bits, whose mean is 0.25 / 65535 = 3.8e-6; in one more pixel of the machine they
 * do not, which makes 5.9e-6 of its mean. */
enum { MOST_OFF = 4 };
static const double off = 8.0 / 255.0, most_mean = 1e-5;

static pov_context *context;

static int set_up(void **state)
{
    (void)state;
    context = scenes_context();
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    pov_context_destroy(context);
    return 0;
}

static double stored(float value)
{
    return isnan(value) ? 2.0 : value < 0.0f ? 0.0 : value > 1.0f ? 1.0 : (double)value;
}

/* Pixels that are off; the mean difference of the others. */
typedef struct difference { int off; double mean; } difference;

static difference difference_of(const float *ours, const float *theirs)
{
    difference d = { 0, 0.0 };

    for (int i = 0; i < PIXELS; i++) {
        double most = 0.0, sum = 0.0;

        for (int c = 4 * i; c < 4 * i + 3; c++) {
            const double apart = fabs(stored(ours[c]) - stored(theirs[c]));

            most = apart > most ? apart : most;
            sum += apart;
        }
        d.off += most > off;
        d.mean += most > off ? 0.0 : sum / (3 * PIXELS);
    }
    return d;
}

static bool holds(difference d) { return d.off <= MOST_OFF && d.mean <= most_mean; }

/* ---- the pictures ---- */

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

/* A picture's name is that of its scene, with a dash after the folder. */
static void path_of_scene(char *path, size_t size, const char *name)
{
    const char *dash = strchr(name, '-');

    assert_non_null(dash);
    snprintf(path, size, "%s/scenes/%.*s/%s.pov", TEST_ROOT, (int)(dash - name), name, dash + 1);
}

static pov_scene *load(const char *name)
{
    char path[1024];
    pov_scene *scene;
    pov_error err;

    path_of_scene(path, sizeof path, name);
    if (pov_scene_load_file(&scene, context, path, NULL, &err) < 0)
        fail_msg("%s:%d:%d: %s", err.file, err.line, err.column, err.message);
    return scene;
}

static difference compare(const char *name, const float *ours)
{
    char path[1024];
    pov_bitmap golden = POV_INIT(golden);
    difference d;
    pov_error err;

    snprintf(path, sizeof path, "%s/tests/golden/%s.png", TEST_ROOT, name);
    if (pov_image_read(context, path, &golden, &err) < 0)
        fail_msg("%s", err.message);
    assert_true(golden.width == WIDTH && golden.height == HEIGHT && golden.bits == 16);
    d = difference_of(ours, golden.rgba);
    pov_image_free(context, &golden);
    return d;
}

static bool is_golden(const char *name)
{
    float *ours = draw(load(name));
    const difference d = compare(name, ours);

    free(ours);
    print_message("%-24s %d pixels off by more than 8/255, mean difference of the others %.2g%s\n", name, d.off, d.mean,
                  holds(d) ? "" : ": NOT HELD");
    return holds(d);
}

static void pictures_are_as_povray_draws_them(void **state)
{
    DIR *folder = opendir(TEST_ROOT "/tests/golden");
    const struct dirent *entry;
    int seen = 0, broken = 0;
    (void)state;

    assert_non_null(folder);
    while ((entry = readdir(folder)) != NULL) {
        const size_t length = strlen(entry->d_name);
        char name[256];

        if (length < 5 || strcmp(entry->d_name + length - 4, ".png") != 0)
            continue;
        snprintf(name, sizeof name, "%.*s", (int)length - 4, entry->d_name);
        broken += !is_golden(name);
        seen++;
    }
    closedir(folder);
    assert_int_equal(seen, PICTURES);
    assert_int_equal(broken, 0);
}

/* ---- what they are here to notice ---- */

/* The scene's text with one place of it said otherwise. */
static pov_scene *reworded(const char *name, const char *from, const char *to)
{
    char path[1024], text[8192], changed[8192 + 64];
    const char *at;
    size_t length;
    FILE *f;

    path_of_scene(path, sizeof path, name);
    f = fopen(path, "rb");
    assert_non_null(f);
    length = fread(text, 1, sizeof text - 1, f);
    fclose(f);
    text[length] = '\0';
    at = strstr(text, from);
    assert_non_null(at);
    snprintf(changed, sizeof changed, "%.*s%s%s", (int)(at - text), text, to, at + strlen(from));
    return scenes_text(context, changed);
}

static bool is_noticed(const char *name, const char *from, const char *to)
{
    float *ours = draw(reworded(name, from, to));
    const difference d = compare(name, ours);

    free(ours);
    return !holds(d);
}

static void a_wrong_highlight_is_noticed(void **state)
{
    (void)state;
    assert_false(is_noticed("test-phong", "phong_size 5 ", "phong_size 5.0 "));
    assert_true(is_noticed("test-phong", "phong_size 5 ", "phong_size 6 "));
    assert_true(is_noticed("test-phong", "phong_size 200", "phong_size 180"));
    assert_true(is_noticed("test-phong", "phong 0.7", "phong 0.6"));
}

static void a_wrong_dielectric_is_noticed(void **state)
{
    (void)state;
    assert_true(is_noticed("test-overlapping_media", "ior 1.2", "ior 1.25"));
    assert_true(is_noticed("test-filter_shadow", "rgbf", "rgbt"));
}

static void swapped_channels_are_noticed(void **state)
{
    float *ours = draw(load("gallery-machine"));
    (void)state;

    assert_true(holds(compare("gallery-machine", ours)));
    for (int i = 0; i < PIXELS; i++) {
        const float red = ours[4 * i];

        ours[4 * i] = ours[4 * i + 2];
        ours[4 * i + 2] = red;
    }
    assert_false(holds(compare("gallery-machine", ours)));
    free(ours);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_as_povray_draws_them),
        cmocka_unit_test(a_wrong_highlight_is_noticed),
        cmocka_unit_test(a_wrong_dielectric_is_noticed),
        cmocka_unit_test(swapped_channels_are_noticed),
    };

    return cmocka_run_group_tests(tests, set_up, tear_down);
}
