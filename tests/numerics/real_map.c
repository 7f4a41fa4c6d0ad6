#include "numerics/real_map.h"

static real determinant2(real a, real b, real c, real d) { return real_sub(real_mul(a, d), real_mul(b, c)); }

void real_map_invert(real_map *f)
{
    real minor[3][3], det;
    int i, j;

    for (i = 0; i < 3; i++) {
        for (j = 0; j < 3; j++) {
            const int r = (i + 1) % 3, s = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
            minor[i][j] = determinant2(f->m[r][c], f->m[r][d], f->m[s][c], f->m[s][d]);
        }
    }
    det = real_add(real_add(real_mul(f->m[0][0], minor[0][0]), real_mul(f->m[0][1], minor[0][1])),
                   real_mul(f->m[0][2], minor[0][2]));
    for (i = 0; i < 3; i++) {
        for (j = 0; j < 3; j++)
            f->inverse[i][j] = real_div(minor[j][i], det);
    }
}

real3 real_times(real m[3][3], real3 v)
{
    real r[3];
    int i;

    for (i = 0; i < 3; i++)
        r[i] = real_add(real_add(real_mul(m[i][0], v.x), real_mul(m[i][1], v.y)), real_mul(m[i][2], v.z));
    return real3_of(r[0], r[1], r[2]);
}
