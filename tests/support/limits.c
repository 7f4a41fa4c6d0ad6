#include "support/limits.h"

#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const limits_frame limits_home = { 1.0, { 0.0, 0.0, 0.0 } };

/* ---- templates ---- */

typedef struct writing { char *text; size_t count, capacity; } writing;

static void put(writing *w, const char *text, size_t count)
{
    if (w->count + count + 1 > w->capacity) {
        w->capacity = 2 * w->capacity + count + 1;
        w->text = realloc(w->text, w->capacity);
        assert_non_null(w->text);
    }
    memcpy(w->text + w->count, text, count);
    w->count += count;
    w->text[w->count] = '\0';
}

/* Parse the mark behind '@'; returns its end. */
static const char *put_mark(writing *w, const char *mark, const limits_frame *f)
{
    const double move[3] = { f->move.x, f->move.y, f->move.z };
    const char kind = mark[0];
    const int n = kind == 'p' || kind == 'v' ? 3 : 1;
    char number[64];
    char *at = (char *)mark + 1;

    assert_non_null(strchr("pvlsn", kind));
    put(w, "<", (size_t)(n == 3));
    for (int i = 0; i < n; i++) {
        double x;

        assert_true(*at == (i == 0 ? '{' : ','));
        x = strtod(at + 1, &at);
        x = kind == 'n' ? x : kind == 's' ? x * f->scale * f->scale : x * f->scale;
        x = kind == 'p' ? x + move[i] : x;
        put(w, number, (size_t)snprintf(number, sizeof number, "%s%.17g", i > 0 ? "," : "", x));
    }
    put(w, ">", (size_t)(n == 3));
    assert_true(*at == '}');
    return at + 1;
}

char *limits_text(const char *template, const limits_frame *frame)
{
    writing w = { NULL, 0, 0 };

    while (*template) {
        const size_t plain = strcspn(template, "@");

        put(&w, template, plain);
        template += plain;
        if (*template)
            template = put_mark(&w, template + 1, frame);
    }
    return w.text;
}

pov_scene *limits_scene(pov_context *context, const char *template, const limits_frame *frame,
                        const pov_load_desc *desc)
{
    char *text = limits_text(template, frame);
    pov_scene *scene;
    pov_error err;

    if (pov_scene_load_text(&scene, context, text, strlen(text), "limits.pov", desc, &err) < 0)
        fail_msg("%d:%d: %s: %s", err.line, err.column, err.message, err.excerpt);
    free(text);
    return scene;
}

float *limits_picture(pov_context *context, const char *template, const limits_frame *frame, int width, int height)
{
    pov_scene *scene = limits_scene(context, template, frame, NULL);
    pov_render_desc d = POV_INIT(d);
    float *pixels;

    d.width = width;
    d.height = height;
    pixels = scenes_render(scene, &d);
    pov_scene_destroy(scene);
    return pixels;
}

/* ---- pictures ---- */

static float difference(const float *a, const float *b)
{
    float largest = 0.0f;

    for (int c = 0; c < 3; c++)
        largest = fmaxf(largest, a[c] == b[c] ? 0.0f : fabsf(a[c] - b[c]));
    return largest;
}

long limits_count(const float *a, const float *b, int width, int height, float tolerance)
{
    long n = 0;

    for (long i = 0; i < (long)width * height; i++)
        n += !(difference(a + 4 * i, b + 4 * i) <= tolerance);
    return n;
}

long limits_count_colour(const float *a, int width, int height, const float colour[3], float tolerance)
{
    long n = 0;

    for (long i = 0; i < (long)width * height; i++)
        n += difference(a + 4 * i, colour) <= tolerance;
    return n;
}

void limits_trace(const pov_scene *scene, pov_vec3 from, pov_vec3 direction, float rgba[4])
{
    pov_tracer *tracer;
    pov_error err;

    if (pov_tracer_create(&tracer, scene, &err) < 0 || pov_trace_color(tracer, from, direction, rgba, &err) < 0)
        fail_msg("%s", err.message);
    pov_tracer_destroy(tracer);
}

/* ---- a scene of everything ---- */

const char limits_everything[] =
    "#version 3.7;\n"
    "global_settings { assumed_gamma 1 max_trace_level 8 }\n"
    "background { color rgb <0.25,0.375,0.5> }\n"
    "camera { location @p{0.5,4,-14} look_at @p{0,1.25,0} angle 54 right <1.3333333,0,0> }\n"
    "light_source { @p{-10,16,-12} color rgb <0.75,0.75,0.625> }\n"
    "light_source { @p{14,9,-8} color rgb <0.25,0.375,0.5> }\n"
    "box { @p{-9,-0.5,-6}, @p{9,0,9} pigment { color rgb <0.5,0.5,0.375> } finish { ambient 0.125 diffuse 0.75 } }\n"
    "polygon { 5, @p{-8,0.25,7}, @p{8,0.25,7}, @p{8,6,8}, @p{-8,6,8}, @p{-8,0.25,7}\n"
    "  pigment { color rgb <0.125,0.125,0.25> } finish { diffuse 0.25 reflection 0.5 } }\n"
    "sphere { @p{-3.5,1.25,0.5}, @l{1.25} pigment { color rgb <0.75,0.125,0.125> }\n"
    "  finish { phong 0.75 phong_size 40 reflection 0.125 } }\n"
    "sphere { @p{-0.25,1,-2.5}, @l{1} pigment { color rgbf <0.875,1,0.875,0.875> } finish { diffuse 0.125 phong 0.5 }\n"
    "  interior { ior 1.5 } }\n"
    "box { @p{1.5,0,1}, @p{3.25,2.5,2.75} pigment { color rgb <0.25,0.5,0.75> } finish { reflection 0.25 } }\n"
    "cone { @p{4.75,0,-1}, @l{1.125}, @p{4.75,2.75,-1}, @l{0.25} pigment { color rgb <0.25,0.625,0.25> } }\n"
    "cone { @p{-5.5,0,-2}, @l{0}, @p{-5,1.75,-2.25}, @l{0.75} open pigment { color rgb <0.75,0.5,0.125> } }\n"
    "cylinder { @p{-1.5,0,3}, @p{-1.25,3.5,3.25}, @l{0.5} pigment { color rgb <0.625,0.25,0.625> }\n"
    "  finish { phong 0.5 } }\n"
    "cylinder { @p{1.75,0.5,-3}, @p{3.25,0.625,-3.5}, @l{0.375} open pigment { color rgb <0.875,0.75,0.25> } }\n"
    "quadric { <1,0.5,2>, <0.5,0,0.25>, <0,0,0>, @s{-0.75} translate @p{0.75,2.5,1.5}\n"
    "  pigment { color rgb <0.875,0.375,0.25> } finish { reflection 0.125 } }\n"
    "quadric { <1,-0.25,1>, <0,0,0>, <0,0,0>, @s{-0.0625} translate @p{-7,3,4}\n"
    "  pigment { color rgb <0.25,0.75,0.75> } }\n"
    "sphere { <0,0,0>, @l{1} scale <1.5,0.25,0.5> rotate <20,30,10> translate @p{3.25,0.875,-3.75}\n"
    "  pigment { color rgbf <0.875,0.75,1,0.75> } interior { ior 1.25 } }\n"
    "box { @v{-0.5,-0.5,-0.5}, @v{0.5,0.5,0.5} rotate <30,45,15> translate @p{-2.25,0.875,-4}\n"
    "  pigment { color rgb <0.125,0.5,0.25> } finish { phong 1 } }\n"
    "polygon { 10, @p{-6,0.125,-4.5}, @p{-4,0.125,-4.5}, @p{-4,2.125,-4.5}, @p{-6,2.125,-4.5}, @p{-6,0.125,-4.5},\n"
    "  @p{-5.5,0.625,-4.5}, @p{-4.5,0.625,-4.5}, @p{-4.5,1.625,-4.5}, @p{-5.5,1.625,-4.5}, @p{-5.5,0.625,-4.5}\n"
    "  pigment { color rgbf <1,0.75,0.5,0.625> } }\n";
