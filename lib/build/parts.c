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

static pov_status check_material(const scene_parts *p, uint32_t number, pov_error *err)
{
    if (number <= p->materials.count)
        return POV_OK;
    return err_set(err, POV_E_ARGUMENT, "there is no material %u: the builder has %zu", number, p->materials.count);
}

pov_status parts_add_shapes(scene_parts *p, const build_part *part, pov_error *err)
{
    pov_status status = check_material(p, part->material, err);

    if (status == POV_OK && part->count > UINT32_MAX / 2)
        status = err_set(err, POV_E_ARGUMENT, "%zu objects are more than a scene holds", part->count);
    for (int i = 0; status == POV_OK && i < BUILD_COLUMNS_MAX && part->columns[i].width > 0; i++)
        status = check_column(part, &part->columns[i], err);
    return status == POV_OK && part->count > 0 ? add_part(p, part, err) : status;
}
