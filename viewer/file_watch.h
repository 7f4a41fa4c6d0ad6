/* file_watch.h - has a file been written again? */
#ifndef VIEWER_FILE_WATCH_H
#define VIEWER_FILE_WATCH_H

#include <stdbool.h>
#include <time.h>

typedef struct file_stamp { bool exists; struct timespec time; long long size; unsigned long long node; } file_stamp;

typedef struct file_watch {
    const char *path;            /* NULL: nothing is watched */
    file_stamp loaded, seen;     /* what was read last, and what stood there at the last look */
    double next;
} file_watch;

/* Watch a path, from what stands there now; "-" is not watched. The path is kept, not copied. */
void file_watch_begin(file_watch *w, const char *path, double now);
/* Looks four times a second. True, once: the file is another, and has not changed between two looks, so that whoever
 * writes it has most likely finished. */
bool file_watch_changed(file_watch *w, double now);
/* Seconds to the next look; less than 0: there is none. */
double file_watch_patience(const file_watch *w, double now);

#endif
