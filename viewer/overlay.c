#include "overlay.h"

#include "curve.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { MESSAGE, PLACE, NOTE, CAPTION, CURVE, HELP, TEXT_SIZE = 2048 };

/* Margin at the window's edges, in units of the scale. */
static const double EDGE = 14.0;

static const char help[] =
    "#povview\n"
    "|drag\torbit about what is in the middle\n"
    "|Shift-drag, middle drag\tpan\n"
    "|wheel\tgo to what is under the pointer\n"
    "|right drag\tlook around; W A S D Q E fly, Shift faster\n"
    "|1  3  7\tfront, right, top\n"
    "|R, Enter\tback to the scene's camera\n"
    "|C\tprint the camera as scene text\n"
    "|[  ]\tless, more exposure\n"
    "|Tab\tthe next view of picture, normal, depth,\n"
    "|\tsamples, time, error, certainty\n"
    "|G\terror against time\n"
    "|I\twhat is under the pointer\n"
    "|P\tpause\n"
    "|S\tsave what is seen as PNG\n"
    "|F5\tread the scene again; a saved file is by itself\n"
    "|H, F1\tthis help\n"
    "|Esc\tquit\n";

static void add(char *out, size_t size, const char *format, ...) POV_PRINTF(3, 4);

static void add(char *out, size_t size, const char *format, ...)
{
    size_t used = strlen(out);
    va_list list;

    va_start(list, format);
    vsnprintf(out + used, size - used, format, list);
    va_end(list);
}

void overlay_write_message(const pov_error *err, bool has_scene, char *out, size_t size)
{
    out[0] = '\0';
    if (err->line > 0)
        add(out, size, "!%s, line %d, column %d\n", err->file, err->line, err->column);
    else
        add(out, size, "!%s\n", err->file[0] ? err->file : "povview");
    add(out, size, " %s\n", err->message);
    if (err->line > 0 && err->excerpt[0])
        add(out, size, "=%s\n^%d\n", err->excerpt, err->caret > 0 ? err->caret : 0);
    if (err->hint[0])
        add(out, size, " did you mean \"%s\"?\n", err->hint);
    add(out, size, has_scene ? " The picture is from before the error.\n"
                             : " The file is read again when it is saved.\n");
}

void overlay_write_place(const session_place *p, char *out, size_t size)
{
    out[0] = '\0';
    if (!p->hit) {
        add(out, size, "#nothing\n");
    } else {
        add(out, size, "#%s, line %d\n", p->keyword, p->line);
        add(out, size, "|position\t%.6g, %.6g, %.6g\n", p->point.x, p->point.y, p->point.z);
        add(out, size, "|normal\t%.4f, %.4f, %.4f\n", p->normal.x, p->normal.y, p->normal.z);
        add(out, size, "|distance\t%.8g\n", p->distance);
        add(out, size, "|hits\t%zu on the way\n", p->hits);
        add(out, size, "|computed in\t%s\n", p->certain ? "double" : "double-double");
    }
    if (p->color[3] > 0.0f)
        add(out, size, "|color\t%.4f, %.4f, %.4f\n", (double)p->color[0], (double)p->color[1], (double)p->color[2]);
    else
        add(out, size, "|color\tnot yet\n");
    if (p->samples > 0.0f)
        add(out, size, "|samples\t%.0f\n", (double)p->samples);
    if (p->seconds > 0.0f)
        add(out, size, "|time\t%.3g \xc2\xb5s\n", 1e6 * (double)p->seconds);
    if (p->error >= 0.0f)
        add(out, size, "|error\t%.2g\n", (double)p->error);
    add(out, size, "|pixel\t%d, %d\n", p->x, p->y);
}

/* Position beside the pointer, on the side where the panel fits. */
static void place_by_pointer(const app *a, const panel *p, int *x, int *y)
{
    int gap = (int)(EDGE * a->scale);

    *x = (int)a->x + gap;
    *y = (int)a->y + gap;
    if (*x + p->width > a->width)
        *x = (int)a->x - gap - p->width;
    if (*y + p->height > a->height)
        *y = (int)a->y - gap - p->height;
    *x = *x > 0 ? *x : 0;
    *y = *y > 0 ? *y : 0;
}

static void place(const app *a, int index, const panel *p, int *x, int *y)
{
    int edge = (int)(EDGE * a->scale);

    *x = *y = edge;
    if (index == PLACE) {
        place_by_pointer(a, p, x, y);
    } else if (index == MESSAGE) {
        *y = a->height - edge - p->height;
    } else if (index == NOTE) {
        *x = (a->width - p->width) / 2;
    } else if (index == CAPTION || index == CURVE) {
        *x = a->width - edge - p->width;
        *y = index == CURVE ? a->height - edge - p->height : edge;
    }
    *x = *x > 0 ? *x : 0;
    *y = *y > 0 ? *y : 0;
}

/* Legend of a view's colours. */
static const char *caption(app_view view)
{
    static const char *const captions[APP_VIEWS] = {
        "", "#normal\n red x, green y, blue z: -1 dark, 1 bright\n", "#depth\n white near, black far\n",
        "#samples\n dark 1, bright 1024\n", "#time\n dark a microsecond of the processor a pixel, bright 10 ms\n",
        "#error\n dark 0.0001, bright 0.1, grey not known\n",
        "#certainty\n blue: double decides; orange: double-double needed\n",
    };

    return captions[view];
}

static void write(int index, const app *a, session *s, char *out, size_t size)
{
    const pov_error *err = session_error(s);
    session_place at;

    out[0] = '\0';
    if (index == MESSAGE && err)
        overlay_write_message(err, a->has_scene, out, size);
    else if (index == PLACE && a->inspect && session_inspect(s, &at))
        overlay_write_place(&at, out, size);
    else if (index == NOTE && a->note[0])
        add(out, size, " %s\n", a->note);
    else if (index == CAPTION)
        add(out, size, "%s", caption(a->view));
    else if (index == HELP && a->help)
        add(out, size, "%s", help);
}

bool overlay_update(overlay *o, const app *a, session *s, present *p)
{
    char text[TEXT_SIZE];
    bool changed = false;

    for (int i = 0; i < PRESENT_PANELS; i++) {
        panel *from = &o->panels[i];
        present_panel to;
        bool fresh;
        int x, y;

        write(i, a, s, text, sizeof text);
        fresh = i == CURVE ? curve_set(from, s, a->curve, a->scale)
                           : panel_set(from, text, a->scale, a->width - (int)(2.0 * EDGE * a->scale));
        place(a, i, from, &x, &y);
        if (!fresh && (!from->pixels || (x == o->x[i] && y == o->y[i])))
            continue;
        to.pixels = from->pixels;
        to.width = from->width;
        to.height = from->height;
        to.x = o->x[i] = x;
        to.y = o->y[i] = y;
        present_set_panel(p, i, &to);
        changed = true;
    }
    return changed;
}

void overlay_free(overlay *o)
{
    for (int i = 0; i < PRESENT_PANELS; i++)
        panel_free(&o->panels[i]);
}
