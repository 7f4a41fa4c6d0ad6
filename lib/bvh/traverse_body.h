/* traverse_body.h - the traversal of one ray, included by traverse.c once for each instruction set, with
 * TRAVERSE_TARGET (the function attribute), TRAVERSE_LANES (a ray as the node test needs it), TRAVERSE_SPREAD (makes
 * it), TRAVERSE_LIMIT (lowers its limit), TRAVERSE_HIT (the node test) and TRAVERSE_NAME (the suffix of names). No
 * guard, for that reason. */

/* Descend from the node at `at` to the nearest leaf, return or frame below it, or to nothing (then: the top of the
 * stack). */
TRAVERSE_TARGET static inline bool TRAVERSE_NAME(descend)(const bvh_node *nodes, const TRAVERSE_LANES *ray, bool sorted,
                                                  uint32_t *at, uint64_t *stack, uint32_t *top)
{
    float entry[BVH_WIDTH];

    while ((*at & BVH_KIND) == BVH_NODE) {
        const bvh_node *node = &nodes[*at];
        uint32_t mask = TRAVERSE_HIT(node, ray, entry);
        if (!mask)
            return false;
        if (!sorted) {
            *at = push_any(node, mask, stack, top);
        } else if (mask & (mask - 1)) {
            *top = push(node, mask, entry, stack, *top);
            *at = (uint32_t)stack[--*top];
        } else {
            *at = node->child[first_of(mask)];
        }
    }
    return true;
}

/* Set up the lane's ray in a frame. False: it misses. */
TRAVERSE_TARGET static inline bool TRAVERSE_NAME(enter)(bvh_traversal *of, uint32_t lane, uint32_t frame,
                                                        bvh_local *local, TRAVERSE_LANES *spread, float *limit)
{
    const bvh_frame *in = &of->tree->frames[frame];
    bvh_local l;

    if (!bvh_enter(in, bvh_ray(of, lane), of->length[lane], of->soa.per_length[lane], &l))
        return false;
    *limit = bvh_limit(l.scale, l.shift, of->limit[lane]);
    TRAVERSE_SPREAD(&l, *limit, spread);
    bvh_to_frame(&of->soa, lane, &l, *limit);
    of->in = in;
    *local = l;
    return true;
}

TRAVERSE_TARGET static inline bool TRAVERSE_NAME(traverse)(bvh_traversal *of, uint32_t lane, uint32_t frame,
                                                           uint32_t at, bool sorted)
{
    const bvh *t = of->tree;
    uint64_t stack[BVH_STACK];
    uint32_t top = 0;
    TRAVERSE_LANES spread;
    bvh_local local;
    float limit;

    if (!TRAVERSE_NAME(enter)(of, lane, frame, &local, &spread, &limit))
        return false;
    for (;;) {
        if (TRAVERSE_NAME(descend)(t->nodes, &spread, sorted, &at, stack, &top)) {
            const uint32_t index = at & ~BVH_KIND;

            if ((at & BVH_KIND) == BVH_LEAF) {
                const double before = of->limit[lane];

                if (of->leaf(of, t->leaves + (size_t)index * BVH_UNIT, (uint64_t)1 << lane))
                    return true;
                if (of->limit[lane] < before) {
                    limit = bvh_limit(local.scale, local.shift, of->limit[lane]);
                    TRAVERSE_LIMIT(&spread, limit);
                    of->soa.local.smax[lane] = limit;
                }
            } else if ((at & BVH_KIND) == BVH_RETURN) {
                /* The ray entered this frame before, so it does not miss it now. */
                TRAVERSE_NAME(enter)(of, lane, index, &local, &spread, &limit);
                frame = index;
            } else if (TRAVERSE_NAME(enter)(of, lane, index, &local, &spread, &limit)) {
                stack[top++] = BVH_RETURN | frame;
                frame = index;
                at = t->frames[index].root;
                continue;
            }
        }
        do {
            if (top == 0)
                return false;
            top--;
        } while (sorted && entry_of(stack[top]) > limit);
        at = (uint32_t)stack[top];
    }
}

TRAVERSE_TARGET static inline uint64_t TRAVERSE_NAME(traverse_each)(bvh_traversal *of, bool sorted)
{
    const uint32_t root = of->tree->frames[0].root;
    uint64_t ended = 0, rest;

    for (rest = of->lanes; rest; rest &= rest - 1) {
        const uint32_t lane = first_of64(rest);

        ended |= (uint64_t)TRAVERSE_NAME(traverse)(of, lane, 0, root, sorted) << lane;
    }
    return ended;
}

TRAVERSE_TARGET static uint64_t TRAVERSE_NAME(nearest_single)(bvh_traversal *of)
{
    return TRAVERSE_NAME(traverse_each)(of, true);
}

TRAVERSE_TARGET static uint64_t TRAVERSE_NAME(any_single)(bvh_traversal *of)
{
    return TRAVERSE_NAME(traverse_each)(of, false);
}
