/* A ray's way through a julia_fractal: long stretches where they are clear, short ones near the surface. What a ray asks next depends on
 * the last answer, so several rays go on side by side, each with its own question. */
#include "common/julia.h"

#include "common/clip.h"

/* Above 0: outside. */
typedef struct sample { double t, value; uint32_t place; } sample;

/* The question that is open: the point at the ray's start; a stretch; its end, and its start again; a place between these. */
typedef enum question { AT_START, OF_STRETCH, AT_END, AT_FRONT, BETWEEN } question;

typedef struct march {
    const common_julia *j;
    pov_hits *hits;
    pov_vec3 o, d;               /* points at o + t d; numbers change by `rate` t */
    double base, rate, unit;
    double near, side;           /* up to there the value is that of the start: rounding decides nothing */
    double to, enough;           /* beyond `enough` nothing is wanted */
    double shortest, length;
    question now;
    double t;                    /* of the question */
    sample a, b;                 /* the stretch that is looked at */
    sample low, high;            /* around its crossing */
    double from, until, least;   /* values that count there; where it is known well enough */
    uint32_t turn;
} march;

static bool is_out(sample a) { return a.value > 0.0; }

static void ask(march *m, question now, double t, double off, common_spheres *s, uint32_t lane)
{
    m->now = now;
    m->t = t;
    common_spheres_put(s, lane, pov_add(m->o, pov_scale(m->d, t)), off);
}

static sample answer(const march *m, const common_spheres *s, uint32_t lane)
{
    sample a = { m->t, m->side, 0 };

    if (m->t < m->near)
        return a;
    a.value = s->square[lane] - m->j->reach * m->j->reach;
    a.value = a.value == a.value ? a.value : HUGE_VAL;
    a.place = (uint32_t)s->place[lane];
    return a;
}

/* ---- stretches ---- */

/* Where stretches end does not depend on what is wanted, so that crossings keep their bits whatever else is in the scene. */
static bool ask_next(march *m, common_spheres *s, uint32_t lane)
{
    const double next = m->a.t + (m->length > m->shortest ? m->length : m->shortest), end = next < m->to ? next : m->to;

    if (!(m->a.t < m->to && m->a.t <= m->enough))
        return false;
    m->b.t = end;
    if (m->length > m->shortest)
        ask(m, OF_STRETCH, 0.5 * (m->a.t + end), 0.5 * (end - m->a.t) * m->rate, s, lane);
    else
        ask(m, AT_END, end, 0.0, s, lane);
    return true;
}

static bool go_on(march *m, common_spheres *s, uint32_t lane)
{
    m->a = m->b;
    m->length = 2.0 * (m->length > m->shortest ? m->length : m->shortest);
    return ask_next(m, s, lane);
}

static bool take_stretch(march *m, common_spheres *s, uint32_t lane)
{
    const common_side side = common_spheres_side(s, lane);

    if (side == COMMON_OPEN) {
        m->length *= 0.25;
        return ask_next(m, s, lane);
    }
    if ((side == COMMON_OUT) != is_out(m->a)) {
        ask(m, AT_END, m->b.t, 0.0, s, lane);
        return true;
    }
    m->b.value = m->a.value;
    m->b.place = m->a.place;
    return go_on(m, s, lane);
}

static bool take_end(march *m, common_spheres *s, uint32_t lane)
{
    m->b = answer(m, s, lane);
    if (is_out(m->a) == is_out(m->b))
        return go_on(m, s, lane);
    ask(m, AT_FRONT, m->a.t, 0.0, s, lane);
    return true;
}

/* ---- crossings ---- */

/* What is left of the value that stays, where the other one becomes `next` from `before` (Anderson and Bjorck). */
static double weight(double next, double before)
{
    const double rest = 1.0 - next / before;

    return rest > 0.0 ? rest : 0.5;
}

/* Each guess goes a little beyond the root, so that both sides come near. */
static void aim(march *m, common_spheres *s, uint32_t lane)
{
    const double low = m->low.t, high = m->high.t, share = m->from / (m->from - m->until);
    double guess;

    m->least = 0x1p-50 * (fabs(low) + m->j->reach / m->rate);
    guess = low + share * (high - low) + (share < 0.5 ? 0.5 : -0.5) * m->least;
    ask(m, BETWEEN, m->turn++ % 8 < 7 && guess > low && guess < high ? guess : 0.5 * (low + high), 0.0, s, lane);
}

/* False: nothing more is wanted. */
static bool report(const march *m, sample at)
{
    const pov_two t = pov_two_sum(m->base, at.t);
    const pov_mark mark = { at.place, 0, 0.0, 0.0 };
    pov_hits *hits = m->hits;

    return pov_cross(hits, t.hi * m->unit, t.lo * m->unit, mark) && !(hits->want == POV_WANT_NEAREST && t.hi * m->unit > hits->tmin);
}

static bool take_front(march *m, common_spheres *s, uint32_t lane)
{
    m->low = answer(m, s, lane);
    m->high = m->b;
    m->from = m->low.value;
    m->until = m->high.value;
    m->turn = 0;
    aim(m, s, lane);
    return true;
}

/* Between two points on different sides; a place beyond the last is none. The side whose value has stayed counts for less the next
 * time. */
static bool take_between(march *m, common_spheres *s, uint32_t lane)
{
    static const uint32_t TURNS = 200;
    const sample c = answer(m, s, lane);
    const bool is_within = c.t > m->low.t && c.t < m->high.t, is_low = is_out(c) == is_out(m->low);

    if (is_within && is_low) {
        m->until *= weight(c.value, m->from);
        m->low = c;
        m->from = c.value;
    } else if (is_within) {
        m->from *= weight(c.value, m->until);
        m->high = c;
        m->until = c.value;
    }
    if (is_within && m->high.t - m->low.t > m->least && m->turn < TURNS) {
        aim(m, s, lane);
        return true;
    }
    return report(m, is_out(m->low) ? m->low : m->high) && go_on(m, s, lane);
}

/* ---- rays ---- */

/* A ray that starts on the surface: on which side it goes on. */
static double side_ahead(const march *m, const pov_ray *ray)
{
    const uint32_t flags = ray->origin_mark.flags;

    if (flags & (POV_MARK_OUTWARD | POV_MARK_INWARD))
        return flags & POV_MARK_OUTWARD ? 0x1p-1000 : 0.0;
    return pov_dot(common_julia_slope(m->j, m->o, ray->origin_mark.feature), m->d) >= 0.0 ? 0x1p-1000 : 0.0;
}

/* Of the number, for a step of length 1 along the ray. */
static double rate_of(const common_julia *j, pov_vec3 d)
{
    const double *n = j->slice.v, last = (n[0] * d.x + n[1] * d.y + n[2] * d.z) / n[3];

    return sqrt(pov_dot(d, d) + last * last);
}

/* False: the ray does not come near. */
static bool begin(march *m, const common_julia *j, const pov_ray *ray, pov_hits *hits, common_spheres *s, uint32_t lane)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    common_span span;

    if (!common_clip(&k, j->box.lo, j->box.hi, &span) || span.hi <= 0.0 || span.lo * k.unit > hits->tmax)
        return false;
    m->j = j;
    m->hits = hits;
    m->base = span.lo > 0.0 ? span.lo : 0.0;
    m->o = common_along(&k, m->base);
    m->d = k.d;
    m->rate = rate_of(j, k.d);
    m->unit = k.unit;
    m->near = m->side = 0.0;
    m->to = span.hi - m->base;
    m->enough = hits->tmax * k.per_unit * (1.0 + 0x1p-20) - m->base;
    m->shortest = j->shortest / m->rate;
    if (ray->origin_surface == hits->owner) {
        m->near = 0x1p-26 * j->reach / m->rate;
        m->side = side_ahead(m, ray);
    }
    ask(m, AT_START, 0.0, 0.0, s, lane);
    return true;
}

/* The answer, and the next question. False: the ray is done. */
static bool take(march *m, common_spheres *s, uint32_t lane)
{
    switch (m->now) {
    case AT_START:
        m->a = answer(m, s, lane);
        m->length = 0.25 * (m->to - m->a.t);
        return ask_next(m, s, lane);
    case OF_STRETCH: return take_stretch(m, s, lane);
    case AT_END: return take_end(m, s, lane);
    case AT_FRONT: return take_front(m, s, lane);
    default: return take_between(m, s, lane);
    }
}

static void move_lane(march *m, common_spheres *s, uint32_t from, uint32_t to)
{
    m[to] = m[from];
    common_spheres_put(s, to, pov_vec3_of(s->x[from], s->y[from], s->z[from]), s->off[from]);
    s->square[to] = s->square[from];
    s->place[to] = s->place[from];
    s->left[to] = s->left[from];
    s->open[to] = s->open[from];
}

/* Rays of one fractal: as one is done the next takes its lane. */
static void intersect_some(const common_julia *j, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    march m[COMMON_SPHERES];
    common_spheres s;
    uint32_t next = 0, count = 0, i;

    for (;;) {
        for (; count < COMMON_SPHERES && next < n; next++)
            count += begin(&m[count], j, rays[next], hits[next], &s, count);
        if (count == 0)
            return;
        common_julia_follow(j, j->places, j->reach * j->reach, &s, count);
        for (i = count; i-- > 0;)
            if (!take(&m[i], &s, i) && i < --count)
                move_lane(m, &s, count, i);
    }
}

void common_julia_intersect(const void *self, const pov_ray *ray, pov_hits *hits) { intersect_some(self, &ray, &hits, 1); }

void common_julia_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    for (uint32_t i = 0, some; i < n; i += some) {
        for (some = 1; i + some < n && selves[i + some] == selves[i];)
            some++;
        intersect_some(selves[i], rays + i, hits + i, some);
    }
}
