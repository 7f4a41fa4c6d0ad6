#include "build/parts.h"

#include "base/err.h"
#include "base/vec.h"

#include <string.h>

void parts_init(scene_parts *p, const env *e)
{
    memset(p, 0, sizeof *p);
    p->env = e;
    arena_init(&p->texts, e);
}

void parts_free(scene_parts *p)
{
    env_free(p->env, p->parts.items);
    env_free(p->env, p->materials.items);
    arena_free(&p->texts);
}

static pov_status add_part(scene_parts *p, const build_part *part, pov_error *err)
{
    return VEC_PUSH(p->env, &p->parts, *part) ? POV_OK : err_memory(err);
}

/* ---- texts ---- */

pov_status parts_add_text(scene_parts *p, const char *text, size_t length, const char *name, pov_error *err)
{
    build_part part = { .kind = BUILD_TEXT, .length = length };

    if (!text)
        return err_set(err, POV_E_ARGUMENT, "a text was expected, NULL was given");
    name = name ? name : "(text)";
    part.text = arena_text(&p->texts, text, length);
    part.name = arena_text(&p->texts, name, strlen(name));
    return part.text && part.name ? add_part(p, &part, err) : err_memory(err);
}

pov_status parts_add_material(scene_parts *p, const char *text, uint32_t *number, pov_error *err)
{
    build_material m = { NULL, text ? strlen(text) : 0 };

    if (!text || !number)
        return err_set(err, POV_E_ARGUMENT, "a material takes a text, and a place for its number");
    if (p->materials.count >= UINT32_MAX - 1)
        return err_set(err, POV_E_ARGUMENT, "there are 2^32 - 2 materials already");
    m.text = arena_text(&p->texts, text, m.length);
    if (!m.text || !VEC_PUSH(p->env, &p->materials, m))
        return err_memory(err);
    *number = (uint32_t)p->materials.count;
    return POV_OK;
}

/* ---- shapes ---- */

/* Zero times an infinity or NaN is NaN. */
static bool are_finite(const double *at, int n)
{
    double sum = 0.0;

    for (int i = 0; i < n; i++)
        sum += 0.0 * at[i];
    return sum == 0.0;
}

static pov_status check_column(const build_part *part, const build_column *c, pov_error *err)
{
    if (!c->at && part->count > 0)
        return err_set(err, POV_E_ARGUMENT, "an array of %zu %s objects is NULL", part->count, part->word);
    for (size_t i = 0; i < part->count; i++)
        if (!are_finite(c->at + i * c->stride, c->width))
            return err_set(err, POV_E_ARGUMENT, "%s %zu of %zu has a number that is infinite or none", part->word, i, part->count);
    return POV_OK;
}

static pov_status check_columns(const build_part *part, pov_error *err)
{
    const build_each *each = &part->each;
    pov_status status = POV_OK;

    for (int i = 0; status == POV_OK && i < BUILD_COLUMNS_MAX && part->columns[i].width > 0; i++)
        status = check_column(part, &part->columns[i], err);
    if (status == POV_OK && each->colours.at)
        status = check_column(part, &each->colours, err);
    if (status == POV_OK && each->matrices.at)
        status = check_column(part, &each->matrices, err);
    return status;
}

static pov_status check_material(const scene_parts *p, uint32_t number, pov_error *err)
{
    if (number <= p->materials.count)
        return POV_OK;
    return err_set(err, POV_E_ARGUMENT, "there is no material %u: the builder has %zu", number, p->materials.count);
}

static pov_status check_materials(const scene_parts *p, const build_part *part, pov_error *err)
{
    pov_status status = check_material(p, part->material, err);

    for (size_t i = 0; status == POV_OK && part->each.materials && i < part->count; i++)
        status = check_material(p, part->each.materials[i], err);
    return status;
}

/* ---- lists ---- */

static pov_status check_list(const build_part *part, const build_list *l, pov_error *err)
{
    const build_column *c = &l->vectors;

    if (l->count > 1u << 30)
        return err_set(err, POV_E_ARGUMENT, "%s of %zu are more than a %s holds", l->word, l->count, part->word);
    if (!c->at && !l->indices && l->count > 0)
        return err_set(err, POV_E_ARGUMENT, "%s of %zu are NULL", l->word, l->count);
    for (size_t i = 0; c->at && i < l->count; i++)
        if (!are_finite(c->at + i * c->stride, c->width))
            return err_set(err, POV_E_ARGUMENT, "%s %zu of %zu has a number that is infinite or none", l->word, i, l->count);
    return POV_OK;
}

/* A lone vector is no array of the program's. */
static bool keep_vector(scene_parts *p, build_column *c)
{
    double *kept = arena_alloc(&p->texts, (size_t)c->width * sizeof *kept, sizeof *kept);

    if (kept)
        memcpy(kept, c->at, (size_t)c->width * sizeof *kept);
    c->at = kept;
    return kept != NULL;
}

/* The materials behind the items, each once, in a list in front of these; NULL: there is no memory. */
static const build_list *list_materials(scene_parts *p, build_list *to, build_list *items)
{
    const size_t most = p->materials.count + 1;
    uint32_t *places = arena_alloc(&p->texts, most * sizeof *places, sizeof *places);
    uint32_t *numbers = arena_alloc(&p->texts, most * sizeof *numbers, sizeof *numbers);

    if (!places || !numbers)
        return NULL;
    *to = (build_list){ .word = "texture_list", .textures = numbers };
    for (size_t i = 0; i < (size_t)items->width * items->count; i++)
        places[items->materials[i]] = 1;
    for (uint32_t number = 1; number < most; number++)
        if (places[number]) {
            places[number] = (uint32_t)to->count;
            numbers[to->count++] = number;
        }
    items->places = places;
    return to;
}

static pov_status check_face_materials(const scene_parts *p, const build_list *l, pov_error *err)
{
    pov_status status = POV_OK;

    for (size_t i = 0; status == POV_OK && i < (size_t)l->width * l->count; i++)
        status = check_material(p, l->materials[i], err);
    return status;
}

static pov_status keep_lists(scene_parts *p, build_part *part, pov_error *err)
{
    build_list *kept = arena_alloc(&p->texts, (part->list_count + 1) * sizeof *kept, sizeof(void *));
    pov_status status = kept ? POV_OK : err_memory(err);
    size_t count = 0;

    for (size_t i = 0; status == POV_OK && i < part->list_count; i++) {
        build_list l = part->lists[i];

        status = check_list(part, &l, err);
        if (status == POV_OK && l.is_bare && !keep_vector(p, &l.vectors))
            status = err_memory(err);
        if (status == POV_OK && l.materials)
            status = check_face_materials(p, &l, err);
        if (status == POV_OK && l.materials && !list_materials(p, &kept[count++], &l))
            status = err_memory(err);
        if (status == POV_OK)
            kept[count++] = l;
    }
    part->lists = kept;
    part->list_count = count;
    return status;
}

/* ---- the whole ---- */

pov_status parts_add_shapes(scene_parts *p, const build_part *given, pov_error *err)
{
    build_part part = *given;
    pov_status status = POV_OK;

    if (part.count > UINT32_MAX / 2)
        return err_set(err, POV_E_ARGUMENT, "%zu objects are more than a scene holds", part.count);
    status = check_materials(p, &part, err);
    if (status == POV_OK)
        status = check_columns(&part, err);
    if (status == POV_OK && part.list_count > 0)
        status = keep_lists(p, &part, err);
    return status == POV_OK && part.count > 0 ? add_part(p, &part, err) : status;
}

static bool is_axis(const pov_vec3 *v) { return are_finite(&v->x, 3) && pov_largest(*v) > 0.0; }

static bool is_usable(const pov_camera *c)
{
    return (int)c->type >= 0 && c->type < POV_CAMERA_TYPES && c->type != POV_CAMERA_MESH && are_finite(&c->location.x, 3) &&
           is_axis(&c->direction) && is_axis(&c->right) && is_axis(&c->up) && are_finite(c->angles, 2) &&
           are_finite(&c->lens_radius, 1) && are_finite(&c->focal_distance, 1) && c->lens_samples >= 0;
}

pov_status parts_add_camera(scene_parts *p, const pov_camera *camera, pov_error *err)
{
    build_part part = { .kind = BUILD_CAMERA };
    pov_camera *kept = arena_alloc(&p->texts, sizeof *kept, sizeof(double));

    if (!is_usable(camera))
        return err_set(err, POV_E_ARGUMENT, "the camera's numbers leave it no picture");
    if (!kept)
        return err_memory(err);
    *kept = *camera;
    part.camera = kept;
    return add_part(p, &part, err);
}
