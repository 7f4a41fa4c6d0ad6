#include "keys.h"

#include <stdlib.h>

enum { EXPOSURE_MOST = 30 };

static const double FIELD_STEP = 1.1, PAGE_LINES = 10.0;

/* ---- the camera ---- */

static void face(app *a, orbit_side side)
{
    orbit_face(&a->orbit, side);
    a->moved = true;
}

static void front(app *a, double now) { (void)now; face(a, ORBIT_FRONT); }
static void right(app *a, double now) { (void)now; face(a, ORBIT_RIGHT); }
static void top(app *a, double now) { (void)now; face(a, ORBIT_TOP); }

static void reset(app *a, double now)
{
    (void)now;
    orbit_reset(&a->orbit);
    a->moved = true;
}

static void frame(app *a, bool found, const pov_box *box, const char *nothing, double now)
{
    if (found && orbit_frame(&a->orbit, box))
        a->moved = true;
    else
        app_say(a, now, "%s", nothing);
}

static void frame_all(app *a, double now)
{
    frame(a, a->has_box, &a->box, "nothing here has an end", now);
}

static void frame_one(app *a, double now)
{
    pov_box box;
    double x, y;
    bool found;

    app_pointed(a, &x, &y);
    found = a->extent && a->extent(a->probe_user, x / a->width, y / a->height, &box);
    frame(a, found, &box, "nothing is under the pointer", now);
}

static void widen(app *a, double factor, double now)
{
    double degrees = orbit_widen(&a->orbit, factor);

    if (degrees > 0.0)
        app_say(a, now, "%.1f\xc2\xb0 across", degrees);
    else if (degrees < 0.0)
        app_say(a, now, "a camera of this kind keeps its field of view");
    a->moved = a->moved || degrees >= 0.0;
}

static void wider(app *a, double now) { widen(a, FIELD_STEP, now); }
static void narrower(app *a, double now) { widen(a, 1.0 / FIELD_STEP, now); }

/* ---- pixels ---- */

static void magnify(app *a, double now) { app_zoom(a, 1.0, now); }
static void reduce(app *a, double now) { app_zoom(a, -1.0, now); }
static void show_whole(app *a, double now) { app_zoom(a, -1000.0, now); }

/* ---- the picture ---- */

static void expose(app *a, int more, double now)
{
    static const char *const thirds[] = { "", " 1/3", " 2/3" };
    int wanted = a->exposure + more, size;

    a->exposure = wanted > EXPOSURE_MOST ? EXPOSURE_MOST : wanted < -EXPOSURE_MOST ? -EXPOSURE_MOST : wanted;
    a->orders |= APP_TONE;
    size = abs(a->exposure);
    if (size > 0 && size < 3)
        app_say(a, now, "exposure %c%s stop", a->exposure < 0 ? '-' : '+', thirds[size] + 1);
    else
        app_say(a, now, "exposure %s%d%s stops", a->exposure < 0 ? "-" : size ? "+" : "", size / 3, thirds[size % 3]);
}

static void darker(app *a, double now) { expose(a, -1, now); }
static void brighter(app *a, double now) { expose(a, 1, now); }

static void mark_clipped(app *a, double now)
{
    a->clipped = !a->clipped;
    a->orders |= APP_MARK;
    app_say(a, now, a->clipped ? "clipped pixels are marked" : "clipped pixels are not marked");
}

static void show_next(app *a, double now)
{
    a->compare = APP_PLAIN;
    a->view = (app_view)((a->view + 1) % APP_VIEWS);
    a->orders |= APP_VIEW;
    app_say(a, now, "%s", app_view_name(a->view));
}

static void flip(app *a, double now) { app_compare_with(a, APP_REFERENCE, now); }
static void differ(app *a, double now) { app_compare_with(a, APP_DIFFERENCE, now); }
static void wipe(app *a, double now) { app_compare_with(a, APP_WIPE, now); }

static void toggle_pause(app *a, double now)
{
    a->paused = !a->paused;
    a->orders |= APP_PAUSE;
    app_say(a, now, a->paused ? "paused" : "going on");
}

/* ---- panels and the rest ---- */

static void toggle(app *a, bool *what)
{
    *what = !*what;
    a->orders |= APP_DRAW;
}

static void toggle_help(app *a, double now)
{
    (void)now;
    a->help_from = 0.0;
    toggle(a, &a->help);
}

static void scroll(app *a, double lines)
{
    if (a->help)
        app_scroll_help(a, lines);
}

static void line_up(app *a, double now) { (void)now; scroll(a, -1.0); }
static void line_down(app *a, double now) { (void)now; scroll(a, 1.0); }
static void page_up(app *a, double now) { (void)now; scroll(a, -PAGE_LINES); }
static void page_down(app *a, double now) { (void)now; scroll(a, PAGE_LINES); }

static void toggle_full(app *a, double now)
{
    (void)now;
    a->full = !a->full;
    a->orders |= APP_FULL;
}

static void toggle_inspector(app *a, double now) { (void)now; toggle(a, &a->inspect); }
static void toggle_curve(app *a, double now) { (void)now; toggle(a, &a->curve); }
static void copy_camera(app *a, double now) { (void)now; a->orders |= APP_PRINT; }
static void save(app *a, double now) { (void)now; a->orders |= APP_SNAPSHOT; }
static void reload(app *a, double now) { (void)now; a->orders |= APP_RELOAD; }
static void quit(app *a, double now) { (void)now; a->orders |= APP_QUIT; }

static const keys_row rows[] = {
    { "drag", "orbit about what is in the middle", { 0 }, false, NULL },
    { "Shift-drag, middle drag", "pan", { 0 }, false, NULL },
    { "wheel", "go to what is under the pointer", { 0 }, false, NULL },
    { "right drag", "look around; W A S D Q E fly, Shift faster", { 0 }, false, NULL },
    { "1", "from the front", { '1' }, false, front },
    { "3", "from the right", { '3' }, false, right },
    { "7", "from the top", { '7' }, false, top },
    { "A, Home", "all objects in view", { 'a', APP_KEY_HOME }, false, frame_all },
    { "F", "the object under the pointer in view", { 'f' }, false, frame_one },
    { "comma", "a wider field of view", { ',' }, false, wider },
    { "period", "a narrower field of view", { '.' }, false, narrower },
    { "Z, Ctrl-wheel", "magnify pixels; then drag and wheel leave the camera", { 'z' }, false, magnify },
    { "X", "magnify pixels less", { 'x' }, false, reduce },
    { "0", "the whole picture", { '0' }, false, show_whole },
    { "R, Enter", "back to the scene's camera", { 'r', APP_KEY_ENTER }, false, reset },
    { "C", "copy the camera as scene text", { 'c' }, false, copy_camera },
    { "[, -", "a third of a stop less exposure", { '[', '-' }, false, darker },
    { "], +", "a third of a stop more exposure", { ']', '+', '=' }, false, brighter },
    { "O", "mark pixels that are clipped", { 'o' }, false, mark_clipped },
    { "Tab", "picture, normal, depth, samples, time, error, certainty", { APP_KEY_TAB }, false, show_next },
    { "B", "the reference in the picture's place", { 'b' }, false, flip },
    { "D", "the difference from the reference", { 'd' }, false, differ },
    { "L", "the reference left of the pointer", { 'l' }, false, wipe },
    { "G", "error against time", { 'g' }, false, toggle_curve },
    { "I", "what is under the pointer", { 'i' }, false, toggle_inspector },
    { "P, Space", "pause and go on", { 'p', ' ' }, false, toggle_pause },
    { "S", "save what is seen as PNG", { 's' }, false, save },
    { "F5", "read the scene again; a saved file is by itself", { APP_KEY_F5 }, true, reload },
    { "H, ?, F1", "this help", { 'h', '?', APP_KEY_F1 }, true, toggle_help },
    { "Up, Down, wheel", "the rest of this help, where it does not fit", { APP_KEY_UP }, true, line_up },
    { "F11", "the whole screen, and back", { APP_KEY_F11 }, true, toggle_full },
    { "Esc, Ctrl-Q", "quit", { APP_KEY_ESCAPE }, true, quit },
};

/* Keys that a row above speaks of. */
static const keys_row unlisted[] = {
    { "Down", "", { APP_KEY_DOWN }, true, line_down },
    { "Page Up", "", { APP_KEY_PAGE_UP }, true, page_up },
    { "Page Down", "", { APP_KEY_PAGE_DOWN }, true, page_down },
};

const keys_row *keys_get(int index)
{
    return index >= 0 && (size_t)index < sizeof rows / sizeof rows[0] ? &rows[index] : NULL;
}

const keys_row *keys_find(int code)
{
    const keys_row *row;

    if (code >= 'A' && code <= 'Z')
        code += 'a' - 'A';
    for (int i = 0; code && (row = keys_get(i)); i++)
        for (size_t k = 0; k < sizeof row->codes / sizeof row->codes[0] && row->codes[k]; k++)
            if (row->codes[k] == code)
                return row;
    for (size_t i = 0; i < sizeof unlisted / sizeof unlisted[0]; i++)
        if (code && unlisted[i].codes[0] == code)
            return &unlisted[i];
    return NULL;
}
