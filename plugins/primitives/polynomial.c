/* polynomial { order, xyz(i, j, k): coefficient, ... [sturm] }: those that are not zero. */
#include "common/curve.h"
#include "common/polynomial.h"

static void read_term(common_polynomial *p, const pov_host *host, pov_reader *in)
{
    double power[3], value;

    host->expect(in, "(");
    for (int i = 0; i < 3; i++) {
        power[i] = host->number(in);
        host->accept(in, ",");
    }
    host->expect(in, ")");
    host->expect(in, ":");
    value = host->number(in);
    for (int i = 0; i < 3; i++)
        if (!(power[i] >= 0.0 && power[i] == floor(power[i])))
            host->fail(in, "the powers of a term must be whole numbers that are not negative");
    if (!(power[0] + power[1] + power[2] <= p->order))
        host->fail(in, "the powers of a term add up to more than the order");
    else if (power[0] >= 0.0 && power[1] >= 0.0 && power[2] >= 0.0)
        p->at[common_polynomial_place(p->order, (int)power[0], (int)power[1], (int)power[2])] = value;
    host->accept(in, ",");
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    const double order = host->number(in);

    if (!(order >= 2.0 && order <= COMMON_ORDER_MAX && order == floor(order))) {
        host->fail(in, "the order of a polynomial must be a whole number from 2 to %d", COMMON_ORDER_MAX);
        return;
    }
    if (!common_polynomial_make(self, host, in, (int)order))
        return;
    host->accept(in, ",");
    while (host->accept(in, "xyz"))
        read_term(self, host, in);
    common_sturm_read(host, in);
    common_polynomial_close(self, host, in);
}

COMMON_POLYNOMIAL_CLASS(polynomial, parse);
