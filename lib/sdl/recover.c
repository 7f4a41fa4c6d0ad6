#include "sdl/recover.h"

#include "sdl/directive.h"
#include "sdl/frame.h"
#include "sdl/report.h"

/* Behind an error in a directive, names are missing or conditions open: what followed would be wrong errors. In a macro,
 * a loop or an included file the same error would come again. */
static bool makes_sense(const pov_reader *in)
{
    return in->error.status == POV_E_SYNTAX && !in->failed_in_directive && in->frames.count == 1 && !in->heap.is_full &&
           in->error_count + 1 < RECOVER_ERRORS_MAX;
}

/* A word that can only stand at the beginning of a statement here. */
static bool begins_statement(const token *t)
{
    static const keyword_id others[] = {
        KEYWORD_BACKGROUND, KEYWORD_CAMERA, KEYWORD_DIFFERENCE, KEYWORD_FOG, KEYWORD_GLOBAL_SETTINGS, KEYWORD_INTERSECTION,
        KEYWORD_LIGHT_GROUP, KEYWORD_LIGHT_SOURCE, KEYWORD_MERGE, KEYWORD_OBJECT, KEYWORD_RAINBOW, KEYWORD_SKY_SPHERE, KEYWORD_UNION,
    };

    if (t->kind != TOKEN_WORD)
        return false;
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        if (t->symbol->id == others[i])
            return true;
    return (t->symbol->flags & KEYWORD_FLAG_SHAPE) != 0;
}

/* Skip to where no brace is open, and a statement or a directive begins. The token at which the reader failed was fetched
 * before; `depth` braces are open in front of it. False: that is not to be found. */
static bool skip_statement(pov_reader *in, token *t, size_t depth)
{
    bool is_closed = false;
    int conditions = 0;

    for (;; frame_fetch(in, t)) {
        if (t->kind == TOKEN_END || t->kind == TOKEN_LEAVE || (t->kind == TOKEN_BAD && !t->fault))
            return t->kind == TOKEN_END && depth == 0 && conditions == 0;
        if (depth == 0 && conditions == 0 && (t->kind == '#' || (is_closed && t->kind != '}') || begins_statement(t)))
            return true;
        if (t->kind == '{') {
            depth++;
        } else if (t->kind == '}') {
            depth -= depth > 0;
            is_closed = depth == 0;
        } else if (t->kind == '#') {
            frame_fetch(in, t);
            conditions += directive_nesting(t);
            if (conditions < 0)
                return false;
        }
    }
}

static void begin_anew(pov_reader *in, const token *t)
{
    in->failed = false;
    in->block = NULL;
    in->nesting = in->depth = in->parentheses = 0;
    in->plugin_braces = 0;
    in->arguments.count = 0;
    in->wants_name = false;
    in->wanted = "a value";
    in->tried_count = 0;
    in->token = *t;
    state_look(in);
    state_settle(in);
}

bool recover(pov_reader *in)
{
    token t = in->failed_at;

    if (!makes_sense(in) || !skip_statement(in, &t, in->failed_depth))
        return false;
    if (in->error_count++ == 0)
        in->first_error = in->error;
    env_log(in->model->env, POV_LOG_ERROR, &in->error);
    begin_anew(in, &t);
    return true;
}

void recover_finish(pov_reader *in)
{
    if (in->error_count == 0)
        return;
    if (in->failed)
        env_log(in->model->env, POV_LOG_ERROR, &in->error);
    in->error = in->first_error;
    in->failed = true;
}
