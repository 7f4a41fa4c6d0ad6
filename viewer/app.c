#include "app.h"

#include "keys.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Each of these keys has a bit in `flying`, in this order. */
static const char flight_keys[] = "WASDQE";
/* A slow scene is restarted after this time even if its first picture is not complete: about 20 times a second. */
static const double RESTART_SECONDS = 0.045;
static const double FLIGHT_SECONDS = 1.0 / 60.0;
static const double WHEEL_SECONDS = 0.5;
static const double WHEEL_LINES = 3.0;
static const double NOTE_SECONDS = 2.0, GREETING_SECONDS = 5.0;

void app_init(app *a, int width, int height, app_probe *probe, void *probe_user)
{
    memset(a, 0, sizeof *a);
    a->width = width;
    a->height = height;
    a->scale = 1.0;
    a->x = 0.5 * width;
    a->y = 0.5 * height;
    a->probe = probe;
    a->probe_user = probe_user;
    a->restarted = -1.0;
    a->zoomed = -1.0;
    a->orders = APP_DRAW;
}

/* The aspect ratio that a camera is meant for. If the window's differs little, or was requested, it is the window's,
 * and the picture is bit-identical to povc's at this size. */
static double shape_of(const app *a, const pov_camera *c)
{
    const double as_good = 0.01;
    double window = (double)a->width / a->height;
    double meant = sqrt(pov_dot(c->right, c->right) / pov_dot(c->up, c->up));

    return a->sized || !(fabs(meant / window - 1.0) > as_good) ? window : meant;
}

void app_set_scene(app *a, const pov_camera *camera, double reach, double size, const pov_box *box)
{
    double shape = shape_of(a, camera);

    if (a->has_scene)
        orbit_set_home(&a->orbit, camera, reach, shape);
    else
        orbit_init(&a->orbit, camera, reach, shape);
    orbit_fit(&a->orbit, a->width, a->height);
    a->has_scene = true;
    a->size = size > 0.0 ? size : 1.0;
    a->has_box = box != NULL;
    if (box)
        a->box = *box;
    a->orders |= APP_DRAW;
}

pov_camera app_camera(const app *a)
{
    return orbit_camera(&a->orbit);
}

const char *app_view_name(app_view view)
{
    static const char *const names[APP_VIEWS] = { "picture", "normal", "depth", "samples", "time", "error",
                                                    "certainty" };

    return names[view];
}

double app_gain(const app *a)
{
    return pow(2.0, a->exposure / 3.0);
}

void app_say(app *a, double now, const char *format, ...)
{
    va_list list;

    va_start(list, format);
    vsnprintf(a->note, sizeof a->note, format, list);
    va_end(list);
    a->note_until = now + NOTE_SECONDS;
    a->orders |= APP_DRAW;
}

void app_zoom(app *a, double steps, double now)
{
    if (!zoom_step(&a->zoom, steps, a->x, a->y, a->width, a->height))
        return;
    if (zoom_is_on(&a->zoom))
        app_say(a, now, "%d : 1; a drag moves it, 0 shows all", a->zoom.factor);
    else
        app_say(a, now, "the whole picture");
}

/* ---- the help, where the window is too small for it ---- */

void app_scroll_help(app *a, double lines)
{
    const double line = 18.0;
    double to = a->help_from + lines * line * a->scale;

    to = to < a->help_below ? to : a->help_below;
    a->help_from = to > 0.0 ? to : 0.0;
    a->orders |= APP_DRAW;
}

void app_fit_help(app *a, double below)
{
    if (a->help_below == below)
        return;
    a->help_below = below;
    app_scroll_help(a, 0.0);
}

static bool help_scrolls(const app *a)
{
    return a->help && a->help_below > 0.0;
}

void app_compare_with(app *a, app_compare how, double now)
{
    if (a->reference_width < 1) {
        app_say(a, now, "nothing to compare with: start with --reference FILE");
        return;
    }
    a->compare = a->compare == how ? APP_PLAIN : how;
    a->view = APP_PICTURE;
    a->orders |= APP_VIEW;
    if (a->compare == APP_PLAIN)
        app_say(a, now, "picture");
    else if (a->reference_width != a->width || a->reference_height != a->height)
        app_say(a, now, "the reference, of %d x %d pixels, is scaled", a->reference_width, a->reference_height);
}

bool app_shows_reference(const app *a, double x)
{
    double pointer, y;

    app_pointed(a, &pointer, &y);
    return a->compare == APP_REFERENCE || (a->compare == APP_WIPE && x + 0.5 < pointer);
}

void app_pointed(const app *a, double *x, double *y)
{
    zoom_to_picture(&a->zoom, a->x, a->y, x, y);
}

/* ---- what is typed ---- */

static void command(app *a, int code, double now)
{
    const keys_row *row = keys_find(code);

    if (code >= '1' && code < '1' + a->choices) {
        a->chosen = code - '1';
        a->orders |= APP_OPEN;
        return;
    }
    if (row && (row->always || a->has_scene))
        row->act(a, now);
}

/* ---- flight ---- */

static double held(const app *a, char plus, char minus)
{
    double sum = 0.0;

    for (int i = 0; flight_keys[i]; i++)
        if (a->flying >> i & 1u)
            sum += flight_keys[i] == plus ? 1.0 : flight_keys[i] == minus ? -1.0 : 0.0;
    return sum;
}

/* Speed: a fifth of the scene in a second, or the distance to what the camera looks at if that is near; Shift is four
 * times as fast. Measured by the clock, so that slow scenes do not slow the flight. */
static void fly(app *a, double now)
{
    pov_vec3 ahead = a->orbit.camera.direction;
    double near = a->orbit.reach * sqrt(pov_dot(ahead, ahead)), speed = 0.2 * a->size, way;

    if (a->drag != APP_FLY || !a->flying || now <= a->flown) {
        a->flown = now;
        return;
    }
    speed = near < speed ? near : speed;
    way = (a->shift ? 4.0 : 1.0) * speed * (now - a->flown);
    orbit_fly(&a->orbit, way * held(a, 'D', 'A'), way * held(a, 'E', 'Q'), way * held(a, 'W', 'S'));
    a->flown = now;
    a->moved = true;
}

static void take_key(app *a, int code, bool down, double now)
{
    const char *key = code > 0 && code < 128 ? strchr(flight_keys, code) : NULL;

    if (code == APP_KEY_SHIFT)
        a->shift = down;
    if (code == APP_KEY_CONTROL)
        a->control = down;
    if (key) {
        unsigned bit = 1u << (key - flight_keys);

        fly(a, now);
        a->flying = down ? a->flying | bit : a->flying & ~bit;
    } else if (down) {
        command(a, code, now);
    }
}

/* ---- the pointer ---- */

static double probe(const app *a, double x, double y)
{
    return a->probe ? a->probe(a->probe_user, x, y) : 0.0;
}

static void take_button(app *a, int button, bool down, double now)
{
    if (!down) {
        if (a->drag != APP_NO_DRAG && button == a->drag_button)
            a->drag = APP_NO_DRAG;
        return;
    }
    if (a->drag != APP_NO_DRAG || !a->has_scene)
        return;
    a->drag_button = button;
    a->drag = button == APP_RIGHT ? APP_FLY
            : zoom_is_on(&a->zoom) ? APP_SHIFT
            : button == APP_MIDDLE || a->shift ? APP_PAN : APP_ORBIT;
    a->flown = now;
    orbit_set_reach(&a->orbit, probe(a, 0.5, 0.5));
}

static void take_pointer(app *a, double x, double y)
{
    double right = (x - a->x) / a->width, down = (y - a->y) / a->height;

    a->x = x;
    a->y = y;
    if (a->inspect || a->compare == APP_WIPE)
        a->orders |= APP_DRAW;
    if (a->drag == APP_NO_DRAG || (right == 0.0 && down == 0.0))
        return;
    if (a->drag == APP_SHIFT) {
        zoom_pan(&a->zoom, right * a->width, down * a->height, a->width, a->height);
        a->orders |= APP_DRAW;
        return;
    }
    if (a->drag == APP_ORBIT)
        orbit_turn(&a->orbit, right, down);
    else if (a->drag == APP_PAN)
        orbit_pan(&a->orbit, right, down);
    else
        orbit_look(&a->orbit, right, down);
    a->moved = true;
}

/* Over a help that does not fit, the wheel scrolls it. Magnified, it goes nearer to the pixels and leaves the camera where it is. */
static void take_wheel(app *a, double steps, double now)
{
    double x = a->x / a->width, y = a->y / a->height;

    if (help_scrolls(a)) {
        app_scroll_help(a, -WHEEL_LINES * steps);
        a->zoomed = now;
        return;
    }
    if (!a->has_scene || steps == 0.0)
        return;
    if (a->control || zoom_is_on(&a->zoom)) {
        app_zoom(a, steps, now);
        a->zoomed = now;
        return;
    }
    /* A wheel that turned too far is no order to the camera. */
    if (now < a->zoomed + WHEEL_SECONDS)
        return;
    orbit_dolly(&a->orbit, x, y, probe(a, x, y), steps);
    a->moved = true;
}

static void take_size(app *a, double width, double height, double scale)
{
    a->scale = scale > 0.0 ? scale : 1.0;
    a->orders |= APP_DRAW;
    /* A minimised window has no size; the old one is kept. */
    if (width < 1.0 || height < 1.0 || (a->width == (int)width && a->height == (int)height))
        return;
    a->width = (int)width;
    a->height = (int)height;
    if (a->has_scene)
        orbit_fit(&a->orbit, a->width, a->height);
    zoom_fit(&a->zoom, a->width, a->height);
    a->resized = true;
}

void app_take(app *a, const app_event *e, double now)
{
    switch (e->kind) {
    case APP_CHARACTER:
        /* While the right button is held, letters steer. */
        if (a->drag != APP_FLY)
            command(a, e->code, now);
        break;
    case APP_KEY: take_key(a, e->code, e->down, now); break;
    case APP_BUTTON: take_button(a, e->code, e->down, now); break;
    case APP_POINTER: take_pointer(a, e->x, e->y); break;
    case APP_WHEEL: take_wheel(a, e->y, now); break;
    case APP_SIZE: take_size(a, e->x, e->y, e->scale); break;
    case APP_LEAVE:
        a->flying = 0;
        a->shift = a->control = false;
        a->drag = APP_NO_DRAG;
        break;
    case APP_CLOSE: a->orders |= APP_QUIT; break;
    }
}

/* ---- what is to be done ---- */

unsigned app_update(app *a, double now, bool coarse_is_there)
{
    unsigned orders;

    fly(a, now);
    if (a->greets && a->has_scene) {
        app_say(a, now, "H: help");
        a->note_until = now + GREETING_SECONDS;
        a->greets = false;
    }
    if (a->note[0] && now >= a->note_until) {
        a->note[0] = '\0';
        a->orders |= APP_DRAW;
    }
    if ((a->moved || a->resized) && (coarse_is_there || now - a->restarted >= RESTART_SECONDS)) {
        a->orders |= a->resized ? APP_RESIZE | APP_DRAW : APP_RESTART;
        a->moved = a->resized = false;
        a->restarted = now;
    }
    orders = a->orders;
    a->orders = 0;
    return orders;
}

double app_patience(const app *a, double now)
{
    double left = -1.0;

    if (a->orders)
        return 0.0;
    if (a->drag == APP_FLY && a->flying)
        return FLIGHT_SECONDS;
    if (a->note[0])
        left = a->note_until > now ? a->note_until - now : 0.0;
    if (a->moved || a->resized) {
        double due = a->restarted + RESTART_SECONDS - now;

        due = due > 0.0 ? due : 0.0;
        left = left < 0.0 || due < left ? due : left;
    }
    return left;
}
