/* contract.h - the tests that every plugin takes, in the order in which they are run. What each file asks is said at
 * its top. */
#ifndef PLUGINS_CONTRACT_H
#define PLUGINS_CONTRACT_H

/* contract_rays.c */
void crossings_lie_within_bounds(void **unused);
void an_ellipsoid_is_the_sphere_of_its_rows(void **unused);
void normals_are_unit(void **unused);
void inside_flips_where_a_ray_crosses(void **unused);
void crossings_ahead_tell_what_is_inside(void **unused);
void nearest_is_the_first_of_all_and_any_is_as_nearest(void **unused);
void what_was_found_before_only_ends_the_interval(void **unused);
void from_the_surface_the_nearest_beyond_a_distance_is_the_next(void **unused);
void zeros_of_a_direction_have_no_sign(void **unused);
void always_exact_finds_the_same(void **unused);
void counting_finds_as_many(void **unused);
void a_ray_without_a_direction_ends(void **unused);
void copies_behave_alike(void **unused);
void an_absorbed_map_is_as_a_mapped_ray(void **unused);

/* contract_certified.c */
void a_certified_distance_is_where_inside_changes(void **unused);
void a_certified_closed_shape_is_never_missed(void **unused);
void a_certified_distance_is_the_same_from_the_other_side(void **unused);
void a_certified_planar_surface_is_planar(void **unused);

/* contract_blocks.c */
void block_filters_never_exclude_a_crossing(void **unused);

/* contract_many.c */
void many_rays_get_the_results_of_single_ones(void **unused);
void many_rays_get_all_crossings_that_single_ones_get(void **unused);
void many_normals_are_those_of_single_ones(void **unused);
void many_shading_normals_are_those_of_single_ones(void **unused);
void normals_at_points_are_those_of_rays(void **unused);

/* contract_leaving.c */
void a_ray_that_leaves_never_hits_its_start(void **unused);
void a_box_or_sphere_fills_its_bounds(void **unused);
void a_convex_shape_is_left_for_good(void **unused);
void who_goes_into_a_closed_shape_comes_out_once(void **unused);
void exits_of_closed_shapes_are_sure(void **unused);
void faces_have_the_same_normal_from_everywhere(void **unused);

#endif
