#include "world/compile.h"

#include "base/err.h"
#include "base/vec.h"
#include "bvh/build.h"
#include "world/compile_maps.h"
#include "world/world.h"

#include <string.h>

/* A transformation is tried on a copy of at most SCRATCH bytes on the stack; a larger class's copy is made in its final
 * place. */
enum { SCRATCH = POV_PREPARED_MAX, MOST_CLASSES = 0x3fff / 3, SLICE_LEAST = 2048,
       SLICES_MOST = 256 };
enum { MADE = 16 };              /* number of classes whose last instances are cached */
/* Beyond this, squares of lengths approach the end of the range of double: such an object is tested separately. */
static const double largest_coordinate = 1e150;

/* ---- parts of the scene, for one thread each ---- */

typedef struct slice {
    pov_status status;
    uint32_t failed;             /* the first object whose map has no inverse */
    uint32_t finite, infinite;
    pov_box bounds, transparent;
    size_t absorbed, composed, packed, scratch;
} slice;

typedef struct class_list { const shape_class **items; size_t count, capacity; } class_list;

typedef struct survey {
    compile_state *f;
    class_list classes;
    slice *slices;
    uint32_t slice_count;
    bool use_blocks;
} survey;

/* The last instance of a class that was made from a parsed form. */
typedef struct made {
    const shape_class *shape;
    const void *text;
    void *instance;
    bool pinned;                   /* a pointer to it is kept */
} made;

/* State of the work on one slice. */
typedef struct maker {
    const survey *survey;
    compile_state *f;
    slice *slice;
    arena *staged, *resident;
    size_t class_index;
    const shape_class *scratch_shape;
    void *scratch;               /* a block of that class, in memory for the largest block so far */
    size_t scratch_bytes;
    made made[MADE];             /* by class */
    const void *boxed;           /* the last instanced shape: its box in object space, if it has one */
    bool has_box;
    pov_box own;
    compile_maps maps;
} maker;

typedef struct scratch_buffer { unsigned char bytes[SCRATCH + COMPILE_ALIGN]; } scratch_buffer;

static void *aligned(scratch_buffer *r)
{
    return r->bytes + (-(uintptr_t)r->bytes & (COMPILE_ALIGN - 1));
}

void compile_make(const leaf_node *o, void *instance)
{
    if (o->shape->prepare) {
        memset(instance, 0, o->shape->instance_size);
        o->shape->prepare(instance, o->instance);
    } else {
        memcpy(instance, o->instance, o->shape->instance_size);
    }
}

static bool is_finite_box(const pov_box *b)
{
    return b->lo.x <= b->hi.x && b->lo.y <= b->hi.y && b->lo.z <= b->hi.z &&
           pov_largest(b->lo) <= largest_coordinate && pov_largest(b->hi) <= largest_coordinate;
}

/* ---- one object ---- */

static size_t find_class(maker *k, const shape_class *shape)
{
    const class_list *all = &k->survey->classes;

    if (all->items[k->class_index] != shape)
        for (k->class_index = 0; all->items[k->class_index] != shape; k->class_index++)
            continue;
    return k->class_index;
}

/* An object's instance before absorption: the model's own if there is one, else one for all consecutive objects of the
 * class with the same parsed form. `pin`: a pointer to it will be kept. NULL: no memory. */
static const void *make(maker *k, const leaf_node *o, bool pin)
{
    made *m = &k->made[find_class(k, o->shape) % MADE];

    if (!o->shape->prepare)
        return o->instance;
    if (m->shape != o->shape || m->text != o->instance) {
        if (m->shape != o->shape || m->pinned)
            m->instance = arena_alloc(k->resident, o->shape->instance_size, COMPILE_ALIGN);
        if (!m->instance)
            return NULL;
        compile_make(o, m->instance);
        m->shape = o->shape;
        m->text = o->instance;
        m->pinned = false;
    }
    m->pinned = m->pinned || pin;
    return m->instance;
}

/* Let a copy absorb the transformation: *out, or NULL if it cannot. */
static pov_status absorb(maker *k, const leaf_node *o, const pov_affine *map, const void **out)
{
    size_t bytes = o->shape->instance_size;
    arena *home = compile_is_resident(k->f, o->shape) ? k->resident : k->staged;
    const void *written = make(k, o, false);
    scratch_buffer here;
    void *trial = bytes <= SCRATCH ? aligned(&here) : arena_alloc(home, bytes, COMPILE_ALIGN), *copy = trial;

    *out = NULL;
    if (!written || !trial)
        return POV_E_MEMORY;
    memcpy(trial, written, bytes);
    if (!o->shape->absorb(trial, map))
        return POV_OK;
    if (bytes <= SCRATCH) {
        copy = arena_alloc(home, bytes, COMPILE_ALIGN);
        if (!copy)
            return POV_E_MEMORY;
        memcpy(copy, trial, bytes);
    }
    *out = copy;
    return POV_OK;
}

/* The box of an instanced shape in object space. False: none, and *out holds zeros. */
static bool own_box(const shape_class *shape, const void *instance, pov_box *out)
{
    static const pov_box none = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };

    if (shape->bounds(instance, out) && is_finite_box(out))
        return true;
    *out = none;
    return false;
}

static const shape_class *shape_of(const compile_state *f, uint32_t id) { return f->groups[f->group[id]].shape; }

void compile_instances(const compile_state *f, const uint32_t *ids, const pov_affine *maps, int n, instance_xform *out)
{
    const void *last = NULL;
    pov_box own, around;
    bool finite = false;
    int i;

    for (i = 0; i < n; i++) {
        const shape_class *shape = shape_of(f, ids[i]);

        if (f->moved[ids[i]] != last)   /* else they were written alike */
            finite = own_box(shape, f->moved[ids[i]], &own);
        last = f->moved[ids[i]];
        if (finite)
            instance_box(&maps[i], &own, &around);
        instance_init(&out[i], &maps[i], &own, finite && is_finite_box(&around) ? &around : NULL, shape->flags);
    }
}

/* The box of an instanced shape in the world, a little wider if its map is known approximately. False: none. */
static bool instance_world_box(maker *k, const leaf_node *o, const void *instance, bool approximate, pov_box *out)
{
    const pov_affine *map;

    if (instance != k->boxed)
        k->has_box = own_box(o->shape, instance, &k->own);
    k->boxed = instance;
    if (!k->has_box)
        return false;
    if (approximate && compile_maps_box(&k->maps, o, &k->own, out))
        return true;
    map = compile_maps_compose(&k->maps, o);   /* its numbers are moderate, or it was composed before */
    instance_box(map, &k->own, out);
    if (o->shape->flags & POV_SHAPE_SPHERE)
        instance_shrink_box(map, &k->own, out);
    return is_finite_box(out);
}

/* Absorb the transformation into the shape, or keep the shape unchanged. */
static pov_status transform_shape(maker *k, const leaf_node *o, uint32_t index, bool *finite, bool *instanced)
{
    const void **instance = &k->f->moved[index];
    pov_box *box = &k->f->boxes[index];
    const bool approximate = compile_maps_is_approx(&k->maps, o);
    const pov_affine *map = approximate ? NULL : compile_maps_compose(&k->maps, o);
    pov_status status = POV_OK;

    *instance = NULL;
    if (!approximate && !map)
        return POV_E_SYNTAX;
    if (!approximate && o->shape->absorb && !(o->flags & LEAF_UV))
        status = absorb(k, o, map, instance);
    if (status < 0)
        return status;
    *instanced = *instance == NULL;
    if (!*instanced) {
        k->slice->absorbed++;
        *finite = o->shape->bounds(*instance, box) && is_finite_box(box);
        return POV_OK;
    }
    *instance = make(k, o, true);
    if (!*instance)
        return POV_E_MEMORY;
    k->slice->composed++;
    k->f->maps[index] = (uint32_t)transform_packed_bytes(o->map);
    *finite = instance_world_box(k, o, *instance, approximate, box);
    return POV_OK;
}

/* Can this shape be packed in a block? Tried alone, in scratch memory, with a frame around its box, if it has one. */
static pov_status try_block(maker *k, const shape_class *shape, const void *instance, const pov_box *box, bool *takes)
{
    bvh_frame around;
    pov_frame frame;

    if (shape->block_size > k->scratch_bytes) {
        k->scratch = arena_alloc(k->staged, shape->block_size, 64);
        if (!k->scratch)
            return POV_E_MEMORY;
        k->scratch_bytes = shape->block_size;
    }
    if (shape != k->scratch_shape)
        memset(k->scratch, 0, shape->block_size);
    k->scratch_shape = shape;
    if (box) {
        around = bvh_frame_around(box);
        frame.centre = around.centre;
        frame.scale = around.scale;
    }
    *takes = shape->block_pack(k->scratch, box ? &frame : NULL, &instance, 1);
    return POV_OK;
}

/* Boxes hold no NaN. */
static double lesser(double a, double b) { return a < b ? a : b; }
static double greater(double a, double b) { return a > b ? a : b; }

static void join(pov_box *all, const pov_box *b)
{
    all->lo = pov_vec3_of(lesser(all->lo.x, b->lo.x), lesser(all->lo.y, b->lo.y), lesser(all->lo.z, b->lo.z));
    all->hi = pov_vec3_of(greater(all->hi.x, b->hi.x), greater(all->hi.y, b->hi.y), greater(all->hi.z, b->hi.z));
}

static const pov_box everything = { { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL }, { HUGE_VAL, HUGE_VAL, HUGE_VAL } };
static const pov_box nothing = { { HUGE_VAL, HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };

/* Fill an object's record, except for its position. */
static void note(maker *k, const leaf_node *o, uint32_t index, const pov_box *box)
{
    object_info *info = &k->f->objects_info[index];
    const material *of = &k->f->model->materials.items[o->material];
    const bool transparent = material_is_transparent(of);
    const bool casts = !(o->flags & LEAF_NO_SHADOW), member = k->f->is_member && k->f->is_member[index];
    const bool plain = !member && !(transparent && (of->texture || k->f->located));

    info->slot = (casts ? COMPILE_CASTS : 0) | (transparent ? 0 : COMPILE_OPAQUE) | (plain ? COMPILE_PLAIN : 0);
    info->material = o->material;
    info->inverse = (o->flags & LEAF_INVERSE) != 0 && !shape_is_patch(o->shape);
    info->member = member;
    info->smooth = o->shape->shading_normals != NULL;
    info->no_image = (o->flags & LEAF_NO_IMAGE) != 0;
    info->no_reflection = (o->flags & LEAF_NO_REFLECTION) != 0;
    info->no_radiosity = (o->flags & LEAF_NO_RADIOSITY) != 0;
    info->filled = plan_is_filled(o);
    info->filters = casts && transparent;
    info->plain = plain;
    if (transparent && !member)
        join(&k->slice->transparent, box);
}

static size_t larger(size_t a, size_t b) { return a > b ? a : b; }

static pov_status compile_one(maker *k, uint32_t index)
{
    compile_state *f = k->f;
    const leaf_node *o = &f->model->leaves.items[index];
    const shape_class *shape = o->shape;
    const void *instance;
    const bool member = f->is_member && f->is_member[index];
    bool finite, shares_leaf = false, instanced = false;
    pov_status status = POV_OK;
    pov_box own, *box = &own;

    if (o->map) {
        status = transform_shape(k, o, index, &finite, &instanced);
        if (status < 0)
            return status;
        box = &f->boxes[index];
        instance = f->moved[index];
    } else {
        instance = make(k, o, false);
        if (!instance)
            return POV_E_MEMORY;
        if (f->moved)
            f->moved[index] = NULL;
        finite = shape->bounds(instance, box) && is_finite_box(box);
    }
    if (k->survey->use_blocks && !member && !instanced && shape->block_size > 0 && shape->block_pack &&
        shape->block_filter) status = try_block(k, shape, instance, finite ? box : NULL, &shares_leaf);
    f->group[index] = (uint16_t)(COMPILE_KINDS * find_class(k, shape)
                                 + (instanced ? COMPILE_INSTANCED : shares_leaf ? COMPILE_SHARES_LEAF : COMPILE_SINGLE));
    k->slice->packed += shares_leaf;
    k->slice->scratch = larger(k->slice->scratch, shape->scratch ? shape->scratch(instance) : 0);
    note(k, o, index, finite ? box : &everything);
    if (!finite)
        f->group[index] |= COMPILE_INFINITE;
    if (member || (f->is_twin && f->is_twin[index])) {
        f->group[index] |= COMPILE_MEMBER;
        return status;
    }
    if (finite && k->slice->finite++ == 0)
        k->slice->bounds = *box;
    else if (finite)
        join(&k->slice->bounds, box);
    k->slice->infinite += !finite;
    return status;
}

static void compile_slice(void *user, uint32_t which, int worker)
{
    survey *s = user;
    uint32_t n = (uint32_t)s->f->model->leaves.count, begin = share_begin(n, s->slice_count, which), i = begin;
    uint32_t end = share_begin(n, s->slice_count, which + 1);
    slice *p = &s->slices[which];
    maker k;

    memset(&k, 0, offsetof(maker, maps));
    compile_maps_init(&k.maps);
    k.survey = s;
    k.f = s->f;
    k.slice = p;
    k.staged = &s->f->staged[worker];
    k.resident = &s->f->resident[worker];
    p->transparent = nothing;
    for (; i < end && p->status == POV_OK; i++) {
        if (s->f->moved && (i - begin) % COMPILE_WINDOW == 0)
            compile_maps_open(&k.maps, &s->f->model->leaves.items[i], end - i);
        p->status = compile_one(&k, i);
        p->failed = i;
    }
}

/* ---- all of them ---- */

static bool find_classes(survey *s, bool *any_map)
{
    const leaf_list *all = &s->f->model->leaves;
    const shape_class *last = NULL;
    size_t i, k;

    *any_map = false;
    for (i = 0; i < all->count; i++) {
        *any_map = *any_map || all->items[i].map;
        if (all->items[i].shape == last)
            continue;
        last = all->items[i].shape;
        for (k = 0; k < s->classes.count && s->classes.items[k] != last; k++)
            continue;
        if (k == s->classes.count && (k == MOST_CLASSES || !VEC_PUSH(s->f->env, &s->classes, last)))
            return false;
    }
    *any_map = *any_map || s->f->model->copies.count > 0;
    return (s->f->model->trees.count == 0 || VEC_PUSH(s->f->env, &s->classes, &csg_class)) &&
           (s->f->model->copies.count == 0 || VEC_PUSH(s->f->env, &s->classes, &copy_class));   /* the last */
}

static arena *make_arenas(const env *e, int count)
{
    arena *arenas = env_alloc(e, (size_t)count, sizeof *arenas);
    int i;

    for (i = 0; arenas && i < count; i++)
        arena_init(&arenas[i], e);
    return arenas;
}

/* Arrays by object are not zeroed: the system clears memory at the first access, which threads do together. */
static bool allocate(survey *s, bool any_map)
{
    compile_state *f = s->f;
    const size_t leaves = f->model->leaves.count, n = compile_count(f);

    s->slice_count = (uint32_t)(leaves / SLICE_LEAST < 1 ? 1 : leaves / SLICE_LEAST > SLICES_MOST ? SLICES_MOST
                                                                            : leaves / SLICE_LEAST);
    s->slices = env_alloc(f->env, s->slice_count, sizeof *s->slices);
    f->staged = make_arenas(f->env, f->threads);
    f->resident = make_arenas(f->env, f->threads);
    f->group = env_resize(f->env, NULL, n + 1, sizeof *f->group);
    f->objects_info = env_resize(f->env, NULL, n + 1, sizeof *f->objects_info);
    if (any_map) {
        f->moved = env_resize(f->env, NULL, n, sizeof *f->moved);
        f->boxes = env_resize(f->env, NULL, n, sizeof *f->boxes);
        f->maps = env_resize(f->env, NULL, n, sizeof *f->maps);
    }
    if (f->model->trees.count > 0)
        f->is_member = env_alloc(f->env, leaves, sizeof *f->is_member);
    return s->slices && f->staged && f->resident && f->group && f->objects_info && (f->is_member || f->model->trees.count == 0) &&
           (!any_map || (f->moved && f->boxes && f->maps));
}

void compile_take(compile_state *f, uint32_t index, const pov_box *box)
{
    if (!box) {
        f->group[index] |= COMPILE_INFINITE;
        f->infinite_count++;
    } else {
        if (f->finite_count++ == 0)
            f->bounds = *box;
        join(&f->bounds, box);
    }
    if (!(f->objects_info[index].slot & COMPILE_OPAQUE))
        join(&f->transparent, box ? box : &everything);
}

/* Sum the slices' counts, or report the first slice's failure. */
static pov_status add_up(survey *s, pov_error *err)
{
    compile_state *f = s->f;
    uint32_t i;

    f->transparent = nothing;
    for (i = 0; i < s->slice_count; i++) {
        const slice *p = &s->slices[i];

        if (p->status == POV_E_MEMORY)
            return err_memory(err);
        if (p->status < 0) {
            const leaf_node *o = &f->model->leaves.items[p->failed];

            return err_set_at(err, p->status, (int)o->line, (int)o->column, "the transformation of this %s has no inverse",
                              o->shape->keyword);
        }
        if (p->finite > 0 && f->finite_count == 0)
            f->bounds = p->bounds;
        else if (p->finite > 0)
            join(&f->bounds, &p->bounds);
        join(&f->transparent, &p->transparent);
        f->finite_count += p->finite;
        f->infinite_count += p->infinite;
        f->absorbed += p->absorbed;
        f->composed += p->composed;
        f->packed += p->packed;
        f->scratch = larger(f->scratch, p->scratch);
    }
    return POV_OK;
}

/* The mark of the host's own classes, which are the last. */
static uint16_t mark_of(const survey *s, const shape_class *shape)
{
    size_t i = s->classes.count;

    while (i > 0 && s->classes.items[i - 1] != shape)
        i--;
    return (uint16_t)(i > 0 ? COMPILE_KINDS * (i - 1) : 0);
}

pov_status compile_objects(compile_state *f, const model *m, const plan *needs, world *const *parts, bool use_blocks, int threads,
                           pov_error *err)
{
    survey s = { f, { NULL, 0, 0 }, NULL, 0, use_blocks };
    pov_status status = POV_OK;
    bool any_map;

    memset(f, 0, sizeof *f);
    f->env = m->env;
    f->model = m;
    f->use_blocks = use_blocks;
    f->clear_members = needs->clear_members;
    f->located = plan_attenuates(m);
    f->parts = parts;
    f->part_count = m->parts.count;
    for (size_t i = 0; i < m->materials.count; i++)
        f->located |= interior_is_located(&m->materials.items[i].interior);
    f->large_resident = m->leaves.count > COMPILE_MANY;
    f->threads = threads;
    if (!find_classes(&s, &any_map) || !allocate(&s, any_map))
        status = err_memory(err);
    if (status == POV_OK)
        compile_mark_members(f);
    if (status == POV_OK && !compile_find_twins(f))
        status = err_memory(err);
    if (status == POV_OK) {
        share_work(threads, s.slice_count, compile_slice, &s);
        status = add_up(&s, err);
    }
    if (status == POV_OK && !compile_add_trees(f, mark_of(&s, &csg_class)))
        status = err_memory(err);
    if (status == POV_OK)
        status = compile_add_copies(f, mark_of(&s, &copy_class), err);
    if (status == POV_OK && !compile_make_groups(f, s.classes.items, s.classes.count))
        status = err_memory(err);
    env_free(f->env, s.classes.items);
    env_free(f->env, s.slices);
    return status;
}

void compile_box(const compile_state *f, uint32_t index, pov_box *out)
{
    const leaf_node *o = compile_leaf(f, index);
    scratch_buffer here;

    if (f->moved && f->moved[index]) {
        *out = f->boxes[index];
    } else if (o->shape->prepare) {
        compile_make(o, aligned(&here));
        o->shape->bounds(aligned(&here), out);
    } else {
        o->shape->bounds(o->instance, out);
    }
}

bool compile_half_space(const compile_state *f, uint32_t index, pov_half_space *out)
{
    const leaf_node *o = compile_leaf(f, index);
    scratch_buffer here;

    if (!o->shape->half_space || f->groups[f->group[index]].instanced || o->shape->instance_size > SCRATCH)
        return false;
    if (f->moved && f->moved[index])
        return o->shape->half_space(f->moved[index], out);
    if (!o->shape->prepare)
        return o->shape->half_space(o->instance, out);
    compile_make(o, aligned(&here));
    return o->shape->half_space(aligned(&here), out);
}

void compile_drop_boxes(compile_state *f)
{
    env_free(f->env, f->boxes);
    f->boxes = NULL;
}

void compile_drop_maps(compile_state *f)
{
    if (f->last)
        model_drop_maps(f->last);
    f->last = NULL;
    env_free(f->env, f->maps);
    f->maps = NULL;
}

void compile_free_arenas(const env *e, arena *arenas, int count)
{
    int i;

    for (i = 0; arenas && i < count; i++)
        arena_free(&arenas[i]);
    env_free(e, arenas);
}

void compile_free(compile_state *f)
{
    compile_free_arenas(f->env, f->staged, f->threads);
    compile_free_arenas(f->env, f->resident, f->threads);
    compile_free_groups(f->env, f->groups, f->group_count);
    env_free(f->env, f->moved);
    env_free(f->env, f->boxes);
    env_free(f->env, f->maps);
    env_free(f->env, f->group);
    env_free(f->env, f->objects_info);
    env_free(f->env, f->shares_leaf);
    env_free(f->env, f->finite);
    env_free(f->env, f->infinite);
    env_free(f->env, f->members);
    env_free(f->env, f->is_member);
    env_free(f->env, f->is_twin);
    csg_free(&f->trees, f->env);
    env_free(f->env, f->roots);
    env_free(f->env, f->tree_leaves);
    env_free(f->env, f->copies);
    env_free(f->env, f->copy_leaves);
    memset(f, 0, sizeof *f);
}
