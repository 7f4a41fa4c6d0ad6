#include "sdl/spline.h"

#include "sdl/expression.h"
#include "sdl/report.h"

#include <string.h>

typedef struct knot {
    double at, v[5];
    double second[5];            /* derivatives, of the natural spline */
} knot;

struct spline {
    shared head;
    keyword_id type;
    int size, count;             /* components, knots */
    knot knots[];                /* in the order of their parameters */
};

enum { KNOTS_MAX = 1 << 20 };

/* ---- reading ---- */

static spline *create(pov_reader *in, int capacity)
{
    spline *s = in->failed ? NULL : value_share(&in->heap, VALUE_SPLINE, sizeof *s + (size_t)capacity * sizeof(knot));

    if (!s)
        report_memory(in);
    return s;
}

static spline *copy(pov_reader *in, const spline *from, int capacity)
{
    spline *s = create(in, capacity);

    if (!s)
        return NULL;
    s->type = from->type;
    s->size = from->size;
    s->count = from->count;
    memcpy(s->knots, from->knots, (size_t)from->count * sizeof(knot));
    return s;
}

/* A second knot of the same parameter takes the place of the first one, but is left out at the end: as POV-Ray does. */
static void insert(spline *s, const knot *k)
{
    int i = s->count, j;

    while (i > 0 && s->knots[i - 1].at > k->at)
        i--;
    if (i > 0 && s->knots[i - 1].at == k->at) {
        if (i == 1 || i < s->count)
            s->knots[i - 1] = *k;
        return;
    }
    for (j = s->count; j > i; j--)
        s->knots[j] = s->knots[j - 1];
    s->knots[i] = *k;
    s->count++;
}

static bool is_type(keyword_id keyword)
{
    return keyword == KEYWORD_LINEAR_SPLINE || keyword == KEYWORD_QUADRATIC_SPLINE ||
           keyword == KEYWORD_CUBIC_SPLINE || keyword == KEYWORD_NATURAL_SPLINE;
}

static keyword_id read_type(pov_reader *in, keyword_id otherwise)
{
    keyword_id type = state_keyword(in);

    if (!is_type(type))
        return otherwise;
    state_advance(in);
    return type;
}

static void read_knot(pov_reader *in, knot *k, int *size)
{
    value v;
    int i;

    k->at = expression_number(in);
    state_accept(in, ',');
    v = expression_read(in);
    if (v.kind != VALUE_NUMBER && v.kind != VALUE_VECTOR)
        expression_to_vector(in, &v);
    for (i = 0; i < 5; i++)
        k->v[i] = v.kind == VALUE_NUMBER ? v.as.v[0] : i < v.size ? v.as.v[i] : 0.0;
    if (v.size > *size)
        *size = v.size;
}

/* The name of a spline, or of an array of splines, is next. */
static bool name_follows(const pov_reader *in)
{
    const value *v = in->token.kind == TOKEN_WORD ? scope_value(in->token.symbol) : NULL;

    return v && (v->kind == VALUE_SPLINE || (v->kind == VALUE_ARRAY && value_array(v)->kind == VALUE_SPLINE));
}

static spline *take_named(pov_reader *in)
{
    value v = expression_operand(in);   /* a sign behind it is that of the next point */
    spline *s = NULL;

    if (!in->failed && v.kind == VALUE_SPLINE)
        s = copy(in, (const spline *)v.as.shared, ((const spline *)v.as.shared)->count + 16);
    else if (!in->failed)
        report_fail(in, &in->value, POV_E_SYNTAX, "expected a spline, found %s", value_name(&v));
    if (value_is_shared(&v))
        value_drop(&in->heap, &v);
    return s;
}

static spline *begin(pov_reader *in)
{
    spline *s;

    if (!name_follows(in)) {
        s = create(in, 16);
        if (s) {
            s->size = 2;
            s->type = read_type(in, KEYWORD_LINEAR_SPLINE);
        }
        return s;
    }
    s = take_named(in);
    state_accept(in, ',');
    if (s)
        s->type = read_type(in, s->type);
    return s;
}

static spline *read_knots(pov_reader *in, spline *s)
{
    int capacity = s->count + 16;

    while (!in->failed && in->token.kind != '}') {
        knot k;

        if (s->count == capacity) {
            spline *longer = copy(in, s, 2 * capacity);

            if (!longer)
                break;
            value_unshare(&in->heap, &s->head);
            s = longer;
            capacity *= 2;
        }
        read_knot(in, &k, &s->size);
        insert(s, &k);
        state_accept(in, ',');
    }
    return s;
}

/* Second derivatives of the natural spline, by elimination from the front. */
static void solve(knot *k, int count, int c, double *ratio)
{
    int i;

    ratio[0] = 0.0;
    for (i = 1; i < count - 1; i++) {
        double left = k[i].at - k[i - 1].at, right = k[i + 1].at - k[i].at;
        double pivot = 2.0 * (left + right) - left * ratio[i - 1];
        double jump = 6.0 * ((k[i + 1].v[c] - k[i].v[c]) / right - (k[i].v[c] - k[i - 1].v[c]) / left);

        ratio[i] = right / pivot;
        k[i].second[c] = (jump - left * k[i - 1].second[c]) / pivot;
    }
    for (i = count - 2; i > 0; i--)
        k[i].second[c] -= ratio[i] * k[i + 1].second[c];
}

static void settle(pov_reader *in, spline *s)
{
    double *ratio = in->failed ? NULL : env_alloc(in->model->env, (size_t)s->count, sizeof *ratio);
    int i, c;

    if (!ratio) {
        report_memory(in);
        return;
    }
    for (i = 0; i < s->count; i++)
        memset(s->knots[i].second, 0, sizeof s->knots[i].second);
    for (c = 0; c < s->size; c++)
        solve(s->knots, s->count, c, ratio);
    env_free(in->model->env, ratio);
}

value spline_read(pov_reader *in)
{
    value v = value_of_number(0.0);
    spline *s;

    state_open(in, '{');
    s = begin(in);
    if (!s)
        return v;
    s = read_knots(in, s);
    if (!in->failed && s->count == 0)
        report_expected(in, "the first point of the spline");
    settle(in, s);
    state_close(in, '}');
    v.kind = VALUE_SPLINE;
    v.as.shared = &s->head;
    return v;
}

/* ---- between the points, one component ---- */

static double linear(const knot *k, int c, double t)
{
    return k[0].v[c] + (k[1].v[c] - k[0].v[c]) * (t - k[0].at) / (k[1].at - k[0].at);
}

/* The parabola through three points. */
static double quadratic(const knot *k, int c, double t)
{
    double a = (t - k[1].at) * (t - k[2].at) / ((k[0].at - k[1].at) * (k[0].at - k[2].at));
    double b = (t - k[0].at) * (t - k[2].at) / ((k[1].at - k[0].at) * (k[1].at - k[2].at));
    double d = (t - k[0].at) * (t - k[1].at) / ((k[2].at - k[0].at) * (k[2].at - k[1].at));

    return a * k[0].v[c] + b * k[1].v[c] + d * k[2].v[c];
}

static double slope(const knot *k, int c)
{
    double after = (k[1].v[c] - k[0].v[c]) / (k[1].at - k[0].at);
    double before = (k[0].v[c] - k[-1].v[c]) / (k[0].at - k[-1].at);

    return (after + before) / 2.0;
}

/* Hermite's, with the mean of the slopes on both sides of a point. */
static double cubic(const knot *k, int c, double t)
{
    double h = k[1].at - k[0].at, s = (t - k[0].at) / h;

    return (2.0 * s * s * s - 3.0 * s * s + 1.0) * k[0].v[c] + (s * s * s - 2.0 * s * s + s) * h * slope(k, c) +
           (3.0 * s * s - 2.0 * s * s * s) * k[1].v[c] + (s * s * s - s * s) * h * slope(k + 1, c);
}

/* With the second derivatives at both ends. */
static double natural(const knot *k, int c, double t)
{
    const double h = k[1].at - k[0].at, a = (k[1].at - t) / h, b = (t - k[0].at) / h;

    return a * k[0].v[c] + b * k[1].v[c] +
           ((a * a * a - a) * k[0].second[c] + (b * b * b - b) * k[1].second[c]) * h * h / 6.0;
}

static int segment_of(const spline *s, double t)
{
    int i = 0;

    while (i + 2 < s->count && t >= s->knots[i + 1].at)
        i++;
    return i;
}

static double component(const spline *s, keyword_id type, int c, double t)
{
    const int first = type == KEYWORD_CUBIC_SPLINE && s->count > 2, last = s->count - 1 - first;
    int i;

    if (s->count == 2 && type == KEYWORD_CUBIC_SPLINE)
        return (s->knots[0].v[c] + s->knots[1].v[c]) / 2.0;   /* as POV-Ray has it */
    if (s->count == 1 || t <= s->knots[first].at)
        return s->knots[s->count == 1 ? 0 : first].v[c];
    if (t >= s->knots[last].at)
        return s->knots[last].v[c];
    i = segment_of(s, t);
    if (s->count == 2 || type == KEYWORD_LINEAR_SPLINE)
        return linear(s->knots + i, c, t);
    if (type == KEYWORD_QUADRATIC_SPLINE)
        return quadratic(s->knots + (i > 0 ? i - 1 : 0), c, t);
    return type == KEYWORD_CUBIC_SPLINE ? cubic(s->knots + i, c, t) : natural(s->knots + i, c, t);
}

const spline *spline_keep(pov_reader *in, const value *v)
{
    const spline *s = (const spline *)v->as.shared;
    const size_t bytes = sizeof *s + (size_t)s->count * sizeof(knot);
    spline *kept = state_alloc(in, bytes, sizeof(double));

    return kept ? memcpy(kept, s, bytes) : NULL;
}

void spline_at(const spline *s, double t, double out[5])
{
    int i;

    for (i = 0; i < 5; i++)
        out[i] = i < s->size ? component(s, s->type, i, t) : 0.0;
}

value spline_call(pov_reader *in, value callee)
{
    const spline *s = (const spline *)callee.as.shared;
    keyword_id type = s->type;
    value v = value_of_number(0.0);
    double t;
    int i;

    state_open(in, '(');
    t = expression_number(in);
    if (state_accept(in, ',')) {
        if (!is_type(state_keyword(in)))
            report_expected(in, "a type of spline");
        type = read_type(in, type);
    }
    state_close(in, ')');
    if (!in->failed) {
        v.kind = VALUE_VECTOR;
        v.size = s->size;
        for (i = 0; i < s->size; i++)
            v.as.v[i] = component(s, type, i, t);
    }
    value_drop(&in->heap, &callee);
    return v;
}
