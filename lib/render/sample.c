#include "render/sample.h"

/* The edge of a square grid of `count`, or 0. */
static int root_of(int count)
{
    int edge = 1;

    while (edge * edge < count)
        edge++;
    return edge * edge == count ? edge : 0;
}

/* The lowest `bits` binary digits of i in the opposite order. */
static unsigned mirrored(unsigned i, int bits)
{
    unsigned m = 0;

    for (; bits > 0; bits--, i >>= 1)
        m = m << 1 | (i & 1u);
    return m;
}

static void fill_grid(sample *s, int edge)
{
    for (int i = 0; i < edge * edge; i++) {
        s[i].x = (i % edge + 0.5) / edge;
        s[i].y = (i / edge + 0.5) / edge;
    }
}

/* Columns in order, rows in the order of van der Corput's sequence: one sample in each of `count` rows and
 * columns. */
static void fill_hammersley(sample *s, int count)
{
    int bits = 0, row = 0;

    while (1 << bits < count)
        bits++;
    for (unsigned v = 0; v < 1u << bits; v++) {
        unsigned i = mirrored(v, bits);

        if (i >= (unsigned)count)
            continue;
        s[i].x = (i + 0.5) / count;
        s[i].y = (row++ + 0.5) / count;
    }
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
