#include "sdl/macro.h"

#include "base/vec.h"
#include "sdl/declare.h"
#include "sdl/directive.h"
#include "sdl/expression.h"
#include "sdl/frame.h"
#include "sdl/limit.h"
#include "sdl/report.h"

enum { PARAMETERS_MAX = 256 };

/* ---- definition ---- */

static int read_parameters(pov_reader *in, symbol **out)
{
    int n = 0;

    state_open(in, '(');
    while (in->token.kind != ')' && !in->failed) {
        if (in->token.kind != TOKEN_WORD || in->token.symbol->id != KEYWORD_OTHER)
            report_expected(in, "the name of a parameter");
        else if (n == PARAMETERS_MAX)
            report_fail(in, &in->token.at, POV_E_SYNTAX, "a macro has at most %d parameters", PARAMETERS_MAX);
        if (in->failed)
            break;
        out[n++] = in->token.symbol;
        state_advance(in);
        state_accept(in, ',');
    }
    if (state_require(in, ')'))
        in->nesting--;
    return n;
}

/* Most macros of included files are never called: their bodies stay text. */
static void skip_body(pov_reader *in, macro *m)
{
    source *text = in->top->text;
    bool is_directive = false;
    size_t depth = 1;
    token t;

    m->text = text;
    m->begin = *text;
    while (depth > 0 && !in->failed) {
        if (!is_directive)
            lex_skip(text);
        lex_next(&in->words, text, &t);
        if (t.kind == TOKEN_END)
            report_fail(in, &m->at, POV_E_SYNTAX, "there is no \"#end\" for this");
        else if (is_directive)
            depth += (size_t)directive_nesting(&t);
        is_directive = t.kind == '#';
    }
    m->behind = text->at;
}

bool macro_lex(pov_reader *in, macro *m)
{
    source *text = m->text, now;
    token_buffer *b;
    token t;

    if (m->tokens)
        return true;
    now = *text;
    *text = m->begin;
    b = token_buffer_create(&in->buffers);
    while (b && text->at < m->behind) {
        lex_next(&in->words, text, &t);
        if ((t.kind == TOKEN_BAD && !t.fault) || !token_buffer_add(&in->buffers, b, &t)) {
            token_buffer_release(&in->buffers, b);
            b = NULL;
        }
    }
    *text = now;
    m->tokens = b;
    m->end = b ? b->count - 2 : 0;
    if (!b)
        report_memory(in);
    return b;
}

/* The body is what stands up to the #end that belongs to it. */
static void find_body(pov_reader *in, macro *m)
{
    if (in->top->text) {
        skip_body(in, m);
        return;
    }
    m->tokens = in->top->tokens;
    m->tokens->uses++;
    m->start = in->top->at;
    directive_skip_all(in, &m->at, 1);
    m->end = in->failed ? m->start : in->top->at - 2;
}

static macro *create(pov_reader *in, const place *at, int count, symbol *const *parameters)
{
    macro *m = in->failed ? NULL : value_share(&in->heap, VALUE_MACRO, sizeof *m + (size_t)count * sizeof *parameters);
    int i;

    if (!m) {
        report_memory(in);
        return NULL;
    }
    m->buffers = &in->buffers;
    m->at = *at;
    m->number = ++in->macros;
    m->count = count;
    for (i = 0; i < count; i++)
        m->parameters[i] = parameters[i];
    return m;
}

void macro_define(pov_reader *in, const place *at)
{
    symbol *parameters[PARAMETERS_MAX], *name;
    const value *old;
    value v;
    macro *m;
    int count;

    in->wants_name = true;
    state_advance(in);
    name = in->token.symbol;
    if (in->token.kind != TOKEN_WORD || name->id != KEYWORD_OTHER) {
        report_expected(in, "the name of a macro");
        in->wants_name = false;
        return;
    }
    old = scope_value(name);
    if (old && old->kind != VALUE_MACRO)
        report_fail(in, &in->token.at, POV_E_SYNTAX, "\"%s\" is %s already", name->name, value_name(old));
    state_advance(in);
    count = read_parameters(in, parameters);
    in->wants_name = false;
    m = create(in, at, count, parameters);
    if (!m)
        return;
    find_body(in, m);
    v.kind = VALUE_MACRO;
    v.is_colour = false;
    v.size = 0;
    v.as.shared = &m->head;
    scope_declare(in, name, v);
    directive_step(in);
}

/* ---- call ---- */

/* A lone name or element of an array goes as itself: the macro can change it. All else is a value. */
static void read_name(pov_reader *in, argument *out)
{
    binding *b = in->token.symbol->binding;
    const place at = in->token.at;
    value v;

    out->slot = b->slot;
    out->lender = b->lender ? b->lender : &b->head;
    out->lender->uses++;
    in->value = at;
    state_advance(in);
    out->slot = expression_element(in, out->slot, &out->lender);
    if (out->slot && out->slot->kind == VALUE_NOTHING)
        report_fail(in, &at, POV_E_SYNTAX, "this element has no value yet");
    if (in->failed || (!expression_goes_on(in) && in->token.kind != '('))
        return;
    v = expression_call(in, value_keep(*out->slot));
    v = expression_go_on(in, v);
    out->value = v.kind == VALUE_NUMBER ? value_of_number(v.as.v[0]) : v;   /* of a component its vector goes */
    value_unshare(&in->heap, out->lender);
    out->lender = NULL;
}

static argument read_argument(pov_reader *in)
{
    static const argument none;
    argument a = none;

    state_settle(in);
    if (in->token.kind == TOKEN_WORD && in->token.symbol->binding)
        read_name(in, &a);
    else
        a.value = declare_value(in);
    return a;
}

static void drop_arguments(pov_reader *in, size_t base)
{
    while (in->arguments.count > base) {
        argument *a = &in->arguments.items[--in->arguments.count];

        if (a->lender)
            value_unshare(&in->heap, a->lender);
        value_drop(&in->heap, &a->value);
    }
}

static void read_arguments(pov_reader *in, const symbol *name, const macro *m)
{
    int i;

    state_open(in, '(');
    for (i = 0; i < m->count && !in->failed; i++) {
        argument a;

        if (in->token.kind == ')') {
            report_fail(in, &in->token.at, POV_E_SYNTAX, "\"%s\" wants %d argument%s, found %d", name->name, m->count,
                        m->count == 1 ? "" : "s", i);
            return;
        }
        a = read_argument(in);
        if (!VEC_PUSH(in->model->env, &in->arguments, a))
            report_memory(in);
        state_accept(in, ',');
    }
    if (state_require(in, ')'))
        in->nesting--;
}

static void bind(pov_reader *in, const macro *m, size_t base)
{
    const size_t level = in->scopes.count - 1;
    int i;

    for (i = 0; i < m->count && !in->failed; i++) {
        argument *a = &in->arguments.items[base + (size_t)i];

        if (a->lender) {
            scope_lend(in, m->parameters[i], a->slot, a->lender);
        } else {
            scope_local(in, m->parameters[i], level, a->value);
            a->value.kind = VALUE_NOTHING;
        }
    }
}

static void begin(pov_reader *in, const symbol *name, macro *m, size_t base, const place *call)
{
    frame *f;

    if (in->failed || !macro_lex(in, m) || !scope_push(in))
        return;
    bind(in, m, base);
    f = in->failed ? NULL : frame_push_tokens(in, FRAME_MACRO, m->tokens, m->start, m->end);
    if (!f)
        return;
    f->name = name;
    f->call = *call;
}

void macro_call(pov_reader *in)
{
    symbol *name = in->token.symbol;
    value v = value_keep(*name->binding->slot);
    macro *m = (macro *)v.as.shared;
    const size_t base = in->arguments.count;
    const place call = in->token.at;

    if (in->scopes.count > in->limits.depth)
        report_fail(in, &call, POV_E_SYNTAX, "more than %zu macros and include files within each other",
                    in->limits.depth);
    limit_turn(in, &call);
    if (state_enter(in)) {
        state_advance(in);
        read_arguments(in, name, m);
        begin(in, name, m, base, &call);
    }
    state_exit(in);
    drop_arguments(in, base);
    value_drop(&in->heap, &v);
    directive_step(in);
}
