#include "sdl/parse_radiosity.h"

#include "sdl/expression.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

/* Directions from a surface that the camera sees: as many as POV-Ray has rays, or a
 * power of two below. More would take the time that samples of the picture need. */
enum { COUNT_DEFAULT = 35, DRAWS_MAX = 16 };

static uint32_t draws_of(double count)
{
    uint32_t draws = 1;

    while (draws < DRAWS_MAX && 2.0 * (double)draws <= count)
        draws *= 2;
    return draws;
}

void parse_radiosity_init(model *m)
{
    radiosity_settings *r = &m->radiosity;

    r->recursion_limit = 2;
    r->draws = draws_of(COUNT_DEFAULT);
    r->brightness = 1.0f;
    r->adc_bailout = 0.01;
}

/* The block: was a word of POV-Ray's accuracy there? */
typedef struct reading { radiosity_settings *out; bool has_accuracy; } reading;

static radiosity_settings *settings_of(void *self) { return ((reading *)self)->out; }

static double read_positive(pov_reader *in, keyword_id keyword)
{
    const double x = value_number(in);

    if (!in->failed && !(x >= 0.0))
        report_fail(in, &in->value, POV_E_SYNTAX, "\"%s\" must not be below 0", token_keyword_name(keyword));
    return x;
}

static void read_limit(pov_reader *in, void *self, keyword_id keyword)
{
    const double limit = value_number(in), most = 20.0;

    if (in->failed)
        return;
    if (!(limit >= 1.0 && limit <= most))
        report_fail(in, &in->value, POV_E_SYNTAX, "\"%s\" must lie in 1 to %.0f", token_keyword_name(keyword), most);
    else
        settings_of(self)->recursion_limit = (uint32_t)limit;
}

/* The second number, if there is one, is the size of POV-Ray's table of directions. */
static void read_count(pov_reader *in, void *self, keyword_id keyword)
{
    const double count = read_positive(in, keyword);

    if (state_accept(in, ','))
        value_number(in);
    settings_of(self)->draws = draws_of(count);
}

static void read_number(pov_reader *in, void *self, keyword_id keyword)
{
    radiosity_settings *out = settings_of(self);

    switch (keyword) {
    case KEYWORD_BRIGHTNESS: out->brightness = (float)value_number(in); break;
    case KEYWORD_GRAY_THRESHOLD: out->gray_threshold = (float)read_positive(in, keyword); break;
    case KEYWORD_ADC_BAILOUT: out->adc_bailout = read_positive(in, keyword); break;
    default: out->max_sample = (float)value_number(in); break;
    }
}

static void read_switch(pov_reader *in, void *self, keyword_id keyword)
{
    const bool on = value_optional(in, 1.0) != 0.0;

    if (keyword == KEYWORD_NORMAL)
        settings_of(self)->uses_normals = on;
    else
        settings_of(self)->sees_media = on;
}

static void skip_accuracy(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((reading *)self)->has_accuracy = true;
    do
        value_number(in);
    while (state_accept(in, ','));
}

static void skip_switch(pov_reader *in, void *self, keyword_id keyword)
{
    (void)self;
    (void)keyword;
    value_optional(in, 1.0);
}

static void skip_file(pov_reader *in, void *self, keyword_id keyword)
{
    (void)self;
    unsupported_skip_file(in, keyword, "radiosity");
}

void parse_radiosity(pov_reader *in, void *self, keyword_id keyword)
{
    static const item items[] = {
        { KEYWORD_RECURSION_LIMIT, read_limit },    { KEYWORD_COUNT, read_count },
        { KEYWORD_BRIGHTNESS, read_number },        { KEYWORD_GRAY_THRESHOLD, read_number },
        { KEYWORD_ADC_BAILOUT, read_number },       { KEYWORD_MAX_SAMPLE, read_number },
        { KEYWORD_NORMAL, read_switch },            { KEYWORD_MEDIA, read_switch },
        { KEYWORD_SUBSURFACE, skip_switch },        { KEYWORD_ALWAYS_SAMPLE, skip_switch },
        { KEYWORD_ERROR_BOUND, skip_accuracy },     { KEYWORD_LOW_ERROR_FACTOR, skip_accuracy },
        { KEYWORD_NEAREST_COUNT, skip_accuracy },   { KEYWORD_MINIMUM_REUSE, skip_accuracy },
        { KEYWORD_MAXIMUM_REUSE, skip_accuracy },   { KEYWORD_PRETRACE_START, skip_accuracy },
        { KEYWORD_PRETRACE_END, skip_accuracy },
        { KEYWORD_SAVE_FILE, skip_file },           { KEYWORD_LOAD_FILE, skip_file },
    };
    static const item_list list = { "a setting of radiosity", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };
    reading r = { &in->model->radiosity, false };
    const place at = in->last;

    (void)self;
    (void)keyword;
    r.out->given = true;
    items_block(in, &list, &r);
    if (r.has_accuracy && !in->failed)
        report_warn(in, &at, "radiosity has no table of samples: the accuracy is left to the samples of the picture");
}
