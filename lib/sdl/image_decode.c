#include "sdl/image_decode.h"

#include "sdl/working.h"

#include <string.h>

/* A stored number goes through the file's curve to linear light, and from there to what the scene calculates in. */
typedef struct curve {
    pov_encoding encoding;
    double power;
    const settings_parsed *working;   /* NULL: it stays as it is */
    bool is_cut;                 /* decoded grey is stored in bytes */
} curve;

static double power_of(double v, double power)
{
    return power == 1.0 ? v : v < 0.0 ? 0.0 : elementary_pow(v, power);
}

static double decoded(const curve *c, double v)
{
    const double linear = c->encoding == POV_ENCODING_SRGB ? srgb_decode(v)
                        : c->encoding == POV_ENCODING_POWER ? power_of(v, c->power) : v;

    return c->working ? working_of(c->working, linear) : linear;
}

int image_cut_grey(double v)
{
    const float q = (float)v, grey = 0.297f * q + 0.589f * q + 0.114f * q;

    return (int)floor(255.0f * grey);
}

double image_decoded(const image_gamma *given, double v)
{
    const curve c = { given->is_srgb ? POV_ENCODING_SRGB : POV_ENCODING_POWER, given->number, NULL, false };

    return decoded(&c, v);
}

static float value_of(const curve *c, double stored)
{
    const double v = decoded(c, stored);

    return (float)(c->is_cut ? image_cut_grey(v) / 255.0 : v);
}

/* ---- which curve ---- */

/* Scenes before 3.7 take what is stored, but where the file and the scene both say what is meant. */
static bool is_decoded(const pov_reader *in, const image *of, const image_gamma *given, bool is_plain)
{
    if (given->is_given)
        return true;
    if (is_plain || of->encoding == POV_ENCODING_STORED)
        return false;
    return in->version >= 3.7 || (of->encoding == POV_ENCODING_POWER && in->settings.assumed_gamma > 0.0);
}

static curve choose(const pov_reader *in, const image *of, const image_gamma *given, bool is_plain)
{
    const settings_parsed *working = is_plain ? NULL : &in->settings;   /* heights and values are no light */
    curve c = { POV_ENCODING_STORED, 1.0, NULL, of->is_cut };

    if (of->encoding == POV_ENCODING_LINEAR && !given->is_given) {
        c.working = working;
    } else if (is_decoded(in, of, given, is_plain)) {
        c.encoding = given->is_given ? given->is_srgb ? POV_ENCODING_SRGB : POV_ENCODING_POWER : of->encoding;
        c.power = given->is_given ? given->number : of->power;
        c.working = working;
    }
    return c;
}

static bool is_stored(const curve *c)
{
    return c->encoding == POV_ENCODING_STORED && !c->is_cut && (!c->working || working_is_linear(c->working));
}

/* ---- tables ---- */

static const float *make_table(pov_reader *in, const curve *c, uint32_t bits)
{
    const uint32_t count = 1u << bits;
    float *table = state_alloc(in, count * sizeof *table, 16);

    for (uint32_t i = 0; table && i < count; i++)
        table[i] = value_of(c, (double)i / (count - 1));
    return table;
}

/* Filter and transmit: of all, then of the entry. */
static void set_alphas(const image_map *map, const image_alphas *a, uint32_t i, pigment *out)
{
    const image *of = map->image;

    out->filter = a->filter[i] >= 0.0f ? a->filter[i] : map->filter;
    out->transmit = a->has_transmit_all || !of->has_alpha ? map->transmit : (float)(1.0 - of->palette[i][3] / 255.0);
    if (a->transmit[i] >= 0.0f)
        out->transmit = a->transmit[i];
}

static double divisor_of(const image_map *map, const unsigned char *entry)
{
    return map->premultiplied && map->image->has_alpha && entry[3] > 0 ? entry[3] : 255.0;
}

static const pigment *make_palette(pov_reader *in, const image_map *map, const curve *c, const image_alphas *alphas)
{
    pigment *palette = state_alloc(in, 256 * sizeof *palette, 16);

    for (uint32_t i = 0; palette && i < 256; i++) {
        const unsigned char *from = map->image->palette[i];

        const float by = (float)(255.0 / divisor_of(map, from));

        palette[i].color = colour_of(by * value_of(c, from[0] / 255.0), by * value_of(c, from[1] / 255.0), by * value_of(c, from[2] / 255.0));
        set_alphas(map, alphas, i, &palette[i]);
    }
    return palette;
}

static void decode_row(const curve *c, const image *of, const unsigned char *from, float *to)
{
    const uint32_t colours = of->channels - (of->channels % 2 == 0 ? 1 : 0);

    memcpy(to, from, sizeof *to * of->width * of->channels);
    for (uint32_t x = 0; x < of->width; x++)
        for (uint32_t k = 0; k < colours; k++)
            to[x * of->channels + k] = value_of(c, to[x * of->channels + k]);
}

/* Floats are decoded at once, in a copy; alpha stays. */
static const image *make_floats(pov_reader *in, const image *of, const curve *c)
{
    const size_t row = (size_t)of->width * of->channels;
    image *copy = state_alloc(in, sizeof *copy, 16);
    float *samples = state_alloc(in, row * sizeof *samples * of->height, 16);

    if (!copy || !samples)
        return of;
    *copy = *of;
    copy->samples = (unsigned char *)samples;
    copy->stride = row * sizeof *samples;
    for (uint32_t y = 0; y < of->height; y++)
        decode_row(c, of, of->samples + y * of->stride, samples + y * row);
    return copy;
}

void image_decode(pov_reader *in, image_map *map, const image_gamma *given, const image_alphas *alphas, bool is_plain)
{
    const image *of = map->image;
    const curve c = choose(in, of, given, is_plain);

    if (of->colours > 0)
        map->palette = make_palette(in, map, &c, alphas);
    else if (is_stored(&c))
        map->decoded = NULL;
    else if (of->bits < 32)
        map->decoded = make_table(in, &c, of->bits);
    else
        map->image = make_floats(in, of, &c);
}
