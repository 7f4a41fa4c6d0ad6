/* bvh_walk_body.h - the walk itself, included by bvh_walk.c once for each instruction set, with WALK_TARGET (the
 * function attribute), WALK_MEET (the node test) and WALK_NAME (what makes names differ). No guard, for that reason. */

/* Put the met children on the stack, the nearest on top, and say how high it is now. */
WALK_TARGET static inline uint32_t WALK_NAME(push)(const bvh_node *node, uint32_t mask, const float *entry, bool sorted,
                                                   uint64_t *stack, uint32_t top)
{
    uint32_t base = top;

    for (; mask; mask &= mask - 1) {
        uint32_t i = first_of(mask), at = top++;
        uint64_t key = key_of(entry[i], node->child[i]);
        if (sorted)
            for (; at > base && stack[at - 1] < key; at--)
                stack[at] = stack[at - 1];
        stack[at] = key;
    }
    return top;
}

/* Change into a frame, leaving behind a way back. */
WALK_TARGET static inline bool WALK_NAME(change)(const bvh_walk *w, uint32_t to, uint32_t *frame, bvh_slabs *s,
                                                 uint64_t *stack, uint32_t *top)
{
    bvh_slabs inner;

    if (!bvh_enter(&w->tree->frames[to], w->ray, w->limit, &inner))
        return false;
    stack[(*top)++] = key_of(0.0f, BVH_RETURN | *frame);
    *frame = to;
    *s = inner;
    return true;
}

WALK_TARGET static inline bool WALK_NAME(walk)(bvh_walk *w, bool sorted)
{
    uint64_t stack[BVH_STACK];
    float entry[BVH_WIDTH];
    bvh_slabs s;
    uint32_t top = 0, frame = 0, at = w->tree->frames[0].root, mask;

    if (!bvh_enter(&w->tree->frames[0], w->ray, w->limit, &s))
        return false;
    for (;;) {
        switch (at & BVH_KIND) {
        case BVH_NODE:
            mask = WALK_MEET(&w->tree->nodes[at], &s, entry);
            if (mask && !(mask & (mask - 1))) {
                at = w->tree->nodes[at].child[first_of(mask)];
                continue;
            }
            top = WALK_NAME(push)(&w->tree->nodes[at], mask, entry, sorted, stack, top);
            break;
        case BVH_LEAF: {
            double before = w->limit;
            if (w->leaf(w, w->tree->leaves + (size_t)(at & ~BVH_KIND) * BVH_UNIT))
                return true;
            if (w->limit < before)
                bvh_set_limit(&s, w->limit);
            break;
        }
        case BVH_FRAME:
            if (WALK_NAME(change)(w, at & ~BVH_KIND, &frame, &s, stack, &top)) {
                at = w->tree->frames[frame].root;
                continue;
            }
            break;
        case BVH_RETURN:
            /* It was entered before, so that it is not passed by now. */
            frame = at & ~BVH_KIND;
            bvh_enter(&w->tree->frames[frame], w->ray, w->limit, &s);
            break;
        }
        do {
            if (top == 0)
                return false;
            top--;
        } while (entry_of(stack[top]) > s.limit);
        at = (uint32_t)stack[top];
    }
}

WALK_TARGET static bool WALK_NAME(nearest_first)(bvh_walk *w)
{
    return WALK_NAME(walk)(w, true);
}

WALK_TARGET static bool WALK_NAME(any_order)(bvh_walk *w)
{
    return WALK_NAME(walk)(w, false);
}
