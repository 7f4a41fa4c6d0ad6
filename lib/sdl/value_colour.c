#include "sdl/value.h"

#include "sdl/expression.h"
#include "sdl/report.h"
#include "sdl/working.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { RED, GREEN, BLUE, FILTER, TRANSMIT, CHANNELS };

/* What a colour's word says of the numbers behind it: how many a lone number stands for, and which channel
 * the fourth number is. Any of them takes up to five numbers. */
typedef struct form {
    keyword_id keyword;
    int channels, fourth;
    bool is_encoded;             /* by the curve of sRGB */
} form;

static const form forms[] = {
    { KEYWORD_RGB, 3, FILTER, false },   { KEYWORD_RGBF, 4, FILTER, false },   { KEYWORD_RGBT, 4, TRANSMIT, false },
    { KEYWORD_RGBFT, 5, FILTER, false }, { KEYWORD_SRGB, 3, FILTER, true },    { KEYWORD_SRGBF, 4, FILTER, true },
    { KEYWORD_SRGBT, 4, TRANSMIT, true }, { KEYWORD_SRGBFT, 5, FILTER, true },
};
static const form plain = { KEYWORD_COLOR, 5, FILTER, false };

static const form *form_of(keyword_id keyword)
{
    size_t i;

    for (i = 0; i < sizeof forms / sizeof forms[0]; i++)
        if (forms[i].keyword == keyword)
            return &forms[i];
    return NULL;
}

static int channel_of(keyword_id keyword)
{
    switch (keyword) {
    case KEYWORD_RED:
        return RED;
    case KEYWORD_GREEN:
        return GREEN;
    case KEYWORD_BLUE:
        return BLUE;
    case KEYWORD_FILTER: case KEYWORD_ALPHA:
        return FILTER;
    case KEYWORD_TRANSMIT:
        return TRANSMIT;
    default:
        return -1;
    }
}

static bool is_colour_value(const value *v)
{
    if (v->kind == VALUE_ARRAY)
        return value_array(v)->kind == VALUE_VECTOR && value_array(v)->size == 5;
    return v->kind == VALUE_VECTOR && v->size == 5;
}

bool value_colour_follows(const pov_reader *in, bool bare)
{
    const symbol *word = in->token.symbol;

    if (word && ((word->flags & KEYWORD_FLAG_PAINT) || (word->binding && is_colour_value(word->binding->slot))))
        return true;
    return bare && value_follows(in);
}

/* As many as were given, a number counting as `alone` of them. */
static int read_components(pov_reader *in, bool bare, double out[CHANNELS], const place *at)
{
    value v = value_read(in, "a colour");
    int i;

    in->value = *at;
    if (!in->failed && v.kind != VALUE_VECTOR && v.kind != VALUE_NUMBER)
        report_fail(in, at, POV_E_SYNTAX, "expected a colour, found %s", value_name(&v));
    if (!in->failed && !bare && v.size != 5)
        report_fail(in, at, POV_E_SYNTAX, "expected a colour, found %s; \"color\" before it makes it one",
                    value_name(&v));
    for (i = 0; i < CHANNELS; i++)
        out[i] = in->failed ? 0.0 : i < v.size ? v.as.v[i] : 0.0;
    if (value_is_shared(&v))
        value_drop(&in->heap, &v);
    return v.kind == VALUE_VECTOR ? v.size : 1;
}

/* A lone number fills the channels of the form; the fourth component is what the form says. */
static void spread(const form *f, int count, const double v[CHANNELS], double out[CHANNELS])
{
    int i;

    for (i = 0; i < 3; i++)
        out[i] = v[count == 1 ? 0 : i];
    if (count == 1) {
        out[f->fourth] = f->channels > 3 ? v[0] : 0.0;
        if (f->channels == 5)
            out[FILTER] = out[TRANSMIT] = v[0];
    } else if (f->fourth == TRANSMIT) {
        out[TRANSMIT] = v[3];
    } else {
        out[FILTER] = v[3];
        out[TRANSMIT] = v[4];
    }
}

static void read_form(pov_reader *in, const form *f, bool bare, double out[CHANNELS])
{
    const place at = in->token.at;
    double v[CHANNELS];
    int i, count = read_components(in, bare, v, &at);

    if (count > f->channels)
        report_warn(in, &at, "more numbers than \"%s\" says: the fourth is filter, the fifth transmit",
                    token_keyword_name(f->keyword));
    spread(f, count, v, out);
    for (i = 0; i < 3 && f->is_encoded; i++)
        out[i] = working_of(&in->settings, srgb_decode(out[i]));
}

/* `red 1 green .5 ...`, alone or behind other forms, where they replace single channels. */
static void read_channels(pov_reader *in, double out[CHANNELS])
{
    int channel;

    while ((channel = channel_of(state_keyword(in))) >= 0 && !in->failed) {
        if (state_keyword(in) == KEYWORD_ALPHA)
            report_warn(in, &in->token.at, "\"alpha\" is taken for \"filter\"");
        state_advance(in);
        out[channel] = expression_number(in);
    }
}

static void check_range(pov_reader *in, const place *at, double out[CHANNELS])
{
    int i;

    for (i = 0; i < CHANNELS; i++) {
        if (fabs(out[i]) <= FLT_MAX)
            continue;
        report_fail(in, at, POV_E_SYNTAX, "a number beyond %g has no use in a colour", (double)FLT_MAX);
        memset(out, 0, CHANNELS * sizeof *out);
        break;
    }
}

/* Returns where the numbers begin. */
static place read_colour(pov_reader *in, bool bare, double out[CHANNELS])
{
    place at, word;
    const form *f;
    bool is_named = false;
    int i;

    for (i = 0; i < CHANNELS; i++)
        out[i] = 0.0;
    state_settle(in);
    word = in->token.at;
    while (!in->failed && (state_keyword(in) == KEYWORD_COLOR || state_keyword(in) == KEYWORD_COLOUR)) {
        state_advance(in);
        state_settle(in);
        is_named = true;
    }
    at = in->token.at;
    f = form_of(state_keyword(in));
    if (f) {
        state_advance(in);
        at = in->token.at;
        read_form(in, f, true, out);
    } else if (channel_of(state_keyword(in)) < 0) {
        if (value_colour_follows(in, bare || is_named))
            read_form(in, &plain, bare || is_named, out);
        else if (is_named)
            report_warn(in, &word, "no colour follows \"color\": it is black");
        else
            report_expected(in, "a colour");
    }
    read_channels(in, out);
    for (i = 0; i < CHANNELS && in->failed; i++)
        out[i] = 0.0;
    return at;
}

void value_colour_any(pov_reader *in, bool bare, double out[CHANNELS])
{
    read_colour(in, bare, out);
}

void value_colour_components(pov_reader *in, bool bare, double out[CHANNELS])
{
    const place at = read_colour(in, bare, out);

    check_range(in, &at, out);
}

paint value_colour(pov_reader *in, bool bare)
{
    double c[CHANNELS];
    paint result;

    value_colour_components(in, bare, c);
    result.colour = colour_of((float)c[RED], (float)c[GREEN], (float)c[BLUE]);
    result.filter = (float)c[FILTER];
    result.transmit = (float)c[TRANSMIT];
    return result;
}
