#include "shade/appearance.h"

/* Fraction of ambient and diffuse light of a transparent surface. Negative if filter and transmit are more than 1
 * together, as in POV-Ray. */
static float opacity_of(const model *m, const pigment *of)
{
    return 1.0f - appearance_covered(m, of->color, of->filter) - of->transmit;
}

static bool is_share(float x) { return x >= 0.0f && x <= 1.0f; }

/* A sum of APPEARANCE_VISIBLE or more does not change if less than half of 2^-32 is added, the distance of floats just
 * below. The highlight is phong cosine^size times at most 1; solved for the cosine with one more factor of 2 for all
 * roundings. */
static double cutoff_of(const finish *of, colour c)
{
    const float largest_size = 0x1p20f;

    if (!(of->phong > 0.0f && of->phong_size > 0.0f && of->phong_size < largest_size))
        return 0.0;
    if (of->metallic != 0.0f && !(is_share(of->metallic) && is_share(c.r) && is_share(c.g) && is_share(c.b)))
        return 0.0;
    return pow(0x1p-34 / (double)of->phong, 1.0 / (double)of->phong_size);
}

static uint32_t power_of(const finish *of)
{
    const float size = of->phong_size;

    return size >= 1.0f && size <= (float)APPEARANCE_POWER_MAX && size == floorf(size) ? (uint32_t)size : 0;
}

static float phong_of(const plan *p, const finish *of)
{
    const uint32_t power = power_of(of);

    if (!p->highlights || of->phong == 0.0f)
        return 0.0f;
    return power > 0 && power <= APPEARANCE_POWER_LANES && of->metallic == 0.0f ? of->phong : NAN;
}

void onward_set_filter(onward *out, const model *m, colour by)
{
    out->filter = coefficient_of(by);
    out->dark = m->opaque_dark_filters && appearance_is_dark(m, by);
}

static inline colour emitted_by(const model *m, const finish *f, const pigment *at, float opacity)
{
    const colour ambient = colour_mul(colour_scale(colour_mul(f->ambient, at->color), opacity), m->ambient_light);

    return colour_add(ambient, colour_scale(colour_mul(f->emission, at->color), opacity));
}

void appearance_light_of(appearance_light *out, const model *m, const finish *f, const pigment *at)
{
    out->opacity = opacity_of(m, at);
    out->emitted = emitted_by(m, f, at, out->opacity);
    out->filter = material_filter_of(at->color, at->filter, at->transmit);
}

bool appearance_transmits(const plan *p, const pigment *at)
{
    return p->transmission && (at->filter != 0.0f || at->transmit != 0.0f);
}

/* Members that depend on the pigment, but for the filter. */
static inline void set_pigment(appearance *out, const plan *p, const finish *f, const pigment *at, float opacity, colour emitted)
{
    out->transmissive = appearance_transmits(p, at);
    out->pigment = at->color;
    out->opacity = opacity;
    out->diffuse_weight = opacity * f->diffuse;
    out->below_weight = 0.0f;
    if (p->subsurface && !colour_is_black(f->translucency)) {
        out->below_weight = out->diffuse_weight;
        out->diffuse_weight = 0.0f;
    }
    out->emitted = emitted;
}

/* f: what out->finish is, which may have been written just before. */
static void paint(appearance *out, const plan *p, const model *m, const finish *f, const pigment *at)
{
    appearance_light own;

    appearance_light_of(&own, m, f, at);
    set_pigment(out, p, f, at, own.opacity, own.emitted);
    onward_set_filter(&out->onward, m, own.filter);
}

static bool is_lit(const finish *f)
{
    return f->diffuse != 0.0f || f->diffuse_back != 0.0f || finish_is_glossy(f) || f->crand != 0.0f;
}

static uint32_t kinds_of(const finish *f)
{
    uint32_t kinds = 0;

    kinds |= f->brilliance != 1.0 ? FINISH_BRILLIANCE : 0;
    kinds |= f->specular != 0.0f ? FINISH_SPECULAR : 0;
    kinds |= f->metallic != 0.0f && finish_is_glossy(f) ? FINISH_METAL : 0;
    kinds |= f->diffuse_back != 0.0f ? FINISH_BACK : 0;
    kinds |= f->irid.amount != 0.0f ? FINISH_IRID : 0;
    return kinds | (f->crand != 0.0f ? FINISH_CRAND : 0);
}

void appearance_make(appearance *out, const plan *p, const model *m, const finish *f, const pigment *at)
{
    out->finish = f;
    out->lit = p->lighting && is_lit(f);
    out->gathers = p->radiosity && (f->diffuse != 0.0f || f->diffuse_back != 0.0f);
    out->kinds = kinds_of(f);
    out->powered = f->reflection.exponent != 1.0f;
    out->angular = finish_is_angular(f);
    out->fresnel = f->reflection.fresnel && !colour_equal(f->reflection.min, f->reflection.max);
    out->reflective = p->reflection && finish_is_mirror(f);
    out->phong = phong_of(p, f);
    out->highlight_cutoff = out->phong == 0.0f ? 0.0 : cutoff_of(f, at->color);
    out->power = power_of(f);
    out->onward.reflection = coefficient_of(f->reflection.max);
    paint(out, p, m, f, at);
    out->needs_point = out->lit || out->gathers || out->reflective || out->transmissive || out->below_weight != 0.0f;
}

void appearance_set_material(appearance *out, const material *of)
{
    out->material = of;
    if (of->double_illuminate)
        out->kinds |= FINISH_BACK;
}

/* Only for metals the colour of the highlight, and so its cut-off, depends on the pigment. */
static inline void set_cutoff(appearance *out, float phong, const finish *f, const pigment *at)
{
    if (phong != 0.0f && f->metallic != 0.0f)
        out->highlight_cutoff = cutoff_of(f, at->color);
}

void appearance_paint(appearance *out, const plan *p, const model *m, const appearance *of, const pigment *at)
{
    *out = *of;
    paint(out, p, m, of->finish, at);
    set_cutoff(out, of->phong, of->finish, at);
}

void appearance_repaint(appearance *out, const plan *p, const model *m, const pigment *at)
{
    const finish *f = out->finish;
    const float opacity = opacity_of(m, at);

    set_pigment(out, p, f, at, opacity, emitted_by(m, f, at, opacity));
    if (out->transmissive)
        onward_set_filter(&out->onward, m, material_filter_of(at->color, at->filter, at->transmit));
    set_cutoff(out, out->phong, f, at);
}
