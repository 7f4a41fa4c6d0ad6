/* hexagonal.h - hexagons of side 1 in the xz plane. */
#ifndef TEXTURE_HEXAGONAL_H
#define TEXTURE_HEXAGONAL_H

#include "base/simd.h"

#include <math.h>

static const double hexagonal_root3 = 1.7320508075688772935;

/* The centres are i (1.5, sqrt(3)/2) + j (0, sqrt(3)). */
typedef struct hexagonal_cell { double i, j, x, z; } hexagonal_cell;   /* x, z: from the centre */

SIMD_INLINE hexagonal_cell hexagonal_in_column(double i, double x, double z)
{
    const double j = floor(z / hexagonal_root3 - 0.5 * i + 0.5);
    const hexagonal_cell c = { i, j, x - 1.5 * i, z - hexagonal_root3 * (j + 0.5 * i) };

    return c;
}

/* The nearest centre lies in the column before the point or in that behind it. */
SIMD_INLINE hexagonal_cell hexagonal_at(double x, double z)
{
    const double first = floor(x / 1.5);
    const hexagonal_cell a = hexagonal_in_column(first, x, z), b = hexagonal_in_column(first + 1.0, x, z);
    const int second = b.x * b.x + b.z * b.z < a.x * a.x + a.z * a.z;
    hexagonal_cell out;

    out.i = second ? b.i : a.i;
    out.j = second ? b.j : a.j;
    out.x = second ? b.x : a.x;
    out.z = second ? b.z : a.z;
    return out;
}

#endif
