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

/* mesh2 { vertex_vectors { ... } ... MATERIAL }: `faces` has three numbers of corners for each face. normals and uvs (two
 * numbers each) are those of the corners, or faces of their own say which; they may be NULL. inside not 0: the inside_vector. */
typedef struct pov_mesh {
    size_t size;
    const pov_vec3 *corners;
    size_t corner_count;
    const uint32_t *faces;
    size_t face_count;
    const pov_vec3 *normals;
    size_t normal_count;
    const uint32_t *normal_faces;
    const double *uvs;
    size_t uv_count;
    const uint32_t *uv_faces;
    pov_vec3 inside;
    /* A material for each face, or POV_NO_MATERIAL: the call's; or three, of its corners. They are textures of a texture_list, in
     * the order of their numbers. NULL: all faces have the call's. */
    const uint32_t *face_materials;
    int materials_a_face;        /* 1 or 3 */
} pov_mesh;

/* One object. mesh is copied, its arrays are not. */
POV_API pov_status pov_builder_add_mesh(pov_builder *builder, const pov_mesh *mesh, uint32_t material, pov_error *err);

/* What differs from object to object of the next call that adds shapes, and of that call only. Arrays have an element for each
 * object, or are NULL: a material instead of the call's; behind it `pigment { color rgb C }`, or rgbf, rgbft; and behind that
 * `matrix <M>`, twelve numbers each. */
typedef struct pov_each {
    size_t size;
    const uint32_t *materials;
    const double *colours;
    int channels;                /* numbers of a colour: 3, 4 or 5 */
    const double *matrices;
} pov_each;

POV_API pov_status pov_builder_each(pov_builder *builder, const pov_each *each, pov_error *err);

/* light_source { POSITION, rgb COLOUR MATERIAL }; here the material is the text of a light: `spotlight point_at 0`. It is read
 * for each light. */
POV_API pov_status pov_builder_add_lights(pov_builder *builder, size_t count, const pov_vec3 *positions,
                                          const pov_vec3 *colours, uint32_t material, pov_error *err);
/* The camera, as pov_scene_get_camera() gives it: nothing of it depends on the dialect. Of several cameras the last counts. */
POV_API pov_status pov_builder_camera(pov_builder *builder, const pov_camera *camera, pov_error *err);

/* Read and compile all that was added, as often as wanted. desc may be NULL. */
POV_API pov_status pov_scene_load_builder(pov_scene **out, const pov_builder *builder, const pov_load_desc *desc,
                                          pov_error *err);

#endif
