/* bvh_company_body.h - the walk in company, included by bvh_company.c once for each instruction set, with
 * COMPANY_TARGET (the function attribute), COMPANY_NAME (what makes names differ), and the tests COMPANY_GROUP,
 * COMPANY_ONE, COMPANY_LANES and COMPANY_WITHIN. No guard, for that reason. */

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

/* All rays in the frame. False: some start too far from it, or are too long or short, to be taken so simply. */
COMPANY_TARGET static inline bool COMPANY_NAME(place)(company *c, const bvh_frame *f)
{
    const pov_rays *rays = &c->party->side;
    const double centre[3] = { f->centre.x, f->centre.y, f->centre.z };
    double most[8] = { 0.0 }, shortest[8], longest[8] = { 0.0 };
    uint32_t i, j;
    int k;

    for (k = 0; k < 3; k++)
        for (i = 0; i < c->width; i += 8)
            for (j = 0; j < 8; j++) {
                double o = (rays->org[k][i + j] - centre[k] + rays->org_lo[k][i + j]) * f->scale;
                c->org[k][i + j] = o;
                c->dir[k][i + j] = rays->dir[k][i + j];
                most[j] = fabs(o) > most[j] ? fabs(o) : most[j];
            }
    for (j = 0; j < 8; j++)
        shortest[j] = HUGE_VAL;
    for (i = 0; i < c->width; i += 8)
        for (j = 0; j < 8; j++) {
            double x = fabs(rays->dir[0][i + j]), y = fabs(rays->dir[1][i + j]), z = fabs(rays->dir[2][i + j]);
            x = y > x ? y : x;
            x = z > x ? z : x;
            shortest[j] = x < shortest[j] ? x : shortest[j];
            longest[j] = x > longest[j] ? x : longest[j];
            c->scale[i + j] = f->scale;
            c->shift[i + j] = 0.0;
            c->limit[i + j] = bvh_limit(f->scale, 0.0, c->party->limit[i + j]);
        }
    for (j = 1; j < 8; j++) {
        most[0] = most[j] > most[0] ? most[j] : most[0];
        shortest[0] = shortest[j] < shortest[0] ? shortest[j] : shortest[0];
        longest[0] = longest[j] > longest[0] ? longest[j] : longest[0];
    }
    return most[0] <= BVH_NEAR && shortest[0] > BVH_SHORT && longest[0] < BVH_LONG;
}

/* Lanes go on alone from a reference in the frame. */
static void COMPANY_NAME(leave)(company *c, uint64_t lanes, uint32_t at)
{
    for (; lanes; lanes &= lanes - 1) {
        uint32_t i = first_of64(lanes);

        if (c->party->alone(c->party, i, c->frame, at))
            end_lanes(c, (uint64_t)1 << i);
    }
    lower_limits(c);
}

/* Take lanes into a frame; those that are in it are told. Rays that need a walk's blind ways are named. */
COMPANY_TARGET static uint64_t COMPANY_NAME(enter_lanes)(company *c, uint32_t frame, uint64_t lanes, uint64_t *blind)
{
    *blind = 0;
    c->frame = frame;
    if (!COMPANY_NAME(place)(c, &c->tree->frames[frame]))
        lanes = enter_each(c, frame, lanes, blind);
    else if (lanes != ~(uint64_t)0 >> (BVH_COMPANY - c->party->count))
        fill_others(c, lanes);
    if (lanes)
        COMPANY_NAME(spread)(c);
    return lanes;
}

/* Into a frame that they have not been in. */
COMPANY_TARGET static uint64_t COMPANY_NAME(enter)(company *c, uint32_t frame, uint64_t lanes)
{
    uint64_t blind, in = COMPANY_NAME(enter_lanes)(c, frame, lanes, &blind);

    if (blind)
        COMPANY_NAME(leave)(c, blind, c->tree->frames[frame].root);
    return in;
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

COMPANY_TARGET static inline uint64_t COMPANY_NAME(walk)(bvh_party *party, bool sorted)
{
    company c;
    company_entry stack[BVH_STACK];
    uint64_t lanes, blind;
    uint32_t top = 0, at = party->tree->frames[0].root;

    begin(&c, party);
    lanes = COMPANY_NAME(enter)(&c, 0, c.open);
    if (!lanes)
        return c.ended;
    for (;;) {
        if ((at & BVH_KIND) == BVH_RETURN) {
            COMPANY_NAME(enter_lanes)(&c, at & ~BVH_KIND, c.open, &blind);
        } else if ((at & BVH_KIND) == BVH_NODE) {
            top = COMPANY_NAME(push)(&c, &c.tree->nodes[at], lanes, sorted, stack, top);
        } else if ((at & BVH_KIND) == BVH_LEAF) {
            visit(&c, lanes, at & ~BVH_KIND);
        } else {
            stack[top].key = key_of(0.0f, BVH_RETURN | c.frame);
            stack[top++].lanes = ~(uint64_t)0;
            lanes = COMPANY_NAME(enter)(&c, at & ~BVH_KIND, lanes);
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

uint64_t COMPANY_NAME(bvh_company_nearest)(bvh_party *party)
{
    return COMPANY_NAME(walk)(party, true);
}

uint64_t COMPANY_NAME(bvh_company_any)(bvh_party *party)
{
    return COMPANY_NAME(walk)(party, false);
}
