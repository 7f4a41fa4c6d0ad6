#include "common/heights.h"

#include "common/simd.h"

enum { LANES = COMMON_WALK_LANES, MANY = 64, HALVES = LANES / COMMON_ENTRIES };

typedef double by_lane[LANES];

/* By lane, as in a walk; the heights of the cell that it is at, and what is told of its two faces. Over water one above zero of `dry` and
 * `wet` tells on which side of its level the ray crosses the plane of a face. */
typedef struct cell_lanes { by_lane at[3], by[3], off, tmax, height[4], across[2], sure[2], dry[2], wet[2]; } cell_lanes;

/* Rays that have entered the box, and begun. */
typedef struct group { common_entries e[HALVES]; cell_lanes c; common_walk w; } group;

typedef struct padded { pov_vec3 at; double behind; } padded;

/* Rays that pass through one face of a cell for certain, whose crossings are still to be found. */
typedef struct queue {
    uint32_t n, ray[COMMON_TRIANGLES];
    padded corner[COMMON_TRIANGLES][3];
    common_triangle_pair pair[COMMON_TRIANGLES];
} queue;

/* Those that go side by side, and which of the rays is in a lane; the others wait. */
typedef struct crowd {
    const common_heights *f;
    const pov_ray *const *rays;
    pov_hits *const *hits;
    uint32_t n, next;
    uint32_t in[LANES];
    common_walk w;
    cell_lanes c;
    queue q;
    group of[MANY / LANES];
} crowd;

COMMON_SEPARATE static void place_lanes(const common_heights *restrict f, const common_entries *restrict e, cell_lanes *restrict c,
                                        common_walk *restrict w, uint32_t half)
{
    for (uint32_t i = 0; i < COMMON_ENTRIES; i++) {
        const uint32_t l = half * COMMON_ENTRIES + i;
        const double base = e->lo[i] > 0.0 ? e->lo[i] : 0.0, span = e->hi[i] - base;
        const double most = c->tmax[l] * e->per_unit[i] * (1.0 + 0x1p-20) - base + 0x1p-40 * (1.0 + base), to = span < most ? span : most;
        const double x = pov_along(pov_two_of(e->f[0][i], e->f[1][i]), base, e->d[0][i], e->d_lo[0][i]) + 0.5;
        const double y = pov_along(pov_two_of(e->f[2][i], e->f[3][i]), base, e->d[1][i], e->d_lo[1][i]) + 0.5;
        const double z = pov_along(pov_two_of(e->f[4][i], e->f[5][i]), base, e->d[2][i], e->d_lo[2][i]) + 0.5;
        const double size = fabs(x) > fabs(y) ? fabs(x) : fabs(y);

        c->at[0][l] = x * (f->wide - 1.0);
        c->at[1][l] = y * 0x1p16;
        c->at[2][l] = z * (f->deep - 1.0);
        c->by[0][l] = e->d[0][i] * (f->wide - 1.0);
        c->by[1][l] = e->d[1][i] * 0x1p16;
        c->by[2][l] = e->d[2][i] * (f->deep - 1.0);
        c->off[l] = 0x1p-10 * (1.0 + (size > fabs(z) ? size : fabs(z)));
        for (int k = 0; k < 3; k++) {
            w->o[k][l] = (float)c->at[k][l];
            w->d[k][l] = (float)c->by[k][l];
        }
        w->to[l] = (float)(to < 8.0 ? to + 0x1p-18 : 8.0);
    }
}

/* May a ray go beside others? */
static bool may_walk(const common_heights *f, const common_entries *e, uint32_t i, const pov_hits *hits)
{
    return hits->want != POV_WANT_ALL && !hits->always_exact && f->ranges.at && pov_largest(pov_vec3_of(e->f[0][i], e->f[2][i], e->f[4][i])) < COMMON_FAR;
}

/* Up to LANES rays. One that misses the box neither goes nor is unsure. */
static void begin_group(const common_heights *f, group *g, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    bool single[LANES];

    for (uint32_t i = 0; i < LANES; i++)
        g->c.tmax[i] = hits[i < n ? i : n - 1]->tmax;
    memset(g->c.height, 0, sizeof g->c.height);
    for (uint32_t half = 0; half < HALVES; half++) {
        const uint32_t from = half * COMMON_ENTRIES < n ? half * COMMON_ENTRIES : 0, rest = n - from;

        common_boxed_enter(&f->boxed, rays + from, rest < COMMON_ENTRIES ? rest : COMMON_ENTRIES, &g->e[half]);
        place_lanes(f, &g->e[half], &g->c, &g->w, half);
    }
    for (uint32_t i = 0; i < LANES; i++) {
        const common_entries *e = &g->e[i / COMMON_ENTRIES];
        const uint32_t l = i % COMMON_ENTRIES;
        const bool reaches = i < n && common_boxed_reaches(e, l, hits[i]), walks = reaches && may_walk(f, e, l, hits[i]);

        g->w.goes[i] = walks ? -1 : 0;
        single[i] = reaches && !walks;
    }
    common_walk_begin(&f->ranges, &g->w);
    for (uint32_t i = 0; i < n; i++)
        g->w.unsure[i] = (g->w.unsure[i] && common_boxed_reaches(&g->e[i / COMMON_ENTRIES], i % COMMON_ENTRIES, hits[i])) || single[i] ? -1 : 0;
}

COMMON_SEPARATE static void judge_lanes(cell_lanes *restrict c, const common_walk *restrict w)
{
    for (uint32_t i = 0; i < LANES; i++) {
        const double a = c->height[0][i], b = c->height[1][i], h = c->height[2][i], d = c->height[3][i], du = c->by[0][i], dv = c->by[2][i];
        const double u = c->at[0][i] - w->x[i], v = c->at[2][i] - w->z[i], p = 1.0 - u, q = 1.0 - v, y = c->at[1][i], rise = c->by[1][i];
        const double off = c->off[i] * (2.0 + fabs(du) + fabs(dv) + fabs(u) + fabs(v));
        const common_judged low = common_judge_face(y - a - u * (b - a) - v * (h - a), rise - du * (b - a) - dv * (h - a), u, v, du, dv, off);
        const common_judged high = common_judge_face(y - d - p * (h - d) - q * (b - d), rise + du * (h - d) + dv * (b - d), p, q, -du, -dv, off);

        c->across[0][i] = low.across;
        c->sure[0][i] = low.sure;
        c->across[1][i] = high.across;
        c->sure[1][i] = high.sure;
    }
}

/* At t a ray is `above` + t `rise` over the plane, so where it crosses that it is `over` - t `by` above the water: of this, times the size of
 * `rise`, the sign counts. */
COMMON_INLINE double height_of(double above, double rise, double over, double by) { return (over * rise - above * by) * (rise < 0.0 ? -1.0 : 1.0); }

/* Heights over a plane, and what they change by, are off by less than `off`. */
COMMON_SEPARATE static void judge_water(cell_lanes *restrict c, const common_walk *restrict w, double water)
{
    for (uint32_t i = 0; i < LANES; i++) {
        const double a = c->height[0][i], b = c->height[1][i], h = c->height[2][i], d = c->height[3][i], du = c->by[0][i], dv = c->by[2][i];
        const double u = c->at[0][i] - w->x[i], v = c->at[2][i] - w->z[i], p = 1.0 - u, q = 1.0 - v, y = c->at[1][i], by = c->by[1][i];
        const double off = c->off[i] * (2.0 + fabs(y - water) + fabs(by));
        const double low = height_of(y - a - u * (b - a) - v * (h - a), by - du * (b - a) - dv * (h - a), y - water, by);
        const double high = height_of(y - d - p * (h - d) - q * (b - d), by + du * (h - d) + dv * (b - d), y - water, by);

        c->dry[0][i] = low - off;
        c->wet[0][i] = -low - off;
        c->dry[1][i] = high - off;
        c->wet[1][i] = -high - off;
    }
}

/* Of some lanes. */
static void judge_cells(const common_heights *f, cell_lanes *c, const common_walk *w, uint32_t lanes)
{
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = common_first_lane(lanes);
        const uint16_t *at = f->height + (size_t)w->z[i] * f->wide + (uint32_t)w->x[i];

        c->height[0][i] = at[0];
        c->height[1][i] = at[1];
        c->height[2][i] = at[f->wide];
        c->height[3][i] = at[f->wide + 1];
    }
    judge_lanes(c, w);
    if (f->water > 0.0)
        judge_water(c, w, 65536.0 * f->water);
}

/* Of a face that a lane passes through: what the water does to it. */
static inline common_passing above_water(const cell_lanes *c, uint32_t lane, uint32_t face)
{
    return c->dry[face][lane] > 0.0 ? COMMON_THROUGH : c->wet[face][lane] > 0.0 ? COMMON_BESIDE : COMMON_UNCLEAR;
}

/* Of a face, 0 or 1, of the cell that a lane is near. The face that its ray starts on does not count, nor what is below the water. */
static inline common_passing verdict_in(const crowd *c, uint32_t lane, uint32_t face)
{
    const common_judged of = { c->c.across[face][lane], c->c.sure[face][lane] };
    const common_passing found = common_passing_of(of);
    const pov_ray *ray = c->rays[c->in[lane]];
    const uint32_t feature = 2 * ((uint32_t)c->w.z[lane] * (c->f->wide - 1) + (uint32_t)c->w.x[lane]) + face;
    const bool starts_there = ray->origin_surface == c->hits[c->in[lane]]->owner && ray->origin_mark.feature == feature;

    if (found != COMMON_THROUGH)
        return found;
    if (starts_there)
        return COMMON_BESIDE;
    return c->f->water > 0.0 ? above_water(&c->c, lane, face) : COMMON_THROUGH;
}

static common_entry entry_of(const crowd *c, uint32_t ray)
{
    const group *g = &c->of[ray / LANES];

    return common_boxed_entry(&g->e[ray % LANES / COMMON_ENTRIES], ray % COMMON_ENTRIES);
}

static void cross_single(const crowd *c, uint32_t ray)
{
    const common_entry e = entry_of(c, ray);

    common_heights_cross(c->f, c->rays[ray], &e, c->hits[ray]);
}

/* The crossing of another object may be there from before. */
static bool has_found(const pov_hits *hits) { return hits->count > 0 && hits->at->owner == hits->owner; }

/* A ray by whose crossing nothing was found is asked by itself: what counts may lie farther on. */
static void cross_queued(crowd *c)
{
    queue *q = &c->q;
    const uint32_t open = q->n > 0 ? common_triangle_cross_many(q->pair, q->n, 1.0) : 0;

    for (uint32_t i = 0; i < q->n; i++)
        if ((open >> i & 1) || !has_found(q->pair[i].hits))
            cross_single(c, q->ray[i]);
    q->n = 0;
}

/* The face, 0 or 1, of the cell that a lane is near. */
static void queue_face(crowd *c, uint32_t lane, uint32_t face)
{
    const uint32_t x = (uint32_t)c->w.x[lane], z = (uint32_t)c->w.z[lane];
    queue *q = &c->q;
    common_triangle_pair *p = &q->pair[q->n];

    q->corner[q->n][0].at = face ? common_height_corner(c->f, x + 1, z) : common_height_corner(c->f, x, z);
    q->corner[q->n][1].at = face ? common_height_corner(c->f, x + 1, z + 1) : common_height_corner(c->f, x + 1, z);
    q->corner[q->n][2].at = common_height_corner(c->f, x, z + 1);
    for (int k = 0; k < 3; k++) {
        q->corner[q->n][k].behind = 0.0;
        p->corner[k] = &q->corner[q->n][k].at;
    }
    p->ray = c->rays[c->in[lane]];
    p->hits = c->hits[c->in[lane]];
    p->feature = 2 * (z * (c->f->wide - 1) + x) + face;
    q->ray[q->n++] = c->in[lane];
    if (q->n == COMMON_TRIANGLES)
        cross_queued(c);
}

/* The next ray that goes; those that may not go beside others are asked by themselves. False: there is none. */
static bool take_next(crowd *c, uint32_t lane)
{
    while (c->next < c->n) {
        const uint32_t ray = c->next++, i = ray % LANES;
        const group *g = &c->of[ray / LANES];

        if (g->w.goes[i]) {
            c->in[lane] = ray;
            common_walk_load(&c->w, lane, &g->w, i);
            for (int k = 0; k < 3; k++) {
                c->c.at[k][lane] = g->c.at[k][i];
                c->c.by[k][lane] = g->c.by[k][i];
            }
            c->c.off[lane] = g->c.off[i];
            return true;
        }
        if (g->w.unsure[i])
            cross_single(c, ray);
    }
    return false;
}

/* The first rays, a lane for each, and then the next: which lanes go, as bits. */
static uint32_t take_first(crowd *c)
{
    const uint32_t some = c->n < LANES ? c->n : LANES;
    uint32_t used = 0;

    c->w = c->of[0].w;
    c->c = c->of[0].c;
    c->next = some;
    for (uint32_t i = 0; i < some; i++) {
        c->in[i] = i;
        if (!c->w.goes[i] && c->w.unsure[i])
            cross_single(c, i);
        used |= (uint32_t)(c->w.goes[i] || take_next(c, i)) << i;
    }
    return used;
}

/* A lane that has stopped: it goes on behind a cell whose faces it passes, or its ray is done. */
static bool goes_on(crowd *c, uint32_t lane)
{
    const bool is_near = c->w.is_near[lane] != 0;
    const common_passing low = is_near ? verdict_in(c, lane, 0) : COMMON_UNCLEAR, high = is_near ? verdict_in(c, lane, 1) : COMMON_UNCLEAR;

    c->w.is_near[lane] = 0;
    if (low == COMMON_BESIDE && high == COMMON_BESIDE) {
        c->w.past[lane] = c->w.goes[lane] = -1;
        return true;
    }
    if (is_near && low + high == COMMON_THROUGH + COMMON_BESIDE)
        queue_face(c, lane, high == COMMON_THROUGH);
    else if (is_near || c->w.unsure[lane])
        cross_single(c, c->in[lane]);
    return take_next(c, lane);
}

/* Up to MANY rays. */
static void cross_many(const common_heights *f, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    enum { ENOUGH = 8 };         /* so many that have stopped are seen to at a time */
    uint32_t used;
    crowd c;

    c.f = f;
    c.rays = rays;
    c.hits = hits;
    c.n = n;
    c.q.n = 0;
    for (uint32_t i = 0; i < n; i += LANES)
        begin_group(f, &c.of[i / LANES], rays + i, hits + i, n - i < LANES ? n - i : LANES);
    used = take_first(&c);
    while (used) {
        const uint32_t go = common_walk_on(&f->ranges, &c.w, common_count(used) > ENOUGH ? common_count(used) - ENOUGH : 0);

        judge_cells(f, &c.c, &c.w, used & ~go);
        for (uint32_t left = used & ~go; left; left &= left - 1) {
            const uint32_t lane = common_first_lane(left);

            if (!goes_on(&c, lane))
                used &= ~(1u << lane);
        }
    }
    cross_queued(&c);
}

void common_heights_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    enum { LEAST = 4 };

    for (uint32_t i = 0, some; i < n; i += some) {
        const common_heights *f = selves[i];

        for (some = 1; some < MANY && i + some < n && selves[i + some] == selves[i];)
            some++;
        if (some >= LEAST && f->relief.levels)
            cross_many(f, rays + i, hits + i, some);
        else
            common_boxed_intersect_many(offsetof(common_heights, boxed), common_heights_cross, NULL, false, selves + i, rays + i, hits + i, some);
    }
}
