/* packet_body.h - packet traversal, included by packet.c once for each instruction set, with PACKET_TARGET (the
 * function attribute), PACKET_NAME (the suffix of names), PACKET_BOUND_ALL (the packet's bounds), the tests
 * PACKET_GROUP, PACKET_FEW, PACKET_LANES and PACKET_WITHIN, PACKET_LOWER (of limits that leaves lowered), and
 * PACKET_PUSH_FEW where there is a better one than the one here. No guard, for that reason. */

PACKET_TARGET static inline void PACKET_NAME(visit)(packet_state *c, uint64_t lanes, uint32_t leaf)
{
    end_lanes(c, c->traversal->leaf(c->traversal, c->tree->leaves + (size_t)leaf * BVH_UNIT, lanes));
    PACKET_LOWER(c);
}

/* Transform one axis of all rays to the frame. */
PACKET_TARGET static inline void PACKET_NAME(enter_axis)(packet_state *c, double centre, double scale, int k)
{
    pov_rays *soa = &c->traversal->soa;
    const double *restrict org = soa->org[k], *restrict org_lo = soa->org_lo[k], *restrict dir = soa->dir[k];
    const double *restrict per_length = soa->per_length;
    float *restrict inverses = c->inverse[k], *restrict near = c->near_offset[k], *restrict far = c->far_offset[k];
    float *restrict org_out = soa->local.org[k], *restrict dir_out = soa->local.dir[k];
    const float least = (float)BVH_LEAST;
    const uint32_t width = c->width;
    uint32_t i;

    for (i = 0; i < width; i++) {
        const float o = (float)((org[i] - centre + org_lo[i]) * scale), d = (float)(dir[i] * per_length[i]);
        const float a = fabsf(d), inverse = 1.0f / copysignf(a > least ? a : least, d);
        const float slack = fabsf(inverse) * (1.0f + fabsf(o)) * PACKET_SLACK;

        inverses[i] = inverse;
        near[i] = o * inverse + slack;
        far[i] = o * inverse - slack;
        org_out[i] = o;
        dir_out[i] = d;
    }
}

PACKET_TARGET static inline void PACKET_NAME(enter_limits)(packet_state *c, double scale)
{
    pov_rays *soa = &c->traversal->soa;
    const double *restrict lengths = c->traversal->length, *restrict per_length = soa->per_length;
    const float *restrict x = soa->local.org[0], *restrict y = soa->local.org[1], *restrict z = soa->local.org[2];
    double *restrict scales = c->scale, *restrict shifts = soa->local.shift, *restrict units = soa->local.unit;
    float *restrict size = soa->local.size;
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
    c->traversal->lowered = c->open; /* all limits are new */
    PACKET_LOWER(c);
}

/* Transform all rays to the frame. False: some need the general method. Their lengths are in the range of filters. */
PACKET_TARGET static inline bool PACKET_NAME(enter_all)(packet_state *c, const bvh_frame *f)
{
    PACKET_NAME(enter_axis)(c, f->centre.x, f->scale, 0);
    PACKET_NAME(enter_axis)(c, f->centre.y, f->scale, 1);
    PACKET_NAME(enter_axis)(c, f->centre.z, f->scale, 2);
    PACKET_NAME(enter_limits)(c, f->scale);
    PACKET_BOUND_ALL(c);
    return c->near && f->scale > BVH_SMALL && f->scale < BVH_LARGE;
}

/* Transform lanes to a frame; returns those that do not miss it. *blind: rays whose numbers are out of range. */
PACKET_TARGET static uint64_t PACKET_NAME(enter_lanes)(packet_state *c, uint32_t frame, uint64_t lanes, uint64_t *blind)
{
    const bool plain = PACKET_NAME(enter_all)(c, &c->tree->frames[frame]);

    *blind = 0;
    c->frame = frame;
    c->traversal->in = &c->tree->frames[frame];
    if (!plain)
        lanes = enter_each(c, frame, lanes, blind);
    if (!lanes)
        return 0;
    if (!plain || lanes != ~(uint64_t)0 >> (BVH_LANES - c->traversal->count)) {
        fill_others(c, lanes);
        PACKET_BOUND_ALL(c);
    }
    return lanes;
}

/* Enter a frame for the first time. */
PACKET_TARGET static uint64_t PACKET_NAME(enter)(packet_state *c, uint32_t frame, uint64_t lanes)
{
    uint64_t blind, in = PACKET_NAME(enter_lanes)(c, frame, lanes, &blind);

    if (blind)
        go_single(c, blind, c->tree->frames[frame].root);
    return in;
}

#ifndef PACKET_PUSH_FEW
#define PACKET_PUSH_FEW PACKET_NAME(push_few)

/* As push, of a few lanes. */
PACKET_TARGET static inline uint32_t PACKET_NAME(push_few)(const packet_state *c, const bvh_node *node, uint64_t lanes,
                                                             bool sorted, packet_stack *stack, uint32_t top)
{
    float entry[BVH_WIDTH];
    uint64_t hit_masks[BVH_WIDTH];
    uint32_t mask = PACKET_FEW(node, c, lanes, entry, hit_masks), base = top;

    for (; mask; mask &= mask - 1, top++) {
        const uint32_t i = first_of(mask);

        insert_entry(stack, sorted ? base : top, top, entry[i], node->child[i], hit_masks[i]);
    }
    return top;
}
#endif

/* Push the children that lanes hit, the nearest on top. */
PACKET_TARGET static inline uint32_t PACKET_NAME(push)(const packet_state *c, const bvh_node *node, uint64_t lanes,
                                                         bool sorted, packet_stack *stack, uint32_t top)
{
    const uint32_t base = top;
    float entry[BVH_WIDTH];
    uint64_t eights;
    uint32_t mask, all;

    if (is_few(lanes))
        return PACKET_PUSH_FEW(c, node, lanes, sorted, stack, top);
    mask = PACKET_GROUP(node, c, entry, &all);
    eights = eights_of(lanes);
    if (are_less(lanes, eights, mask))
        return PACKET_PUSH_FEW(c, node, lanes, sorted, stack, top);
    for (; mask; mask &= mask - 1) {
        const uint32_t i = first_of(mask);
        const uint64_t hit_mask = all >> i & 1 ? lanes : PACKET_LANES(node, i, c, lanes, eights);

        if (!hit_mask)
            continue;
        insert_entry(stack, sorted ? base : top, top, entry[i], node->child[i], hit_mask);
        top++;
    }
    return top;
}

PACKET_TARGET static inline uint64_t PACKET_NAME(traverse)(bvh_traversal *traversal, bool sorted)
{
    packet_state c;
    packet_stack stack;
    uint64_t lanes, blind;
    uint32_t top = 0, at = traversal->tree->frames[0].root;

    begin(&c, traversal);
    lanes = PACKET_NAME(enter)(&c, 0, c.open);
    if (!lanes)
        return c.ended;
    for (;;) {
        if ((at & BVH_KIND) == BVH_RETURN) {
            PACKET_NAME(enter_lanes)(&c, at & ~BVH_KIND, c.open, &blind);
        } else if ((at & BVH_KIND) == BVH_NODE) {
            const uint32_t before = top;
            top = PACKET_NAME(push)(&c, &c.tree->nodes[at], lanes, sorted, &stack, top);
            if (top > before) {
                /* Lanes that hit it do so within their limits. */
                lanes = lanes_on(&stack, --top);
                at = stack.at[top];
                continue;
            }
        } else if ((at & BVH_KIND) == BVH_LEAF) {
            PACKET_NAME(visit)(&c, lanes, at & ~BVH_KIND);
        } else {
            push_entry(&stack, top++, 0.0f, BVH_RETURN | c.frame, ~(uint64_t)0);
            lanes = PACKET_NAME(enter)(&c, at & ~BVH_KIND, lanes);
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
                lanes = PACKET_WITHIN(&c, stack.entry[top], lanes);
        } while (!lanes);
    }
}

uint64_t PACKET_NAME(bvh_nearest_packet)(bvh_traversal *traversal)
{
    return PACKET_NAME(traverse)(traversal, true);
}

uint64_t PACKET_NAME(bvh_any_packet)(bvh_traversal *traversal)
{
    return PACKET_NAME(traverse)(traversal, false);
}
