#include "shade/guide.h"

#include "base/elementary.h"

static const double inverse_pi = 0.31830988618379067;

/* ---- by the cosine ---- */

/* A vector by two axes across a unit one, without a branch at its poles: Duff and others, Building an orthonormal basis,
 * revisited, JCGT 6(1), 2017. */
static pov_vec3 across(pov_vec3 n, double x, double y, double z)
{
    const double sign = copysign(1.0, n.z), a = -1.0 / (sign + n.z), b = n.x * n.y * a;
    const pov_vec3 u = pov_vec3_of(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x), v = pov_vec3_of(b, sign + n.y * n.y * a, -n.y);

    return pov_add(pov_add(pov_scale(u, x), pov_scale(v, y)), pov_scale(n, z));
}

/* A point of the disc below. */
static pov_vec3 spread(pov_vec3 normal, sequence_point p)
{
    const double radius = sqrt(p.x);

    return across(normal, radius * elementary_cos_turns(p.y), radius * elementary_sin_turns(p.y), sqrt(1.0 - p.x));
}

/* ---- towards boxes ---- */

static const double *component(const pov_vec3 *v, int axis) { return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z; }

static double at(pov_vec3 v, int axis) { return *component(&v, axis); }

static void find_sides(guide_view *v, pov_vec3 point)
{
    const pov_vec3 size = pov_sub(v->box->hi, v->box->lo);

    v->whole = 0.0;
    for (int a = 0; a < 3; a++) {
        const bool is_below = at(point, a) < at(v->box->lo, a), is_seen = is_below || at(point, a) > at(v->box->hi, a);

        v->side[a] = is_below ? at(v->box->lo, a) : at(v->box->hi, a);
        v->area[a] = is_seen ? at(size, (a + 1) % 3) * at(size, (a + 2) % 3) : 0.0;
        v->whole += v->area[a];
    }
}

/* How far the box's farthest corner along the normal is above the surface. */
static double height_of(const pov_box *b, pov_vec3 point, pov_vec3 n)
{
    const pov_vec3 corner = pov_vec3_of(n.x > 0.0 ? b->hi.x : b->lo.x, n.y > 0.0 ? b->hi.y : b->lo.y, n.z > 0.0 ? b->hi.z : b->lo.z);

    return pov_dot(n, pov_sub(corner, point));
}

/* What a lamp is likely to give. */
static double expected(const world_lamp *l, pov_vec3 point)
{
    const pov_vec3 to = pov_sub(pov_scale(pov_add(l->box.lo, l->box.hi), 0.5), point), half = pov_scale(pov_sub(l->box.hi, l->box.lo), 0.5);

    return l->power / (pov_dot(to, to) + pov_dot(half, half));
}

void guide_find(const world_lamps *lamps, pov_vec3 point, pov_vec3 normal, guide_views *out)
{
    double sum = 0.0;

    out->count = 0;
    for (uint32_t i = 0; i < lamps->count; i++) {
        guide_view *v = &out->of[out->count];

        v->box = &lamps->items[i].box;
        v->lamp = i;
        if (!(height_of(v->box, point, normal) > 0.0))
            continue;
        find_sides(v, point);
        v->share = expected(&lamps->items[i], point);
        if (!(v->whole > 0.0 && v->share > 0.0 && v->share < HUGE_VAL))
            continue;
        sum += v->share;
        out->count++;
    }
    for (uint32_t i = 0; i < out->count; i++)
        out->of[i].share /= sum;
}

/* Densities are by solid angle. A ray enters a box through one of the faces that look to its start. */
static double density_of(const guide_view *v, pov_vec3 point, pov_vec3 dir)
{
    double enters = 0.0, leaves = HUGE_VAL;
    int face = -1;

    for (int a = 0; a < 3; a++) {
        const double d = at(dir, a), lo = at(v->box->lo, a) - at(point, a), hi = at(v->box->hi, a) - at(point, a);
        double near, far;

        if (d == 0.0 && (lo > 0.0 || hi < 0.0))
            return 0.0;
        if (d == 0.0)
            continue;
        near = d > 0.0 ? lo / d : hi / d;
        far = d > 0.0 ? hi / d : lo / d;
        if (near > enters) {
            enters = near;
            face = a;
        }
        leaves = pov_min(leaves, far);
    }
    return face >= 0 && enters <= leaves ? enters * enters / (v->whole * fabs(at(dir, face))) : 0.0;
}

/* The rest of a number after choosing by it among shares: as random as before. */
static double rest_of(double *u, double share)
{
    const bool chosen = *u < share;

    *u = chosen ? *u / share : *u - share;
    return chosen;
}

/* Towards a point of the faces, all alike. */
static pov_vec3 aim(const guide_view *v, pov_vec3 point, double x, double y)
{
    double left = x * v->whole, to[3];
    int face = 0, b, c;

    while (face < 2 && (left >= v->area[face] || v->area[face] == 0.0))
        left -= v->area[face++];
    b = (face + 1) % 3;
    c = (face + 2) % 3;
    left = v->area[face] > 0.0 ? pov_min(left / v->area[face], 1.0) : 0.5;
    to[face] = v->side[face] - at(point, face);
    to[b] = at(v->box->lo, b) + left * (at(v->box->hi, b) - at(v->box->lo, b)) - at(point, b);
    to[c] = at(v->box->lo, c) + y * (at(v->box->hi, c) - at(v->box->lo, c)) - at(point, c);
    return pov_unit(pov_vec3_of(to[0], to[1], to[2]));
}

static pov_vec3 draw_lamp(const guide_views *all, pov_vec3 point, double x, double y)
{
    uint32_t i = 0;

    while (i + 1 < all->count && !rest_of(&x, all->of[i].share))
        i++;
    if (i + 1 == all->count && i > 0)
        x = pov_min(x / all->of[i].share, 1.0);
    return aim(&all->of[i], point, x, y);
}

/* Of rays half go towards lamps, by chance or where one of each kind is drawn. */
bool guide_draw(const guide_views *all, pov_vec3 point, pov_vec3 normal, sequence_point p, guide_kind kind, pov_vec3 *dir,
                float *by)
{
    double even, density = 0.0;

    *by = kind == GUIDE_EITHER ? 1.0f : 2.0f;
    if (all->count == 0) {
        *dir = spread(normal, p);
        return kind != GUIDE_LAMPS;
    }
    if (kind == GUIDE_EITHER) {
        kind = p.x < 0.5 ? GUIDE_EVEN : GUIDE_LAMPS;
        p.x = kind == GUIDE_EVEN ? 2.0 * p.x : 2.0 * p.x - 1.0;
    }
    *dir = kind == GUIDE_EVEN ? spread(normal, p) : draw_lamp(all, point, p.x, p.y);
    even = pov_dot(*dir, normal) * inverse_pi;
    for (uint32_t i = 0; i < all->count; i++)
        density += all->of[i].share * density_of(&all->of[i], point, *dir);
    *by = (float)(even / (0.5 * even + 0.5 * density));
    return even > 0.0 && *by > 0.0f;
}
