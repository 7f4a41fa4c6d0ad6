#include "curve.h"

#include <math.h>
#include <stdio.h>

enum { MOST_ROWS = 256 };

/* In units of the scale: the panel, and the frame within it. */
static const double WIDTH = 330.0, HEIGHT = 220.0, LEFT = 58.0, TOP = 34.0, RIGHT = 24.0, BOTTOM = 36.0;

/* Passes with a known error, and the decades that hold them. */
typedef struct curve {
    pov_pass rows[MOST_ROWS];
    int count;
    int first_time, last_time, first_error, last_error;   /* powers of ten */
} curve;

static void widen(int *first, int *last, double value)
{
    int below = (int)floor(log10(value)), above = (int)ceil(log10(value));

    *first = below < *first ? below : *first;
    *last = above > *last ? above : *last;
}

/* With more passes than columns the last ones share a column: the newest counts. */
static void collect(curve *c, const session *s)
{
    pov_pass row = POV_INIT(row);

    c->count = 0;
    c->first_time = c->first_error = 1000;
    c->last_time = c->last_error = -1000;
    for (size_t i = 0; session_get_pass(s, i, &row); i++) {
        if (!(row.est_rmse > 0.0) || !(row.wall_s > 0.0))
            continue;
        c->count += c->count < MOST_ROWS;
        c->rows[c->count - 1] = row;
        widen(&c->first_time, &c->last_time, row.wall_s);
        widen(&c->first_error, &c->last_error, row.est_rmse);
        if (row.est_ci95_lo > 0.0)
            widen(&c->first_error, &c->last_error, row.est_ci95_lo);
    }
    c->last_time += c->last_time == c->first_time;
    c->last_error += c->last_error == c->first_error;
}

static double x_of(const curve *c, double seconds)
{
    return LEFT + (WIDTH - LEFT - RIGHT) * (log10(seconds) - c->first_time) / (c->last_time - c->first_time);
}

static double y_of(const curve *c, double error)
{
    double up = (log10(error) - c->first_error) / (c->last_error - c->first_error);

    return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * (up > 0.0 ? up : 0.0);
}

static void text(cairo_t *c, double x, double y, double anchor, const char *words)
{
    cairo_text_extents_t e;

    cairo_text_extents(c, words, &e);
    cairo_move_to(c, x - anchor * e.x_advance, y);
    cairo_show_text(c, words);
}

static void axes(cairo_t *c, const curve *v)
{
    char label[32];

    cairo_set_line_width(c, 1.0);
    for (int p = v->first_time; p <= v->last_time; p++) {
        double x = x_of(v, pow(10.0, p));

        cairo_set_source_rgba(c, 1.0, 1.0, 1.0, 0.18);
        cairo_move_to(c, x, TOP);
        cairo_line_to(c, x, HEIGHT - BOTTOM);
        cairo_stroke(c);
        snprintf(label, sizeof label, "%g s", pow(10.0, p));
        cairo_set_source_rgb(c, 0.8, 0.8, 0.8);
        text(c, x, HEIGHT - BOTTOM + 15.0, 0.5, label);
    }
    for (int p = v->first_error; p <= v->last_error; p++) {
        double y = y_of(v, pow(10.0, p));

        cairo_set_source_rgba(c, 1.0, 1.0, 1.0, 0.18);
        cairo_move_to(c, LEFT, y);
        cairo_line_to(c, WIDTH - RIGHT, y);
        cairo_stroke(c);
        snprintf(label, sizeof label, "%g", pow(10.0, p));
        cairo_set_source_rgb(c, 0.8, 0.8, 0.8);
        text(c, LEFT - 6.0, y + 4.0, 1.0, label);
    }
}

/* Between the limits that hold the true error in 95 of 100 cases. */
static void band(cairo_t *c, const curve *v)
{
    for (int i = 0; i < v->count; i++)
        cairo_line_to(c, x_of(v, v->rows[i].wall_s), y_of(v, v->rows[i].est_ci95_hi));
    for (int i = v->count - 1; i >= 0; i--) {
        double low = v->rows[i].est_ci95_lo;

        cairo_line_to(c, x_of(v, v->rows[i].wall_s), low > 0.0 ? y_of(v, low) : HEIGHT - BOTTOM);
    }
    cairo_close_path(c);
    cairo_set_source_rgba(c, 0.45, 0.70, 1.0, 0.25);
    cairo_fill(c);
}

/* Prediction for uniform sampling from the first row: the error falls with the square root of time. */
static void guide(cairo_t *c, const curve *v)
{
    const double dash[2] = { 5.0, 4.0 };
    double end = pow(10.0, v->last_time), first = v->rows[0].wall_s;

    cairo_set_dash(c, dash, 2, 0.0);
    cairo_move_to(c, x_of(v, first), y_of(v, v->rows[0].est_rmse));
    cairo_line_to(c, x_of(v, end), y_of(v, v->rows[0].est_rmse * sqrt(first / end)));
    cairo_set_source_rgb(c, 0.6, 0.6, 0.6);
    cairo_stroke(c);
    cairo_set_dash(c, NULL, 0, 0.0);
}

static void line(cairo_t *c, const curve *v)
{
    for (int i = 0; i < v->count; i++)
        cairo_line_to(c, x_of(v, v->rows[i].wall_s), y_of(v, v->rows[i].est_rmse));
    cairo_set_line_width(c, 1.5);
    cairo_set_source_rgb(c, 1.0, 0.72, 0.30);
    cairo_stroke(c);
    for (int i = 0; i < v->count; i++) {
        cairo_arc(c, x_of(v, v->rows[i].wall_s), y_of(v, v->rows[i].est_rmse), 2.5, 0.0, 6.283185307179586);
        cairo_fill(c);
    }
}

static void draw(cairo_t *c, const void *user)
{
    const curve *v = user;

    cairo_select_font_face(c, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(c, 11.0);
    axes(c, v);
    cairo_save(c);
    cairo_rectangle(c, LEFT, TOP, WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM);
    cairo_clip(c);
    band(c, v);
    guide(c, v);
    line(c, v);
    cairo_restore(c);
    cairo_set_source_rgb(c, 1.0, 1.0, 1.0);
    cairo_select_font_face(c, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_BOLD);
    text(c, 12.0, 21.0, 0.0, "error against time");
}

bool curve_set(panel *p, const session *s, bool shown, double scale)
{
    char name[80] = "";
    curve c;

    if (!shown)
        return panel_set_drawing(p, "", scale, WIDTH, HEIGHT, draw, NULL);
    collect(&c, s);
    if (c.count == 0)
        return panel_set(p, "#error against time\n No error is known before the second sample.\n", scale,
                         &(panel_room){ (int)(WIDTH * scale), 0, 0 });
    snprintf(name, sizeof name, "%d %.17g %.17g", c.count, c.rows[c.count - 1].wall_s, c.rows[0].wall_s);
    return panel_set_drawing(p, name, scale, WIDTH, HEIGHT, draw, &c);
}
