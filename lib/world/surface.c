#include "base/simd.h"
#include "world/copy_path.h"
#include "world/detail.h"
#include "world/object_box.h"

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

/* index: of the hit's surface in the world. */
static inline void find_normal_of(const world *w, uint32_t index, const pov_ray *ray, hit *h)
{
    const shape_class *shape = w->groups[w->objects_info[index].group].shape;
    const shape_ref ref = world_shape(w, index);

    if (ref.xform)
        instance_normal(ref.xform, shape, ref.instance, ray, &h->crossing, &h->normal);
    else
        shape->normal(ref.instance, ray, &h->crossing, &h->normal);
}

/* Are normals of the group's shapes found by points? */
static inline bool is_by_point(const shape_group *g) { return !g->instanced && g->shape->normal_at_many; }

/* The same of a surface of this world, whose point is known. */
static inline void find_own_normal(const world *w, const pov_ray *ray, hit *h)
{
    const shape_group *g = &w->groups[w->objects_info[h->object].group];
    const pov_vec3 *const point = &h->point;
    pov_vec3 *const out = &h->normal;
    const void *self;

    if (!is_by_point(g)) {
        find_normal_of(w, h->object, ray, h);
        return;
    }
    self = world_shape(w, h->object).instance;
    g->shape->normal_at_many(&self, &point, &out, 1);
}

static void find_copy_normal(const world *w, const pov_ray *ray, hit *h)
{
    copy_path p;
    pov_ray own;

    world_find(w, h->object, &p);
    find_normal_of(p.world, p.index, copy_path_ray(&p, ray, &own), h);
    copy_path_normal(&p, &h->normal);
}


/* The shape's normal is the surface's; for inverse objects it is reversed. */
static inline void set_entering(const object_info *info, const pov_ray *ray, hit *h)
{
    h->entering = h->outside = pov_dot(h->normal, ray->dir) < 0.0;
    if (info->inverse) {
        h->normal = pov_scale(h->normal, -1.0);
        h->entering = pov_dot(h->normal, ray->dir) < 0.0;
    }
    if (info->member)   /* its tree's flag is more accurate than a rounded normal */
        h->entering = (h->crossing.mark.flags & CSG_MARK_ENTERS) != 0;
}

void world_surface(const world *w, const pov_ray *ray, hit *h)
{
    find_point(ray, h);
    if (world_is_own(w, h->object)) {
        find_own_normal(w, ray, h);
        set_entering(&w->objects_info[h->object], ray, h);
    } else {
        find_copy_normal(w, ray, h);
        set_entering(world_info_within(w, h->object), ray, h);
    }
}

bool world_is_at_front(const world *w, const pov_ray *ray, const hit *h)
{
    const shape_class *shape;
    pov_ray moved, own;
    copy_path p;
    shape_ref ref;
    pov_vec3 seen;

    world_find(w, h->object, &p);
    shape = p.world->groups[p.world->objects_info[p.index].group].shape;
    if (shape->shading_normals && world_blended_normal(w, h, &seen))
        return (pov_dot(seen, ray->dir) < 0.0) == (h->outside == h->entering);
    if (!shape->reversed)
        return h->entering;
    ref = world_shape(p.world, p.index);
    ray = copy_path_ray(&p, ray, &moved);
    if (ref.xform)
        instance_ray(ref.xform, ray, &own);
    return h->entering != shape->reversed(ref.instance, ref.xform ? &own : ray, &h->crossing);
}

/* ---- of many ---- */

static inline void put_points(incidence *out, uint32_t i, const pov_ray *ray, const hit *h)
{
    lanes_put(&out->dir, i, ray->dir);
    lanes_put(&out->point, i, h->point);
    lanes_put(&out->point_lo, i, h->point_lo);
}

static inline void put_normal(incidence *out, uint32_t i, const hit *h)
{
    lanes_put(&out->normal, i, pov_scale(h->normal, h->entering ? 1.0 : -1.0));
}

void world_incidence(incidence *out, uint32_t lane, const pov_ray *ray, const hit *h)
{
    put_points(out, lane, ray, h);
    put_normal(out, lane, h);
}

/* Unused lanes cost as much as others: fewer points are cheaper one by one. */
enum { LANES = 4 };

/* By component: starts and distances of rays. */
typedef struct start_lanes { double org[3][LANES], org_lo[3][LANES], t[LANES], t_lo[LANES]; } start_lanes;

static inline void find_axis(const start_lanes *l, int axis, const double *d, double *hi, double *lo)
{
    for (uint32_t i = 0; i < LANES; i++) {
        const pov_two t = pov_fast_two_sum(l->t[i], l->t_lo[i]);
        const pov_two p = along(l->org[axis][i], l->org_lo[axis][i], t, d[i]);

        hi[i] = p.hi;
        lo[i] = p.lo;
    }
}

/* The points of the lanes from `first` on, whose directions are stored. */
SIMD_CLONES static void find_lanes(const start_lanes *restrict l, incidence *restrict out, uint32_t first)
{
    find_axis(l, 0, out->dir.x + first, out->point.x + first, out->point_lo.x + first);
    find_axis(l, 1, out->dir.y + first, out->point.y + first, out->point_lo.y + first);
    find_axis(l, 2, out->dir.z + first, out->point.z + first, out->point_lo.z + first);
}

/* Four rays and their hits. */
static inline void put_lanes(start_lanes *l, incidence *out, uint32_t first, const void *const rays[LANES],
                             const void *const hits[LANES])
{
    double other[LANES], more[LANES], most[LANES];

    simd_transpose(rays, offsetof(pov_ray, org), l->org[0], l->org[1], l->org[2], l->org_lo[0]);
    simd_transpose(rays, offsetof(pov_ray, org_lo.y), l->org_lo[1], l->org_lo[2], out->dir.x + first,
                   out->dir.y + first);
    simd_transpose(rays, offsetof(pov_ray, dir.z), out->dir.z + first, other, more, most);
    simd_transpose(hits, offsetof(hit, crossing), l->t, l->t_lo, other, more);
}

static inline void take_points(const incidence *a, uint32_t first, hit *const h[LANES])
{
    const double *const z = a->point.z + first, *const x_lo = a->point_lo.x + first;
    const void *const from[] = { a->point.x + first, a->point.y + first, z, x_lo };
    const void *const rest[] = { z, x_lo, a->point_lo.y + first, a->point_lo.z + first };

    simd_transpose(from, 0, &h[0]->point.x, &h[1]->point.x, &h[2]->point.x, &h[3]->point.x);
    simd_transpose(rest, 0, &h[0]->point.z, &h[1]->point.z, &h[2]->point.z, &h[3]->point.z);
}

/* Lanes past the end hold the last one again. */
static void find_points(const pov_ray *const *rays, hit *const *hits, uint32_t n, incidence *out)
{
    for (uint32_t first = 0; first < n; first += LANES) {
        const void *r[LANES], *h[LANES];
        hit *to[LANES];
        start_lanes l;

        for (uint32_t i = 0; i < LANES; i++) {
            const uint32_t j = first + i < n ? first + i : n - 1;

            r[i] = rays[j];
            h[i] = to[i] = hits[j];
        }
        put_lanes(&l, out, first, r, h);
        find_lanes(&l, out, first);
        take_points(out, first, to);
    }
}

/* Up to WORLD_MANY shapes of one class. */
typedef struct normals {
    const void *selves[WORLD_MANY];
    const pov_ray *rays[WORLD_MANY];
    const pov_crossing *at[WORLD_MANY];
    pov_vec3 *out[WORLD_MANY];
    uint32_t count, instanced_count;
    const instance_xform *ref[WORLD_MANY];   /* of instanced shapes */
    pov_vec3 *instanced_normals[WORLD_MANY];
    xform_batch batch;                    /* those whose rays are still to be transformed */
    pov_ray own[WORLD_MANY];
} normals;

static inline const pov_ray *known_ray(const object_space_rays *from, const hit *h)
{
    const size_t i = from ? (size_t)(h - from->first) : 0;

    return from && (from->known >> i & 1) && from->of[i] == h->object ? &from->rays[i] : NULL;
}

/* The ray that a class needs for the normal of an instanced shape. */
static const pov_ray *xform_ray(normals *some, const shape_class *shape, const instance_xform *ref,
                                const object_space_rays *from, const pov_ray *ray, hit *h)
{
    const uint32_t n = some->instanced_count++;
    const pov_ray *known = shape->flags & POV_SHAPE_FACETED ? ray : known_ray(from, h);

    some->ref[n] = ref;
    some->instanced_normals[n] = &h->normal;
    if (known)
        return known;
    xform_batch_add(&some->batch, ref, ray, &some->own[n]);
    return &some->own[n];
}

static void find_added(normals *some, const shape_class *shape)
{
    uint32_t i;

    xform_batch_apply(&some->batch);
    if (shape->normal_many != NULL)
        shape->normal_many(some->selves, some->rays, some->at, some->out, some->count);
    else
        for (i = 0; i < some->count; i++)
            shape->normal(some->selves[i], some->rays[i], some->at[i], some->out[i]);
    instance_world_normals(some->ref, some->instanced_normals, some->instanced_count);
}

/* Normals of all of `left` in the group of the first, by their points. Returns the others. */
static uint64_t find_normals_at(const world *w, const shape_group *of, hit *const *hits, uint64_t left)
{
    const void *selves[WORLD_MANY];
    const pov_vec3 *points[WORLD_MANY];
    pov_vec3 *out[WORLD_MANY];
    uint64_t others = 0;
    uint32_t n = 0;

    for (; left; left &= left - 1) {
        const uint32_t i = first_of64(left), which = hits[i]->object;

        if (&w->groups[w->objects_info[which].group] != of) {
            others |= (uint64_t)1 << i;
            continue;
        }
        selves[n] = world_shape(w, which).instance;
        points[n] = &hits[i]->point;
        out[n++] = &hits[i]->normal;
    }
    of->shape->normal_at_many(selves, points, out, n);
    return others;
}

/* Normals of all of `left` in the class of the first, stage by stage. Normals of classes without a batch function are
 * computed at once, unless they are instanced. Returns the others. */
static uint64_t find_normals(const world *w, const object_space_rays *from, const pov_ray *const *rays,
                             hit *const *hits, uint64_t left)
{
    const shape_class *shape = NULL;
    uint64_t others = 0;
    normals some;

    for (some.count = some.instanced_count = some.batch.count = 0; left; left &= left - 1) {
        const uint32_t i = first_of64(left), which = hits[i]->object, n = some.count;
        const shape_group *g = &w->groups[w->objects_info[which].group];
        shape_ref ref;

        if (!g->instanced && g->shape != shape && !g->shape->normal_many) {
            find_normal_of(w, which, rays[i], hits[i]);
            continue;
        }
        if ((shape && g->shape != shape) || is_by_point(g)) {
            others |= (uint64_t)1 << i;
            continue;
        }
        shape = g->shape;
        ref = world_shape(w, which);
        some.selves[n] = ref.instance;
        some.rays[n] = rays[i];
        if (ref.xform)
            some.rays[n] = xform_ray(&some, shape, ref.xform, from, rays[i], hits[i]);
        some.at[n] = &hits[i]->crossing;
        some.out[n] = &hits[i]->normal;
        some.count++;
    }
    if (some.count > 0)
        find_added(&some, shape);
    return others;
}

/* Of what is in copies; returns the others. */
static uint64_t find_copy_normals(const world *w, const pov_ray *const *rays, hit *const *hits, uint64_t left)
{
    uint64_t others = 0;

    for (; left; left &= left - 1) {
        const uint32_t i = first_of64(left);

        if (world_is_own(w, hits[i]->object)) {
            others |= (uint64_t)1 << i;
            continue;
        }
        find_copy_normal(w, rays[i], hits[i]);
        set_entering(world_info_within(w, hits[i]->object), rays[i], hits[i]);
    }
    return others;
}

/* Of hits without points and normals. */
static void find_surfaces(const world *w, const object_space_rays *from, const pov_ray *const *rays, hit *const *hits, uint32_t n,
                          incidence *out)
{
    uint64_t left = ~(uint64_t)0 >> (WORLD_MANY - n), own;
    uint32_t i;

    if (n >= LANES)
        find_points(rays, hits, n, out);
    for (i = 0; n < LANES && i < n; i++) {
        find_point(rays[i], hits[i]);
        put_points(out, i, rays[i], hits[i]);
    }
    if (w->copies)
        left = find_copy_normals(w, rays, hits, left);
    for (own = left; left;) {
        const shape_group *g = &w->groups[w->objects_info[hits[first_of64(left)]->object].group];

        left = is_by_point(g) ? find_normals_at(w, g, hits, left) : find_normals(w, from, rays, hits, left);
    }
    for (i = 0; i < n; i++) {
        if (own >> i & 1)
            set_entering(&w->objects_info[hits[i]->object], rays[i], hits[i]);
        put_normal(out, i, hits[i]);
    }
}

/* Hits whose points and normals are known already, as bits. Hits are in the order of their rays: mostly there is one of each. */
static uint64_t find_complete(const object_space_rays *from, hit *const *hits, uint32_t n)
{
    uint64_t complete = 0;

    if (!from || n == 0)
        return 0;
    if (hits[n - 1] - hits[0] == n - 1)
        return from->complete >> (hits[0] - from->first) & ~(uint64_t)0 >> (WORLD_MANY - n);
    for (uint32_t i = 0; from->complete && i < n; i++)
        complete |= (from->complete >> (hits[i] - from->first) & 1) << i;
    return complete;
}

/* Those that are not `complete`. */
static void find_others(const world *w, const object_space_rays *from, const pov_ray *const *rays, hit *const *hits, uint32_t n,
                        uint64_t complete)
{
    const pov_ray *some_rays[WORLD_MANY];
    hit *some_hits[WORLD_MANY];
    uint32_t count = 0, i;
    incidence aside;

    for (i = 0; i < n; i++)
        if (!(complete >> i & 1)) {
            some_rays[count] = rays[i];
            some_hits[count++] = hits[i];
        }
    if (count > 0)
        find_surfaces(w, from, some_rays, some_hits, count, &aside);
}

/* Rays and where their hits are by lane; lanes past the end hold the last one again. */
static void put_contacts(const pov_ray *const *rays, hit *const *hits, uint32_t n, incidence *out)
{
    double more[LANES], other[LANES];

    for (uint32_t first = 0; first < n; first += LANES) {
        const bool whole = first + LANES <= n;
        const void *r[LANES], *h[LANES];

        for (uint32_t i = 0; i < LANES; i++) {
            const uint32_t j = whole || first + i < n ? first + i : n - 1;

            r[i] = rays[j];
            h[i] = hits[j];
        }
        simd_transpose(r, offsetof(pov_ray, dir), out->dir.x + first, out->dir.y + first, out->dir.z + first, other);
        simd_transpose(h, offsetof(hit, point), out->point.x + first, out->point.y + first, out->point.z + first, out->point_lo.x + first);
        simd_transpose(h, offsetof(hit, point_lo.y), out->point_lo.y + first, out->point_lo.z + first, out->normal.x + first,
                       out->normal.y + first);
        simd_transpose(h, offsetof(hit, normal.z), out->normal.z + first, other, more, other);
    }
}

/* Let normals face where rays come from; against: those that rays go against already. */
SIMD_CLONES static void face_normals(incidence *restrict a, uint32_t n, int64_t *restrict against)
{
    for (uint32_t i = 0; i < n; i++) {
        const pov_vec3 normal = lanes_at(&a->normal, i);
        const int64_t is_against = pov_dot(normal, lanes_at(&a->dir, i)) < 0.0 ? -1 : 0;

        against[i] = is_against;
        lanes_put(&a->normal, i, pov_scale(normal, is_against ? 1.0 : -1.0));
    }
}

void world_surface_many(const world *w, const object_space_rays *from, const pov_ray *const *rays, hit *const *hits,
                        uint32_t n, incidence *out)
{
    const uint64_t complete = find_complete(from, hits, n);
    int64_t against[WORLD_MANY];
    uint32_t object = POV_NO_OWNER;
    bool inverse = false;

    if (!complete) {
        if (n > 0)
            find_surfaces(w, from, rays, hits, n, out);
        return;
    }
    if (complete != ~(uint64_t)0 >> (WORLD_MANY - n))
        find_others(w, from, rays, hits, n, complete);
    put_contacts(rays, hits, n, out);
    face_normals(out, lanes_whole(n), against);
    for (uint32_t i = 0; i < n; i++) {
        hit *h = hits[i];

        if (!(complete >> i & 1)) {
            put_normal(out, i, h);
            continue;
        }
        if (h->object != object) {
            object = h->object;
            inverse = w->objects_info[object].inverse;
        }
        if (inverse) {
            set_entering(&w->objects_info[h->object], rays[i], h);
            put_normal(out, i, h);
        } else {
            h->entering = h->outside = against[i] != 0;
        }
    }
}

/* ---- dielectrics ---- */

static bool is_inside(const world *w, const dielectric *m, pov_vec3 point, pov_vec3 point_lo)
{
    const uint32_t leaves = (uint32_t)w->model->leaves.count;
    const leaf_node *o;
    shape_ref ref;
    bool inside;

    if (m->boxed && !world_is_within(&m->box, point))
        return false;
    if (m->object >= leaves)
        return csg_inside(&w->roots[m->object - leaves], point, point_lo);
    o = &w->model->leaves.items[m->object];
    ref = world_shape(w, m->object);
    if (ref.xform)
        inside = instance_inside(ref.xform, o->shape, ref.instance, point, point_lo);
    else
        inside = o->shape->inside(ref.instance, point, point_lo);
    return inside != ((o->flags & LEAF_INVERSE) != 0);
}

static double size_of(const pov_box *box, bool boxed)
{
    const pov_vec3 edges = pov_sub(box->hi, box->lo);

    return boxed ? edges.x + edges.y + edges.z : HUGE_VAL;
}

/* A point in the space of a copy's part. */
static const world *enter_copy(const world *w, const dielectric *m, pov_vec3 *point, pov_vec3 *point_lo)
{
    const uint32_t which = m->object - (uint32_t)(w->model->leaves.count + w->model->trees.count);
    copy_path p = { .depth = 1, .into = { copy_xform(w, which) } };

    copy_path_point(&p, point, point_lo);
    return w->copies[which].of;
}

static inline bool is_copy(const dielectric *m) { return m->solid == POV_NO_OWNER; }

uint32_t world_filled_at(const world *w, pov_vec3 point, pov_vec3 point_lo)
{
    uint32_t count = 0;

    for (size_t i = 0; i < w->filled.count; i++) {
        const dielectric *m = &w->filled.items[i];

        if (!is_copy(m)) {
            count += is_inside(w, m, point, point_lo);
        } else if (!m->boxed || world_is_within(&m->box, point)) {
            pov_vec3 at = point, at_lo = point_lo;
            const world *part = enter_copy(w, m, &at, &at_lo);

            count += world_filled_at(part, at, at_lo);
        }
    }
    return count;
}

/* A dielectric that holds the point, of some size. */
typedef struct found_solid { double size; uint32_t object, solid; } found_solid;

/* Of nested dielectrics the innermost comes last: a ray that starts there is in it. */
static bool comes_before(const found_solid *a, const found_solid *b)
{
    return a->size != b->size ? a->size > b->size : a->object < b->object;
}

/* The search for the first behind `last`, or of all, so far. */
typedef struct solid_search { const found_solid *last; found_solid next; bool found; } solid_search;

static bool is_next(const solid_search *s, const found_solid *m)
{
    return (!s->last || comes_before(s->last, m)) && (!s->found || comes_before(m, &s->next));
}

static void search(const world *w, const instance_xform *to, uint32_t name, pov_vec3 point, pov_vec3 point_lo, solid_search *s)
{
    for (size_t i = 0; i < w->dielectrics.count; i++) {
        const dielectric *m = &w->dielectrics.items[i];
        pov_box box = m->box;

        if (is_copy(m)) {
            pov_vec3 at = point, at_lo = point_lo;
            const model_copy *c = &w->model->copies.items[m->object - (w->model->leaves.count + w->model->trees.count)];
            const world *part;

            if (m->boxed && !world_is_within(&m->box, point))
                continue;
            part = enter_copy(w, m, &at, &at_lo);
            search(part, copy_xform(w, (uint32_t)(c - w->model->copies.items)), name + c->name, at, at_lo, s);
            continue;
        }
        if (to && m->boxed)
            world_box_of_own(to, &m->box, &box);
        if (is_next(s, &(found_solid){ size_of(&box, m->boxed), name + m->object, name + m->solid }) &&
            is_inside(w, m, point, point_lo)) {
            s->next = (found_solid){ size_of(&box, m->boxed), name + m->object, name + m->solid };
            s->found = true;
        }
    }
}

/* Few dielectrics contain a point, if any: searching for each is cheaper than sorting all. */
void world_dielectrics_at(const world *w, pov_vec3 point, pov_vec3 point_lo, void (*visit)(void *user, uint32_t object),
                          void *user)
{
    found_solid last;
    solid_search s;

    for (s.last = NULL;; s.last = &last) {
        s.found = false;
        search(w, NULL, 0, point, point_lo, &s);
        if (!s.found)
            return;
        visit(user, s.next.solid);
        last = s.next;
    }
}
