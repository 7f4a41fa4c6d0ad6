#include "sdl/parse_photons.h"

#include "model/photons.h"
#include "sdl/expression.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

/* ---- the scene's settings ---- */

/* Of the block: was a word of POV-Ray's accuracy there? */
typedef struct settings_reading { photon_settings *out; bool has_accuracy; } settings_reading;

static photon_settings *settings_of(void *self) { return ((settings_reading *)self)->out; }

static void read_level(pov_reader *in, void *self, keyword_id keyword)
{
    const double level = value_number(in), most = 65535.0;

    (void)keyword;
    if (!in->failed && !(level >= 0.0 && level <= most))
        report_fail(in, &in->value, POV_E_SYNTAX, "\"max_trace_level\" must lie in 0 to %.0f", most);
    else if (!in->failed)
        settings_of(self)->max_trace_level = (int)level;
}

static void read_bailout(pov_reader *in, void *self, keyword_id keyword)
{
    const double bailout = value_number(in);

    (void)keyword;
    settings_of(self)->adc_bailout = bailout > 0.0 ? bailout : 0.0;
}

static void skip_values(pov_reader *in)
{
    do
        value_number(in);
    while (state_accept(in, ','));
}

static void skip_accuracy(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((settings_reading *)self)->has_accuracy = true;
    skip_values(in);
}

/* Photons light media if the first number is above 0; how well is left to the picture's samples. */
static void read_media(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    settings_of(self)->media = value_number(in) > 0.0;
    if (state_accept(in, ','))
        value_number(in);
}

static void skip_file(pov_reader *in, void *self, keyword_id keyword)
{
    (void)self;
    unsupported_skip_file(in, keyword, "photons");
}

void parse_photon_settings(pov_reader *in, void *self, keyword_id keyword)
{
    static const item items[] = {
        { KEYWORD_MAX_TRACE_LEVEL, read_level }, { KEYWORD_ADC_BAILOUT, read_bailout }, { KEYWORD_MEDIA, read_media },
        { KEYWORD_SPACING, skip_accuracy },      { KEYWORD_COUNT, skip_accuracy },      { KEYWORD_GATHER, skip_accuracy },
        { KEYWORD_JITTER, skip_accuracy },       { KEYWORD_AUTOSTOP, skip_accuracy },   { KEYWORD_RADIUS, skip_accuracy },
        { KEYWORD_EXPAND_THRESHOLDS, skip_accuracy }, { KEYWORD_SAVE_FILE, skip_file }, { KEYWORD_LOAD_FILE, skip_file },
    };
    static const item_list list = { "a setting of photons", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };
    settings_reading r = { &in->model->photons, false };
    const place at = in->last;

    (void)self;
    (void)keyword;
    r.out->given = true;
    items_block(in, &list, &r);
    if (r.has_accuracy && !in->failed)
        report_warn(in, &at, "the number of photons and where they are gathered is left to the samples of the picture");
}

/* ---- objects and lights ---- */

static void set(pov_reader *in, uint32_t *flags, uint32_t on, uint32_t off)
{
    const bool is_on = value_optional(in, 1.0) != 0.0;

    *flags = (*flags & ~(on | off)) | (is_on ? on : off);
}

static void read_flag(pov_reader *in, void *self, keyword_id keyword)
{
    switch (keyword) {
    case KEYWORD_TARGET: set(in, self, PHOTON_TARGET, 0); break;
    case KEYWORD_REFLECTION: set(in, self, PHOTON_REFLECTS, PHOTON_REFLECTS_NOT); break;
    case KEYWORD_REFRACTION: set(in, self, PHOTON_REFRACTS, PHOTON_REFRACTS_NOT); break;
    case KEYWORD_COLLECT: set(in, self, 0, PHOTON_IGNORES); break;
    case KEYWORD_PASS_THROUGH: set(in, self, PHOTON_THROUGH, 0); break;
    default: set(in, self, PHOTON_AREA, 0); break;
    }
}

void parse_photons_object(pov_reader *in, uint32_t *flags)
{
    static const item items[] = {
        { KEYWORD_TARGET, read_flag },  { KEYWORD_REFLECTION, read_flag },   { KEYWORD_REFRACTION, read_flag },
        { KEYWORD_COLLECT, read_flag }, { KEYWORD_PASS_THROUGH, read_flag },
    };
    static const item_list list = { "a property of photons", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };

    items_block(in, &list, flags);
}

void parse_photons_light(pov_reader *in, uint32_t *flags)
{
    static const item items[] = {
        { KEYWORD_REFLECTION, read_flag }, { KEYWORD_REFRACTION, read_flag }, { KEYWORD_AREA_LIGHT, read_flag },
    };
    static const item_list list = { "a property of photons", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };

    items_block(in, &list, flags);
}
