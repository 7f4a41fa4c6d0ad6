#define _GNU_SOURCE   /* secure_getenv */
#include "plug/registry.h"

#include "base/dl.h"
#include "base/err.h"
#include "base/file.h"
#include "base/map.h"
#include "base/str.h"
#include "base/thread.h"
#include "base/vec.h"
#include "plug/check.h"

#include <povtrace/image.h>
#include <povtrace/plot.h>

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct loaded {
    void *handle;                /* NULL for a plugin that the program added */
    char *path;
    const pov_plugin *plugin;
    shape_class *shapes;         /* its shapes, complete; NULL: it has none */
} loaded;

struct registry {
    const env *env;
    char *path;
    mutex lock;                  /* guards all below */
    struct { loaded *items; size_t count, capacity; } plugins;
    map shapes, images, plots;   /* by keyword, by ending */
};

static const char shape_folder[] = "primitives";
static const char image_folder[] = "images";
static const char plot_folder[] = "plots";

/* ---- making ---- */

static void default_path(char *text, size_t size)
{
    const char *given = secure_getenv("POVTRACE_PLUGIN_PATH");
    char own[PATH_MAX], folder[PATH_MAX + 16] = "";

    if (dl_own_folder(own, sizeof own))
        snprintf(folder, sizeof folder, "%s/povtrace", own);
    if (given && given[0])
        str_copy(text, size, given);
    else if (folder[0] && strcmp(folder, POV_PLUGIN_DIR) != 0)
        snprintf(text, size, "%s:%s", folder, POV_PLUGIN_DIR);
    else
        str_copy(text, size, POV_PLUGIN_DIR);
}

/* The folders as given, the standard ones, or both. NULL: no memory. */
static char *search_path(const env *e, const char *path)
{
    char standard[2 * PATH_MAX + 32] = "", *all;
    const size_t length = path ? strlen(path) : 0;

    if (length == 0 ? !path : path[length - 1] == ':')
        default_path(standard, sizeof standard);
    all = env_alloc(e, length + strlen(standard) + 1, 1);
    if (all)
        sprintf(all, "%s%s", path ? path : "", standard);
    return all;
}

registry *registry_create(const env *e, const char *path, pov_error *err)
{
    registry *r = env_alloc(e, 1, sizeof *r);

    if (!r) {
        err_memory(err);
        return NULL;
    }
    r->env = e;
    map_init(&r->shapes, e);
    map_init(&r->images, e);
    map_init(&r->plots, e);
    r->path = search_path(e, path);
    if (r->path && mutex_init(&r->lock))
        return r;
    env_free(e, r->path);
    env_free(e, r);
    err_memory(err);
    return NULL;
}

static void unload(registry *r, loaded *l)
{
    if (l->handle)
        dl_close(l->handle);
    env_free(r->env, l->shapes);
    env_free(r->env, l->path);
}

void registry_destroy(registry *r)
{
    size_t i;

    if (!r)
        return;
    for (i = r->plugins.count; i-- > 0;)
        unload(r, &r->plugins.items[i]);
    env_free(r->env, r->plugins.items);
    map_free(&r->shapes);
    map_free(&r->images);
    map_free(&r->plots);
    mutex_destroy(&r->lock);
    env_free(r->env, r->path);
    env_free(r->env, r);
}

/* ---- adding; the lock is held ---- */

/* The tables hold void *; the classes behind it stay const. */
static bool put(map *m, const char *name, const void *value)
{
    union { const void *constant; void *plain; } both;

    both.constant = value;
    return map_put(m, name, both.plain);
}

static bool complete_shapes(registry *r, loaded *l)
{
    const pov_plugin *p = l->plugin;
    size_t n = 0, i;

    while (p->shapes && p->shapes[n])
        n++;
    l->shapes = n > 0 ? env_alloc(r->env, n, sizeof *l->shapes) : NULL;
    for (i = 0; l->shapes && i < n; i++)
        shape_class_fill(&l->shapes[i], p->shapes[i]);
    return l->shapes || n == 0;
}

static pov_status enter(registry *r, loaded *l, pov_error *err)
{
    const pov_plugin *p = l->plugin;
    size_t i;

    if (!complete_shapes(r, l))
        return err_memory(err);
    for (i = 0; p->shapes && p->shapes[i]; i++)
        if (!put(&r->shapes, p->shapes[i]->keyword, &l->shapes[i]))
            return err_memory(err);
    for (i = 0; p->images && p->images[i]; i++)
        if (!put(&r->images, p->images[i]->ending, p->images[i]))
            return err_memory(err);
    for (i = 0; p->plots && p->plots[i]; i++)
        if (!put(&r->plots, p->plots[i]->ending, p->plots[i]))
            return err_memory(err);
    return POV_OK;
}

/* A plugin that was entered in part must not be found again. Replacing a value takes no memory. */
static void withdraw(registry *r, const loaded *l)
{
    const pov_plugin *p = l->plugin;
    size_t i;

    for (i = 0; p->shapes && p->shapes[i]; i++)
        if (map_get(&r->shapes, p->shapes[i]->keyword))
            put(&r->shapes, p->shapes[i]->keyword, NULL);
    for (i = 0; p->images && p->images[i]; i++)
        if (map_get(&r->images, p->images[i]->ending))
            put(&r->images, p->images[i]->ending, NULL);
    for (i = 0; p->plots && p->plots[i]; i++)
        if (map_get(&r->plots, p->plots[i]->ending))
            put(&r->plots, p->plots[i]->ending, NULL);
}

static pov_status add(registry *r, loaded *l, pov_error *err)
{
    const char *wrong = check_plugin(l->plugin);

    if (wrong && l->path)
        return err_file(err, POV_E_PLUGIN, l->path, "cannot use this plugin: %s", wrong);
    if (wrong)
        return err_set(err, POV_E_PLUGIN, "cannot use this plugin: %s", wrong);
    if (!vec_reserve(r->env, (void **)&r->plugins.items, &r->plugins.capacity, r->plugins.count, sizeof *l))
        return err_memory(err);
    if (enter(r, l, err) < 0) {
        withdraw(r, l);
        return POV_E_MEMORY;
    }
    r->plugins.items[r->plugins.count++] = *l;
    return POV_OK;
}

static pov_status load(registry *r, const char *path, pov_error *err)
{
    loaded l = { NULL, NULL, NULL, NULL };
    char why[256];
    pov_status status;

    l.path = env_alloc(r->env, strlen(path) + 1, 1);
    if (!l.path)
        return err_memory(err);
    strcpy(l.path, path);
    l.handle = dl_open(path, why, sizeof why);
    if (!l.handle) {
        status = err_file(err, POV_E_PLUGIN, path, "cannot load this plugin: %s", why);
    } else {
        l.plugin = dl_data(l.handle, POV_PLUGIN_SYMBOL);
        status = l.plugin ? add(r, &l, err)
                          : err_file(err, POV_E_PLUGIN, path, "cannot use this plugin: it has no symbol %s",
                                     POV_PLUGIN_SYMBOL);
    }
    if (status < 0)
        unload(r, &l);
    return status;
}

pov_status registry_add(registry *r, const pov_plugin *plugin, pov_error *err)
{
    loaded l = { NULL, NULL, plugin, NULL };
    pov_status status;

    if (!plugin)
        return err_set(err, POV_E_ARGUMENT, "no plugin was given");
    mutex_lock(&r->lock);
    status = add(r, &l, err);
    if (status < 0)
        env_free(r->env, l.shapes);
    mutex_unlock(&r->lock);
    return status;
}

/* ---- finding ---- */

static bool is_name(const char *word)
{
    size_t n = strspn(word, "abcdefghijklmnopqrstuvwxyz0123456789_");

    return n > 0 && n < 64 && word[n] == '\0';
}

/* The next folder of a colon-separated path; NULL at its end. */
static const char *next_folder(const char *path, char *out, size_t size)
{
    size_t n;

    path += strspn(path, ":");
    n = strcspn(path, ":");
    if (n == 0)
        return NULL;
    snprintf(out, size, "%.*s", (int)(n < size ? n : size - 1), path);
    return path + n;
}

/* Is there <folder>/<kind>/<name>.so, or the same in the sub-folder for the processors that this copy of the library was
 * compiled for? */
static bool is_in(const char *folder, const char *kind, const char *name, char path[PATH_MAX + 128])
{
    if (dl_wide()[0]) {
        snprintf(path, PATH_MAX + 128, "%s/%s/%s/%s.so", folder, kind, dl_wide(), name);
        if (file_exists(path))
            return true;
    }
    snprintf(path, PATH_MAX + 128, "%s/%s/%s.so", folder, kind, name);
    return file_exists(path);
}

/* Load it from the first folder that has it; the path stays empty when none has. */
static pov_status find(registry *r, const char *kind, const char *name, char path[PATH_MAX + 128], pov_error *err)
{
    char folder[PATH_MAX];
    const char *rest = r->path;

    while ((rest = next_folder(rest, folder, sizeof folder)) != NULL) {
        if (is_in(folder, kind, name, path))
            return load(r, path, err);
    }
    path[0] = '\0';
    return POV_OK;
}

/* Look `name` up in the map; else load it from the file called `file`. */
static pov_status look_up(registry *r, map *m, const char *kind, const char *file, const char *name, const void **out,
                          pov_error *err)
{
    char path[PATH_MAX + 128] = "";
    pov_status status = POV_OK;

    *out = NULL;
    if (!is_name(name) || !is_name(file))
        return POV_OK;
    mutex_lock(&r->lock);
    *out = map_get(m, name);
    if (!*out) {
        status = find(r, kind, file, path, err);
        if (status == POV_OK)
            *out = map_get(m, name);
        if (status == POV_OK && !*out && path[0])
            status = err_file(err, POV_E_PLUGIN, path, "this plugin does not offer \"%s\"", name);
    }
    mutex_unlock(&r->lock);
    return status;
}

pov_status registry_shape(registry *r, const char *keyword, const shape_class **out, pov_error *err)
{
    const void *found;
    pov_status status = look_up(r, &r->shapes, shape_folder, keyword, keyword, &found, err);

    *out = found;
    return status;
}

/* The name of a format that has several endings. */
static const char *format_of(const char *ending)
{
    static const char *const same[][2] = { { "jpg", "jpeg" }, { "jpe", "jpeg" }, { "tif", "tiff" }, { "pgm", "ppm" } };

    for (size_t i = 0; i < sizeof same / sizeof same[0]; i++)
        if (strcmp(ending, same[i][0]) == 0)
            return same[i][1];
    return ending;
}

pov_status registry_image(registry *r, const char *ending, const pov_image_format **out, pov_error *err)
{
    const char *format = format_of(ending);
    /* A POT is a GIF whose bytes mean otherwise. */
    const char *file = strcmp(format, "pot") == 0 ? "gif" : format;
    const void *found;
    pov_status status = look_up(r, &r->images, image_folder, file, format, &found, err);

    *out = found;
    return status;
}

/* One plugin draws all formats: a library that draws one draws the others too. */
pov_status registry_plot(registry *r, const char *ending, const pov_plot_format **out, pov_error *err)
{
    const void *found;
    pov_status status = look_up(r, &r->plots, plot_folder, "plot", ending, &found, err);

    *out = found;
    return status;
}

/* ---- for messages ---- */

const char *registry_path(const registry *r)
{
    return r->path;
}

typedef struct sieve {
    void (*visit)(void *user, const char *keyword);
    void *user;
} sieve;

static void visit_file(void *user, const char *name)
{
    const sieve *s = user;
    size_t n = strlen(name);
    char keyword[64];

    if (n <= 3 || n - 3 >= sizeof keyword || strcmp(name + n - 3, ".so") != 0)
        return;
    memcpy(keyword, name, n - 3);
    keyword[n - 3] = '\0';
    s->visit(s->user, keyword);
}

void registry_each_keyword(const registry *r, const char *kind, void (*visit)(void *user, const char *keyword),
                           void *user)
{
    char folder[PATH_MAX], path[PATH_MAX + 32];
    const char *rest = r->path;
    sieve s = { visit, user };

    while ((rest = next_folder(rest, folder, sizeof folder)) != NULL) {
        snprintf(path, sizeof path, "%s/%s", folder, kind);
        file_list(path, visit_file, &s);
    }
}

bool registry_get(registry *r, size_t index, const char **name, const char **path)
{
    bool there;

    mutex_lock(&r->lock);
    there = index < r->plugins.count;
    if (there) {
        *name = r->plugins.items[index].plugin->name;
        *path = r->plugins.items[index].path ? r->plugins.items[index].path : "";
    }
    mutex_unlock(&r->lock);
    return there;
}
