/* Up to eight cylinders or cones at once, in plain double: which of them a ray may meet, which surely, and where. */
#include "kit/frustum_bounds.h"

/* Fewer shapes than that are asked with rays in the lanes. */
enum { SPARSE = 3 };

static double sum_of(pov_vec3 a) { return kit_sum_of_components(a); }

/* How far from the origin points may lie that are considered: those within four times the shape. */
static double reach_of(const kit_frustum *s)
{
    const double across = fmax(sum_of(s->column[0]), sum_of(s->column[1])) * fmax(s->radii[0], s->radii[1]);

    return sum_of(pov_two3_hi(s->anchor)) + 8.0 * (across + sum_of(s->column[2]) * s->length);
}

static bool pack_lane(kit_frustum_block *b, uint32_t i, const kit_frustum *s)
{
    double largest = 0.0;
    int k;

    if (s->empty || !kit_block_range(reach_of(s)))
        return false;
    b->anchor[0][i] = s->anchor.x.hi;
    b->anchor[1][i] = s->anchor.y.hi;
    b->anchor[2][i] = s->anchor.z.hi;
    for (k = 0; k < 3; k++) {
        const pov_vec3 row = pov_scale(pov_two3_hi(s->row[k]), s->scale);

        b->row[k][0][i] = row.x;
        b->row[k][1][i] = row.y;
        b->row[k][2][i] = row.z;
        largest = fmax(largest, pov_largest(row));
    }
    b->radius[i] = s->radius.hi;
    b->slope[i] = s->slope.hi;
    b->height[i] = s->height.hi;
    b->size[i] = largest;
    b->reach = fmax(b->reach, reach_of(s));
    b->open |= (uint32_t)s->open << i;
    return kit_is_ordinary(largest);
}

bool kit_frustum_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    kit_frustum_block *b = block;
    uint32_t i;

    (void)frame;
    b->reach = 0.0;
    b->lanes = (1u << n) - 1;
    b->open = 0;
    for (i = 0; i < POV_BLOCK_MAX; i++)
        if (!pack_lane(b, i, selves[i < n ? i : 0]))
            return false;
    return true;
}

/* What is kept of the lines from one loop to the next. */
typedef struct lines {
    double x[POV_BLOCK_MAX], y[POV_BLOCK_MAX], z[POV_BLOCK_MAX];
    double dx[POV_BLOCK_MAX], dy[POV_BLOCK_MAX], dz[POV_BLOCK_MAX];
    double middle[POV_BLOCK_MAX], discriminant[POV_BLOCK_MAX];
} lines;

static inline void put_line(lines *out, uint32_t i, const kit_line *l)
{
    out->x[i] = l->p.x;
    out->y[i] = l->p.y;
    out->z[i] = l->p.z;
    out->dx[i] = l->d.x;
    out->dy[i] = l->d.y;
    out->dz[i] = l->d.z;
    out->middle[i] = l->middle;
    out->discriminant[i] = l->discriminant;
}

static inline kit_line line_of(const lines *l, uint32_t i)
{
    kit_line line;

    line.p = pov_vec3_of(l->x[i], l->y[i], l->z[i]);
    line.d = pov_vec3_of(l->dx[i], l->dy[i], l->dz[i]);
    line.middle = l->middle[i];
    line.discriminant = l->discriminant[i];
    return line;
}

/* A ray: sigma of a lane is `blur` times its size. */
typedef struct glance { pov_vec3 org, dir; double blur, speed, tmax; } glance;

static inline kit_blur blur_of(const glance *g, double size)
{
    kit_blur b = { g->blur * size, g->speed * size };
    return b;
}

/* Lanes that the line does not miss for certain. */
static inline uint32_t find_met(const kit_frustum_block *b, const glance *g, uint32_t n, lines *restrict out)
{
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    const pov_vec3 o = g->org, d = g->dir;
    int64_t missed = 0;
    uint32_t i;

    for (i = 0; i < n; i++) {
        const kit_one s = kit_one_of(b, i);
        const kit_line l = kit_find_line(&s, o, d);
        const kit_blur blur = blur_of(g, s.size);

        put_line(out, i, &l);
        missed |= kit_line_misses(&s, &l, &blur) ? bit[i] : 0;
    }
    return ~(uint32_t)missed & b->lanes;
}

static inline void bound_lane(const kit_frustum_block *b, uint32_t i, const lines *all, const glance *ray,
                              kit_answer *out)
{
    const kit_one s = kit_one_of(b, i);
    const kit_line l = line_of(all, i);
    const kit_blur blur = blur_of(ray, s.size);
    const uint32_t bit = 1u << i;
    kit_reach side, slab;
    const double tmax = ray->tmax;
    double lo, late, hi;

    out->lo[i] = 0.0;
    if (!(blur.sigma < KIT_BLURRED)) {
        out->maybe |= bit;
        return;
    }
    side = kit_side(&s, &l, &blur);
    slab = kit_slab(&s, &l, &blur);
    lo = kit_greater(side.lo, slab.lo);
    late = kit_greater(side.late, slab.late);
    hi = kit_lesser(side.hi, slab.hi);
    out->lo[i] = lo;
    out->hi[i] = late;
    if (!(lo <= hi && lo <= tmax && hi >= 0.0))
        return;
    out->maybe |= bit;
    /* An open one has to be entered by its side. */
    if (!(late < kit_lesser(side.soon, slab.soon) && lo > 0.0 && late < tmax
          && (!(b->open & bit) || side.lo > slab.late)))
        return;
    out->surely |= bit;
    if (hi < tmax && !(b->open & bit))
        out->twice |= bit;
}

static inline void answer(const kit_frustum_block *b, const pov_rays *rays, uint32_t at, kit_answer *out)
{
    glance g = { kit_origin(rays, at), kit_way(rays, at), 0.0, 0.0, rays->tmax[at] };
    lines l;
    uint32_t met;

    g.speed = sum_of(g.dir);
    g.blur = KIT_BLUR * (rays->size[at] + b->reach);
    if (!(kit_is_ordinary(g.speed) && kit_block_range(g.blur))) {
        kit_decline(b->lanes, out);
        return;
    }
    met = b->lanes < 16 ? find_met(b, &g, POV_BLOCK_MAX / 2, &l) : find_met(b, &g, POV_BLOCK_MAX, &l);
    out->maybe = out->surely = out->twice = 0;
    for (; met; met &= met - 1)
        bound_lane(b, kit_first_lane(met), &l, &g, out);
}

/* Ray by ray: lanes are shapes. Static, since the names of clones would be seen from outside. */
KIT_CLONES static uint32_t filter(const kit_frustum_block *b, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                                  pov_meeting *out)
{
    uint32_t n = 0;
    kit_answer a;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t at = kit_first_lane64(lanes);
        const uint32_t left = kit_owned_by(owners, rays->away[at]);

        if (!(b->lanes & ~left))
            continue;
        answer(b, rays, at, &a);
        a.maybe &= ~left;
        n = kit_tell(&a, at, out, n);
    }
    return n;
}

/* Shape by shape: lanes are rays. */
static uint32_t filter_few(const kit_frustum_block *b, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                           pov_meeting *out)
{
    uint32_t mask, n = 0;

    for (mask = b->lanes; mask; mask &= mask - 1) {
        const uint32_t which = kit_first_lane(mask);

        n = kit_frustum_meet_rays(b, which, rays, kit_stay(rays, lanes, owners[which]), out, n);
    }
    return n;
}

uint32_t kit_frustum_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                            pov_meeting *out)
{
    const kit_frustum_block *b = block;

    if (b->lanes < 1u << (SPARSE - 1))
        return filter_few(b, owners, rays, lanes, out);
    return filter(b, owners, rays, lanes, out);
}
