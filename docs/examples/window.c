/* A window in which a scene becomes a picture, from coarse to fine; a drag turns the camera: window SCENE. */
#include <GLFW/glfw3.h>
#include <povtrace/povtrace.h>

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 800, HEIGHT = 600 };

typedef struct viewer {
    pov_scene *scene;
    pov_job *job;
    pov_camera camera;
    pov_vec3 middle;           /* of the scene: the camera turns about it */
    uint8_t *pixels;
    double x;                  /* the pointer when it was last seen */
    bool moved;
} viewer;

/* From a thread of the job: poke the loop, no more. */
static void wake(void *user)
{
    (void)user;
    glfwPostEmptyEvent();
}

static void on_pointer(GLFWwindow *window, double x, double y)
{
    viewer *v = glfwGetWindowUserPointer(window);
    double angle = (x - v->x) * 0.01;
    pov_vec3 from = pov_sub(v->camera.location, v->middle);

    (void)y;
    v->x = x;
    if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) != GLFW_PRESS)
        return;
    from = pov_vec3_of(from.x * cos(angle) + from.z * sin(angle), from.y, from.z * cos(angle) - from.x * sin(angle));
    pov_camera_look_at(&v->camera, pov_add(v->middle, from), v->middle, pov_vec3_of(0, 1, 0), NULL);
    v->moved = true;
}

/* What is new goes into our pixels a tile at a time; the rest keeps what was there before. */
static void take_tiles(viewer *v)
{
    pov_rect tile;

    while (pov_job_take(v->job, &tile))
        pov_job_read(v->job, tile, POV_PIXELS_DISPLAY8, v->pixels + 4 * ((size_t)tile.y * WIDTH + (size_t)tile.x),
                     WIDTH * 4);
}

static void run(viewer *v, GLFWwindow *window)
{
    void (*place)(GLint, GLint) = (void (*)(GLint, GLint))glfwGetProcAddress("glWindowPos2i");
    void (*zoom)(GLfloat, GLfloat) = (void (*)(GLfloat, GLfloat))glfwGetProcAddress("glPixelZoom");
    void (*draw)(GLsizei, GLsizei, GLenum, GLenum, const void *) =
        (void (*)(GLsizei, GLsizei, GLenum, GLenum, const void *))glfwGetProcAddress("glDrawPixels");

    place(0, HEIGHT);
    zoom(1.0f, -1.0f);         /* OpenGL's first row is the lowest */
    while (!glfwWindowShouldClose(window) && glfwGetKey(window, GLFW_KEY_ESCAPE) != GLFW_PRESS) {
        if (v->moved)
            pov_job_restart(v->job, &v->camera);
        v->moved = false;
        take_tiles(v);
        draw(WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, v->pixels);
        glfwSwapBuffers(window);
        glfwWaitEvents();
    }
}

static pov_status open_scene(viewer *v, pov_context *context, const char *path, pov_error *err)
{
    pov_render_desc desc = POV_INIT(desc);
    pov_box box = { { 0, 0, 0 }, { 0, 0, 0 } };
    pov_status status = pov_scene_load_file(&v->scene, context, path, NULL, err);

    if (status < 0)
        return status;
    v->camera.size = sizeof v->camera;
    pov_scene_get_camera(v->scene, &v->camera);
    pov_scene_get_bounds(v->scene, &box);
    v->middle = pov_scale(pov_add(box.lo, box.hi), 0.5);
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.preview = 16;
    desc.wake = wake;
    status = pov_job_create(&v->job, v->scene, &desc, err);
    return status < 0 ? status : pov_job_start(v->job, err);
}

int main(int argc, char **argv)
{
    viewer v = { 0 };
    pov_context *context = NULL;
    pov_error err = { 0 };
    GLFWwindow *window;

    if (argc != 2 || !glfwInit())
        return 2;
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    window = glfwCreateWindow(WIDTH, HEIGHT, argv[1], NULL, NULL);
    v.pixels = calloc(WIDTH * HEIGHT, 4);
    if (window && v.pixels && pov_context_create(&context, NULL, &err) == POV_OK &&
        open_scene(&v, context, argv[1], &err) == POV_OK) {
        glfwMakeContextCurrent(window);
        glfwSetWindowUserPointer(window, &v);
        glfwSetCursorPosCallback(window, on_pointer);
        run(&v, window);
    }
    if (err.status < 0)
        fprintf(stderr, "%s:%d:%d: %s\n", err.file, err.line, err.column, err.message);
    pov_job_destroy(v.job);
    pov_scene_destroy(v.scene);
    pov_context_destroy(context);
    free(v.pixels);
    glfwTerminate();
    return err.status < 0;
}
