#include "common/expansion.h"

void common_expansion_add(common_expansion *e, double a)
{
    int i, count = 0;

    if (a == 0.0 || e->count >= COMMON_EXPANSION_MAX - 1)
        return;
    for (i = 0; i < e->count; i++) {
        pov_two s = pov_two_sum(a, e->term[i]);

        a = s.hi;
        if (s.lo != 0.0)
            e->term[count++] = s.lo;
    }
    if (a != 0.0)
        e->term[count++] = a;
    e->count = count;
}

void common_expansion_add_product(common_expansion *e, double a, double b)
{
    pov_two p;

    if (a == 0.0 || b == 0.0)
        return;
    p = pov_two_product(a, b);
    common_expansion_add(e, p.lo);
    common_expansion_add(e, p.hi);
}

void common_expansion_add_product3(common_expansion *e, double a, double b, double c)
{
    pov_two p;

    if (a == 0.0 || b == 0.0)
        return;
    p = pov_two_product(a, b);
    common_expansion_add_product(e, p.lo, c);
    common_expansion_add_product(e, p.hi, c);
}

pov_two common_expansion_two(const common_expansion *e)
{
    pov_two sum = { 0.0, 0.0 };
    int i;

    for (i = 0; i < e->count; i++)
        sum = pov_two_add_double(sum, e->term[i]);
    return sum;
}

int common_expansion_sign(const common_expansion *e)
{
    double largest = e->count > 0 ? e->term[e->count - 1] : 0.0;

    return (largest > 0.0) - (largest < 0.0);
}
