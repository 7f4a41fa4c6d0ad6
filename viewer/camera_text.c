#include "camera_text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void add(char *out, size_t size, const char *format, ...) POV_PRINTF(3, 4);

static void add(char *out, size_t size, const char *format, ...)
{
    size_t used = strlen(out);
    va_list list;

    va_start(list, format);
    vsnprintf(out + used, size - used, format, list);
    va_end(list);
}

/* The fewest digits that read back as the same number. */
static void add_number(char *out, size_t size, double value)
{
    char digits[40];

    for (int n = 1; n <= 17; n++) {
        snprintf(digits, sizeof digits, "%.*g", n, value);
        if (strtod(digits, NULL) == value)
            break;
    }
    add(out, size, "%s", digits);
}

static void add_vector(char *out, size_t size, const char *word, pov_vec3 v)
{
    add(out, size, "    %s <", word);
    add_number(out, size, v.x);
    add(out, size, ", ");
    add_number(out, size, v.y);
    add(out, size, ", ");
    add_number(out, size, v.z);
    add(out, size, ">\n");
}

static double length(pov_vec3 v)
{
    return sqrt(pov_dot(v, v));
}

/* The course dialect's rules make nothing but upright left-handed frames. */
static bool is_plain(const pov_camera *c)
{
    const double square = 1e-9;
    pov_vec3 d = pov_unit(c->direction), r = pov_unit(c->right), u = pov_unit(c->up);

    return fabs(pov_dot(d, r)) < square && fabs(pov_dot(d, u)) < square && fabs(pov_dot(r, u)) < square &&
           pov_dot(pov_cross_product(u, d), r) > 0.0;
}

void camera_text(const pov_camera *c, pov_dialect dialect, double reach, char *out, size_t size)
{
    const double pi = 3.14159265358979323846, unit_direction = 4e-16;
    bool plain = dialect == POV_DIALECT_COURSE && is_plain(c);

    out[0] = '\0';
    add(out, size, "camera {\n");
    add_vector(out, size, "location", c->location);
    if (!plain)
        add_vector(out, size, "direction", c->direction);
    add_vector(out, size, "right", c->right);
    add_vector(out, size, "up", c->up);
    if (plain) {
        if (fabs(length(c->direction) - 1.0) > unit_direction) {
            add(out, size, "    angle ");
            add_number(out, size, atan2(0.5 * length(c->right), length(c->direction)) * 360.0 / pi);
            add(out, size, "\n");
        }
        add_vector(out, size, "look_at", pov_add(c->location, pov_scale(c->direction, reach)));
    }
    add(out, size, "}\n");
}
