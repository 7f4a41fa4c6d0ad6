#include "common/runs.h"

#include <stdlib.h>

static int compare(const common_part *a, const common_part *b, int axis)
{
    if (a->at[axis] < b->at[axis] || a->at[axis] > b->at[axis])
        return a->at[axis] < b->at[axis] ? -1 : 1;
    return a->number < b->number ? -1 : a->number > b->number;
}

static int compare_x(const void *a, const void *b) { return compare(a, b, 0); }
static int compare_y(const void *a, const void *b) { return compare(a, b, 1); }
static int compare_z(const void *a, const void *b) { return compare(a, b, 2); }

static int longest_axis(const common_part *parts, uint32_t n)
{
    double lo[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, hi[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
    int longest = 0;

    for (uint32_t i = 0; i < n; i++)
        for (int axis = 0; axis < 3; axis++) {
            lo[axis] = pov_min(lo[axis], parts[i].at[axis]);
            hi[axis] = pov_max(hi[axis], parts[i].at[axis]);
        }
    for (int axis = 1; axis < 3; axis++)
        if (hi[axis] - lo[axis] > hi[longest] - lo[longest])
            longest = axis;
    return longest;
}

/* Halves by whole runs of runs as long as there are several, and then by whole runs. */
void common_runs_arrange(common_part *parts, uint32_t n)
{
    static int (*const order[3])(const void *, const void *) = { compare_x, compare_y, compare_z };
    const uint32_t step = n > COMMON_RUNS ? COMMON_RUNS : COMMON_RUN, middle = (n / step + 1) / 2 * step;

    if (n <= COMMON_RUN)
        return;
    qsort(parts, n, sizeof *parts, order[longest_axis(parts, n)]);
    common_runs_arrange(parts, middle);
    common_runs_arrange(parts + middle, n - middle);
}
