/* near.h - numbers that are equal within a tolerance; cmocka 1.1 compares floats only. */
#ifndef SUPPORT_NEAR_H
#define SUPPORT_NEAR_H

#include "support/check.h"

#include <math.h>

static inline void near_check(double found, double wanted, double tolerance, const char *file, int line)
{
    if (fabs(found - wanted) <= tolerance)
        return;
    print_error("%.17g is not within %g of %.17g\n", found, tolerance, wanted);
    _fail(file, line);
}

#define assert_near(found, wanted, tolerance) near_check((found), (wanted), (tolerance), __FILE__, __LINE__)

#endif
