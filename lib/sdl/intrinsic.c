#include "sdl/intrinsic.h"

#include "base/vec.h"
#include "sdl/array.h"
#include "sdl/expression.h"
#include "sdl/report.h"

#include <math.h>
#include <time.h>

static const double degrees_per_radian = 180.0 / 3.14159265358979323846;

/* ---- arguments ---- */

static void comma(pov_reader *in)
{
    state_accept(in, ',');
}

static double only_argument(pov_reader *in)
{
    double a;

    state_open(in, '(');
    a = expression_full_number(in);
    state_close(in, ')');
    return a;
}

/* ---- of one and two numbers ---- */

static void read_one(pov_reader *in, const intrinsic *row, value *out)
{
    out->as.v[0] = row->of_one(only_argument(in));
}

static void read_two(pov_reader *in, const intrinsic *row, value *out)
{
    double a, b;

    state_open(in, '(');
    a = expression_number(in);
    comma(in);
    b = expression_number(in);
    state_close(in, ')');
    out->as.v[0] = row->of_two(a, b);
}

static double cut(double a)
{
    return expression_integer(a);
}

static double to_radians(double a)
{
    return a / degrees_per_radian;
}

static double to_degrees(double a)
{
    return a * degrees_per_radian;
}

static double divide(double a, double b)
{
    return expression_integer(a / b);
}

/* The inverse of a sine beyond its range: the nearest there is. */
static void read_arc(pov_reader *in, const intrinsic *row, value *out)
{
    double a = only_argument(in);

    if (fabs(a) > 1.0) {
        report_warn(in, &in->value, "\"%s\" of %g counts as that of %d", row->name, a, a < 0.0 ? -1 : 1);
        a = a < 0.0 ? -1.0 : 1.0;
    }
    out->as.v[0] = row->of_one(a);
}

static void read_logarithm(pov_reader *in, const intrinsic *row, value *out)
{
    double a = only_argument(in);

    if (!in->failed && a <= 0.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"%s\" is of numbers above 0", row->name);
    else
        out->as.v[0] = row->of_one(a);
}

static void read_root(pov_reader *in, const intrinsic *row, value *out)
{
    double a = only_argument(in);

    (void)row;
    if (a < 0.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "the root of %g", a);
    else
        out->as.v[0] = sqrt(a);
}

static void read_atan2(pov_reader *in, const intrinsic *row, value *out)
{
    double y, x;

    (void)row;
    state_open(in, '(');
    y = expression_number(in);
    comma(in);
    x = expression_number(in);
    state_close(in, ')');
    if (!in->failed && fabs(x) <= EXPRESSION_NEAR && fabs(y) <= EXPRESSION_NEAR)
        report_fail(in, &in->value, POV_E_SYNTAX, "the angle of a vector without length");
    out->as.v[0] = atan2(y, x);
}

static void read_pow(pov_reader *in, const intrinsic *row, value *out)
{
    double a, b;

    (void)row;
    state_open(in, '(');
    a = expression_number(in);
    comma(in);
    b = expression_number(in);
    state_close(in, ')');
    if (!in->failed && a == 0.0 && b == 0.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "0 to the power of 0");
    out->as.v[0] = pow(a, b);
}

/* ---- of any number of them ---- */

static void read_many(pov_reader *in, const intrinsic *row, value *out)
{
    bool has_comma;
    double a;

    state_open(in, '(');
    a = expression_number(in);
    has_comma = state_accept(in, ',');
    while (has_comma && !in->failed) {
        a = row->of_two(a, expression_number(in));
        has_comma = state_accept(in, ',');
    }
    state_close(in, ')');
    out->as.v[0] = a;
}

static double lesser(double a, double b)
{
    return b < a ? b : a;
}

static double greater(double a, double b)
{
    return b > a ? b : a;
}

static double bits_and(double a, double b)
{
    return (double)(expression_integer(a) & expression_integer(b));
}

static double bits_or(double a, double b)
{
    return (double)(expression_integer(a) | expression_integer(b));
}

static double bits_xor(double a, double b)
{
    return (double)(expression_integer(a) ^ expression_integer(b));
}

/* One argument alone is cut as well. */
static void read_bits(pov_reader *in, const intrinsic *row, value *out)
{
    read_many(in, row, out);
    out->as.v[0] = expression_integer(out->as.v[0]);
}

/* select(a, b, c): b where a < 0, else c; with a d: c where a is 0, d above. */
static void read_select(pov_reader *in, const intrinsic *row, value *out)
{
    double v[4];
    int i, n = 3;

    (void)row;
    state_open(in, '(');
    for (i = 0; i < 3; i++) {
        v[i] = expression_number(in);
        if (i < 2)
            comma(in);
    }
    if (in->token.kind != ')') {
        comma(in);
        v[n++] = expression_number(in);
    }
    state_close(in, ')');
    out->as.v[0] = v[0] < 0.0 ? v[1] : n == 3 || v[0] == 0.0 ? v[2] : v[3];
}

/* ---- random numbers ---- */

static void read_seed(pov_reader *in, const intrinsic *row, value *out)
{
    random_stream stream;
    double seed = only_argument(in);

    (void)row;
    stream.state = (uint32_t)expression_integer(seed);
    if (!in->failed && !VEC_PUSH(in->model->env, &in->randoms, stream))
        report_memory(in);
    out->as.v[0] = (double)in->randoms.count - 1.0;
}

static void read_rand(pov_reader *in, const intrinsic *row, value *out)
{
    double handle = only_argument(in);
    random_stream *stream;

    (void)row;
    if (in->failed)
        return;
    if (!(handle >= 0.0 && handle < (double)in->randoms.count)) {
        report_fail(in, &in->value, POV_E_SYNTAX, "%g is no stream of random numbers, which seed() gives", handle);
        return;
    }
    stream = &in->randoms.items[(size_t)handle];
    stream->state = stream->state * 1812433253u + 12345u;
    out->as.v[0] = (double)stream->state / 4294967295.0;
}

/* ---- constants, and what the reader knows ---- */

static void read_constant(pov_reader *in, const intrinsic *row, value *out)
{
    int i;

    (void)in;
    out->kind = row->size > 1 ? VALUE_VECTOR : VALUE_NUMBER;
    out->size = row->size;
    for (i = 0; i < row->size; i++)
        out->as.v[i] = row->v[i];
}

static void read_clock(pov_reader *in, const intrinsic *row, value *out)
{
    const reader_options *o = in->options;

    out->as.v[0] = !o ? 0.0 : row->v[0] != 0.0 ? o->frames.has_clock : o->frames.clock;
}

static void read_version(pov_reader *in, const intrinsic *row, value *out)
{
    (void)row;
    out->as.v[0] = in->version > 0.0 ? in->version : 3.7;
}

/* Days since the beginning of the year 2000 in UTC. */
static void read_now(pov_reader *in, const intrinsic *row, value *out)
{
    struct timespec t;

    (void)in;
    (void)row;
    clock_gettime(CLOCK_REALTIME, &t);
    out->as.v[0] = ((double)t.tv_sec + 1e-9 * (double)t.tv_nsec - 946684800.0) / 86400.0;
}

static void read_defined(pov_reader *in, const intrinsic *row, value *out)
{
    (void)row;
    out->as.v[0] = array_is_defined(in);
}

static const array *read_array(pov_reader *in, value *out)
{
    *out = expression_read(in);
    if (out->kind == VALUE_ARRAY)
        return value_array(out);
    if (!in->failed)
        report_fail(in, &in->value, POV_E_SYNTAX, "expected an array, found %s", value_name(out));
    return NULL;
}

static void finish_array(pov_reader *in, value *out, double result)
{
    state_close(in, ')');
    value_drop(&in->heap, out);
    *out = value_of_number(result);
}

static void read_dimensions(pov_reader *in, const intrinsic *row, value *out)
{
    const array *a;

    (void)row;
    state_open(in, '(');
    a = read_array(in, out);
    finish_array(in, out, a ? a->dimensions : 0.0);
}

static void read_dimension_size(pov_reader *in, const intrinsic *row, value *out)
{
    const array *a;
    int32_t n;

    (void)row;
    state_open(in, '(');
    a = read_array(in, out);
    comma(in);
    n = expression_integer(expression_number(in) + EXPRESSION_NEAR);
    finish_array(in, out, a && n >= 1 && n <= a->dimensions ? (double)a->sizes[n - 1] : 0.0);
}

#define ONE(name, f) { name, read_one, f, NULL, { 0 }, 0, INTRINSIC_ONE }
#define TWO(name, form, read, f) { name, read, NULL, f, { 0 }, 0, form }
#define FORM(name, form, read) { name, read, NULL, NULL, { 0 }, 0, form }
#define READ(name, read) FORM(name, INTRINSIC_OTHER, read)
#define ONE_OF(name, form, read, f) { name, read, f, NULL, { 0 }, 0, form }
#define NUMBER(name, n) { name, read_constant, NULL, NULL, { n }, 1, INTRINSIC_CONSTANT }

static const intrinsic rows[] = {
    ONE("abs", fabs), ONE("sin", sin), ONE("cos", cos), ONE("tan", tan), ONE("atan", atan), ONE("sinh", sinh),
    ONE("cosh", cosh), ONE("tanh", tanh), ONE("asinh", asinh), ONE("acosh", acosh), ONE("atanh", atanh),
    ONE("exp", exp), ONE("int", cut), ONE("floor", floor), ONE("ceil", ceil), ONE("radians", to_radians),
    ONE("degrees", to_degrees), ONE_OF("asin", INTRINSIC_ARC, read_arc, asin),
    ONE_OF("acos", INTRINSIC_ARC, read_arc, acos), ONE_OF("ln", INTRINSIC_LOGARITHM, read_logarithm, log),
    ONE_OF("log", INTRINSIC_LOGARITHM, read_logarithm, log10), FORM("sqrt", INTRINSIC_ROOT, read_root),
    FORM("atan2", INTRINSIC_ATAN2, read_atan2), FORM("pow", INTRINSIC_POW, read_pow),
    TWO("mod", INTRINSIC_TWO, read_two, fmod), TWO("div", INTRINSIC_TWO, read_two, divide),
    TWO("min", INTRINSIC_MANY, read_many, lesser), TWO("max", INTRINSIC_MANY, read_many, greater),
    TWO("bitwise_and", INTRINSIC_BITS, read_bits, bits_and), TWO("bitwise_or", INTRINSIC_BITS, read_bits, bits_or),
    TWO("bitwise_xor", INTRINSIC_BITS, read_bits, bits_xor), FORM("select", INTRINSIC_SELECT, read_select),
    READ("seed", read_seed), FORM("rand", INTRINSIC_RAND, read_rand), READ("now", read_now),
    READ("defined", read_defined), READ("dimensions", read_dimensions), READ("dimension_size", read_dimension_size),
    READ("version", read_version), READ("clock", read_clock),
    { "clock_on", read_clock, NULL, NULL, { 1.0 }, 0, INTRINSIC_OTHER }, NUMBER("pi", 3.14159265358979323846),
    NUMBER("true", 1.0), NUMBER("yes", 1.0), NUMBER("on", 1.0), NUMBER("false", 0.0), NUMBER("no", 0.0),
    NUMBER("off", 0.0), { "x", read_constant, NULL, NULL, { 1.0, 0.0, 0.0 }, 3, INTRINSIC_CONSTANT },
    { "y", read_constant, NULL, NULL, { 0.0, 1.0, 0.0 }, 3, INTRINSIC_CONSTANT },
    { "z", read_constant, NULL, NULL, { 0.0, 0.0, 1.0 }, 3, INTRINSIC_CONSTANT },
    { "t", read_constant, NULL, NULL, { 0.0, 0.0, 0.0, 1.0 }, 4, INTRINSIC_CONSTANT },
    { "u", read_constant, NULL, NULL, { 1.0, 0.0 }, 2, INTRINSIC_CONSTANT },
    { "v", read_constant, NULL, NULL, { 0.0, 1.0 }, 2, INTRINSIC_CONSTANT },
};

static void note(symbols *words, intrinsic_list list)
{
    size_t i;

    for (i = 0; i < list.count; i++)
        symbols_named(words, list.rows[i].name)->intrinsic = &list.rows[i];
}

void intrinsic_init(symbols *words)
{
    const intrinsic_list own = { rows, sizeof rows / sizeof rows[0] };

    note(words, own);
    note(words, intrinsic_vector_rows());
    note(words, intrinsic_string_rows());
    note(words, intrinsic_object_rows());
}
