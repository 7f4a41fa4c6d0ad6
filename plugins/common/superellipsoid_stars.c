/* Rays at stars side by side: each searches its stretches in turn as common/superellipsoid_star.c does, and those that have come to a stretch
 * with one crossing wait until all do, or have ended. */
#include "common/superellipsoid_lanes.h"
#include "common/superellipsoid_star.h"

/* As deep as a stretch may be halved, and the other halves. */
enum { STACK = 28 };

/* A ray: the stretches left, the nearest last, and the one at hand. */
typedef struct seeker {
    const star_ray *ray;
    common_span within;
    stretch left[STACK], at;
    uint32_t count;
    bool open, waits;            /* is there one at hand? Is its only crossing to be found? */
} seeker;

typedef lane places_of_lanes[PLACES];
typedef struct known_lanes { line_lanes lines; lane e, n, by_n, at_zero_e, at_zero_n, lo, hi; places_of_lanes x, y, z, approx, by_x, by_y, by_z, ring; lane is; } known_lanes;

COMMON_INLINE void put_places(places_of_lanes *out, uint32_t i, double o, double d, double lo, double hi)
{
    const double a = o + d * lo, b = o + d * hi;

    (*out)[NEAREST][i] = least_of(a, b);
    (*out)[FARTHEST][i] = larger(fabs(a), fabs(b));
    (*out)[MIDDLE][i] = o + d * (0.5 * (lo + hi));
}

COMMON_INLINE star_power power_of_lane(const known_lanes *l, int place, uint32_t i)
{
    const star_power power = { l->approx[place][i], l->by_x[place][i], l->by_y[place][i], l->by_z[place][i], l->ring[place][i] };

    return power;
}

COMMON_INLINE void find_powers(known_lanes *restrict l, int place)
{
    COMMON_LOOP
    for (uint32_t i = 0; i < TOGETHER; i++) {
        const star_powers s = { l->e[i], l->n[i], l->by_n[i], l->at_zero_e[i], l->at_zero_n[i] };
        const star_power power = power_at(&s, l->x[place][i], l->y[place][i], l->z[place][i]);

        l->approx[place][i] = power.value;
        l->by_x[place][i] = power.by_x;
        l->by_y[place][i] = power.by_y;
        l->by_z[place][i] = power.by_z;
        l->ring[place][i] = power.ring;
    }
}

/* What approximate sizes tell of each lane's stretch. */
COMMON_SEPARATE static void find_lanes(known_lanes *restrict l)
{
    for (uint32_t i = 0; i < TOGETHER; i++) {
        put_places(&l->x, i, l->lines.o[0][i], l->lines.d[0][i], l->lo[i], l->hi[i]);
        put_places(&l->y, i, l->lines.o[1][i], l->lines.d[1][i], l->lo[i], l->hi[i]);
        put_places(&l->z, i, l->lines.o[2][i], l->lines.d[2][i], l->lo[i], l->hi[i]);
    }
    find_powers(l, NEAREST);
    find_powers(l, FARTHEST);
    find_powers(l, MIDDLE);
    for (uint32_t i = 0; i < TOGETHER; i++) {
        const star_power nearest = power_of_lane(l, NEAREST, i), farthest = power_of_lane(l, FARTHEST, i);
        const bool off = (l->x[NEAREST][i] > 0x1p-30) & (l->y[NEAREST][i] > 0x1p-30) & (l->z[NEAREST][i] > 0x1p-30);
        const pov_vec3 d = { l->lines.d[0][i], l->lines.d[1][i], l->lines.d[2][i] };
        const pov_vec3 at = { l->x[MIDDLE][i], l->y[MIDDLE][i], l->z[MIDDLE][i] };

        l->is[i] = known_of(&nearest, &farthest, l->approx[MIDDLE][i], off, d, at, 0.5 * (l->hi[i] - l->lo[i]));
    }
}

static void get_places(const known_lanes *l, uint32_t i, places *out)
{
    for (int p = 0; p < PLACES + 1; p++) {
        const int from = p < PLACES ? p : MIDDLE;

        out->x[p] = l->x[from][i];
        out->y[p] = l->y[from][i];
        out->z[p] = l->z[from][i];
        out->approx[p] = l->approx[from][i];
    }
    out->exact = false;
}

/* The next stretch that may hold something. */
static bool take_next(seeker *s)
{
    while (s->count > 0) {
        s->at = s->left[--s->count];
        if (!is_past(&s->ray->n, &s->ray->k, &s->within, &s->at, s->ray->hits))
            return true;
    }
    return false;
}

static void report_at(seeker *s, double t)
{
    if (!report(&s->ray->n, &s->ray->k, t, s->ray->hits))
        s->count = 0;
}

/* What is known of the stretch at hand leads on. */
static void go_on(seeker *s, const known_lanes *l, uint32_t i)
{
    const line *n = &s->ray->n;
    stretch near, far;
    places p;
    quest next;

    if ((known)l->is[i] == NOTHING)
        get_places(l, i, &p);
    next = common_star_quest(n, &p, (known)l->is[i], &s->at, &near, &far);
    if (next == HALVES) {
        s->left[s->count++] = far;
        s->left[s->count++] = near;
    } else if (next != NO_MORE && is_any_between(n, &s->ray->k, s->at.lo, s->at.hi, s->ray->hits)) {
        report_at(s, 0.5 * (s->at.lo + s->at.hi));
    } else if (next == CROSSING) {
        report_at(s, common_star_bisect(n, s->at.lo, s->at.hi, s->at.out));
    }
    s->waits = next == ONLY && !is_any_between(n, &s->ray->k, s->at.lo, s->at.hi, s->ray->hits);
}

/* A step of Newton's method kept between two points. False: it is for the last bits, and they have none between them. */
static inline bool step_between(stretch *s, double value, double slope, bool approx, double *t)
{
    double next;

    *((value > 0.0) == s->out ? &s->lo : &s->hi) = *t;
    next = *t - value / slope;
    next = next > s->lo && next < s->hi ? next : 0.5 * (s->lo + s->hi);
    if (!approx && !(next > s->lo && next < s->hi))
        return false;
    *t = next;
    return true;
}

/* Turns until the sizes of all that are open are within `off` of one. */
static void take_turns(seeker *all, const line_lanes *lines, bool approx, bool *open, double *t)
{
    const int most = approx ? APPROX_TURNS : EXACT_TURNS;
    lane value, slope;
    bool any = true;

    for (int turn = 0; any && turn < most; turn++) {
        (approx ? approxes_along : sizes_along)(lines, t, value, slope);
        any = false;
        for (uint32_t i = 0; i < TOGETHER; i++) {
            open[i] = open[i] && fabs(value[i]) > (approx ? APPROX : FINE) &&
                      step_between(&all[i].at, value[i], slope[i], approx, &t[i]);
            any = any || open[i];
        }
    }
}

/* The only crossings of those that wait for theirs. */
static void find_only(seeker *all, const line_lanes *lines)
{
    bool open[TOGETHER];
    lane t;

    for (uint32_t i = 0; i < TOGETHER; i++) {
        open[i] = all[i].waits;
        t[i] = all[i].waits ? 0.5 * (all[i].at.lo + all[i].at.hi) : 0.0;
    }
    take_turns(all, lines, true, open, t);
    for (uint32_t i = 0; i < TOGETHER; i++)
        open[i] = all[i].waits;
    take_turns(all, lines, false, open, t);
    for (uint32_t i = 0; i < TOGETHER; i++) {
        seeker *s = &all[i];

        if (s->waits)
            report_at(s, open[i] ? common_star_bisect(&s->ray->n, s->at.lo, s->at.hi, s->at.out) : t[i]);
        s->waits = false;
    }
}

/* Rays yet to be searched. */
typedef struct queue { const star_ray *next, *end; const bool *out; } queue;

static void put_ray(known_lanes *l, const line *n, uint32_t i)
{
    const star_powers s = powers_of(n->s);

    put_line(&l->lines, n, i);
    l->e[i] = s.e;
    l->n[i] = s.n;
    l->by_n[i] = s.ring;
    l->at_zero_e[i] = s.at_zero_e;
    l->at_zero_n[i] = s.at_zero_n;
}

/* A stretch to look at: the ray's next, or the first of another ray. */
static bool find_stretch(seeker *s, queue *rays, known_lanes *l, uint32_t i)
{
    bool found = take_next(s);

    while (!found && rays->next < rays->end) {
        s->ray = rays->next++;
        s->count = common_star_whole(&s->ray->n, s->ray->from, *rays->out++, &s->within, &s->left[0]) ? 1 : 0;
        found = take_next(s);
        if (found)
            put_ray(l, &s->ray->n, i);
    }
    return found;
}

/* Do they start outside? */
static void find_outside(const star_ray *rays, uint32_t n, bool *out)
{
    line_lanes lines;
    lane t, value, slope;

    for (uint32_t some; n > 0; n -= some, rays += some, out += some) {
        bool any = false;

        some = n < TOGETHER ? n : TOGETHER;
        for (uint32_t i = 0; i < TOGETHER; i++) {
            const star_ray *r = &rays[i < some ? i : some - 1];

            put_line(&lines, &r->n, i);
            t[i] = r->from;
            any = any || r->from > r->n.span.lo;
        }
        if (any)
            sizes_along(&lines, t, value, slope);
        for (uint32_t i = 0; i < some; i++)
            out[i] = !(rays[i].from > rays[i].n.span.lo) || value[i] > 0.0;
    }
}

void common_superellipsoid_stars(const star_ray *rays, uint32_t n)
{
    static const superellipsoid octahedron = { 1.0, 1.0, true, true };
    static const line none = { .s = &octahedron };
    bool out[STARS];
    queue left = { rays, rays + n, out };
    seeker all[TOGETHER];
    known_lanes l;
    bool any = n > 0, waits;

    find_outside(rays, n, out);
    for (uint32_t i = 0; i < TOGETHER; i++) {
        put_ray(&l, &none, i);
        l.lo[i] = l.hi[i] = 0.0;
        all[i].count = 0;
        all[i].waits = false;
    }
    while (any) {
        any = waits = false;
        for (uint32_t i = 0; i < TOGETHER; i++) {
            seeker *s = &all[i];

            s->open = !s->waits && find_stretch(s, &left, &l, i);
            l.lo[i] = s->open ? s->at.lo : l.lo[i];
            l.hi[i] = s->open ? s->at.hi : l.hi[i];
            any = any || s->open;
            waits = waits || s->waits;
        }
        if (any)
            find_lanes(&l);
        for (uint32_t i = 0; any && i < TOGETHER; i++)
            if (all[i].open)
                go_on(&all[i], &l, i);
        if (!any && waits)
            find_only(all, &l.lines);
        any = any || waits;
    }
}
