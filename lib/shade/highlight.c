#include "shade/highlight.h"

/* Three loops: compilers that know the bounds of a cosine do not vectorise its angle. */
SIMD_CLONES static void find_known(double *restrict value, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = highlight_known(value[i]);
}

SIMD_CLONES static void find_angles(double *restrict value, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = elementary_acos(value[i]);
}

SIMD_CLONES static void find_losses(double *restrict value, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = highlight_fresnel_loss(value[i]);
}

void highlight_fresnel_lanes(double *value, uint32_t n)
{
    find_known(value, n);
    find_angles(value, n);
    find_losses(value, n);
}

colour highlight_metal(const model *m, const appearance *of, double cosine)
{
    float metallic = of->finish->metallic;
    colour c = of->pigment;

    if (m->fresnel_metallic)
        metallic *= (float)(1.0 - highlight_fresnel(cosine));
    return colour_of(1.0f + metallic * (c.r - 1.0f), 1.0f + metallic * (c.g - 1.0f),
                     1.0f + metallic * (c.b - 1.0f));
}
