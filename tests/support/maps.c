#include "support/maps.h"

#include <math.h>

double test_power(test_random *r, double lo, double hi)
{
    return pow(10.0, test_uniform(r, lo, hi));
}

double test_factor(test_random *r, double size, double uneven)
{
    const double v = size * test_power(r, -uneven, uneven);

    return test_below(r, 2) ? v : -v;
}

const transform *test_random_map(model *m, test_random *r)
{
    const double size = test_power(r, -12.0, 12.0), uneven = test_below(r, 3) ? 0.5 : 4.5;
    const transform *map = test_transform(m, NULL, TRANSFORM_SCALE, test_factor(r, size, uneven),
                                          test_factor(r, size, uneven), test_factor(r, size, uneven));

    if (test_below(r, 4))
        map = test_transform(m, map, TRANSFORM_ROTATE, test_uniform(r, 0.0, 360.0), test_uniform(r, 0.0, 360.0),
                             test_uniform(r, 0.0, 360.0));
    if (!test_below(r, 4))
        map = test_transform(m, map, TRANSFORM_SCALE, test_power(r, -2.0, 2.0), test_power(r, -2.0, 2.0),
                             test_power(r, -2.0, 2.0));
    if (test_below(r, 4)) {
        const double far = size * test_power(r, -3.0, 9.0);
        const pov_vec3 dir = test_direction(r);
        map = test_transform(m, map, TRANSFORM_TRANSLATE, far * dir.x, far * dir.y, far * dir.z);
    }
    return map;
}

pov_box test_random_cube(test_random *r)
{
    const double size = test_power(r, -2.0, 2.0);
    const pov_vec3 far = pov_scale(test_direction(r), test_below(r, 2) ? 0.0 : 10.0 * size);
    pov_box b;

    b.lo = pov_sub(far, pov_vec3_of(size, size, size));
    b.hi = pov_add(far, pov_vec3_of(size, size, size));
    return b;
}
