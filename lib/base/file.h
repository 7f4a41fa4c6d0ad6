/* file.h - reading whole files, and replacing them whole. */
#ifndef BASE_FILE_H
#define BASE_FILE_H

#include "base/env.h"

/* Read a regular file, a pipe, or standard input for "-". A zero byte that is not counted follows the data. env_free()
 * it. */
pov_status file_read(const env *e, const char *path, char **bytes, size_t *count, pov_error *err);

/* The same, of at most so many bytes. */
pov_status file_read_most(const env *e, const char *path, size_t most, char **bytes, size_t *count, pov_error *err);

/* Write beside the target, then rename over it: commit or discard ends the writing. A symbolic link is followed, and
 * the file it points to is replaced. "-", /dev/stdout and the like, devices and pipes are written to directly. */
typedef struct file_writer {
    const env *env;
    char *path, *temporary;      /* path: the target of links; temporary is NULL where nothing is replaced */
    int descriptor;
    int error;                   /* errno of the first failure */
    size_t used;
    unsigned char buffer[1 << 15];
} file_writer;

pov_status file_writer_open(file_writer *w, const env *e, const char *path, pov_error *err);
/* False after a failure; the cause comes with commit. */
bool file_writer_put(file_writer *w, const void *bytes, size_t count);
pov_status file_writer_commit(file_writer *w, pov_error *err);
void file_writer_discard(file_writer *w);
/* Could the path be written to? Tries everything that open and commit need of the folder and of the names, and leaves
 * no file behind. */
pov_status file_writer_try(const env *e, const char *path, pov_error *err);

/* Call see(user, name) for each entry of a folder; no call when there is no such folder. */
void file_list(const char *folder, void (*visit)(void *user, const char *name), void *user);
bool file_exists(const char *path);
bool file_is_link(const char *path);
/* The path without links, `.` and `..`. False: there is nothing there, or it is longer than `size`. */
bool file_resolve(const char *path, char *out, size_t size);

#endif
