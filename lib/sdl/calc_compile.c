#include "sdl/builder.h"
#include "sdl/expression.h"
#include "sdl/function.h"

#include <string.h>

/* ---- names ---- */

uint16_t builder_name(builder *b, calc_name n)
{
    uint16_t i;

    for (i = 0; i < b->calc.names; i++)
        if (b->name[i].symbol == n.symbol)
            return i;
    if (i == BUILDER_NAMES) {
        builder_refuse(b);
        return 0;
    }
    if (n.kind == VALUE_NUMBER || n.kind == VALUE_VECTOR)
        n.to = builder_registers(b, n.kind == VALUE_NUMBER ? 1 : CALC_COMPONENTS);
    b->name[b->calc.names++] = n;
    return i;
}

static term element(builder *b, symbol *name, const array *a)
{
    calc_name n = { name, VALUE_ARRAY, false, (uint16_t)a->dimensions, a->size, NULL };
    const uint16_t at = builder_registers(b, 1);
    uint16_t to, index;
    int i;

    n.is_colour = a->kind == VALUE_VECTOR && a->items[0].kind == VALUE_VECTOR && a->items[0].is_colour;
    if (a->kind != VALUE_NUMBER && a->kind != VALUE_VECTOR)
        return builder_refuse(b);
    index = builder_name(b, n);
    for (i = 0; i < a->dimensions; i++) {
        builder_expect(b, '[');
        builder_emit_to(b, CALC_SUBSCRIPT, at, builder_number(b), index, (uint16_t)i);
        builder_expect(b, ']');
    }
    to = builder_registers(b, a->kind == VALUE_NUMBER ? 1 : CALC_COMPONENTS);
    builder_emit_to(b, CALC_ELEMENT, to, at, index, 0);
    if (a->kind == VALUE_NUMBER)
        return builder_number_in(to);
    return builder_vector_in(to, a->size, n.is_colour, CALC_COMPONENTS);
}

static term call(builder *b, symbol *name, const function *f)
{
    const calc_name n = { name, VALUE_FUNCTION, false, 0, 0, f };
    const uint32_t count = f->program.parameters;
    uint16_t a[CALC_ARGUMENTS], index = builder_name(b, n);
    uint32_t i;

    if (f->kind != FUNCTION_FORMULA || f->program.capacity > CALC_ARGUMENTS || !builder_is_next(b, '('))
        return builder_refuse(b);
    builder_expect(b, '(');
    for (i = 0; i < count && !b->is_refused; i++) {
        a[i] = builder_number(b);
        if (i + 1 < count)
            builder_accept(b, ',');
    }
    builder_expect(b, ')');
    for (i = 0; i < count && !b->is_refused; i++)
        builder_emit_to(b, CALC_ARGUMENT, 0, a[i], (uint16_t)i, 0);
    return builder_number_in(builder_emit(b, CALC_CALL, 0, index, 0));
}

static term identifier(builder *b, symbol *name)
{
    const value *v = name->binding->slot;
    calc_name n = { name, v->kind, v->is_colour, 0, v->size, NULL };

    switch (v->kind) {
    case VALUE_NUMBER:
        return builder_number_in(b->name[builder_name(b, n)].to);
    case VALUE_VECTOR:
        return builder_vector_in(b->name[builder_name(b, n)].to, v->size, v->is_colour, CALC_COMPONENTS);
    case VALUE_ARRAY:
        return element(b, name, value_array(v));
    case VALUE_FUNCTION:
        return call(b, name, v->as.part);
    default:
        return builder_refuse(b);
    }
}

/* ---- operands ---- */

static term literal(builder *b)
{
    term t = { VALUE_VECTOR, false, false, 0, { 0 } };

    do {
        t.reg[t.size++] = builder_number(b);
        builder_accept(b, ',');
    } while (t.size < CALC_COMPONENTS && !b->is_refused && (t.size < 2 || !builder_is_next(b, '>')));
    builder_expect(b, '>');
    return t;
}

static term builder_word(builder *b, symbol *name)
{
    const local *l = builder_find_local(b, name);

    if (l)
        return l->term;
    if (name->intrinsic)
        return builder_function(b, name->intrinsic);
    if (name->binding && name->binding->slot->kind == VALUE_MACRO)
        return builder_insert(b, name, (macro *)name->binding->slot->as.shared);
    return name->binding ? identifier(b, name) : builder_refuse(b);
}

static term primary(builder *b)
{
    const token *t = builder_next(b);
    term inner;

    b->s->at++;
    switch (t->kind) {
    case TOKEN_NUMBER:
        return t->fault ? builder_refuse(b) : builder_number_in(builder_constant(b, t->number));
    case '<':
        return literal(b);
    case '(':
        inner = builder_full(b);
        builder_expect(b, ')');
        inner.is_part = false;
        return inner;
    case TOKEN_WORD:
        return builder_word(b, t->symbol);
    default:
        return builder_refuse(b);
    }
}

static term dots(builder *b, term t)
{
    while (builder_is_next(b, '.') && !b->is_refused) {
        int i;

        b->s->at++;
        i = builder_is_next(b, TOKEN_WORD) ? expression_component(builder_next(b)->symbol->id) : -1;
        if (i < 0 || (i == EXPRESSION_GRAY ? t.size < 3 : i >= t.size))
            return builder_refuse(b);
        b->s->at++;
        t.reg[0] = i == EXPRESSION_GRAY ? builder_emit(b, CALC_GRAY, t.reg[0], t.reg[1], t.reg[2]) : t.reg[i];
        t.is_part = t.is_part || t.kind == VALUE_VECTOR;
        t.kind = VALUE_NUMBER;
        t.is_colour = false;
        t.size = 1;
    }
    return t;
}

term builder_operand(builder *b)
{
    bool is_negated = false;
    int i, nots = 0;
    term t;

    if (b->depth == BUILDER_DEEPEST || b->is_refused)
        return builder_refuse(b);
    b->depth++;
    for (; builder_is_next(b, '-') || builder_is_next(b, '+') || builder_is_next(b, '!'); b->s->at++) {
        if (builder_is_next(b, '!'))
            nots++;
        else if (builder_is_next(b, '-') && nots == 0)
            is_negated = !is_negated;
    }
    t = dots(b, primary(b));
    for (i = 0; i < t.size; i++) {
        if (nots > 0)
            t.reg[i] = builder_emit(b, nots % 2 == 0 ? CALC_TRUE : CALC_NOT, t.reg[i], 0, 0);
        if (is_negated)
            t.reg[i] = builder_emit(b, CALC_NEGATE, t.reg[i], 0, 0);
    }
    b->depth--;
    return t;
}

/* ---- operators ---- */

/* A number fills all components of the other operand; behind a shorter vector stand zeros. */
static uint16_t component(const term *t, int i)
{
    return t->kind == VALUE_NUMBER ? t->reg[0] : i < t->size ? t->reg[i] : 0;
}

static term combine(builder *b, calc_op op, term a, term second)
{
    const int size = a.size > second.size ? a.size : second.size;
    term t = a;
    int i;

    t.kind = a.kind == VALUE_NUMBER && second.kind == VALUE_NUMBER ? VALUE_NUMBER : VALUE_VECTOR;
    t.size = size;
    if (t.kind == VALUE_VECTOR && a.kind == VALUE_NUMBER)
        memset(t.reg, 0, sizeof t.reg);
    t.is_colour = t.kind == VALUE_VECTOR && (a.is_colour || second.is_colour);
    t.is_part = t.kind == VALUE_NUMBER && a.is_part;
    for (i = 0; i < size; i++)
        t.reg[i] = builder_emit(b, op, component(&a, i), component(&second, i), 0);
    return t;
}

/* Of the operators of one level: -1: it is none. */
static int operator_of(int kind, int level)
{
    static const struct { int kind, level; calc_op op; } rows[] = {
        { '*', 0, CALC_MULTIPLY }, { '/', 0, CALC_DIVIDE }, { '+', 1, CALC_ADD }, { '-', 1, CALC_SUBTRACT },
        { '<', 2, CALC_BELOW }, { '>', 2, CALC_ABOVE }, { '=', 2, CALC_EQUAL }, { TOKEN_AT_MOST, 2, CALC_AT_MOST },
        { TOKEN_AT_LEAST, 2, CALC_AT_LEAST }, { TOKEN_UNEQUAL, 2, CALC_UNEQUAL }, { '&', 3, CALC_AND },
        { '|', 3, CALC_OR },
    };
    size_t i;

    for (i = 0; i < sizeof rows / sizeof rows[0]; i++)
        if (rows[i].kind == kind && rows[i].level == level)
            return (int)rows[i].op;
    return -1;
}

static term level(builder *b, int n)
{
    term t = n < 0 ? builder_operand(b) : level(b, n - 1);
    int op;

    while (n >= 0 && !b->is_refused && (op = operator_of(builder_next(b)->kind, n)) >= 0) {
        b->s->at++;
        t = combine(b, (calc_op)op, t, level(b, n - 1));
    }
    return t;
}

term builder_additive(builder *b)
{
    return level(b, 1);
}

/* Both branches are computed, and are of one kind here. */
static term choice(builder *b, term chooser)
{
    const uint16_t is_true = builder_emit(b, CALC_TRUE, builder_to_number(b, chooser), 0, 0);
    term a, otherwise;
    int i;

    a = builder_full(b);
    builder_expect(b, ':');
    otherwise = builder_full(b);
    if (a.kind != otherwise.kind || a.size != otherwise.size || a.is_colour != otherwise.is_colour)
        return builder_refuse(b);
    for (i = 0; i < CALC_COMPONENTS; i++)
        if (a.reg[i] != otherwise.reg[i])
            a.reg[i] = builder_emit(b, CALC_PICK, is_true, a.reg[i], otherwise.reg[i]);
    return a;
}

term builder_full(builder *b)
{
    term t;

    if (b->depth == BUILDER_DEEPEST)
        return builder_refuse(b);
    b->depth++;
    t = level(b, 3);
    if (!b->is_refused && builder_accept(b, '?'))
        t = choice(b, t);
    b->depth--;
    return t;
}

/* ---- the whole ---- */

/* What may stand behind an expression without a say in it: no directive, no name that could be a macro, no end. */
static bool ends(builder *b)
{
    const token *t = builder_next(b);

    if (b->s != b->streams)
        return false;
    if (t->kind == TOKEN_WORD)
        return t->symbol->id != KEYWORD_OTHER;
    return t->kind != '#' && t->kind != TOKEN_END && t->kind != TOKEN_BAD && t->kind != TOKEN_LEAVE;
}

static void *append(unsigned char **to, const void *items, size_t bytes)
{
    unsigned char *at = *to;

    memcpy(at, items, bytes);
    *to += bytes;
    return at;
}

static calc *conclude(builder *b, token_buffer *buffer, const term *t, replay_kind grammar)
{
    const calc *from = &b->calc;
    const size_t constants = from->constants * sizeof *b->constant, names = from->names * sizeof *b->name,
                 rows = from->rows * sizeof(const intrinsic *), steps = from->steps * sizeof *b->step;
    calc *c = token_buffer_keep(&b->in->buffers, buffer, sizeof *c + constants + names + rows + steps);
    unsigned char *to;
    replay *older;

    if (!c)
        return NULL;
    older = c->head.next;
    *c = *from;
    c->head.next = older;
    c->head.kind = grammar;
    c->end = b->streams[0].at;
    c->kind = t->kind;
    c->is_colour = t->is_colour;
    c->is_part = t->is_part;
    c->is_random = b->randoms > 0;
    c->size = t->size;
    memcpy(c->result, t->reg, sizeof c->result);
    to = (unsigned char *)(c + 1);
    c->constant = append(&to, b->constant, constants);
    c->name = append(&to, b->name, names);
    c->row = append(&to, b->row, rows);
    c->step = append(&to, b->step, steps);
    return c;
}

calc *calc_compile(pov_reader *in, token_buffer *buffer, size_t index, replay_kind grammar)
{
    builder b;
    term t;

    b.in = in;
    b.s = b.streams;
    *b.s = (stream){ buffer->items, index, buffer->count, 0, 0 };
    b.locals = 0;
    b.is_refused = false;
    b.depth = b.randoms = 0;
    b.next = CALC_CONSTANTS;
    memset(&b.calc, 0, sizeof b.calc);
    builder_constant(&b, 0.0);
    t = grammar == REPLAY_FULL ? builder_full(&b) : builder_additive(&b);
    return b.is_refused || !ends(&b) ? NULL : conclude(&b, buffer, &t, grammar);
}
