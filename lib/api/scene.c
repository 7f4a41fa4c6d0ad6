#include "api/adapt.h"
#include "api/explain.h"
#include "api/handles.h"
#include "base/clock.h"
#include "base/file.h"
#include "base/str.h"
#include "base/share.h"
#include "bvh/hierarchy.h"
#include "render/raygen.h"
#include "sdl/reader.h"

#include <povtrace/build.h>
#include <povtrace/math.h>

/* ---- loading ---- */

/* The text is read: fractions beyond 1/2. */
static pov_status tell(const pov_scene *scene, const pov_load_desc *d, double fraction, pov_error *err)
{
    if (d->progress && !d->progress(d->progress_user, fraction, scene->model.leaves.count))
        return err_set(err, POV_E_CANCELLED, "loading was cancelled");
    return POV_OK;
}

/* Half of it is reading. */
static bool tell_reading(void *user, double fraction, size_t objects)
{
    const pov_load_desc *d = user;

    return d->progress(d->progress_user, 0.5 * fraction, objects);
}

static pov_status compile(pov_scene *scene, const pov_load_desc *d, pov_error *err)
{
    world_options options = { d->accel, d->threads, d->accuracy == POV_ACCURACY_MAX, &scene->model };
    double start = clock_seconds();
    pov_status status;

    scene->model.soft_lights = d->soft_lights;
    scene->model.identity += d->soft_lights + 2u * d->quick_colours;   /* checkpoints of the one are none of the other */
    status = tell(scene, d, 0.5, err);
    if (status == POV_OK)
        status = world_create(&scene->world, &scene->model, &options, err);
    if (status == POV_OK)
        status = tell(scene, d, 0.9, err);
    if (status == POV_OK)
        status = explain_world(&scene->explanation, &scene->model, scene->world, err);
    if (status == POV_OK)
        status = explain_plugins(&scene->explanation, &scene->model, scene->context->plugins, err);
    if (status == POV_OK)
        status = shading_create(&scene->shading, &scene->model, scene->world, err);
    if (status == POV_OK)
        status = tell(scene, d, 1.0, err);
    scene->build_seconds = clock_seconds() - start;
    return status;
}

static void destroy_hierarchy(void *item) { hierarchy_destroy(item); }

static const pov_hierarchy *make_hierarchy(model *m, int threads, uint32_t n,
                                           void (*box)(void *user, uint32_t item, pov_box *out), void *user,
                                           uint32_t *order)
{
    const hierarchy_items items = { n, box, user, order, share_threads(threads) };
    hierarchy *h = hierarchy_create(m->env, &items);

    return h && model_keep(m, h, destroy_hierarchy) ? hierarchy_service(h) : NULL;
}

static reader_options reader_options_of(const pov_load_desc *d)
{
    reader_options o = { .dialect = d->dialect, .max_trace_level = d->max_trace_level, .strict = d->strict, .quick_colours = d->quick_colours,
                         .width = d->width, .height = d->height, .library_path = d->library_path,
                         .write_path = d->write_path, .declares = d->declares, .hierarchy = make_hierarchy,
                         .threads = d->threads };
    const pov_animation *a = d->animation;

    o.limits = (reader_limits){ d->limits.depth, d->limits.array, d->limits.string, d->limits.turns,
                                  d->limits.memory, d->limits.seconds, d->most_input, d->most_images };
    if (a)
        o.frames = (reader_frames){ true, a->clock, a->initial_clock, a->final_clock, a->clock_delta,
                                    a->frame, a->initial_frame, a->final_frame };
    return o;
}

static pov_status read_parts(pov_scene *scene, const scene_parts *parts, const char *name, const pov_load_desc *d, pov_error *err)
{
    reader_options options = reader_options_of(d);
    pov_load_desc told = *d;
    double start = clock_seconds();
    pov_status status;

    scene->model.most_rays = d->most_rays;
    options.progress = d->progress ? tell_reading : NULL;
    options.progress_user = &told;
    status = reader_read_parts(&scene->model, scene->context->plugins, parts, name, &options, err);

    scene->parse_seconds = clock_seconds() - start;
    return status;
}

static pov_status read_text(pov_scene *scene, const char *text, size_t length, const char *name, const pov_load_desc *d,
                            pov_error *err)
{
    build_part part = { .kind = BUILD_TEXT, .text = text, .name = name, .length = length };
    const scene_parts one = { .parts = { &part, 1, 1 } };

    return read_parts(scene, &one, name, d, err);
}

static pov_status create(pov_scene **out, pov_context *context, pov_error *err)
{
    pov_scene *scene = env_alloc(&context->env, 1, sizeof *scene);

    if (!scene)
        return err_memory(err);
    context_retain(context);
    scene->context = context;
    model_init(&scene->model, &context->env);
    explain_init(&scene->explanation, &context->env);
    *out = scene;
    return POV_OK;
}

static pov_status check(pov_scene **out, pov_context *context, const void *text, const pov_load_desc *desc,
                        pov_load_desc *ours, pov_error *err)
{
    pov_status status;

    if (out)
        *out = NULL;
    if (!out || !context || !text)
        return err_set(err, POV_E_ARGUMENT, "a scene needs a place, a context and a text");
    status = adapt_in(ours, sizeof *ours, desc, "the load description", err);
    if (status < 0)
        return status;
    if (ours->dialect < POV_DIALECT_AUTO || ours->dialect > POV_DIALECT_POVRAY || ours->accel < POV_ACCEL_TREE ||
        ours->accel > POV_ACCEL_NONE || ours->max_trace_level < 0 || ours->threads < 0 ||
        ours->width < 0 || ours->height < 0 || ours->accuracy < POV_ACCURACY_CERTIFIED || ours->accuracy > POV_ACCURACY_MAX)
        return err_set(err, POV_E_ARGUMENT, "the load description holds a value out of its range");
    return POV_OK;
}

/* Compile the model to a world; a scene that failed is freed. Lines of included files are rare there: an object is named by
 * the scene's own. */
static pov_status conclude(pov_scene **out, pov_scene *scene, const char *name, const pov_load_desc *d, pov_status status,
                           pov_error *err)
{
    if (status == POV_OK) {
        status = compile(scene, d, err);
        if (status < 0 && err && err->line > 0 && !err->file[0])
            str_copy(err->file, sizeof err->file, name);
    }
    if (status < 0)
        pov_scene_destroy(scene);
    else
        *out = scene;
    return status;
}

pov_status pov_scene_load_file(pov_scene **out, pov_context *context, const char *path, const pov_load_desc *desc,
                               pov_error *err)
{
    pov_load_desc d;
    pov_status status = check(out, context, path, desc, &d, err);
    pov_scene *scene = NULL;
    char *text;
    size_t length;

    if (status < 0)
        return status;
    status = create(&scene, context, err);
    if (status < 0)
        return status;
    status = d.most_input ? file_read_most(&context->env, path, d.most_input, &text, &length, err)
                          : file_read(&context->env, path, &text, &length, err);
    if (status == POV_OK) {
        /* The text is freed before the world is made: both need not be in memory at once. */
        status = read_text(scene, text, length, path, &d, err);
        env_free(&context->env, text);
    }
    return conclude(out, scene, path, &d, status, err);
}

pov_status pov_scene_load_text(pov_scene **out, pov_context *context, const char *text, size_t length,
                               const char *name, const pov_load_desc *desc, pov_error *err)
{
    pov_load_desc d;
    pov_status status = check(out, context, text, desc, &d, err);
    pov_scene *scene = NULL;

    if (status == POV_OK)
        status = create(&scene, context, err);
    if (status < 0)
        return status;
    status = read_text(scene, text, length, name ? name : "(text)", &d, err);
    return conclude(out, scene, name ? name : "(text)", &d, status, err);
}

pov_status pov_scene_load_builder(pov_scene **out, const pov_builder *builder, const pov_load_desc *desc, pov_error *err)
{
    pov_load_desc d;
    pov_status status = check(out, builder ? builder->context : NULL, builder, desc, &d, err);
    pov_scene *scene = NULL;

    if (status == POV_OK)
        status = create(&scene, builder->context, err);
    if (status < 0)
        return status;
    status = read_parts(scene, &builder->parts, "(builder)", &d, err);
    return conclude(out, scene, "(builder)", &d, status, err);
}

void pov_scene_destroy(pov_scene *scene)
{
    pov_context *context;

    if (!scene)
        return;
    context = scene->context;
    explain_free(&scene->explanation);
    shading_destroy(scene->shading);
    world_destroy(scene->world);
    model_free(&scene->model);
    env_free(&context->env, scene);
    context_release(context);
}

/* ---- asking ---- */

void pov_scene_get_camera(const pov_scene *scene, pov_camera *out)
{
    if (scene && out)
        adapt_out(out, &scene->model.camera, sizeof scene->model.camera);
}

size_t pov_scene_object_count(const pov_scene *scene)
{
    return !scene ? 0 : model_object_count(&scene->model);
}

bool pov_scene_get_object(const pov_scene *scene, size_t index, const char **keyword, int *line, int *column)
{
    const struct solid_node *solid;
    const struct leaf_node *leaf;
    uint32_t first;

    if (!scene || index >= model_object_count(&scene->model))
        return false;
    solid = model_object(&scene->model, (uint32_t)index, &first);
    if (solid && solid->op == NODE_CLIP)
        solid = NULL;
    leaf = model_leaf(&scene->model, first);
    if (keyword)
        *keyword = solid ? model_op_keyword(solid->op) : leaf->shape->keyword;
    if (line)
        *line = (int)(solid ? solid->line : leaf->line);
    if (column)
        *column = (int)(solid ? solid->column : leaf->column);
    return true;
}

bool pov_scene_get_bounds(const pov_scene *scene, pov_box *out)
{
    return scene && out && world_bounds(scene->world, out);
}

void pov_scene_get_info(const pov_scene *scene, pov_scene_info *out)
{
    const model *m;
    pov_scene_info info = POV_INIT(info);

    if (!scene || !out)
        return;
    m = &scene->model;
    info.dialect = m->dialect;
    info.dialect_reason = m->dialect_reason;
    info.transfer = m->gamma.transfer;
    info.parse_seconds = scene->parse_seconds;
    info.build_seconds = scene->build_seconds;
    info.objects = model_object_count(m);
    info.infinite_objects = world_get_facts(scene->world).infinite;
    info.lights = m->lights.count;
    info.materials = m->materials.count;
    info.warnings = m->warnings;
    info.max_trace_level = m->max_trace_level;
    info.has_camera = m->has_camera;
    adapt_out(out, &info, sizeof info);
}

bool pov_scene_get_plan(const pov_scene *scene, size_t index, pov_plan_row *out)
{
    const explain_row_list *rows;
    pov_plan_row row = POV_INIT(row);

    if (!scene || !out || index >= scene->explanation.rows.count)
        return false;
    rows = &scene->explanation.rows;
    row.used = rows->items[index].used;
    row.subject = rows->items[index].subject;
    row.state = rows->items[index].state;
    row.reason = rows->items[index].reason;
    adapt_out(out, &row, sizeof row);
    return true;
}

/* ---- cameras ---- */

static double length(pov_vec3 v)
{
    double m = pov_largest(v);

    return m > 0.0 ? m * sqrt(pov_dot(pov_scale(v, 1.0 / m), pov_scale(v, 1.0 / m))) : 0.0;
}

bool pov_camera_ray(const pov_camera *camera, double u, double v, pov_vec3 *org, pov_vec3 *dir)
{
    const raygen_screen through = { .u = { u }, .v = { v } };
    pov_camera ours;
    pov_ray ray;

    if (!org || !dir || !camera || adapt_in(&ours, sizeof ours, camera, "the camera", NULL) < 0 ||
        (unsigned)ours.type >= POV_CAMERA_TYPES)
        return false;
    raygen_begin(&ours, &ray, 1);
    raygen_aim(&ours, &through, 1, &ray);
    *org = ray.org;
    *dir = ray.dir;
    return isfinite(ray.org.x + ray.org.y + ray.org.z) && pov_largest(pov_unit(ray.dir)) > 0.0;
}

pov_status pov_camera_look_at(pov_camera *camera, pov_vec3 location, pov_vec3 target, pov_vec3 sky, pov_error *err)
{
    pov_vec3 forward = pov_unit(pov_sub(target, location)), side = pov_unit(pov_cross_product(sky, forward));
    double direction, right, up;

    if (!camera)
        return err_set(err, POV_E_ARGUMENT, "no camera was given");
    if (pov_largest(forward) == 0.0)
        return err_set(err, POV_E_ARGUMENT, "the camera cannot look at its own location");
    if (pov_largest(side) == 0.0)
        return err_set(err, POV_E_ARGUMENT, "the sky lies along the view");
    direction = length(camera->direction);
    right = length(camera->right);
    up = length(camera->up);
    camera->location = location;
    camera->direction = pov_scale(forward, direction);
    camera->right = pov_scale(side, right);
    camera->up = pov_scale(pov_cross_product(forward, side), up);
    return POV_OK;
}
