#include "texture/texture.h"

#include "texture/pattern.h"

#include <povtrace/exact.h>

/* One coordinate: a row of the map times (x, y, z, 1), in double-double. */
static inline pov_two along(const inverse_map *map, int row, pov_two3 p)
{
    const double *hi = map->linear->m[row], *lo = map->linear->m_lo[row];
    const pov_two x = pov_two_mul(pov_two_of(hi[0], lo[0]), p.x), y = pov_two_mul(pov_two_of(hi[1], lo[1]), p.y);
    const pov_two z = pov_two_mul(pov_two_of(hi[2], lo[2]), p.z);

    return pov_two_add(pov_two_add(x, y), pov_two_add(z, pov_two_of(map->move[row], map->move_lo[row])));
}

static inline pov_two3 to_space(const inverse_map *map, pov_two3 p)
{
    pov_two3 out;

    out.x = along(map, 0, p);
    out.y = along(map, 1, p);
    out.z = along(map, 2, p);
    return out;
}

void texture_point(const inverse_map *map, pov_vec3 point, pov_vec3 point_lo, uint32_t lane, texture_points *out)
{
    pov_two3 p = pov_two3_of(point, point_lo);

    if (map)
        p = to_space(map, p);
    lanes_put(&out->at, lane, pov_two3_hi(p));
    lanes_put(&out->at_lo, lane, pov_two3_lo(p));
}

/* The points in the pattern's own space, rounded once. There is at least one: with a loop that tests first, compilers
 * without clones warn of uninitialised lanes. */
SIMD_CLONES static void map_points(const inverse_map *restrict map, const texture_points *restrict p, uint32_t n,
                                   vec_lanes *restrict out)
{
    uint32_t i = 0;

    do
        lanes_put(out, i, pov_two3_hi(to_space(map, pov_two3_of(lanes_at(&p->at, i), lanes_at(&p->at_lo, i)))));
    while (++i < n);
}

/* Lanes behind the last point, up to a whole vector of the processor, are like it. */
static void find_own(const inverse_map *map, const texture_points *p, uint32_t n, vec_lanes *out)
{
    if (map)
        map_points(map, p, n, out);
    else
        *out = p->at;
    for (uint32_t i = n; i < lanes_whole(n); i++)
        lanes_put(out, i, lanes_at(out, n - 1));
}

/* Values beyond the list, which patterns give only for NaN, select its end. */
static inline uint32_t index_of(double value, uint32_t count)
{
    if (!(value >= 1.0))
        return 0;
    return value < (double)count ? (uint32_t)value : count - 1;
}

void texture_eval(const model *m, const material *of, const texture_points *points, uint32_t n, texture_sample *out)
{
    const pattern *p = of->pattern;
    SIMD_ALIGNED double value[LANES_MAX];
    vec_lanes own;

    find_own(map_table_at(&m->kept_maps, p->map), points, n, &own);
    p->class->evaluate(p->self, &own, n, value);
    for (uint32_t i = 0; i < n; i++)
        out[i].pigment = p->list[index_of(value[i], p->count)];
}
