/* Several rays and one tree: which of them certainly pass it, and which crossing is certainly the first of each other. What is open is
 * left to csg_intersect(). */
#include "world/csg_lanes.h"

#include <string.h>

enum { GROUPS = POV_RAYS_MAX / CSG_TOGETHER };

/* ---- rays ---- */

SIMD_INLINE void come_near(const csg_outline *of, const pov_rays *restrict rays, uint32_t first, uint32_t n,
                           csg_near_rays *restrict out)
{
    const pov_vec3 centre = of->centre;
    const double size = of->size, per_size = of->per_size;

    for (uint32_t i = 0; i < n; i++) {
        const uint32_t k = first + i;
        const double x = (rays->org[0][k] - centre.x) * per_size, y = (rays->org[1][k] - centre.y) * per_size,
            z = (rays->org[2][k] - centre.z) * per_size, per_length = rays->per_length[k];
        const double from = csg_greater(csg_greater(fabs(x), fabs(y)), fabs(z));
        const double dx = rays->dir[0][k] * per_length, dy = rays->dir[1][k] * per_length, dz = rays->dir[2][k] * per_length;
        const double start = x * dx + y * dy + z * dz, px = x - dx * start, py = y - dy * start, pz = z - dz * start;

        out->of[CSG_NEAR_AT][i] = px;
        out->of[CSG_NEAR_AT + 1][i] = py;
        out->of[CSG_NEAR_AT + 2][i] = pz;
        out->of[CSG_NEAR_ALONG][i] = dx;
        out->of[CSG_NEAR_ALONG + 1][i] = dy;
        out->of[CSG_NEAR_ALONG + 2][i] = dz;
        out->of[CSG_NEAR_SQUARE][i] = px * px + py * py + pz * pz;
        out->of[CSG_NEAR_START][i] = start;
        out->of[CSG_NEAR_PER_UNIT][i] = per_length * size;
        out->of[CSG_NEAR_FROM][i] = 1.0 + from;
        out->of[CSG_NEAR_OPEN][i] = from < CSG_FARTHEST ? 0.0 : 1.0;
    }
}

/* A small packet has no more than four lanes: behind them they come again. */
static void repeat(csg_near_rays *k)
{
    for (uint32_t i = 0; i < CSG_NEAR_NUMBERS; i++)
        memcpy(k->of[i] + CSG_TOGETHER / 2, k->of[i], sizeof(csg_lane) / 2);
}

/* The ray in lane i to lane j of others, with its columns `some`. */
static void move(const csg_near_rays *from, uint32_t i, uint32_t some, csg_near_rays *to, uint32_t j)
{
    for (uint32_t k = 0; k < CSG_NEAR_NUMBERS; k++)
        to->of[k][j] = from->of[k][i];
    for (; some; some &= some - 1) {
        const uint32_t c = first_of(some);

        to->in[c][j] = from->in[c][i];
        to->out[c][j] = from->out[c][i];
    }
}

/* ---- rays that pass ---- */

SIMD_INLINE void find_never(const csg_tree *t, bool endless, const double *restrict most, csg_near_rays *restrict k, double *restrict passed,
                            double *restrict lo)
{
    SIMD_ALIGNED csg_lane enter, leave;

    for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        enter[i] = -HUGE_VAL;
        leave[i] = HUGE_VAL;
    }
    for (uint32_t left = csg_lanes_within(t); left; left &= left - 1) {
        const uint32_t c = first_of(left);

        csg_lanes_cross(t->outline, c, c % CSG_FEW, k, endless);
        SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
            enter[i] = csg_greater(k->in[c % CSG_FEW][i], enter[i]);
            leave[i] = csg_lesser(k->out[c % CSG_FEW][i], leave[i]);
        }
    }
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        const double start = k->of[CSG_NEAR_START][i], last = csg_greater(enter[i], start), beside = last - leave[i];
        const double near = csg_lanes_near(k, i, last, endless), from = (enter[i] - start - near) * k->of[CSG_NEAR_PER_UNIT][i];
        const double never = beside > near ? 1.0 : from > most[i] ? 1.0 : endless && last == HUGE_VAL ? 1.0 : 0.0;

        passed[i] = k->of[CSG_NEAR_OPEN][i] > 0.0 ? 0.0 : never;
        lo[i] = k->of[CSG_NEAR_OPEN][i] > 0.0 ? 0.0 : csg_greater(from, 0.0);
    }
}

/* Rays and their ends, all eight of which have a place. */
SIMD_INLINE void load(const csg_tree *t, const pov_rays *restrict rays, uint32_t first, uint32_t n, csg_near_rays *restrict k,
                      double *restrict most)
{
    come_near(t->outline, rays, first, n, k);
    memcpy(most, rays->tmax + first, sizeof(csg_lane));
    if (n < CSG_TOGETHER) {
        repeat(k);
        memcpy(most + n, most, sizeof(csg_lane) / 2);
    }
}

/* Rays that are never within all members that are no complements, ahead and before their end, certainly pass the tree. Others do not
 * cross it before `lo`. */
SIMD_CLONES SIMD_NOINLINE static void find_passing(const csg_tree *t, const pov_rays *restrict rays, uint32_t first, uint32_t n,
                                     csg_near_rays *restrict k, double *restrict passed, double *restrict lo)
{
    SIMD_ALIGNED csg_lane most;

    load(t, rays, first, n, k, most);
    if (t->outline->endless)
        find_never(t, true, most, k, passed, lo);
    else
        find_never(t, false, most, k, passed, lo);
}

/* ---- rays that enter what all columns have in common ---- */

/* Of a tree with a box, as csg_sweep.c finds it for one ray: the last entry is the first crossing, if the ray starts outside of all that it
 * is not in, and no other crossing is near. The rest is open. */
SIMD_CLONES SIMD_NOINLINE static void find_entry(const csg_tree *t, const pov_rays *restrict rays, uint32_t first, uint32_t n,
                                                 csg_near_rays *restrict k, csg_firsts *restrict out)
{
    const double margin = CSG_OUTLINE_MARGIN;
    SIMD_ALIGNED csg_lane leave, before, clear, most;

    load(t, rays, first, n, k, most);
    for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        out->at[i] = before[i] = -HUGE_VAL;
        leave[i] = clear[i] = HUGE_VAL;
        out->crossing[i] = 0.0;
        out->inward[i] = 1.0;
    }
    for (uint32_t c = 0; c < t->outline->count; c++) {
        const double entry = 2.0 * c + 1.0;

        csg_lanes_cross(t->outline, c, 0, k, false);
        SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
            const double in = k->in[0][i], end = k->out[0][i], start = k->of[CSG_NEAR_START][i], at = out->at[i];

            before[i] = csg_greater(csg_lesser(in, at), before[i]);
            out->crossing[i] = in > at ? entry : out->crossing[i];
            out->at[i] = csg_greater(in, at);
            leave[i] = csg_lesser(end, leave[i]);
            clear[i] = csg_lesser(fabs(in - start), clear[i]);
        }
    }
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        const double start = k->of[CSG_NEAR_START][i], per_unit = k->of[CSG_NEAR_PER_UNIT][i], at = out->at[i], beyond = csg_greater(at, start) - leave[i];
        const double single = at - before[i] > 2.0 * margin ? leave[i] - at > 2.0 * margin ? 1.0 : 0.0 : 0.0;
        const double ahead = at > start ? clear[i] > margin ? fabs(at) < 2.0 ? single : 0.0 : 0.0 : 0.0;
        const double from = (at - start - margin) * per_unit, never = beyond > margin ? 1.0 : from > most[i] ? 1.0 : 0.0;

        out->passed[i] = k->of[CSG_NEAR_OPEN][i] > 0.0 ? 0.0 : never;
        out->open[i] = k->of[CSG_NEAR_OPEN][i] > 0.0 ? 1.0 : 1.0 - ahead;
        out->lo[i] = csg_greater(from, 0.0);
        out->hi[i] = (at - start + margin) * per_unit;
    }
}

/* ---- candidates ---- */

/* Rays that do not certainly pass the tree, `count` of them; the group behind them is filled before it is known which ones these are. */
typedef struct waiting { csg_near_rays group[GROUPS + 1]; uint32_t count; } waiting;

static void add(const csg_near_rays *of, uint32_t i, uint32_t within, waiting *to)
{
    csg_near_rays *group = &to->group[to->count / CSG_TOGETHER];
    const uint32_t j = to->count++ % CSG_TOGETHER;

    if (j == 0 && of != group)
        *group = *of;
    if (of != group || j != i)
        move(of, i, within, group, j);
    group->ray[j] = of->ray[i];
}

/* Those of the rays of `some`, eight from `first` on, that do not leave a convex member outward, and so the tree, which is within it. */
static uint32_t staying(const csg_tree *t, const pov_rays *rays, uint32_t first, uint32_t some)
{
    const uint32_t leaf = t->members[0].leaf, members = t->member_count;
    uint32_t any = 0;

    for (uint32_t i = 0; i < CSG_TOGETHER; i++)
        any |= rays->excluded[first + i] - leaf < members ? 1 : 0;
    for (uint32_t left = any ? some : 0; left; left &= left - 1) {
        const pov_ray *ray = rays->rays[first + first_of(left)];

        if (ray->origin_mark.flags & POV_MARK_OUTWARD && t->outline->convex >> csg_lanes_column(t, ray->origin_surface) & 1)
            some &= ~(1u << first_of(left));
    }
    return some;
}

/* The rays of `some`, eight from `first` on. */
static void take(const csg_tree *t, const pov_rays *rays, uint32_t first, uint32_t some, waiting *to)
{
    csg_near_rays *k = &to->group[to->count % CSG_TOGETHER ? GROUPS : to->count / CSG_TOGETHER];
    SIMD_ALIGNED csg_lane passed, lo;
    uint32_t n;

    some = staying(t, rays, first, some);
    if (!some)
        return;
    n = some >> CSG_TOGETHER / 2 ? CSG_TOGETHER : CSG_TOGETHER / 2;
    find_passing(t, rays, first, n, k, passed, lo);
    for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        k->ray[i] = (uint8_t)(first + i % n);
        some &= ~((passed[i] > 0.0 ? 1u : 0u) << i);
    }
    for (; some; some &= some - 1)
        add(k, first_of(some), csg_lanes_within(t), to);
}

static pov_candidate candidate_of(const csg_tree *t, const csg_firsts *f, uint32_t i, double most)
{
    const uint32_t crossing = (uint32_t)f->crossing[i], column = crossing >> 1;
    const bool enters = crossing & 1;
    pov_candidate m = { .lo = 0.0 };
    bool inward;

    if (f->open[i] > 0.0)
        return m;
    m.lo = f->lo[i];
    m.hi = f->hi[i];
    m.definite = m.hi * (1.0 + 0x1p-40) < most;
    inward = t->chords.all ? enters == (t->chords.within >> column & 1) : f->inward[i] > 0.0;
    m.note = column | (enters ? CSG_NOTE_ENTERS : 0) | (inward ? CSG_NOTE_INWARD : 0);
    return m;
}

/* That of a ray, in a lane of those; returns their number. */
static uint32_t put_candidate(const csg_tree *t, const csg_firsts *f, uint32_t i, double most, uint32_t ray, uint32_t which, pov_candidate *out)
{
    if (f->passed[i] > 0.0)
        return 0;
    *out = candidate_of(t, f, i, most);
    out->ray = (uint8_t)ray;
    out->lane = (uint8_t)which;
    return !(out->lo > most);
}

/* The first n rays of a group. */
static uint32_t examine(const csg_tree *t, const pov_rays *rays, csg_near_rays *k, uint32_t n, uint32_t which, pov_candidate *out)
{
    uint32_t found = 0;
    csg_firsts f;

    (t->chords.all ? csg_lanes_first_chord : csg_lanes_first_swept)(t, rays, k, &f);
    for (uint32_t i = 0; i < n; i++)
        found += put_candidate(t, &f, i, rays->tmax[k->ray[i]], k->ray[i], which, out + found);
    return found;
}

static uint32_t filter(const csg_tree *t, const pov_rays *rays, uint64_t lanes, uint32_t which, pov_candidate *out)
{
    uint32_t found = 0;
    waiting k;

    k.count = 0;
    for (uint32_t first = 0; first < POV_RAYS_MAX && lanes >> first; first += CSG_TOGETHER)
        if (lanes >> first & ((1u << CSG_TOGETHER) - 1))
            take(t, rays, first, (uint32_t)(lanes >> first) & ((1u << CSG_TOGETHER) - 1), &k);
    for (uint32_t i = 0; i < k.count; i += CSG_TOGETHER)
        found += examine(t, rays, &k.group[i / CSG_TOGETHER], k.count - i < CSG_TOGETHER ? k.count - i : CSG_TOGETHER, which, out + found);
    return found;
}

/* Does a table tell what happens at each crossing? */
static bool has_table(const csg_tree *t)
{
    const csg_outline *of = t->outline;

    return of->values && of->count <= CSG_TABLE_COLUMNS && !(of->asked | of->held) && !t->clipped.outlined;
}

static uint32_t filter_common(const csg_tree *t, const pov_rays *rays, uint64_t lanes, uint32_t which, pov_candidate *out)
{
    uint32_t found = 0;
    csg_near_rays k;
    csg_firsts f;

    for (uint32_t first = 0; first < POV_RAYS_MAX && lanes >> first; first += CSG_TOGETHER) {
        uint32_t some = staying(t, rays, first, (uint32_t)(lanes >> first) & ((1u << CSG_TOGETHER) - 1));

        if (some)
            find_entry(t, rays, first, some >> CSG_TOGETHER / 2 ? CSG_TOGETHER : CSG_TOGETHER / 2, &k, &f);
        for (; some; some &= some - 1)
            found += put_candidate(t, &f, first_of(some), rays->tmax[first + first_of(some)], first + first_of(some), which, out + found);
    }
    return found;
}

/* What is clipped, and what has many members, is left to csg_intersect() where the columns that hold it do not tell. */
static uint32_t filter_passing(const csg_tree *t, const pov_rays *rays, uint64_t lanes, uint32_t which, pov_candidate *out)
{
    SIMD_ALIGNED csg_lane passed, lo;
    uint32_t found = 0;
    csg_near_rays k;

    for (uint32_t first = 0; first < POV_RAYS_MAX && lanes >> first; first += CSG_TOGETHER) {
        uint32_t some = staying(t, rays, first, (uint32_t)(lanes >> first) & ((1u << CSG_TOGETHER) - 1));

        if (some)
            find_passing(t, rays, first, some >> CSG_TOGETHER / 2 ? CSG_TOGETHER : CSG_TOGETHER / 2, &k, passed, lo);
        for (; some; some &= some - 1) {
            const uint32_t i = first_of(some);

            out[found] = (pov_candidate){ .lo = lo[i], .ray = (uint8_t)(first + i), .lane = (uint8_t)which };
            found += !(passed[i] > 0.0);
        }
    }
    return t->clipped.outlined ? csg_clipped_narrow(t, rays, out, found) : found;
}

static uint32_t decline(uint64_t lanes, uint32_t which, pov_candidate *out)
{
    uint32_t n = 0;

    for (; lanes; lanes &= lanes - 1, n++)
        out[n] = (pov_candidate){ .ray = (uint8_t)first_of64(lanes), .lane = (uint8_t)which };
    return n;
}

/* A single ray is left to csg_intersect(), which looks at the columns side by side. */
uint32_t csg_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_candidate *out)
{
    const csg_block *b = block;
    uint32_t n = 0;

    (void)owners;
    for (uint32_t which = 0; which < b->count; which++) {
        const csg_tree *t = b->tree[which];

        if ((lanes & (lanes - 1)) == 0 || !t->outline || !(csg_lanes_within(t) || has_table(t)))
            n += decline(lanes, which, out + n);
        else if (t->chords.all || has_table(t))
            n += filter(t, rays, lanes, which, out + n);
        else if (!t->clipped.outlined && !t->outline->endless && csg_is_common(t))
            n += filter_common(t, rays, lanes, which, out + n);
        else
            n += filter_passing(t, rays, lanes, which, out + n);
    }
    return n;
}
