#include "shade/spectrum.h"

/* Shares of white light in equal parts of the spectrum, as POV-Ray has them. */
enum { CELLS = 20 };
static const colour cells[CELLS] = {
    { .0531f, 0, 0 },      { .0961f, 0, 0 },      { .1274f, 0, 0 },      { .1449f, .0183f, 0 }, { .1496f, .0643f, 0 },
    { .1412f, .0995f, 0 }, { .1191f, .1253f, 0 }, { .0852f, .1395f, 0 }, { .0363f, .1436f, 0 }, { .0013f, .1370f, .0122f },
    { 0, .1193f, .0529f }, { 0, .0919f, .0855f }, { 0, .0524f, .1105f }, { 0, .0088f, .1261f }, { 0, 0, .1336f },
    { 0, 0, .1322f },      { .0020f, 0, .1221f }, { .0117f, 0, .1039f }, { .0152f, 0, .0761f }, { .0105f, 0, .0410f },
};

colour spectrum_of(int i, int n)
{
    colour sum = colour_of(0.0f, 0.0f, 0.0f);

    for (int k = 0; k < CELLS; k++) {
        const float first = fmaxf((float)k, (float)(CELLS * i) / (float)n);
        const float last = fminf((float)(k + 1), (float)(CELLS * (i + 1)) / (float)n);

        if (last > first)
            sum = colour_add(sum, colour_scale(cells[k], last - first));
    }
    return sum;
}
