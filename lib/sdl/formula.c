#include "sdl/formula.h"

#include "base/vec.h"
#include "function/internal.h"
#include "sdl/expression.h"
#include "sdl/function_host.h"
#include "sdl/noise.h"
#include "sdl/report.h"
#include "texture/noise_functions.h"

#include <string.h>

/* A name that stands for a register: a parameter, or the variable of a sum. */
typedef struct local { const symbol *name; uint32_t at; } local;

typedef struct local_list { local *items; size_t count, capacity; } local_list;
typedef struct code_list { instruction *items; size_t count, capacity; } code_list;
typedef struct constant_list { double *items; size_t count, capacity; } constant_list;
typedef struct host_list { program_host *items; size_t count, capacity; } host_list;
typedef struct callee_list { const program **items; size_t count, capacity; } callee_list;

typedef struct compiler {
    pov_reader *in;
    local_list locals;
    code_list code;
    constant_list constants;
    callee_list callees;
    host_list hosts;
    uint32_t next, most, capacity;   /* the first free register; behind the last one used; what callees need */
} compiler;

enum { REGISTERS_MAX = 1 << 16 };

static uint32_t full(compiler *c);

/* ---- code ---- */

static uint32_t reserve(compiler *c, uint32_t count)
{
    uint32_t at = c->next;

    if (c->next + count > REGISTERS_MAX)
        report_fail(c->in, &c->in->token.at, POV_E_SYNTAX, "the function is too large");
    else
        c->next += count;
    if (c->next > c->most)
        c->most = c->next;
    return at;
}

static void emit(compiler *c, program_op op, uint32_t to, uint32_t a, uint32_t b)
{
    instruction i = { (uint16_t)op, 0, to, a, b };

    if (!c->in->failed && !VEC_PUSH(c->in->model->env, &c->code, i))
        report_memory(c->in);
}

/* The result takes the first register that the operands took. */
static uint32_t combine(compiler *c, program_op op, uint32_t mark, uint32_t a, uint32_t b)
{
    uint32_t to;

    c->next = mark;
    to = reserve(c, 1);
    emit(c, op, to, a, b);
    return to;
}

static uint32_t constant(compiler *c, double number)
{
    uint32_t to = reserve(c, 1);

    emit(c, PROGRAM_CONSTANT, to, (uint32_t)c->constants.count, 0);
    if (!c->in->failed && !VEC_PUSH(c->in->model->env, &c->constants, number))
        report_memory(c->in);
    return to;
}

/* ---- calls ---- */

/* Arguments behind an open bracket into registers in a row, whose first one is given. */
static uint32_t read_arguments(compiler *c, uint32_t least, uint32_t most, uint32_t *first)
{
    uint32_t n = 0;

    *first = c->next;
    state_open(c->in, '(');
    while (!c->in->failed && c->in->token.kind != ')' && n < most) {
        uint32_t mark = c->next, value_at = full(c);

        c->next = mark;
        if (value_at != reserve(c, 1))
            emit(c, PROGRAM_COPY, mark, value_at, 0);
        n++;
        if (!state_accept(c->in, ','))
            break;
    }
    if (!c->in->failed && n < least)
        report_fail(c->in, &c->in->token.at, POV_E_SYNTAX, "expected %u arguments, found %u", (unsigned)least,
                    (unsigned)n);
    state_close(c->in, ')');
    return n;
}

static uint32_t call_one(compiler *c, int number)
{
    const uint32_t mark = c->next;
    uint32_t first;

    read_arguments(c, 1, 1, &first);
    return combine(c, PROGRAM_ONE, mark, first, (uint32_t)number);
}

static void emit_two(compiler *c, int number, uint32_t to, uint32_t a, uint32_t b)
{
    emit(c, PROGRAM_TWO, to, a, b);
    if (!c->in->failed)
        c->code.items[c->code.count - 1].c = (uint16_t)number;
}

/* min and max take any number of arguments. */
static uint32_t call_two(compiler *c, int number, bool is_fold)
{
    const uint32_t mark = c->next;
    uint32_t first, i, n = read_arguments(c, 2, is_fold ? 255 : 2, &first);

    for (i = 1; i < n; i++)
        emit_two(c, number, first, first, first + i);
    c->next = mark + 1;
    return first;
}

static uint32_t call_select(compiler *c)
{
    const uint32_t mark = c->next;
    uint32_t first, n = read_arguments(c, 3, 4, &first);

    return combine(c, PROGRAM_SELECT, mark, first, n);
}

/* sum(i, from, to, E) and prod: E for each i from `from` while it is at most `to`. */
static uint32_t call_series(compiler *c, bool is_product)
{
    pov_reader *in = c->in;
    const uint32_t total = reserve(c, 1);
    local variable = { NULL, reserve(c, 1) };
    uint32_t last = reserve(c, 1), start, value_at, one;

    in->wants_name = true;
    state_open(in, '(');
    in->wants_name = false;
    if (in->token.kind != TOKEN_WORD)
        report_expected(in, "the name of a variable");
    variable.name = in->token.symbol;
    state_advance(in);
    state_expect(in, ',');
    emit(c, PROGRAM_COPY, variable.at, full(c), 0);
    state_expect(in, ',');
    emit(c, PROGRAM_COPY, last, full(c), 0);
    state_expect(in, ',');
    emit(c, PROGRAM_COPY, total, constant(c, is_product ? 1.0 : 0.0), 0);
    start = (uint32_t)c->code.count;
    emit(c, PROGRAM_JUMP_ABOVE, 0, variable.at, last);
    if (!in->failed && !VEC_PUSH(in->model->env, &c->locals, variable))
        report_memory(in);
    value_at = full(c);
    if (c->locals.count > 0)
        c->locals.count--;
    emit(c, is_product ? PROGRAM_MULTIPLY : PROGRAM_ADD, total, total, value_at);
    one = constant(c, 1.0);
    emit(c, PROGRAM_ADD, variable.at, variable.at, one);
    emit(c, PROGRAM_JUMP_WITHIN, start + 1, variable.at, last);
    if (!in->failed)
        c->code.items[start].to = (uint32_t)c->code.count;
    state_close(in, ')');
    c->next = total + 1;
    return total;
}

/* What is no formula is asked of its host. */
static uint32_t emit_host(compiler *c, uint32_t mark, uint32_t first, program_host host, uint32_t part)
{
    const uint32_t to = combine(c, PROGRAM_HOST, mark, first, (uint32_t)c->hosts.count);

    if (c->in->failed)
        return to;
    c->code.items[c->code.count - 1].c = (uint16_t)part;
    if (!VEC_PUSH(c->in->model->env, &c->hosts, host))
        report_memory(c->in);
    return to;
}

/* Only here "hf" is a component. */
static int next_component(const pov_reader *in)
{
    const bool is_height = in->token.kind == TOKEN_WORD && strcmp(in->token.symbol->name, "hf") == 0;

    return is_height ? EXPRESSION_HEIGHT : expression_component(state_keyword(in));
}

static int component_of(compiler *c, const function *f)
{
    int i = 0;

    if (f->kind == FUNCTION_PATTERN)
        return 0;
    state_expect(c->in, '.');
    i = next_component(c->in);
    if (i < 0)
        report_expected(c->in, "a component such as \"red\" or \"hf\"");
    state_advance(c->in);
    return i;
}

static uint32_t call_part(compiler *c, const function *f)
{
    const program_host host = { function_host_value, function_host_values, f, f->kind == FUNCTION_SPLINE ? 1 : 3 };
    const uint32_t mark = c->next;
    uint32_t first;
    int part;

    read_arguments(c, f->kind == FUNCTION_SPLINE ? 1 : 3, 3, &first);
    part = component_of(c, f);
    return emit_host(c, mark, first, host, part < 0 ? 0 : (uint32_t)part);
}

/* A function that does nothing but pass its arguments on to one that is built in, as those of functions.inc: what it calls. */
static const instruction *passed_on(const program *p)
{
    const instruction *i = p->code;

    return p->count == 1 && i->a == 0 && i->to == p->result && (i->op == PROGRAM_INTERNAL || i->op == PROGRAM_HOST) ? i : NULL;
}

/* Called itself, with the same arguments. */
static uint32_t call_passed_on(compiler *c, const program *by, const instruction *i, uint32_t mark, uint32_t first)
{
    return i->op == PROGRAM_INTERNAL ? combine(c, PROGRAM_INTERNAL, mark, first, i->b) : emit_host(c, mark, first, by->hosts[i->b], i->c);
}

static uint32_t call_declared(compiler *c, const function *f)
{
    const uint32_t mark = c->next;
    const program *callee = &f->program;
    uint32_t first, n = callee->parameters;

    if (f->kind != FUNCTION_FORMULA)
        return call_part(c, f);
    read_arguments(c, n, n, &first);
    if (passed_on(callee))
        return call_passed_on(c, callee, passed_on(callee), mark, first);
    if (callee->capacity > c->capacity)
        c->capacity = callee->capacity;
    if (!c->in->failed && !VEC_PUSH(c->in->model->env, &c->callees, callee))
        report_memory(c->in);
    return combine(c, PROGRAM_CALL, mark, first, (uint32_t)c->callees.count - 1);
}

/* ---- operands ---- */

/* u and v are other words for x and y. */
static keyword_id plain_name(const symbol *name)
{
    return name->id == KEYWORD_U ? KEYWORD_X : name->id == KEYWORD_V ? KEYWORD_Y : name->id;
}

static bool find_local(const compiler *c, const symbol *name, uint32_t *at)
{
    const keyword_id id = plain_name(name);
    size_t i = c->locals.count;

    while (i-- > 0)
        if (c->locals.items[i].name == name ||
            (id != KEYWORD_OTHER && plain_name(c->locals.items[i].name) == id)) {
            *at = c->locals.items[i].at;
            return true;
        }
    return false;
}

/* A number's value is that of now. */
static uint32_t declared(compiler *c)
{
    pov_reader *in = c->in;
    binding *b = in->token.symbol->binding;
    shared *lender = b->lender ? b->lender : &b->head;
    const place at = in->token.at;
    value *slot = b->slot;
    uint32_t result = 0;

    lender->uses++;
    state_advance(in);
    slot = expression_element(in, slot, &lender);
    if (slot && slot->kind == VALUE_NUMBER)
        result = constant(c, slot->as.v[0]);
    else if (slot && slot->kind == VALUE_FUNCTION)
        result = call_declared(c, slot->as.part);
    else if (slot)
        report_fail(in, &at, POV_E_SYNTAX, "%s has no place in a formula", value_name(slot));
    value_unshare(&in->heap, lender);
    return result;
}

static uint32_t keyword(compiler *c)
{
    pov_reader *in = c->in;
    const symbol *name = in->token.symbol;
    int one = program_one_argument(name->name), two = program_two_arguments(name->name);
    const keyword_id id = name->id;

    if (id == KEYWORD_PI || id == KEYWORD_CLOCK)
        return constant(c, expression_to_number(in, expression_operand(in)));
    if (one < 0 && two < 0 && id != KEYWORD_SELECT && id != KEYWORD_SUM && id != KEYWORD_PROD) {
        report_expected(in, "a number or a function of numbers");
        return 0;
    }
    in->wants_name = id == KEYWORD_SUM || id == KEYWORD_PROD;
    state_advance(in);
    in->wants_name = false;
    if (one >= 0)
        return call_one(c, one);
    if (two >= 0)
        return call_two(c, two, id == KEYWORD_MIN || id == KEYWORD_MAX);
    return id == KEYWORD_SELECT ? call_select(c) : call_series(c, id == KEYWORD_PROD);
}

static uint32_t primary(compiler *c)
{
    pov_reader *in = c->in;
    uint32_t at = 0;

    state_settle(in);
    if (in->token.kind == TOKEN_NUMBER) {
        at = constant(c, in->token.number);
        state_advance(in);
    } else if (in->token.kind == '(') {
        state_open(in, '(');
        at = full(c);
        state_close(in, ')');
    } else if (in->token.kind != TOKEN_WORD) {
        report_expected(in, "a number");
    } else if (find_local(c, in->token.symbol, &at)) {
        state_advance(in);
    } else if (in->token.symbol->id != KEYWORD_OTHER) {
        at = keyword(c);
    } else if (in->token.symbol->binding) {
        at = declared(c);
    } else if (in->token.symbol == in->declaring) {
        report_fail(in, &in->token.at, POV_E_SYNTAX, "\"%s\" is being declared: a function cannot call itself", in->declaring->name);
    } else {
        report_undeclared(in);
    }
    return at;
}

static uint32_t unary(compiler *c)
{
    pov_reader *in = c->in;
    const uint32_t mark = c->next;
    bool is_negative = false;
    uint32_t at;

    if (!state_enter(in))
        return 0;
    state_settle(in);
    if (in->token.kind == '-' || in->token.kind == '+') {     /* one sign, unlike elsewhere */
        is_negative = in->token.kind == '-';
        state_advance(in);
    }
    at = primary(c);
    state_exit(in);
    return is_negative ? combine(c, PROGRAM_NEGATE, mark, at, 0) : at;
}

/* ---- operators, tightest first ---- */

static uint32_t product(compiler *c)
{
    const uint32_t mark = c->next;
    uint32_t a = unary(c);

    while (!c->in->failed && (c->in->token.kind == '*' || c->in->token.kind == '/')) {
        program_op op = c->in->token.kind == '*' ? PROGRAM_MULTIPLY : PROGRAM_DIVIDE;

        state_advance(c->in);
        a = combine(c, op, mark, a, unary(c));
    }
    return a;
}

static uint32_t sum(compiler *c)
{
    const uint32_t mark = c->next;
    uint32_t a = product(c);

    while (!c->in->failed && (c->in->token.kind == '+' || c->in->token.kind == '-')) {
        program_op op = c->in->token.kind == '+' ? PROGRAM_ADD : PROGRAM_SUBTRACT;

        state_advance(c->in);
        a = combine(c, op, mark, a, product(c));
    }
    return a;
}

static bool is_comparison(int kind, program_op *op, bool *swaps)
{
    *swaps = kind == '>' || kind == TOKEN_AT_LEAST;
    *op = kind == '<' || kind == '>'                           ? PROGRAM_LESS
          : kind == TOKEN_AT_MOST || kind == TOKEN_AT_LEAST    ? PROGRAM_AT_MOST
          : kind == '='                                        ? PROGRAM_EQUAL
                                                               : PROGRAM_UNEQUAL;
    return *op != PROGRAM_UNEQUAL || kind == TOKEN_UNEQUAL;
}

static uint32_t comparison(compiler *c)
{
    const uint32_t mark = c->next;
    uint32_t a = sum(c), b;
    program_op op;
    bool swaps;

    while (!c->in->failed && is_comparison(c->in->token.kind, &op, &swaps)) {
        state_advance(c->in);
        b = sum(c);
        a = swaps ? combine(c, op, mark, b, a) : combine(c, op, mark, a, b);
    }
    return a;
}

static uint32_t conjunction(compiler *c)
{
    const uint32_t mark = c->next;
    uint32_t a = comparison(c);

    while (!c->in->failed && state_accept(c->in, '&'))
        a = combine(c, PROGRAM_AND, mark, a, comparison(c));
    return a;
}

static uint32_t full(compiler *c)
{
    const uint32_t mark = c->next;
    uint32_t a = conjunction(c);

    while (!c->in->failed && state_accept(c->in, '|'))
        a = combine(c, PROGRAM_OR, mark, a, conjunction(c));
    return a;
}

/* ---- into the scene's memory ---- */

static void *keep(pov_reader *in, const void *items, size_t bytes)
{
    void *kept = bytes > 0 ? state_alloc(in, bytes, 16) : NULL;

    if (kept)
        memcpy(kept, items, bytes);
    return kept;
}

static void conclude(compiler *c, uint32_t parameters, uint32_t result, program *out)
{
    pov_reader *in = c->in;

    memset(out, 0, sizeof *out);
    out->parameters = parameters;
    out->registers = c->most > 0 ? c->most : 1;
    out->capacity = out->registers + c->capacity;
    out->result = result;
    out->count = (uint32_t)c->code.count;
    if (!in->failed) {
        out->code = keep(in, c->code.items, c->code.count * sizeof *c->code.items);
        out->constants = keep(in, c->constants.items, c->constants.count * sizeof *c->constants.items);
        out->callees = keep(in, c->callees.items, c->callees.count * sizeof *c->callees.items);
        out->hosts = keep(in, c->hosts.items, c->hosts.count * sizeof *c->hosts.items);
    }
    env_free(in->model->env, c->locals.items);
    env_free(in->model->env, c->code.items);
    env_free(in->model->env, c->constants.items);
    env_free(in->model->env, (void *)c->callees.items);
    env_free(in->model->env, c->hosts.items);
}

bool formula_compile(pov_reader *in, symbol *const *parameters, uint32_t count, program *out)
{
    compiler c;
    uint32_t i;

    memset(&c, 0, sizeof c);
    c.in = in;
    c.next = c.most = count;
    for (i = 0; i < count && !in->failed; i++) {
        local one = { parameters[i], i };
        uint32_t earlier;

        if (!find_local(&c, parameters[i], &earlier) && !VEC_PUSH(in->model->env, &c.locals, one))
            report_memory(in);
    }
    i = full(&c);
    conclude(&c, count, i, out);
    return !in->failed;
}

enum { SAME_LANES = 1 / (NOISE_FUNCTION_LANES == (int)PROGRAM_LANES) };   /* a program's lanes are those of noise */

bool formula_internal(pov_reader *in, uint32_t number, program *out)
{
    const program_host host = { noise_function_value, noise_function_values, in->model, internal_arguments(number) };
    compiler c;

    memset(&c, 0, sizeof c);
    c.in = in;
    c.next = c.most = internal_arguments(number);
    if (noise_function_exists(number) && noise_of(in))
        emit_host(&c, 0, 0, host, number);
    else
        emit(&c, PROGRAM_INTERNAL, 0, 0, number);
    conclude(&c, internal_arguments(number), 0, out);
    return !in->failed;
}
