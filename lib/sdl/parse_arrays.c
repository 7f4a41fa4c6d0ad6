#include "sdl/parse_arrays.h"

#include "sdl/frame.h"
#include "sdl/host_arrays.h"
#include "sdl/parse.h"

#include "base/hash.h"

#include <string.h>

/* Objects of one part. Their plain twin: the next object is the last leaf again but for its shape. */
typedef struct arrays {
    const build_part *part;
    symbol *word;
    const shape_class *shape;
    object_parsed object;        /* with its modifiers */
    bool twin;
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
    const build_material *m = parts_material(all, part->material);

    memset(a, 0, sizeof *a);
    a->part = a->rows.part = part;
    a->host = host_arrays();
    frame_begin_text(in, m ? m->text : "", m ? m->length : 0, "(material)");
    state_advance(in);
    a->word = in->failed ? NULL : find_word(in, part->word);
    a->shape = a->word ? parse_shape_class(in, a->word) : NULL;
    if (!a->shape && !in->failed)
        report_fail(in, &in->token.at, POV_E_PLUGIN, "no plugin for \"%s\" in %s", part->word, registry_path(in->plugins));
    parse_object_begin(in, &a->object);
    a->object.leaf.line = a->object.leaf.column = 0;
    a->object.kind = OBJECT_LEAF;
    a->object.leaf.shape = a->shape;
    parse_modifiers(in, &a->object, TOKEN_END);
    return !in->failed;
}

/* The scene's identity depends on its numbers. */
static void note_numbers(pov_reader *in, const build_part *part)
{
    for (int i = 0; i < BUILD_COLUMNS_MAX && part->columns[i].width > 0; i++) {
        const build_column *c = &part->columns[i];
        const bool is_dense = c->stride == (size_t)c->width;
        const size_t pieces = is_dense ? 1 : part->count, bytes = (size_t)c->width * (is_dense ? part->count : 1) * sizeof *c->at;

        for (size_t at = 0; at < pieces; at++)
            in->sources.hash = hash_bytes(in->sources.hash, c->at + at * c->stride, bytes);
    }
}

/* ---- one after the other ---- */

static bool read_shape(pov_reader *in, arrays *a, size_t row)
{
    leaf_node *leaf = &a->object.leaf;

    a->rows.row = row;
    a->rows.column = 0;
    leaf->instance = state_alloc(in, parse_shape_size(a->shape), 32);
    if (!leaf->instance)
        return false;
    a->shape->parse(leaf->instance, &a->host, in);
    if (!in->failed)
        parse_share_shape(in, a->word, leaf);
    return !in->failed;
}

/* Once an object has become one leaf and nothing else, those of its material do too, with the same map, flags and
 * material. */
static void add_first(pov_reader *in, arrays *a)
{
    const model *m = in->model;
    const size_t before = m->leaves.count, others = m->groups.count + m->texture_maps.count;

    parse_add_object(in, &a->object);
    a->twin = m->leaves.count == before + 1 && m->groups.count + m->texture_maps.count == others;
}

static void add_twin(pov_reader *in, const arrays *a)
{
    leaf_node leaf = in->model->leaves.items[in->model->leaves.count - 1];

    leaf.instance = a->object.leaf.instance;
    if (!model_add_leaf(in->model, &leaf))
        report_memory(in);
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
    for (size_t i = 0; i < part->count && read_shape(in, &a, i); i++)
        if (a.twin)
            add_twin(in, &a);
        else
            add_first(in, &a);
    in->rows = NULL;
}
