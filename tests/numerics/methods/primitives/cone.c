#include "numerics/methods/cone.h"

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    pov_vec3 base, top;
    double base_radius, top_radius;

    host->vector(in, &base);
    host->accept(in, ",");
    base_radius = fabs(host->number(in));
    host->accept(in, ",");
    host->vector(in, &top);
    host->accept(in, ",");
    top_radius = fabs(host->number(in));
    cone_make(self, base, base_radius, top, top_radius, host->accept(in, "open"));
}

CONE_CLASS(cone);
