#include "shade/albedo.h"

#include "shade/paint.h"

/* The sum over stacks of layers, each from its top to its last, which counts for all that is left. */
static colour sum_of(const texture_term *terms, uint32_t count)
{
    colour sum = colour_of(0.0f, 0.0f, 0.0f);
    float left = 1.0f;

    for (uint32_t i = 0; i < count; i++) {
        const texture_term *t = &terms[i];
        const bool is_last = i + 1 == count || terms[i + 1].first;
        const float seen = pov_minf(pov_maxf(1.0f - t->pigment.filter - t->pigment.transmit, 0.0f), 1.0f);

        left = t->first ? 1.0f : left;
        sum = colour_add(sum, colour_scale(t->pigment.color, t->share * left * (is_last ? 1.0f : seen)));
        left *= 1.0f - seen;
    }
    return sum;
}

colour albedo_of(pov_tracer *t, const pov_ray *ray, const hit *h)
{
    const shading *scene = t->context.scene;
    const appearance *constant = shading_constant(scene, h->object);

    if (!constant->varies)
        return constant->material->pigment;
    return sum_of(t->painted.terms, paint_hit(scene, ray, h, t->painted.terms));
}
