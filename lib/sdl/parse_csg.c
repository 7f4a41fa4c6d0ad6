/* Objects become part of the model, each member with what it has from the objects around it: a texture and an interior
 * where it has none, flags, and transformations behind its own. */
#include "base/vec.h"
#include "sdl/materials.h"
#include "sdl/object_query.h"
#include "sdl/parse_copies.h"
#include "sdl/parse_cutaway.h"
#include "sdl/parse_media.h"
#include "sdl/parse_texture.h"
#include "sdl/textures.h"

/* A group that is being added, or an object whose clip is, and those around it. */
typedef struct around {
    const struct around *outer;
    const object_parsed *group;
    const transform *since;      /* only its transformations behind this one hold */
    bool cuts;                   /* the member that is added is what the group is without */
    bool is_void;                /* nothing is left of it but its lights */
    uint32_t lights;             /* number of the light group that this is or is in; 0: none */
} around;

static const uint32_t hiding_flags = LEAF_NO_IMAGE | LEAF_NO_REFLECTION | LEAF_NO_RADIOSITY;

/* Its own texture and interior, or each from the nearest group around it that has one. */
static void find_surface(const pov_reader *in, const object_parsed *o, const around *a, surface_parsed *found)
{
    *found = *parse_surface_of(o);
    parse_surface_default(in->placed, found);
    for (; a && !(found->has_look && found->material.interior.given); a = a->outer) {
        const surface_parsed *s = parse_surface_of(a->group);
        const interior own = found->material.interior;

        if (!found->has_look && s->has_look) {
            *found = *s;
            found->material.interior = own;
        }
        if (!own.given && s->material.interior.given)
            found->material.interior = s->material.interior;
    }
    if (parse_finish_is_old(found))
        parse_finish_settle(found);
}

/* The first of a list of transformations, without the last few. */
static const transform *without_last(const transform *list, uint32_t count)
{
    for (; list && count > 0; count--)
        list = list->before;
    return list;
}

/* Without one of its own, the interior_texture of the nearest group around that has one. What moves the object's texture and
 * not that group's is undone. */
static const texture *find_inside(pov_reader *in, const object_parsed *o, const around *a, const texture *own)
{
    const around *giver = a;
    const surface_parsed *s;
    const transform *moves;

    while (giver && !parse_surface_of(giver->group)->inside)
        giver = giver->outer;
    if (own || !giver)
        return own;
    for (s = parse_surface_of(o); a != giver && !s->has_look; a = a->outer) {
        o = a->group;
        s = parse_surface_of(o);
    }
    moves = parse_last_transforms(in, o->map, s->moves);
    for (; a != giver; a = a->outer)
        parse_append_transforms(in, &moves, a->group->map, a->since);
    s = parse_surface_of(giver->group);
    parse_append_transforms(in, &moves, without_last(giver->group->map, s->moves), NULL);
    return textures_move(in, s->inside, parse_invert_transforms(in, moves));
}

static const transform *find_map(pov_reader *in, const object_parsed *o, const around *a)
{
    const transform *map = o->map;

    for (; a; a = a->outer)
        parse_append_transforms(in, &map, a->group->map, a->since);
    return map;
}

/* Of its transformations, those that came behind its texture. */
static uint32_t find_moves(const object_parsed *o, const around *a)
{
    const surface_parsed *s = parse_surface_of(o);
    uint32_t moves;

    for (; a && !s->has_look; a = a->outer)
        s = parse_surface_of(a->group);
    for (moves = s->moves; a; a = a->outer)
        moves += parse_count_transforms(a->group->map) - parse_count_transforms(a->since);
    return s->has_look ? moves : 0;
}

/* As in POV-Ray uv_mapping of a group holds for all in it but what has an interior_texture of its own. */
static bool says_uv(const object_parsed *o, const around *a)
{
    const surface_parsed *s = parse_surface_of(o);

    for (; a && !s->uv && !(s->has_look && s->inside); a = a->outer)
        s = parse_surface_of(a->group);
    return s->uv;
}

/* A texture whose own object says so stays; others have moved before. */
static void spread_uv(pov_reader *in, const object_parsed *o, const around *a, const transform *map, uint32_t moves, surface_parsed *s)
{
    if (s->uv || in->failed || !says_uv(o, a))
        return;
    if (moves > 0)
        parse_surface_move(in, s, parse_last_transforms(in, map, moves));
    s->uv = true;
}

/* What fills the object moves with it: it was moved by the transformations of the object that has the interior, and is
 * now by those of the groups around that one. */
static const media *find_media(pov_reader *in, const object_parsed *o, const around *a, const media *found)
{
    const transform *moves = NULL;
    const surface_parsed *s = parse_surface_of(o);

    for (; a && !s->material.interior.given; a = a->outer)
        s = parse_surface_of(a->group);
    for (; found && a; a = a->outer)
        parse_append_transforms(in, &moves, a->group->map, a->since);
    return found ? parse_media_settle(in, parse_media_move(in, found, moves)) : NULL;
}

/* So is a light that has an object. */
static bool is_union(const object_parsed *o)
{
    return (o->kind == OBJECT_GROUP && o->op == NODE_UNION) || o->kind == OBJECT_LIGHT;
}

/* Which rays do not see it. What is one solid is seen as a whole: as in POV-Ray only merges, and unions in nothing else, ask
 * their members, and unions in solids for no_reflection alone. */
static uint32_t find_hidden(const object_parsed *o, const around *a)
{
    uint32_t hidden = 0, of_unions = 0;

    for (; a; o = a->group, a = a->outer) {
        of_unions = is_union(a->group) ? of_unions | o->flags : 0;
        hidden |= a->group->op == NODE_MERGE ? o->flags : is_union(o) || is_union(a->group) ? o->flags & LEAF_NO_REFLECTION : 0;
    }
    return (hidden | of_unions | o->flags) & hiding_flags;
}

/* What is one solid throws its shadow as a whole, whatever its members say. */
static uint32_t find_flags(const object_parsed *o, const around *a)
{
    uint32_t flags = (o->flags & ~hiding_flags) | find_hidden(o, a);

    for (; a; a = a->outer) {
        if (!is_union(a->group))
            flags &= ~(uint32_t)LEAF_NO_SHADOW;
        flags |= a->group->flags & (LEAF_NO_SHADOW | LEAF_HOLLOW | LEAF_DOUBLE_ILLUMINATE | PHOTON_OBJECT_FLAGS);
    }
    return flags;
}

/* Of the last leaf's transformations so many came behind its texture, and moved it too. */
static void set_texture_map(pov_reader *in, const transform *map, uint32_t moves)
{
    const transform *list = moves < parse_count_transforms(map) ? parse_last_transforms(in, map, moves) : map;
    place at = in->object;
    pov_affine whole;

    if (in->failed || !list)
        return;
    if (!transform_compose(list, &whole))
        report_fail(in, &at, POV_E_SYNTAX, "the texture is moved beyond what a double holds");
    else if (!model_set_texture_map(in->model, &whole))
        report_memory(in);
}

/* Note a leaf of an object with cutaway_textures. */
static void note_cutaway(pov_reader *in, const around *a, cutaway_member c)
{
    c.cuts = false;
    for (; a; a = a->outer) {
        c.cuts ^= a->cuts;
        if (a->group == in->cutaway->whole)
            break;
    }
    parse_cutaway_add(in, &c);
}

static bool add_leaf(pov_reader *in, const object_parsed *o, const around *a, node_ref *out)
{
    uint32_t moves = find_moves(o, a);
    leaf_node leaf = o->leaf;
    surface_parsed s;
    material m;

    find_surface(in, o, a, &s);
    leaf.map = find_map(in, o, a);
    leaf.flags = find_flags(o, a);
    s.inside = o->both_sides ? NULL : find_inside(in, o, a, s.inside);
    spread_uv(in, o, a, leaf.map, moves, &s);
    if (o->parts) {
        parse_parts_surface(in, o, leaf.map, moves, &s);
        moves = parse_count_transforms(leaf.map);
    }
    parse_surface_material(in, &s, &m);
    m.interior.media = find_media(in, o, a, m.interior.media);
    leaf.flags |= m.needs_uv ? LEAF_UV : 0;
    m.double_illuminate = (leaf.flags & LEAF_DOUBLE_ILLUMINATE) != 0;
    leaf.material = materials_index(in, &m);
    *out = (node_ref)in->model->leaves.count;
    if (!in->failed && !model_add_leaf(in->model, &leaf))
        report_memory(in);
    if (m.texture)
        set_texture_map(in, leaf.map, moves);
    if (in->cutaway && !in->failed)
        note_cutaway(in, a, (cutaway_member){ .leaf = *out, .surface = s, .map = leaf.map, .moves = moves });
    return !in->failed;
}

/* What moves a part of a light: all behind `since`, and the groups around. False: doubles don't hold it. */
static bool compose_since(pov_reader *in, const object_parsed *o, const around *a, const transform *since, pov_affine *out)
{
    const transform *map = NULL;

    parse_append_transforms(in, &map, o->map, since);
    for (; a; a = a->outer)
        parse_append_transforms(in, &map, a->group->map, a->since);
    return transform_compose(map, out);
}

static bool move_light(pov_reader *in, const object_parsed *o, const around *a, light *l, pov_vec3 *point_at)
{
    pov_affine whole, aim, spread;
    pov_vec3 low;

    if (!compose_since(in, o, a, NULL, &whole) || !compose_since(in, o, a, o->aimed, &aim) || !compose_since(in, o, a, o->spread, &spread))
        return false;
    transform_point(&aim, o->point_at, point_at, &low);
    transform_point(&whole, o->light.position, &l->position, &l->position_lo);
    for (int i = 0; i < 2; i++)
        l->area.axes[i] = transform_direction(&spread, l->area.axes[i]);
    return true;
}

/* through: the first leaf of what it is projected through; those to the last are that. */
static void add_light(pov_reader *in, const object_parsed *o, const around *a, uint32_t through)
{
    pov_vec3 point_at = o->point_at;
    light l = o->light;
    bool is_fine = true;

    l.position_lo = pov_vec3_of(0.0, 0.0, 0.0);
    if (find_map(in, o, a))
        is_fine = move_light(in, o, a, &l, &point_at);
    l.group = a && a->group->is_light_group ? a->lights : 0;   /* of a union in a group it shines on all the scene */
    l.through = through;
    l.through_count = (uint32_t)in->model->leaves.count - through;
    l.axis = pov_unit(pov_sub(pov_sub(point_at, l.position), l.position_lo));
    l.aim = pov_dot(pov_sub(pov_sub(point_at, l.position), l.position_lo), l.axis);
    if (!is_fine || !parse_is_finite(l.position) || !parse_is_finite(l.position_lo)) {
        place at = in->object;

        report_fail(in, &at, POV_E_SYNTAX, "the light is moved beyond what a double holds");
    }
    if (!in->failed && !VEC_PUSH(in->model->env, &in->model->lights, l))
        report_memory(in);
}

/* ---- declared solids that are used often ---- */

/* Transformations of the groups around; false: one of these is more than a union, or says more. */
static bool count_outer(const around *a, uint32_t *outer)
{
    for (*outer = 0; a; a = a->outer) {
        const object_parsed *o = a->group;
        const surface_parsed *s = parse_surface_of(o);

        if (o->kind != OBJECT_GROUP || o->op != NODE_UNION || o->is_light_group || o->clips || o->flags || s->has_look || s->inside || s->uv ||
            s->material.interior.given || a->since)
            return false;
        *outer += parse_count_transforms(o->map);
    }
    return true;
}

static bool waits(pov_reader *in, const object_parsed *o, const around *a)
{
    uint32_t outer;

    return o->is_named && in->copies && !in->cutaway && count_outer(a, &outer) &&
           parse_copies_wait(in, o, find_map(in, o, a), outer);
}

/* ---- light groups ---- */

/* A new number for each. */
static uint32_t find_lights(pov_reader *in, const object_parsed *o, const around *a)
{
    if (o->is_light_group)
        return ++in->light_groups;
    return a ? a->lights : 0;
}

/* The groups around whose lights reach into this one: as in POV-Ray where a name stands between the two. */
static uint32_t find_from(const object_parsed *o, const around *a)
{
    bool is_named = o->is_named;

    for (; a; a = a->outer) {
        is_named |= a->group->is_named;
        if (a->group->is_light_group && is_named)
            return a->lights;
    }
    return 0;
}

/* The leaves since the first are those of the group. */
static void add_light_group(pov_reader *in, const object_parsed *o, const around *a, uint32_t first, uint32_t number)
{
    const light_group g = { first, (uint32_t)in->model->leaves.count - first, number, find_from(o, a), o->global_lights };

    if (!in->failed && !VEC_PUSH(in->model->env, &in->model->light_groups, g))
        report_memory(in);
}

/* False: there is nothing for its group to hold, or the reader has failed. */
static bool add(pov_reader *in, const object_parsed *o, const around *a, node_ref *out);

static bool is_unpictured(const object_parsed *member, const object_parsed *of) { return (member->flags & ~of->flags & LEAF_NO_IMAGE) != 0; }

/* Is it a merge, in nothing but unions, of whose members the camera does not see some? For its rays it is one of the others, as in
 * POV-Ray. */
static bool is_parted(const object_parsed *o, const around *a)
{
    bool is_seen = false, is_hidden = false;

    if (o->op != NODE_MERGE || (o->flags & LEAF_INVERSE))
        return false;
    for (; a; a = a->outer)
        if (!is_union(a->group) || (a->group->flags & LEAF_INVERSE))
            return false;
    for (const object_parsed *member = o->first; member; member = member->next)
        *(is_unpictured(member, o) ? &is_hidden : &is_seen) = true;
    return is_hidden && is_seen;
}

/* Of a merge that is parted those that the camera sees, or the others. */
typedef enum members { ALL, SEEN, HIDDEN } members;

static bool is_one_of(members which, const object_parsed *member, const object_parsed *o)
{
    return which == ALL || (which == HIDDEN) == is_unpictured(member, o);
}

/* False: there is nothing for a group to hold, or the reader has failed. */
static bool add_members(pov_reader *in, around *here, members which, const group_node *shape, node_ref *out)
{
    const object_parsed *o = here->group;
    node_list children = { NULL, 0, 0 };
    node_ref child;

    for (const object_parsed *member = o->first; member && !in->failed; member = member->next) {
        bool added;

        if (!is_one_of(which, member, o))
            continue;
        here->cuts = o->op == NODE_DIFFERENCE && member != o->first;
        added = add(in, member, here, &child);
        if (added && !VEC_PUSH(in->model->env, &children, child))
            report_memory(in);
        if (!added && o->op == NODE_DIFFERENCE && member == o->first)
            break;   /* of nothing nothing can be cut */
    }
    if (!in->failed && children.count > 0 && !model_add_group(in->model, shape, children.items, children.count, out))
        report_memory(in);
    env_free(in->model->env, children.items);
    return !in->failed && children.count > 0;
}

/* A union of nothing may have lights that look like something. */
static bool is_void(const object_parsed *o, const around *a)
{
    return (a && a->is_void) || (o->op != NODE_UNION && o->content != CONTENT_SHAPES) ||
           (o->clips && object_content_of(o) == CONTENT_NOTHING);
}

static bool add_parts(pov_reader *in, around *here, const group_node *shape, node_ref *out)
{
    group_node both = *shape;
    node_ref parts[2];

    both.op = NODE_UNION;
    if (!add_members(in, here, SEEN, shape, &parts[0]))
        return add_members(in, here, HIDDEN, shape, out);
    *out = parts[0];
    if (add_members(in, here, HIDDEN, shape, &parts[1]) && !model_add_group(in->model, &both, parts, 2, out))
        report_memory(in);
    return !in->failed;
}

static bool add_group(pov_reader *in, const object_parsed *o, const around *a, node_ref *out)
{
    around here = { .outer = a, .group = o, .lights = find_lights(in, o, a), .is_void = is_void(o, a) };
    cutaway_list list;
    const bool cuts_away = parse_cutaway_begin(in, o, &list);
    const uint32_t leaf = (uint32_t)in->model->leaves.count;
    const surface_parsed *own = parse_surface_of(o);
    const group_node shape = { .op = o->op, .inverse = (o->flags & LEAF_INVERSE) != 0,
                               .united = own->material.interior.given || parse_finish_is_old(own), .line = o->leaf.line, .column = o->leaf.column };
    const bool added = is_parted(o, a) ? add_parts(in, &here, &shape, out) : add_members(in, &here, ALL, &shape, out);

    if (cuts_away)
        parse_cutaway_end(in, &list);
    if (o->is_light_group)
        add_light_group(in, o, a, leaf, here.lights);
    return added;
}

/* What a light is projected through, and what it looks like, are objects. */
static bool add_light_and_objects(pov_reader *in, const object_parsed *o, const around *a, node_ref *out)
{
    const group_node both = { .op = NODE_UNION, .line = o->leaf.line, .column = o->leaf.column };
    around here = { .outer = a, .group = o, .lights = a ? a->lights : 0 };
    const uint32_t leaf = (uint32_t)in->model->leaves.count;
    node_ref children[2] = { 0, 0 };
    bool is_through;

    if (a && a->is_void) {
        add_light(in, o, a, leaf);
        return false;
    }
    here.since = o->through ? o->through->since : NULL;
    is_through = o->through && add(in, o->through, &here, out);
    children[0] = is_through ? *out : 0;
    add_light(in, o, a, leaf);
    here.since = o->first ? o->first->since : NULL;
    if (in->failed || !o->first || !add(in, o->first, &here, &children[1]))
        return is_through && !in->failed;
    *out = children[1];
    if (is_through && !model_add_group(in->model, &both, children, 2, out))
        report_memory(in);
    return !in->failed;
}

static bool add_whole(pov_reader *in, const object_parsed *o, const around *a, node_ref *out)
{
    switch (o->kind) {
    case OBJECT_LEAF:
        return !is_void(o, a) && add_leaf(in, o, a, out);
    case OBJECT_GROUP:
        return !waits(in, o, a) && add_group(in, o, a, out);
    case OBJECT_LIGHT:
        return add_light_and_objects(in, o, a, out);
    }
    return false;
}

/* Does a clip hold all of what it clips? Programs clip whatever they write by the box of the picture. */
static bool is_needless(pov_reader *in, const object_parsed *o, const object_parsed *clip)
{
    object_parsed moved = parse_copy(clip);

    if (!object_is_convex(clip))
        return false;
    parse_append_transforms(in, &moved.map, o->map, clip->since);
    return object_is_within(in, o, &moved);
}

static bool add(pov_reader *in, const object_parsed *o, const around *a, node_ref *out)
{
    const group_node shape = { .op = NODE_CLIP, .line = o->leaf.line, .column = o->leaf.column };
    node_list children = { NULL, 0, 0 };
    node_ref child;

    if (!add_whole(in, o, a, out))
        return false;
    if (!o->clips)
        return true;
    if (!VEC_PUSH(in->model->env, &children, *out))
        report_memory(in);
    for (const object_parsed *clip = o->clips; clip && !in->failed; clip = clip->next) {
        const around here = { .outer = a, .group = o, .since = clip->since };

        if (!is_needless(in, o, clip) && add(in, clip, &here, &child) && !VEC_PUSH(in->model->env, &children, child))
            report_memory(in);
    }
    if (!in->failed && children.count > 1 && !model_add_group(in->model, &shape, children.items, children.count, out))
        report_memory(in);
    env_free(in->model->env, children.items);
    return !in->failed;
}

void parse_add_object(pov_reader *in, const object_parsed *o)
{
    node_ref root;

    if (add(in, o, NULL, &root) && !model_add_tree(in->model, root))
        report_memory(in);
}
