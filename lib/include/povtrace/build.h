/* povtrace/build.h - scenes from arrays of a program, mixed with scene text.
 *
 * A builder notes what the calls add, in their order. pov_scene_load_builder() reads it all as one scene text: the scene is
 * bit for bit that of the text that each call names, and names that a text declares are known to all that follows. Arrays
 * are not copied: they must stay as they are until the last pov_scene_load_builder() has returned. */
#ifndef POVTRACE_BUILD_H
#define POVTRACE_BUILD_H

#include <povtrace/scene.h>

/* For one thread at a time. Bad arguments, infinities and NaN among them, are errors of the call that is given them; it adds
 * nothing. What only the shapes themselves can refuse is an error of loading, with the index of the object. */
typedef struct pov_builder pov_builder;

POV_API pov_status pov_builder_create(pov_builder **out, pov_context *context, pov_error *err);
POV_API void pov_builder_destroy(pov_builder *builder);

/* Whole statements, copied. `name` stands for a file's name in messages; NULL: "(text)". */
POV_API pov_status pov_builder_add_text(pov_builder *builder, const char *text, size_t length, const char *name, pov_error *err);

/* What stands behind the numbers of a shape: `pigment { rgb x } finish { phong 1 } rotate 30*y`, copied. It is read once for
 * each call that has this material. POV_NO_MATERIAL: nothing stands there. */
#define POV_NO_MATERIAL 0u
POV_API pov_status pov_builder_material(pov_builder *builder, const char *text, uint32_t *material, pov_error *err);

/* sphere { CENTRE, RADIUS MATERIAL }, cylinder { BASE, TOP, RADIUS MATERIAL }, cone { BASE, RADIUS, TOP, RADIUS MATERIAL },
 * box { CORNER, CORNER MATERIAL }, `count` of them. */
POV_API pov_status pov_builder_add_spheres(pov_builder *builder, size_t count, const pov_vec3 *centres, const double *radii,
                                           uint32_t material, pov_error *err);
POV_API pov_status pov_builder_add_cylinders(pov_builder *builder, size_t count, const pov_vec3 *bases, const pov_vec3 *tops,
                                             const double *radii, uint32_t material, pov_error *err);
POV_API pov_status pov_builder_add_cones(pov_builder *builder, size_t count, const pov_vec3 *bases, const double *base_radii,
                                         const pov_vec3 *tops, const double *top_radii, uint32_t material, pov_error *err);
POV_API pov_status pov_builder_add_boxes(pov_builder *builder, size_t count, const pov_vec3 *corners,
                                         const pov_vec3 *opposite, uint32_t material, pov_error *err);
/* triangle { A, B, C MATERIAL }, or with normals smooth_triangle { A, N, B, N, C, N MATERIAL }: three of each a triangle.
 * Corners on a line are a warning, as in a text. */
POV_API pov_status pov_builder_add_triangles(pov_builder *builder, size_t count, const pov_vec3 *corners,
                                             const pov_vec3 *normals, uint32_t material, pov_error *err);

/* Read and compile all that was added, as often as wanted. desc may be NULL. */
POV_API pov_status pov_scene_load_builder(pov_scene **out, const pov_builder *builder, const pov_load_desc *desc,
                                          pov_error *err);

#endif
