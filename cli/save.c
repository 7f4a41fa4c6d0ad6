#include "save.h"

#include <errno.h>
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

static pov_status cannot_write(pov_error *err, const char *path, int why)
{
    char text[256];

    snprintf(text, sizeof text, "cannot write: %s", strerror(why));
    return save_fail(err, POV_E_IO, path, text);
}

/* The file is made beside its name and renamed, so it is the folder that must let us write. */
static pov_status check_folder(const char *path, pov_error *err)
{
    const char *slash = strrchr(path, '/');
    char folder[4096];
    size_t length = !slash ? 1 : slash == path ? 1 : (size_t)(slash - path);

    if (length >= sizeof folder)
        return cannot_write(err, path, ENAMETOOLONG);
    memcpy(folder, slash ? path : ".", length);
    folder[length] = '\0';
    return access(folder, W_OK | X_OK) == 0 ? POV_OK : cannot_write(err, path, errno);
}

pov_status save_check(const char *path, pov_error *err)
{
    struct stat about;

    if (strcmp(path, "-") == 0)
        return POV_OK;
    if (stat(path, &about) != 0 || S_ISREG(about.st_mode))
        return check_folder(path, err);
    return S_ISDIR(about.st_mode) ? cannot_write(err, path, EISDIR) : POV_OK;
}

static bool put_all(FILE *to, const void *bytes, size_t count)
{
    bool put = fwrite(bytes, 1, count, to) == count && fflush(to) == 0;

    return put;
}

/* Into a stranger's pipe or device as it is; there is nothing to rename. */
static pov_status save_through(const char *path, const void *bytes, size_t count, pov_error *err)
{
    FILE *to = strcmp(path, "-") == 0 ? stdout : fopen(path, "wb");
    bool put;

    if (!to)
        return cannot_write(err, path, errno);
    put = put_all(to, bytes, count);
    if (to != stdout)
        put = fclose(to) == 0 && put;
    return put ? POV_OK : cannot_write(err, path, errno);
}

/* New files have the rights that any new file would have. */
static void give_rights(int descriptor)
{
    mode_t mask = umask(0);

    umask(mask);
    if (fchmod(descriptor, 0666 & ~mask) != 0)
        return;
}

static pov_status save_beside(const char *path, char *beside, const void *bytes, size_t count, pov_error *err)
{
    int descriptor = mkstemp(beside), why;
    FILE *to = descriptor >= 0 ? fdopen(descriptor, "wb") : NULL;
    bool put;

    if (!to) {
        why = errno;
        if (descriptor >= 0) {
            close(descriptor);
            unlink(beside);
        }
        return cannot_write(err, path, why);
    }
    give_rights(descriptor);
    put = put_all(to, bytes, count);
    put = fclose(to) == 0 && put;
    if (put && rename(beside, path) == 0)
        return POV_OK;
    why = errno;
    unlink(beside);
    return cannot_write(err, path, why);
}

pov_status save_bytes(const char *path, const void *bytes, size_t count, pov_error *err)
{
    struct stat about;
    char beside[4096];

    if (strcmp(path, "-") == 0 || (stat(path, &about) == 0 && !S_ISREG(about.st_mode)))
        return save_through(path, bytes, count, err);
    if ((size_t)snprintf(beside, sizeof beside, "%s.XXXXXX", path) >= sizeof beside)
        return cannot_write(err, path, ENAMETOOLONG);
    return save_beside(path, beside, bytes, count, err);
}
