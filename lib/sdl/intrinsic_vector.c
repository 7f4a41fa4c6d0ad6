#include "sdl/intrinsic.h"
#include "sdl/intrinsic.h"

#include "sdl/expression.h"
#include "sdl/noise.h"
#include "sdl/report.h"

static void comma(pov_reader *in)
{
    state_accept(in, ',');
}

static pov_vec3 only_vector(pov_reader *in)
{
    pov_vec3 v;

    state_open(in, '(');
    v = expression_vector(in);
    state_close(in, ')');
    return v;
}

static void two_vectors(pov_reader *in, pov_vec3 *a, pov_vec3 *b)
{
    state_open(in, '(');
    *a = expression_vector(in);
    comma(in);
    *b = expression_vector(in);
    state_close(in, ')');
}

static void read_vlength(pov_reader *in, const intrinsic *row, value *out)
{
    pov_vec3 v = only_vector(in);

    (void)row;
    out->as.v[0] = sqrt(pov_dot(v, v));
}

static void read_vdot(pov_reader *in, const intrinsic *row, value *out)
{
    pov_vec3 a, b;

    (void)row;
    two_vectors(in, &a, &b);
    out->as.v[0] = pov_dot(a, b);
}

static void read_vnormalize(pov_reader *in, const intrinsic *row, value *out)
{
    pov_vec3 v = only_vector(in);
    double length = sqrt(pov_dot(v, v));

    (void)row;
    if (length > 0.0)
        v = pov_vec3_of(v.x / length, v.y / length, v.z / length);
    else if (!in->failed)
        report_warn(in, &in->value, "a vector without length stays as it is");
    *out = value_of_vector(v);
}

static void read_vcross(pov_reader *in, const intrinsic *row, value *out)
{
    pov_vec3 a, b;

    (void)row;
    two_vectors(in, &a, &b);
    *out = value_of_vector(pov_cross_product(a, b));
}

static pov_vec3 turn(double degrees, pov_vec3 v, int axis)
{
    double s[2], c[2];

    transform_sincos(degrees, s, c);
    if (axis == 0)
        return pov_vec3_of(v.x, c[0] * v.y - s[0] * v.z, s[0] * v.y + c[0] * v.z);
    if (axis == 1)
        return pov_vec3_of(c[0] * v.x + s[0] * v.z, v.y, c[0] * v.z - s[0] * v.x);
    return pov_vec3_of(c[0] * v.x - s[0] * v.y, s[0] * v.x + c[0] * v.y, v.z);
}

static void read_vrotate(pov_reader *in, const intrinsic *row, value *out)
{
    pov_vec3 v, degrees;

    (void)row;
    two_vectors(in, &v, &degrees);
    *out = value_of_vector(turn(degrees.z, turn(degrees.y, turn(degrees.x, v, 0), 1), 2));
}

/* Rodrigues' formula. */
static void read_vaxis_rotate(pov_reader *in, const intrinsic *row, value *out)
{
    pov_vec3 v, axis, across;
    double degrees, length, along, s[2], c[2];

    (void)row;
    state_open(in, '(');
    v = expression_vector(in);
    comma(in);
    axis = expression_vector(in);
    comma(in);
    degrees = expression_number(in);
    state_close(in, ')');
    length = sqrt(pov_dot(axis, axis));
    axis = pov_vec3_of(axis.x / length, axis.y / length, axis.z / length);
    transform_sincos(degrees, s, c);
    across = pov_cross_product(axis, v);
    along = pov_dot(axis, v) * (1.0 - c[0]);
    *out = value_of_vector(pov_vec3_of(v.x * c[0] + across.x * s[0] + axis.x * along,
                                       v.y * c[0] + across.y * s[0] + axis.y * along,
                                       v.z * c[0] + across.z * s[0] + axis.z * along));
}

static void read_vturbulence(pov_reader *in, const intrinsic *row, value *out)
{
    turbulence t = turbulence_default();
    const noise_tables *noise;
    pov_vec3 at;

    (void)row;
    state_open(in, '(');
    t.lambda = (float)expression_number(in);
    comma(in);
    t.omega = (float)expression_number(in);
    comma(in);
    t.octaves = turbulence_octaves(expression_number(in));
    comma(in);
    at = expression_vector(in);
    state_close(in, ')');
    noise = noise_of(in);
    *out = value_of_vector(noise ? noise_vector_turbulence_at(noise, &t, at) : at);
}

#define READ(name, form, read) { name, read, NULL, NULL, { 0 }, 0, form }

static const intrinsic rows[] = {
    READ("vlength", INTRINSIC_VLENGTH, read_vlength), READ("vdot", INTRINSIC_VDOT, read_vdot), READ("vnormalize", INTRINSIC_VNORMALIZE, read_vnormalize),
    READ("vcross", INTRINSIC_VCROSS, read_vcross), READ("vrotate", INTRINSIC_OTHER, read_vrotate), READ("vaxis_rotate", INTRINSIC_OTHER, read_vaxis_rotate),
    READ("vturbulence", INTRINSIC_OTHER, read_vturbulence),
};

intrinsic_list intrinsic_vector_rows(void)
{
    intrinsic_list list = { rows, sizeof rows / sizeof rows[0] };

    return list;
}
