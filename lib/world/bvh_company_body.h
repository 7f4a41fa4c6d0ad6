/* bvh_company_body.h - the walk in company, included by bvh_company.c once for each instruction set, with
 * COMPANY_TARGET (the function attribute), COMPANY_NAME (what makes names differ), COMPANY_ALONE (the walks of
 * single rays), and the tests COMPANY_GROUP, COMPANY_ONE, COMPANY_LANES and COMPANY_WITHIN. No guard, for that reason. */

/* The bounds of one axis over all lanes. Lanes that take no part hold another's values. */
COMPANY_TARGET static inline void COMPANY_NAME(bound_axis)(company *c, int k)
{
    const float *inverse = c->inverse[k];
    const double *o = c->org[k];
    float lo[8], hi[8];
    double first[8], last[8];
    uint32_t i, j;

    for (j = 0; j < 8; j++) {
        lo[j] = hi[j] = inverse[j];
        first[j] = last[j] = o[j];
    }
    for (i = 8; i < c->width; i += 8)
        for (j = 0; j < 8; j++) {
            lo[j] = inverse[i + j] < lo[j] ? inverse[i + j] : lo[j];
            hi[j] = inverse[i + j] > hi[j] ? inverse[i + j] : hi[j];
            first[j] = o[i + j] < first[j] ? o[i + j] : first[j];
            last[j] = o[i + j] > last[j] ? o[i + j] : last[j];
        }
    for (j = 1; j < 8; j++) {
        lo[0] = lo[j] < lo[0] ? lo[j] : lo[0];
        hi[0] = hi[j] > hi[0] ? hi[j] : hi[0];
        first[0] = first[j] < first[0] ? first[j] : first[0];
        last[0] = last[j] > last[0] ? last[j] : last[0];
    }
    bound(c, k, lo[0], hi[0], first[0], last[0]);
}

COMPANY_TARGET static inline void COMPANY_NAME(spread)(company *c)
{
    uint32_t i;
    int k;

    for (k = 0; k < 3; k++) {
        for (i = 0; i < c->width; i++) {
            double d = c->dir[k][i], o = c->org[k][i], a = fabs(d);
            double inverse = 1.0 / copysign(a > BVH_LEAST ? a : BVH_LEAST, d);
            double slack = fabs(inverse) * (1.0 + fabs(o)) * BVH_SLACK;
            c->inverse[k][i] = (float)inverse;
            c->near_offset[k][i] = (float)(o * inverse + slack);
            c->far_offset[k][i] = (float)(o * inverse - slack);
        }
        COMPANY_NAME(bound_axis)(c, k);
    }
}

/* Lanes go on alone from a reference in the frame. */
static void COMPANY_NAME(leave)(company *c, uint64_t lanes, uint32_t at, bool sorted)
{
    for (; lanes; lanes &= lanes - 1) {
        uint32_t i = first_of64(lanes);
        bvh_walk *w = c->walks[i];

        w->frame = c->frame;
        w->at = at;
        if (sorted ? COMPANY_ALONE.nearest_first(w) : COMPANY_ALONE.any_order(w))
            end_lane(c, i);
        else
            lower_limit(c, i);
    }
}

/* Take lanes into a frame they have not been in; those that are told. Rays that need a walk's blind ways go on alone. */
COMPANY_TARGET static uint64_t COMPANY_NAME(enter)(company *c, uint32_t frame, uint64_t lanes, bool sorted)
{
    uint64_t blind, in = enter_lanes(c, frame, lanes, &blind);

    if (in)
        COMPANY_NAME(spread)(c);
    if (blind)
        COMPANY_NAME(leave)(c, blind, c->tree->frames[frame].root, sorted);
    return in;
}

COMPANY_TARGET static void COMPANY_NAME(come_back)(company *c, uint32_t frame)
{
    uint64_t blind;

    if (enter_lanes(c, frame, c->open, &blind))
        COMPANY_NAME(spread)(c);
}

/* Put the children that lanes meet on the stack, the nearest on top. */
COMPANY_TARGET static inline uint32_t COMPANY_NAME(push)(const company *c, const bvh_node *node, uint64_t lanes,
                                                         bool sorted, company_entry *stack, uint32_t top)
{
    float entry[BVH_WIDTH];
    bool alone = is_one(lanes);
    uint32_t mask = alone ? COMPANY_ONE(node, first_of64(lanes), c, entry) : COMPANY_GROUP(node, c, entry), base = top;

    for (; mask; mask &= mask - 1) {
        uint32_t i = first_of(mask), at = top;
        uint64_t meet = alone ? lanes : COMPANY_LANES(node, i, c, lanes), key = key_of(entry[i], node->child[i]);

        if (!meet)
            continue;
        top++;
        if (sorted)
            for (; at > base && stack[at - 1].key < key; at--)
                stack[at] = stack[at - 1];
        stack[at].key = key;
        stack[at].lanes = meet;
    }
    return top;
}

COMPANY_TARGET static inline uint64_t COMPANY_NAME(walk)(bvh_walk *const *walks, uint32_t n, bool sorted)
{
    company c;
    company_entry stack[BVH_STACK];
    uint64_t lanes;
    uint32_t top = 0, at = walks[0]->tree->frames[0].root;

    begin(&c, walks, n);
    lanes = COMPANY_NAME(enter)(&c, 0, c.open, sorted);
    if (!lanes)
        return c.ended;
    for (;;) {
        if ((at & BVH_KIND) == BVH_RETURN) {
            COMPANY_NAME(come_back)(&c, at & ~BVH_KIND);
        } else if ((at & BVH_KIND) == BVH_NODE) {
            top = COMPANY_NAME(push)(&c, &c.tree->nodes[at], lanes, sorted, stack, top);
        } else if ((at & BVH_KIND) == BVH_LEAF) {
            visit(&c, lanes, at & ~BVH_KIND);
        } else {
            stack[top].key = key_of(0.0f, BVH_RETURN | c.frame);
            stack[top++].lanes = ~(uint64_t)0;
            lanes = COMPANY_NAME(enter)(&c, at & ~BVH_KIND, lanes, sorted);
            at = c.tree->frames[at & ~BVH_KIND].root;
            if (lanes)
                continue;
        }
        do {
            if (top == 0 || !c.open)
                return c.ended;
            lanes = stack[--top].lanes & c.open;
            at = (uint32_t)stack[top].key;
            if (sorted && (at & BVH_KIND) != BVH_RETURN)
                lanes = COMPANY_WITHIN(&c, entry_of(stack[top].key), lanes);
        } while (!lanes);
    }
}

uint64_t COMPANY_NAME(bvh_company_nearest)(bvh_walk *const *walks, uint32_t n)
{
    return COMPANY_NAME(walk)(walks, n, true);
}

uint64_t COMPANY_NAME(bvh_company_any)(bvh_walk *const *walks, uint32_t n)
{
    return COMPANY_NAME(walk)(walks, n, false);
}
