/* How a binary tree becomes one of wide nodes: what is found to cost least against all that can be. */
#include "support/check.h"
#include "support/shapes.h"

#include "bvh/build.h"

#include <string.h>

enum { ENDS = 14, NODES = 2 * ENDS - 1 };

/* A tree of so many ends, of any shape: whichever build node comes next is divided. */
static uint32_t plant(test_random *r, bvh_build_node *nodes, uint32_t ends)
{
    uint32_t count = 1, which;

    memset(nodes, 0, NODES * sizeof *nodes);
    nodes[0].is_end = true;
    for (nodes[0].range.area = 1.0f; count < 2 * ends - 1; count += 2) {
        do
            which = (uint32_t)test_uniform(r, 0.0, (double)count);
        while (which >= count || !nodes[which].is_end);
        nodes[which].is_end = false;
        nodes[which].half[0] = count;
        nodes[which].half[1] = count + 1;
        nodes[count].is_end = nodes[count + 1].is_end = true;
        nodes[count].range.area = nodes[which].range.area * (float)test_uniform(r, 0.1, 1.0);
        nodes[count + 1].range.area = nodes[which].range.area * (float)test_uniform(r, 0.1, 1.0);
    }
    return count;
}

static float least_of_all(const bvh_build_node *nodes, uint32_t which);

/* The least that a node costs with these children, or with any of them from `first` on divided further. */
static float least_with(const bvh_build_node *nodes, const uint32_t *children, int n, int first)
{
    float least = 0.0f, other;
    int i;

    for (i = 0; i < n; i++)
        least += least_of_all(nodes, children[i]);
    for (i = first; i < n && n < BVH_WIDTH; i++) {
        uint32_t more[BVH_WIDTH];

        if (nodes[children[i]].is_end)
            continue;
        memcpy(more, children, sizeof more);
        more[i] = nodes[children[i]].half[0];
        more[n] = nodes[children[i]].half[1];
        other = least_with(nodes, more, n + 1, i);
        least = other < least ? other : least;
    }
    return least;
}

static float least_of_all(const bvh_build_node *nodes, uint32_t which)
{
    const bvh_build_node *t = &nodes[which];
    const uint32_t halves[BVH_WIDTH] = { t->half[0], t->half[1] };

    return t->is_end ? 0.0f : t->range.area + least_with(nodes, halves, 2, 0);
}

/* What the nodes cost that were chosen; their ends are counted. */
static float cost_of_chosen(const bvh_build_node *nodes, uint32_t which, uint32_t *ends)
{
    uint32_t children[BVH_WIDTH];
    float sum = nodes[which].range.area;
    int n, i;

    if (nodes[which].is_end) {
        ++*ends;
        return 0.0f;
    }
    n = bvh_children_of(nodes, which, children);
    assert_in_range(n, 2, BVH_WIDTH);
    for (i = 0; i < n; i++)
        sum += cost_of_chosen(nodes, children[i], ends);
    return sum;
}

static void nodes_cost_the_least_that_they_can(void **state)
{
    test_random r = { 5 };
    bvh_build_node nodes[NODES];
    int round;

    (void)state;
    for (round = 0; round < 200; round++) {
        const uint32_t ends = 2 + (uint32_t)round % (ENDS - 1), count = plant(&r, nodes, ends);
        uint32_t candidates = 0;
        float least, chosen;

        bvh_weigh_nodes(nodes, count);
        chosen = cost_of_chosen(nodes, 0, &candidates);
        least = least_of_all(nodes, 0);
        assert_int_equal(candidates, ends);
        assert_true(fabsf(chosen - least) <= 1e-5f * least);
        assert_true(fabsf(chosen - nodes[0].cost[0]) <= 1e-5f * least);
    }
}

static void up_to_eight_ends_are_one_node(void **state)
{
    test_random r = { 6 };
    bvh_build_node nodes[NODES];
    uint32_t children[BVH_WIDTH], ends;

    (void)state;
    for (ends = 2; ends <= BVH_WIDTH; ends++) {
        bvh_weigh_nodes(nodes, plant(&r, nodes, ends));
        assert_int_equal(bvh_children_of(nodes, 0, children), ends);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_cost_the_least_that_they_can),
        cmocka_unit_test(up_to_eight_ends_are_one_node),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
