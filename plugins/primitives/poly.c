/* poly { order, <coefficients> [sturm] }: all of them, by falling power of x, then y, then z. */
#include "common/polynomial.h"

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    const double order = host->number(in);

    if (!(order >= 2.0 && order <= COMMON_ORDER_MAX && order == floor(order)))
        host->fail(in, "the order of a poly must be a whole number from 2 to %d", COMMON_ORDER_MAX);
    else
        common_polynomial_read(self, host, in, (int)order);
}

COMMON_POLYNOMIAL_CLASS(poly, parse);
