/* Crossings of a tree of few members, whatever its nodes are, from their outlines: its members' crossings in order, about, and the
 * value of the tree behind each. Members without an outline are asked for theirs where the ray comes to their boxes. Where crossings are too
 * close to be told apart and it matters, csg_intersect.c has the rules. docs/numerics.md ("Outlines") derives the constants. */
#include "base/simd.h"
#include "world/csg_traversal.h"

#include <string.h>

static const double margin = CSG_OUTLINE_MARGIN;

static uint32_t count_of(uint32_t columns)
{
    uint32_t count = 0;

    for (; columns; columns &= columns - 1)
        count++;
    return count;
}

/* own: where it is among the crossings that are known in full, counted from one; or 0. */
typedef struct crossing { double at; uint16_t column, own; } crossing;

enum { OWN = 48, GROUP_MAX = 8, MOST_CROSSINGS = 2 * CSG_COLUMNS + OWN };

typedef struct sweep {
    csg_traversal *w;
    const csg_outline *of;
    csg_intervals io;
    double from, to;             /* the stretch of the ray, in the outline's units, that the tree's box holds */
    uint32_t holds;              /* columns that hold the ray before the next crossing, as bits */
    uint32_t entered;            /* those by which the states of nodes are, where there is no table of values */
    uint32_t waiting;            /* columns to be asked where the ray enters their boxes */
    uint32_t known;              /* columns whose crossings are among `own` */
    bool exact;                  /* crossings are to be found in double-double */
    bool unsure;                 /* doubles cannot order them */
    bool has_states;             /* the scratch memory's are those by `entered` */
    uint32_t escalated;
    uint32_t count, next, own_count;
    double box[CSG_COLUMNS];     /* of those that wait, where that is */
    uint8_t own_first[CSG_COLUMNS], own_end[CSG_COLUMNS];
    crossing at[MOST_CROSSINGS]; /* of members, within the stretch, from near to far */
    pov_crossing own[OWN];
} sweep;

/* A crossing of the tree. */
typedef struct found_crossing { csg_first is; const pov_crossing *own; } found_crossing;

/* Crossings nearer than that to a place cannot be told from it. */
static double near_by(const sweep *s, double at) { return margin * (s->of->endless ? s->io.from + fabs(at) : 1.0); }

/* ---- one member ---- */

enum { CROSSINGS = 4 };

static const csg_member *member_of(const sweep *s, uint32_t column)
{
    return &s->w->tree->members[s->of->member[column]];
}

/* All crossings ahead. False: there are too many. */
static bool ask(sweep *s, uint32_t column, const pov_hits *hits, pov_crossing *at, uint32_t capacity, uint32_t *count)
{
    const csg_member *m = member_of(s, column);
    pov_hits found = { .tmax = HUGE_VAL, .want = POV_WANT_ALL, .at = at, .capacity = capacity, .grow = csg_no_more, .user = hits->user,
                       .scratch = hits->scratch, .always_exact = s->exact, .unfiltered = hits->unfiltered,
                       .owner = csg_name_of(s->w, m) };

    csg_intersect_member(s->w, m, &found);
    for (uint32_t i = 0; i < found.count; i++)
        at[i].owner = s->w->scratch->names + m->leaf;
    s->escalated += found.escalated;
    *count = found.count;
    return found.count < capacity;
}

/* Once for each column: where its crossings are among `own`. False: there are too many. */
static bool find_own(sweep *s, uint32_t column, const pov_hits *hits)
{
    uint32_t count;

    if (s->known >> column & 1)
        return true;
    if (!ask(s, column, hits, s->own + s->own_count, OWN - s->own_count, &count))
        return false;
    s->known |= 1u << column;
    s->own_first[column] = (uint8_t)s->own_count;
    s->own_end[column] = (uint8_t)(s->own_count += count);
    return true;
}

static bool is_near_start(const sweep *s, const pov_crossing *at) { return at->t * s->w->dir <= CSG_SEPARATION * s->w->size; }

/* Do doubles not tell whether it is ahead? */
static bool is_unsure(const sweep *s, const pov_crossing *at) { return !s->exact && is_near_start(s, at); }

/* Is it behind the ray, in the very place that this starts from? */
static bool is_behind(const sweep *s, const pov_crossing *at) { return s->exact && is_near_start(s, at) && csg_is_behind(s->w, at); }

/* The member's own crossing that lies there. NULL: it is not certain that there is one. */
static const pov_crossing *own_at(sweep *s, const csg_first *f, const pov_hits *hits)
{
    const pov_crossing *found = NULL;

    if (!find_own(s, f->column, hits))
        return NULL;
    for (uint32_t i = s->own_first[f->column]; i < s->own_end[f->column]; i++) {
        const pov_crossing *at = &s->own[i];
        const bool there = fabs(at->t - f->t) <= f->off;

        if (is_behind(s, at))
            continue;
        if (is_unsure(s, at) || (there && found))
            return NULL;
        found = there ? at : found;
    }
    return found;
}

/* ---- crossings in order ---- */

static void insert(sweep *s, double at, uint32_t column, uint32_t own)
{
    uint32_t i = s->count++;

    for (; i > 0 && at < s->at[i - 1].at; i--)
        s->at[i] = s->at[i - 1];
    s->at[i] = (crossing){ at, (uint16_t)column, (uint16_t)own };
}

static void add(sweep *s, double at, uint32_t column, bool passed)
{
    if (passed || at < s->from)
        s->holds ^= 1u << column;
    else if (at <= s->to && at < HUGE_VAL)
        insert(s, at, column, 0);
}

/* A member's own crossings ahead: where the first of them counts, the ray is inside by their number and by whether it ends inside. False: it is
 * open which ones are ahead. */
static bool add_own(sweep *s, uint32_t i, bool ends_inside, const pov_hits *hits)
{
    bool inside = ends_inside;

    if (!find_own(s, i, hits))
        return false;
    for (uint32_t k = s->own_first[i]; k < s->own_end[i]; k++) {
        const double at = s->io.start + s->own[k].t / s->io.per_unit;

        if (is_behind(s, &s->own[k]))
            continue;
        s->unsure = s->unsure || is_unsure(s, &s->own[k]);
        inside = inside != (at >= s->from);
        if (at >= s->from && at <= s->to)
            insert(s, at, i, k + 1);
    }
    s->holds ^= (uint32_t)(inside != (s->io.outside >> i & 1)) << i;
    return !s->unsure;
}

/* `from`: the column that the ray starts on, one of whose crossings is the start. One that it starts near is asked for its own. False: open. */
static bool add_column(sweep *s, uint32_t i, uint32_t from, const pov_hits *hits)
{
    const double in = s->io.in[i], out = s->io.out[i], start = s->io.start, near = near_by(s, start);
    bool enters, leaves;

    if (in == HUGE_VAL || in - out > near_by(s, in))
        return i != from;
    enters = fabs(in - start) <= near;
    leaves = fabs(out - start) <= near;
    if (i == from && enters == leaves)
        return false;
    if (i != from && (enters || leaves) && start + near >= s->from)
        return add_own(s, i, (s->io.outside >> i & 1) != (out == HUGE_VAL), hits);
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

/* Where the ray enters the box of a column that is to be asked; from a start within the box at once. */
static void await(sweep *s, uint32_t i)
{
    double enter, leave = HUGE_VAL;

    if (!csg_hits_box(s->w, &member_of(s, i)->box, &enter, &leave))
        return;
    s->box[i] = s->io.start + enter / s->io.per_unit;
    s->box[i] -= near_by(s, s->box[i]);
    s->waiting |= 1u << i;
}

static bool begin(sweep *s, uint32_t from, const pov_hits *hits)
{
    s->holds = s->io.outside;
    s->count = s->next = s->own_count = s->waiting = s->known = s->entered = 0;
    for (uint32_t i = 0; i < s->of->count; i++) {
        if (s->of->held >> i & 1)
            continue;
        if (s->of->asked >> i & 1)
            await(s, i);
        else if (!add_column(s, i, from, hits))
            return false;
    }
    return true;
}

/* The crossings of a column that was waited for: without any of one that holds the tree there is nothing. False: it is open whether the ray
 * starts inside. */
static bool enter_column(sweep *s, uint32_t i, const pov_hits *hits)
{
    s->waiting &= ~(1u << i);
    if (!find_own(s, i, hits))
        return false;
    if (s->own_first[i] == s->own_end[i] && member_of(s, i)->needed) {
        s->waiting = 0;
        s->count = s->next;
        return true;
    }
    return add_own(s, i, false, hits);
}

/* The first column whose box is entered by there, or CSG_COLUMNS. */
static uint32_t entered_by(const sweep *s, double by)
{
    uint32_t first = CSG_COLUMNS;

    for (uint32_t left = s->waiting; left; left &= left - 1) {
        const uint32_t i = first_of(left);

        if (s->box[i] <= by) {
            first = i;
            by = s->box[i];
        }
    }
    return first;
}

/* The next crossings that are near each other, of which the last is before `end`: their columns, and those that are crossed an odd number of
 * times, as bits. */
typedef struct near_group { uint32_t end, any, changed; } near_group;

static near_group group_up_to(const sweep *s, uint32_t end)
{
    near_group g = { end, 0, 0 };

    for (uint32_t i = s->next; i < end; i++) {
        g.any |= 1u << s->at[i].column;
        g.changed ^= 1u << s->at[i].column;
    }
    return g;
}

/* Behind the next crossing and those that are near it. False: open. */
static bool find_end(sweep *s, const pov_hits *hits, uint32_t *end)
{
    for (;;) {
        uint32_t column;

        *end = s->next + (s->next < s->count);
        while (*end < s->count && s->at[*end].at - s->at[*end - 1].at <= near_by(s, s->at[*end].at))
            ++*end;
        column = entered_by(s, *end > s->next ? s->at[*end - 1].at + near_by(s, s->at[*end - 1].at) : s->to);
        if (column == CSG_COLUMNS)
            return true;
        if (!enter_column(s, column, hits))
            return false;
    }
}

/* ---- the tree's value ---- */

static void flip(sweep *s, uint32_t columns)
{
    const csg_tree *t = s->w->tree;

    if (!s->has_states)
        memcpy(s->w->scratch->states, t->outside, t->node_count * sizeof *t->outside);
    s->has_states = true;
    s->entered ^= columns;
    for (; columns; columns &= columns - 1)
        csg_flip(t, s->w->scratch->states, s->w->scratch->inside, s->of->member[first_of(columns)]);
}

static int32_t value_of(sweep *s, uint32_t holds)
{
    if (s->of->is_product)
        return holds == s->of->factors;
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

/* So many clips with gaps are looked at in all their sets; of more any crossing may matter. */
enum { HELD_MAX = 3 };

/* The same, whatever clips with gaps hold. */
static bool may_matter(sweep *s, uint32_t any)
{
    const uint32_t held = s->of->held, before = s->holds;
    bool matter = matters(s, any) || count_of(held) > HELD_MAX;

    for (uint32_t some = held; some && !matter; some = (some - 1) & held) {
        s->holds = before ^ some;
        matter = matters(s, any);
    }
    s->holds = before;
    return matter;
}

/* What clips with gaps hold on both sides of a crossing. False: open, or not the same. */
static bool find_held(sweep *s, uint32_t end, const pov_crossing *at)
{
    const double before = s->next > 0 ? s->at[s->next].at - s->at[s->next - 1].at : HUGE_VAL, after = end < s->count ? s->at[end].at - s->at[s->next].at : HUGE_VAL;
    const double step = csg_open_step(s->w, at->t, pov_min(at->t, before * s->io.per_unit), after * s->io.per_unit);

    for (uint32_t left = s->of->held; left; left &= left - 1) {
        const csg_member *m = member_of(s, first_of(left));
        const bool inside = csg_member_holds(s->w, m, at->t - step);

        if (csg_member_holds(s->w, m, at->t + step) != inside)
            return false;
        s->holds = inside ? s->holds | (left & (0u - left)) : s->holds & ~(left & (0u - left));
    }
    return true;
}

static void find_about(const sweep *s, const crossing *at, found_crossing *out)
{
    out->is.column = at->column;
    out->is.t = (at->at - s->io.start) * s->io.per_unit;
    out->is.off = near_by(s, at->at) * s->io.per_unit;
    out->own = at->own ? &s->own[at->own - 1] : NULL;
}

/* Several crossings near each other, one or more of which matter, by the rules of the walk: the members' own crossings in order. False: open. */
static bool pass_group(sweep *s, const near_group *g, pov_hits *hits, bool *more)
{
    csg_traversal *w = s->w;
    pov_crossing group[GROUP_MAX];
    uint32_t count = 0;
    bool passed;

    if (g->end - s->next > GROUP_MAX || w->tree->open_count > 0)
        return false;
    for (uint32_t i = s->next; i < g->end; i++) {
        found_crossing about;
        const pov_crossing *own;

        find_about(s, &s->at[i], &about);
        own = about.own ? about.own : own_at(s, &about.is, hits);
        if (!own)
            return false;
        group[count++] = *own;
    }
    flip(s, s->entered ^ s->holds);
    w->found.at = group;
    w->found.count = count;
    w->applied = 0;
    w->whole = w->grazes = false;
    csg_put_in_order(w, 0, 0);
    passed = csg_pass(w, hits, s->exact, more);
    s->unsure = s->unsure || !passed;
    s->entered = passed && *more ? s->entered ^ g->changed : s->entered | g->any;
    return passed;
}

/* The next crossing, which may matter. False: that is open. */
static bool take(sweep *s, const near_group *g, const pov_hits *hits, found_crossing *out, bool *matter)
{
    const crossing *first = &s->at[s->next];

    find_about(s, first, out);
    if (s->of->held) {
        out->own = out->own ? out->own : own_at(s, &out->is, hits);
        if (!out->own || !find_held(s, g->end, out->own))
            return false;
    }
    *matter = !s->of->held || matters(s, g->any);
    out->is.inward = value_of(s, s->holds ^ g->any) > value_of(s, s->holds);
    return true;
}

/* The next crossing of the tree. `*more`: others have been reported, and no more is wanted. */
static csg_found find(sweep *s, pov_hits *hits, found_crossing *out, bool *more)
{
    for (uint32_t end; *more; s->next = end) {
        bool matter, several;
        near_group g;

        if (!find_end(s, hits, &end))
            return CSG_OPEN;
        if (end == s->next)
            return CSG_NOTHING;
        g = group_up_to(s, end);
        matter = may_matter(s, g.any);
        several = matter && end > s->next + 1;
        if (matter && (several ? !pass_group(s, &g, hits, more) : !take(s, &g, hits, out, &matter)))
            return CSG_OPEN;
        s->holds ^= g.changed;
        if (!matter || several)
            continue;
        s->next = end;
        return CSG_CROSSED;
    }
    return CSG_NOTHING;
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

/* Any crossing will do, wherever it is, and this one is certainly among those that count. */
static bool is_enough(const csg_first *f, const pov_hits *hits) { return csg_first_is_enough(f, hits) && f->t - f->off > hits->tmin; }

/* The first crossing of what all columns have in common, or some without others. Open: as of other trees. */
static csg_found find_by_intervals(const sweep *s, uint32_t from, double most, csg_first *out)
{
    const csg_outline *of = s->of;
    csg_intervals io;

    if (csg_is_common(s->w->tree))
        return find_common(s, from, out);
    if (s->w->tree->chords.all || !of->is_product || of->endless || of->hidden || (of->asked | of->held) || s->io.outside)
        return CSG_OPEN;
    io = s->io;
    return csg_outline_first(of, &io, from, most, out);
}

/* False: its member does not have it; `*more`: more is wanted. One before what counts is none. */
static bool report(sweep *s, const found_crossing *f, pov_hits *hits, bool *more)
{
    const pov_crossing about = { .t = f->is.t, .owner = s->w->scratch->names + member_of(s, f->is.column)->leaf };
    const pov_crossing *at = f->own ? f->own : is_enough(&f->is, hits) ? &about : own_at(s, &f->is, hits);

    if (!at)
        return false;
    *more = csg_report(at, f->is.inward, hits) && (hits->want == POV_WANT_ALL || !(at->t > hits->tmin));
    return true;
}

/* The first crossing, or all. */
static bool report_found(sweep *s, pov_hits *hits)
{
    bool more = true;

    while (more) {
        found_crossing f;
        const csg_found found = find(s, hits, &f, &more);

        if (found == CSG_OPEN || (found == CSG_CROSSED && !report(s, &f, hits, &more)))
            return false;
        more = more && found == CSG_CROSSED;
    }
    hits->escalated += s->escalated;
    return true;
}

/* As report_found(), with room for states. */
static bool report_in_order(sweep *s, uint32_t from, pov_hits *hits)
{
    bool done;

    s->unsure = s->has_states = false;
    if (!begin(s, from, hits))
        return false;
    done = report_found(s, hits);
    for (; s->entered; s->entered &= s->entered - 1)
        s->w->scratch->inside[s->of->member[first_of(s->entered)]] = 0;
    return done;
}

/* The first crossing of what all columns have in common. False: open, or it lies before what counts. */
static bool report_common(sweep *s, const csg_first *first, pov_hits *hits)
{
    const found_crossing f = { *first, NULL };
    bool more;

    s->known = s->own_count = 0;
    if (!(first->t - first->off > hits->tmin) || !report(s, &f, hits, &more))
        return false;
    hits->escalated += s->escalated;
    return true;
}

bool csg_sweep(csg_traversal *w, pov_hits *hits, bool exact)
{
    const double most = hits->tmax + hits->slack;
    const uint32_t count = hits->count;
    sweep s;
    csg_first first;
    csg_found found;
    const uint32_t from = csg_outline_column(w);

    if ((w->ray->origin_mark.flags & POV_MARK_OUTWARD && w->tree->outline->convex >> from & 1) || !csg_traversal_hits_box(w) || w->enter > most)
        return true;
    s.w = w;
    s.of = w->tree->outline;
    s.exact = exact;
    s.escalated = 0;
    if (!csg_outline_cross(s.of, w->ray, &s.io))
        return false;
    s.from = s.io.start + pov_max(w->enter, hits->tmin) / s.io.per_unit;
    s.from -= near_by(&s, s.from);
    s.to = s.io.start + pov_min(w->leave, most) / s.io.per_unit;
    s.to += near_by(&s, s.to);
    if (is_nowhere(&s, from))
        return true;
    if (s.of->walked)
        return false;
    found = hits->want == POV_WANT_ALL ? CSG_OPEN : find_by_intervals(&s, from, most, &first);
    if (found == CSG_CROSSED)
        return report_common(&s, &first, hits);
    if (found == CSG_NOTHING || report_in_order(&s, from, hits))
        return true;
    if (!s.unsure || s.exact)
        return false;
    hits->count = count;
    s.exact = true;
    s.escalated++;
    return report_in_order(&s, from, hits);
}
