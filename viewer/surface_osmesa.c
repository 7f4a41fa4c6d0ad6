#include "surface.h"

#include <GL/osmesa.h>

#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* The library is loaded at first use with local names: a window draws by libGL, which exports the same ones. It is
 * never unloaded, because it leaves threads and exit handlers. */
typedef struct library {
    void *handle;
    OSMesaContext (*create)(const int *attributes, OSMesaContext share);
    void (*destroy)(OSMesaContext context);
    GLboolean (*make_current)(OSMesaContext context, void *buffer, GLenum type, GLsizei width, GLsizei height);
    OSMESAproc (*get_proc)(const char *name);
    void (*finish)(void);        /* OpenGL's */
} library;

typedef struct memory_surface {
    surface base;
    library mesa;
    OSMesaContext context;
    int width, height;
    unsigned char *buffer;
    pthread_mutex_t lock;        /* guards posted */
    pthread_cond_t news;
    bool posted;
} memory_surface;

/* get_proc of the table has no place for a surface: the process has one library at most. */
static OSMESAproc (*mesa_get_proc)(const char *name);

static surface_call get_proc(const char *name)
{
    return (surface_call)mesa_get_proc(name);
}

static void get_size(surface *s, int *width, int *height, double *scale)
{
    const memory_surface *m = (const memory_surface *)s;

    *width = m->width;
    *height = m->height;
    *scale = 1.0;
}

static void wait_for_post(surface *s, double seconds)
{
    memory_surface *m = (memory_surface *)s;
    struct timespec until;

    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_sec += (time_t)seconds;
    until.tv_nsec += (long)((seconds - (double)(time_t)seconds) * 1e9);
    until.tv_sec += until.tv_nsec / 1000000000L;
    until.tv_nsec %= 1000000000L;
    pthread_mutex_lock(&m->lock);
    while (!m->posted)
        if (pthread_cond_timedwait(&m->news, &m->lock, &until) != 0)
            break;
    m->posted = false;
    pthread_mutex_unlock(&m->lock);
}

static void post(void *user)
{
    memory_surface *m = user;

    pthread_mutex_lock(&m->lock);
    m->posted = true;
    pthread_cond_signal(&m->news);
    pthread_mutex_unlock(&m->lock);
}

/* Orders are drawn when the picture is shown, which is now. */
static void swap(surface *s)
{
    ((memory_surface *)s)->mesa.finish();
}

static void fill_screen(surface *s, bool full)
{
    (void)s;
    (void)full;
}

static void hide(surface *s)
{
    (void)s;
}

static void set_title(surface *s, const char *title)
{
    (void)s;
    (void)title;
}

static void copy(void *s, const char *text)
{
    (void)s;
    (void)text;
}

static void close_memory(surface *s)
{
    memory_surface *m = (memory_surface *)s;

    if (m->context)
        m->mesa.destroy(m->context);
    pthread_cond_destroy(&m->news);
    pthread_mutex_destroy(&m->lock);
    free(m->buffer);
    free(m);
}

/* C99 has no cast from a data pointer to a function pointer; in POSIX both have one size. */
static bool fetch(library *l, const char *name, void *out)
{
    void *found = dlsym(l->handle, name);

    memcpy(out, &found, sizeof found);
    return found != NULL;
}

static bool open_library(library *l)
{
    static const char *const names[] = { "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so" };

    for (size_t i = 0; i < sizeof names / sizeof names[0] && !l->handle; i++)
        l->handle = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
    if (!l->handle || !fetch(l, "OSMesaCreateContextAttribs", &l->create) ||
        !fetch(l, "OSMesaDestroyContext", &l->destroy) || !fetch(l, "OSMesaMakeCurrent", &l->make_current) ||
        !fetch(l, "OSMesaGetProcAddress", &l->get_proc) ||
        !fetch(l, "glFinish", &l->finish))
        return false;
    mesa_get_proc = l->get_proc;
    return true;
}

bool surface_osmesa_resize(surface *s, int width, int height)
{
    memory_surface *m = (memory_surface *)s;
    unsigned char *larger = malloc((size_t)width * (size_t)height * 4);
    app_event event = { APP_SIZE, 0, false, width, height, 1.0 };

    if (!larger || !m->mesa.make_current(m->context, larger, GL_UNSIGNED_BYTE, width, height)) {
        free(larger);
        return false;
    }
    free(m->buffer);
    m->buffer = larger;
    m->width = width;
    m->height = height;
    if (m->base.sink)
        m->base.sink(m->base.sink_user, &event);
    return true;
}

static void say(pov_error *err, const char *message)
{
    err->status = POV_E_IO;
    snprintf(err->message, sizeof err->message, "%s", message);
}

surface *surface_osmesa_open(int width, int height, pov_error *err)
{
    static const int attributes[] = { OSMESA_FORMAT, OSMESA_RGBA, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE,
                                      OSMESA_CONTEXT_MAJOR_VERSION, 2, OSMESA_CONTEXT_MINOR_VERSION, 1, 0 };
    memory_surface *m = calloc(1, sizeof *m);
    pthread_condattr_t monotonic;

    if (!m) {
        say(err, "no memory for a picture");
        return NULL;
    }
    m->base.get_proc = get_proc;
    m->base.get_size = get_size;
    m->base.wait = wait_for_post;
    m->base.swap = swap;
    m->base.set_title = set_title;
    m->base.copy = copy;
    m->base.fill_screen = fill_screen;
    m->base.hide = hide;
    m->base.post = post;
    m->base.close = close_memory;
    pthread_mutex_init(&m->lock, NULL);
    pthread_condattr_init(&monotonic);
    pthread_condattr_setclock(&monotonic, CLOCK_MONOTONIC);
    pthread_cond_init(&m->news, &monotonic);
    pthread_condattr_destroy(&monotonic);
    if (!open_library(&m->mesa))
        say(err, "cannot draw without a display: libOSMesa was not found");
    else if (!(m->context = m->mesa.create(attributes, NULL)))
        say(err, "cannot draw without a display: OSMesa gives no OpenGL 2.1");
    else if (!surface_osmesa_resize(&m->base, width, height))
        say(err, "cannot draw without a display: OSMesa takes no picture of this size");
    else
        return &m->base;
    close_memory(&m->base);
    return NULL;
}
