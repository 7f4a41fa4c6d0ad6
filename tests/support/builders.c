#include "support/builders.h"

#include "support/check.h"
#include "support/scenes.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void built_put(built_text *t, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    t->length += (size_t)vsnprintf(t->at + t->length, BUILT_TEXT_MAX - t->length, format, args);
    va_end(args);
    assert_true(t->length < BUILT_TEXT_MAX);
}

pov_builder *built_create(pov_context *context)
{
    pov_builder *b;

    assert_int_equal(pov_builder_create(&b, context, NULL), POV_OK);
    return b;
}

void built_add_text(pov_builder *b, const char *text)
{
    assert_int_equal(pov_builder_add_text(b, text, strlen(text), NULL, NULL), POV_OK);
}

uint32_t built_material(pov_builder *b, const char *text)
{
    uint32_t number;

    assert_int_equal(pov_builder_material(b, text, &number, NULL), POV_OK);
    return number;
}

pov_scene *built_load(const pov_builder *b)
{
    pov_error err = { 0 };
    pov_scene *scene = NULL;

    if (pov_scene_load_builder(&scene, b, NULL, &err) < 0)
        fail_msg("%s:%d:%d: %s", err.file, err.line, err.column, err.message);
    return scene;
}

float *built_draw(const pov_builder *b)
{
    pov_render_desc d = POV_INIT(d);
    pov_scene *scene = built_load(b);
    float *pixels;

    d.width = BUILT_WIDTH;
    d.height = BUILT_HEIGHT;
    pixels = scenes_render(scene, &d);
    pov_scene_destroy(scene);
    return pixels;
}

double built_next(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}
