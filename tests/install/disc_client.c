/* disc_client.c - the disc plugin built out of tree, compiled into a program and given to a context. */
#include <povtrace/shape.h>
#include <povtrace/povtrace.h>

#include <stdio.h>
#include <string.h>

extern const pov_plugin povtrace_plugin;

int main(void)
{
    static const char text[] = "disc { <0, 0, 5>, <0, 0, 1>, 2, .5 }";
    pov_context *context = NULL;
    pov_scene *scene = NULL;
    pov_tracer *tracer = NULL;
    pov_error err = { POV_OK, 0, 0, 0, "", "", "", "" };
    pov_hit hit = POV_INIT(hit);
    const char *name, *path;
    bool met, through_hole;

    if (pov_context_create(&context, NULL, &err) < 0 ||
        pov_context_add_plugin(context, &povtrace_plugin, &err) < 0 ||
        pov_scene_load_text(&scene, context, text, strlen(text), "text", NULL, &err) < 0 ||
        pov_tracer_create(&tracer, scene, &err) < 0) {
        fprintf(stderr, "%s\n", err.message);
        return 1;
    }
    met = pov_trace_hit(tracer, pov_vec3_of(1, 0, 0), pov_vec3_of(0, 0, 1), &hit);
    through_hole = !pov_trace_blocked(tracer, pov_vec3_of(0.1, 0, 0), pov_vec3_of(0.1, 0, 9));
    if (!pov_context_get_plugin(context, 0, &name, &path))
        return 2;
    printf("%s from \"%s\": distance %g, %s\n", name, path, hit.distance, through_hole ? "hole" : "no hole");
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return met && hit.distance == 5.0 && through_hole && path[0] == '\0' ? 0 : 3;
}
