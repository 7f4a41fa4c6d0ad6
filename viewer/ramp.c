#include "ramp.h"

static const double stops[][3] = {
    { 12.0, 10.0, 40.0 }, { 72.0, 32.0, 125.0 }, { 190.0, 55.0, 95.0 }, { 245.0, 150.0, 35.0 }, { 255.0, 250.0, 195.0 },
};
enum { STOPS = sizeof stops / sizeof stops[0] };

void ramp_color(double t, uint8_t *rgba)
{
    double place = (t < 1.0 ? t : 1.0) * (STOPS - 1);
    int below = place < STOPS - 1 ? (int)place : STOPS - 2;

    rgba[3] = 255;
    if (!(t >= 0.0)) {
        rgba[0] = rgba[1] = rgba[2] = 60;
        return;
    }
    for (int c = 0; c < 3; c++)
        rgba[c] = (uint8_t)(stops[below][c] + (place - below) * (stops[below + 1][c] - stops[below][c]) + 0.5);
}
