#include "session_state.h"

#include <stdio.h>
#include <string.h>

const uint8_t *session_pixels(const session *s, int *width, int *height)
{
    *width = s->picture.width;
    *height = s->picture.height;
    return s->picture.pixels;
}

static bool picture_has_rows(const session *s)
{
    return s->picture.pixels && s->picture.last >= s->picture.first;
}

bool session_has_rows(const session *s)
{
    return picture_has_rows(s) || (s->reference.bytes && s->reference.last >= s->reference.first);
}

bool session_take_rows(session *s, int *first, int *last)
{
    picture *p = &s->picture;

    if (!picture_has_rows(s))
        return false;
    *first = p->first;
    *last = p->last;
    p->first = p->height;
    p->last = -1;
    return true;
}

const uint8_t *session_reference_pixels(const session *s, int *width, int *height)
{
    *width = s->reference.width;
    *height = s->reference.height;
    return s->reference.bytes;
}

bool session_take_reference_rows(session *s, int *first, int *last)
{
    return reference_take_rows(&s->reference, first, last);
}

const char *session_reference_path(const session *s)
{
    return s->desc.args->reference ? s->desc.args->reference : "";
}

double session_reference_rms(const session *s)
{
    pov_pass pass = POV_INIT(pass);
    double rms = -1.0;

    for (size_t i = 0; s->job && pov_job_get_pass(s->job, i, &pass); i++)
        rms = pass.ref_rmse;
    return rms;
}

double session_middle_depth(const session *s)
{
    return s->middle * session_depth_unit(s);
}

void session_count_certain(const session *s, size_t *certain, size_t *uncertain)
{
    maps_counts counts = { 0, 0 };

    if (s->maps)
        counts = maps_count(s->maps);
    *certain = counts.certain;
    *uncertain = counts.uncertain;
}

void session_count_clipped(const session *s, size_t *above, size_t *below)
{
    *above = s->picture.clipped[PICTURE_ABOVE];
    *below = s->picture.clipped[PICTURE_BELOW];
}

bool session_shows_reference(const session *s, int x)
{
    return app_shows_reference(s->app, x) && reference_fits(&s->reference, s->picture.width, s->picture.height);
}

const uint8_t *session_seen_pixel(const session *s, int x, int y)
{
    const size_t at = 4 * ((size_t)y * (size_t)s->picture.width + (size_t)x);

    return (session_shows_reference(s, x) ? s->reference.bytes : s->picture.pixels) + at;
}

bool session_coarse_is_there(const session *s)
{
    return s->scene && picture_is_covered(&s->picture);
}

double session_coarse_since(const session *s)
{
    return s->job && session_shows_job(s) && !picture_is_covered(&s->picture) ? s->begun : -1.0;
}

unsigned long session_restarts(const session *s)
{
    return s->restarts;
}

pov_context *session_context(session *s)
{
    return s->context;
}

const pov_error *session_error(const session *s)
{
    return s->wrong ? &s->error : NULL;
}

bool session_get_pass(const session *s, size_t index, pov_pass *out)
{
    return s->job && pov_job_get_pass(s->job, index, out);
}

/* A limit of surfaces: not even a ray through millions of objects may delay the window. */
static bool is_worth_more(void *user, const pov_hit *hit)
{
    const size_t most = 1000;
    size_t *count = user;

    (void)hit;
    return ++*count < most;
}

bool session_inspect(session *s, session_place *out)
{
    const app *a = s->app;
    pov_camera camera = app_camera(a);
    pov_hit hit = POV_INIT(hit);
    pov_rect pixel = { 0, 0, 1, 1 };
    pov_vec3 ray;
    double x, y;

    memset(out, 0, sizeof *out);
    app_pointed(a, &x, &y);
    pixel.x = (int)x;
    pixel.y = (int)y;
    if (!s->job || x < 0.0 || y < 0.0 || pixel.x >= s->picture.width || pixel.y >= s->picture.height)
        return false;
    out->x = pixel.x;
    out->y = pixel.y;
    ray = orbit_ray(&a->orbit, (pixel.x + 0.5) / s->picture.width, (pixel.y + 0.5) / s->picture.height);
    pov_job_read(s->job, pixel, POV_PIXELS_LINEAR_FLOAT, out->color, sizeof out->color);
    pov_job_read(s->job, pixel, POV_PIXELS_SAMPLES, &out->samples, sizeof out->samples);
    pov_job_read(s->job, pixel, POV_PIXELS_ERROR, &out->error, sizeof out->error);
    pov_job_read(s->job, pixel, POV_PIXELS_TIME, &out->seconds, sizeof out->seconds);
    out->compared = reference_fits(&s->reference, s->picture.width, s->picture.height);
    if (out->compared)
        memcpy(out->reference, reference_color(&s->reference, pixel.x, pixel.y), sizeof out->reference);
    out->hit = pov_trace_hit(s->tracer, camera.location, ray, &hit);
    if (!out->hit)
        return true;
    pov_scene_get_object(s->scene, hit.object, &out->keyword, &out->line, &out->column);
    pov_trace_hits(s->tracer, camera.location, ray, is_worth_more, &out->hits);
    out->distance = hit.distance * sqrt(pov_dot(ray, ray));
    out->point = hit.point;
    out->normal = hit.normal;
    out->certain = hit.certain;
    return true;
}

/* Progress and remaining time. Percentages are never rounded up to 100. */
static void describe(const session *s, const char *name, const pov_progress *p, char *out, size_t size)
{
    char quality[80] = "", rest[40] = "";

    if (p->est_rmse >= 0.0)
        snprintf(quality, sizeof quality, ", %.1f samples, error %.2g", p->spp_mean, p->est_rmse);
    if (p->fraction >= 1.0) {
        snprintf(out, size, "%.100s: done in %.1f s%s", name, s->worked, quality);
        return;
    }
    if (s->app->paused)
        snprintf(rest, sizeof rest, ", paused");
    else if (p->seconds_left >= 1.0)
        snprintf(rest, sizeof rest, ", %.0f s left", p->seconds_left);
    snprintf(out, size, "%.100s: %d %%%s%s", name, (int)(100.0 * p->fraction), quality, rest);
}

void session_title(session *s, char *out, size_t size)
{
    const char *path = s->path[0] ? s->path : "povview", *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    pov_progress p = POV_INIT(p);

    if (!s->job) {
        snprintf(out, size, s->loads > 0 ? "%.100s: reading" : "%.100s", name);
        return;
    }
    pov_job_get_progress(s->job, &p);
    if (!session_shows_job(s))
        snprintf(out, size, "%.100s: %s", name, app_view_name(s->app->view));
    else
        describe(s, name, &p, out, size);
}
