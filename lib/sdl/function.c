#include "sdl/function.h"

#include "function/internal.h"
#include "sdl/expression.h"
#include "sdl/formula.h"
#include "sdl/function_host.h"
#include "sdl/parse_pattern.h"
#include "sdl/parse_texture.h"
#include "sdl/report.h"
#include "sdl/spline.h"
#include "sdl/textures.h"
#include "sdl/unsupported.h"
#include "texture/texture.h"

#include <string.h>

enum { PARAMETERS_MAX = 56, BUFFER = 256 };

/* ---- declaration ---- */

static bool is_parameter(const symbol *name)
{
    switch (name->id) {
    case KEYWORD_OTHER: case KEYWORD_X: case KEYWORD_Y: case KEYWORD_Z: case KEYWORD_U: case KEYWORD_V:
        return true;
    default:
        return false;
    }
}

static uint32_t read_parameters(pov_reader *in, symbol **out)
{
    uint32_t n = 0;

    in->wants_name = true;
    state_open(in, '(');
    while (!in->failed && in->token.kind != ')') {
        if (in->token.kind != TOKEN_WORD || !is_parameter(in->token.symbol))
            report_expected(in, "the name of a parameter");
        else if (n == PARAMETERS_MAX)
            report_fail(in, &in->token.at, POV_E_SYNTAX, "a function has at most %d parameters", PARAMETERS_MAX);
        if (in->failed)
            break;
        out[n++] = in->token.symbol;
        state_advance(in);
        state_accept(in, ',');
    }
    if (!in->failed && n == 0)
        report_expected(in, "the name of a parameter");
    in->wants_name = false;
    state_close(in, ')');
    return n;
}

static uint32_t default_parameters(pov_reader *in, uint32_t count, symbol **out)
{
    if (count == 2) {
        out[0] = &in->words.keywords[KEYWORD_U];
        out[1] = &in->words.keywords[KEYWORD_V];
        return 2;
    }
    out[0] = &in->words.keywords[KEYWORD_X];
    out[1] = &in->words.keywords[KEYWORD_Y];
    out[2] = &in->words.keywords[KEYWORD_Z];
    return 3;
}

static void read_internal(pov_reader *in, function *f)
{
    uint32_t number;

    state_advance(in);
    state_open(in, '(');
    number = (uint32_t)expression_integer(expression_number(in));
    if (!in->failed && internal_arguments(number) == 0 && number != 77)
        report_fail(in, &in->value, POV_E_SYNTAX, "there is no internal function %d", (int)number);
    state_close(in, ')');
    formula_internal(in, number, &f->program);
}

static void read_transform(pov_reader *in, function *f)
{
    value v;

    f->kind = FUNCTION_TRANSFORM;
    state_advance(in);
    v = parse_transform_value(in);
    if (!in->failed && !transform_compose(v.as.part, &f->map))
        report_fail(in, &in->last, POV_E_SYNTAX, "the transformation has no inverse");
}

static void read_pigment(pov_reader *in, function *f)
{
    f->kind = FUNCTION_PIGMENT;
    state_advance(in);
    f->pigment = parse_pigment_upon(in, NULL);
    if (!in->failed)
        textures_settle_pigment(in, f->pigment);
}

/* What a pattern gives at a point alone. */
static bool is_of_points(const pattern_class *class)
{
    return class->evaluate && !(class->flags & PATTERN_NEEDS_NORMAL);
}

static void read_pattern_content(pov_reader *in, pattern_reading *r)
{
    if (!parse_pattern_word(in, r))
        report_expected(in, "a pattern");
    else if (!in->failed && !is_of_points(r->parsed.pattern.class))
        report_fail(in, &in->last, POV_E_SYNTAX, "\"%s\" has no value without a surface",
                    r->parsed.pattern.class->keyword);
    parse_pattern_close(in, r);
    while (!in->failed && in->token.kind != '}')
        if (!parse_pattern_modifier(in, r))
            report_expected(in, "a modifier of the pattern or \"}\"");
}

static void read_pattern(pov_reader *in, function *f)
{
    pattern_reading r;
    block b;

    f->kind = FUNCTION_PATTERN;
    state_advance(in);
    items_open(in, &b);
    parse_pattern_begin(&r);
    read_pattern_content(in, &r);
    in->block = b.outer;
    state_close(in, '}');
    if (in->failed)
        return;
    f->pattern = parse_pattern_end(in, &r);
    textures_settle_pattern(in, f->pattern);
}

static void read_content(pov_reader *in, function *f, symbol *const *parameters, uint32_t count)
{
    switch (state_keyword(in)) {
    case KEYWORD_INTERNAL:
        read_internal(in, f);
        break;
    case KEYWORD_TRANSFORM:
        read_transform(in, f);
        break;
    case KEYWORD_PIGMENT:
        read_pigment(in, f);
        break;
    case KEYWORD_SPLINE:
        f->kind = FUNCTION_SPLINE;
        state_advance(in);
        f->spline = spline_read(in);
        f->curve = in->failed ? NULL : spline_keep(in, &f->spline);
        break;
    case KEYWORD_PATTERN:
        read_pattern(in, f);
        break;
    default:
        formula_compile(in, parameters, count, &f->program);
    }
}

value function_read(pov_reader *in) { return function_read_of(in, 3); }

value function_read_of(pov_reader *in, uint32_t wanted)
{
    symbol *parameters[PARAMETERS_MAX];
    uint32_t count;
    function *f;

    count = in->token.kind == '(' ? read_parameters(in, parameters) : default_parameters(in, wanted, parameters);
    f = state_alloc(in, sizeof *f, 16);
    if (!f)
        return value_of_number(0.0);
    f->model = in->model;
    state_open(in, '{');
    read_content(in, f, parameters, count);
    state_close(in, '}');
    return value_of_part(VALUE_FUNCTION, f);
}

/* ---- call ---- */

static void read_arguments(pov_reader *in, double *out, uint32_t count)
{
    uint32_t i;

    state_open(in, '(');
    for (i = 0; i < count && !in->failed; i++) {
        out[i] = expression_number(in);
        if (i + 1 < count)
            state_accept(in, ',');
    }
    state_close(in, ')');
}

static double run(pov_reader *in, const program *p)
{
    double own[BUFFER], *buffer = own, result = 0.0;

    if (p->capacity > BUFFER)
        buffer = env_alloc(in->model->env, p->capacity, sizeof *buffer);
    if (!buffer) {
        report_memory(in);
        return 0.0;
    }
    read_arguments(in, buffer, p->parameters);
    if (!in->failed)
        result = program_run(p, buffer);
    if (buffer != own)
        env_free(in->model->env, buffer);
    return result;
}

static value map_point(pov_reader *in, const function *f)
{
    double at[3];

    read_arguments(in, at, 3);
    return in->failed ? value_of_number(0.0) : value_of_vector(function_host_map(f, at));
}

static value colour_at(pov_reader *in, const function *f)
{
    value v = value_of_number(0.0);
    double at[3];

    read_arguments(in, at, 3);
    v.kind = VALUE_VECTOR;
    v.size = 5;
    v.is_colour = true;
    if (!in->failed)
        function_host_colours(f, &(pov_vec3){ at[0], at[1], at[2] }, 1, &v.as.v);
    return v;
}

static value number_at(pov_reader *in, const function *f)
{
    double at[3];

    read_arguments(in, at, 3);
    return value_of_number(in->failed ? 0.0 : function_host_value(f, at, 0));
}

value function_call(pov_reader *in, value callee)
{
    const function *f = callee.as.part;

    switch (f->kind) {
    case FUNCTION_SPLINE:
        return spline_call(in, value_keep(f->spline));
    case FUNCTION_TRANSFORM:
        return map_point(in, f);
    case FUNCTION_PIGMENT:
        return colour_at(in, f);
    case FUNCTION_PATTERN:
        return number_at(in, f);
    default:
        return value_of_number(run(in, &f->program));
    }
}
