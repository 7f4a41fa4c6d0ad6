#include "world/bvh_build.h"

#include <string.h>

typedef struct layout {
    bvh *out;
    const bvh_input *in;
    bvh_ref *refs;
    size_t nodes, frames, leaf_bytes;   /* given out so far */
} layout;

/* ---- how much there is ---- */

static uint32_t leaf_ids(const layout *l, const bvh_range *r, uint32_t ids[BVH_WIDTH])
{
    uint32_t i, n = bvh_range_count(r);

    for (i = 0; i < n; i++)
        ids[i] = l->refs[r->begin + i].id;
    return n;
}

static void count(layout *l, const bvh_draft_child *c, int depth)
{
    const bvh_leaves *leaves = &l->in->leaves;
    uint32_t ids[BVH_WIDTH], n;
    size_t bytes;
    int i;

    l->out->frame_count += c->frame != NULL;
    if (depth > l->out->depth)
        l->out->depth = depth;
    if (!c->node) {
        n = leaf_ids(l, &c->range, ids);
        bytes = leaves->size(leaves->user, ids, n);
        l->out->leaf_bytes += (bytes + BVH_UNIT - 1) / BVH_UNIT * BVH_UNIT;
        l->out->leaf_count++;
        return;
    }
    l->out->node_count++;
    for (i = 0; i < c->node->count; i++)
        count(l, &c->node->child[i], depth + 1);
}

/* ---- putting it down ---- */

static uint32_t put_leaf(layout *l, const bvh_range *r)
{
    const bvh_leaves *leaves = &l->in->leaves;
    uint32_t ids[BVH_WIDTH], n = leaf_ids(l, r, ids);
    size_t at = l->leaf_bytes, bytes = leaves->size(leaves->user, ids, n);

    leaves->fill(leaves->user, ids, n, l->out->leaves + at);
    l->leaf_bytes += (bytes + BVH_UNIT - 1) / BVH_UNIT * BVH_UNIT;
    return BVH_LEAF | (uint32_t)(at / BVH_UNIT);
}

static uint32_t put(layout *l, const bvh_draft_child *c);

static void set_place(bvh_node *node, int i, const float *lo, const float *hi)
{
    int k;

    for (k = 0; k < 3; k++) {
        node->bounds[2 * k][i] = lo[k];
        node->bounds[2 * k + 1][i] = hi[k];
    }
}

static uint32_t put_node(layout *l, const bvh_draft_node *draft)
{
    static const float never_lo[3] = { HUGE_VALF, HUGE_VALF, HUGE_VALF };
    static const float never_hi[3] = { -HUGE_VALF, -HUGE_VALF, -HUGE_VALF };
    uint32_t index = (uint32_t)l->nodes++;
    bvh_node *node = &l->out->nodes[index];
    int i;

    for (i = 0; i < BVH_WIDTH; i++)
        set_place(node, i, never_lo, never_hi);
    for (i = 0; i < draft->count; i++) {
        const bvh_draft_child *c = &draft->child[i];
        set_place(node, i, c->lo, c->hi);
        node->child[i] = put(l, c);
    }
    return BVH_NODE | index;
}

static uint32_t put(layout *l, const bvh_draft_child *c)
{
    bvh_frame *frame = NULL;
    uint32_t index = 0, reference;

    if (c->frame) {
        index = (uint32_t)l->frames++;
        frame = &l->out->frames[index];
        *frame = *c->frame;
    }
    reference = c->node ? put_node(l, c->node) : put_leaf(l, &c->range);
    if (!frame)
        return reference;
    frame->root = reference;
    return BVH_FRAME | index;
}

static bool allocate(bvh *b, const env *e)
{
    const size_t most = ~BVH_KIND;

    if (b->node_count > most || b->frame_count > most || b->leaf_bytes / BVH_UNIT > most)
        return false;
    b->nodes = env_alloc_aligned(e, b->node_count * sizeof *b->nodes, BVH_UNIT);
    b->frames = env_alloc(e, b->frame_count, sizeof *b->frames);
    b->leaves = env_alloc_aligned(e, b->leaf_bytes, BVH_UNIT);
    return b->nodes && b->frames && b->leaves;
}

bool bvh_layout(bvh *out, const bvh_input *in, const bvh_draft_child *root, bvh_ref *refs)
{
    layout l = { out, in, refs, 0, 0, 0 };

    count(&l, root, 0);
    if (!allocate(out, in->env)) {
        bvh_free(out, in->env);
        return false;
    }
    put(&l, root);
    return true;
}

void bvh_free(bvh *b, const env *e)
{
    env_free_aligned(e, b->nodes);
    env_free(e, b->frames);
    env_free_aligned(e, b->leaves);
    memset(b, 0, sizeof *b);
}
