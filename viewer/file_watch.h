/* file_watch.h - notices changes of a file. */
#ifndef VIEWER_FILE_WATCH_H
#define VIEWER_FILE_WATCH_H

#include <stdbool.h>
#include <time.h>

typedef struct file_stamp { bool exists; struct timespec time; long long size; unsigned long long node; } file_stamp;

typedef struct file_watch {
    const char *path;            /* NULL: nothing is watched */
    file_stamp loaded, seen;     /* state when the file was last read, and state at the last check */
    double next;
} file_watch;

/* Watch a path, starting with its present state; "-" is not watched. The path is kept, not copied. */
void file_watch_begin(file_watch *w, const char *path, double now);
/* Checks four times a second. True, once: the file has changed, and then not between two checks, so that its writer has
 * most likely finished. */
bool file_watch_changed(file_watch *w, double now);
/* Seconds to the next check; less than 0: none. */
double file_watch_patience(const file_watch *w, double now);

#endif
