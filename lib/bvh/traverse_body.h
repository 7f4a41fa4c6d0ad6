/* traverse_body.h - the walk itself, included by traverse.c once for each instruction set, with WALK_TARGET (the
 * function attribute), WALK_LANES (a ray as the node test wants it), WALK_SPREAD (makes it), WALK_LIMIT (lowers its
 * limit), WALK_MEET (the node test), WALK_ANY (to put children on the stack in any order) and WALK_NAME (what makes
 * names differ). No guard, for that reason. */

#ifndef WALK_PUSH
#define WALK_PUSH WALK_NAME(push)
/* Put the met children on the stack, the nearest on top, and say how high it is now. Exchanges sort the first four,
 * for they cost fewer wrongly guessed branches than a loop. */
WALK_TARGET static inline uint32_t WALK_NAME(push)(const bvh_node *node, uint32_t mask, const float *entry,
                                                   walk_stack *stack, uint32_t top)
{
    uint64_t a = take_key(node, &mask, entry), b = take_key(node, &mask, entry), c, d;
    uint32_t base = top, at;

    put_greater_first(&a, &b);
    if (!mask) {
        put_on(stack, top++, a);
        put_on(stack, top++, b);
        return top;
    }
    c = take_key(node, &mask, entry);
    put_greater_first(&b, &c);
    put_greater_first(&a, &b);
    if (!mask) {
        put_on(stack, top++, a);
        put_on(stack, top++, b);
        put_on(stack, top++, c);
        return top;
    }
    d = take_key(node, &mask, entry);
    put_greater_first(&c, &d);
    put_greater_first(&b, &c);
    put_greater_first(&a, &b);
    put_on(stack, top++, a);
    put_on(stack, top++, b);
    put_on(stack, top++, c);
    put_on(stack, top++, d);
    while (mask) {
        a = take_key(node, &mask, entry);
        for (at = top++; at > base && key_on(stack, at - 1) < a; at--)
            put_on(stack, at, key_on(stack, at - 1));
        put_on(stack, at, a);
    }
    return top;
}

#endif

/* The node at `at` and what is nearest below it, until that is no node, or nothing (then: the top of the stack). */
WALK_TARGET static inline bool WALK_NAME(descend)(const bvh_node *nodes, const WALK_LANES *ray, bool sorted,
                                                  uint32_t *at, walk_stack *stack, uint32_t *top)
{
    float entry[BVH_WIDTH];

    while ((*at & BVH_KIND) == BVH_NODE) {
        const bvh_node *node = &nodes[*at];
        uint32_t mask = WALK_MEET(node, ray, entry);
        if (!mask)
            return false;
        if (!sorted) {
            *at = WALK_ANY(node, mask, stack, top);
        } else if (mask & (mask - 1)) {
            *top = WALK_PUSH(node, mask, entry, stack, *top);
            *at = stack->at[--*top];
        } else {
            *at = node->child[first_of(mask)];
        }
    }
    return true;
}

/* Set up the ray in a frame. False: it passes by. */
WALK_TARGET static inline bool WALK_NAME(enter)(bvh_walk *w, uint32_t frame, bvh_local *local, WALK_LANES *lanes,
                                                float *limit)
{
    bvh_local l;

    if (!bvh_enter(&w->tree->frames[frame], w->ray, w->length, w->per_length, &l))
        return false;
    *limit = bvh_limit(l.scale, l.shift, w->limit);
    WALK_SPREAD(&l, *limit, lanes);
    if (w->framed)
        bvh_stand(w->framed, 0, &l, *limit);
    w->in = &w->tree->frames[frame];
    *local = l;
    return true;
}

WALK_TARGET static inline bool WALK_NAME(walk)(bvh_walk *w, bool sorted)
{
    const bvh *t = w->tree;
    walk_stack stack;
    uint32_t top = 0, frame = w->frame, at = w->at;
    WALK_LANES lanes;
    bvh_local local;
    float limit;
    double before;

    if (!WALK_NAME(enter)(w, frame, &local, &lanes, &limit))
        return false;
    for (;;) {
        if (WALK_NAME(descend)(t->nodes, &lanes, sorted, &at, &stack, &top)) {
            uint32_t index = at & ~BVH_KIND;
            if ((at & BVH_KIND) == BVH_LEAF) {
                before = w->limit;
                if (w->leaf(w, t->leaves + (size_t)index * BVH_UNIT))
                    return true;
                if (w->limit < before) {
                    limit = bvh_limit(local.scale, local.shift, w->limit);
                    WALK_LIMIT(&lanes, limit);
                    if (w->framed)
                        w->framed->framed.smax[0] = limit;
                }
            } else if ((at & BVH_KIND) == BVH_RETURN) {
                /* It was entered before, so that it is not passed by now. */
                WALK_NAME(enter)(w, index, &local, &lanes, &limit);
                frame = index;
            } else if (WALK_NAME(enter)(w, index, &local, &lanes, &limit)) {
                put_on(&stack, top++, BVH_RETURN | frame);
                frame = index;
                at = t->frames[index].root;
                continue;
            }
        }
        do {
            if (top == 0)
                return false;
            top--;
        } while (sorted && stack.entry[top] > limit);
        at = stack.at[top];
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
