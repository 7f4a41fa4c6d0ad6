/* scenes.h - the tree's scenes, and rendering them through the public calls. */
#ifndef SUPPORT_SCENES_H
#define SUPPORT_SCENES_H

#include <povtrace/povtrace.h>

#define TEST_PLUGINS TEST_BUILD "/lib/povtrace"
/* The primitives for the copy of the library that the test is linked with. */
#define TEST_PRIMITIVES TEST_PLUGINS "/primitives/" TEST_COPY

/* Paths of all scenes of a folder of scenes/, sorted; NULL ends. Free with scenes_free(). */
char **scenes_list(const char *folder);
void scenes_free(char **list);

/* Does the file's name, without its folder, begin with one of these? NULL ends. */
bool scenes_is_one_of(const char *path, const char *const *names);

/* A context that finds the built plugins and logs nothing. */
pov_context *scenes_context(void);
/* The whole picture, linear float RGBA; the caller frees it. Fails the test on any error. */
float *scenes_render(const pov_scene *scene, const pov_render_desc *desc);
/* Load text, or fail the test. */
pov_scene *scenes_text(pov_context *context, const char *text);
/* Load text and render it. */
float *scenes_draw_as(const char *text, const pov_render_desc *desc);
/* 0 samples or threads: the defaults. */
float *scenes_draw(const char *text, int width, int height, int samples, int threads);

#endif
