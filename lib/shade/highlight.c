#include "shade/highlight.h"

colour highlight_metal(const model *m, const appearance *of, double cosine)
{
    float metallic = of->finish->metallic;
    colour c = of->pigment;

    if (m->fresnel_metallic)
        metallic *= (float)(1.0 - highlight_fresnel(cosine));
    return colour_of(1.0f + metallic * (c.r - 1.0f), 1.0f + metallic * (c.g - 1.0f),
                     1.0f + metallic * (c.b - 1.0f));
}
