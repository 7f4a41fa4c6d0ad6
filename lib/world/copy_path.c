#include "world/copy_path.h"

const instance_xform *copy_xform(const world *w, uint32_t copy)
{
    return world_shape(w, (uint32_t)(w->model->leaves.count + w->model->trees.count) + copy).xform;
}

void world_find(const world *w, uint32_t name, copy_path *out)
{
    const model_copy *c;

    out->depth = 0;
    while ((c = model_copy_of(w->model, &name)) != NULL) {
        const uint32_t which = (uint32_t)(c - w->model->copies.items);

        out->into[out->depth++] = copy_xform(w, which);
        w = w->copies[which].of;
    }
    out->world = w;
    out->index = name;
}

bool copy_path_moves(const copy_path *p)
{
    for (uint32_t i = 0; i < p->depth; i++)
        if (p->into[i])
            return true;
    return false;
}

const pov_ray *copy_path_ray(const copy_path *p, const pov_ray *ray, pov_ray *own)
{
    for (uint32_t i = 0; i < p->depth; i++) {
        const pov_ray from = *ray;

        if (p->into[i]) {
            instance_ray(p->into[i], &from, own);
            ray = own;
        }
    }
    return ray;
}

void copy_path_point(const copy_path *p, pov_vec3 *point, pov_vec3 *point_lo)
{
    for (uint32_t i = 0; i < p->depth; i++)
        if (p->into[i]) {
            const pov_two3 own = instance_point(p->into[i], *point, *point_lo);

            *point = pov_two3_hi(own);
            *point_lo = pov_two3_lo(own);
        }
}

void copy_path_normal(const copy_path *p, pov_vec3 *normal)
{
    for (uint32_t i = p->depth; i-- > 0;)
        if (p->into[i])
            instance_world_normal(p->into[i], normal);
}

/* ---- records and maps ---- */

const object_info *world_info_within(const world *w, uint32_t name)
{
    copy_path p;

    world_find(w, name, &p);
    return &p.world->objects_info[p.index];
}

/* The inverse of an instance transform as a map: p' = columns (p - anchor) + own anchor. */
static void inverse_of(const instance_xform *x, linear_map *linear, pov_two move[3])
{
    const pov_vec3 *c = x->column, *lo = x->column_lo, a = x->anchor, o = x->own_anchor, o_lo = x->own_anchor_lo;
    const double anchor[3] = { a.x, a.y, a.z };
    const double hi[3][3] = { { c[0].x, c[1].x, c[2].x }, { c[0].y, c[1].y, c[2].y }, { c[0].z, c[1].z, c[2].z } };
    const double low[3][3] = { { lo[0].x, lo[1].x, lo[2].x }, { lo[0].y, lo[1].y, lo[2].y }, { lo[0].z, lo[1].z, lo[2].z } };
    const pov_two own[3] = { pov_two_of(o.x, o_lo.x), pov_two_of(o.y, o_lo.y), pov_two_of(o.z, o_lo.z) };

    for (int i = 0; i < 3; i++) {
        move[i] = own[i];
        for (int j = 0; j < 3; j++) {
            linear->m[i][j] = hi[i][j];
            linear->m_lo[i][j] = low[i][j];
            move[i] = pov_two_sub(move[i], pov_two_mul_double(pov_two_of(hi[i][j], low[i][j]), anchor[j]));
        }
    }
}

/* The map `first`, then another: `then` NULL changes nothing. */
static void compose(const linear_map *first, const pov_two move[3], const inverse_map *then, linear_map *linear, inverse_map *out)
{
    const linear_map *l = then ? then->linear : NULL;

    for (int i = 0; i < 3; i++) {
        pov_two sum = l ? pov_two_of(then->move[i], then->move_lo[i]) : move[i];

        for (int k = 0; l && k < 3; k++)
            sum = pov_two_add(sum, pov_two_mul(pov_two_of(l->m[i][k], l->m_lo[i][k]), move[k]));
        out->move[i] = sum.hi;
        out->move_lo[i] = sum.lo;
        for (int j = 0; j < 3; j++) {
            pov_two at = pov_two_of(first->m[i][j], first->m_lo[i][j]);

            if (l)
                at = pov_two_of(0.0, 0.0);
            for (int k = 0; l && k < 3; k++)
                at = pov_two_add(at, pov_two_mul(pov_two_of(l->m[i][k], l->m_lo[i][k]), pov_two_of(first->m[k][j], first->m_lo[k][j])));
            linear->m[i][j] = at.hi;
            linear->m_lo[i][j] = at.lo;
        }
    }
    out->linear = linear;
}

const inverse_map *world_texture_map_within(const world *w, uint32_t name, inverse_map *space, linear_map *linear)
{
    copy_path p;
    inverse_map own;
    const inverse_map *map;

    world_find(w, name, &p);
    map = model_texture_map(p.world->model, p.index, &own);
    for (uint32_t i = p.depth; i-- > 0;)
        if (p.into[i]) {
            linear_map first, both;
            pov_two move[3];

            inverse_of(p.into[i], &first, move);
            compose(&first, move, map, &both, space);
            *linear = both;
            space->linear = linear;
            map = space;
        }
    if (map == &own) {
        *space = own;
        map = space;
    }
    return map;
}
