#include "texture/penrose.h"

#include <math.h>
#include <stdbool.h>

/* Tiles are halved into triangles, of which there are two: `acute` with angles of 36, 72, 72 degrees, and `flat` with 36, 36,
 * 108. Both consist of smaller such triangles. A point is followed down: from a triangle at the origin, far larger than its
 * distance, to one of the size of a tile. Where it is stands in its shares of the three corners a, b, c. */
typedef struct triangle {
    bool flat;
    bool beside_kite;            /* of kites: the short side is another kite's, too */
    double a, b, c;
} triangle;

static const double golden = 1.6180339887498949, fourth = 6.8541019662496847;   /* its fourth power */
static const double sin36 = 0.58778525229247313, cos36 = 0.80901699437494742, tan36 = 0.72654252800536089;
static const double sin72 = 0.95105651629515357, cos72 = 0.30901699437494742;

enum { LEVELS_MAX = 160 };       /* beyond them doubles have no places between tiles */

static double least(double a, double b) { return a < b ? a : b; }
static double most(double a, double b) { return a > b ? a : b; }

/* All that a mirror at a multiple of 36 degrees shows is the same: to the sector of 0 to 36 degrees. */
static void fold(double *x, double *z)
{
    const double cosines[] = { -cos72, cos72, cos36 }, sines[] = { sin72, sin72, sin36 };

    *z = fabs(*z);
    for (int i = 0; i < 3; i++) {
        const double beyond = cosines[i] * *z - sines[i] * *x;

        if (beyond > 0.0) {
            *x += 2.0 * beyond * sines[i];
            *z -= 2.0 * beyond * cosines[i];
        }
    }
}

/* Shares of corners at the origin; at `length` from it along x; and at `other` from it at 36 degrees. */
static void begin(double x, double z, double length, double other, double *origin, double *along, double *aside)
{
    *aside = z / (sin36 * other);
    *along = (x - z * cos36 / sin36) / length;
    *origin = 1.0 - *along - *aside;
}

/* A multiple of four steps down, so that what lies at the origin is the same; *length grows to where they begin. */
static int levels_of(double x, double z, double *length)
{
    int levels = 0;

    for (; levels < LEVELS_MAX && x * x + z * z > 0.8 * *length * *length; levels += 4)
        *length *= fourth;
    return levels;
}

/* ---- kites and darts: acute with the tip b, a aside, c on the axis; flat with the tip c, a aside, b on the axis ---- */

static void split_kite(triangle *t)
{
    const double a = t->a, b = t->b, c = t->c;

    t->beside_kite = c > golden * b;
    if (t->beside_kite) {
        *t = (triangle){ false, true, c - golden * b, a, golden * golden * b };
    } else {
        const double nearer = b - c / golden, rest = golden * c;

        *t = nearer > golden * a ? (triangle){ true, false, rest, golden * golden * a, nearer - golden * a }
                                 : (triangle){ false, false, golden * nearer, a - nearer / golden, rest };
    }
}

static void split_dart(triangle *t)
{
    const double a = t->a, b = t->b, c = t->c;

    *t = a > golden * c ? (triangle){ true, false, b, golden * golden * c, a - golden * c }
                        : (triangle){ false, false, golden * a, c - a / golden, b };
}

static void split_kites(triangle *t, int levels)
{
    while (levels-- > 0)
        if (t->flat)
            split_dart(t);
        else
            split_kite(t);
}

static double shaded(int kind, int kinds, double steepness, double depth)
{
    const double border = 1.0 - steepness * depth;

    return (kind + (border > 0.0 ? border < 1.0 ? border : 1.0 : 0.0)) / kinds;
}

/* Five kites about the origin. */
double penrose_kites(double x, double z)
{
    triangle t = { 0 };
    double length = 1.0;
    const int levels = levels_of(x, z, &length);

    fold(&x, &z);
    begin(x, z, length, length, &t.b, &t.c, &t.a);
    split_kites(&t, levels);
    return shaded(t.flat, 2, 4.46, t.flat ? least(t.b * sin36 / golden, t.c * sin36)
                                          : least(t.c * sin36, t.b * sin36 * golden));
}

/* ---- rhombi: both with the corner a between two sides of a rhombus ---- */

static void split_thin(triangle *t)
{
    const double a = t->a, b = t->b, c = t->c;

    *t = b > golden * a ? (triangle){ false, false, c, golden * golden * a, b - golden * a }
                        : (triangle){ true, false, golden * b, c, a - b / golden };
}

static void split_wide(triangle *t)
{
    const double a = t->a, b = t->b, c = t->c;

    if (c > golden * b) {
        *t = (triangle){ true, false, golden * golden * b, c - golden * b, a };
    } else {
        const double nearer = b - c / golden, rest = golden * c;

        *t = nearer > a / golden ? (triangle){ true, false, golden * a, rest, nearer - a / golden }
                                 : (triangle){ false, false, rest, golden * golden * nearer, a - golden * nearer };
    }
}

/* Five wide ones about the origin. */
double penrose_rhombi(double x, double z)
{
    triangle t = { .flat = true };
    double length = 1.0;
    int levels = levels_of(x, z, &length);

    fold(&x, &z);
    begin(x, z, length, golden * length, &t.c, &t.a, &t.b);
    while (levels-- > 0)
        if (t.flat)
            split_wide(&t);
        else
            split_thin(&t);
    return shaded(!t.flat, 2, 3.4300886, least(t.b, t.c) * (t.flat ? sin72 : sin36));
}

/* ---- pentagons, drawn on kites and darts ---- */

typedef struct line { double x, z, dx, dz; } line;       /* a point, and the unit direction */

/* How far to the left of it. */
static double left_of(const line *l, double x, double z) { return l->dx * (z - l->z) - l->dz * (x - l->x); }

/* Along a long side of a kite from its tip, or of a dart from its wing, lie half a pentagon of kind 0, the half of one of
 * kind 2, and a point of a star or a boat. Beside them are one of kind 1, half a thin rhombus or the middle of a boat, and
 * another of kind 0. */
static double shaded_pentagons(const triangle *t, double size, double x, double z)
{
    const double apothem = 0.68819096023558677, radius = 0.85065080835203993, flat_side = 0.16245984811645317;
    const double low = 2.0 * apothem + radius, middle = low + cos72 * radius, high = sin72 * radius;
    const line sides[] = {       /* of kind 1, counterclockwise from its lowest corner */
        { low, 0.0, sin72, cos72 }, { middle + apothem, 0.0, 0.0, 1.0 }, { low, 2.0 * high, -sin72, cos72 },
        { middle - radius, high, -sin36, -cos36 }, { low, 0.0, sin36, -cos36 },
    };
    const line above = { middle - radius, high, sin72, cos72 };        /* the upper side of kind 2 */
    const double rise = left_of(&above, x, z);
    double inside[5], deepest = HUGE_VAL, steepness = 3.4300886;

    for (int i = 0; i < 5; i++) {
        inside[i] = left_of(&sides[i], x, z);
        deepest = least(deepest, inside[i]);
    }
    if (x < apothem)
        return shaded(0, 6, steepness, apothem - x);
    if (deepest > 0.0)
        return shaded(1, 6, steepness, deepest);
    if (inside[2] < 0.0)
        return shaded(0, 6, steepness, -inside[2]);
    if (inside[4] < 0.0 && rise < 0.0)
        return shaded(2, 6, steepness, least(x - apothem, least(-rise, -inside[4])));
    if (inside[3] < 0.0 && rise > 0.0)
        return shaded(t->flat ? 4 : 5, 6, steepness, least(rise, -inside[3]));
    deepest = most(-inside[0], -inside[1]);
    return t->flat || t->beside_kite ? shaded(3, 6, steepness, deepest)
                                     : shaded(4, 6, steepness, least(deepest, size + flat_side - x));
}

double penrose_pentagons(double x, double z)
{
    const double size = 3.6034146492943866;
    triangle t = { 0 };
    double length = size;
    const int levels = levels_of(x, z, &length);

    fold(&x, &z);
    begin(x, z, length, length, &t.b, &t.a, &t.c);
    split_kites(&t, levels);
    x = size * (t.flat ? t.c + 0.5 * t.b : t.a + cos36 * t.c);
    z = size * (t.flat ? 0.5 * tan36 * t.b : sin36 * t.c);
    return shaded_pentagons(&t, size, x, z);
}
