#include "sdl/host_parts.h"

#include "function/form.h"
#include "function/slope.h"
#include "sdl/function.h"
#include "sdl/function_host.h"
#include "sdl/parse.h"
#include "sdl/report.h"

#include <string.h>

/* ---- functions ---- */

typedef struct served { pov_function service; const function *of; } served;

static double value_of_formula(const pov_function *self, const double *arguments, double *memory)
{
    const program *p = &((const served *)(const void *)self)->of->program;

    memcpy(memory, arguments, p->parameters * sizeof *memory);
    return program_run(p, memory);
}

/* A pattern or a pigment, of which the first component counts. */
static double value_of_other(const pov_function *self, const double *arguments, double *memory)
{
    (void)memory;
    return function_host_value(((const served *)(const void *)self)->of, arguments, 0);
}

enum { SAME_LANES = 1 / (POV_VALUES == (int)PROGRAM_LANES) };   /* a program's lanes are those of the interface */

static void values_of_formula(const pov_function *self, const double *arguments, uint32_t n, double *memory, double *out)
{
    const program *p = &((const served *)(const void *)self)->of->program;

    memcpy(memory, arguments, p->parameters * POV_VALUES * sizeof *memory);
    program_run_many(p, memory, n, NULL, out);
}

static void values_of_other(const pov_function *self, const double *arguments, uint32_t n, double *memory, double *out)
{
    (void)memory;
    function_host_values(((const served *)(const void *)self)->of, arguments, 0, n, NULL, out);
}

const pov_function *host_function(pov_reader *in, uint32_t n)
{
    const value v = in->failed ? value_of_number(0.0) : function_read_of(in, n);
    served *s = in->failed ? NULL : state_alloc(in, sizeof *s, 16);
    bool is_formula;

    if (!s)
        return NULL;
    s->of = v.as.part;
    if (s->of->kind != FUNCTION_FORMULA && s->of->kind != FUNCTION_PATTERN && s->of->kind != FUNCTION_PIGMENT) {
        report_fail(in, &in->last, POV_E_SYNTAX, "expected a function that gives a number");
        return NULL;
    }
    is_formula = s->of->kind == FUNCTION_FORMULA;
    s->service.value = is_formula ? value_of_formula : value_of_other;
    s->service.values = is_formula ? values_of_formula : values_of_other;
    s->service.parameters = is_formula ? s->of->program.parameters : 3;
    s->service.memory = is_formula ? s->of->program.capacity : 1;
    s->service.memory_many = is_formula ? (uint32_t)program_lanes_capacity(&s->of->program) : 1;
    return &s->service;
}

const function *host_function_of(const pov_function *f) { return ((const served *)(const void *)f)->of; }

typedef struct bounded { pov_function_bounds service; tape tape; } bounded;

static const pov_form *bounds_over(const pov_function_bounds *self, pov_form *memory)
{
    const tape *t = &((const bounded *)(const void *)self)->tape;

    form_run(t, memory);
    return &memory[t->result];
}

static const pov_slope *slopes_at(const pov_function_bounds *self, pov_slope *memory)
{
    const tape *t = &((const bounded *)(const void *)self)->tape;

    slope_run(t, memory);
    return &memory[t->result];
}

const pov_function_bounds *host_function_bounds(pov_reader *in, const pov_function *f)
{
    const function *of = in->failed || !f ? NULL : host_function_of(f);
    tape t = { 0 };
    tape_outcome outcome;
    bounded *b;

    if (!of || of->kind != FUNCTION_FORMULA)
        return NULL;
    outcome = tape_record(in->model->env, &of->program, &t);
    if (outcome == TAPE_NO_MEMORY)
        report_memory(in);
    if (outcome != TAPE_RECORDED)
        return NULL;
    b = state_alloc(in, sizeof *b + t.count * sizeof *t.steps, 16);
    if (b) {
        memcpy(b + 1, t.steps, t.count * sizeof *t.steps);
        b->service.over = bounds_over;
        b->service.at = slopes_at;
        b->service.registers = t.registers;
        b->tape = t;
        b->tape.steps = (const tape_step *)(const void *)(b + 1);
    }
    env_free(in->model->env, (void *)(uintptr_t)t.steps);
    return b ? &b->service : NULL;
}

/* ---- transformations ---- */

static bool is_identity(const pov_affine *map)
{
    static const pov_affine none;

    return memcmp(map, &none, sizeof none) == 0;
}

/* The map of the list behind another one: as a matrix, rounded to double. */
static bool compose_behind(pov_reader *in, const transform *list, const pov_affine *before, pov_affine *out)
{
    const transform *all = NULL;
    double m[12];

    if (is_identity(before))
        return transform_compose(list, out);
    for (int i = 0; i < 12; i++)
        m[i] = before->m[i % 3][i / 3];
    all = transform_append(&in->model->maps, NULL, TRANSFORM_MATRIX, m);
    parse_append_transforms(in, &all, list, NULL);
    return transform_compose(all, out);
}

static bool is_move(keyword_id word)
{
    return word == KEYWORD_TRANSLATE || word == KEYWORD_ROTATE || word == KEYWORD_SCALE || word == KEYWORD_MATRIX ||
           word == KEYWORD_TRANSFORM;
}

bool host_transform(pov_reader *in, pov_affine *map)
{
    const transform *list = NULL;
    pov_affine made;

    while (!in->failed && is_move(state_keyword(in))) {
        const keyword_id word = state_keyword(in);

        state_advance(in);
        parse_transform(in, &list, word);
    }
    if (in->failed || !list || !compose_behind(in, list, map, &made))
        return false;
    parse_component_move(in, list);
    *map = made;
    return true;
}
