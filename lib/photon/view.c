#include "photon/view.h"

#include "base/vec3.h"

/* ---- screens ---- */

/* The rows of the inverse of the matrix of these columns. False: it has none. */
static bool invert(pov_vec3 x, pov_vec3 y, pov_vec3 z, pov_vec3 row[3])
{
    const double volume = pov_dot(x, pov_cross_product(y, z));

    if (!(fabs(volume) > 0.0))
        return false;
    row[0] = pov_scale(pov_cross_product(y, z), 1.0 / volume);
    row[1] = pov_scale(pov_cross_product(z, x), 1.0 / volume);
    row[2] = pov_scale(pov_cross_product(x, y), 1.0 / volume);
    return true;
}

bool photon_screen_make(photon_screen *out, const pov_ray corners[3], int width, int height)
{
    const pov_ray *first = &corners[0], *right = &corners[1], *down = &corners[2];
    const bool parallel = vec3_is_same(first->dir, right->dir) && vec3_is_same(first->dir, down->dir);
    pov_vec3 x, y;

    if (!parallel && !(vec3_is_same(first->org, right->org) && vec3_is_same(first->org, down->org)))
        return false;
    x = parallel ? pov_sub(right->org, first->org) : pov_sub(right->dir, first->dir);
    y = parallel ? pov_sub(down->org, first->org) : pov_sub(down->dir, first->dir);
    out->from = first->org;
    out->one = parallel ? 1.0 : 0.0;
    if (!invert(pov_scale(x, 1.0 / width), pov_scale(y, 1.0 / height), first->dir, out->row))
        return false;
    if (parallel)
        out->row[2] = pov_vec3_of(0, 0, 0);
    out->across[0] = pov_cross_product(out->row[1], out->row[2]);
    out->across[1] = pov_cross_product(out->row[2], out->row[0]);
    out->across[2] = pov_cross_product(out->row[0], out->row[1]);
    return isfinite(pov_largest(out->across[0]) + pov_largest(out->across[1]) + pov_largest(out->across[2]));
}

/* The place of a point; returns what it was divided by: above 0 in front of the camera. */
static double place_of(const photon_screen *s, pov_vec3 point, double out[2])
{
    const pov_vec3 d = pov_sub(point, s->from);
    const double depth = pov_dot(s->row[2], d) + s->one;

    out[0] = pov_dot(s->row[0], d) / depth;
    out[1] = pov_dot(s->row[1], d) / depth;
    return depth;
}

/* ---- samples ---- */

/* The least radius of a disc is a part of a pixel's size that falls with the fourth root of m, the samples so far of the
 * pixel's half (docs/light.md): so the later, the more of them meet it, however much light it holds. Of a pixel's first
 * sample in each half that would blur more than it helps. */
static const double least_disc = 0.6;

/* A pixel has as many cells as the square root of m, a power of two, so that each cell has as many samples. */
static void set_parts(photon_view *v, uint32_t m)
{
    int quarters = 0;

    while (m >> 2 * (quarters + 1))
        quarters++;
    v->parts[0] = 1 << (quarters + 1) / 2;
    v->parts[1] = 1 << quarters / 2;
}

void photon_view_begin(photon_view *v, const photon_screen *screen, const pov_ray *ray, uint32_t number)
{
    v->from = ray->org;
    v->least = number < 2 ? 0.0 : least_disc / sqrt(sqrt((double)(number / 2) + 1.0));
    v->screen = screen;
    if (!screen)
        return;
    place_of(screen, pov_add(ray->org, ray->dir), v->place);
    set_parts(v, number / 2);
}

double photon_view_spacing(const photon_view *v, pov_vec3 at)
{
    const pov_vec3 d = pov_sub(at, v->from);

    return v->width + v->slope * sqrt(pov_dot(d, d));
}

/* ---- cells ---- */

/* How far the place on the screen moves with a point: the gradient of a coordinate. */
static pov_vec3 gradient(const photon_screen *s, int of, double place, double depth)
{
    return pov_scale(pov_sub(s->row[of], pov_scale(s->row[2], place)), 1.0 / depth);
}

static double length_of(pov_vec3 v) { return sqrt(pov_dot(v, v)); }

/* What is seen is not plane, and in perspective not as wide behind as in front: twice as far is looked. Cells that reach further than
 * half of the distance, or so many pixels, are too flat for that. */
static const double more = 2.0, furthest = 0.5, longest = 64.0;

/* Light that discs of this radius in pixels hold counts in the cell as well without them. */
static const double narrow = 1.25;

/* The cell, but for spacing: how far it reaches across the normal at a place that the sample sees. False: it does not see it. */
static bool cell_at(const photon_view *v, pov_vec3 at, pov_vec3 normal, photon_cell *out)
{
    const double same_place = 0x1p-13;   /* pixels */
    const photon_screen *s = v->screen;
    double place[2], depth, area;
    pov_vec3 x, y;

    if (!s)
        return false;
    depth = place_of(s, at, place);
    if (!(depth > 0.0 && fabs(place[0] - v->place[0]) < same_place && fabs(place[1] - v->place[1]) < same_place))
        return false;
    x = gradient(s, 0, place[0], depth);
    y = gradient(s, 1, place[1], depth);
    area = fabs(pov_dot(normal, pov_cross_product(x, y)));
    out->reach = more * (length_of(pov_cross_product(y, normal)) / v->parts[0] + length_of(pov_cross_product(normal, x)) / v->parts[1]) / area;
    for (int i = 0; i < 2; i++) {
        out->lo[i] = floor(v->place[i] * v->parts[i]) / v->parts[i];
        out->hi[i] = out->lo[i] + 1.0 / v->parts[i];
    }
    out->screen = s;
    return isfinite(out->reach);
}

static double distance(const photon_view *v, pov_vec3 at) { return length_of(pov_sub(at, v->from)); }

bool photon_view_cell(const photon_view *v, pov_vec3 at, pov_vec3 normal, photon_cell *out)
{
    const double spacing = photon_view_spacing(v, at);

    if (!cell_at(v, at, normal, out) || !(out->reach < longest * spacing) ||
        (v->screen->one == 0.0 && !(out->reach < furthest * distance(v, at))))
        return false;
    out->spacing = narrow * spacing;
    out->slope = out->widening = 0.0;
    return true;
}

/* In perspective reach is proportional to distance. */
bool photon_view_along(const photon_view *v, pov_vec3 from, pov_vec3 dir, photon_cell *out)
{
    const double start = distance(v, from), unit = pov_max(start, 1.0);

    if (!cell_at(v, pov_add(from, pov_scale(dir, unit)), dir, out))
        return false;
    out->widening = v->screen->one == 0.0 ? out->reach / (start + unit) : 0.0;
    out->reach -= out->widening * unit;
    out->spacing = narrow * photon_view_spacing(v, from);
    out->slope = narrow * v->slope;
    return true;
}
