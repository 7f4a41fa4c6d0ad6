#include "bvh/corner.h"

/* Build nodes are taken out, one after the other, and put where they add least to the surfaces of those above them
 * (Bittner, Hapala, Havran 2013: Fast insertion-based optimization of bounding volume hierarchies). Cuts that part by
 * centres leave what is large among what is small, deep in the tree. */

/* More rounds find little. Some 20 build nodes are looked at for a place, and no more than LOOKS where boxes lie in
 * boxes. As many wait as there are levels, unless the tree is a chain. */
enum { ROUNDS = 2, STEPS = 200, QUEUE_MOST = 64 };

static inline box box_of(const bvh_build_node *t)
{
    const char *at = (const char *)&t->range;
    const box b = { corner_at(at + offsetof(bvh_range, lo)), corner_at(at + offsetof(bvh_range, hi)) };

    return b;
}

/* A place beside a build node, and how much less the surfaces are with it there. */
typedef struct insertion { uint32_t beside; float gain; } insertion;

typedef struct search {
    box own;                     /* of what is to be put elsewhere */
    float area;
    int steps;                   /* that are left */
    insertion best;
} search;

/* In all below a build node, and beside it. gain: of what becomes of all above it. */
static void search_below(search *s, const bvh_build_node *nodes, uint32_t top, float gain)
{
    insertion queue[QUEUE_MOST];
    int n = 1;

    queue[0].beside = top;
    queue[0].gain = gain;
    while (n > 0 && s->steps > 0) {
        insertion at = queue[--n];
        const bvh_build_node *t = &nodes[at.beside];
        box both;

        if (at.gain - s->area <= s->best.gain)
            continue;
        s->steps--;
        both = box_of(t);
        both = add(both, s->own.lo, s->own.hi);
        at.gain -= area_of(&both);
        if (at.gain > s->best.gain)
            s->best = at;
        at.gain += t->range.area;
        if (!t->is_end && at.gain - s->area > s->best.gain && n + 2 <= QUEUE_MOST) {
            const insertion a = { t->half[0], at.gain }, b = { t->half[1], at.gain };
            queue[n++] = a;
            queue[n++] = b;
        }
    }
}

static uint32_t other_half(const bvh_build_node *nodes, uint32_t which)
{
    const uint32_t *half = nodes[nodes[which].above].half;

    return half[half[0] == which];
}

/* The best of all places but its own, or beside the root: none. Whatever held it becomes as small as what is left. */
static insertion find_insertion(const bvh_build_node *nodes, uint32_t which)
{
    const bvh_build_node *t = &nodes[which], *left = &nodes[other_half(nodes, which)];
    search s = { box_of(t), t->range.area, STEPS, { 0, 0.0f } };
    float gain = nodes[t->above].range.area;
    box rest = box_of(left);
    uint32_t i;

    for (i = 0; !left->is_end && i < 2; i++)
        search_below(&s, nodes, left->half[i], left->range.area);
    for (i = t->above; i != 0 && s.steps > 0; i = nodes[i].above, s.steps--) {
        const uint32_t other = other_half(nodes, i);
        const box more = box_of(&nodes[other]);

        search_below(&s, nodes, other, gain);
        rest = add(rest, more.lo, more.hi);
        gain += nodes[nodes[i].above].range.area - area_of(&rest);
    }
    return s.best;
}

/* Find a build node's box anew. False: it is as it was. */
static bool measure(bvh_build_node *nodes, uint32_t which)
{
    bvh_range *r = &nodes[which].range;
    const box old = box_of(&nodes[which]), more = box_of(&nodes[nodes[which].half[1]]);
    box both = box_of(&nodes[nodes[which].half[0]]);
    bool changed = false;
    int k;

    both = add(both, more.lo, more.hi);
    for (k = 0; k < 3; k++) {
        r->lo[k] = LANE(both.lo, k);
        r->hi[k] = LANE(both.hi, k);
        changed = changed || r->lo[k] != LANE(old.lo, k) || r->hi[k] != LANE(old.hi, k);
    }
    r->area = area_of(&both);
    return changed;
}

static void measure_above(bvh_build_node *nodes, uint32_t which)
{
    while (which != 0) {
        which = nodes[which].above;
        if (!measure(nodes, which))
            return;
    }
}

static void replace(bvh_build_node *nodes, uint32_t old, uint32_t new)
{
    const uint32_t above = nodes[old].above;

    nodes[above].half[nodes[above].half[1] == old] = new;
    nodes[new].above = above;
}

/* What held it goes with it. */
static void reinsert(bvh_build_node *nodes, uint32_t which, uint32_t beside)
{
    const uint32_t holder = nodes[which].above, left = other_half(nodes, which);

    replace(nodes, holder, left);
    measure_above(nodes, left);
    replace(nodes, beside, holder);
    nodes[holder].half[0] = beside;
    nodes[holder].half[1] = which;
    nodes[beside].above = nodes[which].above = holder;
    measure(nodes, holder);
    measure_above(nodes, holder);
}

void bvh_reinsert(bvh_build_node *nodes, uint32_t count)
{
    uint32_t i;
    int round;

    for (round = 0; round < ROUNDS; round++)
        for (i = 1; i < count; i++) {
            const insertion none = { 0, 0.0f }, s = nodes[i].above == 0 ? none : find_insertion(nodes, i);

            if (s.beside != 0)
                reinsert(nodes, i, s.beside);
        }
}
