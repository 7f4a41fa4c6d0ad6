#include "shade/highlight.h"

/* A rational fit of metal's loss of colour towards grazing light, by the angle of incidence as a fraction of 90
 * degrees. */
static double fresnel(double cosine)
{
    const double half_pi = 1.57079632679489661923;
    double x = acos(fmin(1.0, fmax(0.0, cosine))) / half_pi - 1.12;

    return fmin(1.0, fmax(0.0, 0.014567225 / (x * x) - 0.011612903));
}

colour highlight_metal(const model *m, const appearance *of, double cosine)
{
    float metallic = of->material->finish.metallic;
    colour c = of->pigment;

    if (m->fresnel_metallic)
        metallic *= (float)(1.0 - fresnel(cosine));
    return colour_of(1.0f + metallic * (c.r - 1.0f), 1.0f + metallic * (c.g - 1.0f),
                     1.0f + metallic * (c.b - 1.0f));
}
