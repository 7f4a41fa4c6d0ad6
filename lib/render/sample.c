#include "render/sample.h"

/* The edge of a square grid of `count`, or 0. */
static int root_of(int count)
{
    int edge = 1;

    while (edge * edge < count)
        edge++;
    return edge * edge == count ? edge : 0;
}

/* The binary digits of i, mirrored at the point: van der Corput's sequence. */
static double mirrored_bits(unsigned i)
{
    double value = 0.0, digit = 0.5;

    for (; i > 0; i >>= 1, digit *= 0.5)
        value += (i & 1u) ? digit : 0.0;
    return value;
}

static void fill_grid(sample *s, int edge)
{
    for (int i = 0; i < edge * edge; i++) {
        s[i].x = (i % edge + 0.5) / edge;
        s[i].y = (i / edge + 0.5) / edge;
    }
}

/* The mean of the mirrored bits is below a half by no more than the room above their largest. */
static void fill_hammersley(sample *s, int count)
{
    double sum = 0.0;

    for (int i = 0; i < count; i++) {
        s[i].x = (i + 0.5) / count;
        s[i].y = mirrored_bits((unsigned)i);
        sum += s[i].y;
    }
    for (int i = 0; i < count; i++)
        s[i].y += 0.5 - sum / count;
}

sample *samples_make(const env *e, int count)
{
    sample *s = env_resize(e, NULL, (size_t)count, sizeof *s);
    int edge = root_of(count);

    if (!s)
        return NULL;
    if (edge > 0)
        fill_grid(s, edge);
    else
        fill_hammersley(s, count);
    return s;
}
