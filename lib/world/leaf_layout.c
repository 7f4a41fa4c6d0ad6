#include "world/leaf_layout.h"

#include "base/pages.h"
#include "base/share.h"
#include "base/simd.h"

#include <string.h>

bool leaf_layout_init(leaf_layout *r, compile_state *f, uint32_t slices)
{
    memset(r, 0, sizeof *r);
    r->state = f;
    r->slices = slices;
    r->of = env_alloc(f->env, slices + 1u, sizeof *r->of);
    r->ready = env_resize(f->env, NULL, slices, TRANSFORM_MANY * sizeof *r->ready);
    r->at = env_alloc(f->env, slices, f->group_count * sizeof *r->at);
    return r->of && r->ready && r->at;
}

void leaf_layout_free(leaf_layout *r)
{
    env_free(r->state->env, r->of);
    env_free(r->state->env, r->maps);
    env_free(r->state->env, r->ready);
    env_free(r->state->env, r->at);
    r->of = NULL;
    r->maps = NULL;
    r->ready = NULL;
    r->at = NULL;
}

/* Objects of a leaf lie anywhere in the scene. Prefetching this far ahead hides most of the memory latency. */
enum { AHEAD = 16, PREFETCHED = 512 };

/* ---- sizes ---- */

static bool comes_before(const compile_state *f, uint32_t a, uint32_t b)
{
    return f->group[a] != f->group[b] ? f->group[a] < f->group[b] : a < b;
}

/* By group, then by object: few in a leaf, and nearly in order in a list. */
static void put_in_order(const compile_state *f, uint32_t *ids, uint32_t count)
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

/* Number of objects at the front that form one leaf batch. An instanced shape has a batch of its own, as has any shape
 * with a single instance filter. */
static uint32_t batch_length(const compile_state *f, const uint32_t *ids, uint32_t count)
{
    const shape_group *g = &f->groups[f->group[ids[0]]];
    uint32_t n = 1;

    if (g->instanced || (!g->shares_leaf && leaf_batch_may_filter(g->shape)))
        return 1;
    while (n < count && n < LEAF_WIDTH && f->group[ids[n]] == f->group[ids[0]])
        n++;
    return n;
}

/* More instance filters than this, one cache line each, take too much memory. */
enum { INSTANCE_FILTERS_MOST = 1 << 17 };

static unsigned flags_of(const compile_state *f, const shape_group *g)
{
    if (g->instanced)
        return f->composed <= INSTANCE_FILTERS_MOST ? LEAF_INSTANCED | LEAF_RESERVED : LEAF_INSTANCED;
    return g->shares_leaf ? LEAF_RESERVED : 0;
}

/* Is the instance of a leaf batch's only shape already in its final memory? */
static bool is_resident(const compile_state *f, uint32_t id, uint32_t count)
{
    return count == 1 && f->moved && f->moved[id] && compile_is_resident(f, f->groups[f->group[id]].shape);
}

/* Prefetch the data for the size of batches that come soon. */
SIMD_INLINE void prefetch_size(const compile_state *f, const uint32_t *ids, uint32_t rest)
{
    if (!f->moved || rest <= AHEAD)
        return;
    SIMD_PREFETCH(&f->group[ids[AHEAD]]);
    SIMD_PREFETCH(&f->moved[ids[AHEAD]]);
    if (f->maps)
        SIMD_PREFETCH(&f->maps[ids[AHEAD]]);
}

size_t leaf_layout_size(leaf_layout *r, uint32_t slice, uint32_t *ids, uint32_t count, uint32_t rest)
{
    const compile_state *f = r->state;
    size_t bytes = 0;
    uint32_t n;

    prefetch_size(f, ids, rest);
    put_in_order(f, ids, count);
    r->of[slice].ids += count;
    for (; count > 0; ids += n, count -= n) {
        const shape_group *g = &f->groups[f->group[ids[0]]];
        n = batch_length(f, ids, count);
        if (!is_resident(f, ids[0], n))
            r->at[slice * f->group_count + f->group[ids[0]]] += n;
        bytes += leaf_batch_bytes(g->shape, n, flags_of(f, g));
        if (g->instanced && f->last)
            r->of[slice].maps += f->maps[ids[0]];
    }
    return bytes;
}

bool leaf_layout_allocate(leaf_layout *r)
{
    compile_state *f = r->state;
    size_t g;
    uint32_t slice;

    for (g = 0; g < f->group_count; g++) {
        uint32_t all = 0;
        for (slice = 0; slice < r->slices; slice++) {
            uint32_t *at = &r->at[slice * f->group_count + g], n = *at;
            *at = all;
            all += n;
        }
        if (all > LEAF_SINGLE)
            return false;
        if (f->groups[g].instanced)
            continue;
        f->groups[g].instances = env_reserve_aligned(f->env, (size_t)all * f->groups[g].stride, 64);
        if (!f->groups[g].instances)
            return false;
    }
    return true;
}

/* ---- transformations ---- */

/* Prefetch the last of its transformations and those written before it, which mostly precede it in memory. */
SIMD_INLINE void prefetch_list(const transform *list)
{
    if (list) {
        SIMD_PREFETCH(list->v);
        SIMD_PREFETCH((const unsigned char *)list - 64);
    }
}

static void take_slice(void *user, uint32_t slice, int worker)
{
    const leaf_layout *r = user;
    const compile_state *f = r->state;
    size_t at = r->of[slice].maps;
    uint32_t i;

    (void)worker;
    for (i = r->of[slice].ids; i < r->of[slice + 1].ids; i++) {
        const uint32_t id = f->finite[i];
        if (i + 2 * AHEAD < f->finite_count) {
            const uint32_t next = f->finite[i + 2 * AHEAD];
            SIMD_PREFETCH(&compile_leaf(f, next)->map);
            SIMD_PREFETCH(&f->group[next]);
            SIMD_PREFETCH(&f->maps[next]);
        }
        if (i + AHEAD < f->finite_count)
            prefetch_list(compile_leaf(f, f->finite[i + AHEAD])->map);
        if (f->groups[f->group[id]].instanced) {
            transform_pack(compile_leaf(f, id)->map, r->maps + at);
            at += f->maps[id];
        }
    }
}

bool leaf_layout_take_maps(leaf_layout *r, uint32_t first)
{
    compile_state *f = r->state;
    size_t maps = 0;
    uint32_t slice, ids = 0;

    if (!f->last)
        return true;
    for (slice = 0; slice <= r->slices; slice++) {
        const leaf_layout_slice mine = r->of[slice];
        const leaf_layout_slice from = { ids, ids, maps, maps, 0, 0 };
        r->of[slice] = from;
        ids += slice < first ? 0 : mine.ids;
        maps += slice < first ? 0 : mine.maps;
    }
    if (maps > 0) {
        r->maps = env_resize(f->env, NULL, maps, 1);
        if (!r->maps)
            return false;
        share_work(f->threads, r->slices, take_slice, r);
    }
    compile_drop_maps(f);
    return true;
}

void leaf_layout_filled(leaf_layout *r, uint32_t slice)
{
    unsigned char *rest;

    if (!r->maps || r->of[slice].maps == 0)
        return;
    rest = env_resize(r->state->env, r->maps, r->of[slice].maps, 1);
    if (rest)
        r->maps = rest;
}

/* Make instance transforms for the next instanced shapes of the slice, as many as could be composed at once. */
static void instances_next(leaf_layout *r, uint32_t slice)
{
    const compile_state *f = r->state;
    leaf_layout_slice *p = &r->of[slice];
    pov_affine maps[TRANSFORM_MANY];
    uint32_t ids[TRANSFORM_MANY];
    const void *next = transform_compose_packed(r->maps + p->next, r->maps + p[1].maps, maps, &p->ready);
    int n = 0;

    for (; n < p->ready; p->next_id++)
        if (f->groups[f->group[f->finite[p->next_id]]].instanced)
            ids[n++] = f->finite[p->next_id];
    compile_instances(f, ids, maps, n, r->ready + slice * TRANSFORM_MANY);
    p->next = (size_t)((const unsigned char *)next - r->maps);
    p->used = 0;
}

static const instance_xform *instance_of(leaf_layout *r, uint32_t slice, uint32_t id)
{
    instance_xform *ready = r->ready + slice * TRANSFORM_MANY;
    leaf_layout_slice *p = &r->of[slice];
    pov_affine map;

    if (!r->maps) {
        transform_compose(compile_leaf(r->state, id)->map, &map);   /* succeeds, as before */
        compile_instances(r->state, &id, &map, 1, ready);
        return ready;
    }
    if (p->used == p->ready)
        instances_next(r, slice);
    return &ready[p->used++];
}

/* ---- filling ---- */

/* Store the instance in its final memory. */
static const void *store_instance(leaf_layout *r, uint32_t id, uint32_t slot)
{
    const compile_state *f = r->state;
    const shape_group *g = &f->groups[f->group[id]];
    unsigned char *instance = g->instances + (size_t)slot * g->stride;

    if (f->moved && f->moved[id])
        memcpy(instance, f->moved[id], g->shape->instance_size);
    else
        compile_make(compile_leaf(f, id), instance);
    f->objects_info[id].slot = slot;
    return instance;
}

/* Record the leaf batch of an object whose instance is not among its group's. */
static void note_batch(leaf_layout *r, uint32_t id, const leaf_batch *out)
{
    const size_t line = (size_t)((const unsigned char *)out - r->base) / LEAF_LINE;

    r->state->objects_info[id].slot = (uint32_t)line | LEAF_SINGLE | r->mark;
}

/* Fill the instance transform of a leaf batch, and record its position. */
static const void *add_instance(leaf_layout *r, uint32_t slice, const bvh_frame *frame, uint32_t id, leaf_batch *out)
{
    unsigned char *start = (unsigned char *)out;
    instance_xform *p = (instance_xform *)(void *)(start + LEAF_XFORM);
    instance_filter s;

    *p = *instance_of(r, slice, id);
    if (r->state->use_blocks && frame && instance_filter_make(p, frame, &s)) {
        out->flags |= LEAF_PACKED;
        if (out->flags & LEAF_RESERVED)
            memcpy(start + LEAF_INSTANCED_BYTES, &s, sizeof s);
    }
    note_batch(r, id, out);
    return r->state->moved[id];
}

static bool pack(const shape_class *shape, const bvh_frame *in, const void *const *selves, uint32_t count,
                 leaf_batch *out)
{
    pov_frame frame = { { 0.0, 0.0, 0.0 }, 1.0 };

    if (in) {
        frame.centre = in->centre;
        frame.scale = in->scale;
    }
    return shape->block_pack((unsigned char *)out + LEAF_HEAD, in ? &frame : NULL, selves, count);
}

/* The instance filter of a single ellipsoid behind the head of its leaf batch. */
static bool filter_single(const leaf_layout *r, const bvh_frame *frame, const void *self, leaf_batch *out)
{
    instance_filter *s = (instance_filter *)(void *)((unsigned char *)out + LEAF_HEAD);
    pov_ellipsoid e;

    return r->state->use_blocks && frame && out->shape->ellipsoid(self, &e) &&
        instance_filter_make_ellipsoid(&e, frame, s);
}

static void fill_batch(leaf_layout *r, uint32_t slice, const bvh_frame *frame, const uint32_t *ids, uint32_t count,
                       leaf_batch *out)
{
    const compile_state *f = r->state;
    uint32_t *at = &r->at[slice * f->group_count + f->group[ids[0]]];
    const shape_group *g = &f->groups[f->group[ids[0]]];
    const void *selves[LEAF_WIDTH] = { NULL };
    uint8_t plain = 0;
    uint32_t i;

    memset(out, 0, leaf_batch_bytes(g->shape, count, flags_of(f, g)));
    out->shape = g->shape;
    out->count = (uint8_t)count;
    out->flags = (uint8_t)(flags_of(f, g) | (unsigned)g->class_number << LEAF_CLASS_SHIFT);
    for (i = 0; i < count; i++) {
        object_info *info = &f->objects_info[ids[i]];

        out->object[i] = ids[i];
        out->casts |= (uint8_t)((info->slot & COMPILE_CASTS ? 1u : 0u) << i);
        out->opaque |= (uint8_t)((info->slot & COMPILE_OPAQUE ? 1u : 0u) << i);
        plain |= (uint8_t)((info->slot & COMPILE_PLAIN ? 1u : 0u) << i);
        info->group = f->group[ids[i]];
        if (g->instanced) {
            selves[i] = add_instance(r, slice, frame, ids[i], out);
        } else if (is_resident(f, ids[i], count)) {
            note_batch(r, ids[i], out);
            selves[i] = f->moved[ids[i]];
        } else {
            selves[i] = store_instance(r, ids[i], (*at)++);
        }
    }
    out->instances = selves[0];
    out->plain = plain;          /* only now: it is one of the bytes of the instance transform */
    if (!g->instanced)
        out->stride = g->stride;
    if (g->shares_leaf && pack(g->shape, frame, selves, count, out))
        out->flags |= LEAF_PACKED;
    if (g->shares_leaf && g->shape == &csg_class)
        out->plain = (uint8_t)leaf_batch_lanes(out);   /* a definite hit is one whatever members look like */
    if (!g->instanced && !g->shares_leaf && leaf_batch_may_filter(g->shape) && filter_single(r, frame, selves[0], out))
        out->flags |= LEAF_PACKED;
}

/* Prefetch a shape that will soon be copied, from its present memory. */
SIMD_INLINE void prefetch_shape(const compile_state *f, uint32_t id)
{
    const shape_class *shape = f->groups[f->group[id]].shape;
    const unsigned char *moved = f->moved ? f->moved[id] : NULL;
    const unsigned char *from = moved ? moved : compile_leaf(f, id)->instance;
    const size_t all = moved || !shape->prepare ? shape->instance_size : shape->parsed_size;
    const size_t bytes = all < PREFETCHED ? all : PREFETCHED;
    size_t i;

    for (i = 0; i < bytes; i += LEAF_LINE)
        SIMD_PREFETCH(from + i);
}

/* Prefetch an object's data that will soon be read: for an unchanged object, its parsed form. */
SIMD_INLINE void prefetch(const leaf_layout *r, const uint32_t *ids)
{
    const compile_state *f = r->state;
    uint32_t id;

    if (r->mark != 0 || ids + 2 * AHEAD >= f->finite + f->finite_count)
        return;
    id = ids[2 * AHEAD];
    SIMD_PREFETCH(&f->group[id]);
    SIMD_PREFETCH(&f->objects_info[id]);
    if (f->moved)
        SIMD_PREFETCH(&f->moved[id]);
    else
        SIMD_PREFETCH(compile_leaf(f, id));
    prefetch_shape(f, ids[AHEAD]);
}

void leaf_layout_fill(leaf_layout *r, uint32_t slice, const bvh_frame *frame, const uint32_t *ids, uint32_t count,
                      void *at)
{
    const compile_state *f = r->state;
    unsigned char *end = at;
    uint32_t n;

    for (; count > 0; ids += n, count -= n) {
        leaf_batch *out = (leaf_batch *)(void *)end;
        n = batch_length(f, ids, count);
        prefetch(r, ids + n);
        fill_batch(r, slice, frame, ids, n, out);
        if (n < count)
            out->flags |= LEAF_MORE;
        end += leaf_batch_bytes(out->shape, out->count, out->flags);
    }
}
