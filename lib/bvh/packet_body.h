/* packet_body.h - the walk in company, included by packet.c once for each instruction set, with
 * COMPANY_TARGET (the function attribute), COMPANY_NAME (what makes names differ), COMPANY_BOUND_ALL (what all lanes
 * share), the tests COMPANY_GROUP, COMPANY_FEW, COMPANY_LANES and COMPANY_WITHIN, COMPANY_LOWER (of limits that leaves
 * lowered), and COMPANY_PUSH_FEW where there is a better one than what is here. No guard, for that reason. */

COMPANY_TARGET static inline void COMPANY_NAME(visit)(company *c, uint64_t lanes, uint32_t leaf)
{
    end_lanes(c, c->party->leaf(c->party, c->tree->leaves + (size_t)leaf * BVH_UNIT, lanes));
    COMPANY_LOWER(c);
}

/* One axis of all rays in the frame. */
COMPANY_TARGET static inline void COMPANY_NAME(place_axis)(company *c, double centre, double scale, int k)
{
    pov_rays *side = &c->party->side;
    const double *restrict org = side->org[k], *restrict org_lo = side->org_lo[k], *restrict dir = side->dir[k];
    const double *restrict per_length = side->per_length;
    float *restrict inverses = c->inverse[k], *restrict near = c->near_offset[k], *restrict far = c->far_offset[k];
    float *restrict org_out = side->framed.org[k], *restrict dir_out = side->framed.dir[k];
    const float least = (float)BVH_LEAST;
    const uint32_t width = c->width;
    uint32_t i;

    for (i = 0; i < width; i++) {
        const float o = (float)((org[i] - centre + org_lo[i]) * scale), d = (float)(dir[i] * per_length[i]);
        const float a = fabsf(d), inverse = 1.0f / copysignf(a > least ? a : least, d);
        const float slack = fabsf(inverse) * (1.0f + fabsf(o)) * COMPANY_SLACK;

        inverses[i] = inverse;
        near[i] = o * inverse + slack;
        far[i] = o * inverse - slack;
        org_out[i] = o;
        dir_out[i] = d;
    }
}

COMPANY_TARGET static inline void COMPANY_NAME(place_limits)(company *c, double scale)
{
    pov_rays *side = &c->party->side;
    const double *restrict lengths = c->party->length, *restrict per_length = side->per_length;
    const float *restrict x = side->framed.org[0], *restrict y = side->framed.org[1], *restrict z = side->framed.org[2];
    double *restrict scales = c->scale, *restrict shifts = side->framed.shift, *restrict units = side->framed.unit;
    float *restrict size = side->framed.size;
    const double back = 1.0 / scale;
    const uint32_t width = c->width;
    uint32_t i;

    for (i = 0; i < width; i++) {
        scales[i] = scale * lengths[i];
        shifts[i] = 0.0;
        units[i] = per_length[i] * back;
        size[i] = fabsf(x[i]) + fabsf(y[i]) + fabsf(z[i]);
    }
    c->least = HUGE_VALF;
    c->party->lowered = c->open; /* all limits are new here */
    COMPANY_LOWER(c);
}

/* All rays in the frame. False: they cannot be taken so simply. Their lengths are in the range of filters. */
COMPANY_TARGET static inline bool COMPANY_NAME(place)(company *c, const bvh_frame *f)
{
    COMPANY_NAME(place_axis)(c, f->centre.x, f->scale, 0);
    COMPANY_NAME(place_axis)(c, f->centre.y, f->scale, 1);
    COMPANY_NAME(place_axis)(c, f->centre.z, f->scale, 2);
    COMPANY_NAME(place_limits)(c, f->scale);
    COMPANY_BOUND_ALL(c);
    return c->near && f->scale > BVH_SMALL && f->scale < BVH_LARGE;
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
    const bool plain = COMPANY_NAME(place)(c, &c->tree->frames[frame]);

    *blind = 0;
    c->frame = frame;
    c->party->in = &c->tree->frames[frame];
    if (!plain)
        lanes = enter_each(c, frame, lanes, blind);
    if (!lanes)
        return 0;
    if (!plain || lanes != ~(uint64_t)0 >> (BVH_COMPANY - c->party->count)) {
        fill_others(c, lanes);
        COMPANY_BOUND_ALL(c);
    }
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

#ifndef COMPANY_PUSH_FEW
#define COMPANY_PUSH_FEW COMPANY_NAME(push_few)

/* As push, of a few lanes. */
COMPANY_TARGET static inline uint32_t COMPANY_NAME(push_few)(const company *c, const bvh_node *node, uint64_t lanes,
                                                             bool sorted, company_stack *stack, uint32_t top)
{
    float entry[BVH_WIDTH];
    uint64_t meets[BVH_WIDTH];
    uint32_t mask = COMPANY_FEW(node, c, lanes, entry, meets), base = top;

    for (; mask; mask &= mask - 1, top++) {
        const uint32_t i = first_of(mask);

        put_in(stack, sorted ? base : top, top, entry[i], node->child[i], meets[i]);
    }
    return top;
}
#endif

/* Put the children that lanes meet on the stack, the nearest on top. */
COMPANY_TARGET static inline uint32_t COMPANY_NAME(push)(const company *c, const bvh_node *node, uint64_t lanes,
                                                         bool sorted, company_stack *stack, uint32_t top)
{
    const uint32_t base = top;
    float entry[BVH_WIDTH];
    uint64_t eights;
    uint32_t mask, all;

    if (is_few(lanes))
        return COMPANY_PUSH_FEW(c, node, lanes, sorted, stack, top);
    mask = COMPANY_GROUP(node, c, entry, &all);
    eights = eights_of(lanes);
    if (are_less(lanes, eights, mask))
        return COMPANY_PUSH_FEW(c, node, lanes, sorted, stack, top);
    for (; mask; mask &= mask - 1) {
        const uint32_t i = first_of(mask);
        const uint64_t meet = all >> i & 1 ? lanes : COMPANY_LANES(node, i, c, lanes, eights);

        if (!meet)
            continue;
        put_in(stack, sorted ? base : top, top, entry[i], node->child[i], meet);
        top++;
    }
    return top;
}

COMPANY_TARGET static inline uint64_t COMPANY_NAME(walk)(bvh_party *party, bool sorted)
{
    company c;
    company_stack stack;
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
            const uint32_t before = top;
            top = COMPANY_NAME(push)(&c, &c.tree->nodes[at], lanes, sorted, &stack, top);
            if (top > before) {
                /* Whoever meets it does so within the limit. */
                lanes = lanes_on(&stack, --top);
                at = stack.at[top];
                continue;
            }
        } else if ((at & BVH_KIND) == BVH_LEAF) {
            COMPANY_NAME(visit)(&c, lanes, at & ~BVH_KIND);
        } else {
            put_on(&stack, top++, 0.0f, BVH_RETURN | c.frame, ~(uint64_t)0);
            lanes = COMPANY_NAME(enter)(&c, at & ~BVH_KIND, lanes);
            at = c.tree->frames[at & ~BVH_KIND].root;
            if (lanes)
                continue;
        }
        do {
            if (top == 0 || !c.open)
                return c.ended;
            lanes = lanes_on(&stack, --top) & c.open;
            at = stack.at[top];
            if (sorted && (at & BVH_KIND) != BVH_RETURN)
                lanes = COMPANY_WITHIN(&c, stack.entry[top], lanes);
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
