/* registry.h - plugins by keyword, found and loaded at first use. Any thread. */
#ifndef PLUG_REGISTRY_H
#define PLUG_REGISTRY_H

#include "base/env.h"
#include "plug/shape_class.h"

typedef struct registry registry;

/* path: folders, colon separated, each with primitives/ and images/ in it; NULL, or behind a colon at its end: the
 * environment's, else povtrace/ beside the library, else the configured folder. */
registry *registry_create(const env *e, const char *path, pov_error *err);
void registry_destroy(registry *r);

/* A plugin that the program adds; it is checked like a loaded one. */
pov_status registry_add(registry *r, const pov_plugin *plugin, pov_error *err);

/* The class of a keyword. *out is NULL and the status POV_OK when no folder has such a plugin. A plugin that exists and
 * cannot be used is POV_E_PLUGIN, with the path and the reason. Only words of a-z, 0-9 and _ are searched for. */
pov_status registry_shape(registry *r, const char *keyword, const shape_class **out, pov_error *err);
pov_status registry_plot(registry *r, const char *ending, const struct pov_plot_format **out, pov_error *err);
pov_status registry_image(registry *r, const char *ending, const struct pov_image_format **out, pov_error *err);

/* For messages: the searched folders, colon separated; and the keywords that could be loaded (kind: "primitives" or
 * "images"). */
const char *registry_path(const registry *r);
void registry_each_keyword(const registry *r, const char *kind, void (*visit)(void *user, const char *keyword),
                           void *user);

/* The index-th plugin in use. */
bool registry_get(registry *r, size_t index, const char **name, const char **path);

#endif
