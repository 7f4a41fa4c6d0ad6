#include "world/leaf_layout.h"

#include "base/pages.h"
#include "base/share.h"
#include "base/simd.h"

#include <string.h>

bool runs_init(runs *r, flat *f, uint32_t parts)
{
    memset(r, 0, sizeof *r);
    r->flat = f;
    r->parts = parts;
    r->of = env_alloc(f->env, parts + 1u, sizeof *r->of);
    r->ready = env_resize(f->env, NULL, parts, PLACEMENT_MANY * sizeof *r->ready);
    r->at = env_alloc(f->env, parts, f->group_count * sizeof *r->at);
    return r->of && r->ready && r->at;
}

void runs_free(runs *r)
{
    env_free(r->flat->env, r->of);
    env_free(r->flat->env, r->maps);
    env_free(r->flat->env, r->ready);
    env_free(r->flat->env, r->at);
    r->of = NULL;
    r->maps = NULL;
    r->ready = NULL;
    r->at = NULL;
}

/* Objects of a leaf lie anywhere in the scene. Looking ahead by so many hides most of the way to memory. */
enum { AHEAD = 16, EXPECTED = 512 };

/* ---- sizes ---- */

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

/* How many from the front make one run. Shapes with a placement stay where they are, so each makes its own, as does what
 * may stand alone. */
static uint32_t run_length(const flat *f, const uint32_t *ids, uint32_t count)
{
    const shape_group *g = &f->groups[f->group[ids[0]]];
    uint32_t n = 1;

    if (g->placed || (!g->packs && run_may_stand(g->shape)))
        return 1;
    while (n < count && n < RUN_WIDTH && f->group[ids[n]] == f->group[ids[0]])
        n++;
    return n;
}

/* What stands of placed shapes hold, a line of memory each, is too much where there are more of them. */
enum { STANDS_MOST = 1 << 17 };

static unsigned room_of(const flat *f, const shape_group *g)
{
    if (g->placed)
        return f->composed <= STANDS_MOST ? RUN_PLACED | RUN_ROOM : RUN_PLACED;
    return g->packs ? RUN_ROOM : 0;
}

/* Is the instance of a run's only shape where it will be? */
static bool is_settled(const flat *f, uint32_t id, uint32_t count)
{
    return count == 1 && f->moved && f->moved[id] && flat_stays(f, f->groups[f->group[id]].shape);
}

/* What the size of what comes soon depends on. */
SIMD_INLINE void expect_size(const flat *f, const uint32_t *ids, uint32_t rest)
{
    if (!f->moved || rest <= AHEAD)
        return;
    SIMD_EXPECT(&f->group[ids[AHEAD]]);
    SIMD_EXPECT(&f->moved[ids[AHEAD]]);
    if (f->maps)
        SIMD_EXPECT(&f->maps[ids[AHEAD]]);
}

size_t runs_size(runs *r, uint32_t part, uint32_t *ids, uint32_t count, uint32_t rest)
{
    const flat *f = r->flat;
    size_t bytes = 0;
    uint32_t n;

    expect_size(f, ids, rest);
    put_in_order(f, ids, count);
    r->of[part].ids += count;
    for (; count > 0; ids += n, count -= n) {
        const shape_group *g = &f->groups[f->group[ids[0]]];
        n = run_length(f, ids, count);
        if (!is_settled(f, ids[0], n))
            r->at[part * f->group_count + f->group[ids[0]]] += n;
        bytes += run_bytes(g->shape, n, room_of(f, g));
        if (g->placed && f->last)
            r->of[part].maps += f->maps[ids[0]];
    }
    return bytes;
}

bool runs_allocate(runs *r)
{
    flat *f = r->flat;
    size_t g;
    uint32_t part;

    for (g = 0; g < f->group_count; g++) {
        uint32_t all = 0;
        for (part = 0; part < r->parts; part++) {
            uint32_t *at = &r->at[part * f->group_count + g], n = *at;
            *at = all;
            all += n;
        }
        if (all > RUNS_ALONE)
            return false;
        if (f->groups[g].placed)
            continue;
        f->groups[g].instances = env_reserve_aligned(f->env, (size_t)all * f->groups[g].stride, 64);
        if (!f->groups[g].instances)
            return false;
    }
    return true;
}

/* ---- transformations ---- */

/* The last of its transformations and those written before it, which mostly lie before it. */
SIMD_INLINE void expect_list(const transform *list)
{
    if (list) {
        SIMD_EXPECT(list->v);
        SIMD_EXPECT((const unsigned char *)list - 64);
    }
}

static void take_part(void *user, uint32_t part, int hand)
{
    const runs *r = user;
    const flat *f = r->flat;
    size_t at = r->of[part].maps;
    uint32_t i;

    (void)hand;
    for (i = r->of[part].ids; i < r->of[part + 1].ids; i++) {
        const uint32_t id = f->finite[i];
        if (i + 2 * AHEAD < f->finite_count) {
            const uint32_t next = f->finite[i + 2 * AHEAD];
            SIMD_EXPECT(&flat_leaf(f, next)->map);
            SIMD_EXPECT(&f->group[next]);
            SIMD_EXPECT(&f->maps[next]);
        }
        if (i + AHEAD < f->finite_count)
            expect_list(flat_leaf(f, f->finite[i + AHEAD])->map);
        if (f->groups[f->group[id]].placed) {
            transform_pack(flat_leaf(f, id)->map, r->maps + at);
            at += f->maps[id];
        }
    }
}

bool runs_take_maps(runs *r, uint32_t first)
{
    flat *f = r->flat;
    size_t maps = 0;
    uint32_t part, ids = 0;

    if (!f->last)
        return true;
    for (part = 0; part <= r->parts; part++) {
        const runs_part mine = r->of[part];
        const runs_part from = { ids, ids, maps, maps, 0, 0 };
        r->of[part] = from;
        ids += part < first ? 0 : mine.ids;
        maps += part < first ? 0 : mine.maps;
    }
    if (maps > 0) {
        r->maps = env_resize(f->env, NULL, maps, 1);
        if (!r->maps)
            return false;
        share_work(f->threads, r->parts, take_part, r);
    }
    flat_drop_maps(f);
    return true;
}

void runs_filled(runs *r, uint32_t part)
{
    unsigned char *rest;

    if (!r->maps || r->of[part].maps == 0)
        return;
    rest = env_resize(r->flat->env, r->maps, r->of[part].maps, 1);
    if (rest)
        r->maps = rest;
}

/* Of the part's next placed shapes, as many as the transformations that could be composed at once. */
static void place_next(runs *r, uint32_t part)
{
    const flat *f = r->flat;
    runs_part *p = &r->of[part];
    pov_affine maps[TRANSFORM_MANY];
    uint32_t ids[TRANSFORM_MANY];
    const void *next = transform_compose_packed(r->maps + p->next, r->maps + p[1].maps, maps, &p->ready);
    int n = 0;

    for (; n < p->ready; p->next_id++)
        if (f->groups[f->group[f->finite[p->next_id]]].placed)
            ids[n++] = f->finite[p->next_id];
    flat_place(f, ids, maps, n, r->ready + part * PLACEMENT_MANY);
    p->next = (size_t)((const unsigned char *)next - r->maps);
    p->used = 0;
}

static const placement *placement_of(runs *r, uint32_t part, uint32_t id)
{
    placement *ready = r->ready + part * PLACEMENT_MANY;
    runs_part *p = &r->of[part];
    pov_affine map;

    if (!r->maps) {
        transform_compose(flat_leaf(r->flat, id)->map, &map);   /* as it could before */
        flat_place(r->flat, &id, &map, 1, ready);
        return ready;
    }
    if (p->used == p->ready)
        place_next(r, part);
    return &ready[p->used++];
}

/* ---- filling ---- */

/* Put the instance into its final place. */
static const void *settle(runs *r, uint32_t id, uint32_t slot)
{
    const flat *f = r->flat;
    const shape_group *g = &f->groups[f->group[id]];
    unsigned char *instance = g->instances + (size_t)slot * g->stride;

    if (f->moved && f->moved[id])
        memcpy(instance, f->moved[id], g->shape->instance_size);
    else
        flat_make(flat_leaf(f, id), instance);
    f->things[id].slot = slot;
    return instance;
}

/* Where the run of one whose instance is not among its group's stands. */
static void note_run(runs *r, uint32_t id, const run *out)
{
    const size_t line = (size_t)((const unsigned char *)out - r->base) / RUNS_LINE;

    r->flat->things[id].slot = (uint32_t)line | RUNS_ALONE | r->mark;
}

/* What a run of a placed shape holds besides, and where it can be found. */
static const void *place(runs *r, uint32_t part, const bvh_frame *frame, uint32_t id, run *out)
{
    unsigned char *start = (unsigned char *)out;
    placement *p = (placement *)(void *)(start + RUN_PLACE);
    stand s;

    *p = *placement_of(r, part, id);
    if (r->flat->use_blocks && frame && placement_stand(p, frame, &s)) {
        out->flags |= RUN_PACKED;
        if (out->flags & RUN_ROOM)
            memcpy(start + RUN_PLACED_BYTES, &s, sizeof s);
    }
    note_run(r, id, out);
    return r->flat->moved[id];
}

static bool pack(const shape_class *shape, const bvh_frame *in, const void *const *selves, uint32_t count, run *out)
{
    pov_frame frame = { { 0.0, 0.0, 0.0 }, 1.0 };

    if (in) {
        frame.centre = in->centre;
        frame.scale = in->scale;
    }
    return shape->block_pack((unsigned char *)out + RUN_HEAD, in ? &frame : NULL, selves, count);
}

/* An ellipsoid alone behind the head of its run. */
static bool stand_alone(const runs *r, const bvh_frame *frame, const void *self, run *out)
{
    stand *s = (stand *)(void *)((unsigned char *)out + RUN_HEAD);
    pov_ellipsoid e;

    return r->flat->use_blocks && frame && out->shape->ellipsoid(self, &e) && placement_stand_ellipsoid(&e, frame, s);
}

static void fill_run(runs *r, uint32_t part, const bvh_frame *frame, const uint32_t *ids, uint32_t count, run *out)
{
    const flat *f = r->flat;
    uint32_t *at = &r->at[part * f->group_count + f->group[ids[0]]];
    const shape_group *g = &f->groups[f->group[ids[0]]];
    const void *selves[RUN_WIDTH] = { NULL };
    uint8_t plain = 0;
    uint32_t i;

    memset(out, 0, run_bytes(g->shape, count, room_of(f, g)));
    out->shape = g->shape;
    out->count = (uint8_t)count;
    out->flags = (uint8_t)(room_of(f, g) | (unsigned)g->class_number << RUN_CLASS_SHIFT);
    for (i = 0; i < count; i++) {
        world_thing *thing = &f->things[ids[i]];

        out->object[i] = ids[i];
        out->casts |= (uint8_t)((thing->slot & FLAT_CASTS ? 1u : 0u) << i);
        out->opaque |= (uint8_t)((thing->slot & FLAT_OPAQUE ? 1u : 0u) << i);
        plain |= (uint8_t)((thing->slot & FLAT_PLAIN ? 1u : 0u) << i);
        thing->group = f->group[ids[i]];
        if (g->placed) {
            selves[i] = place(r, part, frame, ids[i], out);
        } else if (is_settled(f, ids[i], count)) {
            note_run(r, ids[i], out);
            selves[i] = f->moved[ids[i]];
        } else {
            selves[i] = settle(r, ids[i], (*at)++);
        }
    }
    out->instances = selves[0];
    out->plain = plain;          /* now: it lies among the bytes of an instance's transform */
    if (!g->placed)
        out->stride = g->stride;
    if (g->packs && pack(g->shape, frame, selves, count, out))
        out->flags |= RUN_PACKED;
    if (!g->placed && !g->packs && run_may_stand(g->shape) && stand_alone(r, frame, selves[0], out))
        out->flags |= RUN_PACKED;
}

/* A shape as it will soon be read, from where it stands now. */
SIMD_INLINE void expect_shape(const flat *f, uint32_t id)
{
    const shape_class *shape = f->groups[f->group[id]].shape;
    const unsigned char *moved = f->moved ? f->moved[id] : NULL;
    const unsigned char *from = moved ? moved : flat_leaf(f, id)->instance;
    const size_t all = moved || !shape->prepare ? shape->instance_size : shape->parsed_size;
    const size_t bytes = all < EXPECTED ? all : EXPECTED;
    size_t i;

    for (i = 0; i < bytes; i += RUNS_LINE)
        SIMD_EXPECT(from + i);
}

/* What will soon be read of an object: of one that stays as it was written, where that is. */
SIMD_INLINE void expect(const runs *r, const uint32_t *ids)
{
    const flat *f = r->flat;
    uint32_t id;

    if (r->mark != 0 || ids + 2 * AHEAD >= f->finite + f->finite_count)
        return;
    id = ids[2 * AHEAD];
    SIMD_EXPECT(&f->group[id]);
    SIMD_EXPECT(&f->things[id]);
    if (f->moved)
        SIMD_EXPECT(&f->moved[id]);
    else
        SIMD_EXPECT(flat_leaf(f, id));
    expect_shape(f, ids[AHEAD]);
}

void runs_fill(runs *r, uint32_t part, const bvh_frame *frame, const uint32_t *ids, uint32_t count, void *at)
{
    const flat *f = r->flat;
    unsigned char *end = at;
    uint32_t n;

    for (; count > 0; ids += n, count -= n) {
        run *out = (run *)(void *)end;
        n = run_length(f, ids, count);
        expect(r, ids + n);
        fill_run(r, part, frame, ids, n, out);
        if (n < count)
            out->flags |= RUN_MORE;
        end += run_bytes(out->shape, out->count, out->flags);
    }
}
