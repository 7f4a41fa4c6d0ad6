/* The public calls: contexts, scenes, single rays, structs of other sizes, many threads at once. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/shape.h>

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char sphere[] = "light_source { <0, 0, -10> rgb 1 } sphere { <0, 0, 0>, 1 pigment { color red 1 } }";

/* ---- contexts ---- */

static void a_scene_outlives_its_context(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, sphere);
    pov_tracer *tracer;
    pov_hit hit = POV_INIT(hit);

    (void)state;
    pov_context_destroy(context);
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    assert_true(pov_trace_hit(tracer, pov_vec3_of(0, 0, -5), pov_vec3_of(0, 0, 1), &hit));
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
}

static void plugins_are_loaded_when_a_scene_names_them(void **state)
{
    pov_context *context = scenes_context();
    const char *name, *path;
    pov_scene *scene;

    (void)state;
    assert_false(pov_context_get_plugin(context, 0, &name, &path));
    scene = scenes_text(context, sphere);
    assert_true(pov_context_get_plugin(context, 0, &name, &path));
    assert_string_equal(name, "sphere");
    assert_string_equal(path, TEST_PLUGINS "/primitives/sphere.so");
    assert_false(pov_context_get_plugin(context, 1, &name, &path));
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void a_context_without_plugins_says_where_it_looked(void **state)
{
    pov_context_desc d = POV_INIT(d);
    pov_context *context;
    pov_scene *scene;
    pov_error err;

    (void)state;
    d.plugin_path = "/nowhere/a:/nowhere/b";
    assert_int_equal(pov_context_create(&context, &d, &err), POV_OK);
    assert_int_equal(pov_scene_load_text(&scene, context, sphere, strlen(sphere), NULL, NULL, &err), POV_E_PLUGIN);
    assert_non_null(strstr(err.message, "/nowhere/a"));
    assert_non_null(strstr(err.message, "/nowhere/b"));
    assert_int_equal(err.line, 1);
    assert_int_equal(err.column, 36);
    pov_context_destroy(context);
}

static void a_plugin_of_another_contract_is_refused(void **state)
{
    pov_plugin other = { POV_PLUGIN_ABI + 1, sizeof other, "other", "1", NULL, NULL, NULL };
    pov_plugin empty = { POV_PLUGIN_ABI, sizeof empty, "empty", "1", NULL, NULL, NULL };
    pov_context *context = scenes_context();
    pov_error err;

    (void)state;
    assert_int_equal(pov_context_add_plugin(context, &other, &err), POV_E_PLUGIN);
    assert_int_equal(pov_context_add_plugin(context, &empty, &err), POV_E_PLUGIN);
    assert_int_equal(pov_context_add_plugin(context, NULL, &err), POV_E_ARGUMENT);
    pov_context_destroy(context);
}

/* ---- arguments ---- */

static void missing_arguments_are_errors_and_not_crashes(void **state)
{
    pov_context *context = scenes_context();
    pov_render_desc d = { 0 };
    pov_scene *scene;
    pov_job *job;
    pov_error err;

    (void)state;
    assert_int_equal(pov_context_create(NULL, NULL, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_scene_load_file(&scene, context, NULL, NULL, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_scene_load_file(&scene, NULL, "x", NULL, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_scene_load_file(&scene, context, "/no/such.pov", NULL, &err), POV_E_IO);
    assert_string_equal(err.file, "/no/such.pov");
    scene = scenes_text(context, sphere);
    assert_int_equal(pov_job_create(&job, scene, NULL, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_job_create(&job, scene, &d, &err), POV_E_ARGUMENT);
    assert_null(job);
    pov_scene_destroy(scene);
    pov_scene_destroy(NULL);
    pov_context_destroy(context);
    pov_context_destroy(NULL);
}

static void structs_of_other_sizes_are_adapted(void **state)
{
    struct { pov_scene_info info; char newer[64]; } large;
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, sphere);
    pov_scene_info small;
    pov_camera camera;

    (void)state;
    memset(&large, 0x55, sizeof large);
    large.info.size = sizeof large;
    pov_scene_get_info(scene, &large.info);
    assert_int_equal(large.info.size, sizeof large);
    assert_int_equal(large.info.objects, 1);
    assert_int_equal(large.newer[0], 0);
    memset(&small, 0x55, sizeof small);
    small.size = offsetof(pov_scene_info, transfer);
    pov_scene_get_info(scene, &small);
    assert_int_equal(small.dialect, POV_DIALECT_COURSE);
    assert_int_equal(small.objects, (size_t)0x5555555555555555);
    memset(&camera, 0x55, sizeof camera);
    camera.size = sizeof camera;
    pov_scene_get_camera(scene, &camera);
    assert_true(camera.direction.z == 1.0 && camera.location.x == 0.0);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* ---- single rays ---- */

static void rays_hit_what_is_there(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, sphere);
    pov_tracer *tracer;
    pov_hit hit = POV_INIT(hit);
    pov_error err;
    float rgba[4];

    (void)state;
    assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
    assert_true(pov_trace_hit(tracer, pov_vec3_of(0, 0, -5), pov_vec3_of(0, 0, 2), &hit));
    assert_true(hit.distance == 2.0 && hit.point.z == -1.0 && hit.normal.z == -1.0 && hit.object == 0 && hit.certain);
    assert_true(pov_trace_hit(tracer, pov_vec3_of(0, 0, 0), pov_vec3_of(0, 0, 1e-200), &hit));
    assert_true(hit.normal.z == -1.0);
    assert_false(pov_trace_hit(tracer, pov_vec3_of(0, 0, -5), pov_vec3_of(0, 1, 0), &hit));
    assert_true(hit.certain);
    assert_false(pov_trace_hit(tracer, pov_vec3_of(0, 0, -5), pov_vec3_of(0, 0, 0), &hit));
    assert_false(pov_trace_hit(tracer, pov_vec3_of(NAN, 0, -5), pov_vec3_of(0, 0, 1), &hit));
    assert_true(pov_trace_blocked(tracer, pov_vec3_of(0, 0, -5), pov_vec3_of(0, 0, 5)));
    assert_false(pov_trace_blocked(tracer, pov_vec3_of(0, 0, -5), pov_vec3_of(0, 0, -1)));
    assert_int_equal(pov_trace_color(tracer, pov_vec3_of(0, 0, -5), pov_vec3_of(0, 0, 1), rgba, &err), POV_OK);
    assert_true(fabsf(rgba[0] - 0.6f) < 1e-6f && rgba[1] == 0.0f && rgba[3] == 1.0f);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

typedef struct crossings { size_t count, most; pov_hit at[64]; } crossings;

static bool note_crossing(void *user, const pov_hit *hit)
{
    crossings *c = user;

    assert_in_range(c->count, 0, 63);
    c->at[c->count++] = *hit;
    return c->count < c->most;
}

static crossings cross_all(const pov_scene *scene, pov_vec3 org, pov_vec3 dir, size_t most)
{
    crossings c = { .most = most };
    pov_tracer *tracer;

    size_t count;

    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    count = pov_trace_hits(tracer, org, dir, note_crossing, &c);
    assert_int_equal(count, c.count);
    pov_tracer_destroy(tracer);
    return c;
}

static void assert_crossing(const crossings *c, size_t i, uint32_t object, double distance, double normal)
{
    assert_int_equal(c->at[i].object, object);
    assert_true(c->at[i].distance == distance);
    assert_true(c->at[i].normal.z == normal);
}

static void assert_object(const pov_scene *scene, size_t index, const char *keyword, int line, int column)
{
    const char *word;
    int l, c;

    assert_true(pov_scene_get_object(scene, index, &word, &l, &c));
    assert_string_equal(word, keyword);
    assert_int_equal(l, line);
    assert_int_equal(c, column);
}

/* What is merged, intersected or cut is one object; members of a union are objects of their own, unless they share an
 * interior; what is clipped is what it was. */
static void a_solid_made_of_others_is_one_object(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context,
                                   "difference { sphere { 0, 2 } sphere { <0, 0, -1.5>, 1 } }\n"
                                   "union { sphere { <0, 0, 4>, 1 } sphere { <0, 0, 7>, 1 } }\n"
                                   " union { sphere { <9, 0, 0>, 1 } sphere { <9, 0, 1>, 1 } interior { ior 1.5 } }\n"
                                   "box { <-1, -1, 9>, <1, 1, 10> clipped_by { sphere { <0, 0, 9>, 0.5 } } }");
    crossings c;

    (void)state;
    assert_int_equal(pov_scene_object_count(scene), 5);
    assert_object(scene, 0, "difference", 1, 1);
    assert_object(scene, 2, "sphere", 2, 33);
    assert_object(scene, 3, "union", 3, 2);
    assert_object(scene, 4, "box", 4, 1);
    c = cross_all(scene, pov_vec3_of(0, 0, -4), pov_vec3_of(0, 0, 1), 64);
    assert_int_equal(c.count, 7);
    assert_crossing(&c, 0, 0, 3.5, -1.0);
    assert_crossing(&c, 1, 0, 6.0, -1.0);
    assert_crossing(&c, 2, 1, 7.0, -1.0);
    assert_crossing(&c, 4, 2, 10.0, -1.0);
    assert_crossing(&c, 6, 4, 13.0, -1.0);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void every_surface_on_the_way_is_seen(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, "sphere { 0, 1 } sphere { 0, 2 } quadric { <0, 0, 0>, <0, 0, 0>, <0, 0, 1>, -4 }"
                                            "box { <-1, -1, 4>, <1, 1, 5> } box { <-1, -1, 5>, <1, 1, 7> }");
    crossings c;

    (void)state;
    c = cross_all(scene, pov_vec3_of(0, 0, -4), pov_vec3_of(0, 0, 0.5), 64);
    assert_int_equal(c.count, 9);
    assert_crossing(&c, 0, 1, 4.0, -1.0);
    assert_crossing(&c, 1, 0, 6.0, -1.0);
    assert_crossing(&c, 2, 0, 10.0, -1.0);
    assert_crossing(&c, 3, 1, 12.0, -1.0);
    /* The box begins on the plane, which is the end of what lies below it: entered first, and then left. */
    assert_crossing(&c, 4, 3, 16.0, -1.0);
    assert_crossing(&c, 5, 2, 16.0, -1.0);
    assert_crossing(&c, 6, 4, 18.0, -1.0);
    assert_crossing(&c, 7, 3, 18.0, -1.0);
    assert_crossing(&c, 8, 4, 22.0, -1.0);
    c = cross_all(scene, pov_vec3_of(0, 0, -4), pov_vec3_of(0, 0, 0.5), 3);
    assert_int_equal(c.count, 3);
    c = cross_all(scene, pov_vec3_of(0, 9, -4), pov_vec3_of(0, 0, -1), 64);
    assert_int_equal(c.count, 0);
    c = cross_all(scene, pov_vec3_of(0, 0, 0), pov_vec3_of(0, 0, 0), 64);
    assert_int_equal(c.count, 0);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* Along the middle of a pile of a thousandth part of what a step would be with an absolute epsilon. */
static void thin_and_far_surfaces_are_all_seen(void **state)
{
    char text[4096];
    pov_context *context = scenes_context();
    pov_scene *scene;
    crossings c;
    size_t used = 0;

    (void)state;
    for (int i = 0; i < 20; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "box { <-1, -1, %.17g>, <1, 1, %.17g> }\n",
                                 1e6 + i * 4e-9, 1e6 + i * 4e-9 + 2e-9);
    scene = scenes_text(context, text);
    c = cross_all(scene, pov_vec3_of(0.1, 0.2, 0), pov_vec3_of(1e-9, -1e-9, 1), 64);
    assert_int_equal(c.count, 40);
    for (size_t i = 0; i < c.count; i++)
        assert_int_equal(c.at[i].object, i / 2);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* Past the sphere of radius 1 by the last bit of 1, along its edge, and within it by half of that. */
static void a_miss_says_whether_it_was_certain(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, sphere);
    pov_tracer *tracer;
    pov_hit hit = POV_INIT(hit);

    (void)state;
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    assert_false(pov_trace_hit(tracer, pov_vec3_of(0x1.0000000000001p0, 0, -5), pov_vec3_of(0, 0, 1), &hit));
    assert_false(hit.certain);
    assert_false(pov_trace_hit(tracer, pov_vec3_of(1.5, 0, -5), pov_vec3_of(0, 0, 1), &hit));
    assert_true(hit.certain);
    assert_true(pov_trace_hit(tracer, pov_vec3_of(0x1.fffffffffffffp-1, 0, -5), pov_vec3_of(0, 0, 1), &hit));
    assert_false(hit.certain);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void a_camera_can_be_turned(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, sphere);
    pov_camera camera = POV_INIT(camera);
    pov_vec3 up = pov_vec3_of(0, 1, 0);

    (void)state;
    pov_scene_get_camera(scene, &camera);
    assert_int_equal(pov_camera_look_at(&camera, pov_vec3_of(10, 0, 0), pov_vec3_of(0, 0, 0), up, NULL), POV_OK);
    assert_true(camera.direction.x == -1.0 && camera.right.z > 1.3 && camera.up.y == 1.0);
    assert_int_equal(pov_camera_look_at(&camera, up, up, up, NULL), POV_E_ARGUMENT);
    assert_int_equal(pov_camera_look_at(&camera, pov_vec3_of(0, 0, 0), up, up, NULL), POV_E_ARGUMENT);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void wait_for(pov_job *job)
{
    while (pov_job_wait(job, 10.0) == POV_JOB_RUNNING)
        continue;
}

static void a_restart_with_no_real_camera_keeps_the_one_it_had(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, "sphere { <0, 0, 4>, 1 pigment { color red 1 } finish { ambient 1 } }"
                                            "global_settings { ambient_light rgb 1 }");
    const pov_rect middle = { 8, 6, 1, 1 };
    pov_render_desc d = POV_INIT(d);
    pov_camera nothing = { 0 };
    float rgba[4] = { 0 };
    pov_job *job;

    (void)state;
    d.width = 16;
    d.height = 12;
    assert_int_equal(pov_job_create(&job, scene, &d, NULL), POV_OK);
    assert_int_equal(pov_job_start(job, NULL), POV_OK);
    wait_for(job);
    pov_job_restart(job, &nothing);
    wait_for(job);
    pov_job_read(job, middle, POV_PIXELS_LINEAR_FLOAT, rgba, sizeof rgba);
    assert_true(rgba[0] == 1.0f);
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* ---- messages ---- */

typedef struct notes { int warnings; pov_error last; } notes;

static void note(void *user, pov_log_level level, const pov_error *message)
{
    notes *n = user;

    n->warnings += level == POV_LOG_WARN;
    n->last = *message;
}

static void warnings_come_through_the_log_with_their_place(void **state)
{
    static const char text[] = "sphere {\n <0,0,0>, -1\n}";
    pov_context_desc d = POV_INIT(d);
    pov_context *context;
    pov_scene *scene;
    notes n = { 0 };

    (void)state;
    d.plugin_path = TEST_PLUGINS;
    d.log = note;
    d.log_user = &n;
    assert_int_equal(pov_context_create(&context, &d, NULL), POV_OK);
    assert_int_equal(pov_scene_load_text(&scene, context, text, strlen(text), "w.pov", NULL, NULL), POV_OK);
    assert_int_equal(n.warnings, 1);
    assert_int_equal(n.last.line, 2);
    assert_string_equal(n.last.file, "w.pov");
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* ---- many at once ---- */

enum { THREADS = 4, ROUNDS = 6 };

/* NULL when all went well. */
static void *load_and_render(void *user)
{
    pov_context *context = user;
    char text[400];
    int i;

    for (i = 0; i < ROUNDS; i++) {
        pov_render_desc d = POV_INIT(d);
        pov_scene *scene;
        float *pixels;

        snprintf(text, sizeof text, "%s box { <-1,-3,0>, <1,-2,%d> } cylinder { <3,0,0>, <3,1,0>, .5 }", sphere, i + 1);
        if (pov_scene_load_text(&scene, context, text, strlen(text), NULL, NULL, NULL) < 0)
            return context;
        d.width = 40;
        d.height = 30;
        d.threads = 2;
        pixels = scenes_render(scene, &d);
        if (!(pixels[4 * (40 * 15 + 20)] >= 0.0f))
            return context;
        free(pixels);
        pov_scene_destroy(scene);
    }
    return NULL;
}

static void loads_and_renders_run_side_by_side(void **state)
{
    pov_context *contexts[2];
    pthread_t threads[THREADS];
    void *wrong;
    int i;

    (void)state;
    contexts[0] = scenes_context();
    contexts[1] = scenes_context();
    for (i = 0; i < THREADS; i++)
        assert_int_equal(pthread_create(&threads[i], NULL, load_and_render, contexts[i % 2]), 0);
    for (i = 0; i < THREADS; i++) {
        pthread_join(threads[i], &wrong);
        assert_null(wrong);
    }
    pov_context_destroy(contexts[0]);
    pov_context_destroy(contexts[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_scene_outlives_its_context),
        cmocka_unit_test(plugins_are_loaded_when_a_scene_names_them),
        cmocka_unit_test(a_context_without_plugins_says_where_it_looked),
        cmocka_unit_test(a_plugin_of_another_contract_is_refused),
        cmocka_unit_test(missing_arguments_are_errors_and_not_crashes),
        cmocka_unit_test(structs_of_other_sizes_are_adapted),
        cmocka_unit_test(rays_hit_what_is_there),
        cmocka_unit_test(every_surface_on_the_way_is_seen),
        cmocka_unit_test(a_solid_made_of_others_is_one_object),
        cmocka_unit_test(thin_and_far_surfaces_are_all_seen),
        cmocka_unit_test(a_miss_says_whether_it_was_certain),
        cmocka_unit_test(a_camera_can_be_turned),
        cmocka_unit_test(a_restart_with_no_real_camera_keeps_the_one_it_had),
        cmocka_unit_test(warnings_come_through_the_log_with_their_place),
        cmocka_unit_test(loads_and_renders_run_side_by_side),
    };

    return cmocka_run_group_tests_name("api", tests, NULL, NULL);
}
