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

/* ---- surfaces whose value is limited to 10, and scaled by their first parameter p[0] ---- */

#define SURFACE(name) static double name(double x, double y, double z, const double *p)
#define PLAIN(name) SURFACE(name) { (void)p;

SURFACE(bicorn)
{
    const double a = p[1], u = x * x + z * z;

    return y * y * (a * a - u) - sq(u + 2.0 * a * y - a * a);
}

SURFACE(bifolia)
{
    const double u = x * x + z * z;

    return p[1] * y * u - sq(u + y * y);
}

SURFACE(boy_surface)
{
    const double s = sqrt(2.0), w = 1.0 - z, q = x * x + y * y, z2 = z * z, z4 = z2 * z2;

    return p[1] * (64.0 * cube(w) * cube(z) - 48.0 * w * w * z2 * (3.0 * q + 2.0 * z2) +
                   12.0 * w * z * (27.0 * q * q - 24.0 * z2 * q + 36.0 * s * y * z * (y * y - 3.0 * x * x) + 4.0 * z4) +
                   (9.0 * q - 2.0 * z2) * (-81.0 * q * q - 72.0 * z2 * q +
                                           108.0 * s * x * z * (x * x - 3.0 * y * y) + 4.0 * z4));
}

PLAIN(crossed_trough) return x * x * z * z - y; }
PLAIN(cubic_saddle) return z + cube(y) - cube(x); }
PLAIN(cushion)
    return z * z * x * x - fourth(z) - 2.0 * z * z + 2.0 * cube(z) + x * x - fourth(x) - 2.0 * x * x * y * y -
           fourth(y) + y * y * (1.0 + 2.0 * z - z * z);
}
PLAIN(devils_curve) return fourth(y) - 0.25 * y * y - sq(x * x + z * z) + 0.36 * x * x; }
SURFACE(folium_surface)
{
    return (y * y + z * z) * (1.0 - (4.0 * p[1] - p[2]) * x) + (1.0 + p[2]) * x * x;
}
PLAIN(glob) return 0.5 * x * fourth(x) + 0.5 * fourth(x) - y * y - z * z; }
PLAIN(heart)
    return -(cube(2.0 * x * x + y * y + z * z - 1.0) - 0.1 * x * x * cube(z) - y * y * cube(z));
}
PLAIN(hunt_surface)
    return -(4.0 * cube(x * x + y * y + z * z - 13.0) + 27.0 * sq(3.0 * x * x + y * y - 4.0 * z * z - 12.0));
}
SURFACE(hyperbolic_torus)
{
    const double a = p[1], b = p[2];

    return 4.0 * a * a * (x * x - z * z) - sq(x * x + y * y - z * z + a * a - b * b);
}
SURFACE(kampyle) { return p[2] * p[2] * (fourth(x) - p[1] * p[1] * x * x) - y * y - z * z; }
PLAIN(klein_bottle)
    const double r2 = x * x + y * y + z * z;

    return -((r2 + 2.0 * y - 1.0) * (sq(r2 - 2.0 * y - 1.0) - 8.0 * z * z) + 16.0 * x * z * (r2 - 2.0 * y - 1.0));
}
PLAIN(kummer1)
    return -(fourth(x) + fourth(y) + fourth(z) - x * x - y * y - z * z - x * x * y * y - y * y * z * z -
             z * z * x * x + 1.0);
}
SURFACE(kummer2)
{
    return 1.0 - (fourth(x) + fourth(y) + fourth(z) + p[1] * (x * x + y * y + z * z) +
                  p[2] * (x * x * y * y + y * y * z * z + z * z * x * x) + p[3] * x * y * z);
}
PLAIN(gerono) return x * x - fourth(x) - y * y - z * z; }
PLAIN(mitre) return y * y - fourth(y) - y * y * z * z - 4.0 * x * x * (x * x + y * y + z * z); }
PLAIN(nodal_cubic) (void)x; return 6.0 * y * z - cube(y) - cube(z); }
SURFACE(cassini)
{
    return p[2] * p[2] + p[3] * p[1] * p[1] * (x * x + z * z) - sq(x * x + y * y + z * z + p[1] * p[1]);
}
PLAIN(paraboloid) return y - x * x - z * z; }
SURFACE(parabolic_torus)
{
    const double a2 = p[1] * p[1], b2 = p[2] * p[2];

    return -(sq(x * x + y * y - z) + sq(a2 - b2) + (a2 + b2) * (z - x * x) + (a2 - b2) * y * y);
}
PLAIN(pillow) return fourth(x) + fourth(y) + fourth(z) - x * x - y * y - z * z; }
PLAIN(piriform) return fourth(x) - cube(x) + y * y + z * z; }
PLAIN(quartic_paraboloid) return y - fourth(x) - fourth(z); }
PLAIN(quartic_saddle) return y - fourth(x) + fourth(z); }
SURFACE(quartic_cylinder)
{
    return p[1] * p[1] * p[2] * p[2] - (x * x + z * z) * (y * y + p[2] * p[2]);
}
PLAIN(steiners_roman) return -(x * x * y * y + x * x * z * z + y * y * z * z + x * y * z); }
SURFACE(strophoid) { return p[3] * p[3] * x * x * (p[1] + x) - (p[2] - x) * (y * y + z * z); }
SURFACE(torus2)
{
    const double a = p[1], b = p[2];

    return 4.0 * a * a * (x * x + z * z) - sq(x * x + y * y + z * z + a * a - b * b);
}
PLAIN(torus_gumdrop)
    const double r2 = x * x + y * y + z * z, q = x * x * (y * y + z * z);

    return -(4.0 * r2 * r2 + 17.0 * q - 8.0 * q - 20.0 * r2 + 17.0);
}
PLAIN(umbrella) return y * z * z - x * x; }
SURFACE(witch) { return p[1] * (1.0 - y) - y * (x * x + z * z); }
PLAIN(enneper)
    const double w = fabs(z) < 0.2 ? 0.2 : z, d = y * y - x * x;

    return 6.0 * sq(d / (4.0 * w)) - cube(d / (2.0 * w) + 2.0 * z * z / 9.0);
}
SURFACE(dupin_cyclid)
{
    const double q = x * x + y * y + z * z, s = p[5] * p[5], a = p[3], b = p[4], big = p[1] * p[1], small = p[2] * p[2];
    const double n = s * s - 2.0 * s * (x * a + y * b) + (a * a + b * b) * q;

    return -(n * n - 2.0 * (big + small) * (sq(s * x - a * q) + sq(s * z)) + 2.0 * (big - small) * sq(s * y + b * q) +
             sq(big - small) * q * q);
}

/* ---- plane curves, drawn out or turned about the y axis ---- */

#define CURVE(name) static double name(double x, double y, double z, const double *p)
CURVE(cyl1) { (void)z; (void)p; return cube(fabs(x)) - x * x + y * y; }
CURVE(cyl2) { (void)z; (void)p; return 3.0 * x * x * y - 2.0 * fourth(x) - y * y + 2.0 * cube(y) - fourth(y); }
CURVE(cyl3) { (void)z; (void)p; return x * y * y + 2.0 * x * x * y - y * y - x * x * y * y - fourth(x); }
CURVE(cyl4) { (void)z; (void)p; return cube(y) - 3.0 * x * x * y - sq(x * x + y * y); }
CURVE(devils_2d) { (void)z; return fourth(y) - p[2] * p[2] * y * y - fourth(x) + p[1] * p[1] * x * x; }
CURVE(folium_2d) { (void)z; return -(y * y * (1.0 - (4.0 * p[1] - p[2]) * x) + (1.0 + p[2]) * x * x); }
CURVE(kampyle_2d) { (void)z; return p[2] * p[2] * fourth(x) - p[1] * cube(p[2]) * x * x - y * y; }
CURVE(gerono_2d) { (void)z; return p[2] * p[2] * (p[1] * p[1] * x * x - fourth(x)) - y * y; }
CURVE(piriform_2d) { (void)z; return p[3] * p[3] * cube(x) * (p[1] + p[2] * x) - y * y; }
CURVE(strophoid_2d) { (void)z; return p[3] * p[3] * x * x * (p[1] + x) - (p[2] - x) * y * y; }
CURVE(witch_2d) { (void)z; return p[2] - (p[1] * p[1] + x * x) * y; }

/* The point in the plane of the curve: switch, offset, angle in degrees. */
static void to_curve(double *x, double *y, double z, const double *turn)
{
    const double a = turn[2] * (pi / 180.0), r = length2(*x, z) - turn[1];

    if (turn[0] <= 0.0)
        return;
    *x = r * cos(a) - *y * sin(a);
    *y = r * sin(a) + *y * cos(a);
}

/* ---- all others ---- */

SURFACE(blob)
{
    const double s = p[2], t = p[4], low = (sq(x + p[0] / 2.0) + y * y + z * z) * s * s;
    const double high = (sq(x - p[0] / 2.0) + y * y + z * z) * t * t;

    return -((low < 1.0 ? p[1] * sq(1.0 - low) : 0.0) + (high < 1.0 ? p[3] * sq(1.0 - high) : 0.0));
}

SURFACE(blob2)
{
    const double q = y * y + z * z;

    return p[3] - p[2] * (exp(-p[1] * (x * x + q)) + exp(-p[1] * (sq(x - p[0]) + q)));
}

SURFACE(comma)
{
    const double r = x == 0.0 && z == 0.0 ? 1e-4 : x, angle = atan2(z, r);
    const double s = length3(r - p[0] / 2.0, y, z) - p[0] / 2.0;
    const double t = length2(length2(r + p[0] / 4.0, z) - 0.75 * p[0], y) - p[0] / 2.0 * cos(angle / 2.0);

    return least(s, most(t, -z));
}

static void ellipsoids(double x, double y, double z, const double *p, double e[3])
{
    x *= x;
    y *= y;
    z *= z;
    e[0] = exp(-p[1] * (x + p[0] * (y + z)));
    e[1] = exp(-p[1] * (y + p[0] * (x + z)));
    e[2] = exp(-p[1] * (z + p[0] * (x + y)));
}

SURFACE(cross_ellipsoids)
{
    double e[3];

    ellipsoids(x, y, z, p, e);
    return p[3] - p[2] * most(most(e[0], e[1]), e[2]);
}

SURFACE(flange_cover)
{
    double e[3];

    ellipsoids(x, y, z, p, e);
    return p[3] - p[2] * (e[0] + e[1] + e[2]);
}

SURFACE(isect_ellipsoids)
{
    double e[3];

    ellipsoids(x, y, z, p, e);
    return p[3] - p[2] * least(least(e[0], e[1]), e[2]);
}

SURFACE(spikes)
{
    double e[3];

    ellipsoids(x, y, z, p, e);
    return p[2] * (e[0] + e[1] + e[2] - p[4] * exp(-p[3] * (x * x + y * y + z * z)));
}

SURFACE(ellipsoid) { return length3(p[0] * x, p[1] * y, p[2] * z); }

static double fold(double angle)
{
    return angle - 2.0 * pi * floor(angle / (2.0 * pi));
}

SURFACE(helical_torus)
{
    const double u = length2(x, z), q = u - p[0], D = length2(q, y), h = atan2(x, z), g = atan2(q, y);
    const double d = fold(p[1] * h + p[2] * g) - pi;
    const double A = least(sqrt(sq(D - p[5]) + p[6] * d * d), D + p[5]) -
                     p[3] * cos(p[7] * atan2(p[8] * d, D - p[5]) + p[9] * h);

    return least(A, u + p[0] - p[5]) - p[4];
}

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

SURFACE(helix1)
{
    const double q = length2(x, z), w = q - p[3], a = p[6] * (pi / 180.0);
    const double d = (pi - fold((p[1] * y + atan2(z, x)) * p[0])) / (p[0] * p[1] * p[4]);

    return least(q + p[3], section(w * cos(a) + d * sin(a), d * cos(a) - w * sin(a), p[5])) - p[2];
}

SURFACE(helix2)
{
    const double c = cos(p[1] * y), s = sin(p[1] * y), u = x - p[3] * c, v = z - p[3] * s;

    return section(u * c + v * s, v * c - u * s, p[5]) - p[2];
}

/* Along and across the nearest axis of the nearest hexagon; their centres stand at (sqrt 3 (i + j/2), 3j/2). */
static void hexagon(double x, double y, double out[2])
{
    const double s = sqrt(3.0), column = floor(x / s), row = floor(y / 1.5);
    double u = 0.0, v = 0.0, nearest = HUGE_VAL, along, across;
    int i, j;

    for (j = -1; j < 3; j++)
        for (i = -2; i < 3; i++) {
            const double a = x - s * (column + i + 0.5 * fmod(fabs(row + j), 2.0)), b = y - 1.5 * (row + j);

            if (a * a + b * b < nearest) {
                nearest = a * a + b * b;
                u = a;
                v = b;
            }
        }
    out[0] = fabs(u);
    out[1] = fabs(v);
    for (i = -1; i < 2; i += 2) {
        along = fabs(u * 0.5 + v * i * s / 2.0);
        across = fabs(v * 0.5 - u * i * s / 2.0);
        if (along > out[0]) {
            out[0] = along;
            out[1] = across;
        }
    }
}

SURFACE(hex_x)
{
    double h[2];

    (void)z;
    (void)p;
    hexagon(x, y, h);
    return h[0];
}

SURFACE(hex_y)
{
    double h[2];

    (void)z;
    (void)p;
    hexagon(x, y, h);
    return h[1];
}

/* The distance to the nearest even multiple of w. */
static double to_thread(double v, double w)
{
    return v - 2.0 * w * floor(v / (2.0 * w) + 0.5);
}

SURFACE(mesh1)
{
    const double a = p[3] * cos(pi * x / p[0]), b = p[3] * cos(pi * z / p[1]), c = p[2], k = p[4];

    return least(least(length2(c * to_thread(z, p[1]), k * (y - a)), length2(c * to_thread(z - p[1], p[1]), k * (y + a))),
                 least(length2(c * to_thread(x, p[0]), k * (y + b)), length2(c * to_thread(x - p[0], p[0]), k * (y - b))));
}

SURFACE(ph) { (void)p; return atan2(length2(x, z), y); }
static double polynomial(double y, const double *p)
{
    return p[0] + y * (p[1] + y * (p[2] + y * (p[3] + y * p[4])));
}
SURFACE(poly4) { return length2(x, z) + least(5.0, -polynomial(y, p)); }

SURFACE(polytubes)
{
    const double r = polynomial(y, p + 1);
    double nearest = 10000.0;

    for (int i = 0; i < (p[0] < 1e6 ? (int)p[0] : 1000000); i++)
        nearest = least(nearest, length2(x - r * sin(2.0 * pi * i / p[0]), z - r * cos(2.0 * pi * i / p[0])));
    return nearest;
}

SURFACE(quantum)
{
    (void)p;
    return 1.2 - 1.6 * sq(x * x + z * z - 2.0 * y * y) * exp(-4.0 * 0.33333333 * length3(x, y, z));
}
SURFACE(radius) { (void)p; return length3(x, y, z); }
SURFACE(rounded_box)
{
    const double r = p[0];

    return length3(most(fabs(x) - (p[1] - r), 0.0), most(fabs(y) - (p[2] - r), 0.0), most(fabs(z) - (p[3] - r), 0.0)) -
           r - 0.000001;
}
SURFACE(sphere) { return length3(x, y, z) - p[0]; }
SURFACE(spikes_2d) { return y - p[0] * cos(p[1] * x) * cos(p[2] * z) * exp(-p[3] * (x * x + z * z)); }

SURFACE(spiral)
{
    const double q = x == 0.0 && z == 0.0 ? 1e-6 : length2(x, z), r = length3(x, y, z);
    double w = (q + p[0] * atan2(z, x) / (2.0 * pi)) / p[0];

    w = (w - floor(w) - 0.5) * p[0];
    return most(least(section(w, y, p[5]), most(r, q)) - p[1], r - p[2]);
}

static double ratio(double a, double b) { return b != 0.0 ? a / b : HUGE_VAL; }

SURFACE(superellipsoid)
{
    const double e = p[0], n = p[1], q = pow(fabs(x), ratio(2.0, e)) + pow(fabs(y), ratio(2.0, e));

    return 1.0 - pow(pow(q, ratio(e, n)) + pow(fabs(z), ratio(2.0, n)), n / 2.0);
}
SURFACE(th) { (void)y; (void)p; return atan2(x, z); }
SURFACE(torus) { return length2(length2(x, z) - p[0], y) - p[1]; }

/* ---- by number ---- */

/* LIMITED: p[0] times the value, limited to 10. TURNED: the same of a curve, whose last three parameters turn it; the
 * first four are limited by p[1]. */
typedef enum form { PLAIN_VALUE, LIMITED, TURNED, TURNED_LIMIT } form;

typedef struct row {
    double (*value)(double x, double y, double z, const double *p);
    uint32_t arguments;
    form form;
} row;

static const row rows[] = {
    { cyl1, 8, TURNED_LIMIT }, { cyl2, 8, TURNED_LIMIT }, { cyl3, 8, TURNED_LIMIT }, { cyl4, 8, TURNED_LIMIT },
    { bicorn, 5, LIMITED }, { bifolia, 5, LIMITED }, { blob, 8, PLAIN_VALUE }, { blob2, 7, PLAIN_VALUE },
    { boy_surface, 5, LIMITED }, { comma, 4, PLAIN_VALUE }, { cross_ellipsoids, 7, PLAIN_VALUE },
    { crossed_trough, 4, LIMITED }, { cubic_saddle, 4, LIMITED }, { cushion, 4, LIMITED }, { devils_curve, 4, LIMITED },
    { devils_2d, 9, TURNED }, { dupin_cyclid, 9, LIMITED }, { ellipsoid, 6, PLAIN_VALUE }, { enneper, 4, LIMITED },
    { flange_cover, 7, PLAIN_VALUE }, { folium_surface, 6, LIMITED }, { folium_2d, 9, TURNED }, { glob, 4, LIMITED },
    { heart, 4, LIMITED }, { helical_torus, 13, PLAIN_VALUE }, { helix1, 10, PLAIN_VALUE }, { helix2, 10, PLAIN_VALUE },
    { hex_x, 4, PLAIN_VALUE }, { hex_y, 4, PLAIN_VALUE }, { NULL, 9, PLAIN_VALUE }, { hunt_surface, 4, LIMITED },
    { hyperbolic_torus, 6, LIMITED }, { isect_ellipsoids, 7, PLAIN_VALUE }, { kampyle, 6, LIMITED },
    { kampyle_2d, 9, TURNED }, { klein_bottle, 4, LIMITED }, { kummer1, 4, LIMITED }, { kummer2, 7, LIMITED },
    { gerono, 4, LIMITED }, { gerono_2d, 9, TURNED }, { mesh1, 8, PLAIN_VALUE }, { mitre, 4, LIMITED },
    { nodal_cubic, 4, LIMITED }, { cushion, 4, LIMITED }, { cassini, 7, LIMITED }, { paraboloid, 4, LIMITED },
    { parabolic_torus, 6, LIMITED }, { ph, 3, PLAIN_VALUE }, { pillow, 4, LIMITED }, { piriform, 4, LIMITED },
    { piriform_2d, 10, TURNED }, { poly4, 8, PLAIN_VALUE }, { polytubes, 9, PLAIN_VALUE }, { quantum, 4, PLAIN_VALUE },
    { quartic_paraboloid, 4, LIMITED }, { quartic_saddle, 4, LIMITED }, { quartic_cylinder, 6, LIMITED },
    { radius, 3, PLAIN_VALUE }, { NULL, 9, PLAIN_VALUE }, { NULL, 9, PLAIN_VALUE }, { rounded_box, 7, PLAIN_VALUE },
    { sphere, 4, PLAIN_VALUE }, { spikes, 8, PLAIN_VALUE }, { spikes_2d, 7, PLAIN_VALUE }, { spiral, 9, PLAIN_VALUE },
    { steiners_roman, 4, LIMITED }, { strophoid, 7, LIMITED }, { strophoid_2d, 10, TURNED },
    { superellipsoid, 5, PLAIN_VALUE }, { th, 3, PLAIN_VALUE }, { torus, 5, PLAIN_VALUE }, { torus2, 6, LIMITED },
    { torus_gumdrop, 4, LIMITED }, { umbrella, 4, LIMITED }, { witch, 5, LIMITED }, { witch_2d, 9, TURNED },
    { NULL, 3, PLAIN_VALUE }, { NULL, 0, PLAIN_VALUE }, { NULL, 4, PLAIN_VALUE },
};

enum { ROWS = sizeof rows / sizeof rows[0] };

uint32_t internal_arguments(uint32_t number)
{
    return number < ROWS ? rows[number].arguments : 0;
}

static double limit(double value, double most_of_it)
{
    return least(most_of_it, most(-most_of_it, value));
}

double internal_value(uint32_t number, const double *v)
{
    const row *f = &rows[number];
    const double *p = v + 3;
    double x = v[0], y = v[1], value;

    if (!f->value)
        return 0.0;
    if (f->form >= TURNED)
        to_curve(&x, &y, v[2], v + f->arguments - 3);
    value = f->value(x, y, v[2], p);
    if (f->form == PLAIN_VALUE)
        return value;
    value *= p[0];
    if (f->form == TURNED_LIMIT && number == 0)
        return most(-p[1], least(p[1], value));
    return limit(value, f->form == TURNED_LIMIT ? p[1] : 10.0);
}
