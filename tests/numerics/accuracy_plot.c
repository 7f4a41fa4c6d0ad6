/* accuracy_plot.c - the two plots of the accuracy report, as SVG and PNG.
 *
 * accuracy_plot FOLDER reads lines `plot panel method x y promise clean` and draws FOLDER/accuracy-<plot>: six panels of
 * logarithmic axes, a mark for each line, the promise as a dashed line. A mark that is not clean, where hits were
 * misjudged, is hollow. accuracy_report.py makes the lines. */
#include <cairo-svg.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_MAX = 1024, PANELS = 6, METHODS = 5, ACROSS = 3 };
enum { PANEL_WIDTH = 300, PANEL_HEIGHT = 230, LEFT = 54, TOP = 26, BOTTOM = 40, RIGHT = 12, HEAD = 44, FOOT = 40 };
enum { WIDTH = ACROSS * PANEL_WIDTH, HEIGHT = HEAD + PANELS / ACROSS * PANEL_HEIGHT + FOOT };

typedef struct point {
    char plot[16], panel[16], method[16];
    double x, y, promise;
    int clean;
} point;

typedef struct style { const char *method, *label; double red, green, blue; } style;
/* Okabe and Ito's colours, each with a mark of its own: told apart in print and by the colour-blind. */
static const style styles[METHODS] = {
    { "certified", "certified (povtrace)", 0.0, 0.0, 0.0 },
    { "max", "max (povtrace)", 0.0, 0.447, 0.698 },
    { "textbook", "textbook", 0.835, 0.369, 0.0 },
    { "q-form", "re-centred, q-form", 0.0, 0.62, 0.451 },
    { "double-double", "always double-double", 0.8, 0.475, 0.655 },
};
static const char *const panels[PANELS] = { "sphere", "box", "cone", "cylinder", "quadric", "polygon" };

typedef struct about {
    const char *plot, *title, *x_title;
    int x_from, x_to, x_step;    /* powers of ten that are marked */
    double margin;               /* to either side of them, in powers of ten */
    bool lines;
} about;

static const about plots[2] = {
    { "work", "Work and precision: the greatest error over distance, translation, scale and grazing rays", "ns a ray", 1, 4, 1,
      0.12, false },
    { "distance", "The greatest error of a hit's distance, by how far the ray comes from", "distance / size", 0, 12, 3,
      0.8, true },
};
enum { Y_FROM = -1, Y_TO = 18, Y_STEP = 3 };

static point all[POINTS_MAX];
static int point_count;

static void text(cairo_t *c, double x, double y, double align, double size, const char *words)
{
    cairo_text_extents_t e;

    cairo_set_font_size(c, size);
    cairo_text_extents(c, words, &e);
    cairo_move_to(c, x - align * e.x_advance, y);
    cairo_show_text(c, words);
}

/* Ten to a power, the power raised. */
static void power(cairo_t *c, double x, double y, double align, int exponent)
{
    char words[16];

    if (exponent >= 0 && exponent <= 1) {
        text(c, x, y, align, 10.0, exponent ? "10" : "1");
        return;
    }
    snprintf(words, sizeof words, "%d", exponent);
    text(c, x - align * 20.0, y, 0.0, 10.0, "10");
    text(c, x - align * 20.0 + 12.0, y - 4.0, 0.0, 7.5, words);
}

static void grey(cairo_t *c, double level) { cairo_set_source_rgb(c, level, level, level); }

/* ---- a panel: its lower left corner, and its axes ---- */

typedef struct frame { double x, y, width, height; const about *about; } frame;

static double across(const frame *f, double value)
{
    const double least = f->about->x_from - f->about->margin, most = f->about->x_to + f->about->margin;

    return f->x + f->width * (log10(value) - least) / (most - least);
}

/* Values beyond the axis are drawn at its end. */
static double up(const frame *f, double value)
{
    const double at = fmin(fmax(log10(fmax(value, 1e-30)), Y_FROM), Y_TO - 0.4);

    return f->y - f->height * (at - Y_FROM) / (Y_TO - Y_FROM);
}

static void draw_axes(cairo_t *c, const frame *f, const char *title, double promise)
{
    char words[64];
    int i;

    cairo_set_line_width(c, 0.6);
    for (i = f->about->x_from; i <= f->about->x_to; i += f->about->x_step) {
        const double x = across(f, pow(10.0, i));

        grey(c, 0.88);
        cairo_move_to(c, x, f->y);
        cairo_line_to(c, x, f->y - f->height);
        cairo_stroke(c);
        grey(c, 0.2);
        power(c, x, f->y + 14.0, 0.5, i);
    }
    for (i = 0; i <= Y_TO; i += Y_STEP) {
        const double y = up(f, pow(10.0, i));

        grey(c, 0.88);
        cairo_move_to(c, f->x, y);
        cairo_line_to(c, f->x + f->width, y);
        cairo_stroke(c);
        grey(c, 0.2);
        power(c, f->x - 5.0, y + 3.5, 1.0, i);
    }
    grey(c, 0.4);
    cairo_rectangle(c, f->x, f->y - f->height, f->width, f->height);
    cairo_stroke(c);
    grey(c, 0.1);
    text(c, f->x, f->y - f->height - 6.0, 0.0, 12.0, title);
    snprintf(words, sizeof words, "dashed: promised, %g ulp", promise);
    text(c, f->x + f->width, f->y - f->height - 6.0, 1.0, 9.5, words);
    text(c, f->x + f->width / 2.0, f->y + 29.0, 0.5, 10.0, f->about->x_title);
}

static void draw_promise(cairo_t *c, const frame *f, double promise)
{
    const double dash[2] = { 5.0, 3.0 }, y = up(f, promise);

    grey(c, 0.25);
    cairo_set_line_width(c, 1.1);
    cairo_set_dash(c, dash, 2, 0.0);
    cairo_move_to(c, f->x, y);
    cairo_line_to(c, f->x + f->width, y);
    cairo_stroke(c);
    cairo_set_dash(c, NULL, 0, 0.0);
}

static void outline(cairo_t *c, int form, double x, double y)
{
    static const double corners[METHODS] = { 0, 4, 3, 4, 3 }, turns[METHODS] = { 0, 0.125, 0.75, 0.0, 0.25 };
    /* Ours are smaller, so that others show behind them. */
    const double r = form == 0 ? 3.8 : form == 1 ? 4.6 : form == 4 ? 7.8 : 5.6;
    int i;

    cairo_new_path(c);
    if (form == 0)
        cairo_arc(c, x, y, r, 0.0, 6.283185307179586);
    for (i = 0; i < (int)corners[form]; i++) {
        const double angle = 6.283185307179586 * (turns[form] + i / corners[form]);
        cairo_line_to(c, x + r * cos(angle), y + r * sin(angle));
    }
    cairo_close_path(c);
}

static void draw_mark(cairo_t *c, int form, double x, double y, bool clean)
{
    const style *s = &styles[form];

    outline(c, form, x, y);
    if (clean)
        cairo_set_source_rgb(c, s->red, s->green, s->blue);
    else
        grey(c, 1.0);
    cairo_fill_preserve(c);
    cairo_set_source_rgb(c, s->red, s->green, s->blue);
    cairo_set_line_width(c, 1.4);
    cairo_stroke(c);
}

static bool belongs(const point *p, const about *a, const char *panel, int method)
{
    return strcmp(p->plot, a->plot) == 0 && strcmp(p->panel, panel) == 0
           && (method < 0 || strcmp(p->method, styles[method].method) == 0);
}

static void draw_method(cairo_t *c, const frame *f, const char *panel, int method)
{
    const style *s = &styles[method];
    int i;

    cairo_new_path(c);
    for (i = 0; i < point_count && f->about->lines; i++) {
        if (belongs(&all[i], f->about, panel, method))
            cairo_line_to(c, across(f, all[i].x), up(f, all[i].y));
    }
    cairo_set_source_rgb(c, s->red, s->green, s->blue);
    cairo_set_line_width(c, 1.2);
    cairo_stroke(c);
    for (i = 0; i < point_count; i++) {
        if (belongs(&all[i], f->about, panel, method))
            draw_mark(c, method, across(f, all[i].x), up(f, all[i].y), all[i].clean != 0);
    }
}

static void draw_panel(cairo_t *c, const about *a, int number)
{
    const frame f = { number % ACROSS * PANEL_WIDTH + LEFT, HEAD + (number / ACROSS + 1) * PANEL_HEIGHT - BOTTOM,
                      PANEL_WIDTH - LEFT - RIGHT, PANEL_HEIGHT - TOP - BOTTOM, a };
    int i = 0;

    while (i < point_count && !belongs(&all[i], a, panels[number], -1))
        i++;
    if (i == point_count)
        return;
    draw_axes(c, &f, panels[number], all[i].promise);
    draw_promise(c, &f, all[i].promise);
    /* Ours last, on top. */
    for (i = METHODS - 1; i >= 0; i--)
        draw_method(c, &f, panels[number], i);
}

static void draw(cairo_t *c, const about *a)
{
    double x = LEFT;
    int i;

    grey(c, 1.0);
    cairo_paint(c);
    cairo_select_font_face(c, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    grey(c, 0.1);
    text(c, LEFT, 20.0, 0.0, 14.0, a->title);
    text(c, LEFT, 37.0, 0.0, 10.5, "greatest error in units in the last place, against MPFR; hollow: some hits or misses are misjudged");
    for (i = 0; i < PANELS; i++)
        draw_panel(c, a, i);
    for (i = 0; i < METHODS; i++) {
        draw_mark(c, i, x, HEIGHT - 20.0, true);
        grey(c, 0.1);
        text(c, x + 10.0, HEIGHT - 16.0, 0.0, 11.0, styles[i].label);
        x += 165.0;
    }
}

static bool put(const about *a, const char *folder, bool is_svg)
{
    char path[1024];
    cairo_surface_t *surface;
    cairo_status_t status;
    cairo_t *c;

    snprintf(path, sizeof path, "%s/accuracy-%s.%s", folder, a->plot, is_svg ? "svg" : "png");
    surface = is_svg ? cairo_svg_surface_create(path, WIDTH, HEIGHT)
                     : cairo_image_surface_create(CAIRO_FORMAT_RGB24, WIDTH, HEIGHT);
    c = cairo_create(surface);
    draw(c, a);
    status = is_svg ? CAIRO_STATUS_SUCCESS : cairo_surface_write_to_png(surface, path);
    cairo_destroy(c);
    cairo_surface_finish(surface);
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    if (status != CAIRO_STATUS_SUCCESS)
        fprintf(stderr, "%s: %s\n", path, cairo_status_to_string(status));
    return status == CAIRO_STATUS_SUCCESS;
}

int main(int argc, char **argv)
{
    bool good = true;
    int i;

    if (argc != 2)
        return 2;
    while (point_count < POINTS_MAX) {
        point *p = &all[point_count];

        if (scanf("%15s %15s %15s %lf %lf %lf %d", p->plot, p->panel, p->method, &p->x, &p->y, &p->promise, &p->clean) != 7)
            break;
        point_count++;
    }
    for (i = 0; i < 2; i++)
        good = put(&plots[i], argv[1], true) && put(&plots[i], argv[1], false) && good;
    return good ? 0 : 1;
}
