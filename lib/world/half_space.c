/* The box of a polyhedron that is given by its faces: around the points where three of them meet that lie in all others. */
#include "world/half_space.h"

#include <math.h>

/* Directions within this angle of a face count as leading out along it. */
static const double open_angle = 0x1p-30;
/* Errors of a point where three planes meet, and of being outside a plane: fractions of the lengths involved. */
static const double point_error = 0x1p-46, face_error = 0x1p-40, least_determinant = 0x1p-43;

void half_spaces_add(half_spaces *all, const pov_half_space *one, bool complement, uint32_t id)
{
    pov_half_space *added = &all->of[all->count];

    if (all->count == HALF_SPACES_MAX)
        return;
    *added = *one;
    if (complement) {
        added->normal = pov_scale(one->normal, -1.0);
        added->distance = -one->distance;
    }
    all->id[all->count++] = id;
}

void half_spaces_add_box(half_spaces *all, const pov_box *box)
{
    const pov_half_space faces[6] = {
        { { 1.0, 0.0, 0.0 }, box->hi.x }, { { -1.0, 0.0, 0.0 }, -box->lo.x }, { { 0.0, 1.0, 0.0 }, box->hi.y },
        { { 0.0, -1.0, 0.0 }, -box->lo.y }, { { 0.0, 0.0, 1.0 }, box->hi.z }, { { 0.0, 0.0, -1.0 }, -box->lo.z }
    };

    for (int i = 0; i < 6; i++)
        half_spaces_add(all, &faces[i], false, 0);
}

/* ---- is it finite? ---- */

static bool leads_out(const half_spaces *all, pov_vec3 d)
{
    for (uint32_t i = 0; i < all->count; i++)
        if (pov_dot(all->of[i].normal, d) > open_angle)
            return false;
    return true;
}

/* The edges of an infinite polyhedron that lead to infinity are parallel to two faces; of one without edges, a line is. */
static bool is_finite(const half_spaces *all)
{
    bool edges = false;

    for (uint32_t i = 0; i < all->count; i++)
        for (uint32_t j = 0; j < i; j++) {
            const pov_vec3 d = pov_cross_product(all->of[i].normal, all->of[j].normal);
            const double length = sqrt(pov_dot(d, d));

            if (!(length > open_angle))
                continue;
            edges = true;
            if (leads_out(all, pov_scale(d, 1.0 / length)) || leads_out(all, pov_scale(d, -1.0 / length)))
                return false;
        }
    return edges;
}

/* ---- its corners ---- */

/* The point where three planes meet, and how far it may be off. False: they are parallel to a line. */
static bool corner_of(const pov_half_space *a, const pov_half_space *b, const pov_half_space *c, pov_vec3 *out, double *error)
{
    const pov_vec3 bc = pov_cross_product(b->normal, c->normal), ca = pov_cross_product(c->normal, a->normal);
    const pov_vec3 ab = pov_cross_product(a->normal, b->normal);
    const double det = pov_dot(a->normal, bc), size = fabs(a->distance) + fabs(b->distance) + fabs(c->distance);
    const pov_vec3 sum = pov_add(pov_add(pov_scale(bc, a->distance), pov_scale(ca, b->distance)), pov_scale(ab, c->distance));

    if (!(fabs(det) > least_determinant))
        return false;
    *out = pov_scale(sum, 1.0 / det);
    *error = point_error * size / (det * det) + face_error * (size + pov_largest(*out));
    return true;
}

static bool is_in_all(const half_spaces *all, pov_vec3 p, double error)
{
    for (uint32_t i = 0; i < all->count; i++)
        if (!(pov_dot(all->of[i].normal, p) <= all->of[i].distance + 2.0 * error + face_error * fabs(all->of[i].distance)))
            return false;
    return true;
}

static void extend(pov_box *b, pov_vec3 p, double by)
{
    b->lo = pov_vec3_of(pov_min(b->lo.x, p.x - by), pov_min(b->lo.y, p.y - by), pov_min(b->lo.z, p.z - by));
    b->hi = pov_vec3_of(pov_max(b->hi.x, p.x + by), pov_max(b->hi.y, p.y + by), pov_max(b->hi.z, p.z + by));
}

static void extend_by_corner(const half_spaces *all, uint32_t i, uint32_t j, uint32_t k, pov_box *out)
{
    pov_vec3 p;
    double error;

    if (corner_of(&all->of[i], &all->of[j], &all->of[k], &p, &error) && is_in_all(all, p, error))
        extend(out, p, 4.0 * error);
}

bool half_spaces_bound(const half_spaces *all, pov_box *out)
{
    const pov_box empty = { { HUGE_VAL, HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };

    if (!is_finite(all))
        return false;
    *out = empty;
    for (uint32_t i = 0; i < all->count; i++)
        for (uint32_t j = 0; j < i; j++)
            for (uint32_t k = 0; k < j; k++)
                extend_by_corner(all, i, j, k, out);
    return out->lo.x <= out->hi.x && pov_largest(out->lo) < HUGE_VAL && pov_largest(out->hi) < HUGE_VAL;
}
