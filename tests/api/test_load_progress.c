/* Loading tells how far it is, and ends when the program wants no more. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SPHERES = 20000 };

typedef struct watch { int calls, until; double last, worst_step; size_t objects; bool fell; } watch;

static bool note(void *user, double fraction, size_t objects)
{
    watch *w = user;
    const double step = fraction - w->last;

    w->fell = w->fell || step < 0.0 || objects < w->objects;
    if (fraction <= 0.5 && step > w->worst_step)
        w->worst_step = step;
    w->last = fraction;
    w->objects = objects;
    return ++w->calls != w->until;
}

static char *many_spheres(void)
{
    char *text = malloc(40 * SPHERES + 100), *to = text;

    assert_non_null(text);
    to += sprintf(to, "#version 3.7; camera { location -9*z }\n");
    for (int i = 0; i < SPHERES; i++)
        to += sprintf(to, "sphere { <%d, %d, %d>, .3 }\n", i % 30, i / 30 % 30, i / 900);
    return text;
}

static pov_status load(pov_scene **scene, const char *text, watch *w, pov_error *err)
{
    pov_context *context = scenes_context();
    pov_load_desc desc = POV_INIT(desc);
    pov_status status;

    desc.progress = note;
    desc.progress_user = w;
    status = pov_scene_load_text(scene, context, text, strlen(text), "many.pov", &desc, err);
    pov_context_destroy(context);
    return status;
}

static void loading_says_how_far_it_is(void **state)
{
    char *text = many_spheres();
    watch w = { .until = -1 };
    pov_error err = { 0 };
    pov_scene *scene;

    (void)state;
    assert_int_equal(load(&scene, text, &w, &err), POV_OK);
    assert_true(w.calls > 20 && !w.fell && w.last == 1.0);
    assert_true(w.worst_step < 0.05);
    assert_int_equal(w.objects, SPHERES);
    pov_scene_destroy(scene);
    free(text);
}

/* At any call; nothing is left behind, which a leak would tell. */
static void loading_is_cancelled_at_any_call(void **state)
{
    char *text = many_spheres();
    watch all = { .until = -1 };
    pov_scene *scene;

    (void)state;
    assert_int_equal(load(&scene, text, &all, NULL), POV_OK);
    pov_scene_destroy(scene);
    for (int i = 1; i <= all.calls; i += i < all.calls - 6 ? 11 : 1) {
        watch w = { .until = i };
        pov_error err = { 0 };

        assert_int_equal(load(&scene, text, &w, &err), POV_E_CANCELLED);
        assert_null(scene);
        assert_int_equal(w.calls, i);
        assert_int_equal(err.status, POV_E_CANCELLED);
        assert_string_equal(err.message, "loading was cancelled");
    }
    free(text);
}

/* What stands still in the text, such as a loop. */
static void what_takes_long_is_cancelled(void **state)
{
    static const char *const texts[] = {
        "#version 3.7; #declare I = 0; #while (1) #declare I = I + 1; #end",
        "#version 3.7; #while (1) sphere { 0, 1 } #end",
        "#version 3.7; #macro M() #local X = 1; #end #while (1) M() #end",
        "#version 3.7; sphere { 0, 1 pigment { image_map { function 100, 3000 { pigment { rgb x } } } } }",
        "#version 3.7; sphere { 0, 1 pigment { image_pattern { function 100, 3000 { x } } } }",
    };

    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        watch w = { .until = 9 };
        pov_error err = { 0 };
        pov_scene *scene;

        assert_int_equal(load(&scene, texts[i], &w, &err), POV_E_CANCELLED);
        assert_true(err.line == 1 && err.column > 10);
        assert_int_equal(w.calls, 9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loading_says_how_far_it_is),
        cmocka_unit_test(loading_is_cancelled_at_any_call),
        cmocka_unit_test(what_takes_long_is_cancelled),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
