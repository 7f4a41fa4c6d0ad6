/* real.h - arithmetic in 512 bits, or as many as are asked for, written as expressions.
 *
 * Every function gives a new number out of a pool; real_reset() takes all back, real_release() those since a mark. MPFR rounds
 * to nearest. */
#ifndef NUMERICS_REAL_H
#define NUMERICS_REAL_H

#include <mpfr.h>
#include <stdbool.h>

typedef mpfr_ptr real;
typedef struct real3 { real x, y, z; } real3;

void real_reset(void);
int real_mark(void);
void real_release(int mark);
void real_copy(real to, real from);
void real_free_all(void);
/* Of all that follow; takes back all that there are. */
void real_precision(int bits);

real real_of(double a);
real real_of2(double hi, double lo);
real real_add(real a, real b);
real real_sub(real a, real b);
real real_mul(real a, real b);
real real_div(real a, real b);
real real_neg(real a);
real real_sqrt(real a);
int real_sign(real a);
int real_compare(real a, real b);
double real_double(real a);

real3 real3_of(real x, real y, real z);
real3 real3_add(real3 a, real3 b);
real3 real3_sub(real3 a, real3 b);
real3 real3_scale(real3 a, real s);
real real3_dot(real3 a, real3 b);
real3 real3_cross(real3 a, real3 b);

#endif
