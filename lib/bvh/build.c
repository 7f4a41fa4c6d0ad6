#include "bvh/build.h"

#include "base/share.h"
#include "base/thread.h"
#include "base/vec.h"

#include <string.h>

/* From this depth on ranges are halved by count, so that log8(2^32) < 12 more steps end the tree: BVH_DEPTH is
 * enough. */
enum { HALVE_FROM = 40 };
/* A part of a frame gets a frame of its own if it is at most 2^-10 of it and holds enough objects to repay the change
 * of frames. */
static const float frame_fraction = 0x1p-10f;
enum { FRAME_LEAST = 16 };
/* Ranges of fewer objects than this are not worth a thread's work. */
enum { JOB_LEAST = 4096, THREADS_FROM = 20000, SLICES = 64 };

/* A subtree to build, possibly by another thread. */
typedef struct job {
    bvh_draft_child *child;
    bvh_range range;             /* in its own frame if it has one */
    double scale;                /* of that frame */
    int depth;
    bool is_fine;                /* no finer frame is possible */
} job;

typedef struct builder {
    const bvh_input *in;
    int threads;
    bvh_ref *refs;
    const bvh_frame *frame;      /* the whole scene's */
    mutex lock;                  /* guards the members below, while threads work */
    condition changed;
    struct { job *items; size_t count, capacity; } jobs;
    int at_work;                 /* workers whose job may add others */
    bool failed;
} builder;

/* One thread of the build. */
typedef struct worker {
    builder *builder;
    arena memory;
} worker;

/* A leaf is one object, or the objects of one block. Leaves with two blocks, or with several objects that share none,
 * were measured to cost more than nodes that separate them. */
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
    return b->in->shares_leaf[group];
}

/* threads: idle threads that may help. */
static void cut(const builder *b, const bvh_range *r, bool halve, int threads, bvh_range *x, bvh_range *y)
{
    bvh_range whole = *r;

    if (halve)
        bvh_halve(&whole, b->refs, x, y);
    else
        bvh_split(&whole, b->refs, threads, x, y);
    x->is_leaf = is_leaf(b, x);
    y->is_leaf = is_leaf(b, y);
}

/* Index of the next range to split: the one with the largest surface, or at great depth the one with most objects; -1:
 * none. */
static int next_to_cut(const bvh_range *slices, int n, bool halve)
{
    float most = -1.0f;
    int i, best = -1;

    for (i = 0; i < n; i++) {
        float size = halve ? (float)bvh_range_count(&slices[i]) : slices[i].area;
        if (!slices[i].is_leaf && size > most) {
            most = size;
            best = i;
        }
    }
    return best;
}

static bool grow_child(worker *h, const job *j);

/* Allocate a node; its children are set later. */
static bvh_draft_node *make_node(worker *h, const job *j, int n)
{
    bvh_draft_node *node = arena_alloc(&h->memory, sizeof *node + (size_t)n * sizeof *node->child, 8);

    if (node)
        node->count = n;
    j->child->node = node;
    return node;
}

/* Set one of its children, and return the job of building it. */
static job set_child(const job *above, bvh_draft_child *c, const bvh_range *r)
{
    const job below = { c, *r, above->scale, above->depth + 1, above->is_fine };

    memcpy(c->lo, r->lo, sizeof c->lo);
    memcpy(c->hi, r->hi, sizeof c->hi);
    c->begin = r->begin;
    c->count = bvh_range_count(r);
    return below;
}

/* Turn a range into a node. */
static bool grow_node(worker *h, const job *j)
{
    bvh_range slices[BVH_WIDTH];
    bool halve = j->depth >= HALVE_FROM;
    int n = 1, best, i, threads = j->depth == 0 ? h->builder->threads : 1;
    bvh_draft_node *node;

    slices[0] = j->range;
    while (n < BVH_WIDTH && (best = next_to_cut(slices, n, halve)) >= 0) {
        cut(h->builder, &slices[best], halve, threads, &slices[best], &slices[n]);
        n++;
    }
    node = make_node(h, j, n);
    for (i = 0; node && i < n; i++) {
        const job below = set_child(j, &node->child[i], &slices[i]);
        if (!grow_child(h, &below))
            return false;
    }
    return node != NULL;
}

static bool wants_frame(const job *j, const bvh_range *r)
{
    int k;

    if (j->is_fine)
        return false;
    for (k = 0; k < 3; k++)
        if (r->hi[k] - r->lo[k] > frame_fraction)
            return false;
    return bvh_range_count(r) >= FRAME_LEAST && j->depth < HALVE_FROM;
}

/* A frame finer than a few rounding errors of world coordinates gains nothing, and is not made. */
static bool set_frame(worker *h, job *j)
{
    const bvh_input *in = h->builder->in;
    bvh_range *r = &j->range;
    pov_box all = bvh_box_around(in, h->builder->refs, r->begin, r->end);
    bvh_frame frame = bvh_frame_around(&all);

    j->is_fine = frame.scale * (double)frame_fraction < 0.25 * j->scale;
    if (j->is_fine)
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

static bool grow(worker *h, const job *j);

/* Split a range recursively in two, down to leaves and to ranges that need a frame of their own. Returns the number of
 * build nodes. */
static uint32_t grow_nodes(const builder *b, const job *j, bvh_build_node *nodes)
{
    uint32_t count = 1, i;

    nodes[0].range = j->range;
    nodes[0].depth = j->depth;
    for (i = 0; i < count; i++) {
        bvh_build_node *t = &nodes[i];

        t->is_end = t->range.is_leaf || (i > 0 && wants_frame(j, &t->range));
        if (t->is_end)
            continue;
        t->half[0] = count;
        t->half[1] = count + 1;
        cut(b, &t->range, t->depth >= HALVE_FROM, 1, &nodes[count].range, &nodes[count + 1].range);
        nodes[count].depth = nodes[count + 1].depth = t->depth + 1;
        count += 2;
    }
    return count;
}

/* Collapse a build node and its descendants into wide nodes. */
static bool collapse(worker *h, const job *j, const bvh_build_node *nodes, uint32_t which)
{
    uint32_t children[BVH_WIDTH];
    const int n = bvh_children_of(nodes, which, children);
    bvh_draft_node *node = make_node(h, j, n);
    int i;

    for (i = 0; node && i < n; i++) {
        const bvh_build_node *t = &nodes[children[i]];
        const job below = set_child(j, &node->child[i], &t->range);

        if (!(t->is_end ? t->range.is_leaf || grow(h, &below) : collapse(h, &below, nodes, children[i])))
            return false;
    }
    return node != NULL;
}

/* Build the nodes of a range with the least surface area cost. */
static bool grow_small(worker *h, const job *j)
{
    const env *e = h->builder->in->env;
    bvh_build_node *nodes = env_resize(e, NULL, 2 * (size_t)bvh_range_count(&j->range), sizeof *nodes);
    bool done = false;

    if (nodes) {
        bvh_weigh_nodes(nodes, grow_nodes(h->builder, j, nodes));
        done = collapse(h, j, nodes, 0);
    }
    env_free(e, nodes);
    return done;
}

static bool grow(worker *h, const job *j)
{
    job own = *j;

    if (wants_frame(&own, &own.range) && !set_frame(h, &own))
        return false;
    if (bvh_range_count(&own.range) < JOB_LEAST && own.depth < HALVE_FROM)
        return grow_small(h, &own);
    return grow_node(h, &own);
}

/* ---- by several threads ---- */

static bool leave_to_others(worker *h, const job *j)
{
    builder *b = h->builder;
    bool done;

    mutex_lock(&b->lock);
    done = VEC_PUSH(b->in->env, &b->jobs, *j);
    condition_wake_all(&b->changed);
    mutex_unlock(&b->lock);
    return done;
}

static bool grow_child(worker *h, const job *j)
{
    if (j->range.is_leaf)
        return true;
    if (h->builder->threads > 1 && bvh_range_count(&j->range) >= JOB_LEAST)
        return leave_to_others(h, j);
    return grow(h, j);
}

/* Take jobs until there are none and no running job can add one. */
static void work(void *user, uint32_t which, int unused)
{
    worker *h = (worker *)user + which;
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

static void name_slice(void *user, uint32_t slice, int unused)
{
    const builder *b = user;
    uint32_t begin = share_begin(b->in->count, SLICES, slice), end = share_begin(b->in->count, SLICES, slice + 1), i;

    (void)unused;
    for (i = begin; i < end; i++) {
        const uint32_t id = b->in->ids[i];

        b->refs[i].id = id;
        b->refs[i].slots = b->in->shares_leaf[b->in->group[id]] ? 1 : BVH_WIDTH;
    }
    bvh_frame_convert(b->frame, b->in, b->refs, begin, end);
}

/* A node of one leaf. */
static bool bound_leaf(worker *h, const job *j)
{
    bvh_draft_node *node = make_node(h, j, 1);

    if (node)
        set_child(j, &node->child[0], &j->range);
    return node != NULL;
}

/* Build the draft of the whole tree. */
static bool grow_all(builder *b, bvh_draft_child *root, worker *workers)
{
    bvh_frame *frame = arena_alloc(&workers[0].memory, sizeof *frame, 8);
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
    share_work(b->threads, SLICES, name_slice, b);
    bvh_range_measure(&all.range, b->refs, b->threads);
    all.range.is_leaf = is_leaf(b, &all.range);
    if (all.range.is_leaf)
        return !b->in->bounds_leaf || bound_leaf(&workers[0], &all);
    done = grow(&workers[0], &all);
    if (done && b->threads > 1) {
        share_work(b->threads, (uint32_t)b->threads, work, workers);
        done = !b->failed;
    }
    return done;
}

/* The boxes have an order now, which is all that is needed of them. */
static void keep_slice(void *user, uint32_t slice, int unused)
{
    const builder *b = user;
    const uint32_t end = share_begin(b->in->count, SLICES, slice + 1);

    (void)unused;
    for (uint32_t i = share_begin(b->in->count, SLICES, slice); i < end; i++)
        b->in->ids[i] = b->refs[i].id;
}

static bool draft_and_lay_out(bvh *out, builder *b, bvh_leaf **leaves)
{
    int n = b->threads, i;
    worker *workers = env_alloc(b->in->env, (size_t)n, sizeof *workers);
    bvh_draft_child root;
    bool done;

    if (!workers)
        return false;
    memset(&root, 0, sizeof root);
    for (i = 0; i < n; i++) {
        workers[i].builder = b;
        arena_init(&workers[i].memory, b->in->env);
    }
    done = grow_all(b, &root, workers);
    if (done && b->in->drop)
        b->in->drop(b->in->box_user);
    if (done)
        share_work(b->threads, SLICES, keep_slice, b);
    env_free_aligned(b->in->env, b->refs);   /* the largest part of the memory of a build */
    b->refs = NULL;
    done = done && bvh_layout(out, b->in, &root, leaves);
    for (i = 0; i < n; i++)
        arena_free(&workers[i].memory);
    env_free(b->in->env, workers);
    return done;
}

/* Build the nodes and the order of the leaves; working memory is freed. */
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
    done = build_nodes(out, in, &leaves) && bvh_fill_leaves(out, in, &leaves);
    env_free(in->env, leaves);
    if (!done)
        bvh_free(out, in->env);
    return done;
}
