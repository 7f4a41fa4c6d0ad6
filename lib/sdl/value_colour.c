#include "sdl/report.h"
#include "sdl/value.h"

#include <float.h>
#include <math.h>

enum { RED, GREEN, BLUE, FILTER, TRANSMIT, CHANNELS };

/* What a colour's word says of the numbers behind it: how many a lone number stands for, and which channel
 * the fourth number is. Any of them takes up to five numbers. */
typedef struct form {
    word_id word;
    int channels, fourth;
} form;

static const form forms[] = {
    { WORD_RGB, 3, FILTER },
    { WORD_RGBF, 4, FILTER },
    { WORD_RGBT, 4, TRANSMIT },
    { WORD_RGBFT, 5, FILTER },
};
static const form plain = { WORD_COLOR, 5, FILTER };

static const form *form_of(word_id word)
{
    size_t i;

    for (i = 0; i < sizeof forms / sizeof forms[0]; i++)
        if (forms[i].word == word)
            return &forms[i];
    return NULL;
}

static int channel_of(word_id word)
{
    switch (word) {
    case WORD_RED:
        return RED;
    case WORD_GREEN:
        return GREEN;
    case WORD_BLUE:
        return BLUE;
    case WORD_FILTER:
        return FILTER;
    case WORD_TRANSMIT:
        return TRANSMIT;
    default:
        return -1;
    }
}

bool value_colour_follows(const pov_reader *in, bool bare)
{
    return (in->token.symbol && (in->token.symbol->flags & TRAIT_PAINT)) || (bare && value_follows(in));
}

static void read_numbers(pov_reader *in, const form *f, float out[CHANNELS])
{
    const int most = f->fourth == TRANSMIT ? 4 : 5;
    double v[VALUE_LIST_MAX];
    bool is_list = in->token.kind == '<';
    int i, count = value_list(in, "a colour", 1, most, v);

    if (count > f->channels && is_list)
        report_warn(in, &in->value, "more numbers than \"%s\" says: the fourth is filter, the fifth transmit",
                    token_word_name(f->word));
    if (!is_list)
        for (i = 1; i < f->channels; i++)
            v[i] = v[0];
    for (i = 0; i < most && !in->failed; i++) {
        if (fabs(v[i]) > FLT_MAX)
            report_fail(in, &in->value, POV_E_SYNTAX, "a number beyond %g has no use in a colour",
                        (double)FLT_MAX);
        out[i < 3 ? i : i == 3 ? f->fourth : TRANSMIT] = (float)v[i];
    }
}

/* `red 1 green .5 ...`, alone or behind other forms, where they replace single channels. */
static void read_channels(pov_reader *in, float out[CHANNELS])
{
    int channel;

    while ((channel = channel_of(state_word(in))) >= 0 && !in->failed) {
        state_advance(in);
        out[channel] = value_float(in);
    }
}

paint value_colour(pov_reader *in, bool bare)
{
    float c[CHANNELS] = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
    const form *f;
    paint result;

    if (state_word(in) == WORD_COLOR || state_word(in) == WORD_COLOUR) {
        state_advance(in);
        bare = true;
    }
    f = form_of(state_word(in));
    if (f) {
        state_advance(in);
        read_numbers(in, f, c);
    } else if (channel_of(state_word(in)) < 0) {
        if (bare && value_follows(in))
            read_numbers(in, &plain, c);
        else
            report_expected(in, "a colour");
    }
    read_channels(in, c);
    result.colour = colour_of(c[RED], c[GREEN], c[BLUE]);
    result.filter = c[FILTER];
    result.transmit = c[TRANSMIT];
    return result;
}
