#include "world/bvh_build.h"

#include "base/share.h"
#include "base/thread.h"
#include "base/vec.h"

#include <string.h>

/* From this depth on the tree is halved by count, so that log8(2^32) < 12 more steps end it: BVH_DEPTH is enough. */
enum { HALVE_FROM = 40 };
/* A part of a frame gets one of its own when it is at most 2^-10 of it and holds enough to repay the change. */
static const float frame_part = 0x1p-10f;
enum { FRAME_LEAST = 16 };
/* What a lowest node holds when it is full. */
enum { FULL_PACKED = BVH_WIDTH * BVH_WIDTH, FULL_ALONE = BVH_WIDTH };
/* Parts of fewer things than this are not worth a thread's while. */
enum { JOB_LEAST = 4096, THREADS_FROM = 20000, PARTS = 64 };

/* A part of the tree that is to grow, perhaps by whoever comes first. */
typedef struct job {
    bvh_draft_child *child;
    bvh_range range;             /* in its own frame where it has one */
    double scale;                /* of that frame */
    int depth;
} job;

typedef struct builder {
    const bvh_input *in;
    int threads;
    bvh_ref *refs;
    const bvh_frame *frame;      /* the whole scene's */
    mutex lock;                  /* guards what follows, while threads work */
    condition changed;
    struct { job *items; size_t count, capacity; } jobs;
    int at_work;                 /* hands whose job may lead to others */
    bool failed;
} builder;

/* One thread's part in it. */
typedef struct hand {
    builder *builder;
    arena memory;
} hand;

/* One thing, or what one block can hold. Leaves that ask two blocks, or more things than one that stand alone, were
 * measured to cost more than the nodes that tell them apart. */
static bool is_leaf(const builder *b, const bvh_range *r)
{
    uint32_t i;
    uint16_t group;

    if (bvh_range_count(r) == 1)
        return true;
    if (bvh_range_count(r) > BVH_WIDTH)
        return false;
    group = b->in->group[b->refs[r->begin].id];
    for (i = r->begin + 1; i < r->end; i++)
        if (b->in->group[b->refs[i].id] != group)
            return false;
    return b->in->packs[group];
}

/* threads: who has nothing else to do. */
static void cut(const builder *b, const bvh_range *r, bool halve, int threads, bvh_range *x, bvh_range *y)
{
    bvh_range whole = *r;

    if (halve)
        bvh_halve(&whole, b->refs, x, y);
    else
        bvh_split(&whole, b->refs, b->in->all_pack, threads, x, y);
    x->is_leaf = is_leaf(b, x);
    y->is_leaf = is_leaf(b, y);
}

/* Parts of a node of n things need not be smaller than this: a power of the tree's width times what a lowest node
 * holds, so that nodes are nearly full all the way down. */
static uint32_t part_of(const builder *b, uint32_t n)
{
    uint32_t part = b->in->all_pack ? FULL_PACKED : FULL_ALONE;

    if (n <= part)
        return 0;
    while (n / part > BVH_WIDTH)
        part *= BVH_WIDTH;
    return part;
}

/* Which of the parts to cut next: the one most often met, or at great depth the one of most things; -1: none. */
static int next_to_cut(const bvh_range *parts, int n, uint32_t part, bool halve)
{
    float most = -1.0f;
    int i, best = -1;

    for (i = 0; i < n; i++) {
        float size = halve ? (float)bvh_range_count(&parts[i]) : parts[i].area;
        if (!parts[i].is_leaf && size > most && (bvh_range_count(&parts[i]) > part || halve)) {
            most = size;
            best = i;
        }
    }
    return best;
}

static bool grow_child(hand *h, const job *j);

/* Parts of a range become children of one node. */
static bool grow_parts(hand *h, const job *above, const bvh_range *parts, int n)
{
    bvh_draft_node *node = arena_alloc(&h->memory, sizeof *node + (size_t)n * sizeof *node->child, 8);
    int i;

    if (!node)
        return false;
    above->child->node = node;
    node->count = n;
    for (i = 0; i < n; i++) {
        bvh_draft_child *c = &node->child[i];
        memcpy(c->lo, parts[i].lo, sizeof c->lo);
        memcpy(c->hi, parts[i].hi, sizeof c->hi);
        c->begin = parts[i].begin;
        c->count = bvh_range_count(&parts[i]);
    }
    for (i = 0; i < n; i++) {
        const job below = { &node->child[i], parts[i], above->scale, above->depth + 1 };
        if (!grow_child(h, &below))
            return false;
    }
    return true;
}

/* The things of a range become a node. */
static bool grow_node(hand *h, const job *j)
{
    bvh_range parts[BVH_WIDTH];
    bool halve = j->depth >= HALVE_FROM;
    uint32_t part = part_of(h->builder, bvh_range_count(&j->range));
    int n = 1, best, threads = j->depth == 0 ? h->builder->threads : 1;

    parts[0] = j->range;
    while (n < BVH_WIDTH && (best = next_to_cut(parts, n, part, halve)) >= 0) {
        cut(h->builder, &parts[best], halve, threads, &parts[best], &parts[n]);
        n++;
    }
    return grow_parts(h, j, parts, n);
}

static bool wants_frame(const bvh_range *r, int depth)
{
    int k;

    for (k = 0; k < 3; k++)
        if (r->hi[k] - r->lo[k] > frame_part)
            return false;
    return bvh_range_count(r) >= FRAME_LEAST && depth < HALVE_FROM;
}

/* Boxes within a few rounding errors of the world's own numbers gain nothing from a finer frame, and get none. */
static bool set_frame(hand *h, job *j)
{
    const bvh_input *in = h->builder->in;
    bvh_range *r = &j->range;
    pov_box all = bvh_box_around(in, h->builder->refs, r->begin, r->end);
    bvh_frame frame = bvh_frame_around(&all);

    if (frame.scale * (double)frame_part < 0.25 * j->scale)
        return true;
    j->child->frame = arena_alloc(&h->memory, sizeof frame, 8);
    if (!j->child->frame)
        return false;
    *j->child->frame = frame;
    j->scale = frame.scale;
    bvh_frame_convert(&frame, in, h->builder->refs, r->begin, r->end);
    bvh_range_measure(r, h->builder->refs, 1);
    return true;
}

static bool grow(hand *h, const job *j)
{
    job own = *j;

    if (wants_frame(&own.range, own.depth) && !set_frame(h, &own))
        return false;
    return grow_node(h, &own);
}

/* ---- by several threads ---- */

static bool leave_to_others(hand *h, const job *j)
{
    builder *b = h->builder;
    bool done;

    mutex_lock(&b->lock);
    done = VEC_PUSH(b->in->env, &b->jobs, *j);
    condition_wake_all(&b->changed);
    mutex_unlock(&b->lock);
    return done;
}

static bool grow_child(hand *h, const job *j)
{
    if (j->range.is_leaf)
        return true;
    if (h->builder->threads > 1 && bvh_range_count(&j->range) >= JOB_LEAST)
        return leave_to_others(h, j);
    return grow(h, j);
}

/* Take jobs until there are none and nobody is left who could bring one. */
static void work(void *user, uint32_t which, int unused)
{
    hand *h = (hand *)user + which;
    builder *b = h->builder;

    (void)unused;
    mutex_lock(&b->lock);
    while (!b->failed && (b->jobs.count > 0 || b->at_work > 0)) {
        bool done;
        job mine;
        if (b->jobs.count == 0) {
            condition_wait(&b->changed, &b->lock);
            continue;
        }
        mine = b->jobs.items[--b->jobs.count];
        b->at_work++;
        mutex_unlock(&b->lock);
        done = grow(h, &mine);
        mutex_lock(&b->lock);
        b->at_work--;
        b->failed = b->failed || !done;
        condition_wake_all(&b->changed);
    }
    mutex_unlock(&b->lock);
}

static void name_part(void *user, uint32_t part, int unused)
{
    const builder *b = user;
    uint32_t begin = share_begin(b->in->count, PARTS, part), end = share_begin(b->in->count, PARTS, part + 1), i;

    (void)unused;
    for (i = begin; i < end; i++) {
        b->refs[i].id = b->in->ids[i];
        b->refs[i].unused = 0;
    }
    bvh_frame_convert(b->frame, b->in, b->refs, begin, end);
}

/* The draft of the whole tree. */
static bool grow_all(builder *b, bvh_draft_child *root, hand *hands)
{
    bvh_frame *frame = arena_alloc(&hands[0].memory, sizeof *frame, 8);
    job all;
    bool done;

    if (!frame)
        return false;
    *frame = bvh_frame_around(&b->in->bounds);
    b->frame = root->frame = frame;
    root->count = b->in->count;
    memset(&all, 0, sizeof all);
    all.child = root;
    all.scale = frame->scale;
    all.range.end = b->in->count;
    share_work(b->threads, PARTS, name_part, b);
    bvh_range_measure(&all.range, b->refs, b->threads);
    all.range.is_leaf = is_leaf(b, &all.range);
    if (all.range.is_leaf)
        return true;
    done = grow_node(&hands[0], &all);
    if (done && b->threads > 1) {
        share_work(b->threads, (uint32_t)b->threads, work, hands);
        done = !b->failed;
    }
    return done;
}

static bool draft_and_lay_out(bvh *out, builder *b, bvh_leaf **leaves)
{
    int n = b->threads, i;
    hand *hands = env_alloc(b->in->env, (size_t)n, sizeof *hands);
    bvh_draft_child root;
    bool done;

    if (!hands)
        return false;
    memset(&root, 0, sizeof root);
    for (i = 0; i < n; i++) {
        hands[i].builder = b;
        arena_init(&hands[i].memory, b->in->env);
    }
    done = grow_all(b, &root, hands);
    if (done && b->in->drop)
        b->in->drop(b->in->box_user);
    done = done && bvh_layout(out, b->in, &root, b->refs, leaves);
    for (i = 0; i < n; i++)
        arena_free(&hands[i].memory);
    env_free(b->in->env, hands);
    return done;
}

/* The nodes and the order of the leaves; what served to find them is given back. */
static bool build_nodes(bvh *out, const bvh_input *in, bvh_leaf **leaves)
{
    builder b;
    bool done = false;

    memset(&b, 0, sizeof b);
    b.in = in;
    b.threads = in->count < THREADS_FROM ? 1 : in->threads;
    b.refs = env_reserve_aligned(in->env, in->count * sizeof *b.refs, 64);
    if (b.refs && mutex_init(&b.lock)) {
        if (condition_init(&b.changed)) {
            done = draft_and_lay_out(out, &b, leaves);
            condition_destroy(&b.changed);
        }
        mutex_destroy(&b.lock);
    }
    env_free(in->env, b.jobs.items);
    env_free_aligned(in->env, b.refs);
    return done;
}

bool bvh_build(bvh *out, const bvh_input *in)
{
    bvh_leaf *leaves = NULL;
    bool done;

    memset(out, 0, sizeof *out);
    done = build_nodes(out, in, &leaves) && bvh_place_leaves(out, in, &leaves);
    env_free(in->env, leaves);
    if (!done)
        bvh_free(out, in->env);
    return done;
}
