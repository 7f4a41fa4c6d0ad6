#include "bvh/build.h"

#include "base/pages.h"
#include "base/share.h"

#include <string.h>

/* ---- nodes ---- */

typedef struct layout {
    bvh *out;
    bvh_leaf *leaves;
    size_t nodes, frames, laid_leaves;     /* assigned so far */
} layout;

static void count(bvh *out, const bvh_draft_child *c, int depth)
{
    int i;

    out->frame_count += c->frame != NULL;
    if (depth > out->depth)
        out->depth = depth;
    if (!c->node) {
        out->leaf_count++;
        return;
    }
    out->node_count++;
    for (i = 0; i < c->node->count; i++)
        count(out, &c->node->child[i], depth + 1);
}

/* Leaves come in the order of their ranges. */
static uint32_t put_leaf(layout *l, const bvh_draft_child *c, uint32_t frame)
{
    const uint32_t index = (uint32_t)l->laid_leaves++;

    l->leaves[index].begin = c->begin;
    l->leaves[index].frame = frame;
    return BVH_LEAF | index;
}

/* Lay out a subtree within a frame. */
static uint32_t put(layout *l, const bvh_draft_child *c, uint32_t frame);

static void set_slot(bvh_node *node, int i, const float *lo, const float *hi)
{
    int k;

    for (k = 0; k < 3; k++) {
        node->bounds[2 * k][i] = lo[k];
        node->bounds[2 * k + 1][i] = hi[k];
    }
}

/* The children in the order of their ranges. */
static void sort_children(const bvh_draft_node *draft, int sorted[BVH_WIDTH])
{
    for (int i = 0; i < draft->count; i++) {
        int at = i;

        for (; at > 0 && draft->child[sorted[at - 1]].begin > draft->child[i].begin; at--)
            sorted[at] = sorted[at - 1];
        sorted[at] = i;
    }
}

static uint32_t put_node(layout *l, const bvh_draft_node *draft, uint32_t frame)
{
    static const float never_lo[3] = { HUGE_VALF, HUGE_VALF, HUGE_VALF };
    static const float never_hi[3] = { -HUGE_VALF, -HUGE_VALF, -HUGE_VALF };
    uint32_t index = (uint32_t)l->nodes++;
    bvh_node *node = &l->out->nodes[index];
    int sorted[BVH_WIDTH], i;

    sort_children(draft, sorted);
    for (i = 0; i < BVH_WIDTH; i++) {
        set_slot(node, i, never_lo, never_hi);
        node->child[i] = BVH_NODE;
    }
    for (i = 0; i < draft->count; i++) {
        const bvh_draft_child *c = &draft->child[sorted[i]];
        set_slot(node, sorted[i], c->lo, c->hi);
        node->child[sorted[i]] = put(l, c, frame);
    }
    return BVH_NODE | index;
}

static uint32_t put(layout *l, const bvh_draft_child *c, uint32_t frame)
{
    uint32_t reference;

    if (c->frame) {
        frame = (uint32_t)l->frames++;
        l->out->frames[frame] = *c->frame;
    }
    reference = c->node ? put_node(l, c->node, frame) : put_leaf(l, c, frame);
    if (!c->frame)
        return reference;
    l->out->frames[frame].root = reference;
    return BVH_FRAME | frame;
}

/* The first write to a page waits while the system clears it. All threads do that together, each on a large page of its
 * own: two threads at one page would both clear it. */
static void touch_slice(void *user, uint32_t slice, int worker)
{
    const bvh *b = user;
    size_t i = (slice * PAGES_LARGE + sizeof *b->nodes - 1) / sizeof *b->nodes;

    (void)worker;
    for (; i < b->node_count && i * sizeof *b->nodes < (slice + 1) * PAGES_LARGE; i++)
        b->nodes[i].child[0] = BVH_NODE;
}

bool bvh_layout(bvh *out, const bvh_input *in, const bvh_draft_child *root, bvh_leaf **leaves)
{
    const size_t most = ~BVH_KIND;
    layout l = { out, NULL, 0, 0, 0 };

    *leaves = NULL;
    count(out, root, 0);
    if (out->node_count > most || out->frame_count > most || out->leaf_count > most)
        return false;
    out->nodes = pages_reserve(in->env, out->node_count * sizeof *out->nodes);
    out->frames = env_alloc(in->env, out->frame_count, sizeof *out->frames);
    *leaves = l.leaves = env_resize(in->env, NULL, out->leaf_count + 1, sizeof *l.leaves);
    if (!out->nodes || !out->frames || !l.leaves)
        return false;
    share_work(in->threads, (uint32_t)(out->node_count * sizeof *out->nodes / PAGES_LARGE) + 1, touch_slice, out);
    put(&l, root, 0);
    l.leaves[out->leaf_count].begin = in->count;
    return true;
}

/* ---- leaves ---- */

/* Number of rounds in which slices are filled. */
enum { ROUNDS = 16, ROUND = BVH_SLICES / ROUNDS };

typedef struct leaf_work {
    const bvh *tree;
    const bvh_input *in;
    bvh_leaf *leaves;
    uint32_t first;              /* first slice of this round */
} leaf_work;

static void size_slice(void *user, uint32_t slice, int worker)
{
    const leaf_work *w = user;
    const bvh_leaves *ask = &w->in->leaves;
    const uint32_t n = (uint32_t)w->tree->leaf_count, last = share_begin(n, BVH_SLICES, slice + 1);
    uint32_t i;

    (void)worker;
    for (i = share_begin(n, BVH_SLICES, slice); i < last; i++) {
        bvh_leaf *leaf = &w->leaves[i];
        size_t bytes = ask->size(ask->user, slice, w->in->ids + leaf->begin, leaf[1].begin - leaf->begin,
                                 w->leaves[last].begin - leaf->begin);
        leaf->at = (uint32_t)((bytes + BVH_UNIT - 1) / BVH_UNIT);
    }
}

static void fill_slice(void *user, uint32_t which, int worker)
{
    const leaf_work *w = user;
    const bvh_leaves *ask = &w->in->leaves;
    uint32_t slice = w->first + which, n = (uint32_t)w->tree->leaf_count, i = share_begin(n, BVH_SLICES, slice);

    (void)worker;
    for (; i < share_begin(n, BVH_SLICES, slice + 1); i++) {
        const bvh_leaf *leaf = &w->leaves[i];
        ask->fill(ask->user, slice, &w->tree->frames[leaf->frame], w->in->ids + leaf->begin,
                  leaf[1].begin - leaf->begin, w->tree->leaves + (size_t)leaf->at * BVH_UNIT);
    }
}

/* From sizes to positions. False: too many for a reference. */
static bool add_up(bvh *out, bvh_leaf *leaves)
{
    size_t i, at = 0;

    for (i = 0; i < out->leaf_count; i++) {
        size_t units = leaves[i].at;
        leaves[i].at = (uint32_t)at;
        at += units;
        if (at > ~BVH_KIND)
            return false;
    }
    out->leaf_bytes = at * BVH_UNIT;
    return true;
}

/* Replace numbers of leaves in references by positions. */
static void point(uint32_t *reference, const bvh_leaf *leaves)
{
    if ((*reference & BVH_KIND) == BVH_LEAF)
        *reference = BVH_LEAF | leaves[*reference & ~BVH_KIND].at;
}

static void point_slice(void *user, uint32_t slice, int worker)
{
    const leaf_work *w = user;
    const uint32_t n = (uint32_t)w->tree->node_count;
    uint32_t i, k;

    (void)worker;
    for (i = share_begin(n, BVH_SLICES, slice); i < share_begin(n, BVH_SLICES, slice + 1); i++)
        for (k = 0; k < BVH_WIDTH; k++)
            point(&w->tree->nodes[i].child[k], w->leaves);
}

/* Slices are filled from the last to the first; the list is shortened by leaves that are filled. */
static void fill(leaf_work *w, bvh_leaf **leaves)
{
    const bvh_input *in = w->in;
    bvh_leaf *rest;

    for (w->first = BVH_SLICES; w->first > 0;) {
        w->first -= ROUND;
        share_work(in->threads, ROUND, fill_slice, w);
        in->leaves.filled(in->leaves.user, w->first);
        rest = env_resize(in->env, *leaves, share_begin((uint32_t)w->tree->leaf_count, BVH_SLICES, w->first) + 1u,
                          sizeof *rest);
        if (rest)
            *leaves = w->leaves = rest;
    }
}

bool bvh_fill_leaves(bvh *out, const bvh_input *in, bvh_leaf **leaves)
{
    leaf_work w = { out, in, *leaves, 0 };
    size_t i;

    share_work(in->threads, BVH_SLICES, size_slice, &w);
    if (!add_up(out, *leaves))
        return false;
    out->leaves = env_reserve_aligned(in->env, out->leaf_bytes, BVH_UNIT);
    if (!out->leaves || !in->leaves.allocate(in->leaves.user, out->leaves))
        return false;
    share_work(in->threads, BVH_SLICES, point_slice, &w);
    for (i = 0; i < out->frame_count; i++)
        point(&out->frames[i].root, *leaves);
    fill(&w, leaves);
    return true;
}

void bvh_free(bvh *b, const env *e)
{
    pages_free(e, b->nodes);
    env_free(e, b->frames);
    env_free_aligned(e, b->leaves);
    memset(b, 0, sizeof *b);
}
