/* interleaved.h - single rays traverse a tree interleaved: while one waits for its node, others continue. Children that
 * are hit are pushed without a branch, because branches of alternating rays cannot be predicted. No guard: packet.c
 * includes it, once. */

/* Number of rays at a time. */
enum { INTERLEAVED = 16 };

/* Traversal state of one ray: byte offsets of the near and far bound rows, and the stack. The stack starts with eight
 * sentinel entries; the last one ends the traversal. */
typedef struct interleaved_ray {
    float inverse[3], near_offset[3], far_offset[3], limit;
    uint32_t near_row[3], far_row[3];
    uint32_t at, lane, top;
    float entry[BVH_STACK + 2 * BVH_WIDTH];
    uint32_t child[BVH_STACK + 2 * BVH_WIDTH];
} interleaved_ray;

/* All rays, and the lanes that have not begun; bits of those that are at a node, and at a leaf or the end. */
typedef struct interleaved {
    interleaved_ray of[INTERLEAVED];
    uint64_t later;
    uint32_t at_node, at_leaf;
} interleaved;

static inline bool is_at_node(const interleaved_ray *t) { return (t->at & BVH_KIND) == BVH_NODE; }

BVH_AVX2 static inline void begin_ray(const packet_state *c, uint32_t lane, interleaved_ray *t)
{
    int k;

    for (k = 0; k < 3; k++) {
        t->inverse[k] = c->inverse[k][lane];
        t->near_offset[k] = c->near_offset[k][lane];
        t->far_offset[k] = c->far_offset[k][lane];
        t->near_row[k] = (2u * (uint32_t)k + (t->inverse[k] < 0.0f)) * (uint32_t)sizeof(float[BVH_WIDTH]);
        t->far_row[k] = t->near_row[k] ^ (uint32_t)sizeof(float[BVH_WIDTH]);
    }
    t->limit = c->limit[lane];
    t->lane = lane;
    t->at = c->tree->frames[0].root;
    t->top = BVH_WIDTH;
    _mm256_storeu_ps(t->entry, _mm256_set1_ps(-HUGE_VALF));
    t->child[BVH_WIDTH - 1] = BVH_RETURN;
}

/* Begin the next lane in this place, if there is one. */
BVH_AVX2 static inline void begin_next(const packet_state *c, interleaved *all, interleaved_ray *t)
{
    if (!all->later)
        return;
    begin_ray(c, first_of64(all->later), t);
    all->later &= all->later - 1;
}

/* Distances to the planes of a row. */
BVH_AVX2 static inline __m256 planes(const bvh_node *node, uint32_t row, const float *inverse, const float *offset)
{
    const float *bounds = (const float *)(const void *)((const char *)node + row);

    return _mm256_fmsub_ps(_mm256_load_ps(bounds), _mm256_broadcast_ss(inverse), _mm256_broadcast_ss(offset));
}

/* As hit_mask_avx2. */
BVH_AVX2 static inline __mmask8 hit_mask_avx512(const bvh_node *node, const interleaved_ray *t, __m256 *entry)
{
    const __m256 x = planes(node, t->near_row[0], &t->inverse[0], &t->near_offset[0]);
    const __m256 y = planes(node, t->near_row[1], &t->inverse[1], &t->near_offset[1]);
    const __m256 z = planes(node, t->near_row[2], &t->inverse[2], &t->near_offset[2]);
    const __m256 far_x = planes(node, t->far_row[0], &t->inverse[0], &t->far_offset[0]);
    const __m256 far_y = planes(node, t->far_row[1], &t->inverse[1], &t->far_offset[1]);
    const __m256 far_z = planes(node, t->far_row[2], &t->inverse[2], &t->far_offset[2]);
    const __m256 out = sooner(sooner(far_x, far_y), sooner(far_z, _mm256_broadcast_ss(&t->limit)));

    *entry = later(later(x, y), later(z, _mm256_setzero_ps()));
    return _mm256_cmp_ps_mask(*entry, out, _CMP_LE_OQ);
}

/* Push the children of the ray's node that are hit, and pop the top of the stack. */
BVH_AVX2 static inline void step_ray(const bvh_node *nodes, interleaved_ray *t, bool sorted)
{
    const bvh_node *node = &nodes[t->at];
    const __m256i child = _mm256_load_si256((const __m256i *)(const void *)node->child);
    __m256 entry;
    const __mmask8 hit = hit_mask_avx512(node, t, &entry);
    const uint32_t count = (uint32_t)__builtin_popcount(hit);

    if (sorted) {
        const __m256i order = sort_avx512(slot_entries_avx512(entry, hit), count);

        _mm256_storeu_ps(t->entry + t->top, entries_avx512(order));
        store_avx512(t->child + t->top, _mm256_permutevar8x32_epi32(child, order));
    } else {
        store_avx512(t->child + t->top, _mm256_maskz_compress_epi32(hit, child));
    }
    t->top += count - 1;
    t->at = t->child[t->top];
}

/* Advance all rays that are at nodes, until none is. */
BVH_AVX2 static inline void step_rays(const bvh_node *nodes, interleaved *all, bool sorted)
{
    while (all->at_node) {
        uint32_t node = 0, rest;

        for (rest = all->at_node; rest; rest &= rest - 1) {
            const uint32_t which = first_of(rest);

            step_ray(nodes, &all->of[which], sorted);
            node |= (uint32_t)is_at_node(&all->of[which]) << which;
        }
        all->at_leaf |= all->at_node & ~node;
        all->at_node = node;
    }
}

/* Pop the topmost entry within the limit. */
BVH_AVX2 static inline void go_on(interleaved_ray *t, bool sorted)
{
    const __m256 limit = _mm256_broadcast_ss(&t->limit);
    uint32_t within = 0;

    for (; sorted && !within; t->top -= BVH_WIDTH)
        within = _mm256_cmp_ps_mask(_mm256_loadu_ps(t->entry + t->top - BVH_WIDTH), limit, _CMP_LE_OQ);
    t->top += sorted ? 31u - (uint32_t)__builtin_clz(within) : ~0u;
    t->at = t->child[t->top];
}

static inline const unsigned char *leaf_at(const packet_state *c, const interleaved_ray *t)
{
    return c->tree->leaves + (size_t)(t->at & ~BVH_KIND) * BVH_UNIT;
}

BVH_AVX2 static inline void ask_leaf(packet_state *c, interleaved_ray *t, bool sorted)
{
    const uint64_t lane = (uint64_t)1 << t->lane;

    end_lanes(c, c->traversal->leaf(c->traversal, leaf_at(c, t), lane));
    if (c->traversal->lowered) {
        c->traversal->lowered = 0;
        lower_limit(c, t->lane);
        t->limit = c->limit[t->lane];
    }
    go_on(t, sorted);
    if (!(c->open & lane))
        t->at = BVH_RETURN;
}

/* Process all rays that are at leaves, which are prefetched first, or at the end; then pop their next entries. */
BVH_AVX2 static inline void ask_leaves(packet_state *c, interleaved *all, bool sorted)
{
    uint32_t node = 0, end = 0, rest;

    for (rest = all->at_leaf; rest; rest &= rest - 1) {
        const unsigned char *leaf = leaf_at(c, &all->of[first_of(rest)]);

        SIMD_PREFETCH(leaf);
        SIMD_PREFETCH(leaf + BVH_UNIT);
    }
    for (rest = all->at_leaf; rest; rest &= rest - 1) {
        const uint32_t which = first_of(rest);
        interleaved_ray *t = &all->of[which];

        if (t->at != BVH_RETURN)
            ask_leaf(c, t, sorted);
        if (t->at == BVH_RETURN)
            begin_next(c, all, t);
        node |= (uint32_t)is_at_node(t) << which;
        end |= (uint32_t)(t->at == BVH_RETURN) << which;
    }
    all->at_node = node;
    all->at_leaf &= ~(node | end);
}

BVH_AVX2 static inline uint64_t traverse_interleaved(bvh_traversal *traversal, bool sorted)
{
    packet_state c;
    interleaved all;
    uint32_t i;

    begin(&c, traversal);
    all.later = enter_avx2(&c, 0, c.open) & c.open;
    for (i = 0; i < INTERLEAVED && all.later; i++)
        begin_next(&c, &all, &all.of[i]);
    all.at_leaf = ~(~0u << i);
    all.at_node = 0;
    if ((c.tree->frames[0].root & BVH_KIND) == BVH_NODE) {
        all.at_node = all.at_leaf;
        all.at_leaf = 0;
    }
    while (all.at_node | all.at_leaf) {
        step_rays(c.tree->nodes, &all, sorted);
        ask_leaves(&c, &all, sorted);
    }
    return c.ended;
}

uint64_t bvh_nearest_interleaved(bvh_traversal *traversal)
{
    return traverse_interleaved(traversal, true);
}

uint64_t bvh_any_interleaved(bvh_traversal *traversal)
{
    return traverse_interleaved(traversal, false);
}
