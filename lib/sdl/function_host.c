#include "sdl/function_host.h"

#include "sdl/expression.h"
#include "sdl/spline.h"
#include "texture/points.h"

#include <string.h>

static pov_vec3 vector_of(const double *at) { return pov_vec3_of(at[0], at[1], at[2]); }

static void put_point(const double *at, texture_points *out)
{
    out->has_surface = false;
    texture_point(NULL, vector_of(at), pov_vec3_of(0.0, 0.0, 0.0), 0, out);
}

/* In functions ripples and waves have their usual number of sources, whatever the settings say. */
static void find_values(const function *f, const texture_points *points, uint32_t n, double *found)
{
    pattern_input in;
    vec_lanes own;

    points_place(f->model, f->pattern, points, n, &own, NULL);
    in = points_input(f->model, f->pattern, points, &own, n);
    in.waves = NOISE_WAVES;
    points_values(&in, found);
}

static double value_of_pattern(const function *f, const double *at)
{
    SIMD_ALIGNED double found[LANES_MAX];
    texture_points points;

    put_point(at, &points);
    find_values(f, &points, 1, found);
    return found[0];
}

void function_host_values(const function *f, const vec_lanes *at, uint32_t n, double *out)
{
    SIMD_ALIGNED double found[LANES_MAX];
    texture_points points;

    points.has_surface = false;
    for (uint32_t i = 0; i < n; i++)
        texture_point(NULL, lanes_at(at, i), pov_vec3_of(0.0, 0.0, 0.0), i, &points);
    find_values(f, &points, n, found);
    memcpy(out, found, n * sizeof *out);
}

void function_host_colour(const function *f, const double *at, double out[5])
{
    texture_points points;
    pigment p;

    put_point(at, &points);
    pigment_eval(f->model, f->pigment, &points, 1, &p);
    out[0] = (double)p.color.r;
    out[1] = (double)p.color.g;
    out[2] = (double)p.color.b;
    out[3] = (double)p.filter;
    out[4] = (double)p.transmit;
}

pov_vec3 function_host_map(const function *f, const double *at)
{
    pov_vec3 p, rest;

    transform_point(&f->map, vector_of(at), &p, &rest);
    return p;
}

double function_host_value(const void *self, const double *at, uint32_t part)
{
    const function *f = self;
    double v[5] = { 0.0 };
    pov_vec3 p;

    switch (f->kind) {
    case FUNCTION_PATTERN:
        return value_of_pattern(f, at);
    case FUNCTION_PIGMENT:
        function_host_colour(f, at, v);
        break;
    case FUNCTION_TRANSFORM:
        p = function_host_map(f, at);
        v[0] = p.x;
        v[1] = p.y;
        v[2] = p.z;
        break;
    default:
        spline_at(f->curve, at[0], v);
    }
    return expression_part(v, (int)part);
}
