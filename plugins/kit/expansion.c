#include "kit/expansion.h"

void kit_expansion_add(kit_expansion *e, double a)
{
    int i, count = 0;

    if (a == 0.0 || e->count >= KIT_EXPANSION_MAX - 1)
        return;
    for (i = 0; i < e->count; i++) {
        pov_two s = pov_two_sum(a, e->part[i]);

        a = s.hi;
        if (s.lo != 0.0)
            e->part[count++] = s.lo;
    }
    if (a != 0.0)
        e->part[count++] = a;
    e->count = count;
}

void kit_expansion_add_product(kit_expansion *e, double a, double b)
{
    pov_two p;

    if (a == 0.0 || b == 0.0)
        return;
    p = pov_two_product(a, b);
    kit_expansion_add(e, p.lo);
    kit_expansion_add(e, p.hi);
}

void kit_expansion_add_product3(kit_expansion *e, double a, double b, double c)
{
    pov_two p;

    if (a == 0.0 || b == 0.0)
        return;
    p = pov_two_product(a, b);
    kit_expansion_add_product(e, p.lo, c);
    kit_expansion_add_product(e, p.hi, c);
}

pov_two kit_expansion_two(const kit_expansion *e)
{
    pov_two sum = { 0.0, 0.0 };
    int i;

    for (i = 0; i < e->count; i++)
        sum = pov_two_add_double(sum, e->part[i]);
    return sum;
}

int kit_expansion_sign(const kit_expansion *e)
{
    double largest = e->count > 0 ? e->part[e->count - 1] : 0.0;

    return (largest > 0.0) - (largest < 0.0);
}
