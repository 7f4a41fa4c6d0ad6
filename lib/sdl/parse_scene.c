#include "sdl/parse_air.h"
#include "sdl/directive.h"
#include "sdl/parse_media.h"
#include "sdl/recover.h"
#include "sdl/report.h"

static void read_camera(pov_reader *in, void *self, keyword_id keyword)
{
    const place at = in->last;

    (void)self;
    (void)keyword;
    if (in->camera.at.source)
        report_warn(in, &at, "there was a camera before; the last one counts");
    parse_camera(in, &in->camera);
}

static const item statement_items[] = {
    { KEYWORD_CAMERA, read_camera },
    { KEYWORD_GLOBAL_SETTINGS, parse_global_settings },
    { KEYWORD_BACKGROUND, parse_background },
    { KEYWORD_SKY_SPHERE, parse_sky },
    { KEYWORD_FOG, parse_fog },
    { KEYWORD_RAINBOW, parse_rainbow },
    { KEYWORD_MEDIA, parse_atmosphere },
};

static const keyword_id coming[] = {
    KEYWORD_RADIOSITY, KEYWORD_PHOTONS, KEYWORD_OTHER,
};

static const item_list statements = { "an object or a setting", ITEMS(statement_items), NULL, NULL, coming,
                                      VALUE_NOTHING, NULL };

static void guess_keyword(void *user, const char *keyword)
{
    report_guess_try(user, keyword);
}

void parse_shapes_guess(const pov_reader *in, guess *g)
{
    for (int i = KEYWORD_OTHER + 1; i < KEYWORDS; i++)
        if (token_keyword_flags((keyword_id)i) & KEYWORD_FLAG_SHAPE)
            report_guess_try(g, token_keyword_name((keyword_id)i));
    registry_each_keyword(in->plugins, "primitives", guess_keyword, g);
}

void parse_scene_guess(guess *g)
{
    size_t i;

    for (i = 0; i < statements.count; i++)
        report_guess_try(g, token_keyword_name(statements.items[i].keyword));
    report_guess_try(g, "light_source");
}

/* A word that is no statement names an object, if a plugin knows it. */
static void read_statement(pov_reader *in)
{
    if (items_try(in, &statements, NULL) || directive_run_bare(in))
        return;
    if (in->token.kind == TOKEN_WORD) {
        parse_object(in);
    } else if (in->token.kind == ';') {
        report_warn(in, &in->token.at, "a \";\" that nothing needs");
        state_advance(in);
    } else {
        report_expected(in, statements.wanted);
    }
}

void parse_scene(pov_reader *in)
{
    do
        while (!in->failed && !state_at_end(in))
            read_statement(in);
    while (in->failed && recover(in));
}
