#include "bar.h"

#include "add.h"
#include "ramp.h"

#include <math.h>
#include <string.h>

const bar_scale bar_samples = { 1.0, 1024.0 }, bar_seconds = { 1e-6, 1e-2 }, bar_error = { 1e-4, 1e-1 };

double bar_share(const bar_scale *s, double value)
{
    return log(value / s->low) / log(s->high / s->low);
}

double bar_depth_share(double middle, double depth)
{
    return 1.0 - 1.0 / (1.0 + pow(depth / middle, 3.0));
}

static uint8_t byte_of(double share)
{
    return (uint8_t)(255.0 * (share > 0.0 ? share < 1.0 ? share : 1.0 : 0.0) + 0.5);
}

void bar_color(int kind, double share, uint8_t *rgba)
{
    if (kind == BAR_RAMP) {
        ramp_color(share, rgba);
        return;
    }
    memset(rgba, 0, 3);
    rgba[3] = 255;
    if (kind == BAR_DEPTH)
        memset(rgba, byte_of(1.0 - share), 3);
    else
        rgba[kind - BAR_X] = byte_of(share);
}

void bar_write(const bar_scale *s, double unit, char *out, size_t size)
{
    const double rounding = 1.0 + 1e-9, short_enough = 5000.0;

    add(out, size, "~%c", BAR_RAMP);
    for (double v = s->low; v <= s->high * rounding; v *= 10.0) {
        add(out, size, "%s%.4f ", v > s->low ? "\t" : "", bar_share(s, v));
        if (v / unit > short_enough)
            add(out, size, "1e%.0f", log10(v / unit));
        else
            add(out, size, "%.4g", v / unit);
    }
    add(out, size, "\n");
}

void bar_write_depth(double middle, char *out, size_t size)
{
    static const double round_ones[] = { 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0 };
    const double first = 0.04, last = 0.96, apart = 0.19;
    double decade = pow(10.0, floor(log10(0.3 * middle))), before = -1.0;

    add(out, size, "~%c", BAR_DEPTH);
    for (int i = 0; i < 24; i++) {
        const double depth = round_ones[i % 8] * decade * pow(10.0, (double)(i / 8));
        const double share = bar_depth_share(middle, depth);

        if (share < first || share > last || share < before + apart)
            continue;
        add(out, size, "%s%.4f %.4g", before < 0.0 ? "" : "\t", share, depth);
        before = share;
    }
    add(out, size, "\n");
}
