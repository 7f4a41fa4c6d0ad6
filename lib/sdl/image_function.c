#include "sdl/image_function.h"

#include "sdl/function_host.h"
#include "sdl/host_parts.h"
#include "sdl/limit.h"
#include "sdl/report.h"
#include "sdl/value.h"

enum { SIDE_MAX = 1 << 15 };

static uint32_t parse_side(pov_reader *in)
{
    const double side = value_number(in);

    if (in->failed || (side >= 1.0 && side <= SIDE_MAX))
        return (uint32_t)side;
    report_fail(in, &in->value, POV_E_SYNTAX, "the sides of an image are 1 to %d pixels", SIDE_MAX);
    return 0;
}

/* From 0 to 1, in steps of one less than there are pixels. */
static double place_of(uint32_t i, uint32_t count) { return count > 1 ? (double)i / (count - 1) : 0.0; }

/* Beyond 0 and 1 the lowest 16 bits count, as in POV-Ray. */
static uint16_t sample_of(double v)
{
    const double whole = 65535.0 * v;

    return whole > -0x1p31 && whole < 0x1p31 ? (uint16_t)(int32_t)whole : 0;
}

/* Several pixels of a row at once. */
static void fill(pov_reader *in, const pov_function *f, const image *of, uint16_t *samples, double *memory)
{
    double at[3][POV_VALUES] = { { 0.0 } }, found[POV_VALUES];

    for (uint32_t row = 0; row < of->height && limit_time(in, &in->value); row++)
        for (uint32_t from = 0; from < of->width; from += POV_VALUES) {
            const uint32_t n = of->width - from < POV_VALUES ? of->width - from : POV_VALUES;

            for (uint32_t i = 0; i < POV_VALUES; i++) {
                at[0][i] = place_of(from + i, of->width);
                at[1][i] = place_of(row, of->height);
            }
            f->values(f, at[0], n, memory, found);
            for (uint32_t i = 0; i < n; i++)
                samples[(size_t)row * of->width + from + i] = sample_of(found[i]);
        }
}

/* The filter of a pigment is not kept, as POV-Ray has it. */
static void fill_colours(pov_reader *in, const function *f, const image *of, uint16_t *samples)
{
    for (uint32_t row = 0; row < of->height && limit_time(in, &in->value); row++)
        for (uint32_t column = 0; column < of->width; column++, samples += 4) {
            const double at[3] = { place_of(column, of->width), place_of(row, of->height), 0.0 };
            double c[5];

            function_host_colour(f, at, c);
            for (int k = 0; k < 3; k++)
                samples[k] = sample_of(c[k]);
            samples[3] = sample_of(1.0 - c[4]);
        }
}

const image *image_function_parse(pov_reader *in, bool colours)
{
    const pov_function *f;
    uint16_t *samples;
    double *memory;
    image *out = state_alloc(in, sizeof *out, 16);

    if (!out)
        return NULL;
    out->width = parse_side(in);
    state_accept(in, ',');
    out->height = parse_side(in);
    f = host_function(in, 3);
    if (!f || in->failed)
        return NULL;
    colours = colours && host_function_of(f)->kind == FUNCTION_PIGMENT;
    out->channels = colours ? 4 : 1;
    out->has_alpha = colours;
    out->bits = 16;
    out->encoding = POV_ENCODING_STORED;
    out->stride = sizeof *samples * out->channels * out->width;
    if (!limit_images(in, out->stride * out->height)) {
        report_fail(in, &in->value, POV_E_MEMORY, "this image takes %zu bytes, of %zu that images may still take", out->stride * out->height,
                    in->limits.images - in->image_bytes);
        return NULL;
    }
    samples = state_alloc(in, out->stride * out->height, 16);
    memory = state_alloc(in, f->memory_many * sizeof *memory, 16);
    if (in->failed)
        return NULL;
    if (colours)
        fill_colours(in, host_function_of(f), out, samples);
    else
        fill(in, f, out, samples, memory);
    out->samples = (unsigned char *)samples;
    return in->failed ? NULL : out;
}
