/* The first crossing of a tree that is an intersection of a few convex members and complements of such: what most solids
 * of a scene are. A ray is inside each of them along one interval, so no queue and no values at nodes are needed. Where
 * two crossings are too close for doubles, and where more than the first crossing is wanted, csg_intersect.c has the rules. */
#include "base/simd.h"
#include "world/csg_traversal.h"

/* Boxes of members are compared with distances that are this much off. */
static const double margin = 1.0 + 0x1p-40;
/* The least cosine for which a surface's distance is told from that along the ray, where both are near zero. */
static const double steep = 0x1p-10;

enum { CROSSINGS = 2 * CSG_FEW + 1 };   /* one more than they can have */

/* Where the ray is inside a member; NULL: already at its start, or never. */
typedef struct chord { const pov_crossing *in, *out; } chord;

typedef struct chord_search {
    csg_traversal *w;
    pov_hits found;
    bool unsure;
    const uint32_t *member;      /* by column */
    uint32_t asked;              /* columns of `few`, as bits */
    double enter[CSG_FEW], leave[CSG_FEW];   /* of their boxes */
    chord of[CSG_FEW];
    pov_crossing at[CROSSINGS];
} chord_search;

/* ---- which trees ---- */

static bool is_simple(const csg_member *m)
{
    return m->boxed && !m->patch && !csg_is_unseen(m) && (m->shape->flags & POV_SHAPE_CONVEX);
}

/* Is a node, or its complement, an intersection of members and complements? */
static bool add(const csg_tree *t, node_ref node, bool complement, uint8_t *holds)
{
    const csg_node *n = &t->nodes[node & ~NODE_GROUP];

    if (!(node & NODE_GROUP)) {
        holds[node] = t->members[node].inverse == complement;
        return true;
    }
    complement = complement != n->inverse;
    if (n->child_count > 1 && complement == (n->op == NODE_INTERSECTION))
        return false;
    for (uint32_t i = 0; i < n->child_count; i++)
        if (!add(t, t->children[n->child + i], complement, holds))
            return false;
    return true;
}

bool csg_is_product(const csg_tree *t, uint8_t *holds)
{
    return t->member_count <= CSG_CHORDS_MAX && add(t, NODE_GROUP, false, holds);
}

static bool are_simple(const csg_tree *t)
{
    for (uint32_t i = 0; i < t->member_count; i++)
        if (!is_simple(&t->members[i]))
            return false;
    return true;
}

static uint32_t column_of(const csg_tree *t, uint32_t member)
{
    for (uint32_t i = 0; i < t->few.count; i++)
        if (t->bounds[t->few.bound[i]].member == member)
            return i;
    return CSG_FEW;
}

void csg_find_chords(csg_tree *t)
{
    uint8_t holds[CSG_CHORDS_MAX] = { 0 };
    csg_chords *f = &t->chords;

    if (t->few.count == 0 || !t->boxed || t->empty || !csg_is_product(t, holds) || !are_simple(t))
        return;
    for (uint32_t i = 0; i < t->member_count; i++) {
        const uint32_t column = column_of(t, i);

        if (column == CSG_FEW && holds[i])
            return;                            /* no ray is ever inside it */
        if (column == CSG_FEW)
            continue;
        f->member[column] = i;
        f->within |= (uint32_t)holds[i] << column;
    }
    f->all = f->within != 0 ? (1u << t->few.count) - 1 : 0;
}

/* ---- members ---- */

/* Crossings at this distance and at that one: which is farther? Where that is open the answer does not matter. Near the start they may be apart
 * by much of their distances, and yet in one place. */
static bool is_before(chord_search *s, double a, double b)
{
    const double gap = fabs(b - a);

    s->unsure = s->unsure || gap <= CSG_SEPARATION * fabs(b) || gap * s->w->dir * steep <= CSG_SAME_POINT * s->w->size;
    return a < b;
}

/* What double-double has found near the start: behind it, before it for certain, or neither. */
typedef enum side { BEHIND, BEFORE, UNKNOWN } side;

static side side_of(const csg_traversal *w, const pov_crossing *at)
{
    const double slope = fabs(csg_slope(w, at));

    if (!(at->mark.flags & POV_MARK_ESCALATED) || slope < steep * w->dir)
        return UNKNOWN;
    return at->t * slope <= CSG_SAME_POINT * w->size ? BEHIND : BEFORE;
}

/* Leave out crossings of the place that the ray starts from. */
static void drop_behind(chord_search *s, uint32_t first)
{
    const double near = CSG_SEPARATION * s->w->size;
    uint32_t kept = first;

    for (uint32_t i = first; i < s->found.count; i++) {
        const pov_crossing *at = &s->at[i];
        const side is = at->t * s->w->dir > near ? BEFORE : side_of(s->w, at);

        s->unsure = s->unsure || is == UNKNOWN;
        if (is != BEHIND)
            s->at[kept++] = *at;
    }
    s->found.count = kept;
}

/* The interval of a column's member. */
static chord *ask(chord_search *s, uint32_t column)
{
    const uint32_t first = s->found.count;
    chord *c = &s->of[column];
    const pov_crossing *at = s->at + first;
    const csg_member *m;
    uint32_t count;

    if (s->asked >> column & 1)
        return c;
    s->asked |= 1u << column;
    m = &s->w->tree->members[s->member[column]];
    s->found.owner = s->w->scratch->names + m->leaf;
    csg_intersect_member(s->w, m, &s->found);
    drop_behind(s, first);
    count = s->found.count - first;
    c->in = c->out = NULL;
    s->unsure = s->unsure || count > 2;
    if (s->unsure || count == 0)
        return c;
    c->out = &at[count - 1];
    if (count == 2)
        c->in = is_before(s, at[0].t, at[1].t) ? &at[0] : &at[1];
    if (c->in == c->out)
        c->out = &at[0];
    return c;
}

/* ---- the first crossing ---- */

/* Members that are no complements: the ray must be inside all. False: it never is. */
static bool find_common(chord_search *s, chord *both)
{
    const csg_chords *f = &s->w->tree->chords;
    const uint32_t from = csg_which(s->w, s->w->ray->origin_surface);
    uint32_t left = f->within;

    both->in = both->out = NULL;
    for (uint32_t first = 0, i; left; left &= ~(1u << i), first = 1) {
        const chord *c;

        i = first_of(left);
        for (uint32_t k = 0; !first && k < s->w->tree->few.count; k++)
            i = f->member[k] == from && (left >> k & 1) ? k : i;   /* a ray that leaves a member outward ends here */
        c = ask(s, i);
        if (s->unsure || !c->out)
            return false;
        if (c->in && (!both->in || is_before(s, both->in->t, c->in->t)))
            both->in = c->in;
        if (!both->out || is_before(s, c->out->t, both->out->t))
            both->out = c->out;
    }
    return !both->in || is_before(s, both->in->t, both->out->t);
}

/* Beyond the complements that hold `both->in`, one after the other. False: they reach to the end. */
static bool leave_hollows(chord_search *s, chord *both)
{
    uint32_t left = s->w->tree->chords.all & ~s->w->tree->chords.within;

    for (uint32_t rest = left; rest && !s->unsure; ) {
        const uint32_t i = first_of(rest);
        const double at = both->in ? both->in->t : 0.0;
        const chord *c;

        rest &= rest - 1;
        if (at > s->leave[i] * margin || s->enter[i] > at * margin)
            continue;
        c = ask(s, i);
        if (s->unsure || !c->out || (c->in && !is_before(s, c->in->t, at)) || !is_before(s, at, c->out->t))
            continue;
        both->in = c->out;
        if (!is_before(s, both->in->t, both->out->t))
            return false;
        left &= ~(1u << i);
        rest = left;
    }
    return true;
}

/* The ray starts inside the solid: where does it leave it? */
static void find_exit(chord_search *s, chord *both)
{
    for (uint32_t left = s->w->tree->chords.all & ~s->w->tree->chords.within; left && !s->unsure; left &= left - 1) {
        const uint32_t i = first_of(left);
        const chord *c;

        if (s->enter[i] > both->out->t * margin)
            continue;
        c = ask(s, i);
        if (c->in && is_before(s, c->in->t, both->out->t))
            both->out = c->in;
    }
}

static void begin(chord_search *s, csg_traversal *w, const pov_hits *hits)
{
    const pov_hits found = { .tmax = HUGE_VAL, .want = POV_WANT_ALL, .at = s->at, .capacity = CROSSINGS, .grow = csg_no_more,
                             .user = hits->user, .scratch = hits->scratch };

    s->w = w;
    s->member = w->tree->chords.all ? w->tree->chords.member : w->tree->outline->member;
    s->found = found;
    s->unsure = false;
    s->asked = 0;
}

/* Report the crossing that the outline has found. False: its member does not have it. */
static bool report_found(chord_search *s, const csg_first *f, pov_hits *hits)
{
    const csg_member *m = &s->w->tree->members[s->member[f->column]];
    const pov_crossing about = { .t = f->t, .owner = s->w->scratch->names + m->leaf };
    const pov_crossing *at = &about;

    if (!csg_first_is_enough(f, hits)) {
        const chord *c = ask(s, f->column);

        at = f->enters ? c->in : c->out;
        if (s->unsure || !at)
            return false;
        hits->escalated += s->found.escalated;
    }
    csg_report(at, f->inward, hits);
    return true;
}

bool csg_chords_report(csg_traversal *w, const csg_first *f, pov_hits *hits)
{
    chord_search s;

    begin(&s, w, hits);
    return report_found(&s, f, hits);
}

/* False: open. */
static bool is_found(csg_traversal *w, pov_hits *hits)
{
    const uint32_t from = csg_outline_column(w);
    csg_intervals of;
    csg_first first;

    /* A ray that leaves a convex member outward leaves the tree, which is within it. */
    if (w->ray->origin_mark.flags & POV_MARK_OUTWARD && w->tree->chords.within >> from & 1)
        return true;
    if (!csg_outline_cross(w->tree->outline, w->ray, &of))
        return false;
    switch (csg_outline_first(w->tree->outline, &of, from, hits->tmax + hits->slack, &first)) {
    case CSG_NOTHING:
        return true;
    case CSG_CROSSED:
        return csg_chords_report(w, &first, hits);
    default:
        return false;
    }
}

bool csg_chords_first(csg_traversal *w, pov_hits *hits)
{
    const csg_chords *f = &w->tree->chords;
    chord_search s;
    chord both;

    if (w->tree->outline && is_found(w, hits))
        return true;
    begin(&s, w, hits);
    csg_enter_few(w, &w->tree->few, s.enter, s.leave);
    for (uint32_t left = f->within; left; left &= left - 1)
        if (!(s.enter[first_of(left)] <= s.leave[first_of(left)] && s.enter[first_of(left)] < hits->tmax + hits->slack))
            return true;
    if (find_common(&s, &both) && leave_hollows(&s, &both)) {
        if (!both.in)
            find_exit(&s, &both);
        if (!s.unsure)
            csg_report(both.in ? both.in : both.out, both.in != NULL, hits);
    }
    if (!s.unsure)
        hits->escalated += s.found.escalated;
    return !s.unsure;
}
