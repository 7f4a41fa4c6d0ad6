#include "world/bvh_build.h"

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
enum { JOB_LEAST = 4096, THREADS_FROM = 20000, THREADS_MAX = 64 };

/* A part of the tree that is left for whoever comes first. */
typedef struct job { bvh_draft_child *child; int depth; } job;

typedef struct builder {
    const bvh_input *in;
    bvh_ref *refs;
    struct { job *items; size_t count, capacity; } jobs;
    mutex lock;                  /* guards next */
    size_t next;
} builder;

/* One thread's part in it. */
typedef struct hand {
    builder *builder;
    arena memory;
    uint32_t job_below;          /* smaller parts become jobs; 0: none do */
    bool failed;
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

static void cut(const builder *b, const bvh_range *r, bool halve, bvh_range *x, bvh_range *y)
{
    bvh_range whole = *r;

    if (halve)
        bvh_halve(&whole, b->refs, x, y);
    else
        bvh_split(&whole, b->refs, b->in->all_pack, x, y);
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

static bool grow(hand *h, bvh_draft_child *child, int depth);

/* The things of child->range become a node below it. */
static bool grow_node(hand *h, bvh_draft_child *child, int depth)
{
    bvh_range parts[BVH_WIDTH];
    bvh_draft_node *node = arena_alloc(&h->memory, sizeof *node, 16);
    bool halve = depth >= HALVE_FROM;
    uint32_t part = part_of(h->builder, bvh_range_count(&child->range));
    int n = 1, i, best;

    if (!node)
        return false;
    parts[0] = child->range;
    while (n < BVH_WIDTH && (best = next_to_cut(parts, n, part, halve)) >= 0) {
        cut(h->builder, &parts[best], halve, &parts[best], &parts[n]);
        n++;
    }
    child->node = node;
    node->count = n;
    for (i = 0; i < n; i++) {
        node->child[i].range = parts[i];
        node->child[i].scale = child->frame ? child->frame->scale : child->scale;
        memcpy(node->child[i].lo, parts[i].lo, sizeof parts[i].lo);
        memcpy(node->child[i].hi, parts[i].hi, sizeof parts[i].hi);
    }
    for (i = 0; i < n; i++)
        if (!grow(h, &node->child[i], depth + 1))
            return false;
    return true;
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
static bool set_frame(hand *h, bvh_draft_child *child)
{
    bvh_range *r = &child->range;
    const pov_box *boxes = h->builder->in->boxes;
    bvh_frame frame = bvh_frame_of(boxes, h->builder->refs, r->begin, r->end);

    if (frame.scale * (double)frame_part < 0.25 * child->scale)
        return true;
    child->frame = arena_alloc(&h->memory, sizeof frame, 16);
    if (!child->frame)
        return false;
    *child->frame = frame;
    bvh_frame_convert(&frame, boxes, h->builder->refs, r->begin, r->end);
    bvh_range_measure(r, h->builder->refs);
    return true;
}

static bool grow(hand *h, bvh_draft_child *child, int depth)
{
    uint32_t n = bvh_range_count(&child->range);

    if (child->range.is_leaf)
        return true;
    if (n < h->job_below) {
        job later = { child, depth };
        return VEC_PUSH(h->builder->in->env, &h->builder->jobs, later);
    }
    if (wants_frame(&child->range, depth) && !set_frame(h, child))
        return false;
    return grow_node(h, child, depth);
}

static void *work(void *user)
{
    hand *h = user;
    builder *b = h->builder;

    for (;;) {
        size_t mine;
        mutex_lock(&b->lock);
        mine = b->next < b->jobs.count ? b->next++ : b->jobs.count;
        mutex_unlock(&b->lock);
        if (mine == b->jobs.count)
            return NULL;
        if (!grow(h, b->jobs.items[mine].child, b->jobs.items[mine].depth)) {
            h->failed = true;
            return NULL;
        }
    }
}

/* All the jobs, by the calling thread and by as many others as start. */
static bool work_together(builder *b, hand *hands, int n)
{
    thread threads[THREADS_MAX];
    bool failed = false;
    int i, started = 0;

    if (!mutex_init(&b->lock))
        return false;
    for (i = 0; i < n; i++)
        hands[i].job_below = 0;
    while (started < n - 1 && thread_start(&threads[started], work, &hands[started + 1]))
        started++;
    work(&hands[0]);
    for (i = 0; i < started; i++)
        thread_join(threads[i]);
    for (i = 0; i < n; i++)
        failed = failed || hands[i].failed;
    mutex_destroy(&b->lock);
    return !failed;
}

static bool grow_all(builder *b, bvh_draft_child *root, hand *hands, int n)
{
    root->range.begin = 0;
    root->range.end = b->in->count;
    if (!set_frame(&hands[0], root))
        return false;
    root->range.is_leaf = is_leaf(b, &root->range);
    if (n > 1) {
        uint32_t part = b->in->count / 32;
        hands[0].job_below = part > JOB_LEAST ? part : JOB_LEAST;
    }
    if (!root->range.is_leaf && !grow_node(&hands[0], root, 0))
        return false;
    return n == 1 || work_together(b, hands, n);
}

static int thread_count(const bvh_input *in)
{
    int n = in->threads > 0 ? in->threads : thread_cores();

    if (in->count < THREADS_FROM)
        return 1;
    return n < THREADS_MAX ? n : THREADS_MAX;
}

bool bvh_build(bvh *out, const bvh_input *in)
{
    int n = thread_count(in), i;
    hand *hands = env_alloc(in->env, (size_t)n, sizeof *hands);
    bvh_draft_child root;
    builder b;
    uint32_t k;
    bool done = false;

    memset(out, 0, sizeof *out);
    memset(&b, 0, sizeof b);
    memset(&root, 0, sizeof root);
    b.in = in;
    b.refs = env_alloc(in->env, in->count, sizeof *b.refs);
    if (b.refs && hands) {
        for (i = 0; i < n; i++) {
            hands[i].builder = &b;
            arena_init(&hands[i].memory, in->env);
        }
        for (k = 0; k < in->count; k++)
            b.refs[k].id = in->ids[k];
        done = grow_all(&b, &root, hands, n) && bvh_layout(out, in, &root, b.refs);
        for (i = 0; i < n; i++)
            arena_free(&hands[i].memory);
    }
    env_free(in->env, b.jobs.items);
    env_free(in->env, b.refs);
    env_free(in->env, hands);
    return done;
}
