#include "bvh/build.h"
#include "world/copy_path.h"

#include "base/err.h"
#include "base/share.h"
#include "base/vec.h"

#include <string.h>

/* Scenes of fewer objects are compiled by the calling thread alone. */
enum { THREADS_FROM = 10000 };

/* ---- dielectrics ---- */

/* Solids that are looked for. Opaque ones are so only where they may hold the camera of the scene: no ray of another place
 * is seen inside them. */
typedef enum around { AROUND_FILLED, AROUND_DIELECTRIC, AROUND_OPAQUE } around;

static bool is_wanted(const world *w, const leaf_node *o, around kind)
{
    switch (kind) {
    case AROUND_FILLED: return plan_is_filled(o);
    case AROUND_DIELECTRIC: return plan_is_dielectric(w->model, o);
    default: return w->plan.opaque_at_start && plan_is_solid(o);
    }
}

/* For a copy: has its part any of these? */
static bool has_copy(const compile_state *f, uint32_t copy, around kind)
{
    const world *part = f->copies[copy].of;

    return kind == AROUND_FILLED ? part->filled.count > 0 : part->dielectrics.count > 0;
}

/* For a tree its first leaf of this kind, if any; for a leaf the leaf. */
static uint32_t solid_leaf(const world *w, const compile_state *f, uint32_t object, around kind)
{
    const uint32_t leaves = (uint32_t)w->model->leaves.count;
    const csg_tree *t = object < leaves ? NULL : &f->trees.items[object - leaves];
    const uint32_t first = t ? t->members[0].leaf : object, end = t ? first + t->member_count : first + 1;

    for (uint32_t i = first; i < end; i++)
        if (is_wanted(w, &w->model->leaves.items[i], kind) && (t || !f->is_member || !f->is_member[i]))
            return i;
    return POV_NO_OWNER;
}

/* An inverse solid's inside is all but its box, and that of a tree may reach beyond what shows. */
static void box_around(const compile_state *f, uint32_t object, bool finite, dielectric *m)
{
    const uint32_t leaves = (uint32_t)f->model->leaves.count;
    const bool is_endless = object >= leaves && !f->trees.items[object - leaves].boxed;

    m->boxed = finite && !is_endless && !(compile_leaf(f, object)->flags & LEAF_INVERSE);
    if (m->boxed)
        compile_box(f, object, &m->box);
}

static bool find_around(world *w, const compile_state *f, dielectric_list *out, around kind)
{
    uint32_t i, k;

    /* Both lists are in the order of the objects. */
    for (i = 0, k = 0; i < w->model->leaves.count + f->trees.count; i++) {
        uint32_t leaf = solid_leaf(w, f, i, kind);
        const bool wanted = leaf != POV_NO_OWNER;
        dielectric m = { .object = i };

        if (!wanted && kind == AROUND_DIELECTRIC)
            leaf = solid_leaf(w, f, i, AROUND_OPAQUE);
        if (leaf == POV_NO_OWNER)
            continue;
        while (k < f->finite_count && f->finite[k] < i)
            k++;
        m.solid = world_solid(w, leaf);
        box_around(f, i, k < f->finite_count && f->finite[k] == i, &m);
        if (!wanted && !w->is_part && m.boxed && w->model->camera.type != POV_CAMERA_MESH && !world_is_within(&m.box, w->model->camera.location))
            continue;
        if (!VEC_PUSH(w->env, out, m))
            return false;
    }
    return true;
}

/* Copies whose parts have some. */
static bool find_copies(world *w, const compile_state *f, dielectric_list *out, around kind)
{
    const uint32_t first = (uint32_t)(w->model->leaves.count + f->trees.count);

    for (uint32_t i = 0; i < w->model->copies.count; i++) {
        dielectric m = { .solid = POV_NO_OWNER, .object = first + i };

        if (!has_copy(f, i, kind))
            continue;
        m.boxed = f->copies[i].of->infinite_count == 0;
        if (m.boxed)
            compile_box(f, first + i, &m.box);
        if (!VEC_PUSH(w->env, out, m))
            return false;
    }
    return true;
}

/* Solids that may contain the start of a camera's ray. */
static bool find_starts(world *w, const compile_state *f)
{
    const bool air = w->plan.media || w->model->fogs.count > 0 || w->model->rainbows.count > 0;

    return (!w->plan.dielectrics_at_start || (find_around(w, f, &w->dielectrics, AROUND_DIELECTRIC) &&
                                              find_copies(w, f, &w->dielectrics, AROUND_DIELECTRIC))) &&
           (!air || (find_around(w, f, &w->filled, AROUND_FILLED) && find_copies(w, f, &w->filled, AROUND_FILLED)));
}

/* Members that differ in what fills them are solids of their own. Media are those of the whole where both have some: each
 * member's are moved with it. */
static bool are_filled_alike(const model *m, uint32_t a, uint32_t b)
{
    const interior *in = &m->materials.items[m->leaves.items[a].material].interior;
    interior other = m->materials.items[m->leaves.items[b].material].interior;

    if (in->media && other.media)
        other.media = in->media;
    return interior_equal(in, &other);
}

/* The first leaf from `first` on that is filled like this one; most are like the one before. */
static uint32_t first_alike(const world *w, uint32_t first, uint32_t leaf)
{
    uint32_t i = first;

    if (leaf > first && are_filled_alike(w->model, leaf - 1, leaf))
        return w->solids[leaf - 1];
    while (i < leaf && (w->solids[i] != i || !are_filled_alike(w->model, i, leaf)))
        i++;
    return i;
}

/* By leaf, the first leaf of its solid. */
static bool find_solids(world *w)
{
    const model *m = w->model;
    uint32_t i;

    if (m->solids.count == 0)
        return true;
    w->solids = env_resize(w->env, NULL, m->leaves.count, sizeof *w->solids);
    for (i = 0; w->solids && i < m->leaves.count; i++)
        w->solids[i] = i;
    for (i = 0; w->solids && i < m->solids.count; i++)
        for (uint32_t k = 0; k < m->solids.items[i].leaf_count; k++)
            w->solids[m->solids.items[i].leaf + k] = first_alike(w, m->solids.items[i].leaf, m->solids.items[i].leaf + k);
    return w->solids != NULL;
}

static void note_open(csg_tree *t, const csg_member *m)
{
    const double size = m->open && m->boxed ? pov_largest(pov_sub(m->box.hi, m->box.lo)) : 0.0;

    t->open_count += m->open;
    if (size > 0.0 && !(t->open_size > 0.0 && t->open_size < size))
        t->open_size = size;
}

/* Members get their positions from their batches. */
static void bind_members(world *w, csg_tree *t)
{
    for (uint32_t k = 0; k < t->member_count; k++) {
        csg_member *m = &t->members[k];
        const shape_ref ref = world_shape(w, m->leaf);

        m->instance = ref.instance;
        m->xform = ref.xform;
        m->class_number = w->groups[w->objects_info[m->leaf].group].class_number;
        m->open = !m->patch && m->shape->open && m->shape->open(m->instance);
        note_open(t, m);
    }
}

/* Tables of trees' values take a time to fill that grows with their sizes: of these have no more than so many in all. */
static uint32_t table_columns(uint32_t trees)
{
    enum { COLUMNS_MOST = 14, SETS_MOST = 1 << 15 };
    uint32_t columns = COLUMNS_MOST;

    while (columns > CSG_TABLE_COLUMNS && trees > (uint32_t)SETS_MOST >> columns)
        columns--;
    return columns;
}

static bool bind_trees(world *w)
{
    const uint32_t columns = table_columns(w->trees.count);

    for (uint32_t i = 0; i < w->trees.count; i++) {
        csg_tree *t = &w->trees.items[i];

        bind_members(w, t);
        if (!csg_find_same(t, w->env) || !csg_find_outline(t, w->env, columns))
            return false;
    }
    return true;
}

/* ---- lists and the tree ---- */

/* The lists are the first slice of the leaf batches, the tree's slices follow. */
enum { LIST_SLICE, TREE_SLICE };

typedef struct layout {
    world *world;
    leaf_layout batches;
    size_t first, second;        /* bytes of the lists of infinite objects, and of finite ones; members follow */
} layout;

static bool size_lists(layout *l, bool with_finite)
{
    const compile_state *f = l->batches.state;
    world *w = l->world;
    size_t all;

    l->second = with_finite ? leaf_layout_size(&l->batches, LIST_SLICE, f->finite, f->finite_count, 0) : 0;
    l->first = leaf_layout_size(&l->batches, LIST_SLICE, f->infinite, f->infinite_count, 0);
    all = l->first + l->second + leaf_layout_size(&l->batches, LIST_SLICE, f->members, f->member_count, 0);
    if (all > 0)
        w->list_memory = env_reserve_aligned(w->env, all, 64);
    return w->list_memory || all == 0;
}

static void fill_lists(layout *l, bool with_finite)
{
    const compile_state *f = l->batches.state;
    world *w = l->world;
    unsigned char *second = l->first > 0 ? w->list_memory + l->first : w->list_memory;

    l->batches.base = w->list_memory;
    l->batches.mark = LEAF_IN_LISTS;
    if (f->infinite_count > 0) {
        leaf_layout_fill(&l->batches, LIST_SLICE, NULL, f->infinite, f->infinite_count, w->list_memory);
        w->infinite = (const leaf_batch *)(const void *)w->list_memory;
    }
    if (f->member_count > 0)
        leaf_layout_fill(&l->batches, LIST_SLICE, NULL, f->members, f->member_count, second + l->second);
    if (with_finite && f->finite_count > 0) {
        leaf_layout_fill(&l->batches, LIST_SLICE, NULL, f->finite, f->finite_count, second);
        w->list = (const leaf_batch *)(const void *)second;
    }
}

static size_t leaf_size(void *user, uint32_t slice, uint32_t *ids, uint32_t count, uint32_t rest)
{
    return leaf_layout_size(&((layout *)user)->batches, TREE_SLICE + slice, ids, count, rest);
}

/* Lists are filled first: the transformations of their objects may be freed now. */
static bool leaf_allocate(void *user, const void *leaves)
{
    layout *l = user;

    if (!leaf_layout_allocate(&l->batches))
        return false;
    fill_lists(l, false);
    l->batches.base = leaves;
    l->batches.mark = 0;
    return leaf_layout_take_maps(&l->batches, TREE_SLICE);
}

static void leaf_fill(void *user, uint32_t slice, const bvh_frame *frame, const uint32_t *ids, uint32_t count, void *at)
{
    leaf_layout_fill(&((layout *)user)->batches, TREE_SLICE + slice, frame, ids, count, at);
}

static void leaves_filled(void *user, uint32_t slice)
{
    leaf_layout_filled(&((layout *)user)->batches, TREE_SLICE + slice);
}

static void box_of(void *user, uint32_t id, pov_box *out)
{
    compile_box(user, id, out);
}

static void drop_boxes(void *user)
{
    compile_drop_boxes(user);
}

/* Do no filters tell of an object that rays miss it? */
static bool is_unfiltered(const compile_state *f, uint32_t id)
{
    const shape_group *g = &f->groups[f->group[id]];

    return !g->instanced && !g->shares_leaf && !leaf_batch_may_filter(g->shape);
}

static bool make_tree(layout *l)
{
    compile_state *f = l->batches.state;
    world *w = l->world;
    bvh_input in = {
        .env = w->env,
        .box = box_of,
        .drop = drop_boxes,
        .box_user = f,
        .bounds = f->bounds,
        .ids = f->finite,
        .count = f->finite_count,
        .group = f->group,
        .shares_leaf = f->shares_leaf,
        .bounds_leaf = is_unfiltered(f, f->finite[0]),
        .threads = f->threads,
        .leaves = { leaf_size, leaf_allocate, leaf_fill, leaves_filled, l },
    };

    w->has_tree = bvh_build(&w->tree, &in);
    return w->has_tree;
}

static bool make_list(layout *l)
{
    if (!leaf_layout_allocate(&l->batches))
        return false;
    fill_lists(l, true);
    return true;
}

static bool lay_out(world *w, compile_state *f, bool tree)
{
    layout l;
    bool done;

    l.world = w;
    done = leaf_layout_init(&l.batches, f, TREE_SLICE + (tree ? BVH_SLICES : 0)) && size_lists(&l, !tree) &&
           (tree ? make_tree(&l) : make_list(&l));
    leaf_layout_free(&l.batches);
    return done;
}

/* ---- all of it ---- */

/* Does the attenuation of light depend on the position of a crossing? */
static bool is_located(const world *w, const compile_state *f)
{
    uint32_t i;

    if (w->plan.coloured_shadows && w->plan.located)
        return true;
    for (i = 0; w->plan.coloured_shadows && i < w->model->leaves.count; i++)
        if (f->objects_info[i].filters && w->model->materials.items[f->objects_info[i].material].texture)
            return true;
    return false;
}

static pov_status compile(world *w, compile_state *f, const world_options *options, pov_error *err)
{
    bool tree = options->accel != POV_ACCEL_NONE && f->finite_count > 0;

    w->infinite_count = f->infinite_count;
    w->has_bounds = f->finite_count > 0;
    w->extent = w->has_bounds ? pov_max(pov_largest(w->bounds.lo), pov_largest(w->bounds.hi)) : 0.0;
    w->scratch_bytes = f->scratch;
    w->bounds = f->bounds;
    w->transparent = f->transparent;
    w->located = is_located(w, f);
    for (size_t i = 0; i < w->part_count; i++)
        w->located |= w->parts[i]->located;
    if (w->plan.radiosity)
        compile_find_lamps(f, &w->lamps);
    if (!find_solids(w) || !find_starts(w, f) ||
        (w->plan.transmission && !compile_find_isolated(f, &w->isolation)) || !lay_out(w, f, tree))
        return err_memory(err);
    return POV_OK;
}

/* Move the data that rays need to the world; the rest is freed. */
static void take_over(world *w, compile_state *f)
{
    w->groups = f->groups;
    w->group_count = f->group_count;
    w->resident = f->resident;
    w->resident_count = f->threads;
    w->objects_info = f->objects_info;
    w->absorbed = f->absorbed;
    w->composed = f->composed;
    w->packed = f->packed;
    w->finite_count = f->finite_count;
    w->trees = f->trees;
    w->roots = f->roots;
    w->copies = f->copies;
    f->groups = NULL;
    f->resident = NULL;
    f->objects_info = NULL;
    f->trees.items = NULL;
    f->trees.count = 0;
    f->roots = NULL;
    f->copies = NULL;
}

static pov_status create(world **out, const model *m, const world *whole, const world_options *options, pov_error *err);

/* Parts do not refer to each other. */
static pov_status make_parts(world *w, const world_options *options, pov_error *err)
{
    const part_models *all = &w->model->parts;
    world_options of_part = *options;
    pov_status status = POV_OK;

    if (all->count == 0)
        return POV_OK;
    of_part.last = NULL;
    w->parts = env_alloc(w->env, all->count, sizeof *w->parts);
    if (!w->parts)
        return err_memory(err);
    for (size_t i = 0; i < all->count && status == POV_OK; i++) {
        status = create(&w->parts[i], all->items[i], w, &of_part, err);
        w->part_count += status == POV_OK;
    }
    return status;
}

/* whole: the world that the part is of, whose plan holds for it too; or NULL. */
static pov_status build(world *w, const world *whole, const world_options *options, pov_error *err)
{
    bool use_blocks = options->accel != POV_ACCEL_NONE && !options->always_exact;
    int threads = w->model->leaves.count < THREADS_FROM ? 1 : share_threads(options->threads);
    pov_status status = whole ? POV_OK : plan_make(&w->plan, w->model, err);
    compile_state f;

    if (whole)
        w->plan = whole->plan;
    if (status == POV_OK)
        status = make_parts(w, options, err);
    if (status < 0)
        return status;
    status = compile_objects(&f, w->model, &w->plan, w->parts, use_blocks, threads, err);
    f.last = options->last;
    if (status == POV_OK && f.composed == 0)
        compile_drop_maps(&f);
    if (status == POV_OK)
        status = compile(w, &f, options, err);
    take_over(w, &f);
    if (status == POV_OK && !bind_trees(w))
        status = err_memory(err);
    compile_drop_maps(&f);
    compile_free(&f);
    return status;
}

static pov_status create(world **out, const model *m, const world *whole, const world_options *options, pov_error *err)
{
    world *w;
    pov_status status;

    *out = NULL;
    w = env_alloc(m->env, 1, sizeof *w);
    if (!w)
        return err_memory(err);
    w->env = m->env;
    w->model = m;
    w->is_part = whole != NULL;
    w->own_names = (uint32_t)model_own_names(m);
    w->always_exact = options->always_exact;
    w->kernels = bvh_kernels_best();
    status = build(w, whole, options, err);
    if (status < 0)
        world_destroy(w);
    else
        *out = w;
    return status;
}

pov_status world_create(world **out, const model *m, const world_options *options, pov_error *err)
{
    *out = NULL;
    if (model_all_names(m) > POV_NO_OWNER - 1u)
        return err_set(err, POV_E_UNSUPPORTED, "%zu objects are more than this version can hold", model_object_count(m));
    return create(out, m, NULL, options, err);
}

void world_destroy(world *w)
{
    if (!w)
        return;
    for (size_t i = 0; i < w->part_count; i++)
        world_destroy(w->parts[i]);
    env_free(w->env, w->parts);
    env_free(w->env, w->copies);
    compile_free_groups(w->env, w->groups, w->group_count);
    compile_free_arenas(w->env, w->resident, w->resident_count);
    bvh_free(&w->tree, w->env);
    env_free_aligned(w->env, w->list_memory);
    env_free(w->env, w->objects_info);
    env_free(w->env, w->dielectrics.items);
    env_free(w->env, w->filled.items);
    env_free(w->env, w->isolation.number);
    env_free(w->env, w->isolation.boxes);
    csg_free(&w->trees, w->env);
    env_free(w->env, w->roots);
    env_free(w->env, w->solids);
    env_free(w->env, w);
}

const world_lamps *world_get_lamps(const world *w) { return &w->lamps; }

const plan *world_plan(const world *w)
{
    return &w->plan;
}

world_facts world_get_facts(const world *w)
{
    const bvh *t = &w->tree;
    const world_facts facts = { w->absorbed, w->composed, w->packed, w->infinite_count, w->finite_count, t->node_count,
                                t->leaf_count, t->frame_count, t->node_count * sizeof(bvh_node) + t->leaf_bytes, w->part_count,
                                w->model->copies.count, t->depth, w->has_tree ? w->kernels->name : NULL };
    return facts;
}

uint32_t world_solid(const world *w, uint32_t leaf)
{
    const model_copy *c;

    if (leaf < w->own_names)
        return w->solids ? w->solids[leaf] : leaf;
    c = model_copy_of(w->model, &leaf);
    return c->name + world_solid(w->parts[c->of->part], leaf);
}

const uint32_t *world_own_solids(const world *w)
{
    return w->solids;
}

const csg_list *world_trees(const world *w)
{
    return &w->trees;
}

void world_measure_trees(const world *w, csg_size *most)
{
    csg_measure(&w->trees, most);
    for (size_t i = 0; i < w->part_count; i++)
        csg_measure(&w->parts[i]->trees, most);
}

uint32_t world_own_names(const world *w)
{
    return w->own_names;
}

const object_info *world_object_info(const world *w)
{
    return w->objects_info;
}

bool world_bounds(const world *w, pov_box *out)
{
    if (w->has_bounds)
        *out = w->bounds;
    return w->has_bounds;
}

const char *world_class(const world *w, size_t number)
{
    size_t i;

    for (i = 0; i < w->group_count; i++)
        if (w->groups[i].class_number == number)
            return w->groups[i].shape->keyword;
    return NULL;
}

bool world_is_exact(const world *w)
{
    return w->always_exact;
}
