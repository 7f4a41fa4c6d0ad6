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
