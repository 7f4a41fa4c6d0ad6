/* realpath() is XSI's. */
#define _XOPEN_SOURCE 700

#include "base/file.h"

#include "base/err.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- reading ---- */

/* No honest file is larger, and an endless one would take all memory. */
static const size_t LARGEST = (size_t)1 << 30;

static pov_status fail_large(const char *path, size_t most, pov_error *err)
{
    if (most == LARGEST)
        return err_file(err, POV_E_IO, path, "is larger than 1 GiB, which is as much as is read");
    return err_file(err, POV_E_IO, path, "is larger than the %zu bytes that may still be read", most);
}

/* Read to the end into a growing block that keeps one byte to spare. */
static pov_status read_all(const env *e, int descriptor, const char *path, size_t guess, size_t most, char **bytes,
                           size_t *count, pov_error *err)
{
    size_t size = guess + 1, used = 0;
    char *block = env_resize(e, NULL, size, 1), *grown;
    ssize_t got;

    if (!block)
        return err_memory(err);
    while ((got = read(descriptor, block + used, size - used)) != 0) {
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0) {
            env_free(e, block);
            return err_file(err, POV_E_IO, path, "cannot read: %s", strerror(errno));
        }
        used += (size_t)got;
        if (used > most) {
            env_free(e, block);
            return fail_large(path, most, err);
        }
        if (used < size)
            continue;
        grown = size <= SIZE_MAX / 2 ? env_resize(e, block, 2 * size, 1) : NULL;
        if (!grown) {
            env_free(e, block);
            return err_memory(err);
        }
        block = grown;
        size *= 2;
    }
    block[used] = '\0';
    *bytes = block;
    *count = used;
    return POV_OK;
}

pov_status file_read(const env *e, const char *path, char **bytes, size_t *count, pov_error *err)
{
    return file_read_most(e, path, LARGEST, bytes, count, err);
}

pov_status file_read_most(const env *e, const char *path, size_t most, char **bytes, size_t *count, pov_error *err)
{
    bool standard_input = strcmp(path, "-") == 0;
    int descriptor = standard_input ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    struct stat about;
    pov_status status;
    size_t guess = 4095;

    *bytes = NULL;
    *count = 0;
    if (descriptor < 0)
        return err_file(err, POV_E_IO, path, "cannot open: %s", strerror(errno));
    if (fstat(descriptor, &about) < 0)
        status = err_file(err, POV_E_IO, path, "cannot read: %s", strerror(errno));
    else if (S_ISDIR(about.st_mode))
        status = err_file(err, POV_E_IO, path, "is a folder, not a file");
    else if (S_ISREG(about.st_mode) && about.st_size > 0 && (uintmax_t)about.st_size > most)
        status = fail_large(path, most, err);
    else {
        if (S_ISREG(about.st_mode) && about.st_size > 0)
            guess = (size_t)about.st_size;
        status = read_all(e, descriptor, path, guess, most, bytes, count, err);
    }
    if (!standard_input)
        close(descriptor);
    return status;
}

/* ---- folders ---- */

void file_list(const char *folder, void (*visit)(void *user, const char *name), void *user)
{
    DIR *d = opendir(folder);
    struct dirent *entry;

    if (!d)
        return;
    while ((entry = readdir(d)) != NULL)
        visit(user, entry->d_name);
    closedir(d);
}

bool file_exists(const char *path)
{
    return access(path, F_OK) == 0;
}

bool file_is_link(const char *path)
{
    struct stat about;

    return lstat(path, &about) == 0 && S_ISLNK(about.st_mode);
}

bool file_resolve(const char *path, char *out, size_t size)
{
    char resolved[PATH_MAX];
    bool fits = realpath(path, resolved) && strlen(resolved) < size;

    if (fits)
        strcpy(out, resolved);
    return fits;
}
