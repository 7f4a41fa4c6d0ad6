/* Surfaces of a polynomial as they are written, and what is known of one beforehand. */
#include "common/curve.h"
#include "common/polynomial.h"

static uint32_t count_of(int n) { return (uint32_t)((n + 1) * (n + 2) * (n + 3) / 6); }

bool common_polynomial_make(common_polynomial *p, const pov_host *host, pov_reader *in, int order)
{
    p->order = order;
    p->count = count_of(order);
    p->at = host->alloc(in, p->count * sizeof *p->at);
    return p->at != NULL;
}

/* Before it stand the terms of higher powers of x, then those of higher powers of y. */
uint32_t common_polynomial_place(int order, int i, int j, int k)
{
    const int rest = order - i, both = rest - j;

    return (uint32_t)(rest * (rest + 1) * (rest + 2) / 6 + both * (both + 1) / 2 + both - k);
}

void common_polynomial_read(common_polynomial *p, const pov_host *host, pov_reader *in, int order)
{
    if (!common_polynomial_make(p, host, in, order))
        return;
    host->accept(in, ",");
    host->expect(in, "<");
    for (uint32_t i = 0; i < p->count; i++) {
        if (i > 0)
            host->accept(in, ",");
        p->at[i] = host->number(in);
    }
    host->expect(in, ">");
    common_sturm_read(host, in);
    common_polynomial_close(p, host, in);
}

static void list_terms(common_polynomial *p)
{
    uint32_t at = 0, row = 0, terms = 0;

    p->highest_x = p->highest_z = -1;
    for (int i = p->order; i >= 0; i--) {
        p->highest[i] = -1;
        for (int j = p->order - i; j >= 0; j--) {
            p->first[row++] = terms;
            for (int k = p->order - i - j; k >= 0; k--, at++)
                if (p->at[at] != 0.0) {
                    const common_term one = { p->at[at], k };

                    p->term[terms++] = one;
                    p->highest[i] = j > p->highest[i] ? j : p->highest[i];
                    p->highest_z = k > p->highest_z ? k : p->highest_z;
                    p->highest_x = i > p->highest_x ? i : p->highest_x;
                }
        }
    }
    p->first[row] = terms;
}

/* A term comes into a coefficient along a ray by (n + 1) (n + 2) / 2 sums at most, n products and as many sums of Horner's schemes, and one
 * with its number; each of its n factors is a coordinate and a direction that were rounded once. n + 4 more: its Bernstein form. */
static void find_sizes(common_polynomial *p)
{
    const int n = p->order;
    uint32_t at = 0;

    for (int i = n; i >= 0; i--)
        for (int j = n - i; j >= 0; j--)
            for (int k = n - i - j; k >= 0; k--, at++)
                p->size[i + j + k] += fabs(p->at[at]);
    p->off = COMMON_U * (0.5 * (n + 1) * (n + 2) + 5.0 * n + 8.0);
}

void common_polynomial_close(common_polynomial *p, const pov_host *host, pov_reader *in)
{
    const uint32_t n = (uint32_t)p->order;

    p->term = host->alloc(in, p->count * sizeof *p->term);
    p->first = host->alloc(in, ((n + 1) * (n + 2) / 2 + 1) * sizeof *p->first);
    p->highest = host->alloc(in, (n + 1) * sizeof *p->highest);
    p->size = host->alloc(in, (n + 1) * sizeof *p->size);
    if (!p->term || !p->first || !p->highest || !p->size)
        return;
    list_terms(p);
    find_sizes(p);
    p->bounded = common_polynomial_find_box(p, &p->box);
    p->wide = p->bounded ? pov_largest(pov_sub(p->box.hi, p->box.lo)) : HUGE_VAL;
    p->reach = p->bounded ? (pov_largest(p->box.lo) + pov_largest(p->box.hi) + p->wide) * 1.0625 : 0.0;
    p->sizes = common_polynomial_size(p, p->reach);
}
