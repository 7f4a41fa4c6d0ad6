/* Several rays at one cylinder or cone. Most leaves hold one or two of a class, where lanes for shapes would be empty.
 * Loops are apart where conditions on what one of two was chosen for would keep them from becoming vectors. */
#include "kit/frustum_bounds.h"

enum { TOGETHER = 4 };

/* What is kept of lines from one loop to the next. */
typedef struct lines {
    double x[TOGETHER], y[TOGETHER], z[TOGETHER], dx[TOGETHER], dy[TOGETHER], dz[TOGETHER];
    double middle[TOGETHER], discriminant[TOGETHER], sigma[TOGETHER], g[TOGETHER];
} lines;

/* Gives the lines that do not miss for certain, by bits. */
static inline int64_t find_lines(const kit_one *s, double reach, const pov_rays *rays, size_t from, lines *restrict out)
{
    const int64_t bit[TOGETHER] = { 1, 2, 4, 8 };
    int64_t met = 0;
    size_t i;

    for (i = 0; i < TOGETHER; i++) {
        const size_t at = from + i;
        const pov_vec3 org = pov_vec3_of(rays->org[0][at], rays->org[1][at], rays->org[2][at]);
        const pov_vec3 dir = pov_vec3_of(rays->dir[0][at], rays->dir[1][at], rays->dir[2][at]);
        const double speed = kit_sum_of_components(dir), blur = KIT_BLUR * (rays->size[at] + reach);
        const kit_line l = kit_find_line(s, org, dir);
        const double sigma = kit_is_ordinary(speed) & (int)(blur < 1e120) ? blur * s->size : HUGE_VAL;
        const kit_blur b = { sigma, speed * s->size };

        out->x[i] = l.p.x;
        out->y[i] = l.p.y;
        out->z[i] = l.p.z;
        out->dx[i] = l.d.x;
        out->dy[i] = l.d.y;
        out->dz[i] = l.d.z;
        out->middle[i] = l.middle;
        out->discriminant[i] = l.discriminant;
        out->sigma[i] = b.sigma;
        out->g[i] = b.g;
        met |= kit_line_misses(s, &l, &b) ? 0 : bit[i];
    }
    return met;
}

static inline kit_line line_of(const lines *l, size_t i)
{
    const kit_line line = { { l->x[i], l->y[i], l->z[i] }, { l->dx[i], l->dy[i], l->dz[i] }, l->middle[i],
                            l->discriminant[i] };
    return line;
}

typedef struct sides { double lo[TOGETHER], late[TOGETHER], soon[TOGETHER], hi[TOGETHER]; } sides;

static inline void find_sides(const kit_one *s, const lines *all, sides *restrict out)
{
    size_t i;

    for (i = 0; i < TOGETHER; i++) {
        const kit_line l = line_of(all, i);
        const kit_blur b = { all->sigma[i], all->g[i] };
        const kit_reach side = kit_side(s, &l, &b);

        out->lo[i] = side.lo;
        out->late[i] = side.late;
        out->soon[i] = side.soon;
        out->hi[i] = side.hi;
    }
}

/* known: whether anything is certain at all. */
typedef struct masks { int64_t known, maybe, surely, twice; } masks;

/* An open one has to be entered by its side. */
static inline masks bound_lines(const kit_one *s, double closed, const lines *all, const sides *side,
                                const double *restrict tmax, double *restrict out_lo, double *restrict out_hi)
{
    const int64_t bit[TOGETHER] = { 1, 2, 4, 8 };
    masks m = { 0, 0, 0, 0 };
    size_t i;

    for (i = 0; i < TOGETHER; i++) {
        const kit_line l = line_of(all, i);
        const kit_blur b = { all->sigma[i], all->g[i] };
        const kit_reach slab = kit_slab(s, &l, &b);
        const double first = kit_greater(side->lo[i] - slab.late, closed);
        const double lo = kit_greater(side->lo[i], slab.lo), late = kit_greater(side->late[i], slab.late);
        const double hi = kit_lesser(side->hi[i], slab.hi), soon = kit_lesser(side->soon[i], slab.soon);
        const int within = (int)(lo <= hi) & (int)(lo <= tmax[i]) & (int)(hi >= 0.0);
        const int enters = (int)(late < soon) & (int)(lo > 0.0) & (int)(late < tmax[i]) & (int)(first > 0.0);

        m.known |= b.sigma < KIT_BLURRED ? bit[i] : 0;
        m.maybe |= within ? bit[i] : 0;
        m.surely |= enters ? bit[i] : 0;
        m.twice |= hi < tmax[i] ? bit[i] : 0;
        out_lo[i] = lo;
        out_hi[i] = late;
    }
    return m;
}

/* Four rays, of which some are looked at. */
static inline void meet_four(const kit_one *s, const kit_frustum_block *b, bool open, const pov_rays *rays, size_t from,
                             uint32_t some, kit_found *restrict out)
{
    uint32_t met, blind;
    sides side;
    lines l;
    masks m;

    met = (uint32_t)find_lines(s, b->reach, rays, from, &l) & some;
    out->maybe = 0;
    if (!met)
        return;
    find_sides(s, &l, &side);
    m = bound_lines(s, open ? 0.0 : 1.0, &l, &side, rays->tmax + from, out->lo, out->hi);
    out->maybe = met & (uint32_t)(m.maybe | ~m.known);
    out->surely = out->maybe & (uint32_t)(m.surely & m.known);
    out->twice = open ? 0 : out->surely & (uint32_t)m.twice;
    for (blind = out->maybe & ~(uint32_t)m.known; blind; blind &= blind - 1)
        out->lo[kit_first_lane(blind)] = 0.0;
}

KIT_CLONES static uint32_t meet_rays(const kit_frustum_block *b, uint32_t which, const pov_rays *rays, uint64_t lanes,
                                     pov_meeting *out, uint32_t n)
{
    const uint64_t four = (1u << TOGETHER) - 1;
    const kit_one s = kit_one_of(b, which);
    const bool open = b->open >> which & 1;
    kit_found found;

    while (lanes) {
        const uint32_t from = kit_first_lane64(lanes) / TOGETHER * TOGETHER;

        meet_four(&s, b, open, rays, from, (uint32_t)(lanes >> from & four), &found);
        n = kit_tell_rays(&found, from, which, out, n);
        lanes &= ~(four << from);
    }
    return n;
}

uint32_t kit_frustum_meet_rays(const kit_frustum_block *b, uint32_t which, const pov_rays *rays, uint64_t lanes,
                               pov_meeting *out, uint32_t n)
{
    return meet_rays(b, which, rays, lanes, out, n);
}
