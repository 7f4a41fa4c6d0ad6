#include "support/reading.h"

#include <povtrace/shape.h>

#include <string.h>

/* ---- shapes that keep their numbers and are never hit ---- */

static bool bounds(const void *self, pov_box *out)
{
    (void)self;
    (void)out;
    return false;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    (void)self;
    (void)ray;
    (void)hits;
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    (void)self;
    (void)point;
    (void)point_lo;
    return false;
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)self;
    (void)ray;
    (void)at;
    *out = pov_vec3_of(0.0, 1.0, 0.0);
}

static void parse_sphere(void *self, const pov_host *host, pov_reader *in)
{
    test_shape *s = self;

    host->vector(in, &s->vectors[0]);
    host->accept(in, ",");
    if (!host->more(in)) {
        s->numbers[0] = s->vectors[0].x;
        s->vectors[0] = pov_vec3_of(0.0, 0.0, 0.0);
        host->warn(in, "the sphere has no centre");
        return;
    }
    s->numbers[0] = host->number(in);
    if (s->numbers[0] < 0.0)
        host->warn(in, "a negative radius is taken as positive");
}

static void parse_box(void *self, const pov_host *host, pov_reader *in)
{
    test_shape *s = self;

    host->vector(in, &s->vectors[0]);
    host->accept(in, ",");
    host->vector(in, &s->vectors[1]);
}

static void parse_cone(void *self, const pov_host *host, pov_reader *in)
{
    test_shape *s = self;
    int i;

    for (i = 0; i < 2; i++) {
        host->vector(in, &s->vectors[i]);
        host->accept(in, ",");
        s->numbers[i] = host->number(in);
        if (i == 0)
            host->accept(in, ",");
    }
    s->open = host->accept(in, "open");
}

static void parse_cylinder(void *self, const pov_host *host, pov_reader *in)
{
    test_shape *s = self;

    parse_box(self, host, in);
    host->accept(in, ",");
    s->numbers[0] = host->number(in);
    s->open = host->accept(in, "open");
    if (pov_largest(pov_sub(s->vectors[0], s->vectors[1])) == 0.0)
        host->fail(in, "the cylinder has no length");
}

static void parse_quadric(void *self, const pov_host *host, pov_reader *in)
{
    test_shape *s = self;
    int i;

    for (i = 0; i < 3; i++) {
        host->vector(in, &s->vectors[i]);
        host->accept(in, ",");
    }
    s->numbers[0] = host->number(in);
}

static void parse_polygon(void *self, const pov_host *host, pov_reader *in)
{
    test_shape *s = self;
    double n = host->number(in);
    int i;

    if (!(n >= 3.0 && n <= 1e6)) {
        host->fail(in, "a polygon has from 3 to a million points");
        return;
    }
    s->points = host->alloc(in, (size_t)n * sizeof *s->points);
    for (i = 0; s->points && i < (int)n; i++) {
        host->accept(in, ",");
        host->vector(in, &s->points[i]);
    }
    s->count = (int)n;
}

/* Uses host calls that the others don't: expect, and words between values. */
static void parse_blob7(void *self, const pov_host *host, pov_reader *in)
{
    test_shape *s = self;

    host->expect(in, "power");
    s->numbers[0] = host->number(in);
    host->expect(in, "(");
    s->numbers[1] = host->number(in);
    host->expect(in, ")");
}

#define CLASS(word, what) \
    static const pov_shape_class word##_class = { \
        .size = sizeof(pov_shape_class), \
        .flags = what, \
        .keyword = #word, \
        .instance_size = sizeof(test_shape), \
        .parse = parse_##word, \
        .bounds = bounds, \
        .intersect = intersect, \
        .normal = normal, \
        .inside = inside, \
    };

CLASS(sphere, POV_SHAPE_SOLID)
CLASS(box, POV_SHAPE_SOLID)
CLASS(cone, POV_SHAPE_SOLID)
CLASS(cylinder, POV_SHAPE_SOLID)
CLASS(quadric, POV_SHAPE_SOLID)
CLASS(polygon, 0)
CLASS(blob7, POV_SHAPE_SOLID)

static const pov_shape_class *const shapes[] = { &sphere_class,  &box_class,     &cone_class,  &cylinder_class,
                                                 &quadric_class, &polygon_class, &blob7_class, NULL };

const pov_plugin reading_plugin = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "test shapes",
    .version = "1",
    .shapes = shapes,
};

/* ---- reading ---- */

static void keep_note(void *user, pov_log_level level, const pov_error *note)
{
    reading *r = user;

    (void)level;
    if (r->note_count < READING_NOTES)
        r->notes[r->note_count++] = *note;
}

void reading_begin_bytes(reading *r, const char *text, size_t length, const reader_options *options,
                         const pov_allocator *allocator)
{
    memset(r, 0, sizeof *r);
    env_init(&r->env, allocator, keep_note, r);
    model_init(&r->model, &r->env);
    r->plugins = registry_create(&r->env, "/nonexistent", &r->error);
    r->status = r->plugins ? registry_add(r->plugins, &reading_plugin, &r->error) : r->error.status;
    if (r->status == POV_OK)
        r->status = reader_read(&r->model, r->plugins, text, length, "scene.pov", options, &r->error);
}

void reading_begin(reading *r, const char *text)
{
    reading_begin_bytes(r, text, strlen(text), NULL, NULL);
}

void reading_end(reading *r)
{
    model_free(&r->model);
    if (r->plugins)
        registry_destroy(r->plugins);
}

const test_shape *reading_shape(const reading *r, size_t index)
{
    return r->model.leaves.items[index].instance;
}
