#include "shade/layered.h"

#include "base/lane_mask.h"
#include "base/simd.h"
#include "shade/stack.h"
#include "texture/texture.h"

/* From the top. */
static const texture *layer_of(const texture *of, uint32_t k) { return of->textures[of->count - 1 - k]; }

/* Is all that the finish gives but for light of its pigment's colour the same everywhere? */
static bool is_plain(const appearance *of)
{
    return !of->reflective && !of->angular && !(of->kinds & (FINISH_IRID | FINISH_BACK)) && of->finish->metallic == 0.0f;
}

static bool is_opaque(const texture *of) { return of->pigment->most.filter == 0.0f && of->pigment->most.transmit == 0.0f; }

bool layered_takes(const shading *scene, const texture *of, const material *own)
{
    if (!scene->flat_stacks || of->blend != BLEND_LAYERS || of->count < 2 || of->count > STACK_LEVELS)
        return false;
    if (scene->plan->fading || own->double_illuminate || !is_opaque(layer_of(of, of->count - 1)))
        return false;
    for (uint32_t k = 0; k < of->count; k++)
        if (layer_of(of, k)->normal || !is_plain(shading_finish(scene, &layer_of(of, k)->finish)))
            return false;
    return true;
}

/* By lane: a layer's pigments, and what filter takes of the opacity. */
typedef struct SIMD_ALIGNED pigment_lanes { float filter[BATCH_MAX], transmit[BATCH_MAX], covered[BATCH_MAX]; } pigment_lanes;
/* What is left by the layers so far, and whether that is too dark. */
typedef struct SIMD_ALIGNED left_lanes { colour_lanes by; uint32_t dark[BATCH_MAX]; } left_lanes;

/* What all lanes of a layer have in common. */
typedef struct level {
    colour ambient, ambient_light, emission;
    float diffuse, bailout;
    float by_luminance;          /* 1 or 0: loops take conditions that are no numbers for branches */
} level;

static level level_of(const model *m, const finish *f)
{
    const level out = { f->ambient, m->ambient_light, f->emission, f->diffuse, (float)m->adc_bailout, m->opaque_dark_filters ? 1.0f : 0.0f };

    return out;
}

/* False: light goes through some of them. */
static bool put_pigments(const model *m, const pigment *from, uint32_t n, colour_lanes *colours, pigment_lanes *out)
{
    bool opaque = true;

    for (uint32_t i = 0; i < lanes_whole(n); i++) {
        const pigment *const one = &from[i < n ? i : n - 1];

        colour_lane_put(colours, i, one->color);
        out->filter[i] = one->filter;
        out->transmit[i] = one->transmit;
        out->covered[i] = appearance_covered(m, one->color, one->filter);
        opaque &= (one->filter == 0.0f) & (one->transmit == 0.0f);
    }
    return opaque;
}

SIMD_INLINE float emitted_by(float ambient, float ambient_light, float emission, float own, float opacity)
{
    return ambient * own * opacity * ambient_light + emission * own * opacity;
}

/* As appearance_paint() and layer_weigh() have it. What is hidden leaves as much as was left, to other memory, as in merge.c. */
SIMD_CLONES SIMD_NOINLINE static void weigh(const level *at, const pigment_lanes *restrict p, const left_lanes *restrict left, uint32_t n,
                                            layer_lanes *restrict out, left_lanes *restrict to)
{
    const level of = *at;

    for (uint32_t i = 0; i < n; i++) {
        const float r = out->pigment.red[i], g = out->pigment.green[i], b = out->pigment.blue[i], transmit = p->transmit[i];
        const float opacity = 1.0f - p->covered[i] - transmit, red = left->by.red[i], green = left->by.green[i], blue = left->by.blue[i];
        const colour more = { red * (r * p->filter[i] + transmit), green * (g * p->filter[i] + transmit), blue * (b * p->filter[i] + transmit) };
        const bool seen = left->dark[i] == 0;
        const float size = of.by_luminance > 0.0f ? fabsf(colour_luminance(more)) : colour_weight(more);
        const float shines_red = emitted_by(of.ambient.r, of.ambient_light.r, of.emission.r, r, opacity);
        const float shines_green = emitted_by(of.ambient.g, of.ambient_light.g, of.emission.g, g, opacity);
        const float shines_blue = emitted_by(of.ambient.b, of.ambient_light.b, of.emission.b, b, opacity);

        out->diffuse_weight[i] = opacity * of.diffuse;
        out->emitted.red[i] = seen ? shines_red : 0.0f;
        out->emitted.green[i] = seen ? shines_green : 0.0f;
        out->emitted.blue[i] = seen ? shines_blue : 0.0f;
        out->by.red[i] = seen ? red : 0.0f;
        out->by.green[i] = seen ? green : 0.0f;
        out->by.blue[i] = seen ? blue : 0.0f;
        to->by.red[i] = seen ? more.r : red;
        to->by.green[i] = seen ? more.g : green;
        to->by.blue[i] = seen ? more.b : blue;
        to->dark[i] = seen ? (uint32_t)(size < of.bailout) : 1;
    }
}

static void begin(left_lanes *left)
{
    for (uint32_t i = 0; i < BATCH_MAX; i++) {
        left->by.red[i] = left->by.green[i] = left->by.blue[i] = 1.0f;
        left->dark[i] = 0;
    }
}

/* As stack_make_flat() has it of a stack that sends no rays. */
static void set_whole(const texture *of, const layer_lanes *from, surfaces *s, stack *whole)
{
    const material *own = s->at[0].appearance->material;
    appearance *out = &s->varying[0];

    whole->count = of->count;
    whole->weighed = whole->flat = true;
    for (uint32_t k = 0; k < of->count; k++) {
        appearance *one = &whole->layers[k].appearance;

        *one = *from[k].of;
        appearance_set_material(one, own);
    }
    *out = whole->layers[0].appearance;
    out->transmissive = out->fresnel = out->powered = out->clear = false;
    out->stack = whole;
    for (uint32_t i = 0; i < s->count; i++)
        s->at[i].appearance = out;
    s->layered = from;
}

bool layered_put(const shading *scene, const texture *of, const texture_points *points, surfaces *s, stack *whole, layer_lanes *out)
{
    const uint32_t n = lanes_whole(s->count);
    pigment pigments[BATCH_MAX];
    pigment_lanes lanes;
    left_lanes left[2];
    bool opaque = true;

    begin(&left[0]);
    for (uint32_t k = 0; k < of->count; k++) {
        const appearance *finished = shading_finish(scene, &layer_of(of, k)->finish);
        const level at = level_of(scene->model, finished->finish);

        pigment_eval(scene->model, layer_of(of, k)->pigment, points, s->count, pigments);
        opaque = put_pigments(scene->model, pigments, s->count, &out[k].pigment, &lanes);
        out[k].of = finished;
        out[k].seen = lane_mask_all(s->count) & ~lane_mask_of(left[k & 1].dark, s->count);
        weigh(&at, &lanes, &left[k & 1], n, &out[k], &left[~k & 1]);
    }
    if (opaque)
        set_whole(of, out, s, whole);
    return opaque;
}
