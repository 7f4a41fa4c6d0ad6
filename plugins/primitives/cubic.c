/* cubic { <20 coefficients> [sturm] } */
#include "common/polynomial.h"

static void parse(void *self, const pov_host *host, pov_reader *in) { common_polynomial_read(self, host, in, 3); }

COMMON_POLYNOMIAL_CLASS(cubic, parse);
