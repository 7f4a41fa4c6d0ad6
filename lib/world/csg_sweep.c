/* The first crossing of a tree of few members, whatever its nodes are, from their outlines: its members' crossings in order, about,
 * and the value of the tree behind each. Where crossings are too close to be told apart and it matters, and where more than the
 * first is wanted, csg_intersect.c has the rules. docs/numerics.md ("Outlines") derives the constants. */
#include "base/simd.h"
#include "world/csg_traversal.h"

#include <string.h>

static const double margin = CSG_OUTLINE_MARGIN;

typedef struct crossing { double at; uint32_t column; } crossing;

typedef struct sweep {
    csg_traversal *w;
    const csg_outline *of;
    csg_intervals io;
    double from, to;             /* the stretch of the ray, in the outline's units, that the tree's box holds */
    uint32_t holds;              /* columns that hold the ray before the next crossing, as bits */
    uint32_t entered;            /* those by which the states of nodes are, where there is no table of values */
    bool exact;                  /* crossings are to be found in double-double */
    uint32_t escalated;
    uint32_t count;
    crossing at[2 * CSG_COLUMNS];   /* of members, within the stretch, from near to far */
} sweep;

/* Crossings nearer than that to a place cannot be told from it. */
static double near_by(const sweep *s, double at) { return margin * (s->of->endless ? s->io.from + fabs(at) : 1.0); }

/* ---- one member ---- */

enum { CROSSINGS = 4 };
typedef struct asked { pov_crossing at[CROSSINGS]; pov_hits found; } asked;

static const csg_member *member_of(const sweep *s, uint32_t column)
{
    return &s->w->tree->members[s->of->member[column]];
}

/* False: it has more crossings ahead than any member. */
static bool ask(sweep *s, uint32_t column, const pov_hits *hits, asked *out)
{
    const csg_member *m = member_of(s, column);
    const pov_hits found = { .tmax = HUGE_VAL, .want = POV_WANT_ALL, .at = out->at, .capacity = CROSSINGS, .grow = csg_no_more,
                             .user = hits->user, .scratch = hits->scratch, .always_exact = s->exact, .unfiltered = hits->unfiltered,
                             .owner = s->w->scratch->names + m->leaf };

    out->found = found;
    csg_intersect_member(s->w, m, &out->found);
    s->escalated += out->found.escalated;
    return out->found.count < CROSSINGS;
}

/* Is a crossing so near to the start that doubles do not tell whether it is there? */
static bool is_at_start(const sweep *s, const pov_crossing *at) { return at->t * s->w->dir <= CSG_SEPARATION * s->w->size; }

/* Does the ray certainly start on the member, or beyond it, and cross it nowhere near? */
static bool is_passed(sweep *s, uint32_t column, const pov_hits *hits)
{
    asked a;
    uint32_t i = 0;

    if (!ask(s, column, hits, &a))
        return false;
    while (i < a.found.count && !is_at_start(s, &a.at[i]))
        i++;
    if (i < a.found.count && !s->exact) {
        s->exact = true;
        return is_passed(s, column, hits);
    }
    for (i = 0; i < a.found.count; i++)
        if (!csg_is_behind(s->w, &a.at[i]) && a.at[i].t < 4.0 * near_by(s, s->io.start) * s->io.per_unit)
            return false;
    return true;
}

/* The member's own crossing that lies there. NULL: it is not certain that there is one. */
static const pov_crossing *find_own(sweep *s, const csg_first *f, const pov_hits *hits, asked *a)
{
    const pov_crossing *found = NULL;

    if (!ask(s, f->column, hits, a))
        return NULL;
    for (uint32_t i = 0; i < a->found.count; i++) {
        const bool there = fabs(a->at[i].t - f->t) <= f->off;

        if (is_at_start(s, &a->at[i]) && s->exact && csg_is_behind(s->w, &a->at[i]))
            continue;
        if (is_at_start(s, &a->at[i]) || (there && found))
            return NULL;
        found = there ? &a->at[i] : found;
    }
    return found;
}

/* ---- crossings in order ---- */

static void insert(sweep *s, double at, uint32_t column)
{
    uint32_t i = s->count++;

    for (; i > 0 && at < s->at[i - 1].at; i--)
        s->at[i] = s->at[i - 1];
    s->at[i] = (crossing){ at, column };
}

static void add(sweep *s, double at, uint32_t column, bool passed)
{
    if (passed || at < s->from)
        s->holds ^= 1u << column;
    else if (at <= s->to && at < HUGE_VAL)
        insert(s, at, column);
}

/* `from`: the column that the ray starts on, one of whose crossings is the start. False: open. */
static bool add_column(sweep *s, uint32_t i, uint32_t from, const pov_hits *hits)
{
    const double in = s->io.in[i], out = s->io.out[i], start = s->io.start, near = near_by(s, start);
    const bool enters = fabs(in - start) <= near, leaves = fabs(out - start) <= near;

    if (in == HUGE_VAL || in - out > near_by(s, in))
        return i != from;
    if (i == from ? enters == leaves : (enters || leaves) && start + near >= s->from && !is_passed(s, i, hits))
        return false;
    add(s, in, i, in < start || enters);
    add(s, out, i, out < start || leaves);
    return true;
}

/* Is the ray certainly never within all columns that the tree is within? `from`: the column that it starts on. */
static bool is_nowhere(const sweep *s, uint32_t from)
{
    double enter = -HUGE_VAL, leave = HUGE_VAL;

    for (uint32_t left = s->of->within & ~s->io.outside; left; left &= left - 1) {
        const uint32_t i = first_of(left);

        if (i == from)
            continue;
        enter = s->io.in[i] > enter ? s->io.in[i] : enter;
        leave = s->io.out[i] < leave ? s->io.out[i] : leave;
    }
    return enter - near_by(s, enter) > pov_min(leave + near_by(s, leave), s->to) || leave + near_by(s, leave) < s->from;
}

static bool begin(sweep *s, uint32_t from, const pov_hits *hits)
{
    s->holds = s->io.outside;
    s->count = 0;
    for (uint32_t i = 0; i < s->of->count; i++)
        if (!add_column(s, i, from, hits))
            return false;
    return true;
}

/* ---- the tree's value ---- */

static void flip(sweep *s, uint32_t columns)
{
    const csg_tree *t = s->w->tree;

    s->entered ^= columns;
    for (; columns; columns &= columns - 1)
        csg_flip(t, s->w->scratch->states, s->w->scratch->inside, s->of->member[first_of(columns)]);
}

static int32_t value_of(sweep *s, uint32_t holds)
{
    if (s->of->values)
        return s->of->values[holds];
    flip(s, s->entered ^ holds);
    return s->w->scratch->states[0].value;
}

/* May the value change, or a surface show, where columns of `any` are crossed in one place? Those that clip show none. */
static bool matters(sweep *s, uint32_t any)
{
    const int32_t before = value_of(s, s->holds);

    if (!(any & ~s->of->hidden))
        return false;
    for (uint32_t some = any; some; some = (some - 1) & any)
        if (value_of(s, s->holds ^ some) != before)
            return true;
    return false;
}

static csg_found find(sweep *s, csg_first *out)
{
    for (uint32_t i = 0, end; i < s->count; i = end) {
        uint32_t any = 1u << s->at[i].column, changed = any;

        for (end = i + 1; end < s->count && s->at[end].at - s->at[end - 1].at <= near_by(s, s->at[end].at); end++) {
            any |= 1u << s->at[end].column;
            changed ^= 1u << s->at[end].column;
        }
        if (matters(s, any)) {
            out->column = s->at[i].column;
            out->inward = value_of(s, s->holds ^ any) > value_of(s, s->holds);
            out->t = (s->at[i].at - s->io.start) * s->io.per_unit;
            out->off = near_by(s, s->at[i].at) * s->io.per_unit;
            return end == i + 1 ? CSG_CROSSED : CSG_OPEN;
        }
        s->holds ^= changed;
    }
    return CSG_NOTHING;
}

/* As find(), with room for states. */
static csg_found search(sweep *s, csg_first *out)
{
    csg_found found;

    if (!s->of->values)
        memcpy(s->w->scratch->states, s->w->tree->outside, s->w->tree->node_count * sizeof *s->w->tree->outside);
    s->entered = 0;
    found = find(s, out);
    for (; s->entered; s->entered &= s->entered - 1)
        s->w->scratch->inside[s->of->member[first_of(s->entered)]] = 0;
    return found;
}

/* ---- what all columns have in common ---- */

/* Does the ray start in or before a column, for certain, and not on the edge of any but `from`? */
static bool is_clear_of_start(const sweep *s, uint32_t i, uint32_t from)
{
    const double near = near_by(s, s->io.start);
    const bool enters = fabs(s->io.in[i] - s->io.start) <= near, leaves = fabs(s->io.out[i] - s->io.start) <= near;

    return i == from ? enters && !leaves : !enters && !leaves && s->io.out[i] > s->io.start;
}

/* No other crossing is near that one. */
static bool is_single(const sweep *s, double at)
{
    const double near = 2.0 * near_by(s, at);
    uint32_t count = 0;

    for (uint32_t i = 0; i < s->of->count; i++)
        count += (uint32_t)(fabs(s->io.in[i] - at) <= near) + (uint32_t)(fabs(s->io.out[i] - at) <= near);
    return count == 1;
}

/* The last column that is entered; or, of a ray that starts within all, the first that is left. Open: as of other trees. */
static csg_found find_common(const sweep *s, uint32_t from, csg_first *out)
{
    double enter = -HUGE_VAL, leave = HUGE_VAL, at;
    uint32_t last = 0, first = 0;

    for (uint32_t i = 0; i < s->of->count; i++) {
        if (!is_clear_of_start(s, i, from))
            return CSG_OPEN;
        if (i != from && s->io.in[i] > enter) {
            enter = s->io.in[i];
            last = i;
        }
        if (s->io.out[i] < leave) {
            leave = s->io.out[i];
            first = i;
        }
    }
    out->inward = enter > s->io.start;
    at = out->inward ? enter : leave;
    if (s->io.outside || enter > leave || at < s->from || at == HUGE_VAL || !is_single(s, at))
        return CSG_OPEN;
    out->column = out->inward ? last : first;
    out->t = (at - s->io.start) * s->io.per_unit;
    out->off = near_by(s, at) * s->io.per_unit;
    return at > s->to ? CSG_NOTHING : CSG_CROSSED;
}

/* False: its member does not have it. */
static bool report(sweep *s, const csg_first *f, pov_hits *hits)
{
    const pov_crossing about = { .t = f->t, .owner = s->w->scratch->names + member_of(s, f->column)->leaf }, *at = &about;
    asked a;

    if (!csg_first_is_enough(f, hits)) {
        at = find_own(s, f, hits, &a);
        if (!at)
            return false;
    }
    hits->escalated += s->escalated;
    csg_report(at, f->inward, hits);
    return true;
}

bool csg_sweep_first(csg_traversal *w, pov_hits *hits)
{
    const double most = hits->tmax + hits->slack;
    sweep s;
    csg_first first;
    csg_found found;
    const uint32_t from = csg_outline_column(w);

    if ((w->ray->origin_mark.flags & POV_MARK_OUTWARD && w->tree->outline->convex >> from & 1) || !csg_traversal_hits_box(w) || w->enter > most)
        return true;
    s.w = w;
    s.of = w->tree->outline;
    s.exact = false;
    s.escalated = 0;
    if (!csg_outline_cross(s.of, w->ray, &s.io))
        return false;
    s.from = s.io.start + w->enter / s.io.per_unit;
    s.from -= near_by(&s, s.from);
    s.to = s.io.start + pov_min(w->leave, most) / s.io.per_unit;
    s.to += near_by(&s, s.to);
    if (is_nowhere(&s, from))
        return true;
    found = csg_is_common(w->tree) ? find_common(&s, from, &first) : CSG_OPEN;
    if (found == CSG_OPEN) {
        if (!begin(&s, from, hits))
            return false;
        found = search(&s, &first);
    }
    return found == CSG_NOTHING || (found == CSG_CROSSED && report(&s, &first, hits));
}
