#include "sdl/parse_arrays.h"

#include "sdl/frame.h"
#include "sdl/host_arrays.h"
#include "sdl/materials.h"
#include "sdl/parse.h"

#include "base/hash.h"

#include <string.h>

/* What objects of one material have in common. Once one of them has become a leaf and nothing else, the others do too, with
 * the same map, flags and material: the leaf again but for its shape. Where objects have colours of their own, the same holds
 * but for the pigment, as long as that is constant. */
typedef struct style {
    object_parsed object;        /* with its modifiers */
    leaf_node leaf;
    material material;           /* of that leaf */
    bool is_twin;
} style;

/* Objects of one part. */
typedef struct arrays {
    const scene_parts *all;
    const build_part *part;
    symbol *word;
    const shape_class *shape;
    style **styles;                /* by number of the material; NULL: not read yet */
    array_rows rows;
    pov_host host;
} arrays;

/* ---- before the objects ---- */

static symbol *find_word(pov_reader *in, const char *name)
{
    symbol *word = symbols_named(&in->words, name);
    place at = { in->top->text, in->top->text->text, 0, 1, 1 };

    if (word && !(word->flags & KEYWORD_FLAG_BASE))
        state_note_povray(in, &at);
    return word;
}

static bool begin(pov_reader *in, const scene_parts *all, const build_part *part, arrays *a)
{
    memset(a, 0, sizeof *a);
    a->all = all;
    a->part = a->rows.part = part;
    a->rows.all = all;
    a->host = part->list_count > 0 ? host_lists() : host_arrays();
    host_begin_material(in, NULL);
    a->word = in->failed ? NULL : find_word(in, part->word);
    a->shape = a->word ? parse_shape_class(in, a->word) : NULL;
    if (!a->shape && !in->failed)
        report_fail(in, &in->token.at, POV_E_PLUGIN, "no plugin for \"%s\" in %s", part->word, registry_path(in->plugins));
    a->styles = in->failed ? NULL : arena_alloc(&in->members, (all->materials.count + 1) * sizeof *a->styles, sizeof(void *));
    if (!a->styles && !in->failed)
        report_memory(in);
    return !in->failed;
}

/* ---- the scene's identity depends on its numbers ---- */

static void note(pov_reader *in, const void *at, size_t bytes) { in->sources.hash = hash_bytes(in->sources.hash, at, bytes); }

static void note_column(pov_reader *in, const build_column *c, size_t count)
{
    const bool is_dense = c->stride == (size_t)c->width;
    const size_t pieces = is_dense ? 1 : count, bytes = (size_t)c->width * (is_dense ? count : 1) * sizeof *c->at;

    for (size_t at = 0; at < pieces && c->at; at++)
        note(in, c->at + at * c->stride, bytes);
}

static void note_numbers(pov_reader *in, const build_part *part)
{
    for (int i = 0; i < BUILD_COLUMNS_MAX && part->columns[i].width > 0; i++)
        note_column(in, &part->columns[i], part->count);
    for (size_t i = 0; i < part->list_count; i++) {
        const build_list *l = &part->lists[i];

        note_column(in, &l->vectors, l->count);
        if (l->indices)
            note(in, l->indices, 3 * l->count * sizeof *l->indices);
        if (l->materials)
            note(in, l->materials, (size_t)l->width * l->count * sizeof *l->materials);
    }
    note_column(in, &part->each.colours, part->count);
    note_column(in, &part->each.matrices, part->count);
    if (part->each.materials)
        note(in, part->each.materials, part->count * sizeof *part->each.materials);
}

/* ---- one after the other ---- */

/* NULL: the reader has failed. */
static style *read_style(pov_reader *in, arrays *a, uint32_t number)
{
    style *l = arena_alloc(&in->members, sizeof *l, sizeof(double));

    host_begin_material(in, parts_material(a->all, number));
    if (!l)
        report_memory(in);
    if (in->failed)
        return NULL;
    parse_object_begin(in, &l->object);
    l->object.leaf.line = l->object.leaf.column = 0;
    l->object.kind = OBJECT_LEAF;
    l->object.leaf.shape = a->shape;
    parse_modifiers(in, &l->object, TOKEN_END);
    a->styles[number] = l;
    return in->failed ? NULL : l;
}

static style *style_of(pov_reader *in, arrays *a)
{
    const build_part *part = a->part;
    const uint32_t number = part->each.materials ? part->each.materials[a->rows.row] : part->material;

    return a->styles[number] ? a->styles[number] : read_style(in, a, number);
}

static bool read_shape(pov_reader *in, arrays *a, object_parsed *o)
{
    leaf_node *leaf = &o->leaf;
    part_list parts;

    a->rows.column = 0;
    a->rows.list = NULL;
    leaf->instance = state_alloc(in, parse_shape_size(a->shape), 32);
    if (!leaf->instance)
        return false;
    parse_parts_begin(in, &parts);
    a->shape->parse(leaf->instance, &a->host, in);
    parse_parts_end(in, &parts, o);
    if (!in->failed)
        parse_share_shape(in, a->word, leaf);
    return !in->failed;
}

static const double *at_row(const build_column *c, size_t row) { return c->at ? c->at + row * c->stride : NULL; }

/* As the text of a colour gives it. */
static pigment pigment_of(const double *c, int width)
{
    const float filter = width > 3 ? (float)c[3] : 0.0f, transmit = width > 4 ? (float)c[4] : 0.0f;

    return (pigment){ colour_of((float)c[0], (float)c[1], (float)c[2]), filter, transmit };
}

/* The first object of its style, or one that must be read whole. */
static void add_whole(pov_reader *in, const arrays *a, style *l)
{
    const model *m = in->model;
    const build_column *colours = &a->part->each.colours;
    const double *rgbft = at_row(colours, a->rows.row), *matrix = at_row(&a->part->each.matrices, a->rows.row);
    const size_t before = m->leaves.count, others = m->groups.count + m->texture_maps.count;
    object_parsed o = l->object;

    if (rgbft) {
        const pigment p = pigment_of(rgbft, colours->width);

        parse_object_colour(in, &o, &p);
    }
    if (matrix && !parse_object_matrix(in, &o, matrix) && !in->failed)
        a->host.fail(in, "the matrix has no inverse");
    if (in->failed)
        return;
    parse_add_object(in, &o);
    /* Of clipped ones some may be leaves, and others not. */
    if (in->failed || matrix || o.clips || m->leaves.count != before + 1 || m->groups.count + m->texture_maps.count != others)
        return;
    l->leaf = m->leaves.items[before];
    l->material = m->materials.items[l->leaf.material];
    l->is_twin = !rgbft || (!l->material.texture && !l->material.inside);
}

static void add_twin(pov_reader *in, const arrays *a, style *l)
{
    const build_column *colours = &a->part->each.colours;
    const double *rgbft = at_row(colours, a->rows.row);

    if (rgbft) {
        material_set_pigment(&l->material, pigment_of(rgbft, colours->width));
        l->leaf.material = materials_index(in, &l->material);
    }
    l->leaf.instance = l->object.leaf.instance;
    if (!in->failed && !model_add_leaf(in->model, &l->leaf))
        report_memory(in);
}

static void add_object(pov_reader *in, arrays *a)
{
    style *l = style_of(in, a);

    if (!l || !read_shape(in, a, &l->object))
        return;
    if (l->is_twin)
        add_twin(in, a, l);
    else
        add_whole(in, a, l);
}

void parse_arrays(pov_reader *in, const scene_parts *all, const build_part *part)
{
    const surface_parsed defaults = *in->defaults;
    arrays a;

    memset(&in->object, 0, sizeof in->object);
    in->placed = &defaults;
    if (!begin(in, all, part, &a))
        return;
    note_numbers(in, part);
    in->rows = &a.rows;
    for (; a.rows.row < part->count && !in->failed; a.rows.row++)
        add_object(in, &a);
    in->rows = NULL;
}

/* ---- lights ---- */

void parse_array_lights(pov_reader *in, const scene_parts *all, const build_part *part)
{
    note_numbers(in, part);
    for (size_t i = 0; i < part->count && !in->failed; i++) {
        const double *position = at_row(&part->columns[0], i), *rgb = at_row(&part->columns[1], i);
        object_parsed o;

        host_begin_material(in, parts_material(all, part->material));
        if (in->failed)
            return;
        parse_object_begin(in, &o);
        o.light.position = pov_vec3_of(position[0], position[1], position[2]);
        o.light.color = colour_of((float)rgb[0], (float)rgb[1], (float)rgb[2]);
        parse_light_modifiers(in, &o);
        if (!in->failed)
            parse_add_object(in, &o);
    }
}

/* ---- the camera ---- */

void parse_given_camera(pov_reader *in, const build_part *part)
{
    parse_camera_defaults(&in->camera);
    in->camera.given = part->camera;
    note(in, part->camera, sizeof *part->camera);
}
