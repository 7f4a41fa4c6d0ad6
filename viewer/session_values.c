/* The numbers behind the pixels. */
#include "session_state.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_VALUES = 3 };

static void trace_value(const session *s, const pov_camera *camera, int x, int y, float *out)
{
    pov_hit hit = POV_INIT(hit);
    pov_vec3 org, dir;

    out[0] = (float)NAN;
    if (!pov_camera_ray(camera, (x + 0.5) / s->picture.width - 0.5, 0.5 - (y + 0.5) / s->picture.height, &org, &dir) ||
        !pov_trace_hit(s->tracer, org, dir, &hit))
        return;
    if (s->app->view == APP_DEPTH) {
        out[0] = (float)(hit.distance * session_depth_unit(s));
    } else if (s->app->view == APP_CERTAINTY) {
        out[0] = hit.certain ? 1.0f : 2.0f;
    } else {
        out[0] = (float)hit.normal.x;
        out[1] = (float)hit.normal.y;
        out[2] = (float)hit.normal.z;
    }
}

/* Rays are traced once for each view and place, and not with every event. */
static void trace_values(session *s, pov_rect r, float *out)
{
    const size_t count = MOST_VALUES * (size_t)r.width * (size_t)r.height;
    const pov_camera camera = app_camera(s->app);
    session_traced *t = &s->traced;
    const bool known = t->values && t->view == s->app->view && t->restarts == s->restarts &&
                       memcmp(&t->camera, &camera, sizeof camera) == 0 && memcmp(&t->rect, &r, sizeof r) == 0;

    if (!known) {
        float *values = realloc(t->values, count * sizeof *values);

        memset(out, 0, count * sizeof *out);
        for (int i = 0; i < r.width * r.height; i++)
            trace_value(s, &camera, r.x + i % r.width, r.y + i / r.width, out + MOST_VALUES * i);
        if (!values)
            return;
        t->values = values;
        memcpy(values, out, count * sizeof *out);
        t->view = s->app->view;
        t->restarts = s->restarts;
        t->camera = camera;
        t->rect = r;
        return;
    }
    memcpy(out, t->values, count * sizeof *out);
}

static void read_colors(const session *s, pov_rect r, float *out)
{
    float rgba[4];

    for (int i = 0; i < r.width * r.height; i++, out += MOST_VALUES) {
        pov_rect pixel = { r.x + i % r.width, r.y + i / r.width, 1, 1 };

        pov_job_read(s->job, pixel, POV_PIXELS_LINEAR_FLOAT, rgba, sizeof rgba);
        if (session_shows_reference(s, pixel.x)) {
            memcpy(out, reference_color(&s->reference, pixel.x, pixel.y), sizeof *out * MOST_VALUES);
            continue;
        }
        memcpy(out, rgba, sizeof *out * MOST_VALUES);
        if (s->picture.kind == PICTURE_DIFFERENCE && reference_fits(&s->reference, s->picture.width, s->picture.height))
            reference_difference(&s->reference, pixel.x, pixel.y, rgba, out);
        if (!(rgba[3] > 0.0f))
            out[0] = (float)NAN;
    }
}

static void read_map(const session *s, pov_rect r, float *out)
{
    const app_view v = s->app->view;
    const pov_pixels map = v == APP_SAMPLES ? POV_PIXELS_SAMPLES : v == APP_TIME ? POV_PIXELS_TIME : POV_PIXELS_ERROR;

    for (int i = 0; i < r.width * r.height; i++, out += MOST_VALUES) {
        pov_rect pixel = { r.x + i % r.width, r.y + i / r.width, 1, 1 };

        pov_job_read(s->job, pixel, map, out, sizeof *out);
        out[0] = out[0] >= 0.0f ? out[0] : (float)NAN;
        /* In the unit of the legend. */
        out[0] *= v == APP_TIME ? 1e6f : 1.0f;
    }
}

int session_values(session *s, pov_rect r, float *out)
{
    memset(out, 0, MOST_VALUES * sizeof *out * (size_t)r.width * (size_t)r.height);
    if (!s->job)
        return 0;
    if (!session_shows_job(s))
        trace_values(s, r, out);
    else if (s->app->view == APP_PICTURE)
        read_colors(s, r, out);
    else
        read_map(s, r, out);
    return s->app->view == APP_PICTURE || s->app->view == APP_NORMAL ? 3 : 1;
}

double session_depth_unit(const session *s)
{
    pov_vec3 middle = orbit_ray(&s->app->orbit, 0.5, 0.5);

    return sqrt(pov_dot(middle, middle));
}
