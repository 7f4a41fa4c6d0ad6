#include "api/adapt.h"
#include "api/handles.h"
#include "base/err.h"

#include <povtrace/build.h>

pov_status pov_builder_create(pov_builder **out, pov_context *context, pov_error *err)
{
    pov_builder *made;

    if (out)
        *out = NULL;
    if (!out || !context)
        return err_set(err, POV_E_ARGUMENT, "a builder needs a place and a context");
    made = env_alloc(&context->env, 1, sizeof *made);
    if (!made)
        return err_memory(err);
    context_retain(context);
    made->context = context;
    parts_init(&made->parts, &context->env);
    *out = made;
    return POV_OK;
}

void pov_builder_destroy(pov_builder *builder)
{
    pov_context *context;

    if (!builder)
        return;
    context = builder->context;
    parts_free(&builder->parts);
    env_free(&context->env, builder);
    context_release(context);
}

static pov_status no_builder(pov_error *err) { return err_set(err, POV_E_ARGUMENT, "no builder was given"); }

pov_status pov_builder_add_text(pov_builder *builder, const char *text, size_t length, const char *name, pov_error *err)
{
    return builder ? parts_add_text(&builder->parts, text, length, name, err) : no_builder(err);
}

pov_status pov_builder_material(pov_builder *builder, const char *text, uint32_t *number, pov_error *err)
{
    return builder ? parts_add_material(&builder->parts, text, number, err) : no_builder(err);
}

/* ---- shapes ---- */

/* Every stride-th vector from the index on. */
static build_column vectors(const pov_vec3 *at, size_t stride, size_t index)
{
    return (build_column){ at ? &at[index].x : NULL, 3 * stride, 3 };
}

static build_column numbers(const double *at) { return (build_column){ at, 1, 1 }; }

pov_status pov_builder_each(pov_builder *builder, const pov_each *each, pov_error *err)
{
    pov_each e;
    pov_status status = builder ? adapt_in(&e, sizeof e, each, "what differs", err) : no_builder(err);

    if (status < 0)
        return status;
    if (e.colours && (e.channels < 3 || e.channels > 5))
        return err_set(err, POV_E_ARGUMENT, "a colour has 3 to 5 channels, not %d", e.channels);
    builder->each.materials = e.materials;
    builder->each.colours = (build_column){ e.colours, (size_t)e.channels, e.channels };
    builder->each.matrices = (build_column){ e.matrices, 12, 12 };
    return POV_OK;
}

static pov_status add(pov_builder *builder, const build_part *given, pov_error *err)
{
    static const build_each none;
    build_part part = *given;

    if (!builder)
        return no_builder(err);
    part.each = builder->each;
    builder->each = none;
    return parts_add_shapes(&builder->parts, &part, err);
}

pov_status pov_builder_add_spheres(pov_builder *builder, size_t count, const pov_vec3 *centres, const double *radii,
                                   uint32_t look, pov_error *err)
{
    const build_part part = { .kind = BUILD_SHAPES, .word = "sphere", .count = count, .material = look,
                              .columns = { vectors(centres, 1, 0), numbers(radii) } };

    return add(builder, &part, err);
}

pov_status pov_builder_add_cylinders(pov_builder *builder, size_t count, const pov_vec3 *bases, const pov_vec3 *tops,
                                     const double *radii, uint32_t look, pov_error *err)
{
    const build_part part = { .kind = BUILD_SHAPES, .word = "cylinder", .count = count, .material = look,
                              .columns = { vectors(bases, 1, 0), vectors(tops, 1, 0), numbers(radii) } };

    return add(builder, &part, err);
}

pov_status pov_builder_add_cones(pov_builder *builder, size_t count, const pov_vec3 *bases, const double *base_radii,
                                 const pov_vec3 *tops, const double *top_radii, uint32_t look, pov_error *err)
{
    const build_part part = { .kind = BUILD_SHAPES, .word = "cone", .count = count, .material = look,
                              .columns = { vectors(bases, 1, 0), numbers(base_radii), vectors(tops, 1, 0),
                                           numbers(top_radii) } };

    return add(builder, &part, err);
}

pov_status pov_builder_add_boxes(pov_builder *builder, size_t count, const pov_vec3 *corners, const pov_vec3 *opposite,
                                 uint32_t look, pov_error *err)
{
    const build_part part = { .kind = BUILD_SHAPES, .word = "box", .count = count, .material = look,
                              .columns = { vectors(corners, 1, 0), vectors(opposite, 1, 0) } };

    return add(builder, &part, err);
}

pov_status pov_builder_add_triangles(pov_builder *builder, size_t count, const pov_vec3 *corners, const pov_vec3 *normals,
                                     uint32_t look, pov_error *err)
{
    const build_part flat = { .kind = BUILD_SHAPES, .word = "triangle", .count = count, .material = look,
                              .columns = { vectors(corners, 3, 0), vectors(corners, 3, 1), vectors(corners, 3, 2) } };
    const build_part smooth = { .kind = BUILD_SHAPES, .word = "smooth_triangle", .count = count, .material = look,
                                .columns = { vectors(corners, 3, 0), vectors(normals, 3, 0), vectors(corners, 3, 1),
                                             vectors(normals, 3, 1), vectors(corners, 3, 2), vectors(normals, 3, 2) } };

    return add(builder, normals ? &smooth : &flat, err);
}

/* ---- meshes ---- */

/* Add a list if there is anything to list. */
static void list_vectors(build_part *part, build_list *to, const char *word, const double *at, int width, size_t count)
{
    if (at || count > 0)
        to[part->list_count++] = (build_list){ .word = word, .count = count, .vectors = { at, (size_t)width, width } };
}

static void list_faces(build_part *part, build_list *to, const char *word, const uint32_t *faces, size_t count)
{
    if (faces)
        to[part->list_count++] = (build_list){ .word = word, .count = count, .indices = faces };
}

pov_status pov_builder_add_mesh(pov_builder *builder, const pov_mesh *mesh, uint32_t look, pov_error *err)
{
    enum { LISTS = 7 };
    build_list lists[LISTS];
    build_part part = { .kind = BUILD_SHAPES, .word = "mesh2", .count = 1, .material = look, .lists = lists };
    pov_mesh m;
    pov_status status = adapt_in(&m, sizeof m, mesh, "the mesh", err);

    if (status < 0)
        return status;
    if (!m.corners || !m.faces)
        return err_set(err, POV_E_ARGUMENT, "a mesh has corners and faces");
    if (m.face_materials && m.materials_a_face != 1 && m.materials_a_face != 3)
        return err_set(err, POV_E_ARGUMENT, "a face has 1 or 3 materials, not %d", m.materials_a_face);
    list_vectors(&part, lists, "vertex_vectors", &m.corners->x, 3, m.corner_count);
    list_vectors(&part, lists, "normal_vectors", m.normals ? &m.normals->x : NULL, 3, m.normal_count);
    list_vectors(&part, lists, "uv_vectors", m.uvs, 2, m.uv_count);
    list_faces(&part, lists, "face_indices", m.faces, m.face_count);
    lists[part.list_count - 1].materials = m.face_materials;
    lists[part.list_count - 1].width = m.materials_a_face;
    list_faces(&part, lists, "normal_indices", m.normals ? m.normal_faces : NULL, m.face_count);
    list_faces(&part, lists, "uv_indices", m.uvs ? m.uv_faces : NULL, m.face_count);
    if (pov_largest(m.inside) > 0.0)
        lists[part.list_count++] = (build_list){ .word = "inside_vector", .count = 1, .vectors = { &m.inside.x, 3, 3 },
                                                 .is_bare = true };
    return add(builder, &part, err);
}

/* ---- lights and the camera ---- */

pov_status pov_builder_add_lights(pov_builder *builder, size_t count, const pov_vec3 *positions, const pov_vec3 *colours,
                                  uint32_t look, pov_error *err)
{
    const build_part part = { .kind = BUILD_LIGHTS, .word = "light_source", .count = count, .material = look,
                              .columns = { vectors(positions, 1, 0), vectors(colours, 1, 0) } };

    return builder ? parts_add_shapes(&builder->parts, &part, err) : no_builder(err);
}

pov_status pov_builder_camera(pov_builder *builder, const pov_camera *camera, pov_error *err)
{
    pov_camera c;
    pov_status status = builder ? adapt_in(&c, sizeof c, camera, "the camera", err) : no_builder(err);

    return status < 0 ? status : parts_add_camera(&builder->parts, &c, err);
}
