#include "shade/coloured.h"

#include "base/simd.h"

/* Is what surfaces of this finish reflect as a mirror, or give to others, the same whatever the pigment? */
static bool is_coloured(const plan *p, const appearance *of)
{
    return !of->angular && !of->gathers && !p->photons && !p->subsurface && of->finish->metallic == 0.0f;
}

/* False: light goes through some pigment. */
static bool put_colours(const pigment *value, uint32_t n, colour_lanes *out)
{
    bool opaque = true;

    for (uint32_t i = 0; i < n; i++) {
        colour_lane_put(out, i, value[i].color);
        opaque &= (value[i].filter == 0.0f) & (value[i].transmit == 0.0f);
    }
    return opaque;
}

/* As appearance_repaint_plain(). */
SIMD_CLONES static void find_emitted(colour ambient, colour ambient_light, colour emission, uint32_t n, const colour_lanes *restrict of,
                                     colour_lanes *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        out->red[i] = ambient.r * of->red[i] * ambient_light.r + emission.r * of->red[i];
        out->green[i] = ambient.g * of->green[i] * ambient_light.g + emission.g * of->green[i];
        out->blue[i] = ambient.b * of->blue[i] * ambient_light.b + emission.b * of->blue[i];
    }
}

void coloured_set(surfaces *s, const appearance *of)
{
    for (uint32_t i = 0; i < s->count; i++)
        s->at[i].appearance = &s->varying[0];
    s->coloured = of;
}

bool coloured_put(const shading *scene, const appearance *of, const pigment *value, surfaces *s)
{
    const material *own = s->at[0].appearance->material;
    const finish *f = of->finish;
    appearance *out = &s->varying[0];

    if (!is_coloured(scene->plan, of) || !put_colours(value, s->count, &s->pigment))
        return false;
    *out = *of;
    appearance_set_material(out, own);
    appearance_repaint_plain(out, scene->model, value);
    find_emitted(f->ambient, scene->model->ambient_light, f->emission, lanes_whole(s->count), &s->pigment, &s->emitted);
    coloured_set(s, of);
    return true;
}
