/* Rays' ways through a julia_fractal: long stretches where they are clear, short ones near the surface. What a ray asks next depends on the
 * last answer, so several rays go on side by side, each with its own question. */
#include "common/julia.h"

#include "common/clip.h"
#include "common/lanes.h"

enum { LANES = COMMON_PROBES, ALL = (1 << LANES) - 1 };

/* The question that is open, but for a stretch: the point at the ray's start; a stretch's end, and its start again; a place between
 * these; a place of a stretch that crosses once at most. */
typedef enum question { AT_START, AT_END, AT_FRONT, BETWEEN, OF_ONE } question;

/* Above 0: outside. */
typedef struct sample { double t, value; uint32_t place; } sample;

typedef struct track {
    pov_hits *hits;
    double base, rate, unit;     /* numbers change by `rate` t */
    double near, side;           /* up to there the value is that of the start: rounding decides nothing */
    question now;
    double t;                    /* of the question */
    sample low, high;            /* around its crossing */
    bool ends;                   /* `high` is behind the crossing, for certain */
    double from, until, least;   /* values that count there; where it is known well enough */
    uint32_t turn;
} track;

/* Stretches that are looked at, `from` to `end` of points at o + t d; shorter ones than `shortest` are not divided, beyond `enough`
 * nothing is wanted. All bits or none: `from` is outside; a stretch is the question. */
typedef struct stretches {
    double from[LANES], end[LANES], length[LANES], to[LANES], enough[LANES], shortest[LANES], o[3][LANES], d[3][LANES];
    int64_t out[LANES], asked[LANES];
} stretches;

typedef struct search {
    const common_julia *j;
    uint32_t count;
    common_probes probes;
    stretches s;
    track at[LANES];
} search;

static pov_vec3 get(double v[3][LANES], uint32_t l) { return pov_vec3_of(v[0][l], v[1][l], v[2][l]); }

static void put(double v[3][LANES], uint32_t l, pov_vec3 a)
{
    v[0][l] = a.x;
    v[1][l] = a.y;
    v[2][l] = a.z;
}

/* ---- points ---- */

static bool is_out(sample a) { return a.value > 0.0; }

/* `step`: what slopes are for. */
static void ask(search *x, uint32_t l, question now, double t, double step)
{
    const pov_vec3 d = get(x->s.d, l);

    x->at[l].now = now;
    x->at[l].t = t;
    x->s.asked[l] = 0;
    common_probe_put(&x->probes, l, pov_add(get(x->s.o, l), pov_scale(d, t)), pov_scale(d, step), 0.0, false);
}

static sample answer(const search *x, uint32_t l)
{
    const track *r = &x->at[l];
    sample a = { r->t, r->side, 0 };

    if (r->t < r->near)
        return a;
    a.value = x->probes.square[l] - x->j->reach * x->j->reach;
    a.value = a.value == a.value ? a.value : HUGE_VAL;
    a.place = (uint32_t)x->probes.place[l];
    return a;
}

/* ---- stretches ---- */

/* Where stretches end does not depend on what is wanted, so that crossings keep their bits whatever else is in the scene. */
COMMON_INLINE double end_of(double from, double length, double shortest, double to)
{
    const double next = from + (length > shortest ? length : shortest);

    return next < to ? next : to;
}

/* The last lane first. */
static const int64_t bit_of[LANES] = { 32768, 16384, 8192, 4096, 2048, 1024, 512, 256, 128, 64, 32, 16, 8, 4, 2, 1 };

/* Goes on behind stretches that are clear, and divides those that may not be. Which of the lanes it did so for, as bits from the last
 * lane on, and above these which of them ask for a stretch again; what is left of the others keeps as it was. */
COMMON_CLONES static uint32_t take_stretches(const common_julia *restrict j, stretches *restrict s, common_probes *restrict p)
{
    int64_t bits = 0;

    for (uint32_t l = 0; l < LANES; l++) {
        const int64_t asked = s->asked[l], out = s->out[l], left = p->left[l], open = left & p->open[l];
        const int64_t clear = asked & ((out & ~left) | (~out & left & ~open)), on = clear | (asked & open & ~p->sure[l]);
        const double shortest = s->shortest[l], before = s->length[l], least = before > shortest ? before : shortest;
        const double from = clear ? s->end[l] : s->from[l], length = clear ? j->grow * least : j->shrink * before;
        const double end = end_of(from, length, shortest, s->to[l]), middle = 0.5 * (from + end), half = 0.5 * (end - from);
        const int64_t more = from < s->to[l] ? on : 0, wanted = from <= s->enough[l] ? more : 0;

        bits |= bit_of[l] & on;
        bits |= bit_of[l] << LANES & (length > shortest ? wanted : 0);
        s->from[l] = from;
        s->length[l] = on ? length : before;
        s->end[l] = on ? end : s->end[l];
        for (int k = 0; k < 3; k++) {
            p->p[k][l] = on ? s->o[k][l] + s->d[k][l] * middle : p->p[k][l];
            p->d[k][l] = on ? s->d[k][l] * half : p->d[k][l];
        }
    }
    return (uint32_t)bits;
}

static bool ask_next(search *x, uint32_t l)
{
    stretches *s = &x->s;
    const double from = s->from[l], end = end_of(from, s->length[l], s->shortest[l], s->to[l]);
    const pov_vec3 d = get(s->d, l);

    if (!(from < s->to[l] && from <= s->enough[l]))
        return false;
    s->end[l] = end;
    if (s->length[l] > s->shortest[l]) {
        s->asked[l] = -1;
        common_probe_put(&x->probes, l, pov_add(get(s->o, l), pov_scale(d, 0.5 * (from + end))), pov_scale(d, 0.5 * (end - from)), 0.0, true);
    } else {
        ask(x, l, AT_END, end, 0.0);
    }
    return true;
}

/* Behind a stretch, at whose end the ray is outside or not. */
static bool go_on(search *x, uint32_t l, bool out)
{
    stretches *s = &x->s;

    s->from[l] = s->end[l];
    s->length[l] = x->j->grow * (s->length[l] > s->shortest[l] ? s->length[l] : s->shortest[l]);
    s->out[l] = -(int64_t)out;
    return ask_next(x, l);
}

/* It is crossed once at most. */
static bool take_sure(search *x, uint32_t l)
{
    const double from = x->s.from[l], end = x->s.end[l], half = 0.5 * (end - from), slope = x->probes.slope[l];
    const double t = 0.5 * (from + end) + half * (x->j->reach * x->j->reach - x->probes.square[l]) / slope;
    const bool out = x->s.out[l] != 0;
    track *r = &x->at[l];

    if (out == (slope > 0.0))
        return go_on(x, l, out);
    r->low.t = from;
    r->high.t = end;
    r->ends = false;
    r->turn = 0;
    ask(x, l, OF_ONE, t > from && t < end ? t : end, half);
    return true;
}

/* Where it is clear, but not as its start was said to be, that is not true. */
static bool take_stretch(search *x, uint32_t l)
{
    const common_side side = common_probe_side(&x->probes, l);
    const bool out = x->s.out[l] != 0;

    if (side == COMMON_OPEN && x->probes.sure[l])
        return take_sure(x, l);
    if (side == COMMON_OPEN) {
        x->s.length[l] *= x->j->shrink;
        return ask_next(x, l);
    }
    if ((side == COMMON_OUT) == out)
        return go_on(x, l, out);
    ask(x, l, AT_END, x->s.end[l], 0.0);
    return true;
}

static bool take_end(search *x, uint32_t l)
{
    const sample end = answer(x, l);

    if (is_out(end) == (x->s.out[l] != 0))
        return go_on(x, l, is_out(end));
    x->at[l].high = end;
    ask(x, l, AT_FRONT, x->s.from[l], 0.0);
    return true;
}

/* ---- crossings ---- */

/* False: nothing more is wanted. */
static bool report(const search *x, uint32_t l, double at, uint32_t place)
{
    const track *r = &x->at[l];
    const pov_two t = pov_two_sum(r->base, at);
    const pov_mark mark = { place, 0, 0.0, 0.0 };

    return pov_cross(r->hits, t.hi * r->unit, t.lo * r->unit, mark) && !(r->hits->want == POV_WANT_NEAREST && t.hi * r->unit > r->hits->tmin);
}

/* What is left of the value that stays, where the other one becomes `next` from `before` (Anderson and Bjorck). */
static double weight(double next, double before)
{
    const double rest = 1.0 - next / before;

    return rest > 0.0 ? rest : 0.5;
}

/* Each guess goes a little beyond the root, so that both sides come near. */
static bool ask_between(search *x, uint32_t l)
{
    track *r = &x->at[l];
    const double low = r->low.t, high = r->high.t, share = r->from / (r->from - r->until);
    double guess;

    r->least = 0x1p-50 * (fabs(low) + x->j->reach / r->rate);
    guess = low + share * (high - low) + (share < 0.5 ? 0.5 : -0.5) * r->least;
    ask(x, l, BETWEEN, r->turn++ % 8 < 7 && guess > low && guess < high ? guess : 0.5 * (low + high), 0.0);
    return true;
}

static bool take_front(search *x, uint32_t l)
{
    track *r = &x->at[l];

    r->low = answer(x, l);
    r->from = r->low.value;
    r->until = r->high.value;
    r->turn = 0;
    return ask_between(x, l);
}

/* Between two points on different sides; a place beyond the last is none. The side whose value has stayed counts for less the next
 * time. */
static bool take_between(search *x, uint32_t l)
{
    static const uint32_t TURNS = 200;
    track *r = &x->at[l];
    const sample c = answer(x, l);
    const bool is_within = c.t > r->low.t && c.t < r->high.t, is_low = is_out(c) == is_out(r->low);

    if (is_within && is_low) {
        r->until *= weight(c.value, r->from);
        r->low = c;
        r->from = c.value;
    } else if (is_within) {
        r->from *= weight(c.value, r->until);
        r->high = c;
        r->until = c.value;
    }
    if (is_within && r->high.t - r->low.t > r->least && r->turn < TURNS)
        return ask_between(x, l);
    return report(x, l, is_out(r->low) ? r->low.t : r->high.t, is_out(r->low) ? r->low.place : r->high.place) &&
           go_on(x, l, x->s.out[l] == 0);
}

/* Newton's method between two points; a step below SMALL of the stretch leaves an error of its square. */
static bool take_one(search *x, uint32_t l)
{
    static const double SMALL = 0x1p-26;
    static const uint32_t TURNS = 100;
    track *r = &x->at[l];
    const double length = x->s.end[l] - x->s.from[l];
    const sample c = answer(x, l);
    const double next = c.t - 0.5 * length * c.value / x->probes.slope[l];
    const bool out = x->s.out[l] != 0, is_low = is_out(c) == out, is_near = c.t < r->near;
    double t = 0.5 * (r->low.t + r->high.t);

    if (is_low && c.t >= x->s.end[l])
        return go_on(x, l, out);
    *(is_low ? &r->low.t : &r->high.t) = c.t;
    r->ends = r->ends || !is_low;
    if (!is_near && next >= r->low.t && next <= r->high.t)
        t = next;
    else if (!is_near && next > r->high.t && !r->ends)
        t = r->high.t;
    if ((t == next && fabs(t - c.t) <= SMALL * length) || r->turn++ > TURNS)
        return report(x, l, t, x->j->places - 1) && go_on(x, l, !out);
    ask(x, l, OF_ONE, t, 0.5 * length);
    return true;
}

/* ---- rays ---- */

/* A ray that starts on the surface: on which side it goes on. */
static double side_ahead(const common_julia *j, const pov_ray *ray, pov_vec3 o, pov_vec3 d)
{
    const uint32_t flags = ray->origin_mark.flags;

    if (flags & (POV_MARK_OUTWARD | POV_MARK_INWARD))
        return flags & POV_MARK_OUTWARD ? 0x1p-1000 : 0.0;
    return pov_dot(common_julia_slope(j, o, ray->origin_mark.feature), d) >= 0.0 ? 0x1p-1000 : 0.0;
}

/* Of the number, for a step of length 1 along the ray. */
static double rate_of(const common_julia *j, pov_vec3 d)
{
    const double *n = j->slice.v, last = (n[0] * d.x + n[1] * d.y + n[2] * d.z) / n[3];

    return sqrt(pov_dot(d, d) + last * last);
}

/* Into the next lane. What comes from outside the box is outside. */
static void begin(search *x, const pov_ray *ray, pov_hits *hits)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    const bool from_here = ray->origin_surface == hits->owner;
    const uint32_t l = x->count;
    track *r = &x->at[l];
    stretches *s = &x->s;
    common_span span;

    if (!common_clip(&k, x->j->box.lo, x->j->box.hi, &span) || span.hi <= 0.0 || span.lo * k.unit > hits->tmax)
        return;
    r->hits = hits;
    r->base = span.lo > 0.0 ? span.lo : 0.0;
    r->rate = rate_of(x->j, k.d);
    r->unit = k.unit;
    put(s->o, l, common_along(&k, r->base));
    put(s->d, l, k.d);
    r->near = from_here ? 0x1p-26 * x->j->reach / r->rate : 0.0;
    r->side = from_here ? side_ahead(x->j, ray, get(s->o, l), k.d) : 0.0;
    s->from[l] = 0.0;
    s->to[l] = span.hi - r->base;
    s->enough[l] = hits->tmax * k.per_unit * (1.0 + 0x1p-20) - r->base;
    s->shortest[l] = x->j->shortest / r->rate;
    s->length[l] = x->j->first * s->to[l];
    s->out[l] = -1;
    if (from_here)
        s->out[l] = -(int64_t)(r->side > 0.0);
    if (span.lo > 0.0 || from_here) {
        x->count += ask_next(x, l);
    } else {
        ask(x, l, AT_START, 0.0, 0.0);
        x->count++;
    }
}

/* The answer, and the next question. False: the ray is done. */
static bool take(search *x, uint32_t l)
{
    if (x->s.asked[l])
        return take_stretch(x, l);
    switch (x->at[l].now) {
    case AT_START:
        x->s.out[l] = -(int64_t)is_out(answer(x, l));
        return ask_next(x, l);
    case AT_END: return take_end(x, l);
    case AT_FRONT: return take_front(x, l);
    case BETWEEN: return take_between(x, l);
    default: return take_one(x, l);
    }
}

static void move_lane(search *x, uint32_t from, uint32_t to)
{
    stretches *s = &x->s;
    common_probes *p = &x->probes;

    x->at[to] = x->at[from];
    s->from[to] = s->from[from];
    s->end[to] = s->end[from];
    s->length[to] = s->length[from];
    s->to[to] = s->to[from];
    s->enough[to] = s->enough[from];
    s->shortest[to] = s->shortest[from];
    s->out[to] = s->out[from];
    s->asked[to] = s->asked[from];
    put(s->o, to, get(s->o, from));
    put(s->d, to, get(s->d, from));
    common_probe_put(p, to, get(p->p, from), get(p->d, from), p->off[from], p->wide[from] != 0);
}

/* ---- a ray that is alone ---- */

/* Its next stretches fill the lanes beside it: of a stretch in lane l, what follows where it is clear is in lane 2 l + 1, and what follows
 * where it is open in lane 2 l + 2. */
enum { AHEAD = 7 };

/* Functions other than squares and cubes are followed one by one. */
static bool looks_ahead(const search *x) { return x->count == 1 && x->s.asked[0] && (!x->j->f || x->j->squares); }

static void ask_ahead(search *x)
{
    stretches *s = &x->s;
    const double shortest = s->shortest[0], to = s->to[0];
    const pov_vec3 o = get(s->o, 0), d = get(s->d, 0);

    for (uint32_t l = 1; l < AHEAD; l++) {
        const uint32_t before = (l - 1) / 2;
        const bool clear = l % 2 == 1;
        const double length = s->length[before], from = clear ? s->end[before] : s->from[before];

        s->from[l] = from;
        s->length[l] = clear ? x->j->grow * (length > shortest ? length : shortest) : x->j->shrink * length;
        s->end[l] = end_of(from, s->length[l], shortest, to);
        common_probe_put(&x->probes, l, pov_add(o, pov_scale(d, 0.5 * (from + s->end[l]))), pov_scale(d, 0.5 * (s->end[l] - from)), 0.0,
                         true);
    }
}

/* Takes answers as long as the next question is among those that have been asked. */
static bool take_ahead(search *x)
{
    stretches *s = &x->s;
    common_probes *p = &x->probes;

    for (uint32_t l = 0;;) {
        const double from = s->from[0];

        if (!take(x, 0))
            return false;
        l = 2 * l + (s->from[0] == from ? 2 : 1);
        if (!s->asked[0] || l >= AHEAD || s->from[l] != s->from[0] || s->length[l] != s->length[0])
            return true;
        p->square[0] = p->square[l];
        p->slope[0] = p->slope[l];
        p->left[0] = p->left[l];
        p->open[0] = p->open[l];
        p->sure[0] = p->sure[l];
    }
}

/* All rays: as one is done the next takes its lane. */
static void intersect_some(const common_julia *j, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    uint32_t next = 0;
    search x;

    x.j = j;
    x.count = 0;
    for (;;) {
        uint32_t bits;

        while (x.count < LANES && next < n) {
            begin(&x, rays[next], hits[next]);
            next++;
        }
        if (x.count == 0)
            return;
        if (looks_ahead(&x)) {
            ask_ahead(&x);
            common_julia_follow(j, j->places, j->reach, &x.probes, AHEAD);
            x.count = take_ahead(&x);
            continue;
        }
        common_julia_follow(j, j->places, j->reach, &x.probes, x.count);
        bits = x.count < COMMON_LEAST ? 0 : take_stretches(j, &x.s, &x.probes);
        for (uint32_t other = ALL << (LANES - x.count) & ~(bits >> LANES) & ALL; other; other &= other - 1) {
            const uint32_t l = LANES - 1 - common_first_lane(other);

            if (!(bits & bit_of[l] ? ask_next(&x, l) : take(&x, l)) && l < --x.count)
                move_lane(&x, x.count, l);
        }
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
