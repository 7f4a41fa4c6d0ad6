/* noise_run.h - the sums of up to RUN_LANES points of one cell, by the name of RUN. It is included once for each number of lanes,
 * and has no guard for that reason. */

/* `count` components of `lanes` points from lane `first` on; no other lane is written. */
SIMD_INLINE void RUN(const lattice *l, uint32_t first, uint32_t lanes, const double *const from[CORNERS], int count, int level,
                     double *const out[])
{
    typedef double vector __attribute__((vector_size(RUN_LANES * sizeof(double))));
    const vector x = RUN_LOAD(l->inside[0] + first), y = RUN_LOAD(l->inside[1] + first), z = RUN_LOAD(l->inside[2] + first);
    const vector by_x[2] = { x, x - 2.0 }, by_y[2] = { y, y - 2.0 }, by_z[2] = { z, z - 2.0 };
    const uint8_t stored = (uint8_t)((1u << lanes) - 1);
    vector sum[3][PARTS];

#pragma GCC unroll 8
    for (int c = 0; c < CORNERS; c++) {
        const vector weight = RUN_LOAD(l->half_weight[c] + first);
        const vector by[PARTS] = { weight, by_x[c & 1] * weight, by_y[c >> 1 & 1] * weight, by_z[c >> 2] * weight };

        if (is_above(level, c))
            continue;
#pragma GCC unroll 3
        for (int j = 0; j < count; j++)
#pragma GCC unroll 4
            for (int k = 0; k < PARTS; k++) {
                const vector more = by[k] * from[c][PARTS * j + k];

                if (is_height(level, k))
                    continue;
                sum[j][k] = c == 0 ? more : sum[j][k] + more;
                KEEP_ORDER(sum[j][k]);
            }
    }
#pragma GCC unroll 3
    for (int j = 0; j < count; j++) {
        const vector behind = level == LEVEL_Y ? sum[j][3] : level == LEVEL_Z ? sum[j][2] : sum[j][2] + sum[j][3];

        RUN_STORE(out[j] + first, stored, (sum[j][0] + sum[j][1]) + behind);
    }
}
#undef RUN
#undef RUN_LANES
#undef RUN_LOAD
#undef RUN_STORE
