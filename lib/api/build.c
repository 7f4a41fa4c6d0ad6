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

static pov_status add(pov_builder *builder, const build_part *part, pov_error *err)
{
    return builder ? parts_add_shapes(&builder->parts, part, err) : no_builder(err);
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
