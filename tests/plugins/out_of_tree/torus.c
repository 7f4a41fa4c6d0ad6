/* torus { major, minor }: around the y axis, in plain double precision.
 *
 * A class that is honest about that: it does not carry POV_SHAPE_CERTIFIED, and passes the contract. The tests build it
 * once more with FLAGS that claim it and with an ERROR in its distances, in units of the minor radius: both are caught. */
#include <povtrace/shape.h>

#ifndef FLAGS
#define FLAGS POV_SHAPE_SOLID
#endif
#ifndef ERROR
#define ERROR 0.0
#endif

typedef struct torus { double major, minor; } torus;

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    torus *t = self;

    t->major = host->number(in);
    host->accept(in, ",");
    t->minor = host->number(in);
    if (!(t->minor > 0.0 && t->major > t->minor && t->major < 1e100))
        host->fail(in, "the radii of a torus must be positive, the first of them the larger");
}

static bool bounds(const void *self, pov_box *out)
{
    const torus *t = self;
    const double reach = (t->major + t->minor) * (1.0 + 0x1p-40), high = t->minor * (1.0 + 0x1p-40);

    out->lo = pov_vec3_of(-reach, -high, -reach);
    out->hi = pov_vec3_of(reach, high, reach);
    return true;
}

static bool inside(const void *self, pov_vec3 p, pov_vec3 low)
{
    const torus *t = self;
    const double away = sqrt(p.x * p.x + p.z * p.z) - t->major;

    (void)low;
    return away * away + p.y * p.y < t->minor * t->minor;
}

/* ---- rays ---- */

static double value(const double *c, int degree, double x)
{
    double sum = c[degree];

    while (degree-- > 0)
        sum = sum * x + c[degree];
    return sum;
}

static double between(const double *c, int degree, double lo, double hi)
{
    const bool rises = value(c, degree, hi) > 0.0;
    double middle = 0.5 * (lo + hi);

    while (middle > lo && middle < hi) {
        *((value(c, degree, middle) > 0.0) == rises ? &hi : &lo) = middle;
        middle = 0.5 * (lo + hi);
    }
    return middle;
}

/* Roots of a polynomial in an interval, in growing order: between those of its derivative it rises or falls. */
static int roots_in(const double *c, int degree, double lo, double hi, double *out)
{
    double slope[4], turn[6] = { lo };
    int turns = 1, count = 0, i;

    for (i = 1; i <= degree; i++)
        slope[i - 1] = i * c[i];
    if (degree > 1)
        turns += roots_in(slope, degree - 1, lo, hi, turn + 1);
    turn[turns] = hi;
    for (i = 0; i < turns; i++)
        if ((value(c, degree, turn[i]) > 0.0) != (value(c, degree, turn[i + 1]) > 0.0))
            out[count++] = between(c, degree, turn[i], turn[i + 1]);
    return count;
}

/* (|p|^2 + 1 - r^2)^2 = 4 (x^2 + z^2) along p + s d, of unit d, in units of the major radius, whose fourth power may be
 * too small for a double: the roots, and where p is. */
static int cross(const torus *t, const pov_ray *ray, double speed, double *nearest, double *roots)
{
    const pov_vec3 d = pov_scale(ray->dir, 1.0 / speed), org = pov_scale(ray->org, 1.0 / t->major);
    const double minor = t->minor / t->major, reach = 1.5 * (1.0 + minor);
    double b, e, c[5];
    pov_vec3 p;

    *nearest = -pov_dot(org, d);
    p = pov_add(org, pov_scale(d, *nearest));
    b = 2.0 * pov_dot(p, d);
    e = pov_dot(p, p) + 1.0 - minor * minor;
    c[0] = e * e - 4.0 * (p.x * p.x + p.z * p.z);
    c[1] = 2.0 * b * e - 8.0 * (p.x * d.x + p.z * d.z);
    c[2] = b * b + 2.0 * e - 4.0 * (d.x * d.x + d.z * d.z);
    c[3] = 2.0 * b;
    c[4] = 1.0;
    return roots_in(c, 4, -reach, reach, roots);
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const torus *t = self;
    const double speed = sqrt(pov_dot(ray->dir, ray->dir)), unit = t->major / speed;
    const pov_mark mark = { 0, 0, 0.0, 0.0 };
    double nearest, roots[4];
    const int count = cross(t, ray, speed, &nearest, roots);
    int i, left = -1;

    /* The crossing that a ray starts on is the root that is nearest to its start. */
    for (i = 0; i < count && ray->origin_surface == hits->owner; i++)
        if (left < 0 || fabs(roots[i] + nearest) < fabs(roots[left] + nearest))
            left = i;
    for (i = 0; i < count; i++)
        if (i != left && !pov_cross(hits, (roots[i] + nearest) * unit + (ERROR) * t->minor / speed, 0.0, mark))
            return;
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const torus *t = self;
    const pov_vec3 p = pov_add(ray->org, pov_scale(ray->dir, at->t));
    const double way = 1.0 - t->major / sqrt(p.x * p.x + p.z * p.z);

    *out = pov_unit(pov_vec3_of(p.x * way, p.y, p.z * way));
}

static const pov_shape_class torus_class = {
    .size = sizeof(pov_shape_class),
    .flags = FLAGS,
    .keyword = "torus",
    .instance_size = sizeof(torus),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
};

static const pov_shape_class *const shapes[] = { &torus_class, NULL };

POV_PLUGIN(torus) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "torus",
    .version = "1",
    .shapes = shapes,
};
