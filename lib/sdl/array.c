#include "sdl/array.h"

#include "sdl/declare.h"
#include "sdl/expression.h"
#include "sdl/report.h"

#include <string.h>

static value of(array *a)
{
    value v = value_of_number(0.0);

    if (a) {
        v.kind = VALUE_ARRAY;
        v.as.shared = &a->head;
    }
    return v;
}

static array *create(pov_reader *in, int dimensions, const size_t *sizes)
{
    size_t count = 1;
    array *a;
    int i;

    for (i = 0; i < dimensions && !in->failed; i++) {
        if (sizes[i] > in->limits.array / count)
            report_fail(in, &in->value, POV_E_SYNTAX, "an array of more than %zu elements", in->limits.array);
        count *= sizes[i];
    }
    if (in->failed)
        return NULL;
    a = value_share(&in->heap, VALUE_ARRAY, sizeof *a + count * sizeof a->items[0]);
    if (!a) {
        report_memory(in);
        return NULL;
    }
    a->dimensions = dimensions;
    a->count = count;
    memcpy(a->sizes, sizes, (size_t)dimensions * sizeof *sizes);
    return a;
}

/* ---- elements ---- */

static size_t subscript(pov_reader *in, size_t size)
{
    double number;

    state_open(in, '[');
    in->value = in->token.at;
    number = expression_number(in) + EXPRESSION_NEAR;
    if (!in->failed && !(number >= 0.0 && number < (double)size))
        report_fail(in, &in->value, POV_E_SYNTAX, "the subscript %g lies outside of 0 to %zu", number, size - 1);
    state_close(in, ']');
    return in->failed ? 0 : (size_t)number;
}

value *array_slot(pov_reader *in, array *a)
{
    size_t index = 0;
    int i;

    for (i = 0; i < a->dimensions && !in->failed; i++)
        index = index * a->sizes[i] + subscript(in, a->sizes[i]);
    return in->failed ? NULL : &a->items[index];
}

void array_set(pov_reader *in, array *a, value *slot, value v)
{
    value old = *slot;

    if (!in->failed && a->kind == VALUE_NOTHING) {
        a->kind = v.kind;
        a->size = v.size;
    } else if (!in->failed && (a->kind != v.kind || (v.kind == VALUE_VECTOR && a->size != v.size))) {
        report_fail(in, &in->value, POV_E_SYNTAX, "all elements of an array are of one kind: %s, not %s",
                    value_kind_name(a->kind), value_name(&v));
    }
    if (in->failed) {
        value_drop(&in->heap, &v);
        return;
    }
    *slot = v;
    value_drop(&in->heap, &old);
}

value array_copy(pov_reader *in, const array *a)
{
    array *copy = create(in, a->dimensions, a->sizes);
    size_t i;

    if (!copy)
        return of(NULL);
    copy->kind = a->kind;
    copy->size = a->size;
    for (i = 0; i < a->count && !in->failed; i++)
        copy->items[i] = a->items[i].kind == VALUE_ARRAY ? array_copy(in, value_array(&a->items[i]))
                                                         : value_keep(a->items[i]);
    return of(copy);
}

/* ---- initialisers ---- */

static void fill(pov_reader *in, array *a, int dimension, size_t *at)
{
    size_t i;

    state_open(in, '{');
    for (i = 0; dimension < ARRAY_DIMENSIONS && i < a->sizes[dimension] && !in->failed; i++) {
        if (dimension + 1 < a->dimensions)
            fill(in, a, dimension + 1, at);
        else
            array_set(in, a, &a->items[(*at)++], declare_value(in));
        state_accept(in, ',');
    }
    state_close(in, '}');
}

static int read_sizes(pov_reader *in, size_t sizes[ARRAY_DIMENSIONS])
{
    int n = 0;
    double size;

    while (in->token.kind == '[' && !in->failed) {
        state_open(in, '[');
        in->value = in->token.at;
        size = expression_number(in) + EXPRESSION_NEAR;
        if (n == ARRAY_DIMENSIONS)
            report_fail(in, &in->value, POV_E_SYNTAX, "an array has at most %d dimensions", ARRAY_DIMENSIONS);
        else if (!(size >= 1.0))
            report_fail(in, &in->value, POV_E_SYNTAX, "an array has at least one element");
        else
            sizes[n++] = size < (double)in->limits.array ? (size_t)size : in->limits.array + 1;
        state_close(in, ']');
    }
    return n;
}

value array_read(pov_reader *in)
{
    size_t sizes[ARRAY_DIMENSIONS], at = 0;
    array *a;
    int n = read_sizes(in, sizes);

    if (n == 0)
        report_expected(in, "\"[\" and the size of the array");
    a = create(in, n, sizes);
    if (a && in->token.kind == '{')
        fill(in, a, 0, &at);
    return of(a);
}

/* ---- is it there? ---- */

static bool names_something(pov_reader *in)
{
    symbol *name = in->token.symbol;
    shared *lender;
    value *slot;
    bool is_there;

    in->wants_name = false;
    if (in->token.kind == ')' || in->token.kind == TOKEN_END) {
        report_expected(in, "a name");
        return false;
    }
    if (in->token.kind != TOKEN_WORD || !name || !name->binding) {
        state_advance(in);
        return false;
    }
    slot = name->binding->slot;
    lender = name->binding->lender ? name->binding->lender : &name->binding->head;
    lender->uses++;
    state_advance(in);
    slot = expression_element(in, slot, &lender);
    is_there = slot && slot->kind != VALUE_NOTHING;
    value_unshare(&in->heap, lender);
    return is_there;
}

bool array_reads_defined(pov_reader *in)
{
    bool is_there;

    in->wants_name = true;
    state_open(in, '(');
    is_there = names_something(in);
    in->wants_name = false;
    state_require(in, ')');
    return is_there;
}

bool array_is_defined(pov_reader *in)
{
    bool is_there = array_reads_defined(in);

    state_close(in, ')');
    return is_there;
}
