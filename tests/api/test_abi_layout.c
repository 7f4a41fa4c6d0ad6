/* The layout that old programs and plugins were compiled with: members may be added behind these, none may move.
 * On a machine with 64-bit pointers. */
#include "support/check.h"

#include <povtrace/shape_fast.h>
#include <povtrace/povtrace.h>

#define AT(type, member, offset) assert_int_equal(offsetof(type, member), offset)

static void program_structs_stay_where_they_are(void **state)
{
    (void)state;
    AT(pov_error, file, 16);
    AT(pov_error, message, 272);
    AT(pov_error, excerpt, 784);
    AT(pov_error, hint, 1040);
    AT(pov_context_desc, plugin_path, 40);
    AT(pov_load_desc, threads, 20);
    AT(pov_load_desc, accuracy, 24);
    AT(pov_load_desc, most_rays, 128);
    AT(pov_load_desc, progress, 136);
    AT(pov_camera, up, 80);
    AT(pov_camera, type, 104);
    AT(pov_scene_info, max_trace_level, 88);
    AT(pov_scene_info, has_camera, 92);
    AT(pov_plan_row, reason, 32);
    AT(pov_hit, certain, 68);
    AT(pov_hit, shading_normal, 72);
    AT(pov_render_desc, wake_user, 64);
    AT(pov_render_desc, seed, 104);
    AT(pov_render_desc, time_map, 112);
    AT(pov_render_desc, note, 128);
    AT(pov_progress, counts, 40);
    AT(pov_progress, stop, 136);
    AT(pov_progress, round, 160);
    AT(pov_pass, counts, 48);
    AT(pov_pass, clipped, 184);
    AT(pov_class_counts, escalated, 24);
    AT(pov_bitmap, rgba, 24);
    AT(pov_panel, share, 112);
    AT(pov_plot, panel_count, 40);
    AT(pov_image_options, format, 16);
    AT(pov_image_options, layers, 40);
}

static void plugin_structs_stay_where_they_are(void **state)
{
    (void)state;
    AT(pov_ray, origin_surface, 72);
    AT(pov_ray, origin_mark, 80);
    AT(pov_crossing, mark, 24);
    AT(pov_hits, at, 40);
    AT(pov_hits, user, 56);
    AT(pov_hits, scratch, 72);
    AT(pov_host, warn, 64);
    AT(pov_host, hierarchy, 112);
    AT(pov_host, heights, 120);
    AT(pov_host, resize, 128);
    AT(pov_host, more_numbers, 160);
    AT(pov_shape_class, intersect, 40);
    AT(pov_shape_class, prepare, 80);
    AT(pov_shape_class, extension, 104);
    AT(pov_shape_class, open, 112);
    AT(pov_shape_class, textures, 136);
    AT(pov_shape_class, face, 144);
    AT(pov_image, pixels, 32);
    AT(pov_image, alpha, 40);
    AT(pov_image, gamma, 48);
    AT(pov_image, layers, 56);
    AT(pov_image_format, write, 16);
    AT(pov_image_format, read, 24);
    AT(pov_image_format, load, 32);
    AT(pov_raster, channels, 20);
    AT(pov_raster, power, 32);
    AT(pov_raster, palette, 48);
    AT(pov_raster, stride, 64);
    AT(pov_plugin, images, 32);
    AT(pov_plugin, plots, 40);
    assert_int_equal(POV_PLUGIN_ABI, 4);
}

/* Unstable: a new layout is a new name. */
static void the_fast_extension_stays_as_its_name_says(void **state)
{
    (void)state;
    AT(pov_candidate, ray, 16);
    AT(pov_candidate, definite_pair, 19);
    AT(pov_shape_fast, block_filter, 32);
    AT(pov_shape_fast, ellipsoid, 64);
    AT(pov_shape_fast, block_bounds, 152);
    AT(pov_ellipsoid, row, 48);
    AT(pov_rays, inverse, 4608);
    AT(pov_rays, tmax, 6144);
    AT(pov_rays, local.size, 8448);
    AT(pov_rays, local.unit, 9472);
    assert_string_equal(POV_SHAPE_FAST, "povtrace.shape_fast.1");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(program_structs_stay_where_they_are),
        cmocka_unit_test(plugin_structs_stay_where_they_are),
        cmocka_unit_test(the_fast_extension_stays_as_its_name_says),
    };

    return cmocka_run_group_tests_name("abi_layout", tests, NULL, NULL);
}
