#include "plug/check.h"

#include "plug/shape_class.h"

#include <povtrace/image.h>
#include <povtrace/plot.h>

/* Members that abi 4 has from its start: a plugin whose struct is shorter was not built from this contract. */
#define REACHES(ptr, type, last) ((ptr)->size >= offsetof(type, last) + sizeof((ptr)->last))

static const char *check_image(const pov_image_format *f)
{
    if (!REACHES(f, pov_image_format, write))
        return "an image format is shorter than the contract's first version";
    if (!f->ending || !f->ending[0] || (!f->write && !(REACHES(f, pov_image_format, load) && f->load)))
        return "an image format lacks its ending, or can neither be written nor loaded";
    if ((f->depths & (POV_IMAGE_8 | POV_IMAGE_16 | POV_IMAGE_FLOAT)) == 0)
        return "an image format holds no depth that is known";
    return NULL;
}

static const char *check_plot(const pov_plot_format *f)
{
    if (!REACHES(f, pov_plot_format, draw) || !f->ending || !f->ending[0] || !f->draw)
        return "a plot format lacks its ending or draw";
    return NULL;
}

const char *check_plugin(const pov_plugin *plugin)
{
    const char *wrong = NULL;
    size_t i;

    if (plugin->abi != POV_PLUGIN_ABI)
        return "it was built for another version of the plugin contract";
    if (!REACHES(plugin, pov_plugin, plots) || !plugin->name || !plugin->version)
        return "its description is incomplete";
    if (!plugin->shapes && !plugin->images && !plugin->plots)
        return "it offers nothing";
    for (i = 0; !wrong && plugin->shapes && plugin->shapes[i]; i++)
        wrong = shape_class_check(plugin->shapes[i]);
    for (i = 0; !wrong && plugin->images && plugin->images[i]; i++)
        wrong = check_image(plugin->images[i]);
    for (i = 0; !wrong && plugin->plots && plugin->plots[i]; i++)
        wrong = check_plot(plugin->plots[i]);
    return wrong;
}
