#include "world/detail.h"

#include "world/copy_path.h"

/* A hit's shape, and its point in the space of the instance. */
typedef struct part { const shape_class *shape; shape_ref ref; pov_vec3 point, point_lo; copy_path at; } part;

static part find_part(const world *w, const hit *h)
{
    part p = { .point = h->point, .point_lo = h->point_lo };

    world_find(w, h->object, &p.at);
    p.shape = p.at.world->groups[p.at.world->objects_info[p.at.index].group].shape;
    p.ref = world_shape(p.at.world, p.at.index);
    copy_path_point(&p.at, &p.point, &p.point_lo);
    if (p.ref.xform) {
        const pov_two3 own = instance_point(p.ref.xform, p.point, p.point_lo);

        p.point = pov_two3_hi(own);
        p.point_lo = pov_two3_lo(own);
    }
    return p;
}

bool world_blended_normal(const world *w, const hit *h, pov_vec3 *out)
{
    const part p = find_part(w, h);
    pov_vec3 normal[POV_NORMALS_MAX], sum = { 0.0, 0.0, 0.0 };
    double share[POV_NORMALS_MAX];
    uint32_t count, i;

    if (!p.shape->shading_normals)
        return false;
    count = p.shape->shading_normals(p.ref.instance, p.point, p.point_lo, &h->crossing.mark, normal, share);
    if (p.ref.xform && count > 0)
        instance_rotate_normals(p.ref.xform, normal, count);
    for (i = 0; i < count; i++) {
        copy_path_normal(&p.at, &normal[i]);
        sum = pov_add(sum, pov_scale(normal[i], share[i]));
    }
    if (!(pov_largest(sum) > 0.0))
        return false;
    *out = pov_unit(sum);
    return true;
}

static inline void face(const pov_ray *ray, pov_vec3 *normal)
{
    if (pov_dot(*normal, ray->dir) > 0.0)
        *normal = pov_scale(*normal, -1.0);
}

bool world_shading_normal(const world *w, const pov_ray *ray, const hit *h, pov_vec3 *out)
{
    if (!world_blended_normal(w, h, out))
        return false;
    face(ray, out);
    return true;
}

/* ---- shading normals of many ---- */

/* Hits on instances of this world whose shapes blend normals, and where they are in the space of these. */
typedef struct blends {
    uint32_t count, of[WORLD_MANY];
    const shape_class *shape[WORLD_MANY];
    shape_ref ref[WORLD_MANY];
    pov_vec3 point[WORLD_MANY], point_lo[WORLD_MANY];
} blends;

/* The normals that go into each, from first[i] on; and those of them that are still to be turned into the world. */
typedef struct blended {
    pov_vec3 normal[WORLD_MANY * POV_NORMALS_MAX];
    double share[WORLD_MANY * POV_NORMALS_MAX];
    uint32_t first[WORLD_MANY + 1], instanced;
    const instance_xform *xform[WORLD_MANY * POV_NORMALS_MAX];
    pov_vec3 *turned[WORLD_MANY * POV_NORMALS_MAX];
} blended;

static void bring_to_instances(blends *b)
{
    const instance_xform *xforms[WORLD_MANY];
    pov_vec3 *points[WORLD_MANY], *points_lo[WORLD_MANY];
    uint32_t n = 0;

    for (uint32_t i = 0; i < b->count; i++) {
        if (!b->ref[i].xform)
            continue;
        xforms[n] = b->ref[i].xform;
        points[n] = &b->point[i];
        points_lo[n++] = &b->point_lo[i];
    }
    instance_points(xforms, points, points_lo, n);
}

/* Of those from i on that share a class which finds several at once. Returns how many these are; what they blend stands in a row. */
static uint32_t find_several(const blends *b, uint32_t i, hit *const *hits, blended *out)
{
    const void *selves[WORLD_MANY];
    const pov_mark *marks[WORLD_MANY];
    pov_vec3 normal[WORLD_MANY];
    uint32_t count[WORLD_MANY], n = 0, at = out->first[i];

    do {
        selves[n] = b->ref[i + n].instance;
        marks[n] = &hits[b->of[i + n]]->crossing.mark;
        n++;
    } while (i + n < b->count && b->shape[i + n] == b->shape[i]);
    b->shape[i]->shading_normals_many(selves, b->point + i, b->point_lo + i, marks, n, normal, count);
    for (uint32_t k = 0; k < n; k++) {
        out->normal[at] = normal[k];
        out->share[at] = 1.0;
        out->first[i + k + 1] = at += count[k];
    }
    return n;
}

static uint32_t find_one(const blends *b, uint32_t i, hit *const *hits, blended *out)
{
    const uint32_t at = out->first[i];

    out->first[i + 1] = at + b->shape[i]->shading_normals(b->ref[i].instance, b->point[i], b->point_lo[i], &hits[b->of[i]]->crossing.mark,
                                                          &out->normal[at], &out->share[at]);
    return 1;
}

static void find_blended(const blends *b, hit *const *hits, blended *out)
{
    out->instanced = out->first[0] = 0;
    for (uint32_t i = 0; i < b->count;)
        i += (b->shape[i]->shading_normals_many ? find_several : find_one)(b, i, hits, out);
    for (uint32_t i = 0; i < b->count; i++)
        for (uint32_t k = out->first[i]; b->ref[i].xform && k < out->first[i + 1]; k++) {
            out->xform[out->instanced] = b->ref[i].xform;
            out->turned[out->instanced++] = &out->normal[k];
        }
    instance_world_normals(out->xform, out->turned, out->instanced);
}

/* Those that are not on instances of this world are found at once. Returns them. */
static uint64_t take_blends(const world *w, const pov_ray *const *rays, hit *const *hits, uint32_t n, blends *b, pov_vec3 *out)
{
    uint64_t found = 0;

    b->count = 0;
    for (uint32_t i = 0; i < n; i++) {
        const hit *h = hits[i];
        const uint32_t k = b->count;

        if (!world_is_own(w, h->object)) {
            found |= (uint64_t)world_shading_normal(w, rays[i], h, &out[i]) << i;
            continue;
        }
        b->shape[k] = w->groups[w->objects_info[h->object].group].shape;
        if (!b->shape[k]->shading_normals)
            continue;
        b->of[k] = i;
        b->ref[k] = world_shape(w, h->object);
        b->point[k] = h->point;
        b->point_lo[k] = h->point_lo;
        b->count++;
    }
    return found;
}

uint64_t world_shading_normals(const world *w, const pov_ray *const *rays, hit *const *hits, uint32_t n, pov_vec3 *out)
{
    blends b;
    blended from;
    uint64_t found = take_blends(w, rays, hits, n, &b, out);

    bring_to_instances(&b);
    find_blended(&b, hits, &from);
    for (uint32_t i = 0; i < b.count; i++) {
        const uint32_t of = b.of[i];
        pov_vec3 sum = { 0.0, 0.0, 0.0 };

        for (uint32_t k = from.first[i]; k < from.first[i + 1]; k++)
            sum = pov_add(sum, pov_scale(from.normal[k], from.share[k]));
        if (!(pov_largest(sum) > 0.0))
            continue;
        out[of] = pov_unit(sum);
        face(rays[of], &out[of]);
        found |= (uint64_t)1 << of;
    }
    return found;
}

void world_uv(const world *w, const hit *h, double out[2])
{
    const part p = find_part(w, h);

    out[0] = h->point.x;
    out[1] = h->point.y;
    if (p.shape->uv)
        p.shape->uv(p.ref.instance, p.point, &h->crossing.mark, out);
}

static bool holds(const world *w, uint32_t leaf, const hit *h)
{
    const leaf_node *o = &w->model->leaves.items[leaf];
    const shape_ref ref = world_shape(w, leaf);
    bool inside;

    if (!shape_is_solid(o->shape, o->instance))
        return false;
    inside = ref.xform ? instance_inside(ref.xform, o->shape, ref.instance, h->point, h->point_lo)
                       : o->shape->inside(ref.instance, h->point, h->point_lo);
    return inside != ((o->flags & LEAF_INVERSE) != 0);
}

/* The first of the members that hold the point give equal shares. */
static uint32_t find_givers(const world *w, const hit *h, uint32_t *which, double *share)
{
    const cutaway *c;
    uint32_t count = 0, i;
    copy_path p;
    hit own = *h;

    world_find(w, h->object, &p);
    copy_path_point(&p, &own.point, &own.point_lo);
    c = model_cutaway(p.world->model, p.index);
    for (i = 0; c && i < c->giver_count && count < POV_TEXTURES_MAX; i++)
        if (holds(p.world, p.world->model->givers.items[c->giver + i], &own))
            which[count++] = i;
    for (i = 0; i < count; i++)
        share[i] = 1.0 / count;
    return count;
}

uint32_t world_part_textures(const world *w, const hit *h, uint32_t *which, double *share)
{
    const part p = find_part(w, h);

    if (model_leaf(w->model, h->object)->flags & LEAF_CUTAWAY)
        return find_givers(w, h, which, share);
    if (!p.shape->textures)
        return 0;
    return p.shape->textures(p.ref.instance, p.point, p.point_lo, &h->crossing.mark, which, share);
}
