#include "media/phase.h"

/* Coefficients as POV-Ray's pictures show them. */
static const double haze = 0.57666, murk = 0.49574, rayleigh = 0.79940;

static double eighth_power(double x)
{
    const double square = x * x, fourth = square * square;

    return fourth * fourth;
}

static double henyey(double g, double cosine)
{
    const double t = 1.0 + g * g - 2.0 * g * cosine;

    return t > 0.0 ? (1.0 - g * g) / (t * sqrt(t)) : 0.0;
}

double media_phase(const medium *m, double cosine)
{
    const double forward = 0.5 * (1.0 + cosine);
    double power;

    switch (m->type) {
    case SCATTER_HAZE:
        return haze * (1.0 + 9.0 * eighth_power(forward));
    case SCATTER_MURK:
        power = eighth_power(forward);
        power *= power;
        return murk * (1.0 + 50.0 * power * power);
    case SCATTER_RAYLEIGH:
        return rayleigh * (1.0 + cosine * cosine);
    case SCATTER_HENYEY:
        return henyey((double)m->eccentricity, cosine);
    default:
        return 1.0;
    }
}
