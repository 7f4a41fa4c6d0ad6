#include "sdl/noise.h"
#include "sdl/parse_photons.h"
#include "sdl/parse_radiosity.h"
#include "sdl/report.h"
#include "sdl/value.h"

/* More levels than this are a slip, and each tracer keeps room for all of them. */
static const double most_levels = 65535.0;

static void read_ambient_light(pov_reader *in, void *self, keyword_id keyword)
{
    (void)self;
    (void)keyword;
    in->model->ambient_light = value_colour(in, true).colour;
    in->settings.has_ambient_light = true;
}

static void read_irid_wavelength(pov_reader *in, void *self, keyword_id keyword)
{
    (void)self;
    (void)keyword;
    in->model->irid_wavelength = value_colour(in, true).colour;
}

static void read_max_trace_level(pov_reader *in, void *self, keyword_id keyword)
{
    double level = value_number(in);

    (void)self;
    (void)keyword;
    if (level < 0.0 || level > most_levels) {
        report_fail(in, &in->value, POV_E_SYNTAX, "\"max_trace_level\" must lie in 0 to %.0f", most_levels);
        return;
    }
    if (level != (double)(int)level)
        report_warn(in, &in->value, "a trace level is a whole number: %d is taken", (int)level);
    in->model->max_trace_level = (int)level;
}

/* Weights are floats: one that is below the number is below this, too. */
static double float_above(double number)
{
    const float near = (float)number;

    return (double)((double)near < number ? nextafterf(near, HUGE_VALF) : near);
}

static void read_adc_bailout(pov_reader *in, void *self, keyword_id keyword)
{
    (void)self;
    (void)keyword;
    in->model->adc_bailout = float_above(value_number(in));
}

static void read_assumed_gamma(pov_reader *in, void *self, keyword_id keyword)
{
    const bool is_srgb = state_accept_keyword(in, KEYWORD_SRGB);
    const double number = is_srgb ? 2.2 : value_number(in);

    (void)self;
    (void)keyword;
    if (!in->failed && number <= 0.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"assumed_gamma\" must be above 0");
    if (in->settings.assumed_gamma > 0.0) {
        report_warn(in, &in->value, "the \"assumed_gamma\" that was given first stays");
        return;
    }
    in->settings.assumed_gamma = number;
    in->settings.assumed_srgb = is_srgb;
}

static void read_noise_generator(pov_reader *in, void *self, keyword_id keyword)
{
    const double number = value_number(in);

    (void)self;
    (void)keyword;
    if (number != 1.0 && number != 2.0 && number != 3.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"noise_generator\" must be 1, 2 or 3");
    else
        in->model->noise_generator = (int)number;
    in->settings.has_noise_generator = true;
}

static void read_number_of_waves(pov_reader *in, void *self, keyword_id keyword)
{
    const double number = value_number(in), most = 1000.0;

    (void)self;
    (void)keyword;
    if (number < 0.0 || number > most) {
        report_fail(in, &in->value, POV_E_SYNTAX, "\"number_of_waves\" must lie in 0 to %.0f", most);
        return;
    }
    if (number < 1.0)
        report_warn(in, &in->value, "a number of 0 waves counts as 1");
    in->model->number_of_waves = number < 1.0 ? 1 : (uint32_t)number;
}

/* Settings of old versions. */
static void read_unused(pov_reader *in, void *self, keyword_id keyword)
{
    const place at = in->last;

    (void)self;
    if (value_optional(in, 1.0) != 0.0 && !in->failed)
        report_warn(in, &at, "\"%s\" has had no effect since version 3.7", token_keyword_name(keyword));
}

static const keyword_id quiet[] = {
    KEYWORD_CHARSET, KEYWORD_ASCII, KEYWORD_UTF8, KEYWORD_SYS,
    KEYWORD_OTHER,
};

static void read_mm_per_unit(pov_reader *in, void *self, keyword_id keyword)
{
    const double number = value_number(in);

    (void)self;
    (void)keyword;
    if (!in->failed && !(number > 0.0))
        report_fail(in, &in->value, POV_E_SYNTAX, "\"mm_per_unit\" must be above 0");
    in->model->subsurface.mm_per_unit = number;
}

/* How many samples there are is left to those of the picture. */
static void read_subsurface(pov_reader *in, void *self, keyword_id keyword)
{
    static const keyword_id accuracy[] = { KEYWORD_SAMPLES, KEYWORD_RADIOSITY, KEYWORD_OTHER };
    static const item_list list = { "a setting of subsurface light", NULL, 0, accuracy, NULL, NULL, VALUE_NOTHING, NULL };

    (void)self;
    (void)keyword;
    in->model->subsurface.given = true;
    items_block(in, &list, NULL);
}

void parse_global_settings(pov_reader *in, void *self, keyword_id keyword)
{
    static const item items[] = {
        { KEYWORD_AMBIENT_LIGHT, read_ambient_light },
        { KEYWORD_MAX_TRACE_LEVEL, read_max_trace_level },
        { KEYWORD_ADC_BAILOUT, read_adc_bailout },
        { KEYWORD_ASSUMED_GAMMA, read_assumed_gamma },
        { KEYWORD_NOISE_GENERATOR, read_noise_generator },
        { KEYWORD_NUMBER_OF_WAVES, read_number_of_waves },
        { KEYWORD_IRID_WAVELENGTH, read_irid_wavelength },
        { KEYWORD_MAX_INTERSECTIONS, read_unused },
        { KEYWORD_HF_GRAY_16, read_unused },
        { KEYWORD_PHOTONS, parse_photon_settings },
        { KEYWORD_SUBSURFACE, read_subsurface },
        { KEYWORD_MM_PER_UNIT, read_mm_per_unit },
        { KEYWORD_RADIOSITY, parse_radiosity },
    };
    static const item_list list = { "a setting", ITEMS(items), quiet, NULL, NULL, VALUE_NOTHING, NULL };

    (void)self;
    (void)keyword;
    items_block(in, &list, NULL);
}

/* What a background lets through is black; before version 3.7 it let nothing through. */
void parse_background(pov_reader *in, void *self, keyword_id keyword)
{
    static const item_list list = { "a colour", NULL, 0, NULL, NULL, NULL, VALUE_NOTHING, NULL };
    block b;
    paint p;

    (void)self;
    (void)keyword;
    items_open(in, &b);
    if (in->token.kind != '}') {
        p = value_colour(in, true);
        in->model->sky_colour.color = p.colour;
        in->model->sky_colour.filter = p.filter;
        in->model->sky_colour.transmit = p.transmit;
    }
    items_close(in, &b, &list, NULL);
}

void parse_old_level(pov_reader *in, const place *at)
{
    (void)at;
    state_advance(in);
    read_max_trace_level(in, NULL, KEYWORD_MAX_TRACE_LEVEL);
}

void parse_old_limit(pov_reader *in, const place *at)
{
    (void)at;
    state_advance(in);
    read_unused(in, NULL, KEYWORD_MAX_INTERSECTIONS);
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
    g->decodes_srgb = in->settings.assumed_srgb;
    if (in->settings.assumed_gamma > 0.0 || is_new)
        g->transfer = POV_TRANSFER_SRGB;
}

void parse_settings_finish(pov_reader *in)
{
    model *m = in->model;
    bool is_povray = m->dialect == POV_DIALECT_POVRAY, is_new = in->settings.version >= 3.7;

    if (!in->settings.has_ambient_light)
        m->ambient_light = is_povray ? colour_of(1.0f, 1.0f, 1.0f) : colour_of(0.0f, 0.0f, 0.0f);
    if (m->radiosity.given && is_new)
        m->ambient_light = colour_of(0.0f, 0.0f, 0.0f);   /* it stood for what radiosity finds */
    m->opacity_uses_filter_colour = is_povray && !is_new;
    m->fresnel_metallic = is_povray;
    m->opaque_last_level = m->opaque_dark_filters = is_povray;
    m->background = m->sky_colour.color;
    if (!is_povray || is_new)
        m->background = colour_scale(m->background, 1.0f - m->sky_colour.transmit);
    m->sky_is_old = is_povray && !is_new;
    finish_gamma(in, is_new);
    noise_finish(in);
}
