#include "model/sincos.h"

#include "model/transform.h"

#include <string.h>

/* Coefficients of x^2 in the Taylor series of sin(x) / x, for the first four lanes, and of cos(x), for the others: 1/n!
 * with its sign. */
#define FOUR(x) x, x, x, x
#define TERM(sine, sine_lo, cosine, cosine_lo) { { FOUR(sine), FOUR(cosine) }, { FOUR(sine_lo), FOUR(cosine_lo) } }
enum { TERMS = 15 };
static const two_lanes terms[TERMS] = {
    TERM(1.0, 0.0, 1.0, 0.0),
    TERM(-0.16666666666666666, -9.25185853854297e-18, -0.5, 0.0),
    TERM(0.008333333333333333, 1.1564823173178714e-19, 0.041666666666666664, 2.3129646346357427e-18),
    TERM(-0.0001984126984126984, -1.7209558293420705e-22, -0.001388888888888889, 5.300543954373577e-20),
    TERM(2.7557319223985893e-06, -1.858393274046472e-22, 2.48015873015873e-05, 2.1511947866775882e-23),
    TERM(-2.505210838544172e-08, 1.448814070935912e-24, -2.755731922398589e-07, -2.3767714622250297e-23),
    TERM(1.6059043836821613e-10, 1.2585294588752098e-26, 2.08767569878681e-09, -1.20734505911326e-25),
    TERM(-7.647163731819816e-13, -7.03872877733453e-30, -1.1470745597729725e-11, -2.0655512752830745e-28),
    TERM(2.8114572543455206e-15, 1.6508842730861433e-31, 4.779477332387385e-14, 4.399205485834081e-31),
    TERM(-8.22063524662433e-18, -2.2141894119604265e-34, -1.5619206968586225e-16, -1.1910679660273754e-32),
    TERM(1.9572941063391263e-20, -1.3643503830087908e-36, 4.110317623312165e-19, 1.4412973378659527e-36),
    TERM(-3.868170170630684e-23, 8.843177655482344e-40, -8.896791392450574e-22, 7.911402614872376e-38),
    TERM(6.446950284384474e-26, -1.9330404233703465e-42, 1.6117375710961184e-24, -3.6846573564509766e-41),
    TERM(-9.183689863795546e-29, -1.4303150396787322e-45, -2.4795962632247976e-27, 1.2953730964765229e-43),
    TERM(1.1309962886447716e-31, 1.0498015412959506e-47, 3.279889237069838e-30, 1.5117542744029879e-46)
};

/* The sums without their first terms, which are 1, so that the caller can add 1 exactly. |x| <= pi/4: the 15 terms
 * reach (pi/4)^28/28! < 2^-105. From the tenth on a term is below 2^-58 of the sum, so that rounding to double is
 * harmless there. Each step waits for the one before, so n sums side by side cost little more than one. */
static void series(const two_lanes *restrict x2, two_lanes *restrict sum, int n)
{
    int i, k, m;

    for (m = 0; m < n; m++)
        for (k = 0; k < TWO_LANES; k++) {
            double tail = terms[TERMS - 1].hi[k];
            for (i = TERMS - 2; i >= 9; i--)
                tail = tail * x2[m].hi[k] + terms[i].hi[k];
            two_set_lane(&sum[m], k, pov_two_of(tail, 0.0));
        }
    for (i = 8; i >= 1; i--)
        for (m = 0; m < n; m++)
            for (k = 0; k < TWO_LANES; k++)
                two_set_lane(&sum[m], k,
                             pov_two_add(pov_two_mul(two_lane(&sum[m], k), two_lane(&x2[m], k)), two_lane(&terms[i], k)));
    for (m = 0; m < n; m++)
        for (k = 0; k < TWO_LANES; k++)
            two_set_lane(&sum[m], k, pov_two_mul(two_lane(&sum[m], k), two_lane(&x2[m], k)));
}

static void reduce(sincos_turns *t, const double *degrees, two_lanes *x2)
{
    /* pi/180 in double-double. fmod and the subtraction of a multiple of 90 are exact, so that the reduction is. */
    const pov_two degree = { 0.017453292519943295, 2.9486522708701687e-19 };
    int k;

    memset(x2, 0, sizeof *x2);
    for (k = 0; k < SINCOS_ANGLES; k++) {
        double rest = fabs(degrees[k]) < 360.0 ? degrees[k] : fmod(degrees[k], 360.0);
        pov_two square;
        t->quarter[k] = (int)floor(rest / 90.0 + 0.5);
        t->x[k] = pov_two_mul_double(degree, rest - 90.0 * t->quarter[k]);
        square = pov_two_mul(t->x[k], t->x[k]);
        two_set_lane(x2, k, square);
        two_set_lane(x2, TWO_HALF + k, square);
    }
}

static void finish(sincos_turns *t, const two_lanes *sum)
{
    int k;

    for (k = 0; k < SINCOS_ANGLES; k++) {
        pov_two sine = pov_two_add(t->x[k], pov_two_mul(t->x[k], two_lane(sum, k)));
        pov_two cosine = pov_two_add_double(two_lane(sum, TWO_HALF + k), 1.0), swap = sine;

        if (t->quarter[k] & 1) {
            sine = cosine;
            cosine = pov_two_neg(swap);
        }
        t->sine[k] = t->quarter[k] & 2 ? pov_two_neg(sine) : sine;
        t->cosine[k] = t->quarter[k] & 2 ? pov_two_neg(cosine) : cosine;
    }
}

void sincos_many(sincos_turns *t, const double *const *degrees, int n)
{
    two_lanes x2[SINCOS_MANY], sum[SINCOS_MANY];
    int m;

    for (m = 0; m < n; m++)
        reduce(&t[m], degrees[m], &x2[m]);
    series(x2, sum, n);
    for (m = 0; m < n; m++)
        finish(&t[m], &sum[m]);
}

void transform_sincos(double degrees, double *s, double *c)
{
    const double angles[SINCOS_ANGLES] = { degrees, 0.0, 0.0 }, *all = angles;
    sincos_turns t;

    sincos_many(&t, &all, 1);
    s[0] = t.sine[0].hi;
    s[1] = t.sine[0].lo;
    c[0] = t.cosine[0].hi;
    c[1] = t.cosine[0].lo;
}
