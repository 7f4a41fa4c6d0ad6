#include "sdl/calc.h"

#include "sdl/expression.h"
#include "sdl/function.h"
#include "sdl/macro.h"

#include <string.h>

/* The streams of random numbers go back to where they were if the expression is read after all. */
typedef struct work {
    double arguments[CALC_ARGUMENTS];
    random_stream *streams[CALC_RANDOMS];
    uint32_t before[CALC_RANDOMS];
    int taken;
} work;

/* ---- names ---- */

static bool load_number(const value *v, double *r, const calc_name *n)
{
    r[n->to] = v->as.v[0];
    return v->kind == VALUE_NUMBER;
}

static bool load_vector(const value *v, double *r, const calc_name *n)
{
    if (v->kind != VALUE_VECTOR || v->size != n->size || v->is_colour != n->is_colour)
        return false;
    memcpy(r + n->to, v->as.v, sizeof v->as.v);
    return true;
}

static bool is_array(const value *v, const calc_name *n)
{
    const array *a = value_array(v);

    return v->kind == VALUE_ARRAY && a->dimensions == n->to && (a->kind == VALUE_NUMBER || a->kind == VALUE_VECTOR) &&
           a->size == n->size;
}

static bool load(const calc_name *n, double *r)
{
    const binding *b = n->symbol->binding;

    if (!b)
        return false;
    switch (n->kind) {
    case VALUE_NUMBER:
        return load_number(b->slot, r, n);
    case VALUE_VECTOR:
        return load_vector(b->slot, r, n);
    case VALUE_ARRAY:
        return is_array(b->slot, n);
    case VALUE_MACRO:
        return b->slot->kind == VALUE_MACRO && ((const macro *)b->slot->as.shared)->number == n->size;
    default:
        return b->slot->kind == VALUE_FUNCTION && b->slot->as.part == n->part;
    }
}

/* ---- steps ---- */

static bool is_equal(double a, double b)
{
    return !(fabs(a - b) > EXPRESSION_NEAR);
}

/* False: it is none of these. */
static bool compare(const calc_step *s, double *r)
{
    const double a = r[s->a], b = r[s->b];

    switch ((calc_op)s->op) {
    case CALC_BELOW: r[s->to] = a < b; break;
    case CALC_ABOVE: r[s->to] = a > b; break;
    case CALC_AT_MOST: r[s->to] = a < b || is_equal(a, b); break;
    case CALC_AT_LEAST: r[s->to] = a > b || is_equal(a, b); break;
    case CALC_EQUAL: r[s->to] = is_equal(a, b); break;
    case CALC_UNEQUAL: r[s->to] = !is_equal(a, b); break;
    case CALC_AND: r[s->to] = expression_is_true(a) && expression_is_true(b); break;
    case CALC_OR: r[s->to] = expression_is_true(a) || expression_is_true(b); break;
    case CALC_SAME: r[s->to] = a == b; break;
    default: return false;
    }
    return true;
}

/* What is of numbers within a range only: false outside of it. */
static bool limited(const calc *c, const calc_step *s, double *r)
{
    const double a = r[s->a], b = r[s->b];

    switch ((calc_op)s->op) {
    case CALC_ARC:
        r[s->to] = c->row[s->c]->of_one(a);
        return fabs(a) <= 1.0;
    case CALC_LOGARITHM:
        r[s->to] = c->row[s->c]->of_one(a);
        return a > 0.0;
    case CALC_ROOT:
        r[s->to] = sqrt(a);
        return !(a < 0.0);
    case CALC_ATAN2:
        r[s->to] = atan2(a, b);
        return !(fabs(a) <= EXPRESSION_NEAR && fabs(b) <= EXPRESSION_NEAR);
    default:
        r[s->to] = pow(a, b);
        return !(a == 0.0 && b == 0.0);
    }
}

static bool subscript(const calc *c, const calc_step *s, double *r)
{
    const double number = r[s->a] + EXPRESSION_NEAR;
    const double size = (double)value_array(c->name[s->b].symbol->binding->slot)->sizes[s->c];

    if (!(number >= 0.0 && number < size))
        return false;
    r[s->to] = (s->c == 0 ? 0.0 : r[s->to] * size) + (double)(size_t)number;
    return true;
}

static bool take_element(const calc *c, const calc_step *s, double *r)
{
    const calc_name *n = &c->name[s->b];
    const value *v = &value_array(n->symbol->binding->slot)->items[(size_t)r[s->a]];

    if (v->kind == VALUE_NOTHING || v->size != n->size || v->is_colour != n->is_colour)
        return false;
    memcpy(r + s->to, v->as.v, (n->size > 1 ? CALC_COMPONENTS : 1) * sizeof *r);
    return true;
}

static bool take_random(pov_reader *in, const calc_step *s, double *r, work *w)
{
    const double handle = r[s->a];
    random_stream *stream;

    if (!(handle >= 0.0 && handle < (double)in->randoms.count))
        return false;
    stream = &in->randoms.items[(size_t)handle];
    w->streams[w->taken] = stream;
    w->before[w->taken++] = stream->state;
    stream->state = stream->state * 1812433253u + 12345u;
    r[s->to] = (double)stream->state / 4294967295.0;
    return true;
}

static pov_vec3 vector_at(const double *r)
{
    return pov_vec3_of(r[0], r[1], r[2]);
}

static void put_vector(double *r, pov_vec3 v)
{
    r[0] = v.x;
    r[1] = v.y;
    r[2] = v.z;
}

static bool normalise(double *to, pov_vec3 v)
{
    const double length = sqrt(pov_dot(v, v));

    put_vector(to, pov_vec3_of(v.x / length, v.y / length, v.z / length));
    return length > 0.0;
}

/* What is rarer than arithmetic. False: it is not to be computed here. */
static bool run_other(pov_reader *in, const calc *c, const calc_step *s, double *r, work *w)
{
    switch ((calc_op)s->op) {
    case CALC_TRUE: r[s->to] = expression_is_true(r[s->a]); return true;
    case CALC_NOT: r[s->to] = !expression_is_true(r[s->a]); return true;
    case CALC_PICK: r[s->to] = r[s->a] != 0.0 ? r[s->b] : r[s->c]; return true;
    case CALC_GRAY: r[s->to] = 0.297 * r[s->a] + 0.589 * r[s->b] + 0.114 * r[s->c]; return true;
    case CALC_CUT: r[s->to] = expression_integer(r[s->a]); return true;
    case CALC_ARC: case CALC_LOGARITHM: case CALC_ROOT: case CALC_ATAN2: case CALC_POW:
        return limited(c, s, r);
    case CALC_SUBSCRIPT: return subscript(c, s, r);
    case CALC_ELEMENT: return take_element(c, s, r);
    case CALC_CALL:
        r[s->to] = program_run(&((const function *)c->name[s->b].part)->program, w->arguments);
        return true;
    case CALC_VLENGTH: r[s->to] = sqrt(pov_dot(vector_at(r + s->a), vector_at(r + s->a))); return true;
    case CALC_VDOT: r[s->to] = pov_dot(vector_at(r + s->a), vector_at(r + s->b)); return true;
    case CALC_VCROSS: put_vector(r + s->to, pov_cross_product(vector_at(r + s->a), vector_at(r + s->b))); return true;
    case CALC_VNORMALIZE: return normalise(r + s->to, vector_at(r + s->a));
    case CALC_RAND: return take_random(in, s, r, w);
    default: return compare(s, r);
    }
}

static bool give_back(work *w)
{
    while (w->taken > 0) {
        w->taken--;
        w->streams[w->taken]->state = w->before[w->taken];
    }
    return false;
}

static bool run_steps(pov_reader *in, const calc *c, double *r)
{
    const calc_step *s = c->step, *end = s + c->steps;
    work w;

    w.taken = 0;
    for (; s < end; s++) {
        switch ((calc_op)s->op) {
        case CALC_COPY: r[s->to] = r[s->a]; break;
        case CALC_ADD: r[s->to] = r[s->a] + r[s->b]; break;
        case CALC_SUBTRACT: r[s->to] = r[s->a] - r[s->b]; break;
        case CALC_MULTIPLY: r[s->to] = r[s->a] * r[s->b]; break;
        case CALC_DIVIDE:
            if (r[s->b] == 0.0)
                return give_back(&w);
            r[s->to] = r[s->a] / r[s->b];
            break;
        case CALC_NEGATE: r[s->to] = -r[s->a]; break;
        case CALC_ONE: r[s->to] = c->row[s->c]->of_one(r[s->a]); break;
        case CALC_TWO: r[s->to] = c->row[s->c]->of_two(r[s->a], r[s->b]); break;
        case CALC_ARGUMENT: w.arguments[s->b] = r[s->a]; break;
        default:
            if (!run_other(in, c, s, r, &w))
                return give_back(&w);
        }
    }
    return true;
}

bool calc_run(pov_reader *in, calc *c, double r[CALC_REGISTERS])
{
    unsigned i;

    for (i = 0; i < c->names; i++)
        if (!load(&c->name[i], r)) {
            c->misses++;
            return false;
        }
    for (i = 0; i < c->constants; i++)
        r[i] = c->constant[i];
    return run_steps(in, c, r);
}

value calc_value(const calc *c, const double r[CALC_REGISTERS])
{
    value v;
    int i;

    v.kind = c->kind;
    v.is_colour = c->is_colour;
    v.is_part = c->is_part;
    v.size = c->size;
    for (i = 0; i < CALC_COMPONENTS; i++)
        v.as.v[i] = r[c->result[i]];
    return v;
}
