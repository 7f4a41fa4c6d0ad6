#include "surface.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <stdio.h>
#include <stdlib.h>

typedef struct window_surface {
    surface base;
    GLFWwindow *window;
    int x, y, width, height;     /* of the window, while it has the whole screen */
} window_surface;

static void deliver(GLFWwindow *window, app_event event)
{
    window_surface *w = glfwGetWindowUserPointer(window);

    if (w->base.sink)
        w->base.sink(w->base.sink_user, &event);
}

/* ---- events, in the viewer's own words ---- */

static int key_code(int key)
{
    switch (key) {
    case GLFW_KEY_ENTER: case GLFW_KEY_KP_ENTER: return APP_KEY_ENTER;
    case GLFW_KEY_TAB: return APP_KEY_TAB;
    case GLFW_KEY_ESCAPE: return APP_KEY_ESCAPE;
    case GLFW_KEY_F1: return APP_KEY_F1;
    case GLFW_KEY_F5: return APP_KEY_F5;
    case GLFW_KEY_F11: return APP_KEY_F11;
    case GLFW_KEY_UP: return APP_KEY_UP;
    case GLFW_KEY_DOWN: return APP_KEY_DOWN;
    case GLFW_KEY_PAGE_UP: return APP_KEY_PAGE_UP;
    case GLFW_KEY_PAGE_DOWN: return APP_KEY_PAGE_DOWN;
    case GLFW_KEY_HOME: return APP_KEY_HOME;
    case GLFW_KEY_LEFT_SHIFT: case GLFW_KEY_RIGHT_SHIFT: return APP_KEY_SHIFT;
    case GLFW_KEY_LEFT_CONTROL: case GLFW_KEY_RIGHT_CONTROL: return APP_KEY_CONTROL;
    /* Keys by position, because they steer; GLFW's names are the ASCII codes of the American layout. */
    case GLFW_KEY_W: case GLFW_KEY_A: case GLFW_KEY_S: case GLFW_KEY_D: case GLFW_KEY_Q: case GLFW_KEY_E: return key;
    default: return 0;
    }
}

static void on_key(GLFWwindow *window, int key, int scancode, int action, int modifiers)
{
    app_event event = { APP_KEY, key_code(key), action != GLFW_RELEASE, 0.0, 0.0, 0.0 };
    const bool scrolls = event.code >= APP_KEY_UP && event.code <= APP_KEY_PAGE_DOWN;

    (void)scancode;
    if (key == GLFW_KEY_Q && (modifiers & GLFW_MOD_CONTROL))
        event.kind = APP_CLOSE;
    if (event.code && (action != GLFW_REPEAT || scrolls))
        deliver(window, event);
}

static void on_character(GLFWwindow *window, unsigned code)
{
    app_event event = { APP_CHARACTER, (int)code, true, 0.0, 0.0, 0.0 };

    deliver(window, event);
}

static void on_button(GLFWwindow *window, int button, int action, int modifiers)
{
    static const int buttons[] = { APP_LEFT, APP_RIGHT, APP_MIDDLE };
    app_event event = { APP_BUTTON, 0, action == GLFW_PRESS, 0.0, 0.0, 0.0 };

    (void)modifiers;
    if (button < 0 || button > 2)
        return;
    event.code = buttons[button];
    deliver(window, event);
}

/* The pointer is in units of the window, which are larger than pixels on some displays. */
static void on_pointer(GLFWwindow *window, double x, double y)
{
    app_event event = { APP_POINTER, 0, false, x, y, 0.0 };
    int width, height, pixels_across, pixels_down;

    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &pixels_across, &pixels_down);
    if (width < 1 || height < 1)
        return;
    event.x = x * pixels_across / width;
    event.y = y * pixels_down / height;
    deliver(window, event);
}

static void on_wheel(GLFWwindow *window, double x, double y)
{
    app_event event = { APP_WHEEL, 0, false, x, y, 0.0 };

    deliver(window, event);
}

static void get_size(surface *s, int *width, int *height, double *scale)
{
    float across, down;
    GLFWwindow *window = ((window_surface *)s)->window;

    glfwGetFramebufferSize(window, width, height);
    glfwGetWindowContentScale(window, &across, &down);
    *scale = down;
}

static void on_size(GLFWwindow *window, int width, int height)
{
    app_event event = { APP_SIZE, 0, false, 0.0, 0.0, 0.0 };

    get_size(glfwGetWindowUserPointer(window), &width, &height, &event.scale);
    event.x = width;
    event.y = height;
    deliver(window, event);
}

static void on_scale(GLFWwindow *window, float across, float down)
{
    (void)across;
    (void)down;
    on_size(window, 0, 0);
}

static void on_focus(GLFWwindow *window, int focused)
{
    app_event event = { APP_LEAVE, 0, false, 0.0, 0.0, 0.0 };

    if (!focused)
        deliver(window, event);
}

static void on_refresh(GLFWwindow *window)
{
    on_size(window, 0, 0);
}

static void on_close(GLFWwindow *window)
{
    app_event event = { APP_CLOSE, 0, false, 0.0, 0.0, 0.0 };

    deliver(window, event);
}

/* One scene is shown; of several files it is the first. */
static void on_drop(GLFWwindow *window, int count, const char **paths)
{
    window_surface *w = glfwGetWindowUserPointer(window);

    if (count > 0 && w->base.take_file)
        w->base.take_file(w->base.sink_user, paths[0]);
}

/* ---- the surface ---- */

static surface_call get_proc(const char *name)
{
    return (surface_call)glfwGetProcAddress(name);
}

static void wait_for_events(surface *s, double seconds)
{
    (void)s;
    if (seconds > 0.0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
}

static void swap(surface *s)
{
    glfwSwapBuffers(((window_surface *)s)->window);
}

static void set_title(surface *s, const char *title)
{
    glfwSetWindowTitle(((window_surface *)s)->window, title);
}

static void copy(void *s, const char *text)
{
    glfwSetClipboardString(((window_surface *)s)->window, text);
}

/* The screen that the middle of the window is on; NULL: there is none. */
static GLFWmonitor *screen_of(const window_surface *w)
{
    int count = 0, x, y, wide, high;
    GLFWmonitor **all = glfwGetMonitors(&count);

    for (int i = 0; i < count; i++) {
        const GLFWvidmode *mode = glfwGetVideoMode(all[i]);
        const int right = w->x + w->width / 2, down = w->y + w->height / 2;

        glfwGetMonitorPos(all[i], &x, &y);
        wide = mode ? mode->width : 0;
        high = mode ? mode->height : 0;
        if (right >= x && right < x + wide && down >= y && down < y + high)
            return all[i];
    }
    return glfwGetPrimaryMonitor();
}

static void fill_screen(surface *s, bool full)
{
    window_surface *w = (window_surface *)s;
    const bool is_full = glfwGetWindowMonitor(w->window) != NULL;
    const GLFWvidmode *mode;
    GLFWmonitor *screen;

    if (full == is_full)
        return;
    if (!full) {
        glfwSetWindowMonitor(w->window, NULL, w->x, w->y, w->width, w->height, GLFW_DONT_CARE);
        return;
    }
    glfwGetWindowPos(w->window, &w->x, &w->y);
    glfwGetWindowSize(w->window, &w->width, &w->height);
    screen = screen_of(w);
    mode = screen ? glfwGetVideoMode(screen) : NULL;
    if (mode)
        glfwSetWindowMonitor(w->window, screen, 0, 0, mode->width, mode->height, mode->refreshRate);
}

static void hide(surface *s)
{
    glfwHideWindow(((window_surface *)s)->window);
    glfwPollEvents();
}

static void post(void *s)
{
    (void)s;
    glfwPostEmptyEvent();
}

static void close_window(surface *s)
{
    glfwDestroyWindow(((window_surface *)s)->window);
    glfwTerminate();
    free(s);
}

static void listen_to(GLFWwindow *window)
{
    glfwSetKeyCallback(window, on_key);
    glfwSetCharCallback(window, on_character);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_pointer);
    glfwSetScrollCallback(window, on_wheel);
    glfwSetFramebufferSizeCallback(window, on_size);
    glfwSetWindowContentScaleCallback(window, on_scale);
    glfwSetWindowFocusCallback(window, on_focus);
    glfwSetWindowRefreshCallback(window, on_refresh);
    glfwSetWindowCloseCallback(window, on_close);
    glfwSetDropCallback(window, on_drop);
}

static surface *refuse(surface *s, pov_error *err)
{
    const char *why = NULL;

    glfwGetError(&why);
    err->status = POV_E_IO;
    snprintf(err->message, sizeof err->message,
             "cannot open a window (%s); --shot FILE.png draws without a display", why ? why : "no memory");
    free(s);
    return NULL;
}

surface *surface_glfw_open(int width, int height, const char *title, pov_error *err)
{
    window_surface *w = calloc(1, sizeof *w);

    if (!w || !glfwInit())
        return refuse((surface *)w, err);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    w->window = glfwCreateWindow(width, height, title, NULL, NULL);
    if (!w->window) {
        refuse((surface *)w, err);
        glfwTerminate();
        return NULL;
    }
    w->base.get_proc = get_proc;
    w->base.get_size = get_size;
    w->base.wait = wait_for_events;
    w->base.swap = swap;
    w->base.set_title = set_title;
    w->base.copy = copy;
    w->base.fill_screen = fill_screen;
    w->base.hide = hide;
    w->base.post = post;
    w->base.close = close_window;
    glfwSetWindowUserPointer(w->window, w);
    glfwMakeContextCurrent(w->window);
    glfwSwapInterval(1);
    listen_to(w->window);
    return &w->base;
}
