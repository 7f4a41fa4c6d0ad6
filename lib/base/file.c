#include "base/file.h"

#include "base/err.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- reading ---- */

/* Read to the end into a growing block that keeps one byte to spare. */
static pov_status read_all(const env *e, int descriptor, const char *path, size_t guess, char **bytes, size_t *count,
                           pov_error *err)
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
    else {
        if (S_ISREG(about.st_mode) && about.st_size > 0)
            guess = (size_t)about.st_size;
        status = read_all(e, descriptor, path, guess, bytes, count, err);
    }
    if (!standard_input)
        close(descriptor);
    return status;
}

/* ---- replacing ---- */

static char *copy_text(const env *e, const char *text)
{
    size_t bytes = strlen(text) + 1;
    char *copy = env_alloc(e, bytes, 1);

    if (copy)
        memcpy(copy, text, bytes);
    return copy;
}

/* Create a file beside the target, under a name that nothing has; with the old file's mode, if there is one. */
static bool open_beside(file_writer *w, const struct stat *old)
{
    size_t size = strlen(w->path) + 48;
    int attempt;

    w->temporary = env_alloc(w->env, size, 1);
    if (!w->temporary) {
        w->error = ENOMEM;
        return false;
    }
    for (attempt = 0; attempt < 1000 && w->descriptor < 0; attempt++) {
        snprintf(w->temporary, size, "%s.%ld-%d.part", w->path, (long)getpid(), attempt);
        w->descriptor = open(w->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (w->descriptor < 0 && errno != EEXIST)
            break;
    }
    if (w->descriptor < 0) {
        w->error = errno;
        env_free(w->env, w->temporary);
        w->temporary = NULL;
        return false;
    }
    if (old)
        fchmod(w->descriptor, old->st_mode & 07777);
    return true;
}

pov_status file_writer_open(file_writer *w, const env *e, const char *path, pov_error *err)
{
    struct stat about;
    bool exists, ok;

    memset(w, 0, offsetof(file_writer, buffer));
    w->env = e;
    w->descriptor = -1;
    w->path = copy_text(e, path);
    if (!w->path)
        return err_memory(err);
    if (strcmp(path, "-") == 0) {
        w->descriptor = STDOUT_FILENO;
        return POV_OK;
    }
    exists = stat(path, &about) == 0;
    if (exists && !S_ISREG(about.st_mode)) {
        /* A device or a pipe cannot be replaced by renaming. */
        w->descriptor = S_ISDIR(about.st_mode) ? (errno = EISDIR, -1) : open(path, O_WRONLY | O_CLOEXEC);
        ok = w->descriptor >= 0;
        w->error = ok ? 0 : errno;
    } else {
        ok = open_beside(w, exists ? &about : NULL);
    }
    if (ok)
        return POV_OK;
    env_free(e, w->path);
    w->path = NULL;
    if (w->error == ENOMEM)
        return err_memory(err);
    return err_file(err, POV_E_IO, path, "cannot write: %s", strerror(w->error));
}

static void write_out(file_writer *w, const unsigned char *bytes, size_t count)
{
    while (count > 0 && w->error == 0) {
        ssize_t put = write(w->descriptor, bytes, count);
        if (put < 0) {
            if (errno != EINTR)
                w->error = errno;
            continue;
        }
        bytes += put;
        count -= (size_t)put;
    }
}

bool file_writer_put(file_writer *w, const void *bytes, size_t count)
{
    if (count > sizeof w->buffer - w->used) {
        write_out(w, w->buffer, w->used);
        w->used = 0;
    }
    if (count > sizeof w->buffer) {
        write_out(w, bytes, count);
    } else {
        memcpy(w->buffer + w->used, bytes, count);
        w->used += count;
    }
    return w->error == 0;
}

static void close_writer(file_writer *w)
{
    if (w->descriptor >= 0 && w->descriptor != STDOUT_FILENO && close(w->descriptor) < 0 && w->error == 0)
        w->error = errno;
    w->descriptor = -1;
}

static void forget(file_writer *w)
{
    env_free(w->env, w->temporary);
    env_free(w->env, w->path);
    w->temporary = w->path = NULL;
}

pov_status file_writer_commit(file_writer *w, pov_error *err)
{
    pov_status status = POV_OK;

    write_out(w, w->buffer, w->used);
    close_writer(w);
    if (w->temporary && w->error == 0 && rename(w->temporary, w->path) < 0)
        w->error = errno;
    if (w->error != 0) {
        status = err_file(err, POV_E_IO, w->path, "cannot write: %s", strerror(w->error));
        if (w->temporary)
            unlink(w->temporary);
    }
    forget(w);
    return status;
}

void file_writer_discard(file_writer *w)
{
    close_writer(w);
    if (w->temporary)
        unlink(w->temporary);
    forget(w);
}

/* ---- folders ---- */

void file_list(const char *folder, void (*see)(void *user, const char *name), void *user)
{
    DIR *d = opendir(folder);
    struct dirent *entry;

    if (!d)
        return;
    while ((entry = readdir(d)) != NULL)
        see(user, entry->d_name);
    closedir(d);
}

bool file_exists(const char *path)
{
    return access(path, F_OK) == 0;
}
