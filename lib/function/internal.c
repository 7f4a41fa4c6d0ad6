#include "function/internal.h"

#include <math.h>
#include <stddef.h>

static const double pi = 3.14159265358979323846;

static double sq(double a) { return a * a; }
static double cube(double a) { return a * a * a; }
static double fourth(double a) { return a * a * a * a; }
static double least(double a, double b) { return b < a ? b : a; }
static double most(double a, double b) { return b > a ? b : a; }
static double length2(double a, double b) { return sqrt(a * a + b * b); }
static double length3(double a, double b, double c) { return sqrt(a * a + b * b + c * c); }
static double if_below(double a, double b, double c) { return a < 0.0 ? b : c; }
static double if_zero(double a, double b, double c) { return a == 0.0 ? b : c; }

/* Without whole turns. */
static double fold(double angle) { return angle - 2.0 * pi * floor(angle / (2.0 * pi)); }

/* The radius of a point in a cross section of that kind: 0 square, 1 circle, 2 diamond, 3 concave. */
static double section(double a, double b, double t)
{
    a = fabs(a);
    b = fabs(b);
    if (t == 0.0)
        return most(a, b);
    if (t == 1.0)
        return length2(a, b);
    return pow(pow(a, 2.0 / t) + pow(b, 2.0 / t), t / 2.0);
}

/* The distance to the nearest even multiple of w. */
static double to_thread(double v, double w) { return v - 2.0 * w * floor(v / (2.0 * w) + 0.5); }

/* A formula, compiled, and its text: tapes are recorded from that (tape_text.c). */
#define FORMULA(name, ...) FORMULA_AS(name, __VA_ARGS__)
#define FORMULA_AS(name, ...) \
    static const char name##_text[] = #__VA_ARGS__; \
    static double name(double x, double y, double z, const double *p) \
    { \
        (void)x; \
        (void)y; \
        (void)z; \
        (void)p; \
        return __VA_ARGS__; \
    }

/* Parts of several of them. */
#define U (x * x + z * z)
#define R2 (x * x + y * y + z * z)
#define RADIUS length2(x, z)

/* ---- surfaces whose value is limited to 10, and scaled by their first parameter p[0] ---- */

FORMULA(bicorn, y * y * (p[1] * p[1] - U) - sq(U + 2.0 * p[1] * y - p[1] * p[1]))
FORMULA(bifolia, p[1] * y * U - sq(U + y * y))

#define Q (x * x + y * y)
#define Z2 (z * z)
#define Z4 (Z2 * Z2)
#define W (1.0 - z)
FORMULA(boy_surface,
        p[1] * (64.0 * cube(W) * cube(z) - 48.0 * W * W * Z2 * (3.0 * Q + 2.0 * Z2) +
                12.0 * W * z * (27.0 * Q * Q - 24.0 * Z2 * Q + 36.0 * sqrt(2.0) * y * z * (y * y - 3.0 * x * x) + 4.0 * Z4) +
                (9.0 * Q - 2.0 * Z2) * (-81.0 * Q * Q - 72.0 * Z2 * Q +
                                        108.0 * sqrt(2.0) * x * z * (x * x - 3.0 * y * y) + 4.0 * Z4)))
#undef Q
#undef Z2
#undef Z4
#undef W

FORMULA(crossed_trough, x * x * z * z - y)
FORMULA(cubic_saddle, z + cube(y) - cube(x))
FORMULA(cushion,
        z * z * x * x - fourth(z) - 2.0 * z * z + 2.0 * cube(z) + x * x - fourth(x) - 2.0 * x * x * y * y -
        fourth(y) + y * y * (1.0 + 2.0 * z - z * z))
FORMULA(devils_curve, fourth(y) - 0.25 * y * y - sq(U) + 0.36 * x * x)
FORMULA(folium_surface, (y * y + z * z) * (1.0 - (4.0 * p[1] - p[2]) * x) + (1.0 + p[2]) * x * x)
FORMULA(glob, 0.5 * x * fourth(x) + 0.5 * fourth(x) - y * y - z * z)
FORMULA(heart, -(cube(2.0 * x * x + y * y + z * z - 1.0) - 0.1 * x * x * cube(z) - y * y * cube(z)))
FORMULA(hunt_surface, -(4.0 * cube(R2 - 13.0) + 27.0 * sq(3.0 * x * x + y * y - 4.0 * z * z - 12.0)))
FORMULA(hyperbolic_torus,
        4.0 * p[1] * p[1] * (x * x - z * z) - sq(x * x + y * y - z * z + p[1] * p[1] - p[2] * p[2]))
FORMULA(kampyle, p[2] * p[2] * (fourth(x) - p[1] * p[1] * x * x) - y * y - z * z)
FORMULA(klein_bottle, -((R2 + 2.0 * y - 1.0) * (sq(R2 - 2.0 * y - 1.0) - 8.0 * z * z) + 16.0 * x * z * (R2 - 2.0 * y - 1.0)))
FORMULA(kummer1,
        -(fourth(x) + fourth(y) + fourth(z) - x * x - y * y - z * z - x * x * y * y - y * y * z * z -
          z * z * x * x + 1.0))
FORMULA(kummer2,
        1.0 - (fourth(x) + fourth(y) + fourth(z) + p[1] * R2 +
               p[2] * (x * x * y * y + y * y * z * z + z * z * x * x) + p[3] * x * y * z))
FORMULA(gerono, x * x - fourth(x) - y * y - z * z)
FORMULA(mitre, y * y - fourth(y) - y * y * z * z - 4.0 * x * x * R2)
FORMULA(nodal_cubic, 6.0 * y * z - cube(y) - cube(z))
FORMULA(cassini, p[2] * p[2] + p[3] * p[1] * p[1] * U - sq(R2 + p[1] * p[1]))
FORMULA(paraboloid, y - x * x - z * z)

#define A2 (p[1] * p[1])
#define B2 (p[2] * p[2])
FORMULA(parabolic_torus, -(sq(x * x + y * y - z) + sq(A2 - B2) + (A2 + B2) * (z - x * x) + (A2 - B2) * y * y))
#undef A2
#undef B2

FORMULA(pillow, fourth(x) + fourth(y) + fourth(z) - x * x - y * y - z * z)
FORMULA(piriform, fourth(x) - cube(x) + y * y + z * z)
FORMULA(quartic_paraboloid, y - fourth(x) - fourth(z))
FORMULA(quartic_saddle, y - fourth(x) + fourth(z))
FORMULA(quartic_cylinder, p[1] * p[1] * p[2] * p[2] - U * (y * y + p[2] * p[2]))
FORMULA(steiners_roman, -(x * x * y * y + x * x * z * z + y * y * z * z + x * y * z))
FORMULA(strophoid, p[3] * p[3] * x * x * (p[1] + x) - (p[2] - x) * (y * y + z * z))
FORMULA(torus2, 4.0 * p[1] * p[1] * U - sq(R2 + p[1] * p[1] - p[2] * p[2]))

#define Q (x * x * (y * y + z * z))
FORMULA(torus_gumdrop, -(4.0 * R2 * R2 + 17.0 * Q - 8.0 * Q - 20.0 * R2 + 17.0))
#undef Q

FORMULA(umbrella, y * z * z - x * x)
FORMULA(witch, p[1] * (1.0 - y) - y * U)

#define W if_below(fabs(z) - 0.2, 0.2, z)
#define D (y * y - x * x)
FORMULA(enneper, 6.0 * sq(D / (4.0 * W)) - cube(D / (2.0 * W) + 2.0 * z * z / 9.0))
#undef W
#undef D

#define S (p[5] * p[5])
#define BIG (p[1] * p[1])
#define SMALL (p[2] * p[2])
#define N (S * S - 2.0 * S * (x * p[3] + y * p[4]) + (p[3] * p[3] + p[4] * p[4]) * R2)
FORMULA(dupin_cyclid,
        -(N * N - 2.0 * (BIG + SMALL) * (sq(S * x - p[3] * R2) + sq(S * z)) + 2.0 * (BIG - SMALL) * sq(S * y + p[4] * R2) +
          sq(BIG - SMALL) * R2 * R2))
#undef S
#undef BIG
#undef SMALL
#undef N

/* ---- plane curves, drawn out or turned about the y axis ---- */

FORMULA(cyl1, cube(fabs(x)) - x * x + y * y)
FORMULA(cyl2, 3.0 * x * x * y - 2.0 * fourth(x) - y * y + 2.0 * cube(y) - fourth(y))
FORMULA(cyl3, x * y * y + 2.0 * x * x * y - y * y - x * x * y * y - fourth(x))
FORMULA(cyl4, cube(y) - 3.0 * x * x * y - sq(x * x + y * y))
FORMULA(devils_2d, fourth(y) - p[2] * p[2] * y * y - fourth(x) + p[1] * p[1] * x * x)
FORMULA(folium_2d, -(y * y * (1.0 - (4.0 * p[1] - p[2]) * x) + (1.0 + p[2]) * x * x))
FORMULA(kampyle_2d, p[2] * p[2] * fourth(x) - p[1] * cube(p[2]) * x * x - y * y)
FORMULA(gerono_2d, p[2] * p[2] * (p[1] * p[1] * x * x - fourth(x)) - y * y)
FORMULA(piriform_2d, p[3] * p[3] * cube(x) * (p[1] + p[2] * x) - y * y)
FORMULA(strophoid_2d, p[3] * p[3] * x * x * (p[1] + x) - (p[2] - x) * y * y)
FORMULA(witch_2d, p[2] - (p[1] * p[1] + x * x) * y)

/* The point in the plane of the curve; p: switch, offset, angle in degrees. */
#define ANGLE (p[2] * (pi / 180.0))
FORMULA(curve_x, (RADIUS - p[1]) * cos(ANGLE) - y * sin(ANGLE))
FORMULA(curve_y, (RADIUS - p[1]) * sin(ANGLE) + y * cos(ANGLE))
#undef ANGLE

/* ---- all others ---- */

#define LOW ((sq(x + p[0] / 2.0) + y * y + z * z) * p[2] * p[2])
#define HIGH ((sq(x - p[0] / 2.0) + y * y + z * z) * p[4] * p[4])
FORMULA(blob, -(if_below(LOW - 1.0, p[1] * sq(1.0 - LOW), 0.0) + if_below(HIGH - 1.0, p[3] * sq(1.0 - HIGH), 0.0)))
#undef LOW
#undef HIGH

FORMULA(blob2, p[3] - p[2] * (exp(-p[1] * (x * x + (y * y + z * z))) + exp(-p[1] * (sq(x - p[0]) + (y * y + z * z)))))

#define X if_zero(U, 1e-4, x)
FORMULA(comma,
        least(length3(X - p[0] / 2.0, y, z) - p[0] / 2.0,
              most(length2(length2(X + p[0] / 4.0, z) - 0.75 * p[0], y) - p[0] / 2.0 * cos(atan2(z, X) / 2.0), -z)))
#undef X

#define E0 exp(-p[1] * (x * x + p[0] * (y * y + z * z)))
#define E1 exp(-p[1] * (y * y + p[0] * (x * x + z * z)))
#define E2 exp(-p[1] * (z * z + p[0] * (x * x + y * y)))
FORMULA(cross_ellipsoids, p[3] - p[2] * most(most(E0, E1), E2))
FORMULA(flange_cover, p[3] - p[2] * (E0 + E1 + E2))
FORMULA(isect_ellipsoids, p[3] - p[2] * least(least(E0, E1), E2))
FORMULA(spikes, p[2] * (E0 + E1 + E2 - p[4] * exp(-p[3] * R2)))
#undef E0
#undef E1
#undef E2

FORMULA(ellipsoid, length3(p[0] * x, p[1] * y, p[2] * z))

#define D length2(RADIUS - p[0], y)
#define H atan2(x, z)
#define TURN (fold(p[1] * H + p[2] * atan2(RADIUS - p[0], y)) - pi)
FORMULA(helical_torus,
        least(least(sqrt(sq(D - p[5]) + p[6] * TURN * TURN), D + p[5]) -
                  p[3] * cos(p[7] * atan2(p[8] * TURN, D - p[5]) + p[9] * H),
              RADIUS + p[0] - p[5]) - p[4])
#undef D
#undef H
#undef TURN

#define A (p[6] * (pi / 180.0))
#define D ((pi - fold((p[1] * y + atan2(z, x)) * p[0])) / (p[0] * p[1] * p[4]))
#define W (RADIUS - p[3])
FORMULA(helix1, least(RADIUS + p[3], section(W * cos(A) + D * sin(A), D * cos(A) - W * sin(A), p[5])) - p[2])
#undef A
#undef D
#undef W

#define C cos(p[1] * y)
#define S sin(p[1] * y)
FORMULA(helix2,
        section((x - p[3] * C) * C + (z - p[3] * S) * S, (z - p[3] * S) * C - (x - p[3] * C) * S, p[5]) - p[2])
#undef C
#undef S

/* Along and across the nearest axis of the nearest hexagon; their centres stand at (sqrt 3 (i + j/2), 3j/2). */
void internal_hexagon(double x, double y, internal_hex *out)
{
    const double s = sqrt(3.0), column = floor(x / s), row = floor(y / 1.5);
    double u = 0.0, v = 0.0, nearest = HUGE_VAL;

    for (int j = -1; j < 3; j++)
        for (int i = -2; i < 3; i++) {
            const double a = x - s * (column + i + 0.5 * fmod(fabs(row + j), 2.0)), b = y - 1.5 * (row + j);

            if (a * a + b * b < nearest) {
                nearest = a * a + b * b;
                u = a;
                v = b;
            }
        }
    out->along = fabs(u);
    out->across = fabs(v);
    out->x = copysign(1.0, u);
    out->y = 0.0;
    out->side = copysign(1.0, v) * out->x;
    for (int i = -1; i < 2; i += 2) {
        const double along = u * 0.5 + v * i * s / 2.0, across = v * 0.5 - u * i * s / 2.0;

        if (fabs(along) > out->along) {
            out->along = fabs(along);
            out->across = fabs(across);
            out->x = copysign(0.5, along);
            out->y = copysign(i * s / 2.0, along * i);
            out->side = copysign(1.0, across) * copysign(1.0, along);
        }
    }
}

static double hex_x(double x, double y, double z, const double *p)
{
    internal_hex h;

    (void)z;
    (void)p;
    internal_hexagon(x, y, &h);
    return h.along;
}

static double hex_y(double x, double y, double z, const double *p)
{
    internal_hex h;

    (void)z;
    (void)p;
    internal_hexagon(x, y, &h);
    return h.across;
}

#define A (p[3] * cos(pi * x / p[0]))
#define B (p[3] * cos(pi * z / p[1]))
FORMULA(mesh1,
        least(least(length2(p[2] * to_thread(z, p[1]), p[4] * (y - A)), length2(p[2] * to_thread(z - p[1], p[1]), p[4] * (y + A))),
              least(length2(p[2] * to_thread(x, p[0]), p[4] * (y + B)), length2(p[2] * to_thread(x - p[0], p[0]), p[4] * (y - B)))))
#undef A
#undef B

FORMULA(ph, atan2(RADIUS, y))
FORMULA(poly4, RADIUS + least(5.0, -(p[0] + y * (p[1] + y * (p[2] + y * (p[3] + y * p[4]))))))

/* The distance of (x, z) from a corner of a polygon of p[0] corners, whose radius is a polynomial of y. */
FORMULA(tube_radius, p[1] + y * (p[2] + y * (p[3] + y * (p[4] + y * p[5]))))

static double polytubes(double x, double y, double z, const double *p)
{
    const double r = tube_radius(x, y, z, p);
    double nearest = 10000.0;

    for (int i = 0; i < (p[0] < 1e6 ? (int)p[0] : 1000000); i++)
        nearest = least(nearest, length2(x - r * sin(2.0 * pi * i / p[0]), z - r * cos(2.0 * pi * i / p[0])));
    return nearest;
}

FORMULA(quantum, 1.2 - 1.6 * sq(U - 2.0 * y * y) * exp(-4.0 * 0.33333333 * length3(x, y, z)))
FORMULA(radius, length3(x, y, z))
FORMULA(rounded_box,
        length3(most(fabs(x) - (p[1] - p[0]), 0.0), most(fabs(y) - (p[2] - p[0]), 0.0), most(fabs(z) - (p[3] - p[0]), 0.0)) -
        p[0] - 0.000001)
FORMULA(sphere, length3(x, y, z) - p[0])
FORMULA(spikes_2d, y - p[0] * cos(p[1] * x) * cos(p[2] * z) * exp(-p[3] * U))

#define Q if_zero(U, 1e-6, RADIUS)
#define TURNS ((Q + p[0] * atan2(z, x) / (2.0 * pi)) / p[0])
FORMULA(spiral,
        most(least(section((TURNS - floor(TURNS) - 0.5) * p[0], y, p[5]), most(length3(x, y, z), Q)) - p[1],
             length3(x, y, z) - p[2]))
#undef Q
#undef TURNS

#define RATIO(a, b) if_zero(b, 1e300, a / b)
FORMULA(superellipsoid,
        1.0 - pow(pow(pow(fabs(x), RATIO(2.0, p[0])) + pow(fabs(y), RATIO(2.0, p[0])), RATIO(p[0], p[1])) +
                  pow(fabs(z), RATIO(2.0, p[1])), p[1] / 2.0))
#undef RATIO

FORMULA(th, atan2(x, z))
FORMULA(torus, length2(RADIUS - p[0], y) - p[1])

#undef U
#undef R2
#undef RADIUS

/* ---- by number ---- */

typedef struct row {
    double (*value)(double x, double y, double z, const double *p);
    uint32_t arguments;
    internal_form form;
    const char *text;
} row;

#define ROW(name, arguments, form) { name, arguments, INTERNAL_##form, name##_text }
static const row rows[] = {
    ROW(cyl1, 8, TURNED_LIMIT), ROW(cyl2, 8, TURNED_LIMIT), ROW(cyl3, 8, TURNED_LIMIT), ROW(cyl4, 8, TURNED_LIMIT),
    ROW(bicorn, 5, LIMITED), ROW(bifolia, 5, LIMITED), ROW(blob, 8, PLAIN), ROW(blob2, 7, PLAIN),
    ROW(boy_surface, 5, LIMITED), ROW(comma, 4, PLAIN), ROW(cross_ellipsoids, 7, PLAIN),
    ROW(crossed_trough, 4, LIMITED), ROW(cubic_saddle, 4, LIMITED), ROW(cushion, 4, LIMITED),
    ROW(devils_curve, 4, LIMITED), ROW(devils_2d, 9, TURNED), ROW(dupin_cyclid, 9, LIMITED), ROW(ellipsoid, 6, PLAIN),
    ROW(enneper, 4, LIMITED), ROW(flange_cover, 7, PLAIN), ROW(folium_surface, 6, LIMITED), ROW(folium_2d, 9, TURNED),
    ROW(glob, 4, LIMITED), ROW(heart, 4, LIMITED), ROW(helical_torus, 13, PLAIN), ROW(helix1, 10, PLAIN),
    ROW(helix2, 10, PLAIN), { hex_x, 4, INTERNAL_PLAIN, NULL }, { hex_y, 4, INTERNAL_PLAIN, NULL },
    { NULL, 9, INTERNAL_PLAIN, NULL }, ROW(hunt_surface, 4, LIMITED), ROW(hyperbolic_torus, 6, LIMITED),
    ROW(isect_ellipsoids, 7, PLAIN), ROW(kampyle, 6, LIMITED), ROW(kampyle_2d, 9, TURNED),
    ROW(klein_bottle, 4, LIMITED), ROW(kummer1, 4, LIMITED), ROW(kummer2, 7, LIMITED), ROW(gerono, 4, LIMITED),
    ROW(gerono_2d, 9, TURNED), ROW(mesh1, 8, PLAIN), ROW(mitre, 4, LIMITED), ROW(nodal_cubic, 4, LIMITED),
    ROW(cushion, 4, LIMITED), ROW(cassini, 7, LIMITED), ROW(paraboloid, 4, LIMITED), ROW(parabolic_torus, 6, LIMITED),
    ROW(ph, 3, PLAIN), ROW(pillow, 4, LIMITED), ROW(piriform, 4, LIMITED), ROW(piriform_2d, 10, TURNED),
    ROW(poly4, 8, PLAIN), { polytubes, 9, INTERNAL_PLAIN, NULL }, ROW(quantum, 4, PLAIN),
    ROW(quartic_paraboloid, 4, LIMITED), ROW(quartic_saddle, 4, LIMITED), ROW(quartic_cylinder, 6, LIMITED),
    ROW(radius, 3, PLAIN), { NULL, 9, INTERNAL_PLAIN, NULL }, { NULL, 9, INTERNAL_PLAIN, NULL },
    ROW(rounded_box, 7, PLAIN), ROW(sphere, 4, PLAIN), ROW(spikes, 8, PLAIN), ROW(spikes_2d, 7, PLAIN),
    ROW(spiral, 9, PLAIN), ROW(steiners_roman, 4, LIMITED), ROW(strophoid, 7, LIMITED), ROW(strophoid_2d, 10, TURNED),
    ROW(superellipsoid, 5, PLAIN), ROW(th, 3, PLAIN), ROW(torus, 5, PLAIN), ROW(torus2, 6, LIMITED),
    ROW(torus_gumdrop, 4, LIMITED), ROW(umbrella, 4, LIMITED), ROW(witch, 5, LIMITED), ROW(witch_2d, 9, TURNED),
    { NULL, 3, INTERNAL_PLAIN, NULL }, { NULL, 0, INTERNAL_PLAIN, NULL }, { NULL, 4, INTERNAL_PLAIN, NULL },
};

enum { ROWS = sizeof rows / sizeof rows[0] };

uint32_t internal_arguments(uint32_t number)
{
    return number < ROWS ? rows[number].arguments : 0;
}

const char *internal_text(uint32_t number, internal_form *form)
{
    *form = number < ROWS ? rows[number].form : INTERNAL_PLAIN;
    return number < ROWS ? rows[number].text : NULL;
}

const char *internal_curve_text(int axis) { return axis == 0 ? curve_x_text : curve_y_text; }
const char *internal_tube_text(void) { return tube_radius_text; }

static double limit(double value, double most_of_it)
{
    return least(most_of_it, most(-most_of_it, value));
}

double internal_value(uint32_t number, const double *v)
{
    const row *f = &rows[number];
    const double *p = v + 3, *turn = v + f->arguments - 3;
    double x = v[0], y = v[1], value;

    if (!f->value)
        return 0.0;
    if (f->form >= INTERNAL_TURNED && turn[0] > 0.0) {
        x = curve_x(v[0], v[1], v[2], turn);
        y = curve_y(v[0], v[1], v[2], turn);
    }
    value = f->value(x, y, v[2], p);
    if (f->form == INTERNAL_PLAIN)
        return value;
    value *= p[0];
    if (f->form == INTERNAL_TURNED_LIMIT && number == 0)
        return most(-p[1], least(p[1], value));
    return limit(value, f->form == INTERNAL_TURNED_LIMIT ? p[1] : 10.0);
}
