#include "base/elementary.h"
#include "base/simd.h"
#include "shade/brdf.h"
#include "shade/highlight.h"

#include <string.h>

/* Parts of the reflected light of white light, by lane. */
typedef struct SIMD_ALIGNED parts {
    float diffuse[BATCH_MAX];    /* factor of the pigment */
    float phong[BATCH_MAX], specular[BATCH_MAX];   /* highlights */
    float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX];   /* ... and their colour */
    double half_cos[BATCH_MAX];  /* between the normal and the direction half path_cos between light and ray */
    double base[BATCH_MAX], raised[BATCH_MAX];
    uint32_t shines[BATCH_MAX], odd[BATCH_MAX];
} parts;

/* ---- whole powers ---- */

SIMD_CLONES static void square(double *restrict x, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        x[i] *= x[i];
}

SIMD_CLONES static void multiply(double *restrict x, const double *restrict by, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        x[i] *= by[i];
}

SIMD_CLONES static void find_products(const double *restrict base, const int64_t *restrict power, uint32_t n, double *restrict out)
{
    for (uint32_t i = 0; i < n; i++)
        out[i] = highlight_product(base[i], power[i], false);
}

/* The same factors for one power of all lanes, and none that are 1. */
static void find_alike(double *base, int64_t power, uint32_t n, double *out)
{
    for (; !(power & 1); power >>= 1)
        square(base, n);
    memcpy(out, base, n * sizeof *out);
    while (power >>= 1) {
        square(base, n);
        if (power & 1)
            multiply(out, base, n);
    }
}

/* Raise the bases, which are lost, by products: see highlight_product(). */
static void raise_whole(parts *p, const finishes *f, const int64_t *power, uint32_t n)
{
    if (f->held && power[0] > 0 && power[0] <= APPEARANCE_POWER_LANES)
        find_alike(p->base, power[0], n, p->raised);
    else
        find_products(p->base, power, n, p->raised);
}

/* ---- diffuse light ---- */

/* What diffuse light from behind surfaces counts, where none of them says more than plain ones. */
static const float no_back[BATCH_MAX];

static inline float diffuse_by(const finishes *f, const float *back, uint32_t i, double cosine)
{
    return cosine > 0.0 ? f->diffuse_weight[i] : back[i];
}

SIMD_CLONES static void diffuse_plain(parts *restrict p, const finishes *restrict f, const float *restrict back, const double *restrict cosines,
                                      uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        p->diffuse[i] = diffuse_by(f, back, i, cosines[i]) * (float)fabs(cosines[i]);
}

SIMD_CLONES static void find_sizes(const double *restrict cosines, uint32_t n, double *restrict out)
{
    for (uint32_t i = 0; i < n; i++)
        out[i] = fabs(cosines[i]);
}

/* The cosine itself, and whole powers of it by their product; `odd` lanes are left. */
SIMD_CLONES static uint32_t take_courses(parts *restrict p, const finishes *restrict f, const double *restrict cosines, uint32_t n)
{
    uint32_t odd = 0;

    for (uint32_t i = 0; i < n; i++) {
        const float lo = highlight_lo(p->raised[i]), hi = highlight_hi(p->raised[i]);

        p->odd[i] = (f->rich.course[i] != 1) & ((f->rich.course[i] == 0) | !(lo == hi));
        odd |= p->odd[i];
        p->diffuse[i] = diffuse_by(f, f->rich.back_weight, i, cosines[i]) * (f->rich.course[i] == 1 ? (float)fabs(cosines[i]) : lo);
    }
    return odd;
}

static uint32_t diffuse_products(parts *p, const finishes *f, const double *cosines, uint32_t n)
{
    find_sizes(cosines, n, p->base);
    raise_whole(p, f, f->rich.course, n);
    return take_courses(p, f, cosines, n);
}

SIMD_CLONES static void diffuse_powers(parts *restrict p, const finishes *restrict f, const double *restrict cosines, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const float course = (float)elementary_pow(fabs(cosines[i]), f->rich.brilliance[i]);

        p->diffuse[i] = p->odd[i] ? diffuse_by(f, f->rich.back_weight, i, cosines[i]) * course : p->diffuse[i];
    }
}

/* A number from 0 to 1 that is as good as random: the bits of the point and of the direction to the light, mixed. */
static float grain(pov_vec3 point, pov_vec3 dir)
{
    const double numbers[6] = { point.x, point.y, point.z, dir.x, dir.y, dir.z };
    uint64_t bits = 0;

    for (int i = 0; i < 6; i++) {
        bits = (bits ^ elementary_bits(numbers[i])) * 0x9E3779B97F4A7C15u;
        bits ^= bits >> 32;
    }
    return (float)(bits >> 40) * 0x1p-24f;
}

/* Grains take light away, whatever its angle. */
static void take_grains(parts *p, const finishes *f, const vec_lanes *dir)
{
    for (uint32_t k = 0; k < f->count; k++) {
        const uint32_t i = f->lit[k];

        if (f->rich.crand[i] != 0.0f)
            p->diffuse[i] -= f->rich.crand[i] * grain(lanes_at(&f->on->geometry.to.point, i), lanes_at(dir, i));
    }
}

static void diffuse(parts *p, const finishes *f, const float *back, const light_sample *s, const vec_lanes *dir, uint32_t n)
{
    if (!(f->kinds & FINISH_BRILLIANCE))
        diffuse_plain(p, f, back, s->cosine, n);
    else if (diffuse_products(p, f, s->cosine, n))
        diffuse_powers(p, f, s->cosine, n);
    if (f->kinds & FINISH_CRAND)
        take_grains(p, f, dir);
}

/* ---- highlights ---- */

static inline bool is_lit_side(const rich_finishes *r, uint32_t i, double cosine)
{
    return (cosine > 0.0) | ((r->both_sides[i] != 0.0f) & (cosine < 0.0));
}

static inline float least_of(float a, float b) { return a < b ? a : b; }

/* As in brdf.c. */
SIMD_CLONES static void find_shining(parts *restrict p, const finishes *restrict f, const light_sample *restrict s, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const double cosine = s->specular_cos[i];
        const float d = p->diffuse[i], least = least_of(fabsf(f->red[i] * d), least_of(fabsf(f->green[i] * d), fabsf(f->blue[i] * d)));

        p->shines[i] = is_lit_side(&f->rich, i, s->cosine[i]) & (cosine > 0.0) & (f->rich.phong[i] != 0.0f) &
                       !((cosine <= f->highlight_cutoff[i]) & (least >= APPEARANCE_VISIBLE));
        p->base[i] = p->shines[i] ? cosine : 0.0;
    }
}

/* The highlights of `odd` lanes are to be computed by their powers. */
SIMD_CLONES static uint32_t take_products(parts *restrict p, const finishes *restrict f, uint32_t n)
{
    uint32_t odd = 0;

    for (uint32_t i = 0; i < n; i++) {
        const float lo = highlight_lo(p->raised[i]), hi = highlight_hi(p->raised[i]);

        p->odd[i] = p->shines[i] & !((lo == hi) & (f->power[i] > 0) & (f->power[i] <= APPEARANCE_POWER_LANES));
        odd |= p->odd[i];
        p->phong[i] = p->shines[i] ? f->rich.phong[i] * lo : 0.0f;
    }
    return odd;
}

static uint32_t phong_products(parts *p, const finishes *f, const light_sample *s, uint32_t n)
{
    find_shining(p, f, s, n);
    raise_whole(p, f, f->power, n);
    return take_products(p, f, n);
}

/* In a loop of its own: compilers that know the bounds of the base do not vectorise it. */
SIMD_CLONES static void raise(parts *restrict p, const double *restrict exponent, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        p->raised[i] = elementary_pow(p->base[i], exponent[i]);
}

SIMD_CLONES static void take_phong(parts *restrict p, const finishes *restrict f, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        p->phong[i] = p->odd[i] ? f->rich.phong[i] * (float)p->raised[i] : p->phong[i];
}

static void phong_powers(parts *p, const finishes *f, const light_sample *s, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        p->base[i] = s->specular_cos[i] > 0.0 ? s->specular_cos[i] : 0.0;
    raise(p, f->rich.phong_size, n);
    take_phong(p, f, n);
}

SIMD_CLONES static void find_halves(parts *restrict p, const light_sample *restrict s, const geometry *restrict g, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const pov_vec3 half = pov_sub(lanes_at(&s->unit, i), lanes_at(&g->view, i));
        const double square = pov_dot(half, half), cosine = s->cosine[i] + g->cosine[i];
        const double half_cos = square > 0.0 && cosine > 0.0 ? cosine / sqrt(square) : 0.0;

        p->half_cos[i] = p->base[i] = half_cos < 1.0 ? half_cos : 1.0;
    }
}

/* Powers too small for a colour are 0: floats below the normal ones take a processor a hundred times as long. */
static inline float visible(double power) { return (float)(power > 0x1p-100 ? power : 0.0); }

SIMD_CLONES static uint32_t specular_plain(parts *restrict p, const finishes *restrict f, const light_sample *restrict s, uint32_t n)
{
    uint32_t odd = 0;

    for (uint32_t i = 0; i < n; i++) {
        const bool shines = is_lit_side(&f->rich, i, s->cosine[i]) & (p->half_cos[i] > 0.0) & (f->rich.specular[i] != 0.0f);

        p->odd[i] = shines & (f->rich.whole[i] == 0);
        odd |= p->odd[i];
        p->specular[i] = shines ? f->rich.specular[i] * visible(p->raised[i]) : 0.0f;
    }
    return odd;
}

SIMD_CLONES static void take_specular(parts *restrict p, const finishes *restrict f, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        p->specular[i] = p->odd[i] ? f->rich.specular[i] * visible(p->raised[i]) : p->specular[i];
}

static void specular_powers(parts *p, const finishes *f, uint32_t n)
{
    memcpy(p->base, p->half_cos, n * sizeof *p->base);
    raise(p, f->rich.sharpness, n);
    take_specular(p, f, n);
}

static void find_specular(parts *p, const finishes *f, const light_sample *s, uint32_t n)
{
    find_halves(p, s, &f->on->geometry, n);
    raise_whole(p, f, f->rich.whole, n);
    if (specular_plain(p, f, s, n))
        specular_powers(p, f, n);
}

SIMD_CLONES static void dye(parts *restrict p, const finishes *restrict f, const double *restrict loss, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const float share = f->rich.metallic[i] * (float)(1.0 - loss[i]);

        p->red[i] = 1.0f + share * (f->red[i] - 1.0f);
        p->green[i] = 1.0f + share * (f->green[i] - 1.0f);
        p->blue[i] = 1.0f + share * (f->blue[i] - 1.0f);
    }
}

static void metal(parts *p, const finishes *f, const double *cosines, bool fresnel, uint32_t n)
{
    double loss[BATCH_MAX];

    for (uint32_t i = 0; i < n; i++)
        loss[i] = fresnel ? fabs(cosines[i]) : 0.0;
    if (fresnel)
        highlight_fresnel_lanes(loss, n);
    dye(p, f, loss, n);
}

static void highlights(parts *p, const finishes *f, const model *m, const light_sample *s, uint32_t n)
{
    if (f->has_phong && phong_products(p, f, s, n))
        phong_powers(p, f, s, n);
    if (f->kinds & FINISH_SPECULAR)
        find_specular(p, f, s, n);
    if (f->kinds & FINISH_METAL)
        metal(p, f, s->cosine, m->fresnel_metallic, n);
}

/* ---- all together ---- */

/* glossy, dyed: there are highlights, and not all are white. */
static inline void sum_lanes(light_sample *restrict s, const parts *restrict p, const finishes *restrict f,
                             const light_lanes *restrict in, uint32_t n, bool glossy, bool dyed)
{
    for (uint32_t i = 0; i < n; i++) {
        const float strength = glossy ? p->phong[i] + p->specular[i] : 0.0f, d = p->diffuse[i];
        const float red = in->uniform ? in->color.r : in->red[i], green = in->uniform ? in->color.g : in->green[i];
        const float blue = in->uniform ? in->color.b : in->blue[i];

        s->red[i] = red * (f->red[i] * d + (dyed ? p->red[i] * strength : strength));
        s->green[i] = green * (f->green[i] * d + (dyed ? p->green[i] * strength : strength));
        s->blue[i] = blue * (f->blue[i] * d + (dyed ? p->blue[i] * strength : strength));
    }
}

SIMD_CLONES static void sum_dyed(light_sample *restrict s, const parts *restrict p, const finishes *restrict f,
                                 const light_lanes *restrict in, uint32_t n)
{
    sum_lanes(s, p, f, in, n, true, true);
}

SIMD_CLONES static void sum_white(light_sample *restrict s, const parts *restrict p, const finishes *restrict f,
                                  const light_lanes *restrict in, uint32_t n)
{
    sum_lanes(s, p, f, in, n, true, false);
}

SIMD_CLONES static void sum_matt(light_sample *restrict s, const parts *restrict p, const finishes *restrict f,
                                 const light_lanes *restrict in, uint32_t n)
{
    sum_lanes(s, p, f, in, n, false, false);
}

/* A thin film: waves reflected at both its faces add up or cancel out. */
static inline float film(const rich_finishes *r, uint32_t i, double path_cos, float wavelength)
{
    const double full_turn = 6.28318530717958647693;

    return 1.0f + r->irid[i] * (float)elementary_cos(full_turn * r->thickness[i] * path_cos / (double)wavelength);
}

SIMD_CLONES static void films(light_sample *restrict s, const rich_finishes *restrict r, const double *restrict view, colour wavelength,
                              uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const double path_cos = fabs(s->cosine[i]) + fabs(view[i]);

        s->red[i] *= film(r, i, path_cos, wavelength.r);
        s->green[i] *= film(r, i, path_cos, wavelength.g);
        s->blue[i] *= film(r, i, path_cos, wavelength.b);
    }
}

/* both: of sides, what light from behind makes highlights on. */
SIMD_CLONES static void find_contributions(light_sample *restrict s, const float *restrict back, const float *restrict both, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        s->front[i] = (s->cosine[i] > 0.0) | (((back[i] != 0.0f) | (both[i] != 0.0f)) & (s->cosine[i] < 0.0));
        s->contributes[i] = s->front[i] & !colour_is_black(brdf_at(s, i));
    }
}

void brdf_films(const finishes *f, const model *m, light_sample *s, uint32_t n)
{
    films(s, &f->rich, f->on->geometry.cosine, m->irid_wavelength, n);
}

void brdf_reflect_rich(const finishes *f, const model *m, light_sample *s, const light_lanes *in, bool glossy, uint32_t n)
{
    const float *back = f->kinds ? f->rich.back_weight : no_back;   /* only these kinds are kept in lanes */
    parts p;

    diffuse(&p, f, back, s, &in->dir, n);
    if (!f->has_phong)
        memset(p.phong, 0, n * sizeof *p.phong);
    if (!(f->kinds & FINISH_SPECULAR))
        memset(p.specular, 0, n * sizeof *p.specular);
    if (glossy)
        highlights(&p, f, m, s, n);
    if (glossy && (f->kinds & FINISH_METAL))
        sum_dyed(s, &p, f, in, n);
    else if (glossy)
        sum_white(s, &p, f, in, n);
    else
        sum_matt(s, &p, f, in, n);
    if (f->kinds & FINISH_IRID)
        brdf_films(f, m, s, n);
    find_contributions(s, back, f->kinds ? f->rich.both_sides : no_back, n);
}
