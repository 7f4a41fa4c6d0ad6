#include "base/simd.h"
#include "world/bits.h"
#include "world/parts.h"

/* ---- what world_nearest() leaves open ---- */

static inline pov_two along(double o, double o_lo, pov_two t, double d)
{
    return pov_two_add(pov_two_add_double(pov_two_of(o, 0.0), o_lo), pov_two_mul_double(t, d));
}

static void find_point(const pov_ray *ray, hit *h)
{
    pov_two t = pov_fast_two_sum(h->crossing.t, h->crossing.t_lo);
    pov_two3 p;

    p.x = along(ray->org.x, ray->org_lo.x, t, ray->dir.x);
    p.y = along(ray->org.y, ray->org_lo.y, t, ray->dir.y);
    p.z = along(ray->org.z, ray->org_lo.z, t, ray->dir.z);
    h->point = pov_two3_hi(p);
    h->point_lo = pov_two3_lo(p);
}

static void find_normal(const world *w, const pov_ray *ray, hit *h)
{
    const object *o = &w->model->objects.items[h->object];
    const shape_place place = world_place(w, h->object);

    if (place.placement)
        placement_normal(place.placement, o->shape, place.instance, ray, &h->crossing, &h->normal);
    else
        o->shape->normal(place.instance, ray, &h->crossing, &h->normal);
}

/* The shape's normal is the surface's, but that of inverse objects points inwards. */
static inline void take_side(const world *w, const pov_ray *ray, hit *h)
{
    h->entering = h->outside = pov_dot(h->normal, ray->dir) < 0.0;
    if (w->model->objects.items[h->object].flags & OBJECT_INVERSE) {
        h->normal = pov_scale(h->normal, -1.0);
        h->entering = pov_dot(h->normal, ray->dir) < 0.0;
    }
}

void world_surface(const world *w, const pov_ray *ray, hit *h)
{
    find_point(ray, h);
    find_normal(w, ray, h);
    take_side(w, ray, h);
}

/* ---- of many ---- */

/* Lanes that hold nothing cost as much as others: fewer points than the least are better off alone. */
enum { LANES = 8, POINTS_LEAST = 4 };

/* By component: rays and crossings, and the points there. */
typedef struct point_lanes {
    double org[3][LANES], org_lo[3][LANES], dir[3][LANES], t[LANES], t_lo[LANES];
    double point[3][LANES], point_lo[3][LANES];
} point_lanes;

static inline void put_lane(point_lanes *l, uint32_t i, const pov_ray *ray, const pov_crossing *at)
{
    l->org[0][i] = ray->org.x;
    l->org[1][i] = ray->org.y;
    l->org[2][i] = ray->org.z;
    l->org_lo[0][i] = ray->org_lo.x;
    l->org_lo[1][i] = ray->org_lo.y;
    l->org_lo[2][i] = ray->org_lo.z;
    l->dir[0][i] = ray->dir.x;
    l->dir[1][i] = ray->dir.y;
    l->dir[2][i] = ray->dir.z;
    l->t[i] = at->t;
    l->t_lo[i] = at->t_lo;
}

SIMD_CLONES static void find_lanes(point_lanes *l)
{
    uint32_t i;
    int k;

    for (k = 0; k < 3; k++) {
        const double *o = l->org[k], *o_lo = l->org_lo[k], *d = l->dir[k];
        double *hi = l->point[k], *lo = l->point_lo[k];

        for (i = 0; i < LANES; i++) {
            pov_two p = along(o[i], o_lo[i], pov_fast_two_sum(l->t[i], l->t_lo[i]), d[i]);

            hi[i] = p.hi;
            lo[i] = p.lo;
        }
    }
}

static void find_points(const pov_ray *const *rays, hit *const *hits, uint32_t n)
{
    point_lanes l;
    uint32_t first, i, j;

    for (first = 0; first < n; first += LANES) {
        for (i = 0; i < LANES; i++) {
            j = first + i < n ? first + i : n - 1;
            put_lane(&l, i, rays[j], &hits[j]->crossing);
        }
        find_lanes(&l);
        for (i = 0, j = first; i < LANES && j < n; i++, j++) {
            hits[j]->point = pov_vec3_of(l.point[0][i], l.point[1][i], l.point[2][i]);
            hits[j]->point_lo = pov_vec3_of(l.point_lo[0][i], l.point_lo[1][i], l.point_lo[2][i]);
        }
    }
}

/* Up to WORLD_MANY shapes of one class in the space of the world. */
typedef struct normals {
    uint32_t count;
    const void *selves[WORLD_MANY];
    const pov_ray *rays[WORLD_MANY];
    const pov_crossing *at[WORLD_MANY];
    pov_vec3 *out[WORLD_MANY];
} normals;

/* Take those of `left` that are of a class; the others are left. */
static uint64_t take_class(const world *w, const pov_shape_class *shape, const pov_ray *const *rays, hit *const *hits,
                           uint64_t left, normals *out)
{
    uint64_t rest, others = 0;

    out->count = 0;
    for (rest = left; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const uint32_t at = out->count;

        if (w->model->objects.items[hits[i]->object].shape != shape) {
            others |= (uint64_t)1 << i;
            continue;
        }
        out->selves[at] = world_place(w, hits[i]->object).instance;
        out->rays[at] = rays[i];
        out->at[at] = &hits[i]->crossing;
        out->out[at] = &hits[i]->normal;
        out->count++;
    }
    return others;
}

/* Shapes in spaces of their own are asked alone, as are those of classes that know no better. The others are left. */
static uint64_t find_lone_normals(const world *w, const pov_ray *const *rays, hit *const *hits, uint32_t n)
{
    uint64_t others = 0;
    uint32_t i;

    for (i = 0; i < n; i++) {
        const shape_group *g = &w->groups[w->group[hits[i]->object]];

        if (!g->placed && POV_SHAPE_HAS(g->shape, normal_many))
            others |= (uint64_t)1 << i;
        else
            find_normal(w, rays[i], hits[i]);
    }
    return others;
}

static void surface_some(const world *w, const pov_ray *const *rays, hit *const *hits, uint32_t n)
{
    uint64_t left = find_lone_normals(w, rays, hits, n);
    normals some;
    uint32_t i;

    if (n < POINTS_LEAST)
        for (i = 0; i < n; i++)
            find_point(rays[i], hits[i]);
    else
        find_points(rays, hits, n);
    while (left) {
        const pov_shape_class *shape = w->model->objects.items[hits[first_of64(left)]->object].shape;

        left = take_class(w, shape, rays, hits, left, &some);
        shape->normal_many(some.selves, some.rays, some.at, some.out, some.count);
    }
    for (i = 0; i < n; i++)
        take_side(w, rays[i], hits[i]);
}

void world_surface_many(const world *w, const pov_ray *const *rays, hit *const *hits, uint32_t n)
{
    uint32_t first;

    for (first = 0; first < n; first += WORLD_MANY)
        surface_some(w, rays + first, hits + first, n - first < WORLD_MANY ? n - first : WORLD_MANY);
}

/* ---- media ---- */

static bool is_within(const pov_box *b, pov_vec3 p)
{
    return p.x >= b->lo.x && p.x <= b->hi.x && p.y >= b->lo.y && p.y <= b->hi.y && p.z >= b->lo.z && p.z <= b->hi.z;
}

static bool is_inside(const world *w, const medium *m, pov_vec3 point, pov_vec3 point_lo)
{
    const object *o = &w->model->objects.items[m->object];
    const shape_place place = world_place(w, m->object);
    bool inside;

    if (m->boxed && !is_within(&m->box, point))
        return false;
    if (place.placement)
        inside = placement_inside(place.placement, o->shape, place.instance, point, point_lo);
    else
        inside = o->shape->inside(place.instance, point, point_lo);
    return inside != ((o->flags & OBJECT_INVERSE) != 0);
}

void world_media_at(const world *w, pov_vec3 point, pov_vec3 point_lo, void (*see)(void *user, uint32_t object),
                    void *user)
{
    size_t i;

    for (i = 0; i < w->media_count; i++)
        if (is_inside(w, &w->media[i], point, point_lo))
            see(user, w->media[i].object);
}
