#include "sdl/function_host.h"

#include "sdl/expression.h"
#include "sdl/spline.h"
#include "texture/inner.h"
#include "texture/points.h"

static pov_vec3 vector_of(const double *at) { return pov_vec3_of(at[0], at[1], at[2]); }

/* In functions ripples and waves have their usual number of sources, whatever the settings say. */
static void values_of_pattern(const function *f, const texture_points *points, uint32_t n, double *out)
{
    SIMD_ALIGNED double found[LANES_MAX];
    pattern_input in;
    vec_lanes own;

    points_place(f->model, f->pattern, points, n, &own, NULL);
    in = points_input(f->model, f->pattern, points, &own, n);
    in.waves = NOISE_WAVES;
    points_values(&in, found);
    memcpy(out, found, n * sizeof *out);
}

static void put_colour(const pigment *p, double out[5])
{
    out[0] = (double)p->color.r;
    out[1] = (double)p->color.g;
    out[2] = (double)p->color.b;
    out[3] = (double)p->filter;
    out[4] = (double)p->transmit;
}

enum { SAME_LANES = 1 / (FUNCTION_LANES == (int)PROGRAM_LANES) };   /* a memo has room for what a program asks at once */

static bool is_said(const function_said *s, const function *f, const vec_lanes *at, uint32_t n)
{
    const size_t size = n * sizeof at->x[0];

    return s->of == f && s->n == n && memcmp(s->at[0], at->x, size) == 0 && memcmp(s->at[1], at->y, size) == 0 &&
           memcmp(s->at[2], at->z, size) == 0;
}

static void note_question(function_said *s, const function *f, const vec_lanes *at, uint32_t n)
{
    s->of = f;
    s->n = n;
    memcpy(s->at[0], at->x, n * sizeof at->x[0]);
    memcpy(s->at[1], at->y, n * sizeof at->y[0]);
    memcpy(s->at[2], at->z, n * sizeof at->z[0]);
}

/* The pigments there, from the memo if it has them; else it does then. */
static const pigment *recall(const function *f, const texture_points *points, uint32_t n, function_memo *memo)
{
    function_said *s;

    for (uint32_t i = 0; i < memo->count; i++)
        if (is_said(&memo->said[i], f, &points->at, n))
            return memo->said[i].found;
    memo->next = memo->count < FUNCTION_MEMO ? memo->count++ : (memo->next + 1) % FUNCTION_MEMO;
    s = &memo->said[memo->next];
    note_question(s, f, &points->at, n);
    pigment_eval(f->model, f->pigment, points, n, s->found);
    return s->found;
}

static void parts_of_pigment(const function *f, const texture_points *points, uint32_t part, uint32_t n, function_memo *memo, double *out)
{
    pigment own[LANES_MAX];
    const pigment *found = memo ? recall(f, points, n, memo) : own;
    double v[5];

    if (!memo)
        pigment_eval(f->model, f->pigment, points, n, own);
    for (uint32_t i = 0; i < n; i++) {
        put_colour(&found[i], v);
        out[i] = expression_part(v, (int)part);
    }
}

void function_host_colours(const function *f, const pov_vec3 *at, uint32_t n, double (*out)[5])
{
    texture_points points;
    pigment found[LANES_MAX];

    points.has_surface = false;
    for (uint32_t i = 0; i < n; i++)
        texture_point(&points, i, at[i], pov_vec3_of(0.0, 0.0, 0.0));
    pigment_eval(f->model, f->pigment, &points, n, found);
    for (uint32_t i = 0; i < n; i++)
        put_colour(&found[i], out[i]);
}

pov_vec3 function_host_map(const function *f, const double *at)
{
    pov_vec3 p, rest;

    transform_point(&f->map, vector_of(at), &p, &rest);
    return p;
}

static double other_value(const function *f, const double *at, uint32_t part)
{
    double v[5] = { 0.0 };
    pov_vec3 p;

    if (f->kind == FUNCTION_TRANSFORM) {
        p = function_host_map(f, at);
        v[0] = p.x;
        v[1] = p.y;
        v[2] = p.z;
    } else {
        spline_at(f->curve, at[0], v);
    }
    return expression_part(v, (int)part);
}

/* Argument a of point i is at[a * apart + i]. */
static void find_values(const function *f, const double *at, uint32_t apart, uint32_t part, uint32_t n, function_memo *memo, double *out)
{
    const double *y = at + apart, *z = y + apart;
    texture_points points;

    points.has_surface = false;
    for (uint32_t i = 0; i < n; i++)
        texture_point(&points, i, pov_vec3_of(at[i], y[i], z[i]), pov_vec3_of(0.0, 0.0, 0.0));
    if (f->kind == FUNCTION_PATTERN)
        values_of_pattern(f, &points, n, out);
    else
        parts_of_pigment(f, &points, part, n, memo, out);
}

static bool is_textural(const function *f) { return f->kind == FUNCTION_PATTERN || f->kind == FUNCTION_PIGMENT; }

double function_host_value(const void *self, const double *at, uint32_t part)
{
    double found;

    if (!is_textural(self))
        return other_value(self, at, part);
    find_values(self, at, 1, part, 1, NULL, &found);
    return found;
}

void function_host_values(const void *self, const double *at, uint32_t part, uint32_t n, void *memo, double *out)
{
    const function *f = self;

    if (is_textural(f))
        find_values(f, at, PROGRAM_LANES, part, n, memo, out);
    else
        for (uint32_t i = 0; i < n; i++) {
            /* A spline has one argument only. */
            const bool is_curve = f->kind != FUNCTION_TRANSFORM;
            const double one[3] = { at[i], is_curve ? 0.0 : at[PROGRAM_LANES + i], is_curve ? 0.0 : at[2 * PROGRAM_LANES + i] };

            out[i] = other_value(f, one, part);
        }
}
