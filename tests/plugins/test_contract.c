/* test_contract.c - what every primitive plugin promises, asked of each .so in a folder.
 *
 * test_contract [FOLDER or FILE ...]: by default the build's own plugins, and the one built out of tree. A
 * plugin of a keyword that the table does not know is given random numbers until it takes some, so a new
 * primitive passes, or fails, unchanged. */
#include "plugins/contract.h"
#include "plugins/subject.h"

#include "support/check.h"
#include "support/fake_reader.h"
#include "support/scenes.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- the class itself ---- */

static void the_form_is_kept(void **unused)
{
    const shape_class *s = subject.shape;
    const char *name = strrchr(subject.file, '/');

    (void)unused;
    assert_non_null(s->keyword);
    assert_true(s->instance_size > 0 && s->parse && s->bounds && s->intersect && s->normal);
    assert_true(!(s->flags & POV_SHAPE_SOLID) || HAS(inside));
    name = name ? name + 1 : subject.file;
    assert_int_equal(strncmp(name, s->keyword, strlen(s->keyword)), 0);
    assert_string_equal(name + strlen(s->keyword), ".so");
    if (HAS(block_pack))
        assert_true(s->block_size > 0 && s->block_filter);
}

static void garbage_never_crashes_parse(void **unused)
{
    static const char *const words[] = { "<", ">", ",", "open", "{", "}", "pigment", "-", "nan", "\"" };
    static const double odd[] = {0.0, -0.0, 1e308, -1e308,   5e-324,    1e-320, -1.0,
                                 3.0, 4.0,  1e9,   HUGE_VAL, -HUGE_VAL, NAN};
    void *self = subject_memory();
    int round, i;

    (void)unused;
    for (round = 0; round < 20000; round++) {
        const int n = (int)(24.0 * subject_uniform());
        pov_crossing at[MOST];
        pov_box box;

        fake_reader_clear(subject.in);
        for (i = 0; i < n; i++) {
            if (subject_uniform() < 0.4)
                fake_reader_word(subject.in, words[(int)(10.0 * subject_uniform())]);
            else
                fake_reader_number(subject.in, subject_uniform() < 0.5 ? odd[(int)(13.0 * subject_uniform())]
                                                                       : 8.0 * subject_uniform() - 4.0);
        }
        /* What it takes, it must also survive being asked. */
        if (fake_reader_parse_into(subject.in, subject.shape, self)) {
            const pov_ray ray = subject_ray(&subject.things[0]);

            subject.shape->bounds(self, &box);
            subject_ask(self, &ray, at);
            if (HAS(inside))
                subject.shape->inside(self, ray.org, ray.org_lo);
        }
    }
}

/* ---- folders ---- */

/* Fonts, functions and pictures are not here; scenes/test has some. */
static bool needs_scene(const char *keyword)
{
    static const char *const words[] = { "text", "isosurface", "parametric", "height_field" };

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(words[i], keyword) == 0)
            return true;
    return false;
}

static int check_file(const char *file)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_form_is_kept),
        cmocka_unit_test(crossings_lie_within_bounds),
        cmocka_unit_test(an_ellipsoid_is_the_sphere_of_its_rows),
        cmocka_unit_test(normals_are_unit),
        cmocka_unit_test(inside_flips_where_a_ray_crosses),
        cmocka_unit_test(crossings_ahead_tell_what_is_inside),
        cmocka_unit_test(nearest_is_the_first_of_all_and_any_is_as_nearest),
        cmocka_unit_test(what_was_found_before_only_ends_the_interval),
        cmocka_unit_test(from_the_surface_the_nearest_beyond_a_distance_is_the_next),
        cmocka_unit_test(zeros_of_a_direction_have_no_sign),
        cmocka_unit_test(always_exact_finds_the_same),
        cmocka_unit_test(counting_finds_as_many),
        cmocka_unit_test(a_certified_distance_is_where_inside_changes),
        cmocka_unit_test(a_certified_closed_shape_is_never_missed),
        cmocka_unit_test(a_certified_distance_is_the_same_from_the_other_side),
        cmocka_unit_test(a_certified_planar_surface_is_planar),
        cmocka_unit_test(a_ray_without_a_direction_ends),
        cmocka_unit_test(copies_behave_alike),
        cmocka_unit_test(an_absorbed_map_is_as_a_mapped_ray),
        cmocka_unit_test(block_filters_never_exclude_a_crossing),
        cmocka_unit_test(many_rays_get_the_results_of_single_ones),
        cmocka_unit_test(many_rays_get_all_crossings_that_single_ones_get),
        cmocka_unit_test(many_normals_are_those_of_single_ones),
        cmocka_unit_test(many_shading_normals_are_those_of_single_ones),
        cmocka_unit_test(normals_at_points_are_those_of_rays),
        cmocka_unit_test(a_ray_that_leaves_never_hits_its_start),
        cmocka_unit_test(a_box_or_sphere_fills_its_bounds),
        cmocka_unit_test(a_convex_shape_is_left_for_good),
        cmocka_unit_test(who_goes_into_a_closed_shape_comes_out_once),
        cmocka_unit_test(exits_of_closed_shapes_are_sure),
        cmocka_unit_test(faces_have_the_same_normal_from_everywhere),
        cmocka_unit_test(garbage_never_crashes_parse),
    };
    int failed;

    if (!subject_set_up(file)) {
        if (subject.shape && needs_scene(subject.shape->keyword))
            return 0;
        print_error("%s: no shape could be made\n", file);
        return 1;
    }
    failed = cmocka_run_group_tests_name(subject.shape->keyword, tests, NULL, NULL);
    fake_reader_destroy(subject.in);
    return failed;
}

static bool is_plugin(const char *name)
{
    const size_t n = strlen(name);
    return n > 3 && strcmp(name + n - 3, ".so") == 0;
}

static int order(const void *a, const void *b) { return strcmp(a, b); }

static int check_folder(const char *folder)
{
    static char files[256][1024];
    DIR *d = opendir(folder);
    const struct dirent *entry;
    int count = 0, failed = 0, i;

    if (!d)
        return check_file(folder);
    while (count < 256 && (entry = readdir(d)) != NULL) {
        if (is_plugin(entry->d_name))
            snprintf(files[count++], sizeof files[0], "%s/%s", folder, entry->d_name);
    }
    closedir(d);
    qsort(files, (size_t)count, sizeof files[0], order);
    for (i = 0; i < count; i++)
        failed += check_file(files[i]);
    return count == 0 || failed;
}

int main(int argc, char **argv)
{
    int i, failed = 0;

    if (argc < 2)
        return check_folder(TEST_PRIMITIVES)
               + check_folder(TEST_BUILD "/tests/plugins/out_of_tree");
    for (i = 1; i < argc; i++)
        failed += check_folder(argv[i]);
    return failed != 0;
}
