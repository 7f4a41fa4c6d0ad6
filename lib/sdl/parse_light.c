#include "sdl/expression.h"
#include "sdl/parse_media.h"
#include "sdl/parse_photons.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

/* A light source as it is read. */
typedef struct light_reading {
    object_parsed *out;
    double angles[2];            /* radius and falloff as written; NaN: not given */
    bool is_parallel;
} light_reading;

static light *light_of(void *self) { return &((light_reading *)self)->out->light; }

/* A transformation moves what has been said so far: a point_at behind it stays. */
static void move_light(pov_reader *in, void *self, keyword_id keyword)
{
    parse_transform(in, &((light_reading *)self)->out->map, keyword);
}

static void read_type(pov_reader *in, void *self, keyword_id keyword)
{
    light_reading *r = self;
    light *l = light_of(self);

    (void)in;
    if (keyword == KEYWORD_PARALLEL) {
        r->is_parallel = true;
    } else {
        l->type = keyword == KEYWORD_CYLINDER ? LIGHT_CYLINDER : LIGHT_SPOT;
        l->flags &= ~(uint32_t)LIGHT_SHADOWLESS;
    }
}

/* The words that say how light is directed stand behind the word that says that it is. */
static void check_order(pov_reader *in, keyword_id keyword, bool is_directed, const char *after)
{
    place at = in->last;

    if (!in->failed && !is_directed)
        report_fail(in, &at, POV_E_SYNTAX, "\"%s\" stands behind %s", token_keyword_name(keyword), after);
}

static void read_point_at(pov_reader *in, void *self, keyword_id keyword)
{
    light_reading *r = self;

    check_order(in, keyword, r->is_parallel || light_of(self)->type != LIGHT_POINT,
                "\"spotlight\", \"cylinder\" or \"parallel\"");
    r->out->point_at = value_vector(in);
    r->out->aimed = r->out->map;
}

static void read_beam(pov_reader *in, void *self, keyword_id keyword)
{
    light_reading *r = self;

    check_order(in, keyword, light_of(self)->type != LIGHT_POINT, "\"spotlight\" or \"cylinder\"");
    if (keyword == KEYWORD_TIGHTNESS)
        light_of(self)->tightness = value_number(in);
    else
        r->angles[keyword == KEYWORD_FALLOFF] = value_number(in);
}

static void read_fading(pov_reader *in, void *self, keyword_id keyword)
{
    light *l = light_of(self);

    if (keyword == KEYWORD_FADE_DISTANCE)
        l->fade_distance = value_number(in);
    else
        l->fade_power = value_number(in);
}

/* More points than this are a slip. */
enum { AREA_MOST = 1 << 14 };

static uint32_t read_count(pov_reader *in)
{
    const double count = value_number(in);

    if (!in->failed && !(count >= 1.0 && count <= (double)AREA_MOST))
        report_fail(in, &in->value, POV_E_SYNTAX, "an area light has 1 to %d points a side", AREA_MOST);
    return in->failed ? 1 : (uint32_t)count;
}

static void read_area(pov_reader *in, void *self, keyword_id keyword)
{
    light *l = light_of(self);

    (void)keyword;
    l->flags |= LIGHT_AREA;
    ((light_reading *)self)->out->spread = ((light_reading *)self)->out->map;
    for (int i = 0; i < 2; i++) {
        l->area.axes[i] = value_vector(in);
        state_accept(in, ',');
    }
    l->area.counts[0] = read_count(in);
    state_accept(in, ',');
    l->area.counts[1] = read_count(in);
    if (!in->failed && (uint64_t)l->area.counts[0] * l->area.counts[1] > AREA_MOST)
        report_fail(in, &in->value, POV_E_SYNTAX, "an area light has at most %d points", AREA_MOST);
}

/* All points are tested whatever `adaptive` says: what it leaves out may be what a small object hides. */
static void skip_adaptive(pov_reader *in, void *self, keyword_id keyword)
{
    (void)self;
    (void)keyword;
    value_number(in);
}

static void set(pov_reader *in, light *l, uint32_t flag, bool has_value)
{
    if (has_value && value_optional(in, 1.0) == 0.0)
        l->flags &= ~flag;
    else
        l->flags |= flag;
}

static void read_flag(pov_reader *in, void *self, keyword_id keyword)
{
    light *l = light_of(self);

    switch (keyword) {
    case KEYWORD_SHADOWLESS:
        set(in, l, LIGHT_SHADOWLESS, false);
        break;
    case KEYWORD_JITTER:
        set(in, l, LIGHT_JITTER, false);
        break;
    case KEYWORD_CIRCULAR:
        set(in, l, LIGHT_CIRCULAR, false);
        break;
    case KEYWORD_ORIENT:
        set(in, l, LIGHT_ORIENT, false);
        break;
    default:
        set(in, l, LIGHT_AREA_ILLUMINATION, true);
    }
}

static void read_attenuation(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    set(in, light_of(self), LIGHT_ATTENUATED, true);
}

/* It is on unless the scene says otherwise. */
static void read_interaction(pov_reader *in, void *self, keyword_id keyword)
{
    light *l = light_of(self);

    (void)keyword;
    if (value_optional(in, 1.0) == 0.0)
        l->flags |= LIGHT_NO_MEDIA;
    else
        l->flags &= ~(uint32_t)LIGHT_NO_MEDIA;
}

static const item_list no_items = { "the end of the block", NULL, 0, NULL, NULL, NULL, VALUE_NOTHING, NULL };

static void move_by(pov_reader *in, object_parsed *o, const transform *shift)
{
    const media **filling = &o->surface.material.interior.media;

    if (!shift)
        return;
    parse_append_transforms(in, &o->map, shift, NULL);
    o->surface.moves += parse_count_transforms(shift);
    *filling = in->failed ? NULL : parse_media_move(in, *filling, shift);
}

/* An object, moved, and modifiers that hold for it there. False: there is none. */
static bool read_object(pov_reader *in, light_reading *r, const transform *shift, object_parsed *out)
{
    bool found;
    block b;

    items_open(in, &b);
    found = parse_object_try(in, out);
    if (found)
        move_by(in, out, shift);
    else
        report_expected(in, "an object");
    parse_modifiers(in, out, '}');
    items_close(in, &b, &no_items, r);
    return found;
}

/* To where the light is by now. */
static const transform *find_shift(pov_reader *in, const object_parsed *o)
{
    const transform *shift = NULL;
    pov_vec3 at = o->light.position, low;
    pov_affine map;

    if (o->map && transform_compose(o->map, &map))
        transform_point(&map, at, &at, &low);
    parse_append_translation(in, &shift, at);
    return shift;
}

/* An object that is seen where the light is, and hides none of it. */
static void read_looks_like(pov_reader *in, void *self, keyword_id keyword)
{
    light_reading *r = self;
    object_parsed shown;

    (void)keyword;
    if (!read_object(in, r, find_shift(in, r->out), &shown))
        return;
    shown.flags |= LEAF_NO_SHADOW;
    shown.since = r->out->map;
    r->out->first = parse_keep(in, &shown);
}

/* An object that is not seen, but that light has to come through. */
static void read_projected_through(pov_reader *in, void *self, keyword_id keyword)
{
    light_reading *r = self;
    object_parsed hole;

    (void)keyword;
    if (!read_object(in, r, NULL, &hole))
        return;
    hole.flags |= LEAF_NO_SHADOW | LEAF_NO_IMAGE | LEAF_NO_REFLECTION;
    hole.since = r->out->map;
    r->out->through = parse_keep(in, &hole);
}

static void read_photons(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_photons_light(in, &light_of(self)->flags);
}

static const item items[] = {
    PARSE_MOVES(move_light),               { KEYWORD_SPOTLIGHT, read_type },       { KEYWORD_CYLINDER, read_type },
    { KEYWORD_PARALLEL, read_type },       { KEYWORD_POINT_AT, read_point_at },    { KEYWORD_RADIUS, read_beam },
    { KEYWORD_FALLOFF, read_beam },        { KEYWORD_TIGHTNESS, read_beam },       { KEYWORD_FADE_DISTANCE, read_fading },
    { KEYWORD_FADE_POWER, read_fading },   { KEYWORD_AREA_LIGHT, read_area },      { KEYWORD_ADAPTIVE, skip_adaptive },
    { KEYWORD_SHADOWLESS, read_flag },     { KEYWORD_JITTER, read_flag },          { KEYWORD_CIRCULAR, read_flag },
    { KEYWORD_ORIENT, read_flag },         { KEYWORD_AREA_ILLUMINATION, read_flag }, { KEYWORD_LOOKS_LIKE, read_looks_like },
    { KEYWORD_PROJECTED_THROUGH, read_projected_through }, { KEYWORD_PHOTONS, read_photons },
    { KEYWORD_MEDIA_ATTENUATION, read_attenuation }, { KEYWORD_MEDIA_INTERACTION, read_interaction },
};
static const item_list list = { "a modifier of the light", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };

static void skip_colour(pov_reader *in, void *self, keyword_id keyword)
{
    double unused[5];

    (void)self;
    report_warn(in, &in->last, "\"%s\" has no effect on a light that has a name", token_keyword_name(keyword));
    value_colour_components(in, true, unused);
}

/* A light with a name is moved only. */
static const item moves[] = {
    PARSE_MOVES(move_light),      { KEYWORD_COLOR, skip_colour }, { KEYWORD_COLOUR, skip_colour },
    { KEYWORD_RGB, skip_colour }, { KEYWORD_RGBF, skip_colour },  { KEYWORD_RGBT, skip_colour },
    { KEYWORD_RGBFT, skip_colour },
};
static const item_list move_list = { "a transformation", ITEMS(moves), NULL, NULL, NULL, VALUE_NOTHING, NULL };

static void begin(light_reading *r, object_parsed *out)
{
    r->out = out;
    r->angles[0] = r->angles[1] = NAN;
    r->is_parallel = false;
    out->kind = OBJECT_LIGHT;
    out->light.type = LIGHT_POINT;
    out->point_at = pov_vec3_of(0.0, 0.0, 1.0);
}

static double given(double angle, double otherwise) { return isnan(angle) ? otherwise : angle; }

/* What the words mean together, in whatever order they came. */
static void conclude(light_reading *r)
{
    const double degree = 3.14159265358979323846 / 180.0;
    light *l = light_of(r);

    /* Spotlight, cylinder and shadowless are of one kind in POV-Ray: the last word counts. */
    if (l->flags & LIGHT_SHADOWLESS) {
        r->is_parallel |= l->type == LIGHT_CYLINDER;
        l->type = LIGHT_POINT;
    }
    if (r->is_parallel && l->type != LIGHT_CYLINDER) {
        l->flags |= l->type == LIGHT_SPOT ? LIGHT_AHEAD : 0;
        l->type = LIGHT_PARALLEL;
    }
    if (l->type == LIGHT_SPOT) {
        l->radius = cos(degree * given(r->angles[0], 30.0));
        l->falloff = cos(degree * given(r->angles[1], 45.0));
    } else if (l->type == LIGHT_CYLINDER) {
        l->radius = given(r->angles[0], 0.75);
        l->falloff = given(r->angles[1], 1.0);
    }
}

void parse_light_modifiers(pov_reader *in, object_parsed *out)
{
    light_reading r;

    begin(&r, out);
    items_until(in, TOKEN_END, &list, &r);
    conclude(&r);
}

/* The colour stands behind the position, as in POV-Ray. */
void parse_light(pov_reader *in, object_parsed *out)
{
    light_reading r;
    place at = in->last;
    block b;

    begin(&r, out);
    out->leaf.line = (uint32_t)at.line;
    out->leaf.column = (uint32_t)at.column;
    items_open(in, &b);
    if (parse_object_follows(in)) {
        parse_object_try(in, out);
        items_close(in, &b, &move_list, &r);
        return;
    }
    out->light.position = value_vector(in);
    state_accept(in, ',');
    if (value_colour_follows(in, true))
        out->light.color = value_colour(in, true).colour;
    else if (in->token.kind == '}')
        report_warn(in, &at, "a light without a colour is black");
    items_close(in, &b, &list, &r);
    conclude(&r);
}
