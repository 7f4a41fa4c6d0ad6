#include "function/tape_record.h"

#include "base/elementary.h"
#include "base/vec.h"

#include <string.h>

/* A step whose operands are the numbers of other steps; the arguments are the first ones, without an operation. */
typedef struct tape_node { uint32_t a, b, c; uint16_t op; bool is_positive; double k; } node;

enum { ARGUMENT = 0xffff, STEPS_MAX = 4096, TURNS_MAX = 100000, WHOLE_MAX = 64 };

/* ---- steps ---- */

static const node *at(const recorder *r, uint32_t n) { return &r->nodes.items[n]; }

void record_give_up(recorder *r, tape_outcome why)
{
    if (r->outcome == TAPE_RECORDED)
        r->outcome = why;
}

static bool is_constant(const recorder *r, uint32_t n) { return at(r, n)->op == TAPE_CONSTANT; }
static double constant_of(const recorder *r, uint32_t n) { return at(r, n)->k; }

bool record_constant_of(const recorder *r, uint32_t a, double *out)
{
    *out = at(r, a)->k;
    return is_constant(r, a);
}

static bool is_same(const node *a, const node *b)
{
    return a->op == b->op && a->a == b->a && a->b == b->b && a->c == b->c && elementary_bits(a->k) == elementary_bits(b->k);
}

static bool find_positive(const recorder *r, const node *n)
{
    switch (n->op) {
    case TAPE_CONSTANT:
        return n->k >= 0.0;
    case TAPE_ABS: case TAPE_SQRT: case TAPE_EXP: case TAPE_POWER: case TAPE_HEX_ALONG: case TAPE_HEX_ACROSS:
        return true;
    case TAPE_ADD: case TAPE_DIVIDE: case TAPE_MIN:
        return at(r, n->a)->is_positive && at(r, n->b)->is_positive;
    case TAPE_MULTIPLY:
        return n->a == n->b || (at(r, n->a)->is_positive && at(r, n->b)->is_positive);
    case TAPE_OFFSET: case TAPE_SCALE:
        return at(r, n->a)->is_positive && n->k >= 0.0;
    case TAPE_MAX:
        return at(r, n->a)->is_positive || at(r, n->b)->is_positive;
    default:
        return false;
    }
}

static uint32_t put(recorder *r, node n)
{
    for (size_t i = 0; i < r->nodes.count; i++)
        if (is_same(&r->nodes.items[i], &n))
            return (uint32_t)i;
    n.is_positive = n.op != ARGUMENT && find_positive(r, &n);
    if (r->nodes.count >= STEPS_MAX)
        record_give_up(r, TAPE_NONE);
    else if (!VEC_PUSH(r->env, &r->nodes, n))
        record_give_up(r, TAPE_NO_MEMORY);
    return r->outcome == TAPE_RECORDED ? (uint32_t)r->nodes.count - 1 : 0;
}

static uint32_t step_of(recorder *r, tape_op op, uint32_t a, uint32_t b, uint32_t c, double k)
{
    const node n = { a, b, c, (uint16_t)op, false, k };

    return put(r, n);
}

uint32_t record_constant(recorder *r, double k) { return step_of(r, TAPE_CONSTANT, 0, 0, 0, k); }

/* ---- arithmetic ---- */

static uint32_t offset(recorder *r, uint32_t a, double k)
{
    if (is_constant(r, a))
        return record_constant(r, constant_of(r, a) + k);
    return k == 0.0 ? a : step_of(r, TAPE_OFFSET, a, 0, 0, k);
}

static uint32_t scale(recorder *r, uint32_t a, double k)
{
    if (is_constant(r, a))
        return record_constant(r, constant_of(r, a) * k);
    return k == 1.0 ? a : step_of(r, TAPE_SCALE, a, 0, 0, k);
}

static uint32_t add(recorder *r, uint32_t a, uint32_t b)
{
    if (is_constant(r, b))
        return offset(r, a, constant_of(r, b));
    return is_constant(r, a) ? offset(r, b, constant_of(r, a)) : step_of(r, TAPE_ADD, a, b, 0, 0.0);
}

static uint32_t subtract(recorder *r, uint32_t a, uint32_t b)
{
    if (is_constant(r, b))
        return offset(r, a, -constant_of(r, b));
    return is_constant(r, a) ? offset(r, scale(r, b, -1.0), constant_of(r, a)) : step_of(r, TAPE_SUBTRACT, a, b, 0, 0.0);
}

static uint32_t multiply(recorder *r, uint32_t a, uint32_t b)
{
    if (is_constant(r, b))
        return scale(r, a, constant_of(r, b));
    return is_constant(r, a) ? scale(r, b, constant_of(r, a)) : step_of(r, TAPE_MULTIPLY, a, b, 0, 0.0);
}

static uint32_t divide(recorder *r, uint32_t a, uint32_t b)
{
    if (is_constant(r, a) && is_constant(r, b))
        return record_constant(r, constant_of(r, a) / constant_of(r, b));
    return step_of(r, TAPE_DIVIDE, a, b, 0, 0.0);
}

uint32_t record_arithmetic(recorder *r, char op, uint32_t a, uint32_t b)
{
    return op == '+' ? add(r, a, b) : op == '-' ? subtract(r, a, b) : op == '*' ? multiply(r, a, b) : divide(r, a, b);
}

uint32_t record_step(recorder *r, tape_op op, uint32_t a, uint32_t b, uint32_t c) { return step_of(r, op, a, b, c, 0.0); }

/* ---- functions of one argument ---- */

static double cut(double a) { return a > -2147483649.0 && a < 2147483648.0 ? (double)(int32_t)a : -2147483648.0; }
static double inverse_sinh(double a)
{
    const double size = fabs(a);

    return copysign(elementary_log(size + sqrt(size * size + 1.0)), a);
}

static double value_of(tape_op op, double a)
{
    switch (op) {
    case TAPE_ABS: return fabs(a);
    case TAPE_SQRT: return sqrt(a);
    case TAPE_SIN: return elementary_sin(a);
    case TAPE_COS: return elementary_cos(a);
    case TAPE_EXP: return elementary_exp(a);
    case TAPE_LN: return elementary_log(a);
    case TAPE_ASIN: return elementary_asin(a);
    case TAPE_ATAN: return elementary_atan(a);
    case TAPE_ASINH: return inverse_sinh(a);
    case TAPE_FLOOR: return floor(a);
    case TAPE_CEIL: return ceil(a);
    default: return cut(a);
    }
}

static uint32_t one(recorder *r, tape_op op, uint32_t a)
{
    return is_constant(r, a) ? record_constant(r, value_of(op, constant_of(r, a))) : step_of(r, op, a, 0, 0, 0.0);
}

typedef struct name_row { const char *name; tape_op op; } name_row;

static const name_row names[] = {
    { "sin", TAPE_SIN }, { "cos", TAPE_COS }, { "asin", TAPE_ASIN }, { "atan", TAPE_ATAN }, { "asinh", TAPE_ASINH }, { "abs", TAPE_ABS },
    { "int", TAPE_CUT }, { "floor", TAPE_FLOOR }, { "ceil", TAPE_CEIL }, { "sqrt", TAPE_SQRT }, { "exp", TAPE_EXP }, { "ln", TAPE_LN },
};

/* Others are made of these. */
static uint32_t one_composed(recorder *r, const char *name, uint32_t a)
{
    const double turn = 3.14159265358979323846 / 180.0;
    uint32_t up, down;

    if (strcmp(name, "tan") == 0)
        return divide(r, one(r, TAPE_SIN, a), one(r, TAPE_COS, a));
    if (strcmp(name, "acos") == 0)
        return offset(r, scale(r, one(r, TAPE_ASIN, a), -1.0), 90.0 * turn);
    if (strcmp(name, "log") == 0)
        return scale(r, one(r, TAPE_LN, a), 0.43429448190325182765);
    if (strcmp(name, "radians") == 0)
        return scale(r, a, turn);
    if (strcmp(name, "degrees") == 0)
        return scale(r, a, 1.0 / turn);
    if (strcmp(name, "tanh") == 0)
        return offset(r, divide(r, record_constant(r, -2.0), offset(r, one(r, TAPE_EXP, scale(r, a, 2.0)), 1.0)), 1.0);
    if (strcmp(name, "acosh") == 0)
        return one(r, TAPE_LN, add(r, a, one(r, TAPE_SQRT, offset(r, multiply(r, a, a), -1.0))));
    if (strcmp(name, "atanh") == 0)
        return scale(r, one(r, TAPE_LN, divide(r, offset(r, a, 1.0), offset(r, scale(r, a, -1.0), 1.0))), 0.5);
    up = one(r, TAPE_EXP, a);
    down = one(r, TAPE_EXP, scale(r, a, -1.0));
    return scale(r, strcmp(name, "sinh") == 0 ? subtract(r, up, down) : add(r, up, down), 0.5);
}

uint32_t record_one(recorder *r, const char *name, uint32_t a)
{
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(names[i].name, name) == 0)
            return one(r, names[i].op, a);
    return one_composed(r, name, a);
}

/* ---- functions of two ---- */

static uint32_t whole_power(recorder *r, uint32_t a, int n)
{
    uint32_t half;

    if (n <= 1)
        return n == 1 ? a : record_constant(r, 1.0);
    half = whole_power(r, a, n / 2);
    half = multiply(r, half, half);
    return n % 2 ? multiply(r, half, a) : half;
}

static uint32_t power(recorder *r, uint32_t a, uint32_t b)
{
    const double k = constant_of(r, b);

    if (!is_constant(r, b))
        return one(r, TAPE_EXP, multiply(r, b, one(r, TAPE_LN, a)));
    if (k == floor(k) && fabs(k) <= WHOLE_MAX)
        return k < 0.0 ? divide(r, record_constant(r, 1.0), whole_power(r, a, (int)-k)) : whole_power(r, a, (int)k);
    if (k == 0.5)
        return one(r, TAPE_SQRT, a);
    return is_constant(r, a) ? record_constant(r, elementary_pow(constant_of(r, a), k)) : step_of(r, TAPE_POWER, a, 0, 0, k);
}

static uint32_t comparison(recorder *r, tape_op op, uint32_t a, uint32_t b)
{
    double x, y;

    if (!is_constant(r, a) || !is_constant(r, b))
        return step_of(r, op, a, b, 0, 0.0);
    x = constant_of(r, a);
    y = constant_of(r, b);
    switch (op) {
    case TAPE_LESS: return record_constant(r, x < y);
    case TAPE_AT_MOST: return record_constant(r, x <= y);
    case TAPE_EQUAL: return record_constant(r, x == y);
    case TAPE_AND: return record_constant(r, x != 0.0 && y != 0.0);
    case TAPE_OR: return record_constant(r, x != 0.0 || y != 0.0);
    case TAPE_MIN: return record_constant(r, y < x ? y : x);
    case TAPE_MAX: return record_constant(r, y > x ? y : x);
    case TAPE_MOD: return record_constant(r, fmod(x, y));
    default: return record_constant(r, elementary_atan2(x, y));
    }
}

uint32_t record_two(recorder *r, const char *name, uint32_t a, uint32_t b)
{
    if (strcmp(name, "pow") == 0)
        return power(r, a, b);
    if (strcmp(name, "mod") == 0)
        return comparison(r, TAPE_MOD, a, b);
    if (strcmp(name, "div") == 0)
        return one(r, TAPE_CUT, divide(r, a, b));
    return comparison(r, strcmp(name, "min") == 0 ? TAPE_MIN : strcmp(name, "max") == 0 ? TAPE_MAX : TAPE_ATAN2, a, b);
}

uint32_t record_choice(recorder *r, tape_op op, uint32_t a, uint32_t b, uint32_t c)
{
    if (is_constant(r, a))
        return (op == TAPE_BELOW ? constant_of(r, a) < 0.0 : constant_of(r, a) == 0.0) ? b : c;
    return b == c ? b : step_of(r, op, a, b, c, 0.0);
}

static uint32_t select_of(recorder *r, const uint32_t *v, uint32_t count)
{
    const uint32_t rest = count == 3 ? v[2] : record_choice(r, TAPE_ZERO, v[0], v[2], v[3]);

    return record_choice(r, TAPE_BELOW, v[0], v[1], rest);
}

/* ---- running the program ---- */

static uint32_t run(recorder *r, const program *p, uint32_t *reg);

static uint32_t called(recorder *r, const program *callee, const uint32_t *arguments, uint32_t *reg)
{
    memcpy(reg, arguments, callee->parameters * sizeof *reg);
    return run(r, callee, reg);
}

static uint32_t result_of(recorder *r, const program *p, const instruction *i, uint32_t *reg)
{
    const uint32_t a = reg[i->a < p->registers ? i->a : 0], b = reg[i->b < p->registers ? i->b : 0];

    switch ((program_op)i->op) {
    case PROGRAM_CONSTANT: return record_constant(r, p->constants[i->a]);
    case PROGRAM_COPY: return a;
    case PROGRAM_ADD: return add(r, a, b);
    case PROGRAM_SUBTRACT: return subtract(r, a, b);
    case PROGRAM_MULTIPLY: return multiply(r, a, b);
    case PROGRAM_DIVIDE: return divide(r, a, b);
    case PROGRAM_NEGATE: return scale(r, a, -1.0);
    case PROGRAM_LESS: return comparison(r, TAPE_LESS, a, b);
    case PROGRAM_AT_MOST: return comparison(r, TAPE_AT_MOST, a, b);
    case PROGRAM_EQUAL: return comparison(r, TAPE_EQUAL, a, b);
    case PROGRAM_UNEQUAL: return offset(r, scale(r, comparison(r, TAPE_EQUAL, a, b), -1.0), 1.0);
    case PROGRAM_AND: return comparison(r, TAPE_AND, a, b);
    case PROGRAM_OR: return comparison(r, TAPE_OR, a, b);
    case PROGRAM_ONE: return record_one(r, program_one_name(i->b), a);
    case PROGRAM_TWO: return record_two(r, program_two_name(i->c), a, b);
    case PROGRAM_SELECT: return select_of(r, &reg[i->a], i->b);
    case PROGRAM_INTERNAL: return tape_text_internal(r, i->b, &reg[i->a]);
    case PROGRAM_CALL: return called(r, p->callees[i->b], &reg[i->a], reg + p->registers);
    default:
        record_give_up(r, TAPE_NONE);
        return 0;
    }
}

/* Repetitions must be known while the program is recorded. */
static bool jumps(recorder *r, const instruction *i, const uint32_t *reg)
{
    const bool is_within = i->op == PROGRAM_JUMP_WITHIN;

    if (is_constant(r, reg[i->a]) && is_constant(r, reg[i->b]))
        return (constant_of(r, reg[i->a]) <= constant_of(r, reg[i->b])) == is_within;
    record_give_up(r, TAPE_NONE);
    return false;
}

static uint32_t run(recorder *r, const program *p, uint32_t *reg)
{
    for (uint32_t n = 0; n < p->count && r->outcome == TAPE_RECORDED; n++) {
        const instruction *i = &p->code[n];

        if (r->turns++ == TURNS_MAX)
            record_give_up(r, TAPE_NONE);
        if (i->op != PROGRAM_JUMP_ABOVE && i->op != PROGRAM_JUMP_WITHIN)
            reg[i->to] = result_of(r, p, i, reg);
        else if (jumps(r, i, reg))
            n = i->to - 1;
    }
    return reg[p->result];
}

/* ---- registers ---- */

static uint32_t operands_of(const node *n, uint32_t out[3])
{
    switch (n->op) {
    case ARGUMENT: case TAPE_CONSTANT:
        return 0;
    case TAPE_ADD: case TAPE_SUBTRACT: case TAPE_MULTIPLY: case TAPE_DIVIDE: case TAPE_MIN: case TAPE_MAX: case TAPE_MOD: case TAPE_ATAN2:
    case TAPE_LESS: case TAPE_AT_MOST: case TAPE_EQUAL: case TAPE_AND: case TAPE_OR: case TAPE_BELOW: case TAPE_ZERO:
    case TAPE_HEX_ALONG: case TAPE_HEX_ACROSS:
        out[0] = n->a;
        out[1] = n->b;
        out[2] = n->c;
        return n->op == TAPE_BELOW || n->op == TAPE_ZERO ? 3 : 2;
    default:
        out[0] = n->a;
        return 1;
    }
}

/* Where each step's value is used last, 0: nowhere. */
static void find_last_uses(const recorder *r, uint32_t result, uint32_t *last)
{
    uint32_t of[3];

    last[result] = (uint32_t)r->nodes.count;
    for (uint32_t i = (uint32_t)r->nodes.count; i-- > 0;)
        for (uint32_t k = last[i] ? operands_of(at(r, i), of) : 0; k-- > 0;)
            last[of[k]] = last[of[k]] ? last[of[k]] : i;
}

typedef struct places { uint32_t *last, *of, *free, free_count; } places;

/* A register is free again behind the step that uses it last, not within it. */
static void release(const recorder *r, uint32_t i, uint32_t parameters, places *p)
{
    uint32_t of[3];

    for (uint32_t k = operands_of(at(r, i), of); k-- > 0;)
        if (p->last[of[k]] == i && of[k] >= parameters) {
            p->free[p->free_count++] = p->of[of[k]];
            p->last[of[k]] = 0;
        }
}

static void assign(const recorder *r, places *p, tape *out, tape_step *steps)
{
    out->registers = out->parameters;
    for (uint32_t i = 0; i < out->parameters; i++)
        p->of[i] = i;
    for (uint32_t i = out->parameters; i < r->nodes.count; i++) {
        const node *n = at(r, i);
        uint32_t of[3] = { 0, 0, 0 }, count;

        if (!p->last[i])
            continue;
        count = operands_of(n, of);
        p->of[i] = p->free_count > 0 ? p->free[--p->free_count] : out->registers++;
        steps[out->count].op = n->op;
        steps[out->count].to = (uint16_t)p->of[i];
        steps[out->count].a = (uint16_t)(count > 0 ? p->of[of[0]] : 0);
        steps[out->count].b = (uint16_t)(count > 1 ? p->of[of[1]] : 0);
        steps[out->count].c = (uint16_t)(count > 2 ? p->of[of[2]] : 0);
        steps[out->count].is_positive = count > 0 && at(r, of[0])->is_positive;
        steps[out->count++].k = n->k;
        release(r, i, out->parameters, p);
    }
}

static void conclude(recorder *r, uint32_t result, tape *out)
{
    const size_t n = r->nodes.count;
    places p = { env_alloc(r->env, n, sizeof(uint32_t)), env_alloc(r->env, n, sizeof(uint32_t)), env_alloc(r->env, n, sizeof(uint32_t)), 0 };
    tape_step *steps = env_alloc(r->env, n, sizeof *steps);

    if (p.last && p.of && p.free && steps) {
        find_last_uses(r, result, p.last);
        assign(r, &p, out, steps);
        out->result = p.of[result];
        out->steps = steps;
    } else {
        record_give_up(r, TAPE_NO_MEMORY);
        env_free(r->env, steps);
    }
    env_free(r->env, p.last);
    env_free(r->env, p.of);
    env_free(r->env, p.free);
}

tape_outcome tape_record(const env *e, const program *p, tape *out)
{
    recorder r = { e, { NULL, 0, 0 }, 0, TAPE_RECORDED };
    uint32_t *reg = env_alloc(e, p->capacity, sizeof *reg), result = 0;

    memset(out, 0, sizeof *out);
    out->parameters = p->parameters;
    if (!reg)
        return TAPE_NO_MEMORY;
    for (uint32_t i = 0; i < p->parameters; i++) {
        const node n = { i, 0, 0, ARGUMENT, false, 0.0 };

        reg[i] = put(&r, n);
    }
    if (r.outcome == TAPE_RECORDED)
        result = run(&r, p, reg);
    if (r.outcome == TAPE_RECORDED)
        conclude(&r, result, out);
    env_free(e, reg);
    env_free(e, r.nodes.items);
    return r.outcome;
}
