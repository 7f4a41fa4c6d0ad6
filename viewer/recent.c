#define _XOPEN_SOURCE 700   /* realpath */
#include "recent.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The list stands where the XDG base directory specification wants a program's state: at XDG_STATE_HOME, or in
 * .local/state. False: the user has no folder. */
static bool list_path(char *out, size_t size)
{
    const char *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    int length;

    if (state && state[0] == '/')
        length = snprintf(out, size, "%s/povtrace/recent", state);
    else if (home && home[0] == '/')
        length = snprintf(out, size, "%s/.local/state/povtrace/recent", home);
    else
        return false;
    return (size_t)length < size;
}

/* Make the folders of a path, for this user alone as the specification says. */
static void make_folders(char *path)
{
    for (char *at = strchr(path + 1, '/'); at; at = strchr(at + 1, '/')) {
        *at = '\0';
        mkdir(path, 0700);
        *at = '/';
    }
}

static bool is_listed(const recent *r, const char *path)
{
    for (int i = 0; i < r->count; i++)
        if (strcmp(r->paths[i], path) == 0)
            return true;
    return false;
}

static void append(recent *r, const char *path)
{
    if (r->count < RECENT_MOST && strlen(path) < RECENT_PATH && !is_listed(r, path))
        strcpy(r->paths[r->count++], path);
}

static bool is_readable_file(const char *path)
{
    struct stat about;

    return path[0] == '/' && stat(path, &about) == 0 && S_ISREG(about.st_mode) && access(path, R_OK) == 0;
}

/* A line that is longer than a path may be comes in parts. */
void recent_read(recent *r)
{
    char path[RECENT_PATH + 1];
    FILE *f;

    r->count = 0;
    f = list_path(path, sizeof path) ? fopen(path, "r") : NULL;
    if (!f)
        return;
    while (fgets(path, sizeof path, f)) {
        path[strcspn(path, "\n")] = '\0';
        if (is_readable_file(path))
            append(r, path);
    }
    fclose(f);
}

static void write_list(const recent *r)
{
    char path[RECENT_PATH], part[RECENT_PATH + 8];
    bool good = true;
    FILE *f;

    if (!list_path(path, sizeof path))
        return;
    make_folders(path);
    snprintf(part, sizeof part, "%s.part", path);
    f = fopen(part, "w");
    if (!f)
        return;
    for (int i = 0; i < r->count; i++)
        good = fprintf(f, "%s\n", r->paths[i]) > 0 && good;
    good = fclose(f) == 0 && good;
    if (!good || rename(part, path) != 0)
        unlink(part);
}

void recent_add(const char *path)
{
    char *whole = realpath(path, NULL);
    recent before, after;

    if (whole && !strchr(whole, '\n')) {
        recent_read(&before);
        after.count = 0;
        append(&after, whole);
        for (int i = 0; i < before.count; i++)
            append(&after, before.paths[i]);
        write_list(&after);
    }
    free(whole);
}
