#include "sdl/patterns.h"

#include "sdl/unsupported.h"
#include "sdl/value.h"
#include "texture/pattern.h"

#include <string.h>

/* A pattern and its own transformations, of which the map is made when it is first used: names may hold it, and go on
 * moving copies. */
typedef struct pattern_parsed {
    pattern pattern;             /* first: materials point to it */
    const transform *moves;
} pattern_parsed;

/* ---- lists ---- */

static void read_list(pov_reader *in, pigment *list, uint32_t count)
{
    for (uint32_t i = 0; i < count && value_colour_follows(in, true); i++) {
        const paint p = value_colour(in, true);

        list[i].color = p.colour;
        list[i].filter = p.filter;
        list[i].transmit = p.transmit;
        state_accept(in, ',');
    }
}

static pattern_parsed *add(pov_reader *in, const pattern_class *class, const pigment *list)
{
    pattern_parsed *p = state_alloc(in, sizeof *p, sizeof(double));
    pigment *kept = state_alloc(in, class->count * sizeof *kept, sizeof(double));

    if (!p || !kept)
        return NULL;
    memcpy(kept, list, class->count * sizeof *kept);
    p->pattern.class = class;
    p->pattern.list = kept;
    p->pattern.count = class->count;
    return p;
}

/* In many scenes object after object has the same pattern written out: what is as the last one was is that one. */
static const pattern_parsed *share(pov_reader *in, const pattern_class *class, const pigment *list)
{
    const pattern_parsed *last = in->last_pattern;

    if (!last || last->pattern.class != class || memcmp(last->pattern.list, list, class->count * sizeof *list) != 0)
        in->last_pattern = last = add(in, class, list);
    return last;
}

bool patterns_read(pov_reader *in, surface_parsed *s)
{
    const bool is_word = in->token.kind == TOKEN_WORD && in->token.symbol->id != KEYWORD_OTHER;
    const pattern_class *class = is_word ? pattern_find(in->token.symbol->name) : NULL;
    pigment list[PATTERN_LIST_MAX];
    const pattern_parsed *p;

    if (!class)
        return false;
    state_advance(in);
    if (state_keyword(in) == KEYWORD_PIGMENT || state_keyword(in) == KEYWORD_TEXTURE) {
        unsupported_note(in, &in->last, state_keyword(in), "a list of pigments or textures");
        return true;
    }
    memcpy(list, class->list, sizeof list);
    read_list(in, list, class->count);
    p = share(in, class, list);
    if (p) {
        material_set_pattern(&s->material, &p->pattern);
        s->moves = 0;
    }
    return true;
}

/* ---- spaces ---- */

void patterns_move(pov_reader *in, void *self, keyword_id keyword)
{
    surface_parsed *s = self;
    const pattern_parsed *old = (const pattern_parsed *)(const void *)s->material.pattern;
    const transform *unused = NULL;
    pattern_parsed *p;

    if (!old) {
        parse_transform(in, &unused, keyword);
        return;
    }
    p = state_alloc(in, sizeof *p, sizeof(double));
    if (!p)
        return;
    *p = *old;
    p->pattern.map = 0;
    parse_transform(in, &p->moves, keyword);
    s->material.pattern = &p->pattern;
}

uint32_t patterns_count_moves(const transform *list)
{
    uint32_t count = 0;

    for (; list; list = list->before)
        count++;
    return count;
}

static bool compose(pov_reader *in, const transform *list, pov_affine *out)
{
    place at = in->object;

    if (in->failed)
        return false;
    if (!transform_compose(list, out))
        report_fail(in, &at, POV_E_SYNTAX, "the texture is moved beyond what a double holds");
    return !in->failed;
}

void patterns_settle(pov_reader *in, material *m)
{
    pattern_parsed *p = (pattern_parsed *)(void *)m->pattern;
    pov_affine map;

    if (!p || !p->moves || p->pattern.map || !compose(in, p->moves, &map))
        return;
    p->pattern.map = map_table_add(&in->model->kept_maps, in->model->env, &map);
    if (!p->pattern.map)
        report_memory(in);
}

void patterns_place(pov_reader *in, const transform *map, uint32_t moves)
{
    const transform *list = moves < patterns_count_moves(map) ? parse_last_transforms(in, map, moves) : map;
    pov_affine placed;

    if (in->failed || !list || !compose(in, list, &placed))
        return;
    if (!model_set_texture_map(in->model, &placed))
        report_memory(in);
}
