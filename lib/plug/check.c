#include "plug/check.h"

/* Members that abi 1 has from its start: a plugin whose struct is shorter was not built from this contract. */
#define REACHES(ptr, type, last) ((ptr)->size >= offsetof(type, last) + sizeof((ptr)->last))

static const char *check_shape(const pov_shape_class *c)
{
    if (!REACHES(c, pov_shape_class, prepare))
        return "a shape class is shorter than the contract's first version";
    if (!c->keyword || !c->keyword[0])
        return "a shape class has no keyword";
    if (c->instance_size == 0 || c->instance_size > (1u << 20))
        return "a shape class has an impossible instance size";
    if (!c->parse || !c->bounds || !c->intersect || !c->normal)
        return "a shape class lacks parse, bounds, intersect or normal";
    if ((c->flags & POV_SHAPE_SOLID) && !c->inside)
        return "a shape class is a solid without inside";
    if (c->block_filter && (!c->block_pack || c->block_size == 0))
        return "a shape class has a block filter without block_pack or block_size";
    if (REACHES(c, pov_shape_class, lone_block_size) && c->lone_block_size > c->block_size)
        return "a shape class has a larger block for one shape than for several";
    if (c->prepare && (c->text_size == 0 || c->text_size > (1u << 20) || c->instance_size > POV_PREPARED_MAX))
        return "a shape class has prepare with an impossible size";
    return NULL;
}

static const char *check_image(const pov_image_format *f)
{
    if (!REACHES(f, pov_image_format, write))
        return "an image format is shorter than the contract's first version";
    if (!f->ending || !f->ending[0] || !f->write)
        return "an image format lacks its ending or write";
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

const pov_plot_format *const *check_plots(const pov_plugin *plugin)
{
    return REACHES(plugin, pov_plugin, plots) ? plugin->plots : NULL;
}

const char *check_plugin(const pov_plugin *plugin)
{
    const char *wrong = NULL;
    size_t i;

    if (plugin->abi != POV_PLUGIN_ABI)
        return "it was built for another version of the plugin contract";
    if (!REACHES(plugin, pov_plugin, images) || !plugin->name || !plugin->version)
        return "its description is incomplete";
    if (!plugin->shapes && !plugin->images && !check_plots(plugin))
        return "it offers nothing";
    for (i = 0; !wrong && plugin->shapes && plugin->shapes[i]; i++)
        wrong = check_shape(plugin->shapes[i]);
    for (i = 0; !wrong && plugin->images && plugin->images[i]; i++)
        wrong = check_image(plugin->images[i]);
    for (i = 0; !wrong && check_plots(plugin) && check_plots(plugin)[i]; i++)
        wrong = check_plot(check_plots(plugin)[i]);
    return wrong;
}
