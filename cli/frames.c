#include "frames.h"

#include <stdio.h>
#include <string.h>

int frames_count(const frames *f)
{
    return f->to < f->from ? 0 : (f->to - f->from) / f->step + 1;
}

static double clock_of(const frames *f, int frame)
{
    const int steps = f->last - f->first + (f->cyclic ? 1 : 0);

    return steps > 0 ? f->first_clock + (f->last_clock - f->first_clock) * (frame - f->first) / steps : f->first_clock;
}

pov_animation frames_animation(const frames *f, int frame)
{
    const double clock = clock_of(f, frame);
    const pov_animation now = { clock, f->first_clock, f->last_clock, clock_of(f, frame + 1) - clock, frame, f->first,
                                f->last + (f->cyclic ? 1 : 0) };

    return now;
}

static int digits_of(int n)
{
    int digits = 1;

    while (n >= 10) {
        n /= 10;
        digits++;
    }
    return digits;
}

bool frames_name(const frames *f, int frame, const char *path, char *out, size_t size)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    const int stem = dot && dot != name ? (int)(dot - path) : (int)strlen(path);
    int n;

    if (strcmp(path, "-") == 0 || strncmp(path, "/dev/", 5) == 0)
        n = snprintf(out, size, "%s", path);
    else
        n = snprintf(out, size, "%.*s%0*d%s", stem, path, digits_of(f->last > f->to ? f->last : f->to), frame, path + stem);
    return n >= 0 && (size_t)n < size;
}
