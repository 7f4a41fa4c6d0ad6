#include "shade/reflectance.h"

#include "shade/fade.h"
#include "shade/film.h"
#include "shade/highlight.h"

double reflectance_fresnel(double cosine, double ratio)
{
    const double squared = ratio * ratio - (1.0 - cosine * cosine);
    double ahead, across, along;

    if (ratio == 1.0)
        return 0.0;
    if (!(squared > 0.0))
        return 1.0;
    ahead = sqrt(squared);
    across = (cosine - ahead) / (cosine + ahead);
    along = (ratio * ratio * cosine - ahead) / (ratio * ratio * cosine + ahead);
    return 0.5 * (across * across + along * along);
}

/* A cosine below 0 is of a normal that is bent beyond the horizon: as in POV-Ray Fresnel's reflection is whole there. */
static double course(const reflection *r, double cosine, double ratio)
{
    const double away = 1.0 - cosine;

    if (r->fresnel)
        return cosine < 0.0 ? 1.0 : reflectance_fresnel(cosine, ratio);
    return r->falloff == 1.0f ? away : elementary_pow(away > 0.0 ? away : 0.0, (double)r->falloff);
}

static inline float mix(float a, float b, float share) { return a + (b - a) * share; }

static colour mixed(colour a, colour b, float share)
{
    return colour_of(mix(a.r, b.r, share), mix(a.g, b.g, share), mix(a.b, b.b, share));
}

colour reflectance_of(const model *m, const finish *f, colour c, double cosine, double ratio)
{
    const reflection *r = &f->reflection;
    colour by = r->min;

    if (!colour_equal(r->min, r->max))
        by = mixed(r->min, r->max, (float)course(r, cosine, ratio));
    if (r->metallic != 0.0f) {
        const float share = r->metallic * (m->fresnel_metallic ? (float)(1.0 - highlight_fresnel(cosine)) : 1.0f);

        by = colour_mul(by, mixed(colour_of(1.0f, 1.0f, 1.0f), c, share));
    }
    return by;
}

/* The ior of the object over that of the dielectric entered last, and the inverse where the ray leaves the only one. That
 * is the ior ahead over that behind but for a ray that leaves one dielectric within another: POV-Ray sees none of
 * Fresnel's reflection there. */
static double ratio_at(const shade_context *c, const surface *s)
{
    const shading *scene = c->scene;
    const dielectric_span in = s->from->inside;
    const uint32_t object = shading_solid(scene, s->at->object);
    const double own = dielectric_ior(dielectric_interior(scene->model, object), s->from->hue);
    dielectric_crossing crossing;

    dielectric_cross(&c->dielectrics, in, scene->model, object, s->from->hue, &crossing);
    return in.count == 1 && crossing.index == 0 ? 1.0 / own : own / crossing.before;
}

static void set(const shade_context *c, appearance *a, const surface *s, const geometry *g, uint32_t lane)
{
    const finish *f = a->finish;
    const double ratio = f->reflection.fresnel ? ratio_at(c, s) : 1.0;
    const colour by = reflectance_of(c->scene->model, f, a->pigment, g->cosine[lane], ratio);

    a->reflection = coefficient_of(by);
    if (f->conserve_energy)
        appearance_set_filter(a, c->scene->model, colour_mul(a->filter.by, colour_of(1.0f - by.r, 1.0f - by.g, 1.0f - by.b)));
    if (f->irid.amount != 0.0f && !a->powered)
        a->reflection.by = colour_mul(by, film_mirrored(c->scene->model, f, geometry_cosines(g, lane), lanes_at(&g->to.point, lane)));
}

/* The surface's appearance, to be changed. */
static appearance *own_of(surfaces *s, uint32_t i)
{
    appearance *own = &s->varying[i];

    if (s->at[i].appearance != own)
        *own = *s->at[i].appearance;
    s->at[i].appearance = own;
    return own;
}

/* What light loses on its way does not count in the weight of a ray, as POV-Ray has it: it is a factor of its own. */
static void fade(const shade_context *c, surface *at)
{
    at->faded = colour_of(1.0f, 1.0f, 1.0f);
    if (c->scene->plan->fading && !at->appearance->clear)
        fade_inside(c, at->from, at->ray, at->at, &at->faded);
}

void reflectance_set(const shade_context *c, surfaces *s)
{
    for (uint32_t i = 0; i < s->count; i++) {
        surface *at = &s->at[i];
        appearance *own;

        fade(c, at);
        if (!at->appearance->angular)
            continue;
        own = own_of(s, i);
        set(c, own, at, &s->geometry, i);
        appearance_set_filter(own, c->scene->model, colour_scale(own->filter.by, own->finish->refraction));
    }
}

void reflectance_set_layers(const shade_context *c, surfaces *s)
{
    for (uint32_t i = 0; i < s->count; i++) {
        fade(c, &s->at[i]);
        if (s->at[i].appearance->angular)
            set(c, own_of(s, i), &s->at[i], &s->geometry, i);
    }
}
