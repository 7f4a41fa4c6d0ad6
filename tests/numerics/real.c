#include "numerics/real.h"

#include <stdlib.h>

enum { POOL = 1 << 16 };

static mpfr_t pool[POOL];
static int used, made, bits = 512;

static real fresh(void)
{
    if (used == POOL)
        abort();
    if (used == made)
        mpfr_init2(pool[made++], bits);
    return pool[used++];
}

void real_reset(void) { used = 0; }
int real_mark(void) { return used; }
void real_release(int mark) { used = mark; }
void real_copy(real to, real from) { mpfr_set(to, from, MPFR_RNDN); }

void real_precision(int wanted)
{
    real_free_all();
    bits = wanted;
}

void real_free_all(void)
{
    while (made > 0)
        mpfr_clear(pool[--made]);
    used = 0;
    mpfr_free_cache();
}

real real_of(double a)
{
    real r = fresh();

    mpfr_set_d(r, a, MPFR_RNDN);
    return r;
}

real real_of2(double hi, double lo)
{
    real r = real_of(hi);

    mpfr_add_d(r, r, lo, MPFR_RNDN);
    return r;
}

real real_add(real a, real b)
{
    real r = fresh();

    mpfr_add(r, a, b, MPFR_RNDN);
    return r;
}

real real_sub(real a, real b)
{
    real r = fresh();

    mpfr_sub(r, a, b, MPFR_RNDN);
    return r;
}

real real_mul(real a, real b)
{
    real r = fresh();

    mpfr_mul(r, a, b, MPFR_RNDN);
    return r;
}

real real_div(real a, real b)
{
    real r = fresh();

    mpfr_div(r, a, b, MPFR_RNDN);
    return r;
}

real real_neg(real a)
{
    real r = fresh();

    mpfr_neg(r, a, MPFR_RNDN);
    return r;
}

real real_sqrt(real a)
{
    real r = fresh();

    mpfr_sqrt(r, a, MPFR_RNDN);
    return r;
}

int real_sign(real a) { return mpfr_sgn(a); }
int real_compare(real a, real b) { return mpfr_cmp(a, b); }
double real_double(real a) { return mpfr_get_d(a, MPFR_RNDN); }

real3 real3_of(real x, real y, real z)
{
    real3 r = { x, y, z };
    return r;
}

real3 real3_add(real3 a, real3 b)
{
    return real3_of(real_add(a.x, b.x), real_add(a.y, b.y), real_add(a.z, b.z));
}
real3 real3_sub(real3 a, real3 b)
{
    return real3_of(real_sub(a.x, b.x), real_sub(a.y, b.y), real_sub(a.z, b.z));
}
real3 real3_scale(real3 a, real s) { return real3_of(real_mul(a.x, s), real_mul(a.y, s), real_mul(a.z, s)); }

real real3_dot(real3 a, real3 b)
{
    return real_add(real_add(real_mul(a.x, b.x), real_mul(a.y, b.y)), real_mul(a.z, b.z));
}

real3 real3_cross(real3 a, real3 b)
{
    return real3_of(real_sub(real_mul(a.y, b.z), real_mul(a.z, b.y)), real_sub(real_mul(a.z, b.x), real_mul(a.x, b.z)),
                    real_sub(real_mul(a.x, b.y), real_mul(a.y, b.x)));
}
