#include "sdl/parse_media.h"

#include "sdl/parse_texture.h"
#include "sdl/report.h"
#include "sdl/textures.h"
#include "sdl/value.h"

#include <string.h>

enum { DENSITIES_MAX = 32 };

/* One media { } as it is read. */
typedef struct media_reading {
    medium medium;
    const pigment_node *densities[DENSITIES_MAX];
    uint32_t intervals, samples; /* 0: not given */
} media_reading;

/* ---- items ---- */

static void read_colour(pov_reader *in, void *self, keyword_id keyword)
{
    medium *m = &((media_reading *)self)->medium;
    const colour c = value_colour(in, true).colour;

    if (keyword == KEYWORD_ABSORPTION)
        m->absorption = c;
    else
        m->emission = c;
}

static void read_strength(pov_reader *in, void *self, keyword_id keyword)
{
    medium *m = &((media_reading *)self)->medium;

    if (keyword == KEYWORD_ECCENTRICITY && m->type != SCATTER_HENYEY)
        report_fail(in, &in->last, POV_E_SYNTAX, "\"eccentricity\" is of a scattering of type %d", SCATTER_HENYEY);
    else if (keyword == KEYWORD_ECCENTRICITY)
        m->eccentricity = value_float(in);
    else
        m->extinction = value_float(in);
}

/* scattering { TYPE, COLOUR }: the last one of a media counts. */
static void read_scattering(pov_reader *in, void *self, keyword_id keyword)
{
    static const item items[] = { { KEYWORD_ECCENTRICITY, read_strength }, { KEYWORD_EXTINCTION, read_strength } };
    static const item_list list = { "an item of the scattering", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };
    medium *m = &((media_reading *)self)->medium;
    double type;
    block b;

    (void)keyword;
    items_open(in, &b);
    type = value_number(in);
    if (!in->failed && !(type >= 1.0 && type < (double)SCATTER_TYPES)) {
        report_warn(in, &in->value, "the type of a scattering is from 1 to %d; others count as 1", SCATTER_TYPES - 1);
        type = 1.0;
    }
    state_accept(in, ',');
    m->type = in->failed ? SCATTER_NONE : (scatter_type)type;
    m->scattering = value_colour(in, true).colour;
    m->extinction = 1.0f;
    m->eccentricity = 0.0f;
    items_close(in, &b, &list, self);
}

static void read_density(pov_reader *in, void *self, keyword_id keyword)
{
    media_reading *r = self;
    const pigment_node *node = parse_density_node(in);

    (void)keyword;
    if (r->medium.density_count == DENSITIES_MAX)
        report_fail(in, &in->last, POV_E_SYNTAX, "more than %d densities in a media", DENSITIES_MAX);
    else if (node)
        r->densities[r->medium.density_count++] = node;
}

/* The sampler of POV-Ray's that the scene was written for; all come to the same here. */
static void read_method(pov_reader *in, void *self, keyword_id keyword)
{
    const double method = value_number(in), most = 4.0;

    (void)self;
    (void)keyword;
    if (!in->failed && !(method >= 1.0 && method < most))
        report_fail(in, &in->value, POV_E_SYNTAX, "the method of a media is 1, 2 or 3");
}

static uint32_t read_count(pov_reader *in)
{
    const double count = value_number(in), most = 1e6;

    return count >= 1.0 ? (uint32_t)(count < most ? count : most) : 1;
}

/* Samples of POV-Ray's sampler. Here they say how many strata a segment has. */
static void read_samples(pov_reader *in, void *self, keyword_id keyword)
{
    media_reading *r = self;

    if (keyword == KEYWORD_INTERVALS) {
        r->intervals = read_count(in);
        return;
    }
    r->samples = read_count(in);
    if (state_accept(in, ',') || value_follows(in))
        value_number(in);
}

/* What was read so far is moved. */
static void move_media(pov_reader *in, void *self, keyword_id keyword)
{
    media_reading *r = self;
    const transform *moves = NULL;

    parse_transform(in, &moves, keyword);
    for (uint32_t i = 0; i < r->medium.density_count && !in->failed; i++)
        r->densities[i] = textures_move_pigment(in, r->densities[i], moves);
}

static void take_media(pov_reader *in, void *self, const value *v)
{
    media_reading *r = self;

    (void)in;
    if (!v->as.part)
        return;
    r->medium = *(const medium *)v->as.part;
    r->samples = r->medium.strata;
    if (r->medium.density_count > 0)
        memcpy(r->densities, r->medium.densities, r->medium.density_count * sizeof *r->densities);
}

/* ---- media ---- */

/* Intervals without samples are those of old scenes: one sample each. */
static uint32_t strata_of(const media_reading *r)
{
    const uint32_t most = 1000, intervals = r->intervals > 0 ? r->intervals : 1;
    const uint32_t each = r->samples > 0 ? r->samples : 1;

    if (r->intervals == 0 && r->samples == 0)
        return 0;
    return intervals < most && each < most && intervals * each < most ? intervals * each : most;
}

static void read_media(pov_reader *in, media_reading *r)
{
    static const item items[] = {
        { KEYWORD_ABSORPTION, read_colour },  { KEYWORD_EMISSION, read_colour }, { KEYWORD_SCATTERING, read_scattering },
        { KEYWORD_DENSITY, read_density },    { KEYWORD_INTERVALS, read_samples }, { KEYWORD_SAMPLES, read_samples },
        { KEYWORD_METHOD, read_method },
        PARSE_MOVES(move_media),
    };
    static const keyword_id quiet[] = { KEYWORD_RATIO, KEYWORD_CONFIDENCE, KEYWORD_VARIANCE,
                                        KEYWORD_JITTER, KEYWORD_AA_LEVEL, KEYWORD_AA_THRESHOLD, KEYWORD_COLLECT,
                                        KEYWORD_OTHER };
    static const item_list list = { "an item of the media", ITEMS(items), quiet, NULL, NULL, VALUE_MEDIA, take_media };

    memset(r, 0, sizeof *r);
    r->medium.extinction = 1.0f;
    items_block(in, &list, r);
    r->medium.strata = strata_of(r);
}

static medium keep_densities(pov_reader *in, const medium *m, const pigment_node *const *densities)
{
    const size_t bytes = m->density_count * sizeof *densities;
    medium out;

    memset(&out, 0, sizeof out);
    out = *m;
    out.densities = bytes > 0 ? intern(in, densities, bytes, bytes) : NULL;
    return out;
}

const medium *parse_media_node(pov_reader *in)
{
    media_reading r;
    medium m;

    read_media(in, &r);
    if (in->failed)
        return NULL;
    m = keep_densities(in, &r.medium, r.densities);
    return in->failed ? NULL : intern(in, &m, sizeof m, sizeof m);
}

static const media *keep_media(pov_reader *in, const medium *items, uint32_t count)
{
    media list;

    memset(&list, 0, sizeof list);
    list.count = count;
    list.items = intern(in, items, count * sizeof *items, count * sizeof *items);
    return in->failed ? NULL : intern(in, &list, sizeof list, sizeof list);
}

/* More in one interior are a slip. */
enum { MEDIA_MOST = 64 };

const media *parse_media_upon(pov_reader *in, const media *before)
{
    const uint32_t count = before ? before->count : 0;
    const medium *one = parse_media_node(in);
    medium all[MEDIA_MOST];

    if (!one)
        return before;
    if (count == MEDIA_MOST) {
        report_fail(in, &in->last, POV_E_SYNTAX, "more than %d media in one place", MEDIA_MOST);
        return before;
    }
    memset(all, 0, sizeof all);
    if (count > 0)
        memcpy(all, before->items, count * sizeof *all);
    all[count] = *one;
    return keep_media(in, all, count + 1);
}

void parse_atmosphere(pov_reader *in, void *self, keyword_id keyword)
{
    const media *all = parse_media_upon(in, in->model->atmosphere);

    (void)self;
    (void)keyword;
    if (!in->failed)
        in->model->atmosphere = parse_media_settle(in, all);
}

/* ---- changed ones ---- */

static medium move_medium(pov_reader *in, const medium *m, const transform *moves)
{
    const pigment_node *moved[DENSITIES_MAX];

    for (uint32_t i = 0; i < m->density_count; i++)
        moved[i] = textures_move_pigment(in, m->densities[i], moves);
    return keep_densities(in, m, moved);
}

static bool any_varies(const media *m)
{
    for (uint32_t i = 0; i < m->count; i++)
        if (medium_varies(&m->items[i]))
            return true;
    return false;
}

const media *parse_media_move(pov_reader *in, const media *m, const transform *moves)
{
    medium all[MEDIA_MOST];

    if (!m || !moves || in->failed || !any_varies(m))
        return m;
    memset(all, 0, sizeof all);
    for (uint32_t i = 0; i < m->count; i++)
        all[i] = move_medium(in, &m->items[i], moves);
    return in->failed ? m : keep_media(in, all, m->count);
}

const media *parse_media_settle(pov_reader *in, const media *m)
{
    for (uint32_t i = 0; m && i < m->count; i++)
        for (uint32_t k = 0; k < m->items[i].density_count && !in->failed; k++)
            textures_settle_pigment(in, m->items[i].densities[k]);
    return m;
}
