#include "caption.h"

#include "add.h"

#include <string.h>

/* Legend of a view's colours. */
static const char *legend(app_view view)
{
    static const char *const legends[APP_VIEWS] = {
        "", "#normal\n red x, green y, blue z: -1 dark, 1 bright\n", "#depth\n white near, black far\n",
        "#samples a pixel\n~1\t32\t1024\n", "#processor time a pixel\n~1 \xc2\xb5s\t100 \xc2\xb5s\t10 ms\n",
        "#error\n~0.0001\t0.003\t0.1\n grey: not known\n",
        "#certainty\n blue: double decides; orange: double-double needed\n",
    };

    return legends[view];
}

static void write_comparison(const app *a, const session *s, char *out, size_t size)
{
    const char *path = session_reference_path(s), *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    double rms = session_reference_rms(s);

    if (a->compare == APP_REFERENCE) {
        add(out, size, "#the reference\n %.100s\n", name);
    } else if (a->compare == APP_WIPE) {
        add(out, size, "#left: the reference\n %.100s\n#right: the picture\n", name);
    } else {
        add(out, size, "#difference from %.100s\n~0.0001\t0.003\t0.1\n linear light, the largest of three\n", name);
        if (rms >= 0.0)
            add(out, size, " root mean square %.2g\n", rms);
    }
}

void caption_write(const app *a, const session *s, char *out, size_t size)
{
    if (a->compare != APP_PLAIN)
        write_comparison(a, s, out, size);
    else
        add(out, size, "%s", legend(a->view));
}
