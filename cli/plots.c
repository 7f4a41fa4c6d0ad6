#include "plots.h"

bool plots_put_bytes(void *user, const void *bytes, size_t count)
{
    return fwrite(bytes, 1, count, user) == count;
}

pov_status plots_put(pov_context *context, const char *ending, const pov_plot *plot, FILE *to, pov_error *err)
{
    pov_output output = { to, plots_put_bytes };

    return pov_plot_put(context, ending, plot, &output, err);
}
