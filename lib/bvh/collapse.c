#include "bvh/build.h"

/* The least cost of up to `roots` nodes that hold all descendants of a build node, from the costs of its halves;
 * to_left: the number of nodes for the first half. */
static float share_out(const bvh_build_node *nodes, const bvh_build_node *t, int roots, uint8_t *to_left)
{
    const bvh_build_node *a = &nodes[t->half[0]], *b = &nodes[t->half[1]];
    float least = HUGE_VALF;
    int i;

    for (i = 1; i < roots; i++) {
        const float cost = a->cost[i - 1] + b->cost[roots - i - 1];

        if (cost < least) {
            least = cost;
            *to_left = (uint8_t)i;
        }
    }
    return least;
}

/* The probability of hitting a box is proportional to its surface, and each node costs the same to test. */
static void weigh(const bvh_build_node *nodes, bvh_build_node *t)
{
    int roots;

    for (roots = 1; roots <= BVH_WIDTH; roots++) {
        t->cost[roots - 1] = 0.0f;
        t->to_left[roots - 1] = 0;
    }
    if (t->is_end)
        return;
    t->cost[BVH_WIDTH - 1] = share_out(nodes, t, BVH_WIDTH, &t->to_left[BVH_WIDTH - 1]);
    t->cost[0] = t->range.area + t->cost[BVH_WIDTH - 1];
    for (roots = 2; roots < BVH_WIDTH; roots++) {
        t->cost[roots - 1] = share_out(nodes, t, roots, &t->to_left[roots - 1]);
        if (t->cost[roots - 1] >= t->cost[0]) {
            t->cost[roots - 1] = t->cost[0];
            t->to_left[roots - 1] = 0;
        }
    }
}

void bvh_weigh_nodes(bvh_build_node *nodes, uint32_t count)
{
    while (count-- > 0)
        weigh(nodes, &nodes[count]);
}

static int collect(const bvh_build_node *nodes, uint32_t which, int roots, uint32_t *out)
{
    const bvh_build_node *t = &nodes[which];
    const int first = t->to_left[roots - 1];
    int n;

    if (first == 0) {
        *out = which;
        return 1;
    }
    n = collect(nodes, t->half[0], first, out);
    return n + collect(nodes, t->half[1], roots - first, out + n);
}

int bvh_children_of(const bvh_build_node *nodes, uint32_t which, uint32_t out[BVH_WIDTH])
{
    return collect(nodes, which, BVH_WIDTH, out);
}
