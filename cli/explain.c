#include "explain.h"

#include <string.h>

typedef struct widths { int subject, state; } widths;

static widths measure(const pov_scene *scene)
{
    widths w = { 7, 5 };
    pov_plan_row row = POV_INIT(row);

    for (size_t i = 0; pov_scene_get_plan(scene, i, &row); i++) {
        int subject = (int)strlen(row.subject), state = (int)strlen(row.state);

        w.subject = subject > w.subject ? subject : w.subject;
        w.state = state > w.state ? state : w.state;
    }
    return w;
}

/* What is used stands before what was left out. */
void explain_print(FILE *to, const pov_scene *scene)
{
    widths w = measure(scene);
    pov_plan_row row = POV_INIT(row);

    fprintf(to, "  %-*s  %-*s  %s\n", w.subject, "SUBJECT", w.state, "STATE", "REASON");
    for (int used = 1; used >= 0; used--) {
        for (size_t i = 0; pov_scene_get_plan(scene, i, &row); i++) {
            if (row.used == (used == 1))
                fprintf(to, "%c %-*s  %-*s  %s\n", used ? '+' : '-', w.subject, row.subject, w.state,
                        row.state, row.reason);
        }
    }
}
