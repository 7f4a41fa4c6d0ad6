/* test_world_order.c - the order that children of a node are put in by vectors of the copy for x86-64-v4. */
#include "support/check.h"

#include <stdint.h>
#include <string.h>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define HAS_VECTORS 1
#pragma GCC push_options
#pragma GCC target("avx2,fma,avx512f,avx512vl,avx512dq,avx512bw")
#include "bvh/avx2.h"

/* Gives how many were met; their places in the node, and what lies before each, greatest first. */
__attribute__((noinline)) static uint32_t in_order(const float entry[8], uint32_t candidates, uint32_t place[8],
                                                   float before[8])
{
    const uint32_t count = (uint32_t)__builtin_popcount(candidates);
    const __m256i order = sort_avx512(slot_entries_avx512(_mm256_loadu_ps(entry), (__mmask8)candidates), count);
    uint32_t i;

    store_avx512(place, order);
    _mm256_storeu_ps(before, entries_avx512(order));
    for (i = 0; i < 8; i++)
        place[i] &= 7;
    return count;
}
#pragma GCC pop_options
#endif

/* Traversals hold what lies before a child against limits: were it more than it is, a child that is met could be passed
 * by. */
static void what_lies_before_a_child_is_never_more_than_it_is(void **state)
{
#ifdef HAS_VECTORS
    uint64_t seed = 1;
    int round;

    (void)state;
    if (!__builtin_cpu_supports("avx512vl") || !__builtin_cpu_supports("avx512dq")) {
        print_message("this processor has no AVX-512VL and DQ");
        skip();
    }
    for (round = 0; round < 20000; round++) {
        float entry[8], before[8];
        uint32_t place[8], candidates = (uint32_t)round & 255, seen = 0, count, i;

        for (i = 0; i < 8; i++) {
            const uint32_t bits = (uint32_t)((seed = seed * 6364136223846793005u + 1442695040888963407u) >> 34);
            const uint32_t near = round % 3 == 0 ? 0x3f800000u + (bits & 31) : bits % 0x7f800000u;
            memcpy(&entry[i], &near, sizeof near);
        }
        count = in_order(entry, candidates, place, before);
        for (i = 0; i < count; i++) {
            const float own = entry[place[i]];
            assert_true(before[i] <= own);
            assert_true(before[i] >= own * (1.0f - 0x1p-19f) || own < 0x1p-120f);
            assert_true(i == 0 || before[i - 1] >= before[i]);
            seen |= 1u << place[i];
        }
        assert_int_equal(seen, candidates);
    }
#else
    (void)state;
    print_message("this compiler cannot build for AVX-512");
    skip();
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(what_lies_before_a_child_is_never_more_than_it_is) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
