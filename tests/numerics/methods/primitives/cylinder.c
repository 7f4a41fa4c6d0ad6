#include "numerics/methods/cone.h"

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    pov_vec3 base, top;
    double radius;

    host->vector(in, &base);
    host->accept(in, ",");
    host->vector(in, &top);
    host->accept(in, ",");
    radius = fabs(host->number(in));
    cone_make(self, base, radius, top, radius, host->accept(in, "open"));
}

CONE_CLASS(cylinder);
