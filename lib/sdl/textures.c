#include "sdl/textures.h"

#include "sdl/noise.h"
#include "texture/pattern.h"

#include <string.h>

/* ---- the scene's own ---- */

/* Lists of the same transformations become one. */
static const transform *intern_moves(pov_reader *in, const transform *list)
{
    unsigned char buffer[sizeof(transform) + 12 * sizeof(double)];
    const size_t numbers = list && list->kind == TRANSFORM_MATRIX ? 12 : 3;
    transform *one = (transform *)(void *)buffer;

    if (!list)
        return NULL;
    memset(buffer, 0, sizeof buffer);
    one->before = intern_moves(in, list->before);
    one->kind = list->kind;
    memcpy(one->v, list->v, numbers * sizeof *one->v);
    return intern(in, buffer, sizeof *one + numbers * sizeof *one->v, sizeof *one + numbers * sizeof *one->v);
}

/* The numbers of maps are set later, and are no part of what is compared. */
const pattern *textures_pattern(pov_reader *in, const pattern_parsed *p)
{
    const size_t compared = offsetof(pattern_parsed, pattern) + offsetof(pattern, map);
    const pattern_parsed *kept;
    pattern_parsed own = *p;

    own.moves = intern_moves(in, p->moves);
    own.turns = intern_moves(in, p->turns);
    own.pattern.self = intern(in, p->pattern.self, p->pattern.class->self_size, p->pattern.class->self_size);
    own.pattern.map = own.pattern.turn = 0;
    kept = intern(in, &own, sizeof own, compared);
    return kept ? &kept->pattern : NULL;
}

static const void *intern_many(pov_reader *in, const void *items, uint32_t count, size_t size)
{
    return items ? intern(in, items, count * size, count * size) : NULL;
}

const pigment_node *textures_pigment(pov_reader *in, const pigment_node *p)
{
    pigment_node own = *p;

    own.values = intern_many(in, p->values, p->count, sizeof *p->values);
    own.colours = intern_many(in, p->colours, p->count, sizeof *p->colours);
    own.pigments = intern_many(in, p->pigments, p->count, sizeof *p->pigments);
    return intern(in, &own, sizeof own, sizeof own);
}

const normal_node *textures_normal(pov_reader *in, const normal_node *n)
{
    normal_node own = *n;

    own.values = intern_many(in, n->values, n->count, sizeof *n->values);
    own.slopes = intern_many(in, n->slopes, n->count, sizeof *n->slopes);
    own.normals = intern_many(in, n->normals, n->count, sizeof *n->normals);
    return intern(in, &own, sizeof own, sizeof own);
}

const texture *textures_texture(pov_reader *in, const texture *t)
{
    texture own = *t;

    own.values = intern_many(in, t->values, t->count, sizeof *t->values);
    own.textures = intern_many(in, t->textures, t->count, sizeof *t->textures);
    return intern(in, &own, sizeof own, sizeof own);
}

const pigment_node *textures_constant(pov_reader *in, const pigment *p)
{
    pigment_node node;

    memset(&node, 0, sizeof node);
    node.most = *p;
    return textures_pigment(in, &node);
}

/* ---- changed ones ---- */

/* What is done to each pattern: transformations behind it, or uv coordinates for its points. */
typedef struct change { const transform *moves; bool uv, uv_turns; } change;

static const pattern *change_pattern(pov_reader *in, const pattern *p, const change *by)
{
    pattern_parsed own;

    if (!p)
        return NULL;
    own = *textures_parsed(p);
    if (by->moves && (!own.pattern.uv || own.pattern.uv_turns))
        parse_append_transforms(in, own.pattern.uv ? &own.turns : &own.moves, by->moves, NULL);
    if (by->uv) {
        own.pattern.uv = true;
        own.pattern.uv_turns = by->uv_turns;
    }
    return textures_pattern(in, &own);
}

static const pigment_node *change_pigment(pov_reader *in, const pigment_node *p, const change *by)
{
    pigment_node own;

    if (!p || !p->pattern || in->failed)
        return p;
    own = *p;
    own.pattern = change_pattern(in, p->pattern, by);
    return textures_pigment(in, &own);
}

static const normal_node *change_normal(pov_reader *in, const normal_node *n, const change *by)
{
    normal_node own;

    if (!n || !n->pattern || in->failed)
        return n;
    own = *n;
    own.pattern = change_pattern(in, n->pattern, by);
    return textures_normal(in, &own);
}

static const texture *change_texture(pov_reader *in, const texture *t, const change *by);

/* by NULL: as they are in drafts. */
static const texture *change_members(pov_reader *in, const texture *t, const change *by)
{
    const texture **members = env_alloc(in->model->env, t->count, sizeof *members), *changed = NULL;
    texture own = *t;

    if (!members) {
        report_memory(in);
        return t;
    }
    for (uint32_t i = 0; i < t->count; i++)
        members[i] = by ? change_texture(in, t->textures[i], by) : textures_draft(in, t->textures[i]);
    own.textures = members;
    if (!in->failed)
        changed = textures_texture(in, &own);
    env_free(in->model->env, members);
    return changed;
}

/* Members of maps and lists stand in the space of the pattern, and move with it. */
static const texture *change_texture(pov_reader *in, const texture *t, const change *by)
{
    texture own;

    if (!t || in->failed)
        return t;
    if (t->blend == BLEND_LAYERS || t->blend == BLEND_PARTS)
        return change_members(in, t, by);
    own = *t;
    own.pattern = change_pattern(in, t->pattern, by);
    own.pigment = change_pigment(in, t->pigment, by);
    own.normal = change_normal(in, t->normal, by);
    return textures_texture(in, &own);
}

const pigment_node *textures_move_pigment(pov_reader *in, const pigment_node *p, const transform *moves)
{
    const change by = { moves, false, false };

    return moves ? change_pigment(in, p, &by) : p;
}

const normal_node *textures_move_normal(pov_reader *in, const normal_node *n, const transform *moves)
{
    const change by = { moves, false, false };

    return moves ? change_normal(in, n, &by) : n;
}

const texture *textures_move(pov_reader *in, const texture *t, const transform *moves)
{
    const change by = { moves, false, false };

    return moves ? change_texture(in, t, &by) : t;
}

static const change upon_uv = { NULL, true, false }, upon_turned_uv = { NULL, true, true };

const pigment_node *textures_uv_pigment(pov_reader *in, const pigment_node *p) { return change_pigment(in, p, &upon_uv); }
const normal_node *textures_uv_normal(pov_reader *in, const normal_node *n) { return change_normal(in, n, &upon_turned_uv); }
const texture *textures_uv(pov_reader *in, const texture *t, bool turns)
{
    return change_texture(in, t, turns ? &upon_turned_uv : &upon_uv);
}

/* ---- drafts ---- */

bool textures_are_drafts(const pov_reader *in) { return in->options && in->options->quick_colours; }

static const pigment_node *make_draft(pov_reader *in, const pigment_node *p, const pigment_node **members)
{
    pigment_node own = *p;

    for (uint32_t i = 0; i < p->count; i++) {
        members[i] = textures_draft_pigment(in, p->pigments[i]);
        if (in->failed)
            return p;
        own.most = i > 0 ? pigment_most(own.most, members[i]->most) : members[i]->most;
    }
    own.pigments = members;
    return textures_pigment(in, &own);
}

const pigment_node *textures_draft_pigment(pov_reader *in, const pigment_node *p)
{
    const pigment_node **members, *out = p;

    if (p && p->draft)
        return p->draft;
    if (!p || !p->pigments || in->failed)
        return p;
    members = env_alloc(in->model->env, p->count, sizeof *members);
    if (members)
        out = make_draft(in, p, members);
    else
        report_memory(in);
    env_free(in->model->env, members);
    return out;
}

const texture *textures_draft(pov_reader *in, const texture *t)
{
    texture own;

    if (!t || in->failed)
        return t;
    own = *t;
    if (t->blend == BLEND_NONE) {
        own.pigment = textures_draft_pigment(in, t->pigment);
        return textures_texture(in, &own);
    }
    return change_members(in, t, NULL);
}

/* ---- upper layers before version 3.5 ---- */

static pigment colourless(pigment p)
{
    return (pigment){ p.color, 0.0f, p.filter + p.transmit };
}

static const pigment_node *make_colourless(pov_reader *in, const pigment_node *p, pigment *colours, const pigment_node **members)
{
    pigment_node own = *p;

    own.most = colourless(p->most);
    for (uint32_t i = 0; i < p->count; i++) {
        pigment one;

        if (p->colours)
            one = colours[i] = colourless(p->colours[i]);
        else if ((members[i] = textures_colourless(in, p->pigments[i])))
            one = members[i]->most;
        else
            return p;
        own.most = i > 0 ? pigment_most(own.most, one) : one;
    }
    own.colours = p->colours ? colours : NULL;
    own.pigments = p->pigments ? members : NULL;
    return textures_pigment(in, &own);
}

const pigment_node *textures_colourless(pov_reader *in, const pigment_node *p)
{
    const bool has_own_colours = p && p->pattern && p->count == 0;
    pigment *colours;
    const pigment_node **members, *out = p;

    if (!p || has_own_colours || in->failed)
        return p;
    colours = env_alloc(in->model->env, p->count + 1, sizeof *colours);
    members = env_alloc(in->model->env, p->count + 1, sizeof *members);
    if (colours && members)
        out = make_colourless(in, p, colours, members);
    else
        report_memory(in);
    env_free(in->model->env, colours);
    env_free(in->model->env, members);
    return out;
}

/* ---- use ---- */

/* The number of a list's map. 0: there is none, or the reader has failed. */
static uint32_t settle_moves(pov_reader *in, const transform *moves)
{
    const place at = in->object;
    uint32_t number;
    pov_affine map;

    if (!moves || in->failed)
        return 0;
    if (!transform_compose(moves, &map)) {
        report_fail(in, &at, POV_E_SYNTAX, "the texture is moved beyond what a double holds");
        return 0;
    }
    number = map_table_add(&in->model->kept_maps, in->model->env, &map);
    if (!number)
        report_memory(in);
    return number;
}

static void settle_maps(pov_reader *in, pattern_parsed *p)
{
    const transform *all = p->moves;

    if (!p->pattern.map)
        p->pattern.map = settle_moves(in, p->moves);
    if (!p->turns || p->pattern.turn)
        return;
    parse_append_transforms(in, &all, p->turns, NULL);
    p->pattern.turn = settle_moves(in, all);
}

void textures_settle_pattern(pov_reader *in, const pattern *p)
{
    const pigment_node *inner;

    if (!p || in->failed)
        return;
    inner = p->class->inner ? p->class->inner(p->self) : NULL;
    if (inner)
        textures_settle_pigment(in, inner);
    if (pattern_needs_noise(p))
        noise_of(in);
    settle_maps(in, (pattern_parsed *)(void *)textures_parsed(p));
}

void textures_settle_pigment(pov_reader *in, const pigment_node *p)
{
    textures_settle_pattern(in, p->pattern);
    for (uint32_t i = 0; p->pigments && i < p->count && !in->failed; i++)
        textures_settle_pigment(in, p->pigments[i]);
}

void textures_settle_normal(pov_reader *in, const normal_node *n)
{
    if (!n)
        return;
    textures_settle_pattern(in, n->pattern);
    for (uint32_t i = 0; n->normals && i < n->count && !in->failed; i++)
        textures_settle_normal(in, n->normals[i]);
}

void textures_settle(pov_reader *in, const texture *t)
{
    textures_settle_pattern(in, t->pattern);
    if (t->pigment)
        textures_settle_pigment(in, t->pigment);
    if (t->normal)
        textures_settle_normal(in, t->normal);
    for (uint32_t i = 0; t->textures && i < t->count && !in->failed; i++)
        textures_settle(in, t->textures[i]);
}
