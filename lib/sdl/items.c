#include "sdl/items.h"

#include "sdl/expression.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"

#include <stdio.h>

void items_open(pov_reader *in, block *b)
{
    b->keyword = in->last;
    b->brace = in->token.at;
    b->outer = in->block;
    if (in->token.kind == '{')
        in->block = b;
    state_open(in, '{');
}

static bool is_listed(const keyword_id *list, keyword_id keyword)
{
    for (; list && *list != KEYWORD_OTHER; list++)
        if (*list == keyword)
            return true;
    return false;
}

static bool leads_to(const value *v, value_kind kind)
{
    while (v && v->kind == VALUE_ARRAY && value_array(v)->kind != kind)
        v = value_array(v)->kind == VALUE_ARRAY ? &value_array(v)->items[0] : NULL;
    return v && (v->kind == VALUE_ARRAY || v->kind == kind);
}

bool items_name_follows(const pov_reader *in, value_kind kind)
{
    return in->token.kind == TOKEN_WORD && leads_to(scope_value(in->token.symbol), kind);
}

bool items_read_named(pov_reader *in, value_kind kind, value *out)
{
    const place at = in->token.at;

    if (!items_name_follows(in, kind))
        return false;
    *out = expression_read(in);
    if (!in->failed && out->kind != kind)
        report_fail(in, &at, POV_E_SYNTAX, "expected %s, found %s", value_kind_name(kind), value_name(out));
    if (value_is_shared(out))
        value_drop(&in->heap, out);
    return true;
}

static bool take_name(pov_reader *in, const item_list *list, void *self)
{
    value v;

    if (!list->take || !items_read_named(in, list->takes, &v))
        return false;
    if (!in->failed)
        list->take(in, self, &v);
    return true;
}

bool items_try(pov_reader *in, const item_list *list, void *self)
{
    keyword_id keyword = state_keyword(in);
    size_t i;

    if (keyword == KEYWORD_OTHER)
        return in->token.kind == TOKEN_WORD && take_name(in, list, self);
    for (i = 0; i < list->count; i++) {
        if (list->items[i].keyword == keyword) {
            state_advance(in);
            list->items[i].read(in, self, keyword);
            return true;
        }
    }
    if (is_listed(list->quiet, keyword) || is_listed(list->quiet_too, keyword))
        unsupported_skip_item(in);
    else if (is_listed(list->coming, keyword))
        unsupported_item(in);
    else
        return false;
    return true;
}

void items_refuse(pov_reader *in, const item_list *list)
{
    char wanted[128];
    guess g;
    size_t i;

    report_guess_start(&g, in);
    for (i = 0; i < list->count; i++)
        report_guess_try(&g, token_keyword_name(list->items[i].keyword));
    snprintf(wanted, sizeof wanted, "%s or \"}\"", list->wanted);
    report_misplaced(in, wanted, &g);
}

/* Names of other parts stand for all that was read before, so that they come first. */
static bool comes_too_late(const pov_reader *in, const item_list *list)
{
    return list->take && list->takes != VALUE_TRANSFORM && list->takes != VALUE_VECTOR && items_name_follows(in, list->takes);
}

void items_until(pov_reader *in, int end, const item_list *list, void *self)
{
    for (bool is_first = true; !in->failed && in->token.kind != end; is_first = false)
        if ((!is_first && comes_too_late(in, list)) || !items_try(in, list, self))
            items_refuse(in, list);
}

void items_close(pov_reader *in, block *b, const item_list *list, void *self)
{
    items_until(in, '}', list, self);
    in->block = b->outer;
    state_close(in, '}');
}

void items_block(pov_reader *in, const item_list *list, void *self)
{
    block b;

    items_open(in, &b);
    items_close(in, &b, list, self);
}
