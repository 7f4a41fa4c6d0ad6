/* The first crossing of one surface out of which hollows are cut, which may show: all crossings of the surface, and the ends of hollows by
 * their outline, from near to far. Where two of these are too close for that, csg_intersect.c has the rules. */
#include "world/csg_traversal.h"

enum { CROSSINGS = 8, EVENTS = CROSSINGS + 2 * CSG_FEW, SURFACE = CSG_FEW };

bool csg_is_hollowed(const csg_tree *t)
{
    return t->clipped.hollows == (1u << t->clipped.count) - 1 && !t->members[t->clipped.surface].patch;
}

/* A crossing of the surface, or about where an end of a hollow is: the hollow's number, or SURFACE. */
typedef struct event { double t; uint32_t of; const pov_crossing *crossing; } event;

typedef struct hollow_search {
    const csg_traversal *w;
    double off;                  /* ends are off by less */
    uint32_t holds;              /* the hollows that hold the ray before the next event, and the surface, as bits */
    uint32_t escalated, count;
    event at[EVENTS];            /* from near to far */
    pov_crossing crossings[CROSSINGS];
} hollow_search;

static const csg_member *member_of(const hollow_search *s, uint32_t of)
{
    const csg_tree *t = s->w->tree;

    return &t->members[of == SURFACE ? t->clipped.surface : t->clipped.clip[of]];
}

static uint32_t name_of(const hollow_search *s, const csg_member *m) { return s->w->scratch->names + m->leaf; }

/* All crossings ahead. False: there are too many, or one is where the ray starts. */
static bool ask(hollow_search *s, uint32_t of, const pov_hits *hits, pov_crossing *at, uint32_t *count)
{
    const csg_member *m = member_of(s, of);
    pov_hits found = { .tmax = HUGE_VAL, .want = POV_WANT_ALL, .at = at, .capacity = CROSSINGS, .grow = csg_no_more, .user = hits->user,
                       .scratch = hits->scratch, .unfiltered = hits->unfiltered, .owner = name_of(s, m) };
    bool known;

    csg_intersect_member(s->w, m, &found);
    s->escalated += found.escalated;
    *count = found.count;
    known = found.count < CROSSINGS;
    for (uint32_t i = 0; known && i < found.count; i++)
        known = at[i].t * s->w->dir > CSG_SEPARATION * s->w->size;
    return known;
}

static void insert(hollow_search *s, double t, uint32_t of, const pov_crossing *crossing)
{
    uint32_t i = s->count++;

    for (; i > 0 && t < s->at[i - 1].t; i--)
        s->at[i] = s->at[i - 1];
    s->at[i] = (event){ t, of, crossing };
}

static bool add_surface(hollow_search *s, const pov_hits *hits)
{
    uint32_t count;

    if (!ask(s, SURFACE, hits, s->crossings, &count))
        return false;
    for (uint32_t i = 0; i < count; i++)
        insert(s, s->crossings[i].t, SURFACE, &s->crossings[i]);
    s->holds |= (count & 1) << SURFACE;
    return true;
}

/* Of a ray that starts on the hollow's surface one end is the start. */
static bool add_hollow(hollow_search *s, uint32_t i, double in, double out)
{
    const bool enters = fabs(in) <= s->off, leaves = fabs(out) <= s->off;
    const bool starts_here = s->w->ray->origin_surface == name_of(s, member_of(s, i));

    if (in > out + s->off || out < -s->off)
        return !starts_here;
    if (in > out - s->off || (starts_here ? enters == leaves : enters || leaves))
        return false;
    if (in > s->off)
        insert(s, in, i, NULL);
    else if (!leaves)
        s->holds |= 1u << i;
    if (!leaves)
        insert(s, out, i, NULL);
    return true;
}

static void begin(hollow_search *s, const csg_traversal *w)
{
    s->w = w;
    s->holds = s->escalated = s->count = 0;
}

static bool is_solid(const hollow_search *s)
{
    return (s->holds >> SURFACE & 1) != member_of(s, SURFACE)->inverse && !(s->holds & ((1u << SURFACE) - 1));
}

/* The hollow's own crossing there, which is the only one: its other end is an event, too, and two that are so close are not looked at.
 * NULL: it is not certain that there is one. */
static const pov_crossing *find_end(hollow_search *s, const event *e, const pov_hits *hits)
{
    uint32_t count;

    if (!ask(s, e->of, hits, s->crossings, &count))
        return NULL;
    for (uint32_t i = 0; i < count; i++)
        if (fabs(s->crossings[i].t - e->t) <= s->off)
            return &s->crossings[i];
    return NULL;
}

static bool report(hollow_search *s, const event *e, pov_hits *hits)
{
    const csg_first about = { .t = e->t, .off = s->off };
    const pov_crossing end = { .t = e->t, .owner = name_of(s, member_of(s, e->of)) };
    const pov_crossing *at = e->crossing ? e->crossing : csg_first_is_enough(&about, hits) ? &end : find_end(s, e, hits);

    if (!at)
        return false;
    hits->escalated += s->escalated;
    csg_report(at, is_solid(s), hits);
    return true;
}

/* The first crossing, where all of the surface's are known, in hollows whose ends are off by less than `off`. False: open. */
static bool find_first(hollow_search *s, const double *in, const double *out, double off, pov_hits *hits)
{
    const double most = hits->tmax + hits->slack + off;

    s->off = off;
    for (uint32_t i = 0; i < s->w->tree->clipped.count; i++)
        if (!add_hollow(s, i, in[i], out[i]))
            return false;
    for (uint32_t i = 0; i < s->count && !(s->at[i].t > most); i++) {
        const event *e = &s->at[i];
        const bool before = is_solid(s);

        if (i + 1 < s->count && s->at[i + 1].t - e->t <= 2.0 * off)
            return false;
        s->holds ^= 1u << e->of;
        if (is_solid(s) != before && !csg_is_unseen(member_of(s, e->of)))
            return report(s, e, hits);
    }
    hits->escalated += s->escalated;
    return true;
}

bool csg_hollows_first(const csg_traversal *w, const double *in, const double *out, double off, pov_hits *hits)
{
    hollow_search s;

    begin(&s, w);
    return add_surface(&s, hits) && find_first(&s, in, out, off, hits);
}

/* Many rays that come near such a tree cross nothing of its surface, and so nothing else. */
bool csg_hollowed_first(const csg_traversal *w, pov_hits *hits)
{
    const csg_outline *of = w->tree->outline;
    hollow_search s;
    csg_intervals k;

    begin(&s, w);
    if (!add_surface(&s, hits))
        return false;
    if (s.count == 0 && !member_of(&s, SURFACE)->inverse) {
        hits->escalated += s.escalated;
        return true;
    }
    if (!csg_outline_common(of, w->tree->clipped.hollows, w->ray, &k))
        return false;
    for (uint32_t i = 1; i <= w->tree->clipped.count; i++) {
        k.in[i] = (k.in[i] - k.start) * k.per_unit;
        k.out[i] = (k.out[i] - k.start) * k.per_unit;
    }
    return find_first(&s, k.in + 1, k.out + 1, csg_margin(of, &k), hits);
}
