/* What the host offers a primitive while a scene loads: strings, booleans, vectors, colours, files, working memory and a
 * bounding volume hierarchy. All of it is used by one primitive, a heap of spheres that stands in a file. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/shape.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- heap { "file", <scale, lift>, color rgb <1, 0, 0>, on } ---- */

typedef struct sphere { pov_vec3 centre; double radius; } sphere;

/* Of the last heap that was read; the tests look at it. */
typedef struct last_read { char name[64], note[64]; double pair[2], five[5], color[5]; bool flag; size_t bytes; } last_read;
static last_read last;

typedef struct heap { sphere *spheres; const pov_hierarchy *hierarchy; uint32_t count; } heap;

static uint32_t read_spheres(const char *text, sphere *out, uint32_t most)
{
    uint32_t n = 0;
    int used;

    while (n < most && sscanf(text, " %lf %lf %lf %lf%n", &out[n].centre.x, &out[n].centre.y, &out[n].centre.z,
                              &out[n].radius, &used) == 4) {
        text += used;
        n++;
    }
    return n;
}

static pov_box box_of(const sphere *b)
{
    const double r = b->radius * (1.0 + 0x1p-40);
    const pov_box box = { pov_sub(b->centre, pov_vec3_of(r, r, r)), pov_add(b->centre, pov_vec3_of(r, r, r)) };

    return box;
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    enum { MOST = 2000 };
    static pov_box boxes[MOST];
    heap *h = self;
    const char *name = host->string(in), *text;

    snprintf(last.name, sizeof last.name, "%s", name);
    host->accept(in, ",");
    host->vector_of(in, last.pair, 2);
    host->accept(in, ",");
    host->color(in, last.color);
    host->accept(in, ",");
    last.flag = host->boolean(in);
    if (host->accept(in, ","))
        host->vector_of(in, last.five, 5);
    text = host->file(in, name, &last.bytes);
    h->spheres = text ? host->alloc(in, MOST * sizeof *h->spheres) : NULL;
    h->count = h->spheres ? read_spheres(text, h->spheres, MOST) : 0;
    for (uint32_t i = 0; i < h->count; i++)
        boxes[i] = box_of(&h->spheres[i]);
    if (h->count > 0)
        h->hierarchy = host->hierarchy(in, boxes, h->count);
    else if (text)
        (host->fail)(in, "no sphere stands in \"%s\"", name);
}

static bool bounds(const void *self, pov_box *out)
{
    const heap *h = self;

    *out = box_of(&h->spheres[0]);
    for (uint32_t i = 1; i < h->count; i++) {
        const pov_box b = box_of(&h->spheres[i]);

        out->lo = pov_vec3_of(fmin(out->lo.x, b.lo.x), fmin(out->lo.y, b.lo.y), fmin(out->lo.z, b.lo.z));
        out->hi = pov_vec3_of(fmax(out->hi.x, b.hi.x), fmax(out->hi.y, b.hi.y), fmax(out->hi.z, b.hi.z));
    }
    return true;
}

/* The spheres that a ray meets, collected in the working memory first. */
typedef struct scratch { uint32_t count, part[]; } scratch;

static size_t scratch_size(const void *self) { return sizeof(scratch) + ((const heap *)self)->count * sizeof(uint32_t); }

static bool collect(void *user, uint32_t part)
{
    scratch *s = user;

    s->part[s->count++] = part;
    return true;
}

static bool report(const sphere *b, uint32_t part, const pov_ray *ray, pov_hits *hits)
{
    const pov_vec3 o = pov_add(pov_sub(ray->org, b->centre), ray->org_lo);
    const double a = pov_dot(ray->dir, ray->dir), h = pov_dot(o, ray->dir), c = pov_dot(o, o) - b->radius * b->radius;
    const double root = h * h - a * c;
    const pov_mark mark = { part, 0, 0.0, 0.0 };

    if (!(root >= 0.0) || (ray->origin_surface == hits->owner && ray->origin_mark.feature == part))
        return true;
    return pov_cross(hits, (-h - sqrt(root)) / a, 0.0, mark);
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const heap *h = self;
    scratch *s = hits->scratch;

    s->count = 0;
    h->hierarchy->visit(h->hierarchy, ray, hits, collect, s);
    for (uint32_t i = 0; i < s->count; i++)
        if (!report(&h->spheres[s->part[i]], s->part[i], ray, hits))
            return;
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const heap *h = self;
    const pov_vec3 p = pov_add(ray->org, pov_scale(ray->dir, at->t));

    *out = pov_unit(pov_add(pov_sub(p, h->spheres[at->mark.feature].centre), ray->org_lo));
}

static const pov_shape_class heap_class = {
    .size = sizeof heap_class, .keyword = "heap", .instance_size = sizeof(heap), .parse = parse, .bounds = bounds,
    .intersect = intersect, .normal = normal, .scratch = scratch_size,
};
static const pov_shape_class *const shapes[] = { &heap_class, NULL };
static const pov_plugin plugin = { POV_PLUGIN_ABI, sizeof plugin, "heap", "1", shapes, NULL, NULL };

/* ---- tests ---- */

enum { WIDTH = 80, HEIGHT = 60, SPHERES = 400 };

static char folder[] = "/tmp/povtrace-heap-XXXXXX";

static pov_context *context_with_heap(void)
{
    pov_context *context = scenes_context();

    assert_int_equal(pov_context_add_plugin(context, &plugin, NULL), POV_OK);
    return context;
}

static void put_sphere(FILE *list, FILE *scene, int i)
{
    const double x = fmod(0.754877 * i, 1.0) * 8.0 - 4.0, y = fmod(0.569840 * i, 1.0) * 6.0 - 3.0, z = fmod(0.3819 * i, 1.0) * 4.0;
    const double r = 0.05 + 0.25 * fmod(0.618 * i, 1.0);

    fprintf(list, "%.17g %.17g %.17g %.17g\n", x, y, z, r);
    fprintf(scene, "sphere { <%.17g, %.17g, %.17g>, %.17g pigment { rgb <1, .5, .2> } }\n", x, y, z, r);
}

static void put_view(FILE *scene)
{
    fputs("#version 3.7; camera { location <0, 0, -12> look_at 0 angle 40 } light_source { <5, 9, -20> rgb 1 }\n", scene);
}

static float *picture(pov_context *context, const char *name, int threads)
{
    pov_render_desc desc = POV_INIT(desc);
    pov_scene *scene = NULL;
    pov_error err;
    float *pixels;

    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.threads = threads;
    if (pov_scene_load_file(&scene, context, name, NULL, &err) < 0)
        fail_msg("%s: %s", name, err.message);
    pixels = scenes_render(scene, &desc);
    pov_scene_destroy(scene);
    return pixels;
}

/* The same spheres as primitives of their own. */
static void a_heap_from_a_file_is_drawn_like_its_spheres(void **state)
{
    FILE *list = fopen("spheres.txt", "w"), *many = fopen("spheres.pov", "w"), *one = fopen("heap.pov", "w");
    pov_context *context = context_with_heap();
    float *a, *b, *c;
    int different = 0;

    (void)state;
    put_view(many);
    put_view(one);
    fputs("heap { \"spheres.txt\", <2, 3>, color rgb <1, 0, .5>, on, <1, 2, 3, 4, 5> pigment { rgb <1, .5, .2> } }\n", one);
    for (int i = 1; i <= SPHERES; i++)
        put_sphere(list, many, i);
    fclose(list);
    fclose(many);
    fclose(one);
    a = picture(context, "heap.pov", 1);
    b = picture(context, "spheres.pov", 1);
    c = picture(context, "heap.pov", 4);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        different += fabsf(a[4 * i] - b[4 * i]) > 1e-5f;
    assert_true(different <= WIDTH * HEIGHT / 500);
    assert_memory_equal(a, c, 4 * sizeof *a * WIDTH * HEIGHT);
    assert_string_equal(last.name, "spheres.txt");
    assert_true(last.pair[0] == 2.0 && last.pair[1] == 3.0 && last.five[4] == 5.0 && last.flag && last.bytes > 1000);
    assert_true(last.color[0] == 1.0 && last.color[1] == 0.0 && last.color[2] == 0.5 && last.color[3] == 0.0);
    free(a);
    free(b);
    free(c);
    pov_context_destroy(context);
}

static void assert_fails(pov_context *context, const char *text, const char *message)
{
    pov_scene *scene;
    pov_error err;

    assert_true(pov_scene_load_text(&scene, context, text, strlen(text), "scene.pov", NULL, &err) < 0);
    if (!strstr(err.message, message))
        fail_msg("\"%s\" does not say \"%s\"", err.message, message);
    assert_true(err.line == 1 && err.column > 1);
}

static void what_a_service_cannot_do_is_an_error_with_its_place(void **state)
{
    pov_context *context = context_with_heap();

    (void)state;
    assert_fails(context, "heap { \"none.txt\", 1, rgb 1, off }", "there is no file \"none.txt\"");
    assert_fails(context, "heap { \"/etc/passwd\", 1, rgb 1, off }", "/etc/passwd");
    assert_fails(context, "heap { \"../escape.txt\", 1, rgb 1, off }", "escape.txt");
    assert_fails(context, "heap { 3, 1, rgb 1, off }", "string");
    assert_fails(context, "heap { \"spheres.txt\", \"x\", rgb 1, off }", "found a string");
    pov_context_destroy(context);
}

static int begin(void **state)
{
    (void)state;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int end(void **state)
{
    (void)state;
    remove("spheres.txt");
    remove("spheres.pov");
    remove("heap.pov");
    return chdir("/") == 0 ? rmdir(folder) : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_heap_from_a_file_is_drawn_like_its_spheres),
        cmocka_unit_test(what_a_service_cannot_do_is_an_error_with_its_place),
    };

    return cmocka_run_group_tests_name("host_services", tests, begin, end);
}
