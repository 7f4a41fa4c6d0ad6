#include "sdl/declare.h"

#include "sdl/array.h"
#include "sdl/directive.h"
#include "sdl/expression.h"
#include "sdl/parse.h"
#include "sdl/report.h"

#include <string.h>

/* ---- values ---- */

/* A word of colours is next. */
static value read_colour(pov_reader *in)
{
    value v = value_of_number(0.0);

    v.kind = VALUE_VECTOR;
    v.size = 5;
    v.is_colour = true;
    value_colour_any(in, false, v.as.v);
    return in->failed ? value_of_number(0.0) : v;
}

/* What begins with the name of a colour may be another value: `C.red`. */
static value read_expression(pov_reader *in)
{
    const char *wanted = in->wanted;
    value v;

    in->wanted = "a value";
    v = expression_read(in);
    in->wanted = wanted;
    return v;
}

/* What a name stands for is copied; arrays are all that could be changed through it. Of a component its vector goes. */
static value own(pov_reader *in, value v)
{
    value copy;

    if (v.kind == VALUE_NUMBER)
        return value_of_number(v.as.v[0]);
    if (v.kind != VALUE_ARRAY || v.as.shared->uses == 1 || in->failed)
        return v;
    copy = array_copy(in, value_array(&v));
    value_drop(&in->heap, &v);
    return copy;
}

value declare_value(pov_reader *in)
{
    value v = value_of_number(0.0);

    state_settle(in);
    in->value = in->token.at;
    if (in->token.kind == TOKEN_WORD && (in->token.symbol->flags & KEYWORD_FLAG_PAINT))
        return read_colour(in);
    if (in->token.kind == TOKEN_WORD && !in->token.symbol->intrinsic && !in->token.symbol->binding &&
        parse_value(in, &v))
        return v;
    return own(in, read_expression(in));
}

/* ---- names ---- */

/* The name that is next, which is not taken. NULL: the reader has failed. */
static symbol *read_name(pov_reader *in)
{
    in->wants_name = true;
    state_advance(in);
    in->wants_name = false;
    if (in->token.kind == TOKEN_BAD)
        state_settle(in);
    if (in->failed)
        return NULL;
    if (in->token.kind != TOKEN_WORD) {
        report_expected(in, "a name");
        return NULL;
    }
    if (in->token.symbol->id != KEYWORD_OTHER) {
        report_fail(in, &in->token.at, POV_E_SYNTAX, "\"%s\" is a word of the language, and no name",
                    in->token.symbol->name);
        return NULL;
    }
    return in->token.symbol;
}

static bool refuse_fixed(pov_reader *in, const symbol *name)
{
    const value *v = scope_value(name);

    if (v && (v->kind == VALUE_MACRO || v->kind == VALUE_FUNCTION))
        report_fail(in, &in->token.at, POV_E_SYNTAX, "\"%s\" is %s; \"#undef %s\" makes the name free", name->name,
                    value_name(v), name->name);
    return in->failed;
}

static void end_value(pov_reader *in, bool is_plain)
{
    if (!is_plain) {
        state_accept(in, ';');
    } else if (in->token.kind == ';') {
        state_advance(in);
        state_accept(in, ';');
    } else if (in->version == 0.0 || in->version >= 3.5) {
        report_expected(in, "\";\"");
    } else if (!in->failed) {
        report_warn(in, &in->token.at, "a \";\" is missing behind the value");
    }
}

static bool is_plain(const value *v)
{
    return v->kind == VALUE_NUMBER || v->kind == VALUE_VECTOR;
}

/* An array from further out is another one's, but for a parameter: #local sets nothing in it. */
static bool is_anothers(const symbol *name, size_t level)
{
    const binding *b = name->binding;

    return b->level < level && !b->lender && b->slot->kind == VALUE_ARRAY;
}

static void set_element(pov_reader *in, symbol *name, bool is_local, size_t level)
{
    shared *lender;
    value *slot, v;
    bool plain;

    slot = name->binding->slot;
    lender = name->binding->lender ? name->binding->lender : &name->binding->head;
    lender->uses++;
    slot = expression_element(in, slot, &lender);
    state_expect(in, '=');
    v = declare_value(in);
    plain = is_plain(&v);
    if (slot && lender->kind == VALUE_ARRAY && !(is_local && is_anothers(name, level)))
        array_set(in, (array *)lender, slot, v);
    else
        value_drop(&in->heap, &v);
    value_unshare(&in->heap, lender);
    end_value(in, plain);
}

/* A function takes no name that stands for something else. */
static void refuse_function(pov_reader *in, const symbol *name, const value *v)
{
    const value *old = scope_value(name);

    if (!in->failed && old && v->kind == VALUE_FUNCTION && old->kind != VALUE_FUNCTION)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"%s\" is %s; \"#undef %s\" makes the name free", name->name,
                    value_name(old), name->name);
}

/* Macros of the value may still run when it has been read, with a name like this of their own. */
static void set(pov_reader *in, symbol *name, bool is_local, size_t level)
{
    const size_t target = is_local ? level : name->binding ? name->binding->level : 0;
    const symbol *outer = in->declaring;
    bool plain;
    value v;

    state_expect(in, '=');
    in->declaring = name;
    v = declare_value(in);
    in->declaring = outer;
    plain = is_plain(&v);
    refuse_function(in, name, &v);
    if (in->failed)
        value_drop(&in->heap, &v);
    else
        scope_local(in, name, target, v);
    end_value(in, plain);
}

/* `deprecated [once] [version,] ["message",] NAME`: the message is for who uses the name; the declaration counts. */
static symbol *skip_deprecated(pov_reader *in, symbol *name)
{
    if (!name || name->length != 10 || strcmp(name->name, "deprecated") != 0)
        return name;
    in->wants_name = true;
    state_advance(in);
    while (!in->failed && (in->token.kind == TOKEN_STRING || in->token.kind == TOKEN_NUMBER || in->token.kind == ',' ||
                           state_keyword(in) == KEYWORD_ONCE))
        state_advance(in);
    in->wants_name = false;
    if (in->token.kind == TOKEN_WORD && in->token.symbol->id == KEYWORD_OTHER)
        return in->token.symbol;
    report_expected(in, "a name");
    return NULL;
}

void declare_run(pov_reader *in, const place *at)
{
    const bool is_local = in->token.symbol->id == KEYWORD_LOCAL;
    const size_t level = in->scopes.count - 1;
    symbol *name = skip_deprecated(in, read_name(in));

    (void)at;
    if (!name || refuse_fixed(in, name))
        return;
    state_advance(in);
    if (in->token.kind == '[' && name->binding)
        set_element(in, name, is_local, level);
    else
        set(in, name, is_local, level);
}

static void forget_element(pov_reader *in, symbol *name)
{
    value *slot = name->binding->slot;
    shared *lender = name->binding->lender ? name->binding->lender : &name->binding->head;

    lender->uses++;
    slot = expression_element(in, slot, &lender);
    if (slot)
        value_drop(&in->heap, slot);
    value_unshare(&in->heap, lender);
}

void declare_forget(pov_reader *in, const place *at)
{
    symbol *name = read_name(in);

    if (!name)
        return;
    if (!name->binding)
        report_warn(in, at, "\"%s\" is not declared", name->name);
    state_advance(in);
    if (name->binding && in->token.kind == '[')
        forget_element(in, name);
    else
        scope_forget(in, name);
    state_accept(in, ';');
}
