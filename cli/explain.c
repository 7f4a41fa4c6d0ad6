#include "explain.h"

#include <string.h>

typedef struct widths { int subject, state; } widths;

static widths measure(const pov_scene *scene)
{
    widths w = { 7, (int)strlen(pov_built_for()) };
    pov_plan_row row = POV_INIT(row);

    for (size_t i = 0; pov_scene_get_plan(scene, i, &row); i++) {
        int subject = (int)strlen(row.subject), state = (int)strlen(row.state);

        w.subject = subject > w.subject ? subject : w.subject;
        w.state = state > w.state ? state : w.state;
    }
    return w;
}

static void print_row(FILE *to, widths w, bool used, const char *subject, const char *state,
                      const char *reason)
{
    fprintf(to, "%c %-*s  %-*s  %s\n", used ? '+' : '-', w.subject, subject, w.state, state, reason);
}

static void print_rows(FILE *to, widths w, const pov_scene *scene, bool used)
{
    pov_plan_row row = POV_INIT(row);

    for (size_t i = 0; pov_scene_get_plan(scene, i, &row); i++) {
        if (row.used == used)
            print_row(to, w, used, row.subject, row.state, row.reason);
    }
}

static bool is_in_plan(const pov_scene *scene, const char *subject)
{
    pov_plan_row row = POV_INIT(row);

    for (size_t i = 0; pov_scene_get_plan(scene, i, &row); i++) {
        if (strcmp(row.subject, subject) == 0)
            return true;
    }
    return false;
}

static void print_other_plugins(FILE *to, widths w, pov_context *context, const pov_scene *scene)
{
    const char *name, *path;
    char subject[80];

    for (size_t i = 0; pov_context_get_plugin(context, i, &name, &path); i++) {
        snprintf(subject, sizeof subject, "plugin %s", name);
        if (!is_in_plan(scene, subject))
            print_row(to, w, true, subject, "loaded", "writes the output");
    }
}

static void print_library(FILE *to, widths w)
{
    bool wide = strcmp(pov_built_for(), "baseline") != 0;

    print_row(to, w, true, "library", pov_built_for(),
              wide ? "this processor can run the wider of the copies" : "the copy that any processor can run");
}

/* Used parts come before parts that were left out. */
void explain_print(FILE *to, pov_context *context, const pov_scene *scene)
{
    widths w = measure(scene);

    fprintf(to, "  %-*s  %-*s  %s\n", w.subject, "SUBJECT", w.state, "STATE", "REASON");
    print_library(to, w);
    print_rows(to, w, scene, true);
    print_other_plugins(to, w, context, scene);
    print_rows(to, w, scene, false);
}
