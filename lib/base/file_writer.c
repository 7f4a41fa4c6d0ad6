#define _XOPEN_SOURCE 700   /* kill, fsync and PATH_MAX beside what POSIX 2008 has */
#include "base/file.h"

#include "base/err.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { LINKS_MOST = 40, NAMES_MOST = 1000 };
/* A temporary file of a process that is gone counts as lost after so many seconds. Processes of other machines cannot
 * be looked up, but finish their files sooner. */
enum { LOST_AFTER = 3600 };

/* ---- where a path leads ---- */

/* Descriptor that a name such as /dev/stdout or /dev/fd/3 stands for, or -1. */
static int standing_for(const char *path)
{
    static const char *const folders[] = { "/dev/fd/", "/proc/self/fd/" };
    char *end;
    long number;

    if (strcmp(path, "-") == 0 || strcmp(path, "/dev/stdout") == 0)
        return STDOUT_FILENO;
    if (strcmp(path, "/dev/stderr") == 0)
        return STDERR_FILENO;
    for (size_t i = 0; i < sizeof folders / sizeof folders[0]; i++) {
        const size_t n = strlen(folders[i]);

        if (strncmp(path, folders[i], n) != 0 || path[n] < '0' || path[n] > '9')
            continue;
        number = strtol(path + n, &end, 10);
        return *end == '\0' && number <= INT_MAX ? (int)number : -1;
    }
    return -1;
}

/* Target of a link at `path`, as a path of its own. False: errno. */
static bool read_link(char path[PATH_MAX])
{
    char to[PATH_MAX], *slash = strrchr(path, '/');
    ssize_t n = readlink(path, to, sizeof to - 1);
    size_t folder = slash ? (size_t)(slash - path) + 1 : 0;

    if (n < 0)
        return false;
    to[n] = '\0';
    if (to[0] == '/')
        folder = 0;
    if (folder + (size_t)n >= PATH_MAX) {
        errno = ENAMETOOLONG;
        return false;
    }
    memcpy(path + folder, to, (size_t)n + 1);
    return true;
}

/* Follow links to the place of a file that exists or will be made. *descriptor: the descriptor that the name stands
 * for, or -1. False: errno. */
static bool resolve(const char *path, char out[PATH_MAX], int *descriptor)
{
    struct stat about;
    int links;

    if (strlen(path) >= PATH_MAX) {
        errno = ENAMETOOLONG;
        return false;
    }
    strcpy(out, path);
    for (links = 0; links < LINKS_MOST; links++) {
        *descriptor = standing_for(out);
        if (*descriptor >= 0 || lstat(out, &about) != 0 || !S_ISLNK(about.st_mode))
            return true;
        if (!read_link(out))
            return false;
    }
    errno = ELOOP;
    return false;
}

/* ---- the file beside it ---- */

static size_t folder_length(const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash ? (size_t)(slash - path) + 1 : 0;
}

/* The temporary file's name holds as much of the target's as fits. */
static void name_beside(const char *path, int attempt, char *out, size_t size)
{
    const size_t folder = folder_length(path);
    const int buffer = 200;

    snprintf(out, size, "%.*s%.*s.%ld-%d.part", (int)folder, path, buffer, path + folder, (long)getpid(), attempt);
}

/* Is it NAME.PID-N.part, old, and of a process that no longer exists? */
static bool is_lost(const char *folder, const char *entry, const char *name)
{
    const size_t n = strlen(name) < 200 ? strlen(name) : 200;
    char path[PATH_MAX], rest[8] = "";
    struct stat about;
    long pid, number;

    if (strncmp(entry, name, n) != 0 || entry[n] != '.' ||
        sscanf(entry + n, ".%ld-%ld%7s", &pid, &number, rest) != 3 || strcmp(rest, ".part") != 0 || pid <= 0)
        return false;
    if (kill((pid_t)pid, 0) == 0 || errno != ESRCH)
        return false;
    if ((size_t)snprintf(path, sizeof path, "%s%s", folder, entry) >= sizeof path || lstat(path, &about) != 0)
        return false;
    return S_ISREG(about.st_mode) && difftime(time(NULL), about.st_mtime) > LOST_AFTER;
}

/* Remove the temporary files that killed processes have left for this target. */
static void sweep(const char *path)
{
    const size_t n = folder_length(path);
    char folder[PATH_MAX], lost[PATH_MAX];
    struct dirent *entry;
    DIR *d;

    snprintf(folder, sizeof folder, "%.*s", (int)n, path);
    d = opendir(n > 0 ? folder : ".");
    while (d && (entry = readdir(d)) != NULL)
        if (is_lost(folder, entry->d_name, path + n) &&
            (size_t)snprintf(lost, sizeof lost, "%s%s", folder, entry->d_name) < sizeof lost)
            unlink(lost);
    if (d)
        closedir(d);
}

/* Create a file beside the target under an unused name, with the old file's mode if there is one. */
static bool open_beside(file_writer *w, const struct stat *old)
{
    const size_t size = strlen(w->path) + 48;
    int attempt;

    w->temporary = env_alloc(w->env, size, 1);
    if (!w->temporary) {
        w->error = ENOMEM;
        return false;
    }
    for (attempt = 0; attempt < NAMES_MOST && w->descriptor < 0; attempt++) {
        name_beside(w->path, attempt, w->temporary, size);
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

/* ---- opening ---- */

static bool refuse(file_writer *w, int why)
{
    w->error = why;
    return false;
}

/* Would the folder take a file of this name? */
static bool is_short_enough(const char *path)
{
    const size_t n = folder_length(path);
    char folder[PATH_MAX];
    long most;

    snprintf(folder, sizeof folder, "%.*s", (int)n, path);
    most = pathconf(n > 0 ? folder : ".", _PC_NAME_MAX);
    return most < 0 || strlen(path + n) <= (size_t)most;
}

/* The target's path in full, and a descriptor of its own for what stands for one. */
static bool find_target(file_writer *w, const char *path)
{
    char target[PATH_MAX];
    int standing;

    if (!resolve(path, target, &standing))
        return refuse(w, errno);
    w->path = env_alloc(w->env, strlen(target) + 1, 1);
    if (!w->path)
        return refuse(w, ENOMEM);
    strcpy(w->path, target);
    if (standing >= 0)
        w->descriptor = fcntl(standing, F_DUPFD_CLOEXEC, 0);
    return standing < 0 || w->descriptor >= 0 || refuse(w, errno);
}

/* A device or a pipe cannot be replaced by renaming. */
static bool open_as_it_is(file_writer *w)
{
    w->descriptor = open(w->path, O_WRONLY | O_CLOEXEC);
    return w->descriptor >= 0 || refuse(w, errno);
}

/* wait: for the reader of a pipe too; else such a target is left alone. */
static bool open_target(file_writer *w, const char *path, bool wait)
{
    struct stat about;
    bool exists;

    if (!find_target(w, path))
        return false;
    if (w->descriptor >= 0)
        return true;
    exists = stat(w->path, &about) == 0;
    if (exists && S_ISDIR(about.st_mode))
        return refuse(w, EISDIR);
    if (exists && !S_ISREG(about.st_mode))
        return wait ? open_as_it_is(w) : access(w->path, W_OK) == 0 || refuse(w, errno);
    if (!is_short_enough(w->path))
        return refuse(w, ENAMETOOLONG);
    return open_beside(w, exists ? &about : NULL);
}

static void forget(file_writer *w)
{
    env_free(w->env, w->temporary);
    env_free(w->env, w->path);
    w->temporary = w->path = NULL;
}

static pov_status begin(file_writer *w, const env *e, const char *path, bool wait, pov_error *err)
{
    memset(w, 0, offsetof(file_writer, buffer));
    w->env = e;
    w->descriptor = -1;
    if (open_target(w, path, wait))
        return POV_OK;
    forget(w);
    if (w->error == ENOMEM)
        return err_memory(err);
    return err_file(err, POV_E_IO, path, "cannot write: %s", strerror(w->error));
}

pov_status file_writer_open(file_writer *w, const env *e, const char *path, pov_error *err)
{
    pov_status status = begin(w, e, path, true, err);

    if (status == POV_OK && w->temporary)
        sweep(w->path);
    return status;
}

pov_status file_writer_try(const env *e, const char *path, pov_error *err)
{
    file_writer *w = env_alloc(e, 1, sizeof *w);
    pov_status status = w ? begin(w, e, path, false, err) : err_memory(err);

    if (status == POV_OK)
        file_writer_discard(w);
    env_free(e, w);
    return status;
}

/* ---- writing ---- */

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
    } else if (count > 0) {
        memcpy(w->buffer + w->used, bytes, count);
        w->used += count;
    }
    return w->error == 0;
}

/* ---- ending ---- */

static void close_writer(file_writer *w)
{
    if (w->descriptor >= 0 && close(w->descriptor) < 0 && errno != EINTR && w->error == 0)
        w->error = errno;
    w->descriptor = -1;
}

/* After a power cut the name must stand for the old file or for the whole new one: its bytes are on the disk before it has the name.
 * Some file systems cannot promise that; then nothing more can be done. */
static void sync_bytes(file_writer *w)
{
    if (fsync(w->descriptor) < 0 && errno != EINVAL && errno != ENOTSUP && errno != EINTR && w->error == 0)
        w->error = errno;
}

pov_status file_writer_commit(file_writer *w, pov_error *err)
{
    pov_status status = POV_OK;

    write_out(w, w->buffer, w->used);
    if (w->temporary && w->error == 0)
        sync_bytes(w);
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
