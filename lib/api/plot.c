#include "api/adapt.h"
#include "api/handles.h"

#include <povtrace/plot.h>

static pov_status find(pov_context *context, const char *ending, const pov_plot_format **out, pov_error *err)
{
    pov_status status;

    if (!context || !ending)
        return err_set(err, POV_E_ARGUMENT, "a plot needs a context and an ending");
    status = registry_plot(context->plugins, ending, out, err);
    if (status == POV_OK && !*out)
        return err_set(err, POV_E_PLUGIN, "no plugin draws plots of the ending \".%s\"; searched plots/ in %s", ending,
                       registry_path(context->plugins));
    return status;
}

pov_status pov_plot_check(pov_context *context, const char *ending, pov_error *err)
{
    const pov_plot_format *format;

    return find(context, ending, &format, err);
}

pov_status pov_plot_put(pov_context *context, const char *ending, const pov_plot *plot, const pov_output *output,
                        pov_error *err)
{
    const pov_plot_format *format;
    const char *wrong;
    pov_plot ours;
    pov_status status = find(context, ending, &format, err);

    if (status < 0)
        return status;
    if (!plot || !output)
        return err_set(err, POV_E_ARGUMENT, "to draw takes a plot and an output");
    status = adapt_in(&ours, sizeof ours, plot, "the plot", err);
    if (status < 0)
        return status;
    if (ours.width < 1 || ours.height < 1 || !ours.panels || ours.panel_count < 1)
        return err_set(err, POV_E_ARGUMENT, "a plot needs a size and a panel");
    wrong = format->draw(&ours, output);
    return wrong ? err_set(err, POV_E_IO, "cannot draw this plot: %s", wrong) : POV_OK;
}
