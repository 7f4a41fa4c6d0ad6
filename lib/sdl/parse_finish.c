#include "sdl/parse_finish.h"

#include "sdl/noise.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

#include <math.h>
#include <string.h>

/* Strengths that were given as albedos; they depend on words that may follow. */
enum { ALBEDO_DIFFUSE = 1, ALBEDO_PHONG = 2, ALBEDO_SPECULAR = 4 };

/* The word is none of 3.7's reserved ones. It holds for strengths that the block gives later, too. */
static void read_albedo(pov_reader *in, surface_parsed *s, unsigned bit)
{
    if (in->token.kind == TOKEN_WORD && strcmp(in->token.symbol->name, "albedo") == 0) {
        state_advance(in);
        s->albedos |= bit;
    }
}

/* What is below 0 is left out. */
static float read_strength(pov_reader *in) { return pov_maxf(value_float(in), 0.0f); }

static void read_diffuse(pov_reader *in, surface_parsed *s, finish *f)
{
    s->material.finish.written = 1.0f;
    read_albedo(in, s, ALBEDO_DIFFUSE);
    f->diffuse = read_strength(in);
    f->diffuse_back = state_accept(in, ',') || value_follows(in) ? read_strength(in) : 0.0f;
}

static float read_size(pov_reader *in)
{
    const float size = value_float(in);

    if (size < 0.0f)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"phong_size\" must not be negative");
    return size;
}

/* The power is 1 / roughness; POV-Ray takes 0 for a roughness of 0: the whole surface shines. */
static double read_roughness(pov_reader *in)
{
    const double roughness = value_number(in);

    if (roughness == 0.0)
        report_warn(in, &in->value, "with a roughness of 0 the highlight is everywhere");
    return roughness == 0.0 ? HUGE_VAL : roughness;
}

/* A value that may be left out. */
static float read_amount(pov_reader *in) { return value_follows(in) ? value_float(in) : 1.0f; }

static void read_specular(pov_reader *in, surface_parsed *s, finish *f)
{
    read_albedo(in, s, ALBEDO_SPECULAR);
    f->specular = read_strength(in);
}

static void read_phong(pov_reader *in, surface_parsed *s, finish *f)
{
    read_albedo(in, s, ALBEDO_PHONG);
    f->phong = read_strength(in);
}

void parse_finish_item(pov_reader *in, void *self, keyword_id keyword)
{
    surface_parsed *s = self;
    finish *f = &s->material.finish;

    switch (keyword) {
    case KEYWORD_AMBIENT: f->ambient = value_colour(in, true).colour; break;
    case KEYWORD_EMISSION: f->emission = value_colour(in, true).colour; break;
    case KEYWORD_DIFFUSE: read_diffuse(in, s, f); break;
    case KEYWORD_BRILLIANCE: f->brilliance = value_number(in); break;
    case KEYWORD_PHONG: read_phong(in, s, f); break;
    case KEYWORD_PHONG_SIZE: f->phong_size = read_size(in); break;
    case KEYWORD_SPECULAR: read_specular(in, s, f); break;
    case KEYWORD_ROUGHNESS: f->roughness = read_roughness(in); break;
    case KEYWORD_METALLIC: f->metallic = pov_maxf(read_amount(in), 0.0f); break;
    case KEYWORD_CRAND: f->crand = read_strength(in); break;
    case KEYWORD_CONSERVE_ENERGY: f->conserve_energy = read_amount(in) != 0.0f; break;
    default: f->reflection.exponent = value_float(in); break;
    }
}

/* ---- reflection ---- */

/* A block that is being read; it has one value if only that for grazing rays was given. */
typedef struct reflection_block { reflection *of; bool is_one_value; } reflection_block;

/* With one value Fresnel's factor rises from 0 to it. A number is cut to a whole one, as in POV-Ray. */
static void read_fresnel(pov_reader *in, reflection_block *b)
{
    b->of->fresnel = truncf(read_amount(in)) != 0.0f;
    if (b->of->fresnel && b->is_one_value)
        b->of->min = colour_of(0.0f, 0.0f, 0.0f);
}

static void read_reflection_item(pov_reader *in, void *self, keyword_id keyword)
{
    reflection_block *b = self;
    reflection *r = b->of;

    switch (keyword) {
    case KEYWORD_FRESNEL: read_fresnel(in, b); break;
    case KEYWORD_FALLOFF: r->falloff = value_float(in); break;
    case KEYWORD_EXPONENT: r->exponent = value_float(in); break;
    default: r->metallic = read_amount(in); break;
    }
}

/* One value holds for all angles. Without any there is no reflection, whatever was given before. */
static void read_reflection_range(pov_reader *in, reflection_block *b)
{
    reflection *r = b->of;

    r->min = r->max = colour_of(0.0f, 0.0f, 0.0f);
    if (!value_colour_follows(in, true))
        return;
    r->min = r->max = value_colour(in, true).colour;
    state_accept(in, ',');
    b->is_one_value = !value_colour_follows(in, true);
    if (!b->is_one_value)
        r->max = value_colour(in, true).colour;
    state_accept(in, ',');
}

void parse_finish_reflection(pov_reader *in, void *self, keyword_id keyword)
{
    static const item items[] = { { KEYWORD_FRESNEL, read_reflection_item }, { KEYWORD_FALLOFF, read_reflection_item },
                                  { KEYWORD_EXPONENT, read_reflection_item }, { KEYWORD_METALLIC, read_reflection_item } };
    static const item_list list = { "an item of the reflection", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };
    reflection_block r = { &((surface_parsed *)self)->material.finish.reflection, false };
    block b;

    (void)keyword;
    if (in->token.kind != '{') {
        /* As in POV-Ray the course of an earlier block ends with it; what it is raised to and its metallic stay. */
        r.of->min = r.of->max = value_colour(in, true).colour;
        r.of->fresnel = false;
        r.of->falloff = 1.0f;
        return;
    }
    items_open(in, &b);
    read_reflection_range(in, &r);
    items_close(in, &b, &list, &r);
}

/* ---- irid ---- */

static void read_irid_item(pov_reader *in, void *self, keyword_id keyword)
{
    irid *i = &((surface_parsed *)self)->material.finish.irid;

    *(keyword == KEYWORD_THICKNESS ? &i->thickness : &i->turbulence) = value_float(in);
    if (keyword == KEYWORD_TURBULENCE)
        noise_of(in);
}

static void read_irid(pov_reader *in, void *self, keyword_id keyword)
{
    static const item items[] = { { KEYWORD_THICKNESS, read_irid_item }, { KEYWORD_TURBULENCE, read_irid_item } };
    static const item_list list = { "an item of the irid", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };
    block b;

    (void)keyword;
    items_open(in, &b);
    if (value_follows(in))
        ((surface_parsed *)self)->material.finish.irid.amount = read_strength(in);
    items_close(in, &b, &list, self);
}

/* ---- finish ---- */

void parse_finish_take(pov_reader *in, void *self, const value *v)
{
    surface_parsed *s = self;

    (void)in;
    s->material.finish = ((const material *)v->as.part)->finish;
    s->albedos = 0;
}

/* Old scenes have here what is the interior's now. */
static void read_old_ior(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    report_warn(in, &in->last, "\"ior\" belongs in the \"interior\"");
    ((surface_parsed *)self)->material.finish.old_ior = value_number(in);
}

static void read_old_caustics(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    report_warn(in, &in->last, "\"caustics\" belong in the \"interior\", as a 45th of this number");
    ((surface_parsed *)self)->material.finish.old_caustics = value_float(in) / 45.0f;
}

bool parse_finish_is_old(const surface_parsed *s)
{
    return s->has_look && (s->material.finish.old_ior >= 0.0 || s->material.finish.old_caustics >= 0.0f);
}

void parse_finish_settle(surface_parsed *s)
{
    const finish *f = &s->material.finish;
    interior *i = &s->material.interior;

    i->given = true;
    if (f->old_ior >= 0.0)
        interior_set_ior(i, f->old_ior > 0.0 ? f->old_ior : 1.0);
    if (f->old_caustics >= 0.0f)
        i->caustics = f->old_caustics;
}

static void read_old_refraction(pov_reader *in, void *self, keyword_id keyword)
{
    const place at = in->last;

    (void)keyword;
    report_warn(in, &at, "\"refraction\" is out of date: the factor of light that goes through is the pigment's");
    ((surface_parsed *)self)->material.finish.refraction = value_float(in);
}

static void read_translucency(pov_reader *in, void *self, keyword_id keyword)
{
    const colour mean = value_colour(in, true).colour;

    (void)keyword;
    ((surface_parsed *)self)->material.finish.translucency = mean;
    in->model->subsurface.used |= !colour_is_black(mean);
}

static void read_subsurface(pov_reader *in, void *self, keyword_id keyword)
{
    static const item items[] = { { KEYWORD_TRANSLUCENCY, read_translucency } };
    static const item_list list = { "\"translucency\"", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };

    (void)keyword;
    items_block(in, &list, self);
}

const keyword_id parse_finish_coming[] = { KEYWORD_OTHER };

static const keyword_id finish_old[] = { KEYWORD_FADE_DISTANCE, KEYWORD_FADE_POWER, KEYWORD_OTHER };

/* Albedos are fractions of all light from everywhere that is reflected. */
static void resolve_albedos(surface_parsed *s)
{
    finish *f = &s->material.finish;
    const float half = (float)(0.5 * (f->brilliance + 1.0));
    const double n = 1.0 / f->roughness;

    if (s->albedos & ALBEDO_DIFFUSE) {
        f->diffuse *= half;
        f->diffuse_back *= half;
        f->written = half != 0.0f ? 1.0f / half : 1.0f;
    }
    if (s->albedos & ALBEDO_PHONG)
        f->phong *= 0.5f * (f->phong_size + 1.0f);
    if (s->albedos & ALBEDO_SPECULAR)
        f->specular *= (float)((n + 2.0) / (4.0 * (2.0 - exp2(-0.5 * n))));
    s->albedos = 0;
}

void parse_finish(pov_reader *in, surface_parsed *s)
{
    static const item items[] = { PARSE_FINISH_ROWS(parse_finish_item, parse_finish_reflection), { KEYWORD_IRID, read_irid }, { KEYWORD_SUBSURFACE, read_subsurface }, { KEYWORD_IOR, read_old_ior }, { KEYWORD_CAUSTICS, read_old_caustics },
                                  { KEYWORD_REFRACTION, read_old_refraction } };
    static const item_list list = { "an item of the finish", ITEMS(items), finish_old, NULL, parse_finish_coming,
                                    VALUE_FINISH, parse_finish_take };

    s->has_look = true;
    s->albedos = 0;
    items_block(in, &list, s);
    resolve_albedos(s);
}
