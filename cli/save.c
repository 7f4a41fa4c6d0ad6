#define _XOPEN_SOURCE 700   /* realpath */
#include "save.h"

#include "aov.h"

#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

pov_status save_fail(pov_error *err, pov_status status, const char *file, const char *message)
{
    memset(err, 0, sizeof *err);
    err->status = status;
    snprintf(err->file, sizeof err->file, "%s", file);
    snprintf(err->message, sizeof err->message, "%s", message);
    return status;
}

/* A file that the run writes or reads, and its purpose. */
typedef struct named { const char *path, *what; bool written; } named;

enum { NAMES_MAX = 4 + ARGS_AOVS };

/* The full path; for a missing file that of its folder, and its name. False: no such folder. */
static bool full_path(const char *path, char out[PATH_MAX + NAME_MAX + 2])
{
    const char *slash = strrchr(path, '/');
    char folder[PATH_MAX];

    if (realpath(path, out))
        return true;
    if (snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - path) + 1 : 1, slash ? path : ".") >= PATH_MAX ||
        !realpath(folder, out))
        return false;
    snprintf(out + strlen(out), NAME_MAX + 2, "/%s", slash ? slash + 1 : path);
    return true;
}

/* Devices and pipes accept everything, and nothing in them is replaced. */
static bool is_replaced(const char *path)
{
    struct stat about;

    return strcmp(path, "-") != 0 && (stat(path, &about) != 0 || S_ISREG(about.st_mode));
}

static bool is_same_file(const char *a, const char *b)
{
    char full_a[PATH_MAX + NAME_MAX + 2], full_b[PATH_MAX + NAME_MAX + 2];
    struct stat about_a, about_b;

    if (!is_replaced(a) || !is_replaced(b))
        return false;
    if (stat(a, &about_a) == 0 && stat(b, &about_b) == 0)
        return about_a.st_dev == about_b.st_dev && about_a.st_ino == about_b.st_ino;
    return full_path(a, full_a) && full_path(b, full_b) && strcmp(full_a, full_b) == 0;
}

static void put_name(named *names, int *n, const char *path, const char *what, bool written)
{
    if (!path)
        return;
    names[*n].path = path;
    names[*n].what = what;
    names[(*n)++].written = written;
}

static int list_names(const args *a, const char *checkpoint, named names[NAMES_MAX])
{
    static const char *const maps[ARGS_AOVS] = { "--aov certainty", "--aov normal", "--aov depth", "--aov time", "--aov object",
                                                 "--aov position", "--aov albedo", "--aov alpha" };
    int n = 0;

    put_name(names, &n, a->scene, "the scene", false);
    put_name(names, &n, a->reference, "--reference", false);
    put_name(names, &n, a->output, "the picture", true);
    put_name(names, &n, a->report, "--report", true);
    for (int i = 0; i < ARGS_AOVS; i++)
        put_name(names, &n, aov_is_layer(a, i) ? NULL : a->aov[i], maps[i], true);
    if (checkpoint[0])
        put_name(names, &n, checkpoint, "the checkpoint", true);
    return n;
}

pov_status save_check_names(const args *a, pov_error *err)
{
    char checkpoint[PATH_MAX] = "", text[256];
    named names[NAMES_MAX + 1];
    int n;

    if (a->resume || a->partial_every > 0.0)
        snprintf(checkpoint, sizeof checkpoint, "%s.checkpoint", a->output);
    n = list_names(a, checkpoint, names);
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++) {
            if (!names[j].written || !is_same_file(names[i].path, names[j].path))
                continue;
            snprintf(text, sizeof text, "%s and %s are the same file: nothing is rendered", names[i].what, names[j].what);
            return save_fail(err, POV_E_ARGUMENT, names[j].path, text);
        }
    return POV_OK;
}

bool save_is_awaited(const char *path)
{
    struct stat about;
    int descriptor;

    if (strcmp(path, "-") == 0 || stat(path, &about) != 0 || !S_ISFIFO(about.st_mode))
        return true;
    descriptor = open(path, O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor >= 0)
        close(descriptor);
    return descriptor >= 0;
}
