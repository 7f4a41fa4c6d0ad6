#include "world/flatten.h"

#include "base/err.h"

#include <string.h>

/* Instances and placements are told apart by these. */
enum { INSTANCE_ALIGN = 32, MOST_GROUPS = 0xffff };
/* Beyond this, squares of lengths come near the end of the range of double: such an object is asked apart. */
static const double largest_coordinate = 1e150;

static uint32_t stride_of(const pov_shape_class *shape)
{
    size_t bytes = shape->instance_size > 0 ? shape->instance_size : 1;
    return (uint32_t)((bytes + INSTANCE_ALIGN - 1) / INSTANCE_ALIGN * INSTANCE_ALIGN);
}

/* ---- groups ---- */

/* Index of the group, made if new; negative: no memory, or too many. */
static int find_group(flat *f, const pov_shape_class *shape, bool placed, bool packs)
{
    shape_group fresh = { shape, placed, packs, 0, 0, stride_of(shape), NULL, NULL };
    size_t i;

    for (i = 0; i < f->group_count; i++)
        if (f->groups[i].shape == shape && f->groups[i].placed == placed && f->groups[i].packs == packs)
            return (int)i;
    if (f->group_count == f->group_capacity) {
        size_t wanted = f->group_capacity ? 2 * f->group_capacity : 8;
        shape_group *grown = env_resize(f->env, f->groups, wanted, sizeof *grown);
        bool *packed;
        if (!grown)
            return -1;
        f->groups = grown;
        packed = env_resize(f->env, f->packs, wanted, sizeof *packed);
        if (!packed)
            return -1;
        f->packs = packed;
        f->group_capacity = wanted;
    }
    if (f->group_count >= MOST_GROUPS)
        return -1;
    f->packs[f->group_count] = packs;
    f->groups[f->group_count] = fresh;
    return (int)f->group_count++;
}

/* Would a block take this shape? Tried with it alone, in scratch memory. */
static bool takes(const pov_shape_class *shape, const void *instance, void *scratch)
{
    return shape->block_pack(scratch, &instance, 1);
}

static bool has_blocks(const pov_shape_class *shape)
{
    return shape->block_size > 0 && shape->block_pack && shape->block_filter;
}

/* ---- one object ---- */

typedef struct maker {
    flat *f;
    bool use_blocks;
    const transform *list;       /* what `map` was composed of: many objects in a row may share it */
    pov_affine map;
    const pov_shape_class *scratch_shape;
    void *scratch;               /* a block of that class */
} maker;

static bool is_finite_box(const pov_box *b)
{
    return b->lo.x <= b->hi.x && b->lo.y <= b->hi.y && b->lo.z <= b->hi.z &&
           pov_largest(b->lo) <= largest_coordinate && pov_largest(b->hi) <= largest_coordinate;
}

static pov_status compose(maker *k, const object *o, pov_error *err)
{
    if (o->map == k->list)
        return POV_OK;
    k->list = NULL;
    if (!transform_compose(o->map, &k->map))
        return err_set(err, POV_E_SYNTAX, "the transformation of the %s in line %u has no inverse", o->shape->keyword,
                       (unsigned)o->line);
    k->list = o->map;
    return POV_OK;
}

/* Let a copy take the transformation in. *done: it has. */
static pov_status absorb(maker *k, const object *o, flat_shape *s, bool *done, pov_error *err)
{
    void *copy;

    *done = false;
    if (!o->shape->absorb)
        return POV_OK;
    copy = arena_alloc(&k->f->staging, stride_of(o->shape), INSTANCE_ALIGN);
    if (!copy)
        return err_memory(err);
    memcpy(copy, o->instance, o->shape->instance_size);
    *done = o->shape->absorb(copy, &k->map);
    if (*done)
        s->instance = copy;
    k->f->absorbed += *done;
    return POV_OK;
}

/* Take the transformation into the shape, or place it; *finite says whether *box is set. */
static pov_status place(maker *k, const object *o, flat_shape *s, pov_box *box, bool *finite, pov_error *err)
{
    pov_status status = POV_OK;
    bool done = true;
    pov_box own;

    s->instance = o->instance;
    if (o->map)
        status = compose(k, o, err);
    if (o->map && status == POV_OK)
        status = absorb(k, o, s, &done, err);
    if (status < 0)
        return status;
    if (done) {
        *finite = o->shape->bounds(s->instance, box) && is_finite_box(box);
        return POV_OK;
    }
    k->f->composed++;
    *finite = o->shape->bounds(s->instance, &own) && is_finite_box(&own);
    if (*finite) {
        placement_box(&k->map, &own, box);
        *finite = is_finite_box(box);
    }
    s->placement = arena_alloc(&k->f->staging, sizeof *s->placement, INSTANCE_ALIGN);
    if (!s->placement)
        return err_memory(err);
    placement_init(s->placement, &k->map, *finite ? box : NULL);
    return POV_OK;
}

static pov_status set_scratch(maker *k, const pov_shape_class *shape, pov_error *err)
{
    if (shape == k->scratch_shape)
        return POV_OK;
    k->scratch_shape = NULL;
    k->scratch = arena_alloc(&k->f->staging, shape->block_size, 64);
    if (!k->scratch)
        return err_memory(err);
    k->scratch_shape = shape;
    return POV_OK;
}

static pov_status flatten_one(maker *k, uint32_t index, pov_error *err)
{
    flat *f = k->f;
    const object *o = &f->model->objects.items[index];
    flat_shape *s = &f->shapes[index];
    bool finite, packs = false;
    pov_status status;
    int group;

    status = place(k, o, s, &f->boxes[index], &finite, err);
    if (status < 0)
        return status;
    if (finite && k->use_blocks && !s->placement && has_blocks(o->shape)) {
        status = set_scratch(k, o->shape, err);
        if (status < 0)
            return status;
        packs = takes(o->shape, s->instance, k->scratch);
    }
    group = find_group(f, o->shape, s->placement != NULL, packs);
    if (group < 0)
        return err_memory(err);
    f->group[index] = (uint16_t)group;
    f->groups[group].count++;
    f->packed += packs;
    if (finite)
        f->finite[f->finite_count++] = index;
    else
        f->infinite[f->infinite_count++] = index;
    return POV_OK;
}

/* ---- all ---- */

pov_status flatten(flat *f, const model *m, bool use_blocks, pov_error *err)
{
    size_t n = m->objects.count;
    maker k;
    pov_status status = POV_OK;
    uint32_t i;

    memset(f, 0, sizeof *f);
    memset(&k, 0, sizeof k);
    k.f = f;
    k.use_blocks = use_blocks;
    f->env = m->env;
    f->model = m;
    arena_init(&f->staging, m->env);
    f->shapes = env_alloc(f->env, n, sizeof *f->shapes);
    f->boxes = env_alloc(f->env, n, sizeof *f->boxes);
    f->group = env_alloc(f->env, n, sizeof *f->group);
    f->finite = env_alloc(f->env, n, sizeof *f->finite);
    f->infinite = env_alloc(f->env, n, sizeof *f->infinite);
    if (!f->shapes || !f->boxes || !f->group || !f->finite || !f->infinite)
        status = err_memory(err);
    for (i = 0; status == POV_OK && i < n; i++)
        status = flatten_one(&k, i, err);
    if (status < 0) {
        groups_free(f->env, f->groups, f->group_count);
        f->groups = NULL;
        flat_free(f);
    }
    return status;
}

bool flat_allocate(flat *f)
{
    size_t i;

    for (i = 0; i < f->group_count; i++) {
        shape_group *g = &f->groups[i];
        g->instances = env_alloc_aligned(f->env, (size_t)g->count * g->stride, 64);
        if (!g->instances)
            return false;
        if (g->placed) {
            g->placements = env_alloc_aligned(f->env, g->count * sizeof *g->placements, 64);
            if (!g->placements)
                return false;
        }
    }
    return true;
}

void groups_free(const env *e, shape_group *groups, size_t count)
{
    size_t i;

    for (i = 0; i < count; i++) {
        env_free_aligned(e, groups[i].instances);
        env_free_aligned(e, groups[i].placements);
    }
    env_free(e, groups);
}

void flat_free(flat *f)
{
    arena_free(&f->staging);
    env_free(f->env, f->shapes);
    env_free(f->env, f->boxes);
    env_free(f->env, f->group);
    env_free(f->env, f->packs);
    env_free(f->env, f->finite);
    env_free(f->env, f->infinite);
    memset(f, 0, sizeof *f);
}

/* ---- runs ---- */

static bool comes_before(const flat *f, uint32_t a, uint32_t b)
{
    return f->group[a] != f->group[b] ? f->group[a] < f->group[b] : a < b;
}

/* By group, then by object: few in a leaf, and nearly in order in a list. */
static void put_in_order(const flat *f, uint32_t *ids, uint32_t count)
{
    uint32_t gap, i, j;

    for (gap = 1; gap < count / 3; gap = 3 * gap + 1)
        ;
    for (; gap > 0; gap /= 3)
        for (i = gap; i < count; i++) {
            uint32_t id = ids[i];
            for (j = i; j >= gap && comes_before(f, id, ids[j - gap]); j -= gap)
                ids[j] = ids[j - gap];
            ids[j] = id;
        }
}

/* How many from the front make one run. */
static uint32_t run_length(const flat *f, const uint32_t *ids, uint32_t count)
{
    uint32_t n = 1;

    while (n < count && n < RUN_WIDTH && f->group[ids[n]] == f->group[ids[0]])
        n++;
    return n;
}

size_t flat_runs_size(flat *f, uint32_t *ids, uint32_t count)
{
    size_t bytes = 0;
    uint32_t n;

    put_in_order(f, ids, count);
    for (; count > 0; ids += n, count -= n) {
        const shape_group *g = &f->groups[f->group[ids[0]]];
        n = run_length(f, ids, count);
        bytes += run_bytes(g->shape, g->packs);
    }
    return bytes;
}

static void fill_run(flat *f, const uint32_t *ids, uint32_t count, shape_place *places, run *r)
{
    shape_group *g = &f->groups[f->group[ids[0]]];
    const void *selves[RUN_WIDTH];
    uint32_t i;

    r->shape = g->shape;
    r->stride = g->stride;
    r->instances = g->instances + (size_t)g->used * g->stride;
    r->placements = g->placed ? g->placements + g->used : NULL;
    r->count = (uint8_t)count;
    r->flags = g->packs ? RUN_ROOM : 0;
    for (i = 0; i < count; i++, g->used++) {
        const object *o = &f->model->objects.items[ids[i]];
        unsigned char *instance = g->instances + (size_t)g->used * g->stride;
        memcpy(instance, f->shapes[ids[i]].instance, g->shape->instance_size);
        selves[i] = instance;
        if (g->placed)
            g->placements[g->used] = *f->shapes[ids[i]].placement;
        places[ids[i]].instance = instance;
        places[ids[i]].placement = g->placed ? &g->placements[g->used] : NULL;
        r->object[i] = ids[i];
        r->casts |= (uint8_t)(!(o->flags & OBJECT_NO_SHADOW) << i);
        r->opaque |= (uint8_t)(!material_is_transparent(&f->model->materials.items[o->material]) << i);
    }
    if (g->packs && g->shape->block_pack((unsigned char *)r + RUN_HEAD, selves, count))
        r->flags |= RUN_PACKED;
}

void flat_runs_fill(flat *f, uint32_t *ids, uint32_t count, shape_place *places, void *at)
{
    unsigned char *end = at;
    uint32_t n;

    put_in_order(f, ids, count);
    for (; count > 0; ids += n, count -= n) {
        run *r = (run *)(void *)end;
        n = run_length(f, ids, count);
        fill_run(f, ids, n, places, r);
        if (n < count)
            r->flags |= RUN_MORE;
        end += run_bytes(r->shape, (r->flags & RUN_ROOM) != 0);
    }
}
