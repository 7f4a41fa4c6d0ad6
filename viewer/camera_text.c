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

static double length(pov_vec3 v)
{
    return sqrt(pov_dot(v, v));
}

/* ---- numbers ---- */

/* The fewest digits that read back as the same number. */
static void add_exact(char *out, size_t size, double value)
{
    char digits[40];

    for (int n = 1; n <= 17; n++) {
        snprintf(digits, sizeof digits, "%.*g", n, value);
        if (strtod(digits, NULL) == value)
            break;
    }
    add(out, size, "%s", digits);
}

/* To a hundred-thousandth of `whole`, without zeros at the end. */
static void add_short(char *out, size_t size, double value, double whole)
{
    int decimals = (int)ceil(5.0 - log10(whole));
    char digits[400];
    char *end;

    decimals = decimals < 0 ? 0 : decimals < 40 ? decimals : 40;
    snprintf(digits, sizeof digits, "%.*f", decimals, value);
    end = digits + strlen(digits);
    while (decimals > 0 && end[-1] == '0')
        *--end = '\0';
    if (end[-1] == '.')
        *--end = '\0';
    add(out, size, "%s", strcmp(digits, "-0") == 0 ? "0" : digits);
}

static void add_vector(char *out, size_t size, const char *word, pov_vec3 v, double whole)
{
    const double parts[3] = { v.x, v.y, v.z };

    add(out, size, "    %s <", word);
    for (int i = 0; i < 3; i++) {
        add(out, size, i ? ", " : "");
        if (whole > 0.0)
            add_short(out, size, parts[i], whole);
        else
            add_exact(out, size, parts[i]);
    }
    add(out, size, ">\n");
}

static void add_number(char *out, size_t size, const char *word, double value)
{
    add(out, size, "    %s ", word);
    add_short(out, size, value, fabs(value));
    add(out, size, "\n");
}

/* ---- what can be written short ---- */

static bool is_square(const pov_camera *c)
{
    const double square = 1e-9;
    pov_vec3 d = pov_unit(c->direction), r = pov_unit(c->right), u = pov_unit(c->up);

    return fabs(pov_dot(d, r)) < square && fabs(pov_dot(d, u)) < square && fabs(pov_dot(r, u)) < square;
}

static bool is_mirrored(const pov_camera *c)
{
    return !(pov_dot(pov_cross_product(c->up, c->direction), c->right) > 0.0);
}

/* The vertical that look_at gives this camera back: an axis if one does, else its own up. */
static pov_vec3 vertical(const pov_camera *c)
{
    const double level = 1e-9, hardly = 1e-4;
    const pov_vec3 axes[3] = { pov_vec3_of(0, 1, 0), pov_vec3_of(0, 0, 1), pov_vec3_of(1, 0, 0) };
    pov_vec3 right = pov_unit(c->right), up = pov_unit(c->up);

    for (int i = 0; i < 3; i++)
        if (fabs(pov_dot(right, axes[i])) < level && fabs(pov_dot(up, axes[i])) > hardly)
            return pov_dot(up, axes[i]) > 0.0 ? axes[i] : pov_scale(axes[i], -1.0);
    return up;
}

static const char *const types[POV_CAMERA_TYPES] = {
    "", "    orthographic\n", "    fisheye\n", "    ultra_wide_angle\n", "    omnimax\n", "    panoramic\n",
    "    spherical\n", "    cylinder 1\n", "    cylinder 2\n", "    cylinder 3\n", "    cylinder 4\n",
};

static void add_angle(char *out, size_t size, const pov_camera *c)
{
    const double degree = 3.14159265358979323846 / 180.0;

    if (c->type == POV_CAMERA_PERSPECTIVE)
        add_number(out, size, "angle", 2.0 * atan2(0.5 * length(c->right), length(c->direction)) / degree);
    else if (c->type == POV_CAMERA_SPHERICAL)
        add(out, size, "    angle %.6g, %.6g\n", c->angles[0] / degree, c->angles[1] / degree);
    else if (c->type != POV_CAMERA_ORTHOGRAPHIC)
        add_number(out, size, "angle", c->angles[0] / degree);
}

static void add_lens(char *out, size_t size, const pov_camera *c)
{
    if (!(c->lens_radius > 0.0))
        return;
    add_number(out, size, "aperture", 4.0 * c->lens_radius);
    add(out, size, "    blur_samples %d\n", c->lens_samples);
    add_vector(out, size, "focal_point", pov_add(c->location, pov_scale(pov_unit(c->direction), c->focal_distance)),
               c->focal_distance);
}

/* In the povray dialect the vertical is `sky`, in the course dialect `up`. */
static void add_axes(char *out, size_t size, const pov_camera *c, pov_dialect dialect)
{
    const double far = 1.0;
    pov_vec3 sky = vertical(c);
    double sign = is_mirrored(c) ? -1.0 : 1.0;

    if (dialect == POV_DIALECT_COURSE) {
        add_vector(out, size, "right", pov_vec3_of(length(c->right), 0, 0), length(c->right));
        add_vector(out, size, "up", pov_scale(sky, length(c->up)), length(c->up));
        return;
    }
    if (!(sky.y == 1.0))
        add_vector(out, size, "sky", sky, far);
    if (c->type != POV_CAMERA_PERSPECTIVE && length(c->direction) != 1.0)
        add_number(out, size, "direction z *", length(c->direction));
    add_number(out, size, "right x *", sign * length(c->right));
    if (length(c->up) != 1.0)
        add_number(out, size, "up y *", length(c->up));
}

/* ---- the text ---- */

void camera_text_exact(const pov_camera *c, char *out, size_t size)
{
    out[0] = '\0';
    add(out, size, "camera {\n%s", types[c->type]);
    add_vector(out, size, "location", c->location, 0.0);
    add_vector(out, size, "direction", c->direction, 0.0);
    add_vector(out, size, "right", c->right, 0.0);
    add_vector(out, size, "up", c->up, 0.0);
    if (c->type != POV_CAMERA_PERSPECTIVE)
        add_angle(out, size, c);
    add_lens(out, size, c);
    add(out, size, "}\n");
}

void camera_text(const pov_camera *c, pov_dialect dialect, double reach, char *out, size_t size)
{
    bool plain = c->type == POV_CAMERA_PERSPECTIVE && !is_mirrored(c);
    double whole = reach * length(c->direction);

    if (!is_square(c) || (dialect == POV_DIALECT_COURSE && !plain) || !(whole > 0.0 && whole < HUGE_VAL)) {
        camera_text_exact(c, out, size);
        return;
    }
    out[0] = '\0';
    add(out, size, "camera {\n%s", types[c->type]);
    add_vector(out, size, "location", c->location, whole);
    add_axes(out, size, c, dialect);
    add_angle(out, size, c);
    add_vector(out, size, "look_at", pov_add(c->location, pov_scale(c->direction, reach)), whole);
    add_lens(out, size, c);
    add(out, size, "}\n");
}
