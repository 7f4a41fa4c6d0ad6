#include "sdl/parse.h"
#include "sdl/report.h"
#include "sdl/value.h"

/* More levels than this are a slip, and each tracer keeps room for all of them. */
static const double most_levels = 65535.0;

static void read_ambient_light(pov_reader *in, void *self, word_id word)
{
    (void)self;
    (void)word;
    in->model->ambient_light = value_colour(in, true).colour;
    in->settings.has_ambient_light = true;
}

static void read_max_trace_level(pov_reader *in, void *self, word_id word)
{
    double level = value_number(in);

    (void)self;
    (void)word;
    if (level < 0.0 || level > most_levels) {
        report_fail(in, &in->value, POV_E_SYNTAX, "\"max_trace_level\" must lie in 0 to %.0f", most_levels);
        return;
    }
    if (level != (double)(int)level)
        report_warn(in, &in->value, "a trace level is a whole number: %d is taken", (int)level);
    in->model->max_trace_level = (int)level;
}

static void read_adc_bailout(pov_reader *in, void *self, word_id word)
{
    (void)self;
    (void)word;
    in->model->adc_bailout = value_number(in);
}

static void read_assumed_gamma(pov_reader *in, void *self, word_id word)
{
    double number = value_number(in);

    (void)self;
    (void)word;
    if (!in->failed && number <= 0.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"assumed_gamma\" must be above 0");
    in->settings.assumed_gamma = number;
}

void parse_global_settings(pov_reader *in, void *self, word_id word)
{
    static const item items[] = {
        { WORD_AMBIENT_LIGHT, read_ambient_light },
        { WORD_MAX_TRACE_LEVEL, read_max_trace_level },
        { WORD_ADC_BAILOUT, read_adc_bailout },
        { WORD_ASSUMED_GAMMA, read_assumed_gamma },
    };
    static const item_list list = ITEM_LIST("a setting", items);

    (void)self;
    (void)word;
    items_block(in, &list, NULL);
}

/* What a background lets through is black. */
void parse_background(pov_reader *in, void *self, word_id word)
{
    static const item_list list = { "a colour", NULL, 0 };
    block b;
    paint p;

    (void)self;
    (void)word;
    items_open(in, &b);
    if (in->token.kind != '}') {
        p = value_colour(in, true);
        in->model->background = colour_scale(p.colour, 1.0f - p.transmit);
    }
    items_close(in, &b, &list, NULL);
}

static void finish_gamma(pov_reader *in, bool is_new)
{
    gamma *g = &in->model->gamma;

    g->decode = 1.0;
    g->transfer = POV_TRANSFER_LINEAR;
    if (in->model->dialect != POV_DIALECT_POVRAY)
        return;
    if (in->settings.assumed_gamma > 0.0)
        g->decode = in->settings.assumed_gamma;
    if (in->settings.assumed_gamma > 0.0 || is_new)
        g->transfer = POV_TRANSFER_SRGB;
}

void parse_settings_finish(pov_reader *in)
{
    model *m = in->model;
    bool is_povray = m->dialect == POV_DIALECT_POVRAY, is_new = in->settings.version >= 3.7;

    if (!in->settings.has_ambient_light)
        m->ambient_light = is_povray ? colour_of(1.0f, 1.0f, 1.0f) : colour_of(0.0f, 0.0f, 0.0f);
    m->opacity_uses_filter_colour = is_povray && !is_new;
    m->fresnel_metallic = is_povray;
    finish_gamma(in, is_new);
}
