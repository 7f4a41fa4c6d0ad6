/* plot.c - curves by cairo, to SVG and PNG.
 *
 * Curves differ in colour, mark and dash, so that they can be told apart in grey prints and by eyes that do not
 * distinguish red from green. The colours are those of Okabe and Ito: Color universal design, 2008. */
#include <povtrace/plot.h>
#include <povtrace/plugin.h>

#include <cairo-svg.h>
#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct colour { double r, g, b; } colour;
static const colour curve_colours[] = {
    { 0.000, 0.447, 0.698 }, { 0.835, 0.369, 0.000 }, { 0.000, 0.620, 0.451 }, { 0.800, 0.475, 0.655 },
    { 0.337, 0.706, 0.914 }, { 0.902, 0.624, 0.000 }, { 0.000, 0.000, 0.000 },
};
enum { COLOURS = sizeof curve_colours / sizeof curve_colours[0], MARKS = 5, TICKS_MAX = 64, DECADES_MAX = 8 };
static const colour ink = { 0.13, 0.13, 0.13 }, pale = { 0.87, 0.87, 0.87 }, paler = { 0.945, 0.945, 0.945 },
                    level_colour = { 0.35, 0.35, 0.35 };
/* Begin of the guide line, as a fraction of the first point. */
static const double guide_above = 1.3;
static const double parsed_size = 12.0, small_size = 11.0, title_size = 15.0;

/* An axis as it is drawn: positions are logarithms where the axis is logarithmic. */
typedef struct scale { bool logarithmic; double low, high; } scale;

typedef struct frame {
    cairo_t *to;
    const pov_panel *panel;
    double left, top, width, height;
    scale x, y;
} frame;

/* ---- scales ---- */

static bool is_shown(const scale *s, double value)
{
    return isfinite(value) && (!s->logarithmic || value > 0.0);
}

static double position(const scale *s, double value)
{
    return s->logarithmic ? log10(value) : value;
}

static void widen(scale *s, double value)
{
    if (!is_shown(s, value))
        return;
    s->low = pov_min(s->low, position(s, value));
    s->high = pov_max(s->high, position(s, value));
}

static void widen_by_panel(scale *s, const pov_panel *p, bool vertical)
{
    for (size_t i = 0; i < p->series_count; i++)
        for (size_t k = 0; k < p->series[i].count; k++) {
            const pov_series *c = &p->series[i];

            widen(s, vertical ? c->y[k] : c->x[k]);
            if (vertical && c->low && c->high && is_shown(s, c->y[k])) {
                widen(s, c->low[k]);
                widen(s, c->high[k]);
            }
        }
    if (vertical && p->guide)
        widen(s, guide_above * pow(10.0, s->high));
    for (size_t i = 0; i < p->level_count; i++)
        if (p->levels[i].vertical != vertical)
            widen(s, p->levels[i].at);
}

static scale make_scale(const pov_panel *p, const pov_axis *axis, bool vertical)
{
    scale s = { axis->logarithmic, HUGE_VAL, -HUGE_VAL };
    double room;

    if (axis->most > axis->least && (!axis->logarithmic || axis->least > 0.0)) {
        s.low = position(&s, axis->least);
        s.high = position(&s, axis->most);
        return s;
    }
    widen_by_panel(&s, p, vertical);
    if (!(s.low <= s.high)) {
        s.low = 0.0;
        s.high = 1.0;
    }
    room = s.high > s.low ? 0.05 * (s.high - s.low) : s.logarithmic ? 0.3 : pov_max(fabs(s.low), 1.0) * 0.1;
    s.low -= room;
    s.high += room;
    return s;
}

static double across(const frame *f, double x)
{
    return f->left + f->width * (position(&f->x, x) - f->x.low) / (f->x.high - f->x.low);
}

static double down(const frame *f, double y)
{
    return f->top + f->height * (f->y.high - position(&f->y, y)) / (f->y.high - f->y.low);
}

/* ---- ticks ---- */

typedef struct tick { double value; bool named; } tick;

/* Step of 1, 2 or 5 times a power of ten, so that about `wanted` steps fit. */
static double even_step(double span, int wanted)
{
    double ideal = span / wanted, power = pow(10.0, floor(log10(ideal))), part = ideal / power;

    return power * (part <= 1.0 ? 1.0 : part <= 2.0 ? 2.0 : part <= 5.0 ? 5.0 : 10.0);
}

static int even_ticks(const scale *s, int wanted, tick *out)
{
    double step = even_step(s->high - s->low, wanted);
    int count = 0;

    for (double k = ceil(s->low / step); k * step <= s->high && count < TICKS_MAX; k++) {
        out[count].value = k * step;
        out[count++].named = true;
    }
    return count;
}

/* Ticks at 1 ... 9 in each decade; labels where they fit. */
static int decade_ticks(const scale *s, tick *out)
{
    double span = s->high - s->low;
    int first = (int)floor(s->low), last = (int)ceil(s->high), each = 1 + (int)(span / DECADES_MAX), count = 0;

    for (int decade = first; decade <= last; decade++)
        for (int digit = 1; digit <= 9 && count < TICKS_MAX; digit++) {
            double value = digit * pow(10.0, decade), at = log10(value);

            if (at < s->low || at > s->high || (digit > 1 && span > 5.0))
                continue;
            out[count].value = value;
            out[count].named = digit == 1 ? decade % each == 0 : span < 0.7 || (span < 2.5 && (digit == 2 || digit == 5));
            count++;
        }
    return count;
}

static int make_ticks(const scale *s, int wanted, tick *out)
{
    return s->logarithmic ? decade_ticks(s, out) : even_ticks(s, wanted, out);
}

/* ---- ink ---- */

static void set_colour(cairo_t *to, colour c, double alpha)
{
    cairo_set_source_rgba(to, c.r, c.g, c.b, alpha);
}

static void set_text(cairo_t *to, double size, bool bold)
{
    cairo_select_font_face(to, "sans-serif", CAIRO_FONT_SLANT_NORMAL, bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(to, size);
}

static double text_width(cairo_t *to, const char *text)
{
    cairo_text_extents_t e;

    cairo_text_extents(to, text, &e);
    return e.x_advance;
}

/* part: 0 begins at x, 1/2 is centred about it, 1 ends at it. */
static void put_text(cairo_t *to, double x, double y, double part, const char *text)
{
    cairo_move_to(to, x - part * text_width(to, text), y);
    cairo_show_text(to, text);
}

static void put_line(cairo_t *to, double x0, double y0, double x1, double y1)
{
    cairo_move_to(to, x0, y0);
    cairo_line_to(to, x1, y1);
    cairo_stroke(to);
}

/* ---- the frame ---- */

static void draw_grid(const frame *f, const tick *ticks, int count, bool vertical)
{
    cairo_set_line_width(f->to, 1.0);
    for (int i = 0; i < count; i++) {
        set_colour(f->to, ticks[i].named ? pale : paler, 1.0);
        if (vertical)
            put_line(f->to, f->left, down(f, ticks[i].value), f->left + f->width, down(f, ticks[i].value));
        else
            put_line(f->to, across(f, ticks[i].value), f->top, across(f, ticks[i].value), f->top + f->height);
    }
}

static void name_ticks(const frame *f, const tick *ticks, int count, bool vertical)
{
    char text[32];

    set_text(f->to, small_size, false);
    set_colour(f->to, ink, 1.0);
    for (int i = 0; i < count; i++) {
        if (!ticks[i].named)
            continue;
        snprintf(text, sizeof text, "%.6g", ticks[i].value);
        if (vertical)
            put_text(f->to, f->left - 7.0, down(f, ticks[i].value) + 0.35 * small_size, 1.0, text);
        else
            put_text(f->to, across(f, ticks[i].value), f->top + f->height + small_size + 6.0, 0.5, text);
    }
}

static void name_axes(const frame *f)
{
    set_text(f->to, parsed_size, false);
    set_colour(f->to, ink, 1.0);
    if (f->panel->x.title)
        put_text(f->to, f->left + 0.5 * f->width, f->top + f->height + 37.0, 0.5, f->panel->x.title);
    if (!f->panel->y.title)
        return;
    cairo_save(f->to);
    cairo_translate(f->to, f->left - 56.0, f->top + 0.5 * f->height);
    cairo_rotate(f->to, -1.5707963267948966);
    put_text(f->to, 0.0, 0.0, 0.5, f->panel->y.title);
    cairo_restore(f->to);
}

static void draw_axes(const frame *f)
{
    tick x[TICKS_MAX], y[TICKS_MAX];
    int x_count = make_ticks(&f->x, 8, x), y_count = make_ticks(&f->y, 4 + (int)(f->height / 100.0), y);

    draw_grid(f, x, x_count, false);
    draw_grid(f, y, y_count, true);
    name_ticks(f, x, x_count, false);
    name_ticks(f, y, y_count, true);
    name_axes(f);
    set_colour(f->to, ink, 1.0);
    cairo_rectangle(f->to, f->left, f->top, f->width, f->height);
    cairo_stroke(f->to);
}

/* ---- curves ---- */

static bool has_point(const frame *f, const pov_series *s, size_t k)
{
    return is_shown(&f->x, s->x[k]) && is_shown(&f->y, s->y[k]);
}

static bool has_band(const frame *f, const pov_series *s, size_t k)
{
    return has_point(f, s, k) && is_shown(&f->y, s->low[k]) && is_shown(&f->y, s->high[k]);
}

static void draw_band(const frame *f, const pov_series *s, colour c)
{
    bool any = false;

    if (!s->low || !s->high)
        return;
    cairo_new_path(f->to);
    for (size_t k = 0; k < s->count; k++)
        if (has_band(f, s, k)) {
            cairo_line_to(f->to, across(f, s->x[k]), down(f, s->high[k]));
            any = true;
        }
    for (size_t k = s->count; k-- > 0;)
        if (has_band(f, s, k))
            cairo_line_to(f->to, across(f, s->x[k]), down(f, s->low[k]));
    if (!any)
        return;
    cairo_close_path(f->to);
    set_colour(f->to, c, 0.22);
    cairo_fill(f->to);
}

static void draw_mark(cairo_t *to, int kind, double x, double y)
{
    const double r = 3.6;

    switch (kind) {
    case 0:
        cairo_arc(to, x, y, r, 0.0, 6.283185307179586);
        break;
    case 1:
        cairo_rectangle(to, x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r);
        break;
    default:
        /* Diamond, triangle up, triangle down. */
        cairo_move_to(to, x, y - (kind == 4 ? -1.25 : 1.25) * r);
        cairo_line_to(to, x + 1.15 * r, kind == 2 ? y : kind == 3 ? y + 0.85 * r : y - 0.85 * r);
        if (kind == 2)
            cairo_line_to(to, x, y + 1.25 * r);
        cairo_line_to(to, x - 1.15 * r, kind == 2 ? y : kind == 3 ? y + 0.85 * r : y - 0.85 * r);
        cairo_close_path(to);
        break;
    }
    cairo_fill(to);
}

static void set_dash(cairo_t *to, size_t index)
{
    const double dashes[4][4] = { { 1.0, 0.0, 1.0, 0.0 }, { 7.0, 3.0, 7.0, 3.0 }, { 2.0, 2.5, 2.0, 2.5 }, { 8.0, 3.0, 2.0, 3.0 } };

    cairo_set_dash(to, dashes[index % 4], index % 4 == 0 ? 0 : 4, 0.0);
}

static void draw_curve(const frame *f, const pov_series *s, size_t index)
{
    colour c = curve_colours[index % COLOURS];

    draw_band(f, s, c);
    set_colour(f->to, c, 1.0);
    cairo_set_line_width(f->to, s->thin ? 1.2 : 1.8);
    cairo_new_path(f->to);
    for (size_t k = 0; k < s->count; k++)
        if (has_point(f, s, k))
            cairo_line_to(f->to, across(f, s->x[k]), down(f, s->y[k]));
    set_dash(f->to, index);
    cairo_stroke(f->to);
    set_dash(f->to, 0);
    for (size_t k = 0; k < s->count && !s->thin; k++)
        if (has_point(f, s, k))
            draw_mark(f->to, (int)(index % MARKS), across(f, s->x[k]), down(f, s->y[k]));
}

/* ---- levels, guide, legend ---- */

/* Text over the grid, with the paper's colour behind it. */
static void put_note(const frame *f, double x, double y, double part, const char *text)
{
    double width;

    set_text(f->to, small_size, false);
    width = text_width(f->to, text);
    set_colour(f->to, (colour){ 1.0, 1.0, 1.0 }, 0.85);
    cairo_rectangle(f->to, x - part * width - 2.0, y - small_size, width + 4.0, small_size + 4.0);
    cairo_fill(f->to);
    set_colour(f->to, level_colour, 1.0);
    put_text(f->to, x, y, part, text);
}

static void draw_level(const frame *f, const pov_level *l)
{
    const double dash[2] = { 4.0, 3.0 };

    if (!is_shown(l->vertical ? &f->x : &f->y, l->at))
        return;
    set_colour(f->to, level_colour, 1.0);
    cairo_set_line_width(f->to, 1.2);
    cairo_set_dash(f->to, dash, 2, 0.0);
    if (l->vertical)
        put_line(f->to, across(f, l->at), f->top, across(f, l->at), f->top + f->height);
    else
        put_line(f->to, f->left, down(f, l->at), f->left + f->width, down(f, l->at));
    set_dash(f->to, 0);
    if (l->vertical)
        put_note(f, across(f, l->at) - 4.0, f->top + f->height - 8.0, 1.0, l->name);
    else
        put_note(f, f->left + 6.0, down(f, l->at) - 5.0, 0.0, l->name);
}

/* Begins above the first point of the first curve: a steeper curve does not cross it. */
static void draw_guide(const frame *f)
{
    const pov_series *s = f->panel->series;
    const double dash[2] = { 1.5, 3.5 };
    double x0, y0, x1, y1;
    size_t first = 0;

    if (!f->panel->guide || f->panel->series_count == 0 || !f->x.logarithmic || !f->y.logarithmic)
        return;
    while (first < s->count && !has_point(f, s, first))
        first++;
    if (first + 1 >= s->count)
        return;
    x0 = s->x[first];
    y0 = guide_above * s->y[first];
    x1 = pow(10.0, f->x.high);
    y1 = y0 * pow(x1 / x0, f->panel->slope);
    if (log10(y1) < f->y.low) {
        y1 = pow(10.0, f->y.low);
        x1 = x0 * pow(y1 / y0, 1.0 / f->panel->slope);
    }
    set_colour(f->to, level_colour, 1.0);
    cairo_set_line_width(f->to, 1.4);
    cairo_set_dash(f->to, dash, 2, 0.0);
    put_line(f->to, across(f, x0), down(f, y0), across(f, x1), down(f, y1));
    set_dash(f->to, 0);
    x1 = x0 * pow(x1 / x0, 0.45);
    y1 = y0 * pow(x1 / x0, f->panel->slope);
    put_note(f, across(f, x1) + 8.0, down(f, y1) - 6.0, 0.0, f->panel->guide);
}

static void draw_legend(const frame *f)
{
    const double line = 18.0, swatch = 30.0;
    double width = 0.0, x, y;
    size_t named = 0;

    set_text(f->to, parsed_size, false);
    for (size_t i = 0; i < f->panel->series_count; i++)
        if (f->panel->series[i].name) {
            width = pov_max(width, text_width(f->to, f->panel->series[i].name));
            named++;
        }
    if (named == 0)
        return;
    x = f->left + f->width - width - swatch - 22.0;
    y = f->top + 8.0;
    set_colour(f->to, (colour){ 1.0, 1.0, 1.0 }, 0.88);
    cairo_rectangle(f->to, x - 4.0, y, width + swatch + 18.0, (double)named * line + 6.0);
    cairo_fill(f->to);
    for (size_t i = 0; i < f->panel->series_count; i++) {
        const pov_series *s = &f->panel->series[i];

        if (!s->name)
            continue;
        set_colour(f->to, curve_colours[i % COLOURS], 1.0);
        cairo_set_line_width(f->to, s->thin ? 1.2 : 1.8);
        set_dash(f->to, i);
        put_line(f->to, x + 2.0, y + 12.0, x + swatch, y + 12.0);
        set_dash(f->to, 0);
        if (!s->thin)
            draw_mark(f->to, (int)(i % MARKS), x + 0.5 * swatch + 1.0, y + 12.0);
        set_colour(f->to, ink, 1.0);
        put_text(f->to, x + swatch + 8.0, y + 12.0 + 0.35 * parsed_size, 0.0, s->name);
        y += line;
    }
}

/* ---- the whole ---- */

static void draw_panel(frame *f)
{
    const pov_panel *p = f->panel;

    f->x = make_scale(p, &p->x, false);
    f->y = make_scale(p, &p->y, true);
    draw_axes(f);
    cairo_save(f->to);
    cairo_rectangle(f->to, f->left, f->top, f->width, f->height);
    cairo_clip(f->to);
    draw_guide(f);
    for (size_t i = 0; i < p->level_count; i++)
        draw_level(f, &p->levels[i]);
    for (size_t i = p->series_count; i-- > 0;)
        draw_curve(f, &p->series[i], i);
    draw_legend(f);
    cairo_restore(f->to);
}

static void draw_all(cairo_t *to, const pov_plot *plot)
{
    const double left = 74.0, right = 18.0, head = 58.0, foot = 48.0;
    double y = head, shares = 0.0, room = plot->height - head - foot * (double)plot->panel_count;

    cairo_set_source_rgb(to, 1.0, 1.0, 1.0);
    cairo_paint(to);
    cairo_set_line_cap(to, CAIRO_LINE_CAP_BUTT);
    set_colour(to, ink, 1.0);
    set_text(to, title_size, true);
    if (plot->title)
        put_text(to, left, 24.0, 0.0, plot->title);
    set_text(to, parsed_size, false);
    if (plot->note)
        put_text(to, left, 43.0, 0.0, plot->note);
    for (size_t i = 0; i < plot->panel_count; i++)
        shares += plot->panels[i].share > 0.0 ? plot->panels[i].share : 1.0;
    for (size_t i = 0; i < plot->panel_count; i++) {
        const pov_panel *p = &plot->panels[i];
        frame f = { .to = to, .panel = p, .left = left, .top = y, .width = plot->width - left - right };

        f.height = pov_max(room * (p->share > 0.0 ? p->share : 1.0) / shares, 20.0);
        draw_panel(&f);
        y += f.height + foot;
    }
}

static cairo_status_t put_bytes(void *closure, const unsigned char *bytes, unsigned count)
{
    const pov_output *output = closure;

    return output->put(output->user, bytes, count) ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

static const char *finish(cairo_surface_t *surface, const pov_plot *plot, pov_output *png)
{
    cairo_t *to = cairo_create(surface);
    cairo_status_t status;

    draw_all(to, plot);
    status = cairo_status(to);
    cairo_destroy(to);
    if (status == CAIRO_STATUS_SUCCESS && png)
        status = cairo_surface_write_to_png_stream(surface, put_bytes, png);
    cairo_surface_finish(surface);
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    return status == CAIRO_STATUS_SUCCESS ? NULL : cairo_status_to_string(status);
}

static const char *draw_svg(const pov_plot *plot, const pov_output *output)
{
    pov_output to = *output;

    return finish(cairo_svg_surface_create_for_stream(put_bytes, &to, plot->width, plot->height), plot, NULL);
}

static const char *draw_png(const pov_plot *plot, const pov_output *output)
{
    pov_output to = *output;

    return finish(cairo_image_surface_create(CAIRO_FORMAT_RGB24, plot->width, plot->height), plot, &to);
}

static const pov_plot_format svg = { .size = sizeof(pov_plot_format), .ending = "svg", .draw = draw_svg };
static const pov_plot_format png = { .size = sizeof(pov_plot_format), .ending = "png", .draw = draw_png };
static const pov_plot_format *const formats[] = { &svg, &png, NULL };

POV_PLUGIN(plot) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "plot", .version = "0.1.0", .plots = formats,
};
