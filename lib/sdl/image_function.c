#include "sdl/image_function.h"

#include "base/lanes.h"
#include "sdl/function_host.h"
#include "sdl/host_parts.h"
#include "sdl/intern.h"
#include "sdl/limit.h"
#include "sdl/report.h"
#include "sdl/value.h"

#include <stddef.h>
#include <string.h>

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
static void put_sample(const double c[5], uint16_t out[4])
{
    for (int k = 0; k < 3; k++)
        out[k] = sample_of(c[k]);
    out[3] = sample_of(1.0 - c[4]);
}

static void fill_colours(pov_reader *in, const function *f, const image *of, uint16_t *samples)
{
    pov_vec3 at[LANES_MAX];
    double found[LANES_MAX][5];

    for (uint32_t row = 0; row < of->height && limit_time(in, &in->value); row++)
        for (uint32_t from = 0; from < of->width; from += LANES_MAX) {
            const uint32_t n = of->width - from < LANES_MAX ? of->width - from : LANES_MAX;

            for (uint32_t i = 0; i < n; i++)
                at[i] = pov_vec3_of(place_of(from + i, of->width), place_of(row, of->height), 0.0);
            function_host_colours(f, at, n, found);
            for (uint32_t i = 0; i < n; i++, samples += 4)
                put_sample(found[i], samples);
        }
}

static bool parse_sides(pov_reader *in, image *out)
{
    out->width = parse_side(in);
    state_accept(in, ',');
    out->height = parse_side(in);
    return !in->failed;
}

static void set_format(image *out, bool colours)
{
    out->channels = colours ? 4 : 1;
    out->has_alpha = colours;
    out->bits = 16;
    out->encoding = POV_ENCODING_STORED;
    out->stride = sizeof(uint16_t) * out->channels * out->width;
}

static bool make_samples(pov_reader *in, const pov_function *f, image *out)
{
    uint16_t *samples;
    double *memory;

    if (!limit_images(in, out->stride * out->height)) {
        report_fail(in, &in->value, POV_E_MEMORY, "this image takes %zu bytes, of %zu that images may still take", out->stride * out->height,
                    in->limits.images - in->image_bytes);
        return false;
    }
    samples = state_alloc(in, out->stride * out->height, 16);
    memory = state_alloc(in, f->memory_many * sizeof *memory, 16);
    if (in->failed)
        return false;
    if (out->has_alpha)
        fill_colours(in, host_function_of(f), out, samples);
    else
        fill(in, f, out, samples, memory);
    out->samples = (unsigned char *)samples;
    return !in->failed;
}

/* What an image of a pattern or a pigment is made of, and the image. Equal patterns are one, by their addresses. */
typedef struct made {
    const char *tag;             /* keeps it apart from what else is interned */
    const pigment_node *pigment;
    const pattern *pattern;
    uint32_t width, height, waves;
    int32_t noise_generator;
    bool colours;
    const image *image;          /* NULL: yet to be made */
} made;

/* NULL: of a formula, or the reader has failed. */
static made *find_made(pov_reader *in, const function *f, const image *of)
{
    static const char tag[] = "made";
    made key;

    if (f->kind == FUNCTION_FORMULA)
        return NULL;
    memset(&key, 0, sizeof key);
    key.tag = tag;
    key.pigment = f->pigment;
    key.pattern = f->pattern;
    key.width = of->width;
    key.height = of->height;
    key.waves = in->model->number_of_waves;
    key.noise_generator = in->model->noise_generator;
    key.colours = of->has_alpha;
    return (made *)intern(in, &key, sizeof key, offsetof(made, image));
}

const image *image_function_parse(pov_reader *in, bool colours)
{
    image *const out = state_alloc(in, sizeof *out, 16);
    const pov_function *f;
    made *same;

    if (!out || !parse_sides(in, out))
        return NULL;
    f = host_function(in, 3);
    if (!f || in->failed)
        return NULL;
    set_format(out, colours && host_function_of(f)->kind == FUNCTION_PIGMENT);
    same = find_made(in, host_function_of(f), out);
    if (same && same->image)
        return same->image;
    if (in->failed || !make_samples(in, f, out))
        return NULL;
    if (same)
        same->image = out;
    return out;
}
