/* Parts that are stored once, their copies, and the names and numbers of what is in them. */
#include "base/vec.h"
#include "model/model.h"

#include <stdlib.h>
#include <string.h>

/* ---- making ---- */

#define SWAP(type, a, b) do { const type kept = (a); (a) = (b); (b) = kept; } while (0)

void model_swap_nodes(model *a, model *b)
{
    SWAP(leaf_list, a->leaves, b->leaves);
    SWAP(group_list, a->groups, b->groups);
    SWAP(node_list, a->children, b->children);
    SWAP(node_list, a->trees, b->trees);
    SWAP(solid_list, a->solids, b->solids);
    SWAP(copy_list, a->copies, b->copies);
    SWAP(cutaway_leaves, a->cutaways, b->cutaways);
    SWAP(leaf_numbers, a->givers, b->givers);
    SWAP(map_numbers, a->texture_maps, b->texture_maps);
}

model *model_take_part(model *m)
{
    model *part = env_alloc(m->env, 1, sizeof *part);

    if (!part)
        return NULL;
    part->env = m->env;
    part->part = (uint32_t)m->parts.count;
    if (!VEC_PUSH(m->env, &m->parts, part)) {
        env_free(m->env, part);
        return NULL;
    }
    model_swap_nodes(part, m);
    return part;
}

size_t model_all_names(const model *m)
{
    const model_copy *last = m->copies.count > 0 ? &m->copies.items[m->copies.count - 1] : NULL;

    return last ? last->name + model_all_names(last->of) : model_own_names(m);
}

/* False: there are more names than a number holds. */
static bool set_names(model *m)
{
    size_t name = model_own_names(m), objects = 0;

    for (size_t i = 0; i < m->copies.count; i++) {
        model_copy *c = &m->copies.items[i];

        c->name = (uint32_t)name;
        name += model_all_names(c->of);
        objects += model_object_count(c->of);
        c->objects = (uint32_t)objects;
        if (name >= UINT32_MAX)
            return false;
    }
    return true;
}

/* What a part does not have of its own is the whole model's. */
static void share(const model *m, model *part)
{
    model own = *part;

    *part = *m;
    memset(&part->leaves, 0, sizeof part->leaves);
    memset(&part->parts, 0, sizeof part->parts);
    memset(&part->kept, 0, sizeof part->kept);
    model_swap_nodes(part, &own);
    part->part = own.part;
    part->uses = own.uses;
}

bool model_name_copies(model *m)
{
    for (size_t i = 0; i < m->parts.count; i++) {
        share(m, m->parts.items[i]);
        if (!set_names(m->parts.items[i]))
            return false;
    }
    return set_names(m);
}

/* ---- names ---- */

const model_copy *model_copy_of(const model *m, uint32_t *name)
{
    size_t low = 0, high = m->copies.count;

    if (*name < model_own_names(m) || high == 0)
        return NULL;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;

        if (m->copies.items[middle].name <= *name)
            low = middle;
        else
            high = middle;
    }
    *name -= m->copies.items[low].name;
    return &m->copies.items[low];
}

const leaf_node *model_leaf_within(const model *m, uint32_t name)
{
    for (const model_copy *c; (c = model_copy_of(m, &name)) != NULL;)
        m = c->of;
    return &m->leaves.items[name];
}

/* Where something stands among the leaves: a copy before the leaf that follows it. */
static uint64_t place_of(const model *m, const model_copy *c, uint32_t name)
{
    return c ? (uint64_t)c->leaf << 32 | (uint64_t)(c - m->copies.items) : ((uint64_t)name << 32) | UINT32_MAX;
}

bool model_is_before(const model *m, uint32_t a, uint32_t b)
{
    if (m->copies.count == 0)
        return a < b;
    for (;;) {
        const model_copy *in_a = model_copy_of(m, &a), *in_b = model_copy_of(m, &b);

        if (!in_a || in_a != in_b)
            return place_of(m, in_a, a) < place_of(m, in_b, b);
        m = in_a->of;
    }
}

/* ---- objects ---- */

/* Of those that no copy holds. */
static size_t own_objects(const model *m)
{
    const solid_node *last = m->solids.count > 0 ? &m->solids.items[m->solids.count - 1] : NULL;

    return last ? last->object + 1 + m->leaves.count - (last->leaf + last->leaf_count) : m->leaves.count;
}

size_t model_object_count(const model *m)
{
    return own_objects(m) + (m->copies.count > 0 ? m->copies.items[m->copies.count - 1].objects : 0);
}

/* The last solid up to a leaf, or up to an object; NULL: none. */
static const solid_node *last_solid(const model *m, uint32_t leaf, uint32_t object)
{
    size_t low = 0, high = m->solids.count;

    while (low < high) {
        const size_t middle = low + (high - low) / 2;

        if (m->solids.items[middle].leaf <= leaf && m->solids.items[middle].object <= object)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0 ? &m->solids.items[low - 1] : NULL;
}

static uint32_t own_object_of(const model *m, uint32_t leaf)
{
    const solid_node *s;

    if (leaf == m->leaves.count)
        return (uint32_t)own_objects(m);
    s = last_solid(m, leaf, UINT32_MAX);
    if (!s)
        return leaf;
    return leaf < s->leaf + s->leaf_count ? s->object : s->object + 1 + leaf - (s->leaf + s->leaf_count);
}

/* The object that a copy begins with. */
static uint32_t first_object(const model *m, const model_copy *c)
{
    return own_object_of(m, c->leaf) + (c > m->copies.items ? c[-1].objects : 0);
}

/* How many copies stand before a leaf, or begin up to an object. */
static size_t copies_before(const model *m, uint32_t leaf, uint32_t object)
{
    size_t low = 0, high = m->copies.count;

    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        const model_copy *c = &m->copies.items[middle];

        if (c->leaf <= leaf && (object == UINT32_MAX || first_object(m, c) <= object))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

uint32_t model_object_of(const model *m, uint32_t leaf)
{
    const model_copy *c = model_copy_of(m, &leaf);
    size_t before;

    if (c)
        return first_object(m, c) + model_object_of(c->of, leaf);
    before = copies_before(m, leaf, UINT32_MAX);
    return own_object_of(m, leaf) + (before > 0 ? m->copies.items[before - 1].objects : 0);
}

static const solid_node *own_object(const model *m, uint32_t object, uint32_t *leaf)
{
    const solid_node *s = last_solid(m, UINT32_MAX, object);

    *leaf = s ? s->leaf + s->leaf_count + object - s->object - 1 : object;
    if (!s || s->object != object)
        return NULL;
    *leaf = s->leaf;
    return s;
}

const solid_node *model_object(const model *m, uint32_t object, uint32_t *leaf)
{
    const size_t before = copies_before(m, UINT32_MAX, object);
    const model_copy *c = before > 0 ? &m->copies.items[before - 1] : NULL;
    const solid_node *s;

    if (!c)
        return own_object(m, object, leaf);
    if (object - first_object(m, c) >= model_object_count(c->of))
        return own_object(m, object - c->objects, leaf);
    s = model_object(c->of, object - first_object(m, c), leaf);
    *leaf += c->name;
    return s;
}

/* ---- order ---- */

typedef struct in_order { uint32_t leaf, index; } in_order;

static int compare(const void *a, const void *b)
{
    const in_order *x = a, *y = b;

    return x->leaf != y->leaf ? (x->leaf < y->leaf ? -1 : 1) : (x->index > y->index) - (x->index < y->index);
}

/* The elements of an array in the order of their leaves, which are members at that offset. */
static bool sort(const env *e, void *items, size_t count, size_t bytes, uint32_t (*leaf_of)(const model *m, const void *item),
                 const model *m)
{
    in_order *order = env_alloc(e, count + 1, sizeof *order);
    unsigned char *copy = env_alloc(e, count + 1, bytes);
    bool done = order && copy;

    for (size_t i = 0; done && i < count; i++) {
        order[i].leaf = leaf_of(m, (unsigned char *)items + i * bytes);
        order[i].index = (uint32_t)i;
    }
    if (done && count > 0) {
        memcpy(copy, items, count * bytes);
        qsort(order, count, sizeof *order, compare);
    }
    for (size_t i = 0; done && i < count; i++)
        memcpy((unsigned char *)items + i * bytes, copy + order[i].index * bytes, bytes);
    env_free(e, order);
    env_free(e, copy);
    return done;
}

static uint32_t leaf_of_tree(const model *m, const void *item)
{
    return m->groups.items[*(const node_ref *)item & ~NODE_GROUP].leaf;
}

static uint32_t leaf_of_solid(const model *m, const void *item) { (void)m; return ((const solid_node *)item)->leaf; }
static uint32_t leaf_of_cutaway(const model *m, const void *item) { (void)m; return ((const cutaway *)item)->leaf; }

static void renumber(model *m, const uint32_t *now)
{
    for (size_t i = 0; i < m->groups.count; i++)
        m->groups.items[i].leaf = now[m->groups.items[i].leaf];
    for (size_t i = 0; i < m->children.count; i++)
        if (!(m->children.items[i] & NODE_GROUP))
            m->children.items[i] = now[m->children.items[i]];
    for (size_t i = 0; i < m->solids.count; i++)
        m->solids.items[i].leaf = now[m->solids.items[i].leaf];
    for (size_t i = 0; i < m->cutaways.count; i++)
        m->cutaways.items[i].leaf = now[m->cutaways.items[i].leaf];
    for (size_t i = 0; i < m->givers.count; i++)
        m->givers.items[i] = now[m->givers.items[i]];
    for (size_t i = 0; i < m->light_groups.count; i++)
        if (m->light_groups.items[i].leaf_count > 0)
            m->light_groups.items[i].leaf = now[m->light_groups.items[i].leaf];
    for (size_t i = 0; i < m->lights.count; i++)
        if (m->lights.items[i].through_count > 0)
            m->lights.items[i].through = now[m->lights.items[i].through];
}

static void count_objects(model *m)
{
    const solid_node *last = NULL;

    for (size_t i = 0; i < m->solids.count; i++) {
        solid_node *s = &m->solids.items[i];

        s->object = last ? last->object + 1 + s->leaf - (last->leaf + last->leaf_count) : s->leaf;
        last = s;
    }
}

/* Leaves and their texture maps. */
static bool move_leaves(model *m, const uint32_t *order)
{
    const size_t n = m->leaves.count, mapped = m->texture_maps.count;
    leaf_node *leaves = env_resize(m->env, NULL, n + 1, sizeof *leaves);
    uint32_t *maps = mapped > 0 ? env_alloc(m->env, n, sizeof *maps) : NULL;

    if (!leaves || (mapped > 0 && !maps)) {
        env_free(m->env, leaves);
        env_free(m->env, maps);
        return false;
    }
    for (size_t i = 0; i < n; i++) {
        leaves[i] = m->leaves.items[order[i]];
        if (maps)
            maps[i] = order[i] < mapped ? m->texture_maps.items[order[i]] : 0;
    }
    env_free(m->env, m->leaves.items);
    m->leaves.items = leaves;
    m->leaves.capacity = n + 1;
    if (maps) {
        env_free(m->env, m->texture_maps.items);
        m->texture_maps.items = maps;
        m->texture_maps.count = m->texture_maps.capacity = n;
    }
    return true;
}

bool model_reorder(model *m, const uint32_t *order)
{
    uint32_t *now = env_resize(m->env, NULL, m->leaves.count + 1, sizeof *now);
    bool done;

    for (uint32_t i = 0; now && i < m->leaves.count; i++)
        now[order[i]] = i;
    if (now)
        renumber(m, now);
    env_free(m->env, now);
    done = now && move_leaves(m, order) &&
           sort(m->env, m->trees.items, m->trees.count, sizeof *m->trees.items, leaf_of_tree, m) &&
           sort(m->env, m->solids.items, m->solids.count, sizeof *m->solids.items, leaf_of_solid, m) &&
           sort(m->env, m->cutaways.items, m->cutaways.count, sizeof *m->cutaways.items, leaf_of_cutaway, m);
    if (done)
        count_objects(m);
    return done;
}
