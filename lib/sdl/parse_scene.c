#include "sdl/parse.h"
#include "sdl/report.h"

static const item statement_items[] = {
    { WORD_CAMERA, parse_camera },
    { WORD_LIGHT_SOURCE, parse_light },
    { WORD_GLOBAL_SETTINGS, parse_global_settings },
    { WORD_BACKGROUND, parse_background },
};

static const item_list statements = ITEM_LIST("an object or a setting", statement_items);

void parse_scene_guess(guess *g)
{
    size_t i;

    for (i = 0; i < statements.count; i++)
        report_guess_try(g, token_word_name(statements.items[i].word));
}

/* A word that is no statement names an object, if a plugin knows it. */
void parse_scene(pov_reader *in)
{
    while (!in->failed && !state_at_end(in)) {
        if (items_try(in, &statements, NULL))
            continue;
        if (in->token.kind == TOKEN_WORD)
            parse_object(in);
        else
            report_expected(in, statements.wanted);
    }
}
