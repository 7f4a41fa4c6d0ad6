#include "file_watch.h"

#include <string.h>
#include <sys/stat.h>

/* After a change the next check comes sooner. */
static const double LOOK_SECONDS = 0.25, SECOND_LOOK_SECONDS = 0.05;

static file_stamp look(const char *path)
{
    file_stamp f = { false, { 0, 0 }, 0, 0 };
    struct stat s;

    if (stat(path, &s) == 0) {
        f.exists = true;
        f.time = s.st_mtim;
        f.size = s.st_size;
        f.node = s.st_ino;
    }
    return f;
}

static bool is_same(const file_stamp *a, const file_stamp *b)
{
    return a->exists == b->exists && a->size == b->size && a->node == b->node &&
           a->time.tv_sec == b->time.tv_sec && a->time.tv_nsec == b->time.tv_nsec;
}

void file_watch_begin(file_watch *w, const char *path, double now)
{
    memset(w, 0, sizeof *w);
    if (strcmp(path, "-") == 0)
        return;
    w->path = path;
    w->loaded = w->seen = look(path);
    w->next = now + LOOK_SECONDS;
}

bool file_watch_changed(file_watch *w, double now)
{
    file_stamp found;
    bool steady;

    if (!w->path || now < w->next)
        return false;
    found = look(w->path);
    steady = is_same(&found, &w->seen);
    w->seen = found;
    /* An editor that replaces a file leaves no file for a moment. */
    if (!found.exists || is_same(&found, &w->loaded)) {
        w->next = now + LOOK_SECONDS;
        return false;
    }
    w->next = now + (steady ? LOOK_SECONDS : SECOND_LOOK_SECONDS);
    if (steady)
        w->loaded = found;
    return steady;
}

double file_watch_patience(const file_watch *w, double now)
{
    if (!w->path)
        return -1.0;
    return w->next > now ? w->next - now : 0.0;
}
