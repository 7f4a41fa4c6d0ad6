#include "zoom.h"

#include <math.h>

static const int factors[] = { 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128 };
enum { FACTORS = sizeof factors / sizeof factors[0] };

static int factor_of(const zoom *z)
{
    return z->factor > 1 ? z->factor : 1;
}

bool zoom_is_on(const zoom *z)
{
    return z->factor > 1;
}

static double clamp(double v, double most)
{
    return v > 0.0 ? v < most ? v : most : 0.0;
}

/* On the window's grid of pixels, and no further than the picture's edges. */
static void settle(zoom *z, int width, int height)
{
    const int f = factor_of(z);

    z->left = floor(f * clamp(z->left, width - (double)width / f) + 0.5) / f;
    z->top = floor(f * clamp(z->top, height - (double)height / f) + 0.5) / f;
}

bool zoom_step(zoom *z, double steps, double x, double y, int width, int height)
{
    const int before = factor_of(z);
    double at_x, at_y, whole;
    int level = 0;

    z->rest = modf(z->rest + steps, &whole);
    while (level < FACTORS - 1 && factors[level] < before)
        level++;
    level = (int)clamp(level + whole, FACTORS - 1);
    if (factors[level] == before)
        return false;
    zoom_to_picture(z, x, y, &at_x, &at_y);
    z->factor = factors[level];
    z->left = at_x - x / z->factor;
    z->top = at_y - y / z->factor;
    settle(z, width, height);
    return true;
}

void zoom_pan(zoom *z, double right, double down, int width, int height)
{
    z->left -= right / factor_of(z);
    z->top -= down / factor_of(z);
    settle(z, width, height);
}

void zoom_fit(zoom *z, int width, int height)
{
    settle(z, width, height);
}

void zoom_to_picture(const zoom *z, double x, double y, double *picture_x, double *picture_y)
{
    *picture_x = z->left + x / factor_of(z);
    *picture_y = z->top + y / factor_of(z);
}

void zoom_to_window(const zoom *z, double picture_x, double picture_y, double *x, double *y)
{
    *x = (picture_x - z->left) * factor_of(z);
    *y = (picture_y - z->top) * factor_of(z);
}
