/* A ray's walk through a tree of shapes: all crossings of its members, from near to far, and where they change its value.
 *
 * docs/numerics.md ("Solids made of others") has the rules and derives the constants. */
#include "world/csg_traversal.h"

#include "base/simd.h"
#include "world/surface.h"

#include <string.h>

/* In the mark of a crossing of a member that clips. */
#define APPLIED 0x04000000u

/* Distance from a crossing at which inside() of open members is called: a fraction of the least of these, however large others are,
 * but more than the roundings of a place as far from the origin. */
static const double open_step = 0x1p-24, open_step_least = 0x1p-46;

static double cosine_at(const csg_traversal *w, const pov_crossing *at) { return fabs(csg_slope(w, at)); }

/* ---- places ---- */

/* Next to the start a fraction of the distance tells nothing. */
static bool shares_point(const csg_traversal *w, const pov_crossing *first, const pov_crossing *next)
{
    const double between = (next->t - first->t) + (next->t_lo - first->t_lo);
    double a, b;

    if (between > CSG_SEPARATION * fabs(first->t) && first->t * w->dir > CSG_SEPARATION * w->size)
        return false;
    a = cosine_at(w, first);
    b = cosine_at(w, next);
    return !(between * a * b > CSG_SAME_POINT * (w->size + fabs(first->t) * w->dir) * (a + b));
}

static uint32_t end_of_point(const csg_traversal *w, uint32_t first)
{
    const pov_crossing *at = w->found.at;
    uint32_t end = first + 1;

    while (end < w->found.count && shares_point(w, &at[first], &at[end]))
        end++;
    return end;
}

/* Is the member of a crossing entered or left by the coincident crossings as a whole? */
static bool is_changed(const csg_traversal *w, uint32_t which, uint32_t first, uint32_t end)
{
    const pov_crossing *at = w->found.at;
    uint32_t times = 0;

    for (uint32_t i = first; i < end; i++)
        times += at[i].owner == at[which].owner;
    return times & 1;
}

/* Do the nodes above a member change by the coincident crossings, all up to the root? */
static bool is_passed_on(const csg_traversal *w, const csg_member *m)
{
    const csg_scratch *s = w->scratch;
    uint32_t node = m->node;

    while (node != 0 && s->states[node].value != s->before[node].value)
        node = w->tree->nodes[node].parent;
    return node == 0;
}

/* The coincident crossing whose surface is reported: of the members that are entered or left like the solid and whose change is
 * passed on to it, the earliest in the text. */
static const pov_crossing *owner_of(const csg_traversal *w, uint32_t first, uint32_t end, bool enters)
{
    const pov_crossing *at = w->found.at, *best = NULL, *other = NULL;

    for (uint32_t i = first; i < end; i++) {
        const csg_member *m = csg_member_at(w, &at[i]);
        const bool entered = w->scratch->inside[m - w->tree->members];

        if (m->hidden || m->patch)
            continue;
        other = other ? other : &at[i];
        if ((entered != m->turned) == enters && (!best || at[i].owner < best->owner) && is_changed(w, i, first, end) &&
            (end == first + 1 || is_passed_on(w, m)))
            best = &at[i];
    }
    return best ? best : other;
}

bool csg_no_more(pov_hits *hits)
{
    (void)hits;
    return false;
}

bool csg_report(const pov_crossing *at, bool enters, pov_hits *hits)
{
    const uint32_t owner = hits->owner;
    pov_mark mark = at->mark;
    bool more;

    mark.flags &= ~(POV_MARK_OUTWARD | POV_MARK_INWARD | POV_MARK_CLOSED);   /* they describe the member */
    mark.flags |= enters ? CSG_MARK_ENTERS : 0;
    hits->owner = at->owner;
    more = pov_cross(hits, at->t, at->t_lo, mark);
    hits->owner = owner;
    return more;
}

/* Are these two crossings too close for doubles? */
static bool is_close(const csg_traversal *w, uint32_t i)
{
    const pov_crossing *at = w->found.at;

    return i + 1 < w->found.count && at[i + 1].t - at[i].t <= CSG_SEPARATION * fabs(at[i + 1].t);
}

/* ---- coincident crossings ---- */

static uint32_t which_of(const csg_traversal *w, const pov_crossing *at) { return csg_which(w, at->owner); }

enum { CLOSE_MAX = 4 };

/* Pass the next crossings, which are too close for doubles, where their order does not matter: with any of their members entered
 * or left the tree's value is the same. False: it may matter; or open members, which are asked beside each crossing, may be entered. */
static bool pass_close(csg_traversal *w)
{
    const uint32_t first = w->applied;
    const int32_t value = w->scratch->states[0].value;
    uint32_t count = 1;
    bool same = true;

    while (count < CLOSE_MAX && is_close(w, first + count - 1))
        count++;
    same = w->tree->open_count == 0 && !is_close(w, first + count - 1);
    for (uint32_t i = first; i < first + count; i++)
        same = same && !csg_member_at(w, &w->found.at[i])->patch;
    if (!same)
        return false;
    /* In the order of a Gray code, which ends with the last one alone. */
    for (uint32_t i = 1; i < 1u << count; i++) {
        csg_toggle(w, which_of(w, &w->found.at[first + first_of(i)]));
        same = same && w->scratch->states[0].value == value;
    }
    for (uint32_t i = first; i + 1 < first + count; i++)
        csg_toggle(w, which_of(w, &w->found.at[i]));
    w->applied = first + count;
    return same;
}

/* Apply members that clip: before the others those that uncover surfaces, after them those that cover. So a surface that
 * coincides with the clip's is visible. */
static void clip(csg_traversal *w, uint32_t first, uint32_t end, bool enters)
{
    for (uint32_t i = first; i < end; i++) {
        pov_crossing *at = &w->found.at[i];
        const csg_member *m = csg_member_at(w, at);

        if (!m->hidden || m->patch || m->open || at->mark.flags & APPLIED ||
            ((w->scratch->inside[which_of(w, at)] == m->turned) != enters && enters))
            continue;
        at->mark.flags |= APPLIED;
        csg_toggle(w, which_of(w, at));
    }
}

static void apply(csg_traversal *w, uint32_t first, uint32_t end)
{
    for (uint32_t i = first; i < end; i++) {
        const csg_member *m = csg_member_at(w, &w->found.at[i]);

        if (!m->hidden && !m->patch && !m->open)
            csg_toggle(w, which_of(w, &w->found.at[i]));
    }
}

double csg_open_step(const csg_traversal *w, double t, double before, double after)
{
    const double size = w->tree->open_size > 0.0 ? w->tree->open_size : w->size;
    double step = open_step * size + open_step_least * (pov_largest(w->ray->org) + w->dir * fabs(t));

    step = w->dir > 0.0 ? step / w->dir : 0.0;
    return pov_min(pov_min(step, 0.5 * before), 0.5 * after);
}

static double step_at(const csg_traversal *w, uint32_t first, uint32_t end)
{
    const pov_crossing *at = w->found.at;

    return csg_open_step(w, at[first].t, at[first].t - (first > 0 ? at[first - 1].t : 0.0),
                         end < w->found.count ? at[end].t - at[end - 1].t : HUGE_VAL);
}

/* Enter or leave open members by their inside() at a point of the ray: a ray may enter them without a crossing. */
static void update_open(csg_traversal *w, double t, bool behind)
{
    for (uint32_t i = 0; w->tree->open_count > 0 && i < w->asked_count; i++) {
        const uint32_t member = w->scratch->asked[i];
        const csg_member *m = &w->tree->members[member];

        if (m->open && csg_member_holds(w, m, t) != w->scratch->inside[member]) {
            csg_toggle(w, member);
            w->grazes = w->grazes || (behind && m->hidden && !w->whole);
        }
    }
}

/* The earliest patch whose entry would change the tree's value. NULL: none. */
static const pov_crossing *find_patch(csg_traversal *w, uint32_t first, uint32_t end)
{
    const pov_crossing *at = w->found.at, *best = NULL;

    for (uint32_t i = first; i < end; i++) {
        const int32_t before = w->scratch->states[0].value;
        bool changes;

        if (!csg_member_at(w, &at[i])->patch || csg_member_at(w, &at[i])->hidden)
            continue;
        csg_toggle(w, which_of(w, &at[i]));
        changes = w->scratch->states[0].value != before;
        csg_toggle(w, which_of(w, &at[i]));
        if (changes && (!best || at[i].owner < best->owner))
            best = &at[i];
    }
    return best;
}

/* Apply the next coincident crossings, and report a crossing if the tree's value changes. False: nothing more is
 * wanted. */
static bool pass_point(csg_traversal *w, pov_hits *hits)
{
    const csg_state *root = &w->scratch->states[0];
    const uint32_t first = w->applied, end = w->applied = end_of_point(w, first);
    const double step = w->tree->open_count > 0 ? step_at(w, first, end) : 0.0;
    const pov_crossing *at;
    bool enters;
    int32_t before;

    update_open(w, w->found.at[first].t - step, false);
    clip(w, first, end, true);
    before = root->value;
    if (end > first + 1)
        memcpy(w->scratch->before, w->scratch->states, w->tree->node_count * sizeof *w->scratch->before);
    apply(w, first, end);
    update_open(w, w->found.at[end - 1].t + step, true);
    if (w->grazes)
        return false;
    enters = root->value > before;
    at = root->value != before ? owner_of(w, first, end, enters) : find_patch(w, first, end);
    clip(w, first, end, false);
    if (!at || at->t < w->enter || csg_member_at(w, at)->clear)
        return true;
    if (csg_member_at(w, at)->patch)
        enters = (csg_slope(w, at) < 0.0) != csg_member_at(w, at)->turned;
    return csg_report(at, enters, hits) && !(hits->want == POV_WANT_NEAREST && at->t > hits->tmin);
}

/* The next point, or several that doubles need not tell apart. False: they are not sufficient; `*more`: more is wanted. */
static bool pass_next(csg_traversal *w, pov_hits *hits, bool exact, bool *more)
{
    if (!exact && is_close(w, w->applied))
        return pass_close(w);
    *more = pass_point(w, hits);
    return true;
}

bool csg_pass(csg_traversal *w, pov_hits *hits, bool exact, bool *more)
{
    while (*more && w->applied < w->found.count)
        if (!pass_next(w, hits, exact, more))
            return false;
    return true;
}

/* False: doubles were not sufficient. Crossings reported so far are right. */
static bool traverse_once(csg_traversal *w, pov_hits *hits, bool exact)
{
    const double last = pov_min(hits->tmax + hits->slack, w->leave);
    bool enough = true, more = true;

    csg_traversal_begin(w, hits, exact);
    while (enough && more) {
        csg_test_ahead(w);
        enough = w->missed || !w->unsure;
        if (!enough || w->missed || w->scratch->failed || w->applied == w->found.count || w->found.at[w->applied].t > last)
            break;
        enough = pass_next(w, hits, exact, &more);
    }
    csg_traversal_end(w);
    hits->escalated += w->found.escalated;
    return enough;
}

/* Where a clip with gaps is left or entered in the very place where something else is crossed, the order of both counts. */
static bool traverse(csg_traversal *w, pov_hits *hits, bool exact)
{
    const uint32_t count = hits->count;
    bool enough;

    w->whole = false;
    enough = traverse_once(w, hits, exact);
    if (!w->grazes)
        return enough;
    if (hits->want == POV_WANT_ALL)
        hits->count = count;   /* the traversal begins again */
    w->whole = true;
    return traverse_once(w, hits, exact);
}

static bool wants_first(const pov_hits *hits) { return !hits->always_exact && hits->tmin == 0.0 && hits->want != POV_WANT_ALL; }

/* What is wanted, by outlines. False: these cannot tell, or the tree is another one. */
static bool find_by_outline(csg_traversal *w, pov_hits *hits)
{
    const csg_tree *t = w->tree;

    if (hits->unfiltered)
        return false;
    if (t->chords.all && t->open_count == 0 && wants_first(hits))
        return csg_chords_first(w, hits) || (t->outline && csg_sweep(w, hits, true));
    return (t->outline && !t->clipped.outlined && csg_sweep(w, hits, hits->always_exact)) ||
           (t->clipped.count > 0 && wants_first(hits) && csg_clipped_first(w, hits));
}

/* A ray that starts on several surfaces leaves one of the tree's by name; others of the tree are behind it by their distance. */
static const pov_ray *name_start(const csg_tree *t, const csg_scratch *s, const pov_ray *ray, pov_ray *named)
{
    for (uint32_t i = 0; s->from && i < s->from->count; i++) {
        const hit *at = &s->from->at[i];

        if (at->object - s->names - t->members[0].leaf >= t->member_count)
            continue;
        *named = *ray;
        named->origin_surface = at->object;
        named->origin_mark = at->crossing.mark;
        return named;
    }
    return ray;
}

void csg_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const csg_tree *t = ((const csg_root *)self)->tree;
    const uint32_t count = hits->count;
    csg_traversal w;
    pov_ray named;

    csg_traversal_init(&w, t, name_start(t, ((const csg_user *)hits->user)->scratch, ray, &named), hits);
    if (find_by_outline(&w, hits))
        return;
    hits->count = count;
    if (!csg_traversal_enters(&w, hits) || traverse(&w, hits, hits->always_exact))
        return;
    if (hits->want == POV_WANT_ALL)
        hits->count = count;   /* the traversal begins again */
    hits->escalated++;
    traverse(&w, hits, true);
}

/* How many of n rays a clipped surface takes together, from the first one on. */
static uint32_t count_together(const void *const *selves, pov_hits *const *hits, uint32_t n)
{
    const csg_tree *t = ((const csg_root *)selves[0])->tree;
    uint32_t some = 0;

    if (!t->clipped.outlined || t->chords.all || !t->members[t->clipped.surface].shape->intersect_between_many)
        return 0;
    while (some < n && some < CSG_CLIPPED_MANY && selves[some] == selves[0] && wants_first(hits[some]))
        some++;
    return some;
}

void csg_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    for (uint32_t some; n > 0; n -= some, selves += some, rays += some, hits += some) {
        uint32_t open = 1;

        some = count_together(selves, hits, n);
        if (some > 1)
            open = csg_clipped_many(((const csg_root *)selves[0])->tree, rays, hits, some);
        else
            some = 1;
        for (; open; open &= open - 1)
            csg_intersect(selves[0], rays[first_of(open)], hits[first_of(open)]);
    }
}
