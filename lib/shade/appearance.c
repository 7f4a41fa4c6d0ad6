#include "shade/appearance.h"

/* The part of ambient and diffuse light that a surface which lets light through still gives. Negative where filter
 * and transmit are more than 1 together, as in POV-Ray. */
static float opacity_of(const model *m, const material *of)
{
    float filter = of->filter;

    if (m->opacity_uses_filter_colour)
        filter *= fmaxf(of->pigment.r, fmaxf(of->pigment.g, of->pigment.b));
    return 1.0f - filter - of->transmit;
}

static bool is_share(float x) { return x >= 0.0f && x <= 1.0f; }

/* A sum of APPEARANCE_VISIBLE or more stays itself when less than half of 2^-32 is added to it, the distance of floats just
 * below. The highlight is phong cosine^size times at most 1; solved for the cosine with one more factor of 2 for all
 * roundings. */
static double cutoff_of(const material *of)
{
    const float largest_size = 0x1p20f;
    const colour c = of->pigment;

    if (!(of->phong > 0.0f && of->phong_size > 0.0f && of->phong_size < largest_size))
        return 0.0;
    if (of->metallic != 0.0f && !(is_share(of->metallic) && is_share(c.r) && is_share(c.g) && is_share(c.b)))
        return 0.0;
    return pow(0x1p-34 / (double)of->phong, 1.0 / (double)of->phong_size);
}

static uint32_t power_of(const material *of)
{
    const float size = of->phong_size;

    return size >= 1.0f && size <= (float)APPEARANCE_POWER_MAX && size == floorf(size) ? (uint32_t)size : 0;
}

static float phong_of(const plan *p, const material *of)
{
    const uint32_t power = power_of(of);

    if (!p->highlights || of->phong == 0.0f)
        return 0.0f;
    return power > 0 && power <= APPEARANCE_POWER_LANES && of->metallic == 0.0f ? of->phong : NAN;
}

void appearance_make(appearance *out, const plan *p, const model *m, const material *of)
{
    const float opacity = opacity_of(m, of);

    out->lit = p->lighting && (of->diffuse != 0.0f || of->phong != 0.0f);
    out->reflective = p->reflection && !colour_is_black(of->reflection);
    out->transmissive = p->transmission && material_is_transparent(of);
    out->phong = phong_of(p, of);
    out->highlight_cutoff = out->phong == 0.0f ? 0.0 : cutoff_of(of);
    out->power = power_of(of);
    out->pigment = of->pigment;
    out->diffuse_weight = opacity * of->diffuse;
    out->emitted = colour_mul(colour_scale(colour_mul(of->ambient, of->pigment), opacity), m->ambient_light);
    out->reflection = coefficient_of(of->reflection);
    out->filter = coefficient_of(material_filter(of));
    out->material = of;
}
