#include "overlay.h"

#include "add.h"
#include "caption.h"
#include "cells.h"
#include "curve.h"
#include "keys.h"

#include <stdio.h>
#include <string.h>

enum { CELLS, MESSAGE, PLACE, NOTE, CAPTION, CURVE, HELP, START, TEXT_SIZE = 8192 };

/* Margin at the window's edges, in units of the scale. */
static const double EDGE = 14.0;

void overlay_write_help(char *out, size_t size)
{
    const keys_row *row;

    out[0] = '\0';
    add(out, size, "#povview\n");
    for (int i = 0; (row = keys_get(i)); i++)
        add(out, size, "|%s\t%s\n", row->names, row->help);
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
    if (p->compared)
        add(out, size, "|reference\t%.4f, %.4f, %.4f\n", (double)p->reference[0], (double)p->reference[1],
            (double)p->reference[2]);
    if (p->samples > 0.0f)
        add(out, size, "|samples\t%.0f\n", (double)p->samples);
    if (p->seconds > 0.0f)
        add(out, size, "|time\t%.3g \xc2\xb5s\n", 1e6 * (double)p->seconds);
    if (p->error >= 0.0f)
        add(out, size, "|error\t%.2g\n", (double)p->error);
    add(out, size, "|pixel\t%d, %d\n", p->x, p->y);
}

/* Each scene by its name, and the folder it is in. */
static void write_start(const recent *r, char *out, size_t size)
{
    add(out, size, "#povview\n Drop a scene on this window%s\n", r->count > 0 ? ", or type the number of a recent one:" : ".");
    for (int i = 0; i < r->count; i++) {
        const char *path = r->paths[i], *slash = strrchr(path, '/');

        add(out, size, "|%d   %s\t%.*s\n", i + 1, slash + 1, (int)(slash > path ? slash - path : 1), path);
    }
    add(out, size, " H: help. Esc: quit.\n");
}

static int least(int a, int b) { return a < b ? a : b; }
static int most(int a, int b) { return a > b ? a : b; }

/* Pixels of a panel at x, y that lie outside of the window or on panels whose places are settled. */
static long hidden(const overlay *o, const app *a, unsigned settled, const panel *p, int x, int y)
{
    const long all = (long)p->width * p->height;
    const int across = least(x + p->width, a->width) - most(x, 0), down = least(y + p->height, a->height) - most(y, 0);
    long sum = across > 0 && down > 0 ? all - (long)across * down : all;

    for (int i = 0; i < PRESENT_PANELS; i++) {
        const panel *other = &o->panels[i];
        const int right = least(x + p->width, o->x[i] + other->width) - most(x, o->x[i]);
        const int below = least(y + p->height, o->y[i] + other->height) - most(y, o->y[i]);

        if (settled >> i & 1 && other->pixels && right > 0 && below > 0)
            sum += (long)right * below;
    }
    return sum;
}

/* Of these places the first where nothing of the panel is hidden, or the one where least is. */
static void choose(const overlay *o, const app *a, unsigned settled, const panel *p, const int (*at)[2], int count, int *x, int *y)
{
    long best = -1;

    for (int i = 0; i < count; i++) {
        const int left = most(at[i][0], 0), top = most(at[i][1], 0);
        const long lost = hidden(o, a, settled, p, left, top);

        if (best >= 0 && lost >= best)
            continue;
        best = lost;
        *x = left;
        *y = top;
    }
}

/* Each panel has its own place, and others to go to where that is taken; the inspector follows the pointer. */
static void place(const overlay *o, const app *a, int index, unsigned settled, int *x, int *y)
{
    const panel *p = &o->panels[index];
    const int edge = (int)(EDGE * a->scale), right = a->width - edge - p->width, bottom = a->height - edge - p->height;
    const int after = (int)a->x + edge, before = (int)a->x - edge - p->width, under = (int)a->y + edge,
              over = (int)a->y - edge - p->height, middle = (a->width - p->width) / 2;
    const int by_pointer[8][2] = { { after, under }, { before, under }, { after, over }, { before, over },
                                   { edge, edge }, { right, edge }, { edge, bottom }, { right, bottom } };
    const int corners[4][2] = { { edge, edge }, { edge, bottom }, { right, bottom }, { right, edge } };
    const int notes[2][2] = { { middle, edge }, { middle, bottom } };
    const int centre[1][2] = { { middle, (a->height - p->height) / 2 } };
    const int first = index == MESSAGE ? 1 : index == CURVE ? 2 : index == CAPTION ? 3 : 0;
    const int from[4][2] = { { corners[first][0], corners[first][1] }, { corners[first ^ 1][0], corners[first ^ 1][1] },
                             { corners[first ^ 2][0], corners[first ^ 2][1] }, { corners[first ^ 3][0], corners[first ^ 3][1] } };

    if (index == PLACE)
        choose(o, a, settled, p, by_pointer, 8, x, y);
    else if (index == START)
        choose(o, a, settled, p, centre, 1, x, y);
    else if (index == NOTE)
        choose(o, a, settled, p, notes, 2, x, y);
    else
        choose(o, a, settled, p, from, 4, x, y);
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
        caption_write(a, s, out, size);
    else if (index == HELP && a->help)
        overlay_write_help(out, size);
    else if (index == START && session_choices(s) && !a->help)
        write_start(session_choices(s), out, size);
}

bool overlay_update(overlay *o, const app *a, session *s, present *p)
{
    static const int order[PRESENT_PANELS] = { CELLS, HELP, START, MESSAGE, CURVE, CAPTION, NOTE, PLACE };
    const int edges = (int)(2.0 * EDGE * a->scale);
    char text[TEXT_SIZE];
    bool changed = false;
    unsigned settled = 0;

    for (int k = 0; k < PRESENT_PANELS; k++) {
        const int i = order[k];
        const panel_room room = { a->width - edges, i == HELP ? a->height - edges : 0, (int)a->help_from };
        panel *from = &o->panels[i];
        present_panel to;
        bool fresh;
        int x = 0, y = 0;

        write(i, a, s, text, sizeof text);
        fresh = i == CELLS ? cells_set(from, a, s)
              : i == CURVE ? curve_set(from, s, a->curve, a->scale)
                           : panel_set(from, text, a->scale, &room);
        /* Numbers in the pixels lie under the panels and are in no one's way. */
        if (i != CELLS) {
            place(o, a, i, settled, &x, &y);
            settled |= 1u << i;
        }
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

int overlay_help_below(const overlay *o)
{
    const panel *help = &o->panels[HELP];

    return help->pixels ? help->whole_height - help->height : 0;
}

void overlay_free(overlay *o)
{
    for (int i = 0; i < PRESENT_PANELS; i++)
        panel_free(&o->panels[i]);
}
