#include "shade/brdf.h"

#include "base/lane_mask.h"
#include "base/simd.h"
#include "shade/film.h"
#include "shade/highlight.h"
#include "shade/layered.h"
#include "shade/stack.h"

static inline void set_lane(light_sample *s, const geometry *g, const vec_lanes *normal, bool shines, uint32_t i, pov_vec3 unit)
{
    lanes_put(&s->unit, i, unit);
    s->cosine[i] = pov_dot(lanes_at(normal, i), unit);
    if (shines)
        s->specular_cos[i] = pov_dot(lanes_at(&g->reflected, i), unit);
}

/* Properties of the directions: some squared length is out of range; some cosine is too small for
 * world_origin_reflect(). */
enum { ODD_DIR = 1, GRAZING = 2 };

static inline int find_cosines(light_sample *restrict s, const geometry *restrict g, const vec_lanes *restrict normal,
                               const vec_lanes *restrict dir, bool shines, uint32_t n)
{
    int64_t plain = -1, steep = -1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 unit;

        plain &= geometry_unit(dir->x[i], dir->y[i], dir->z[i], &unit);
        set_lane(s, g, normal, shines, i, unit);
        steep &= fabs(s->cosine[i]) > WORLD_GRAZING ? -1 : 0;
    }
    return (plain ? 0 : ODD_DIR) | (steep ? 0 : GRAZING);
}

SIMD_CLONES static int find_plain(light_sample *restrict s, const geometry *restrict g, const vec_lanes *restrict normal,
                                  const vec_lanes *restrict dir, uint32_t n)
{
    return find_cosines(s, g, normal, dir, true, n);
}

SIMD_CLONES static int find_matt(light_sample *restrict s, const geometry *restrict g, const vec_lanes *restrict normal,
                                 const vec_lanes *restrict dir, uint32_t n)
{
    return find_cosines(s, g, normal, dir, false, n);
}

bool brdf_cosines(light_sample *s, const geometry *g, const vec_lanes *dir, bool shines, uint32_t n)
{
    const int found = shines ? find_plain(s, g, g->shading, dir, n) : find_matt(s, g, g->shading, dir, n);

    if (found & ODD_DIR)
        for (uint32_t i = 0; i < n; i++)
            set_lane(s, g, g->shading, shines, i, pov_unit(lanes_at(dir, i)));
    return found != 0;
}

/* Reflected fraction of white light towards the ray's start, with a highlight; own, diffuse_weight: those
 * of the lane. */
static colour brdf(const model *m, const appearance *of, colour own, float diffuse_weight, double cosine, double specular_cos)
{
    const colour diffuse = colour_scale(own, diffuse_weight * (float)cosine);
    const float strength = of->finish->phong * highlight_power(specular_cos, of);

    return colour_add(diffuse, colour_scale(highlight_colour(m, of, cosine), strength));
}

static inline float lesser(float a, float b) { return a < b ? a : b; }

/* Of highlights: none has any, all are of one power, or powers vary. */
enum { HIGHLIGHTS_NONE, HIGHLIGHTS_ALIKE, HIGHLIGHTS_VARYING };

/* Reflected light of all lanes, bit for bit as above where there is a highlight. A highlight that is lost in the sum is
 * left out: all components of the sum are then at least APPEARANCE_VISIBLE. It is not computed either, because denormal
 * floats take a processor a hundred times as long. False: some lanes are left to the general function. */
static inline bool brdf_lanes(light_sample *restrict s, const finishes *restrict f, const light_lanes *restrict in,
                              uint32_t n, bool uniform, int highlights)
{
    const colour color = in->color;
    const int64_t power = f->alike;
    uint32_t odd = 0;

    for (uint32_t i = 0; i < n; i++) {
        const double cosine = s->cosine[i], specular_cos = s->specular_cos[i];
        const float slice = f->diffuse_weight[i] * (float)cosine;
        const float red = f->red[i] * slice, green = f->green[i] * slice, blue = f->blue[i] * slice;
        const float least = lesser(fabsf(red), lesser(fabsf(green), fabsf(blue)));
        const bool shines = highlights && (cosine > 0.0) & (specular_cos > 0.0) & !((specular_cos <= f->highlight_cutoff[i]) & (least >= APPEARANCE_VISIBLE));
        const double product = highlight_product(shines ? specular_cos : 0.0, highlights == HIGHLIGHTS_ALIKE ? power : f->power[i], highlights == HIGHLIGHTS_ALIKE);
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

SIMD_CLONES static bool brdf_matt(light_sample *restrict s, const finishes *restrict f, const light_lanes *restrict in,
                                  uint32_t n)
{
    return brdf_lanes(s, f, in, n, true, HIGHLIGHTS_NONE);
}

SIMD_CLONES static bool brdf_matt_varying(light_sample *restrict s, const finishes *restrict f, const light_lanes *restrict in,
                                          uint32_t n)
{
    return brdf_lanes(s, f, in, n, false, HIGHLIGHTS_NONE);
}

SIMD_CLONES static bool brdf_alike(light_sample *restrict s, const finishes *restrict f, const light_lanes *restrict in,
                                   uint32_t n)
{
    return brdf_lanes(s, f, in, n, true, HIGHLIGHTS_ALIKE);
}

SIMD_CLONES static bool brdf_uniform(light_sample *restrict s, const finishes *restrict f, const light_lanes *restrict in,
                                     uint32_t n)
{
    return brdf_lanes(s, f, in, n, true, HIGHLIGHTS_VARYING);
}

SIMD_CLONES static bool brdf_varying(light_sample *restrict s, const finishes *restrict f, const light_lanes *restrict in,
                                     uint32_t n)
{
    return brdf_lanes(s, f, in, n, false, HIGHLIGHTS_VARYING);
}

static bool brdf_plain(light_sample *s, const finishes *f, const light_lanes *in, uint32_t n)
{
    if (!f->has_phong)
        return in->uniform ? brdf_matt(s, f, in, n) : brdf_matt_varying(s, f, in, n);
    if (!in->uniform)
        return brdf_varying(s, f, in, n);
    return f->alike > 0 ? brdf_alike(s, f, in, n) : brdf_uniform(s, f, in, n);
}

static inline colour incident_at(const light_lanes *in, uint32_t i)
{
    return in->uniform ? in->color : colour_of(in->red[i], in->green[i], in->blue[i]);
}

void brdf_reflect(const finishes *f, const model *m, light_sample *s, const light_lanes *in, bool glossy, uint32_t n)
{
    if (f->kinds || !glossy) {
        brdf_reflect_rich(f, m, s, in, glossy, n);
        return;
    }
    if (brdf_plain(s, f, in, n))
        return;
    for (uint32_t k = 0; k < f->count; k++) {
        const uint32_t i = f->lit[k];
        const colour own = colour_of(f->red[i], f->green[i], f->blue[i]);
        colour c;

        if (!s->odd[i])
            continue;
        c = colour_mul(incident_at(in, i), brdf(m, stack_level(f->on->at[i].appearance, f->level), own, f->diffuse_weight[i], s->cosine[i],
                                                s->specular_cos[i]));
        s->red[i] = c.r;
        s->green[i] = c.g;
        s->blue[i] = c.b;
        s->contributes[i] = s->front[i] & !colour_is_black(c);
    }
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

static int64_t whole_of(double power, double most)
{
    return power >= 1.0 && power <= most && power == floor(power) ? (int64_t)power : 0;
}

/* kinds: what some surface has; the rest is not asked for. */
static void set_rich(rich_finishes *r, uint32_t i, const appearance *a, uint32_t kinds)
{
    const finish *f = a->finish;
    const bool both = a->material->double_illuminate;

    r->back_weight[i] = both ? a->diffuse_weight : a->opacity * f->diffuse_back;
    r->both_sides[i] = both ? 1.0f : 0.0f;
    r->phong[i] = f->phong;
    r->phong_size[i] = (double)f->phong_size;
    r->brilliance[i] = f->brilliance;
    r->course[i] = whole_of(f->brilliance, 63.0);
    if (kinds & FINISH_SPECULAR) {
        r->specular[i] = f->specular;
        r->sharpness[i] = 1.0 / f->roughness;
        r->whole[i] = whole_of(r->sharpness[i], APPEARANCE_POWER_LANES);
    }
    if (kinds & FINISH_METAL)
        r->metallic[i] = f->metallic;
    if (kinds & FINISH_IRID)
        r->irid[i] = f->irid.amount;
    if (kinds & FINISH_CRAND)
        r->crand[i] = f->crand;
}

/* Is it known how thick the films of the lit surfaces are, as these mirror light? */
static bool are_filmed(const finishes *f)
{
    bool known = true;

    for (uint32_t k = 0; k < f->count; k++) {
        const appearance *a = f->on->at[f->lit[k]].appearance;

        known &= f->on->filmed >> f->lit[k] & 1 && stack_level(a, f->level)->finish == a->finish;
    }
    return known;
}

static void set_films(finishes *f, const model *m)
{
    films all;

    if (are_filmed(f)) {
        for (uint32_t k = 0; k < f->count; k++)
            f->rich.thickness[f->lit[k]] = f->on->film[f->lit[k]];
        return;
    }
    all.count = 0;
    for (uint32_t k = 0; k < f->count; k++)
        films_add(&all, stack_level(f->on->at[f->lit[k]].appearance, f->level)->finish, lanes_at(&f->on->geometry.to.point, f->lit[k]));
    films_find(&all, m);
    for (uint32_t k = 0; k < f->count; k++)
        f->rich.thickness[f->lit[k]] = all.of[k]->irid.amount != 0.0f ? all.thickness[k] : 0.0;
}

/* What all surfaces look like, where that is the same constant appearance that has no film; or NULL. */
static const appearance *common(const surfaces *on, uint32_t level)
{
    const appearance *first = on->count > 0 ? on->at[0].appearance : NULL, *a = first ? stack_level(first, level) : NULL;

    return a && on->alike && a->lasts && !(a->kinds & FINISH_IRID) ? a : NULL;
}

static int64_t alike(int64_t some, int64_t all) { return some == all && some < 64 ? some : 0; }

/* Batches of one appearance often follow one another: then lanes are as they were. name: what of the scene they are held as, or NULL. */
static void begin_common(finishes *f, const surfaces *on, const appearance *a, const appearance *name)
{
    f->count = a->lit ? on->count : 0;
    for (uint32_t k = 0; k < f->count; k++)
        f->lit[k] = (uint8_t)k;
    f->kinds = f->count > 0 ? a->kinds : 0;
    f->alike = f->count > 0 ? alike(a->power, a->power) : 0;
    f->has_phong = f->count > 0 && a->finish->phong != 0.0f;
    if (f->held != name || !name)
        f->held_count = 0;
    f->held = name;
    for (uint32_t i = f->held_count; i < f->count; i++) {
        set_finish(f, i, a);
        if (a->kinds)
            set_rich(&f->rich, i, a, a->kinds);
    }
    f->held_count = f->count > f->held_count ? f->count : f->held_count;
}

static void take_pigments(finishes *f, const colour_lanes *of)
{
    memcpy(f->red, of->red, sizeof f->red);
    memcpy(f->green, of->green, sizeof f->green);
    memcpy(f->blue, of->blue, sizeof f->blue);
}

/* Surfaces of one appearance but for their pigments. All else is that of the finish, unless layers made it, or the material adds to it. */
static void begin_coloured(finishes *f, const surfaces *on)
{
    const appearance *a = on->at[0].appearance;

    begin_common(f, on, a, a == on->coloured || a->material->double_illuminate ? NULL : on->coloured);
    take_pigments(f, &on->pigment);
}

/* Layers of one finish that differ by their pigments. Only layers are held by that name. */
static void begin_layered(finishes *f, const surfaces *on, uint32_t level)
{
    const layer_lanes *of = &on->layered[level];

    begin_common(f, on, stack_level(on->at[0].appearance, level), of->of);
    take_pigments(f, &of->pigment);
    memcpy(f->diffuse_weight, of->diffuse_weight, sizeof f->diffuse_weight);
    if (f->count > 0)
        f->count = lane_mask_list(of->seen, f->lit);
    if (f->count > 0)
        return;
    f->kinds = 0;
    f->alike = 0;
    f->has_phong = false;
}

void brdf_begin(finishes *f, const model *m, const surfaces *on, uint32_t level)
{
    const appearance *same = common(on, level);
    uint32_t count = 0, kinds = 0;
    int64_t some = 0, all = -1;

    f->on = on;
    f->level = level;
    if (on->coloured) {
        begin_coloured(f, on);
        return;
    }
    if (on->layered) {
        begin_layered(f, on, level);
        return;
    }
    if (same) {
        begin_common(f, on, same, same);
        return;
    }
    f->held = NULL;
    f->has_phong = false;
    for (uint32_t i = 0; i < on->count; i++) {
        const appearance *a = stack_level(on->at[i].appearance, level);

        if (!a || !a->lit)
            continue;
        f->lit[count++] = (uint8_t)i;
        set_finish(f, i, a);
        kinds |= a->kinds;
        f->has_phong |= a->finish->phong != 0.0f;
        some |= f->power[i];
        all &= f->power[i];
    }
    f->alike = alike(some, all);
    f->count = count;
    f->kinds = kinds;
    for (uint32_t k = 0; kinds && k < count; k++)
        set_rich(&f->rich, f->lit[k], stack_level(on->at[f->lit[k]].appearance, level), kinds);
    if (kinds & FINISH_IRID)
        set_films(f, m);
}
