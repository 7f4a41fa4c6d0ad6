#include "shade/lighting.h"

#include "base/simd.h"
#include "shade/highlight.h"
#include "shade/transmittance.h"

/* One sample of a light source for each surface, by lane. */
typedef struct light_sample {
    double cosine[BATCH_MAX];    /* between the direction to it and the shading normal */
    double specular_cos[BATCH_MAX];   /* ... and the mirrored ray */
    float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX];   /* reflected light if the source is not occluded */
    uint32_t odd[BATCH_MAX];     /* 1: not computed yet */
    uint32_t front[BATCH_MAX], contributes[BATCH_MAX];   /* 1: the light is in front; and the reflected light is not
                                                          * zero */
} light_sample;

static inline void set_cosines(light_sample *s, const geometry *g, const vec_lanes *normal, uint32_t i, pov_vec3 unit)
{
    s->cosine[i] = pov_dot(lanes_at(normal, i), unit);
    s->specular_cos[i] = pov_dot(lanes_at(&g->reflected, i), unit);
}

/* Properties of the directions: some squared length is out of range; some cosine is too small for
 * world_origin_reflect(). */
enum { ODD_DIR = 1, GRAZING = 2 };

SIMD_CLONES static int find_plain(light_sample *restrict s, const geometry *restrict g, const vec_lanes *restrict normal,
                                  const vec_lanes *restrict dir, uint32_t n)
{
    int64_t plain = -1, steep = -1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 unit;

        plain &= geometry_unit(dir->x[i], dir->y[i], dir->z[i], &unit);
        set_cosines(s, g, normal, i, unit);
        steep &= fabs(s->cosine[i]) > WORLD_GRAZING ? -1 : 0;
    }
    return (plain ? 0 : ODD_DIR) | (steep ? 0 : GRAZING);
}

/* True: there may be a cosine too small for world_origin_reflect(). */
static bool find_cosines(light_sample *s, const geometry *g, const vec_lanes *dir, uint32_t n)
{
    const int found = find_plain(s, g, g->shading, dir, n);

    if (found & ODD_DIR)
        for (uint32_t i = 0; i < n; i++)
            set_cosines(s, g, g->shading, i, pov_unit(lanes_at(dir, i)));
    return found != 0;
}

/* Reflected fraction of white light towards the ray's start, with a highlight. */
static colour brdf(const model *m, const appearance *of, double cosine, double specular_cos)
{
    const colour diffuse = colour_scale(of->pigment, of->diffuse_weight * (float)cosine);
    const float strength = of->material->phong * highlight_power(specular_cos, of);

    return colour_add(diffuse, colour_scale(highlight_colour(m, of, cosine), strength));
}

static inline float lesser(float a, float b) { return a < b ? a : b; }

/* Reflected light of all lanes, bit for bit as above where there is a highlight. A highlight that is lost in the sum is
 * left out: all components of the sum are then at least APPEARANCE_VISIBLE. It is not computed either, because denormal
 * floats take a processor a hundred times as long. False: some lanes are left to the general function. */
static inline bool brdf_lanes(light_sample *restrict s, const finishes *restrict f, const light_lanes *restrict in,
                              uint32_t n, bool uniform)
{
    const colour color = in->color;
    uint32_t odd = 0;

    for (uint32_t i = 0; i < n; i++) {
        const double cosine = s->cosine[i], specular_cos = s->specular_cos[i];
        const float slice = f->diffuse_weight[i] * (float)cosine;
        const float red = f->red[i] * slice, green = f->green[i] * slice, blue = f->blue[i] * slice;
        const float least = lesser(fabsf(red), lesser(fabsf(green), fabsf(blue)));
        const bool shines = (cosine > 0.0) & (specular_cos > 0.0) & !((specular_cos <= f->highlight_cutoff[i]) & (least >= APPEARANCE_VISIBLE));
        const double product = highlight_product(shines ? specular_cos : 0.0, f->power[i]);
        const float lo = f->phong[i] * highlight_lo(product), hi = f->phong[i] * highlight_hi(product);
        const float strength = shines ? lo : 0.0f;

        s->odd[i] = shines & !(lo == hi);
        odd |= s->odd[i];
        s->red[i] = (uniform ? color.r : in->red[i]) * (red + strength);
        s->green[i] = (uniform ? color.g : in->green[i]) * (green + strength);
        s->blue[i] = (uniform ? color.b : in->blue[i]) * (blue + strength);
        s->front[i] = cosine > 0.0;
        s->contributes[i] = (cosine > 0.0) & !colour_is_black(colour_of(s->red[i], s->green[i], s->blue[i]));
    }
    return !odd;
}

SIMD_CLONES static bool brdf_uniform(light_sample *restrict s, const finishes *restrict f, const light_lanes *restrict in,
                                     uint32_t n)
{
    return brdf_lanes(s, f, in, n, true);
}

SIMD_CLONES static bool brdf_varying(light_sample *restrict s, const finishes *restrict f, const light_lanes *restrict in,
                                     uint32_t n)
{
    return brdf_lanes(s, f, in, n, false);
}

static inline colour incident_at(const light_lanes *in, uint32_t i)
{
    return in->uniform ? in->color : colour_of(in->red[i], in->green[i], in->blue[i]);
}

static void brdf_all(const lighting *l, light_sample *s, const light_lanes *in, uint32_t n)
{
    const model *m = l->context->scene->model;

    if (in->uniform ? brdf_uniform(s, &l->finishes, in, n) : brdf_varying(s, &l->finishes, in, n))
        return;
    for (uint32_t k = 0; k < l->lit_count; k++) {
        const uint32_t i = l->lit[k];
        colour c;

        if (!s->odd[i])
            continue;
        c = colour_mul(incident_at(in, i), brdf(m, l->on->at[i].appearance, s->cosine[i], s->specular_cos[i]));
        s->red[i] = c.r;
        s->green[i] = c.g;
        s->blue[i] = c.b;
        s->contributes[i] = s->front[i] & !colour_is_black(c);
    }
}

static inline colour contribution_at(const light_sample *s, uint32_t i)
{
    return colour_of(s->red[i], s->green[i], s->blue[i]);
}

/* Collect rays from lit surfaces that face the light and reflect any of it, without unpredictable branches. Returns the
 * number of surfaces that face the light. */
static uint32_t aim(lighting *l, const light_sample *s, const vec_lanes *dir)
{
    pov_ray *const own = l->own;
    const size_t lit_count = l->lit_count;
    uint32_t front = 0;
    size_t count = 0;

    for (size_t k = 0; k < lit_count; k++) {
        const size_t i = l->lit[k];

        own[i].dir = lanes_at(dir, (uint32_t)i);
        l->rays[count] = &own[i];
        l->of[count] = (uint8_t)i;
        front += s->front[i];
        count += s->contributes[i];
    }
    l->count = (uint32_t)count;
    return front;
}

static bool any_coincident(const lighting *l)
{
    for (uint32_t i = 0; i < l->count; i++)
        if (l->on->at[l->of[i]].coincident)
            return true;
    return false;
}

/* Rays from coincident surfaces are traced one by one. */
static uint64_t trace_each(const lighting *l, double tmax, colour *through)
{
    const shade_context *c = l->context;
    uint64_t lit = 0;

    for (uint32_t i = 0; i < l->count; i++) {
        const uint32_t at = l->on->at[l->of[i]].coincident;
        const bool is_lit = at ? transmittance_from(c, &c->coincident_sets.items[at - 1], l->rays[i], tmax, &through[i])
                               : transmittance_find(c, &l->rays[i], 1, tmax, &through[i]) != 0;

        lit |= (uint64_t)is_lit << i;
    }
    return lit;
}

/* The rays to one sample of a light source that are not occluded. */
static uint64_t trace(const lighting *l, double tmax, colour *through)
{
    shade_context *c = l->context;

    c->counts.shadow += l->count;
    if (c->coincident_sets.count > 0 && any_coincident(l))
        return trace_each(l, tmax, through);
    return transmittance_find(c, l->rays, l->count, tmax, through);
}

/* Set the origin surfaces of the rays, at these cosines. NULL: none is so small that it matters. */
static void name_origins(lighting *l, const double *cosines)
{
    for (uint32_t k = 0; k < l->lit_count; k++) {
        const uint32_t i = l->lit[k];

        world_origin_reflect(&l->own[i], l->on->at[i].at, cosines ? cosines[i] : 1.0);
    }
}

/* The same where the shading normal does not tell the side of a ray: the geometric one does. */
static void name_sides(lighting *l, const vec_lanes *dir)
{
    for (uint32_t k = 0; k < l->lit_count; k++) {
        const uint32_t i = l->lit[k];
        const double cosine = pov_dot(lanes_at(&l->on->geometry.to.normal, i), pov_unit(lanes_at(dir, i)));

        if (cosine < 0.0)
            world_origin_transmit(&l->own[i], l->on->at[i].at, -cosine);
        else
            world_origin_reflect(&l->own[i], l->on->at[i].at, cosine);
    }
}

/* The mean transmittance to all samples of a light source; the rays to the first are aimed already. */
static uint64_t trace_samples(lighting *l, const scene_light *from, uint32_t samples, colour *through)
{
    const geometry *g = &l->on->geometry;
    const light_points at = { &g->to.point, &g->to.point_lo, l->on->count };
    const float share = 1.0f / (float)samples;
    uint64_t lit = 0;

    for (uint32_t i = 0; i < l->count; i++)
        through[i] = colour_of(0.0f, 0.0f, 0.0f);
    for (uint32_t k = 0; k < samples; k++) {
        colour some[BATCH_MAX];
        light_lanes in;

        from->class->sample(from->light, k, &at, &in);
        name_sides(l, &in.dir);
        for (uint32_t i = 0; i < l->count; i++)
            l->own[l->of[i]].dir = lanes_at(&in.dir, l->of[i]);
        for (uint64_t some_lit = trace(l, in.tmax, some); some_lit; some_lit &= some_lit - 1) {
            const uint32_t i = first_of64(some_lit);

            through[i] = colour_add(through[i], colour_scale(some[i], share));
            lit |= (uint64_t)1 << i;
        }
    }
    name_origins(l, NULL);
    return lit;
}

static inline void add_light(surface *s, colour given) { s->lit = colour_add(s->lit, given); }

static void add_visible(lighting *l, const scene_light *from, const light_sample *s, double tmax)
{
    const uint32_t samples = from->class->samples(from->light);
    colour through[BATCH_MAX];

    if (!l->context->scene->plan->shadows)
        for (uint32_t i = 0; i < l->count; i++)
            add_light(&l->on->at[l->of[i]], contribution_at(s, l->of[i]));
    else
        for (uint64_t lit = samples == 1 ? trace(l, tmax, through) : trace_samples(l, from, samples, through); lit;
             lit &= lit - 1) {
            const uint32_t i = first_of64(lit);

            add_light(&l->on->at[l->of[i]], colour_mul(contribution_at(s, l->of[i]), through[i]));
        }
}

/* Add the light of one source to the lit surfaces. */
static void add_light_source(lighting *l, const scene_light *from)
{
    shade_context *c = l->context;
    const geometry *g = &l->on->geometry;
    const light_points at = { &g->to.point, &g->to.point_lo, l->on->count };
    const uint32_t n = lanes_whole(at.n);
    uint32_t front;
    light_sample s;
    light_lanes in;
    bool named;

    from->class->sample(from->light, 0, &at, &in);
    named = find_cosines(&s, g, &in.dir, n) || geometry_is_bent(g);
    if (geometry_is_bent(g))
        name_sides(l, &in.dir);
    else if (named)
        name_origins(l, s.cosine);
    brdf_all(l, &s, &in, n);
    front = aim(l, &s, &in.dir);
    c->counts.shadow_behind += l->lit_count - front;
    c->counts.shadow_idle += front - l->count;
    if (l->count > 0)
        add_visible(l, from, &s, in.tmax);
    if (named)
        name_origins(l, NULL);
    c->failed = c->failed || query_context_failed(c->context);
}

static inline void set_finish(finishes *f, uint32_t i, const appearance *a)
{
    f->red[i] = a->pigment.r;
    f->green[i] = a->pigment.g;
    f->blue[i] = a->pigment.b;
    f->diffuse_weight[i] = a->diffuse_weight;
    f->phong[i] = a->phong;
    f->highlight_cutoff[i] = a->highlight_cutoff;
    f->power[i] = a->power;
}

/* Collect the lit surfaces; rays from them start alike for all lights. */
static void begin(lighting *l, shade_context *c, surfaces *on)
{
    uint32_t count = 0;

    l->context = c;
    l->on = on;
    for (uint32_t i = 0; i < on->count; i++) {
        const surface *s = &on->at[i];
        pov_ray *ray = &l->own[i];

        if (!s->appearance->lit)
            continue;
        l->lit[count++] = (uint8_t)i;
        set_finish(&l->finishes, i, s->appearance);
        ray->org = s->at->point;
        ray->org_lo = s->at->point_lo;
        world_origin_reflect(ray, s->at, 1.0);
    }
    l->lit_count = count;
}

void light_gather(lighting *l, shade_context *c, surfaces *on)
{
    const shading *scene = c->scene;

    begin(l, c, on);
    for (size_t k = 0; l->lit_count > 0 && k < scene->light_count; k++) {
        if (c->failed || interrupt_is_due(&c->interrupt, l->lit_count))
            return;
        add_light_source(l, &scene->lights[k]);
    }
}
