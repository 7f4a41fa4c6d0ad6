#include "caption.h"

#include "add.h"
#include "bar.h"

#include <string.h>

static void write_comparison(const app *a, const session *s, char *out, size_t size)
{
    const char *path = session_reference_path(s), *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    double rms = session_reference_rms(s);

    if (a->compare == APP_REFERENCE) {
        add(out, size, "#the reference\n %.100s\n", name);
    } else if (a->compare == APP_WIPE) {
        add(out, size, "#left: the reference\n %.100s\n#right: the picture\n", name);
    } else {
        add(out, size, "#difference from %.100s\n", name);
        bar_write(&bar_error, 1.0, out, size);
        add(out, size, " linear light, the largest of three\n");
        if (rms >= 0.0)
            add(out, size, " root mean square %.2g\n", rms);
    }
}

/* How many pixels, and which part of those that see a surface. */
static void write_certainty(const session *s, char *out, size_t size)
{
    size_t certain, uncertain;
    double all;

    session_count_certain(s, &certain, &uncertain);
    all = certain + uncertain > 0 ? (double)(certain + uncertain) : 1.0;
    add(out, size, "#certainty\n%%5a82dc 1: double decides, %zu pixels (%.4g %%)\n", certain, 100.0 * (double)certain / all);
    add(out, size, "%%ff961e 2: double-double needed, %zu (%.4g %%)\n", uncertain, 100.0 * (double)uncertain / all);
}

static void write_clipped(const session *s, char *out, size_t size)
{
    size_t above, below;

    session_count_clipped(s, &above, &below);
    add(out, size, "#clipped\n%%ff00ff above 1: %zu pixels\n%%00ffff below 0: %zu pixels\n", above, below);
}

static void write_view(const app *a, const session *s, char *out, size_t size)
{
    switch (a->view) {
    case APP_NORMAL: add(out, size, "#normal: x red, y green, z blue\n~x\n~y\n~z0 -1\t0.25 -0.5\t0.5 0\t0.75 0.5\t1 1\n"); break;
    case APP_DEPTH:
        add(out, size, "#depth\n");
        bar_write_depth(session_middle_depth(s), out, size);
        break;
    case APP_SAMPLES:
        add(out, size, "#samples a pixel\n");
        bar_write(&bar_samples, 1.0, out, size);
        break;
    case APP_TIME:
        add(out, size, "#microseconds of a pixel, of one processor\n");
        bar_write(&bar_seconds, 1e-6, out, size);
        break;
    case APP_ERROR:
        add(out, size, "#error\n");
        bar_write(&bar_error, 1.0, out, size);
        add(out, size, "%%3c3c3c not known\n");
        break;
    case APP_CERTAINTY: write_certainty(s, out, size); break;
    default: break;
    }
}

void caption_write(const app *a, const session *s, char *out, size_t size)
{
    if (a->compare != APP_PLAIN)
        write_comparison(a, s, out, size);
    else if (a->view == APP_PICTURE && a->clipped)
        write_clipped(s, out, size);
    else
        write_view(a, s, out, size);
}
