#include "sdl/parse_media.h"
#include "sdl/report.h"
#include "sdl/value.h"

static void read_ior(pov_reader *in, interior *i)
{
    double ior = value_number(in);

    if (ior < 0.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"ior\" must not be negative");
    if (!in->failed && ior == 0.0) {
        report_warn(in, &in->value, "an ior of 0 counts as 1");
        ior = 1.0;
    }
    interior_set_ior(i, ior);
}

static void read_samples(pov_reader *in, interior *i)
{
    const double samples = value_number(in);

    if (!(samples >= 1.0 && samples <= 1000.0))
        report_fail(in, &in->value, POV_E_SYNTAX, "\"dispersion_samples\" must be from 1 to 1000");
    else
        i->dispersion_samples = (int)samples;
}

static void read_item(pov_reader *in, void *self, keyword_id keyword)
{
    interior *i = &((surface_parsed *)self)->material.interior;

    switch (keyword) {
    case KEYWORD_IOR: read_ior(in, i); break;
    case KEYWORD_CAUSTICS: i->caustics = value_float(in); break;
    case KEYWORD_DISPERSION: interior_ask_dispersion(i, value_number(in)); break;
    case KEYWORD_DISPERSION_SAMPLES: read_samples(in, i); break;
    case KEYWORD_FADE_DISTANCE: i->fade_distance = value_number(in); break;
    case KEYWORD_FADE_POWER: i->fade_power = value_number(in); break;
    default: i->fade_color = value_colour(in, true).colour; break;
    }
}

static void skip_refraction(pov_reader *in, void *self, keyword_id keyword)
{
    (void)self;
    (void)keyword;
    report_warn(in, &in->last, "\"refraction\" has no effect: an ior refracts");
    value_optional(in, 1.0);
}

static void take_interior(pov_reader *in, void *self, const value *v)
{
    (void)in;
    ((surface_parsed *)self)->material.interior = ((const material *)v->as.part)->interior;
}

static void read_media(pov_reader *in, void *self, keyword_id keyword)
{
    interior *i = &((surface_parsed *)self)->material.interior;

    (void)keyword;
    i->media = parse_media_upon(in, i->media);
}

void parse_interior(pov_reader *in, surface_parsed *s)
{
    static const item items[] = { { KEYWORD_IOR, read_item }, { KEYWORD_CAUSTICS, read_item },
                                  { KEYWORD_DISPERSION, read_item }, { KEYWORD_DISPERSION_SAMPLES, read_item },
                                  { KEYWORD_FADE_DISTANCE, read_item }, { KEYWORD_FADE_POWER, read_item },
                                  { KEYWORD_FADE_COLOR, read_item }, { KEYWORD_FADE_COLOUR, read_item },
                                  { KEYWORD_MEDIA, read_media }, { KEYWORD_REFRACTION, skip_refraction } };
    static const item_list list = { "an item of the interior", ITEMS(items), NULL, NULL, NULL,
                                    VALUE_INTERIOR, take_interior };

    interior_init(&s->material.interior);
    s->material.interior.given = true;
    items_block(in, &list, s);
}
