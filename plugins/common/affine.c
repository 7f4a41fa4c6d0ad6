#include "common/affine.h"

/* The entries of a composed map are within 2^-100 of the largest partial products; products and sums of a
 * few of them stay below this. */
#define TOLERANCE 0x1p-90

void common_linear(const pov_affine *map, pov_two3 rows[3])
{
    int i;

    for (i = 0; i < 3; i++) {
        rows[i].x = common_entry(map, i, 0);
        rows[i].y = common_entry(map, i, 1);
        rows[i].z = common_entry(map, i, 2);
    }
}

void common_inverse_linear(const pov_affine *map, pov_two3 rows[3])
{
    int i;

    for (i = 0; i < 3; i++) {
        rows[i].x = common_inverse_entry(map, i, 0);
        rows[i].y = common_inverse_entry(map, i, 1);
        rows[i].z = common_inverse_entry(map, i, 2);
    }
}

pov_two3 common_map_point(const pov_affine *map, pov_two3 p)
{
    pov_two3 rows[3], out;

    common_linear(map, rows);
    out.x = pov_two_add(pov_two3_dot(rows[0], p), common_entry(map, 0, 3));
    out.y = pov_two_add(pov_two3_dot(rows[1], p), common_entry(map, 1, 3));
    out.z = pov_two_add(pov_two3_dot(rows[2], p), common_entry(map, 2, 3));
    return out;
}

static double largest_entry(const double m[3][4])
{
    double largest = 0.0;
    int i, j;

    for (i = 0; i < 3; i++) {
        for (j = 0; j < 3; j++)
            largest = pov_max(largest, fabs(m[i][j]));
    }
    return largest;
}

bool common_is_similarity(const pov_affine *map, pov_two *factor)
{
    double power = pov_inverse_power(largest_entry(map->m));
    pov_two3 rows[3];
    pov_two square, other;
    int i;

    common_linear(map, rows);
    for (i = 0; i < 3; i++) {
        rows[i].x = pov_two_scale(rows[i].x, power);
        rows[i].y = pov_two_scale(rows[i].y, power);
        rows[i].z = pov_two_scale(rows[i].z, power);
    }
    square = pov_two3_dot(rows[0], rows[0]);
    for (i = 1; i < 3; i++) {
        other = pov_two_sub(pov_two3_dot(rows[i], rows[i]), square);
        if (!(fabs(other.hi) <= TOLERANCE * square.hi))
            return false;
    }
    for (i = 0; i < 3; i++) {
        other = pov_two3_dot(rows[i], rows[(i + 1) % 3]);
        if (!(fabs(other.hi) <= TOLERANCE * square.hi))
            return false;
    }
    square = pov_two_sqrt(square);
    *factor = pov_two_of(square.hi / power, square.lo / power);
    return isfinite(factor->hi) && factor->hi > 0.0;
}

bool common_is_axial(const pov_affine *map, int axis[3])
{
    int i, j;

    for (i = 0; i < 3; i++) {
        int entries = 0;

        for (j = 0; j < 3; j++) {
            if (map->m[i][j] != 0.0) {
                axis[i] = j;
                entries++;
            }
        }
        if (entries != 1)
            return false;
    }
    return axis[0] != axis[1] && axis[1] != axis[2] && axis[2] != axis[0];
}

double common_condition(const pov_affine *map)
{
    return largest_entry(map->m) * largest_entry(map->inv);
}
