/* What leaves the window: pictures and cameras. */
#include "session_state.h"

#include "camera_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_SNAPSHOTS = 9999 };

/* File name: the scene's name without folder and ending, an unused number, .png; in the working folder. */
static bool free_name(session *s, char *out, size_t size)
{
    const char *path = s->path, *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
    size_t length = strcspn(base, ".");

    while (s->snapshot < MOST_SNAPSHOTS) {
        s->snapshot++;
        snprintf(out, size, "%.*s-%03d.png", (int)length, base, s->snapshot);
        if (access(out, F_OK) != 0)
            return true;
    }
    return false;
}

/* Is something else seen than the picture that povc would write? */
static bool is_colored(const session *s)
{
    return s->app->view != APP_PICTURE || s->app->compare != APP_PLAIN || s->app->clipped;
}

void session_save(session *s)
{
    const picture *from = &s->picture;
    helper_picture p = { s->job, NULL, from->width, from->height, app_gain(s->app), s->info.transfer };
    size_t bytes = (size_t)from->width * (size_t)from->height * 4;
    char name[300];

    if (!s->job || !free_name(s, name, sizeof name))
        return;
    if (is_colored(s)) {
        p.bytes = malloc(bytes);
        p.transfer = POV_TRANSFER_LINEAR;
        for (int i = 0; p.bytes && i < from->width * from->height; i++)
            memcpy(p.bytes + 4 * (size_t)i, session_seen_pixel(s, i % from->width, i / from->width), 4);
    }
    if ((is_colored(s) && !p.bytes) || !helper_save(s->helper, name, &p)) {
        free(p.bytes);
        app_say(s->app, s->now, "not saved: no memory");
    }
}

/* Short, and below it as a comment what is the same bit for bit. */
static void print_exact(const pov_camera *camera)
{
    char text[1024];
    const char *line = text;

    camera_text_exact(camera, text, sizeof text);
    puts("// The same bit for bit:");
    while (*line) {
        int count = (int)strcspn(line, "\n");

        printf("// %.*s\n", count, line);
        line += count + (line[count] == '\n');
    }
}

void session_print_camera(session *s)
{
    pov_camera camera = app_camera(s->app);
    char text[1024];

    camera_text(&camera, s->info.dialect, s->app->orbit.reach, text, sizeof text);
    s->desc.copy(s->desc.wake_user, text);
    fputs(text, stdout);
    print_exact(&camera);
    fflush(stdout);
    app_say(s->app, s->now, "the camera is copied, and printed on the terminal");
}
