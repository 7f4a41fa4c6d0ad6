#include "function/program.h"

#include "function/internal.h"

#include <math.h>
#include <string.h>

/* ---- functions by number ---- */

static double cut(double a)
{
    return a > -2147483649.0 && a < 2147483648.0 ? (double)(int32_t)a : -2147483648.0;
}

static double divide(double a, double b)
{
    return cut(a / b);
}

static double to_radians(double a)
{
    return a * (3.14159265358979323846 / 180.0);
}

static double to_degrees(double a)
{
    return a * (180.0 / 3.14159265358979323846);
}

static double lesser(double a, double b)
{
    return b < a ? b : a;
}

static double greater(double a, double b)
{
    return b > a ? b : a;
}

typedef struct one_row { const char *name; double (*of)(double); } one_row;
typedef struct two_row { const char *name; double (*of)(double, double); } two_row;

static const one_row ones[] = {
    { "sin", sin },     { "cos", cos },     { "tan", tan },     { "asin", asin },   { "acos", acos },
    { "atan", atan },   { "sinh", sinh },   { "cosh", cosh },   { "tanh", tanh },   { "asinh", asinh },
    { "acosh", acosh }, { "atanh", atanh }, { "abs", fabs },    { "int", cut },     { "floor", floor },
    { "ceil", ceil },   { "sqrt", sqrt },   { "exp", exp },     { "ln", log },      { "log", log10 },
    { "radians", to_radians },              { "degrees", to_degrees },
};

static const two_row twos[] = {
    { "atan2", atan2 }, { "pow", pow }, { "mod", fmod }, { "div", divide }, { "min", lesser }, { "max", greater },
};

int program_one_argument(const char *name)
{
    for (size_t i = 0; i < sizeof ones / sizeof ones[0]; i++)
        if (strcmp(ones[i].name, name) == 0)
            return (int)i;
    return -1;
}

int program_two_arguments(const char *name)
{
    for (size_t i = 0; i < sizeof twos / sizeof twos[0]; i++)
        if (strcmp(twos[i].name, name) == 0)
            return (int)i;
    return -1;
}

const char *program_one_name(uint32_t number) { return ones[number].name; }
const char *program_two_name(uint32_t number) { return twos[number].name; }

/* ---- running ---- */

static double choose(const double *v, uint32_t count)
{
    if (v[0] < 0.0)
        return v[1];
    return count == 3 || v[0] == 0.0 ? v[2] : v[3];
}

static double call(const program *callee, const double *arguments, double *registers)
{
    memcpy(registers, arguments, callee->parameters * sizeof *registers);
    return program_run(callee, registers);
}

double program_run(const program *p, double *r)
{
    const instruction *i = p->code, *const end = p->count > 0 ? i + p->count : i;   /* a constant has no code */

    for (; i < end; i++) {
        switch ((program_op)i->op) {
        case PROGRAM_CONSTANT: r[i->to] = p->constants[i->a]; break;
        case PROGRAM_COPY: r[i->to] = r[i->a]; break;
        case PROGRAM_ADD: r[i->to] = r[i->a] + r[i->b]; break;
        case PROGRAM_SUBTRACT: r[i->to] = r[i->a] - r[i->b]; break;
        case PROGRAM_MULTIPLY: r[i->to] = r[i->a] * r[i->b]; break;
        case PROGRAM_DIVIDE: r[i->to] = r[i->a] / r[i->b]; break;
        case PROGRAM_NEGATE: r[i->to] = -r[i->a]; break;
        case PROGRAM_LESS: r[i->to] = r[i->a] < r[i->b]; break;
        case PROGRAM_AT_MOST: r[i->to] = r[i->a] <= r[i->b]; break;
        case PROGRAM_EQUAL: r[i->to] = r[i->a] == r[i->b]; break;
        case PROGRAM_UNEQUAL: r[i->to] = r[i->a] != r[i->b]; break;
        case PROGRAM_AND: r[i->to] = r[i->a] != 0.0 && r[i->b] != 0.0; break;
        case PROGRAM_OR: r[i->to] = r[i->a] != 0.0 || r[i->b] != 0.0; break;
        case PROGRAM_ONE: r[i->to] = ones[i->b].of(r[i->a]); break;
        case PROGRAM_TWO: r[i->to] = twos[i->c].of(r[i->a], r[i->b]); break;
        case PROGRAM_SELECT: r[i->to] = choose(&r[i->a], i->b); break;
        case PROGRAM_INTERNAL: r[i->to] = internal_value(i->b, &r[i->a]); break;
        case PROGRAM_HOST: r[i->to] = p->hosts[i->b].value(p->hosts[i->b].self, &r[i->a], i->c); break;
        case PROGRAM_CALL: r[i->to] = call(p->callees[i->b], &r[i->a], r + p->registers); break;
        case PROGRAM_JUMP_ABOVE:
            if (!(r[i->a] <= r[i->b]))
                i = p->code + i->to - 1;
            break;
        case PROGRAM_JUMP_WITHIN:
            if (r[i->a] <= r[i->b])
                i = p->code + i->to - 1;
            break;
        }
    }
    return r[p->result];
}

/* ---- running lanes ---- */

typedef double row[PROGRAM_LANES];

/* The result may stand where an argument does. */
static void take_row(program_op op, const double *a, const double *b, double *to)
{
    row v;

    switch (op) {
    case PROGRAM_ADD: for (uint32_t l = 0; l < PROGRAM_LANES; l++) v[l] = a[l] + b[l]; break;
    case PROGRAM_SUBTRACT: for (uint32_t l = 0; l < PROGRAM_LANES; l++) v[l] = a[l] - b[l]; break;
    case PROGRAM_MULTIPLY: for (uint32_t l = 0; l < PROGRAM_LANES; l++) v[l] = a[l] * b[l]; break;
    case PROGRAM_DIVIDE: for (uint32_t l = 0; l < PROGRAM_LANES; l++) v[l] = a[l] / b[l]; break;
    case PROGRAM_LESS: for (uint32_t l = 0; l < PROGRAM_LANES; l++) v[l] = a[l] < b[l]; break;
    case PROGRAM_AT_MOST: for (uint32_t l = 0; l < PROGRAM_LANES; l++) v[l] = a[l] <= b[l]; break;
    case PROGRAM_EQUAL: for (uint32_t l = 0; l < PROGRAM_LANES; l++) v[l] = a[l] == b[l]; break;
    case PROGRAM_UNEQUAL: for (uint32_t l = 0; l < PROGRAM_LANES; l++) v[l] = a[l] != b[l]; break;
    case PROGRAM_AND: for (uint32_t l = 0; l < PROGRAM_LANES; l++) v[l] = (a[l] != 0.0) & (b[l] != 0.0); break;
    default: for (uint32_t l = 0; l < PROGRAM_LANES; l++) v[l] = (a[l] != 0.0) | (b[l] != 0.0); break;
    }
    memcpy(to, v, sizeof v);
}

/* The arguments of one lane, in a row. */
static const double *arguments_of(row *from, uint32_t count, uint32_t lane, double *out)
{
    for (uint32_t k = 0; k < count; k++)
        out[k] = from[k][lane];
    return out;
}

static void ask_host(const program_host *host, row *from, uint32_t part, uint32_t n, void *memo, double *to)
{
    double own[INTERNAL_ARGUMENTS_MAX];
    row v;

    if (host->values)
        host->values(host->self, from[0], part, n, memo, v);
    else
        for (uint32_t l = 0; l < n; l++)
            v[l] = host->value(host->self, arguments_of(from, host->arguments, l, own), part);
    memcpy(to, v, n * sizeof *v);
}

/* What is done to each lane by itself. */
static void take_lanes(const instruction *i, row *r, uint32_t n)
{
    double own[INTERNAL_ARGUMENTS_MAX];
    row *const from = r + i->a;
    double *const to = r[i->to];

    for (uint32_t l = 0; l < n; l++)
        switch ((program_op)i->op) {
        case PROGRAM_ONE: to[l] = ones[i->b].of(from[0][l]); break;
        case PROGRAM_TWO: to[l] = twos[i->c].of(from[0][l], r[i->b][l]); break;
        case PROGRAM_SELECT: to[l] = choose(arguments_of(from, i->b, l, own), i->b); break;
        default: to[l] = internal_value(i->b, arguments_of(from, internal_arguments(i->b), l, own)); break;
        }
}

static void call_lanes(const program *callee, row *arguments, row *registers, uint32_t n, void *memo, double *to)
{
    row v;

    memcpy(registers, arguments, callee->parameters * sizeof *registers);
    program_run_many(callee, registers[0], n, memo, v);
    memcpy(to, v, n * sizeof *v);
}

static void step_lanes(const program *p, const instruction *i, row *r, uint32_t n, void *memo)
{
    switch ((program_op)i->op) {
    case PROGRAM_CONSTANT:
        for (uint32_t l = 0; l < PROGRAM_LANES; l++)
            r[i->to][l] = p->constants[i->a];
        break;
    case PROGRAM_COPY: memmove(r[i->to], r[i->a], sizeof *r); break;
    case PROGRAM_NEGATE:
        for (uint32_t l = 0; l < PROGRAM_LANES; l++)
            r[i->to][l] = -r[i->a][l];
        break;
    case PROGRAM_ONE: case PROGRAM_TWO: case PROGRAM_SELECT: case PROGRAM_INTERNAL: take_lanes(i, r, n); break;
    case PROGRAM_HOST: ask_host(&p->hosts[i->b], r + i->a, i->c, n, memo, r[i->to]); break;
    case PROGRAM_CALL: call_lanes(p->callees[i->b], r + i->a, r + p->registers, n, memo, r[i->to]); break;
    default: take_row((program_op)i->op, r[i->a], r[i->b], r[i->to]); break;
    }
}

/* Lanes may take different ways there. */
static bool has_jumps(const program *p)
{
    for (uint32_t i = 0; i < p->count; i++)
        if (p->code[i].op == PROGRAM_JUMP_ABOVE || p->code[i].op == PROGRAM_JUMP_WITHIN)
            return true;
    return false;
}

void program_run_many(const program *p, double *registers, uint32_t n, void *memo, double *out)
{
    row *const r = (row *)registers;
    double *const own = registers + PROGRAM_LANES * (size_t)p->capacity;

    if (has_jumps(p)) {
        for (uint32_t l = 0; l < n; l++) {
            arguments_of(r, p->parameters, l, own);
            out[l] = program_run(p, own);
        }
        return;
    }
    for (uint32_t i = 0; i < p->count; i++)
        step_lanes(p, &p->code[i], r, n, memo);
    memcpy(out, r[p->result], n * sizeof *out);
}
