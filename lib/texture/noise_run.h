/* noise_run.h - the sums of RUN_LANES points of one cell, by the name of RUN. It is included once for each number of lanes, and has
 * no guard for that reason. */

/* `count` components from lane `first` on, of a multiple of that many lanes. */
SIMD_INLINE void RUN(const lattice *l, uint32_t first, const double *const from[CORNERS], int count, bool level, double *const out[])
{
    typedef double lanes __attribute__((vector_size(RUN_LANES * sizeof(double))));
    const lanes x = *(const lanes *)(const void *)(l->inside[0] + first), y = *(const lanes *)(const void *)(l->inside[1] + first);
    const lanes z = *(const lanes *)(const void *)(l->inside[2] + first);
    const lanes by_x[2] = { x, x - 1.0 }, by_y[2] = { y, y - 1.0 }, by_z[2] = { z, z - 1.0 };
    lanes sum[3][PARTS];

#pragma GCC unroll 8
    for (int c = 0; c < CORNERS; c++) {
        const lanes weight = *(const lanes *)(const void *)(l->weight[c] + first);
        const lanes by[PARTS] = { weight, by_x[c & 1] * weight, by_y[c >> 1 & 1] * weight, by_z[c >> 2] * weight };

        if (level && is_above(c))
            continue;
#pragma GCC unroll 3
        for (int j = 0; j < count; j++)
#pragma GCC unroll 4
            for (int k = 0; k < PARTS; k++) {
                const lanes more = by[k] * from[c][PARTS * j + k + (k == 0 ? HALVES : 0)];

                if (level && k == HEIGHT)
                    continue;
                sum[j][k] = c == 0 ? more : sum[j][k] + more;
                KEEP_ORDER(sum[j][k]);
            }
    }
#pragma GCC unroll 3
    for (int j = 0; j < count; j++) {
        const lanes all = (sum[j][0] + sum[j][1]) + (level ? sum[j][3] : sum[j][2] + sum[j][3]);

        memcpy(out[j] + first, &all, sizeof all);
    }
}
#undef RUN
#undef RUN_LANES
