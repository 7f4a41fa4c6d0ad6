#include "sdl/frame.h"

#include "base/vec.h"
#include "sdl/directive.h"
#include "sdl/report.h"

static frame *push(pov_reader *in, const frame *f)
{
    if (!VEC_PUSH(in->model->env, &in->frames, *f)) {
        report_memory(in);
        return NULL;
    }
    in->top = &in->frames.items[in->frames.count - 1];
    return in->top;
}

static frame fresh(const pov_reader *in, frame_kind kind)
{
    static const frame none;
    frame f = none;

    f.kind = kind;
    f.call = in->last;
    f.conditions = in->conditions.count;
    return f;
}

frame *frame_push_text(pov_reader *in, frame_kind kind, source *text)
{
    frame f = fresh(in, kind);

    f.text = text;
    return push(in, &f);
}

void frame_begin_text(pov_reader *in, const char *text, size_t length, const char *name)
{
    static const token none;
    source *s = source_add(&in->sources, text, length, name);

    if (!s) {
        report_memory(in);
    } else if (in->frames.count == 0) {
        frame_push_text(in, FRAME_SCENE, s);
    } else {
        in->top->text = s;
        in->token = none;
    }
}

frame *frame_push_tokens(pov_reader *in, frame_kind kind, token_buffer *tokens, size_t at, size_t end)
{
    frame f = fresh(in, kind);

    f.tokens = tokens;
    f.at = at;
    f.end = end;
    tokens->uses++;
    return push(in, &f);
}

void frame_pop(pov_reader *in)
{
    if (in->top->tokens)
        token_buffer_release(&in->buffers, in->top->tokens);
    in->frames.count--;
    in->top = in->frames.count > 0 ? &in->frames.items[in->frames.count - 1] : NULL;
}

/* The place of a LEAVE is that of the last token. */
static void leave(const pov_reader *in, token *out)
{
    static const token none;
    const frame *f = in->top;

    if (f->tokens) {
        *out = none;
        out->at = f->end > 0 ? f->tokens->items[f->end - 1].at : f->call;
        out->at.length = 0;
    }
    out->kind = TOKEN_LEAVE;
}

void frame_fetch(pov_reader *in, token *out)
{
    for (;;) {
        frame *f = in->top;

        if (f->has_saved) {
            *out = f->saved;
            f->has_saved = false;
            return;
        }
        if (f->text) {
            lex_next(&in->words, f->text, out);
            if (out->kind != TOKEN_END || f->kind == FRAME_SCENE)
                return;
        } else if (f->at < f->end) {
            *out = f->tokens->items[f->at++];
            return;
        }
        if (f->kind != FRAME_LOOP) {
            leave(in, out);
            return;
        }
        frame_pop(in);
    }
}

void frame_save(pov_reader *in)
{
    in->top->saved = in->token;
    in->top->has_saved = true;
}

token_buffer *frame_capture(pov_reader *in)
{
    token_buffer *b = token_buffer_create(&in->buffers);
    bool is_directive = false;
    size_t depth = 1;
    token t;

    while (b && depth > 0) {
        frame_fetch(in, &t);
        if (t.kind == TOKEN_END || t.kind == TOKEN_LEAVE)
            return b;
        if ((t.kind == TOKEN_BAD && !t.fault) || !token_buffer_add(&in->buffers, b, &t))
            break;
        if (is_directive)
            depth += (size_t)directive_nesting(&t);
        is_directive = t.kind == '#';
    }
    if (b && depth == 0)
        return b;
    report_memory(in);
    if (b)
        token_buffer_release(&in->buffers, b);
    return NULL;
}
