#include "world/company.h"

#include "base/simd.h"

static inline void put_ray(pov_rays *s, uint32_t i, const pov_ray *ray)
{
    s->org[0][i] = ray->org.x;
    s->org[1][i] = ray->org.y;
    s->org[2][i] = ray->org.z;
    s->org_lo[0][i] = ray->org_lo.x;
    s->org_lo[1][i] = ray->org_lo.y;
    s->org_lo[2][i] = ray->org_lo.z;
    s->dir[0][i] = ray->dir.x;
    s->dir[1][i] = ray->dir.y;
    s->dir[2][i] = ray->dir.z;
}

static inline double is_out(double x, double least, double most)
{
    const double size = fabs(x);

    return size <= most && (size >= least || size == 0.0) ? 0.0 : 1.0;
}

/* What follows from a ray. odd: not zero where it is out of the range that filters are promised. */
SIMD_CLONES static void derive(pov_rays *restrict s, uint32_t width, double tmax, double *restrict odd)
{
    uint32_t i;

    for (i = 0; i < width; i++) {
        const double x = s->dir[0][i], y = s->dir[1][i], z = s->dir[2][i], square = x * x + y * y + z * z;

        s->inverse[i] = 1.0 / square;
        s->per_length[i] = sqrt(s->inverse[i]);
        s->size[i] = fabs(s->org[0][i]) + fabs(s->org[1][i]) + fabs(s->org[2][i]);
        s->tmax[i] = tmax;
        odd[i] = is_out(x, 1e-80, 1e80) + is_out(y, 1e-80, 1e80) + is_out(z, 1e-80, 1e80) +
                 is_out(s->size[i], 0.0, 1e100) + (square > 0.0 ? 0.0 : 1.0);
    }
}

static uint64_t take_rays(company *c, const pov_ray *const *rays, uint64_t which)
{
    double odd[WORLD_MANY];
    uint64_t alone = 0;
    uint32_t n = 0, i;

    for (; which; which &= which - 1) {
        i = first_of64(which);
        c->rays[n] = rays[i];
        c->of[n] = (uint8_t)i;
        put_ray(&c->party.side, n++, rays[i]);
    }
    c->party.count = n;
    for (i = n; i % 8; i++)
        put_ray(&c->party.side, i, c->rays[n - 1]);
    derive(&c->party.side, i, just_beyond(c->tmax), odd);
    while (i-- > 0) {
        c->party.limit[i] = c->tmax;
        if (odd[i] != 0.0 && i < n)
            alone |= bit_of(i);
    }
    return alone;
}

uint64_t company_begin(company *c, const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax)
{
    c->party.tree = &w->tree;
    c->party.rays = c->rays;
    c->party.lowered = 0;
    c->world = w;
    c->walker = k;
    c->tmax = tmax;
    c->asked = c->waiting = 0;
    return take_rays(c, rays, which);
}

uint64_t company_filter(company *c, const run *r, uint64_t lanes)
{
    const pov_shape_class *shape = r->shape;
    uint64_t met = 0;

    if (POV_SHAPE_HAS(shape, block_filter_many))
        return shape->block_filter_many(run_block(r), &c->party.side, lanes, c->answers);
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes);

        shape->block_filter(run_block(r), c->rays[i], 0.0, c->party.side.tmax[i], &c->answers[i]);
        if (c->answers[i].maybe)
            met |= bit_of(i);
    }
    return met;
}

/* ---- who goes with whom ---- */

/* Fewer rays of one octant are better off alone. */
enum { COMPANY_LEAST = 8 };

/* Those of one octant go together through a tree; a list takes all. */
static void divide(const world *w, const pov_ray *const *rays, uint32_t n, uint64_t of[8])
{
    uint32_t i;

    for (i = 0; i < 8; i++)
        of[i] = 0;
    if (!w->has_tree)
        of[0] = all_of(n);
    else
        for (i = 0; i < n; i++)
            of[bvh_octant(rays[i])] |= bit_of(i);
}

static inline bool is_company(uint64_t lanes)
{
    uint32_t n;

    for (n = 0; lanes && n < COMPANY_LEAST; lanes &= lanes - 1)
        n++;
    return n == COMPANY_LEAST;
}

uint64_t world_nearest_many(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out)
{
    uint64_t of[8], met = 0, apart = 0;
    uint32_t octant;

    if (n == 0)
        return 0;
    divide(w, rays, n, of);
    for (octant = 0; octant < 8; octant++)
        if (is_company(of[octant]))
            met |= company_nearest(w, k, rays, of[octant], tmax, out);
        else
            apart |= of[octant];
    return apart ? met | company_nearest_apart(w, k, rays, apart, tmax, out) : met;
}

uint64_t world_light_path_many(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax,
                               colour *through)
{
    uint64_t of[8], lit = 0;
    uint32_t octant;

    if (n == 0)
        return 0;
    divide(w, rays, n, of);
    for (octant = 0; octant < 8; octant++)
        if (is_company(of[octant]))
            lit |= company_light(w, k, rays, of[octant], tmax, through);
        else
            for (; of[octant]; of[octant] &= of[octant] - 1) {
                const uint32_t i = first_of64(of[octant]);
                lit |= (uint64_t)world_light_path(w, k, rays[i], tmax, &through[i]) << i;
            }
    return lit;
}
