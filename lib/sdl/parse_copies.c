#include "sdl/parse_copies.h"

#include "base/vec.h"
#include "sdl/limit.h"
#include "sdl/parse_texture.h"

#include <string.h>

/* A part pays from so many leaves on, uses, and leaves of all uses: what it saves is memory, and a few rays are slower. */
enum { LEAVES_LEAST = 5, USES_LEAST = 8, WRITTEN_OUT_LEAST = 10000 };
/* A larger solid that holds others of names is no part: these may be. */
enum { LEAVES_MOST = 1 << 20 };
/* So many of the last declared solids are looked at. */
enum { LOOKED_AT = 256 };

/* ---- which solids ---- */

static const uint32_t told_apart = LEAF_NO_SHADOW | PHOTON_TARGET;   /* flags that all leaves of a part share */

static uint32_t count_list(const object_parsed *first);

/* Textures that all around it moves before they stand upon uv coordinates. */
static bool is_moved_upon_uv(const object_parsed *o)
{
    const surface_parsed *s = parse_surface_of(o);

    return s->uv && (o->kind == OBJECT_GROUP || !s->has_look);
}

/* Leaves in an object; 0: it holds something that cannot be in a part. */
static uint32_t count_leaves(const object_parsed *o)
{
    uint32_t count = 1;

    if (o->kind == OBJECT_LIGHT || o->is_light_group || o->parts || o->flags & told_apart ||
        is_moved_upon_uv(o) || parse_surface_of(o)->material.interior.media)
        return 0;
    if (o->kind == OBJECT_GROUP)
        count = count_list(o->first);
    for (const object_parsed *clip = o->clips; clip && count > 0; clip = clip->next) {
        const uint32_t more = count_leaves(clip);

        count = more > 0 ? count + more : 0;
    }
    return count;
}

static uint32_t count_list(const object_parsed *first)
{
    uint32_t count = 0;

    for (const object_parsed *o = first; o; o = o->next) {
        const uint32_t more = count_leaves(o);

        if (more == 0 || more > UINT32_MAX / 2 - count)
            return 0;
        count += more;
    }
    return count;
}

static bool holds_named(const object_parsed *first)
{
    for (const object_parsed *o = first; o; o = o->next)
        if (o->is_named || holds_named(o->first))
            return true;
    return false;
}

/* May it be a part, whatever is in it? The interior_texture of a whole is moved otherwise. */
static bool may_wait(const object_parsed *o)
{
    const surface_parsed *s = parse_surface_of(o);

    return o->is_named && !s->inside && !s->uv && !s->material.interior.media && o->kind == OBJECT_GROUP && o->first &&
           !o->is_light_group && !o->clips && !(o->flags & (LEAF_INVERSE | PHOTON_TARGET | LEAF_CUTAWAY));
}

/* ---- uses ---- */

static bool are_alike(const surface_parsed *a, const surface_parsed *b)
{
    surface_parsed one = *a, other = *b;

    one.moves = other.moves = 0;
    return a == b || memcmp(&one, &other, sizeof one) == 0;
}

/* Transformations in front of the surface, if it has any look that they do not move. */
static const transform *map_before(pov_reader *in, const object_parsed *o)
{
    const surface_parsed *s = parse_surface_of(o);
    const transform *map = o->map;
    material look;

    if (!s->has_look)
        return NULL;
    parse_surface_material(in, s, &look);
    if (!look.texture)
        return NULL;
    for (uint32_t i = 0; i < s->moves && map; i++)
        map = map->before;
    return map;
}

static bool is_same(const copied *c, const object_parsed *o, const transform *map, const surface_parsed *defaults)
{
    return c->object->first == o->first && c->object->op == o->op && c->object->flags == o->flags && c->map == map &&
           are_alike(c->surface, parse_surface_of(o)) && (c->defaults == defaults || are_alike(c->defaults, defaults));
}

static const surface_parsed *keep_defaults(pov_reader *in)
{
    copies_read *all = in->copies;
    surface_parsed *fresh;

    if (all->defaults && memcmp(all->defaults, in->placed, sizeof *all->defaults) == 0)
        return all->defaults;
    fresh = arena_alloc(&in->members, sizeof *fresh, sizeof(double));
    if (!fresh)
        report_memory(in);
    else
        all->defaults = memcpy(fresh, in->placed, sizeof *fresh);
    return fresh;
}

/* The record of the solid of a use; NULL: the reader has failed. */
static copied *find(pov_reader *in, const object_parsed *o)
{
    copies_read *all = in->copies;
    const transform *map = map_before(in, o);
    const surface_parsed *defaults = in->failed ? NULL : keep_defaults(in);
    const size_t end = all->of.count > LOOKED_AT ? all->of.count - LOOKED_AT : 0;
    const copied *same_members = NULL;
    copied fresh = { .map = map, .defaults = defaults };

    if (in->failed)
        return NULL;
    for (size_t i = all->of.count; i > end; i--) {
        copied *c = &all->of.items[i - 1];

        if (is_same(c, o, map, defaults))
            return c;
        same_members = c->object->first == o->first ? c : same_members;
    }
    fresh.object = parse_keep(in, o);
    if (in->failed)
        return NULL;
    fresh.surface = parse_surface_of(fresh.object);
    fresh.leaves = same_members ? same_members->leaves : count_list(o->first);
    if (!same_members && fresh.leaves > LEAVES_MOST && holds_named(o->first))
        fresh.leaves = 0;
    if (!VEC_PUSH(in->model->env, &all->of, fresh)) {
        report_memory(in);
        return NULL;
    }
    return &all->of.items[all->of.count - 1];
}

bool parse_copies_wait(pov_reader *in, const object_parsed *o, const transform *map, uint32_t outer)
{
    copy_use use = { .leaf = (uint32_t)in->model->leaves.count, .map = map, .at = in->object };
    copied *of;

    if (!may_wait(o) || !in->copies)
        return false;
    of = find(in, o);
    if (!of || of->leaves < LEAVES_LEAST)
        return in->failed;
    if (of->map)
        use.map = parse_last_transforms(in, map, parse_surface_of(o)->moves + outer);
    use.of = (uint32_t)(of - in->copies->of.items);
    of->uses++;
    if (!in->failed && !VEC_PUSH(in->model->env, &in->copies->uses, use))
        report_memory(in);
    return true;
}

/* ---- the end ---- */

static bool pays(const copied *c)
{
    return c->uses >= USES_LEAST && (uint64_t)c->leaves * c->uses >= WRITTEN_OUT_LEAST;
}

/* The solid, moved by these transformations too. */
static void add(pov_reader *in, const copied *c, const transform *map)
{
    const surface_parsed defaults = *c->defaults, *placed = in->placed;
    object_parsed o = parse_copy(c->object);
    surface_parsed surface = *c->surface;

    o.map = c->map;
    parse_append_transforms(in, &o.map, map, NULL);
    surface.moves = parse_count_transforms(map);
    o.shared = &surface;
    in->placed = &defaults;
    parse_add_object(in, &o);
    in->placed = placed;
}

static void make_part(pov_reader *in, copied *c)
{
    model outside = { .env = in->model->env }, *part;

    model_swap_nodes(in->model, &outside);
    add(in, c, NULL);
    part = in->failed ? NULL : model_take_part(in->model);
    model_swap_nodes(in->model, &outside);
    if (!part) {
        report_memory(in);
        return;
    }
    part->uses = c->uses;
    c->part = part;
}

/* Where written out leaves belong: so many of the new ones stand before an old one. */
typedef struct stretch { uint32_t before, count; } stretch;

static bool put_in_order(model *m, const stretch *all, size_t count, uint32_t old)
{
    uint32_t *order = env_resize(m->env, NULL, m->leaves.count + 1, sizeof *order), n = 0, from = 0, fresh = old;
    bool done = order != NULL;

    for (size_t i = 0; done && i < count; i++) {
        while (from < all[i].before)
            order[n++] = from++;
        for (uint32_t k = 0; k < all[i].count; k++)
            order[n++] = fresh++;
    }
    while (done && from < old)
        order[n++] = from++;
    done = done && model_reorder(m, order);
    env_free(m->env, order);
    return done;
}

/* In the order of the text: uses become copies, or are written out behind all leaves for the moment. */
static void settle(pov_reader *in, const copies_read *all, stretch *out)
{
    model *m = in->model;
    const uint32_t old = (uint32_t)m->leaves.count;
    uint32_t shift = 0;
    bool moved = false;
    size_t count = 0;

    for (size_t i = 0; i < all->uses.count && !in->failed; i++) {
        const copy_use *use = &all->uses.items[i];
        const copied *c = &all->of.items[use->of];
        const uint32_t first = (uint32_t)m->leaves.count;

        in->object = use->at;
        if (c->part) {
            const model_copy copy = { .of = c->part, .map = use->map, .leaf = use->leaf + shift };

            if (!VEC_PUSH(m->env, &m->copies, copy))
                report_memory(in);
            continue;
        }
        add(in, c, use->map);
        out[count++] = (stretch){ use->leaf, (uint32_t)m->leaves.count - first };
        shift += (uint32_t)m->leaves.count - first;
        moved |= use->leaf < old;
        limit_look(in, &use->at);
    }
    if (!in->failed && moved && !put_in_order(m, out, count, old))
        report_memory(in);
}

void parse_copies_finish(pov_reader *in)
{
    copies_read *all = in->copies;
    stretch *out = env_alloc(in->model->env, all->uses.count + 1, sizeof *out);
    place at;

    if (!out)
        report_memory(in);
    at = in->object;
    in->copies = NULL;           /* nothing waits any more */
    for (size_t i = 0; i < all->of.count && !in->failed; i++)
        if (pays(&all->of.items[i]))
            make_part(in, &all->of.items[i]);
    if (!in->failed)
        settle(in, all, out);
    in->copies = all;
    env_free(in->model->env, out);
    if (!in->failed && !model_name_copies(in->model))
        report_fail(in, &at, POV_E_UNSUPPORTED, "these are more objects than this version can hold");
}

void parse_copies_free(copies_read *all, const env *e)
{
    env_free(e, all->of.items);
    env_free(e, all->uses.items);
}
