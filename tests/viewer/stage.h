/* stage.h - the whole viewer on OSMesa, for tests: what is done, and what is seen then. For one program each. */
#ifndef TESTS_VIEWER_STAGE_H
#define TESTS_VIEWER_STAGE_H

#include "loop.h"
#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WIDTH = 320, HEIGHT = 240 };

/* A red sphere before a black ground; at the camera's height, lit from behind it. */
static const char good[] = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                           "camera { location <0, 0, -5> look_at 0 }\n"
                           "light_source { <0, 0, -50> rgb 1 }\n"
                           "sphere { 0, 1 pigment { rgb <1, 0, 0> } finish { ambient 0 diffuse .4 } }\n";

/* What the libraries below keep to the process's end is theirs, and so are the fences of OSMesa, which has not been
 * built to be looked at. The sanitizers ask for these by name. */
POV_EXPORT const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libfontconfig.so\nleak:libOSMesa.so\nleak:libLLVM\nleak:libglapi.so\n";
}

POV_EXPORT const char *__tsan_default_suppressions(void);
const char *__tsan_default_suppressions(void)
{
    return "race:libOSMesa.so\n";
}

static char folder[] = "/tmp/povview-test-XXXXXX";
static char scene_path[sizeof folder + 20];

static inline void write_scene(const char *text)
{
    FILE *f = fopen(scene_path, "w");

    assert_non_null(f);
    assert_true(fputs(text, f) >= 0);
    assert_int_equal(fclose(f), 0);
}

typedef struct stage { viewer v; uint8_t *pixels; } stage;

static inline stage *begin_as(const char *text, int frames, int samples, const char *compared)
{
    stage *s = calloc(1, sizeof *s);
    args a = { .scene = scene_path, .width = WIDTH, .height = HEIGHT, .keys = "", .shot = "", .frames = frames, .samples = samples,
               .plugin_path = TEST_PLUGINS, .reference = compared };
    pov_error err = { 0 };
    surface *memory = surface_osmesa_open(WIDTH, HEIGHT, &err);

    assert_non_null(s);
    write_scene(text);
    if (!memory || viewer_open(&s->v, &a, memory, frames > 0, &err) < 0)
        fail_msg("%s", err.message);
    s->v.fixed_clock = 0.0;
    shot_wait_for_scene(&s->v);
    return s;
}

static inline stage *begin_with(const char *text, int frames, int samples)
{
    return begin_as(text, frames, samples, NULL);
}

static inline stage *begin(const char *text, int frames)
{
    return begin_with(text, frames, 1);
}

/* Do this, wait, and see what is there then. */
static inline const uint8_t *see(stage *s, const char *keys)
{
    shot_play(&s->v, keys);
    shot_settle(&s->v);
    /* Words in passing have passed. */
    s->v.fixed_clock += 10.0;
    viewer_step(&s->v);
    free(s->pixels);
    s->pixels = malloc((size_t)s->v.app.width * (size_t)s->v.app.height * 4);
    assert_non_null(s->pixels);
    present_read(s->v.present, s->v.app.width, s->v.app.height, s->pixels);
    return s->pixels;
}

static inline uint8_t *copy(const uint8_t *pixels)
{
    uint8_t *to = malloc(WIDTH * HEIGHT * 4);

    assert_non_null(to);
    return memcpy(to, pixels, WIDTH * HEIGHT * 4);
}

static inline void end(stage *s)
{
    viewer_close(&s->v);
    free(s->pixels);
    free(s);
}

static inline const uint8_t *at(const uint8_t *pixels, int x, int y)
{
    return pixels + 4 * (y * WIDTH + x);
}

static inline void assert_color(const uint8_t *pixel, int red, int green_, int blue, int tolerance)
{
    if (abs(pixel[0] - red) > tolerance || abs(pixel[1] - green_) > tolerance || abs(pixel[2] - blue) > tolerance)
        fail_msg("%d %d %d is not %d %d %d", pixel[0], pixel[1], pixel[2], red, green_, blue);
}

/* How many pixels differ, of all. */
static inline int differences(const uint8_t *a, const uint8_t *b)
{
    int count = 0;

    for (int i = 0; i < WIDTH * HEIGHT; i++)
        count += memcmp(a + 4 * i, b + 4 * i, 3) != 0;
    return count;
}

static inline int make_folder(void **state)
{
    (void)state;
    if (!mkdtemp(folder) || chdir(folder) != 0)
        return -1;
    snprintf(scene_path, sizeof scene_path, "%s/scene.pov", folder);
    return 0;
}

static inline int remove_folder(void **state)
{
    static const char *const names[] = { "scene.pov", "scene-001.png", "scene-002.png", "wanted.png", "reference.png", "reference.pfm",
                                         "other.pov" };

    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        unlink(names[i]);
    return chdir("/") == 0 ? rmdir(folder) : -1;
}

#endif
