/* A ray's walk through a tree of shapes: all crossings of its members, from near to far, and where they change its value.
 *
 * docs/numerics.md ("Solids made of others") has the rules and derives the constants. */
#include "base/simd.h"
#include "base/vec.h"
#include "world/csg.h"

#include <string.h>

/* Crossings are coincident if their distances differ by no more than the error of double-double. */
static const double same_point = 0x1p-92;
/* Distances in double are distinct if they differ by more than this fraction; else all are computed again in
 * double-double. */
static const double separation = 0x1p-42;
/* Boxes are tested in doubles: their slabs are off by a few roundings of the coordinates. */
static const double box_slack = 0x1p-48;

/* In the mark of a crossing of a member that clips. */
#define APPLIED 0x04000000u

/* Distance from a crossing at which open members are asked, as a fraction of the size. */
static const double open_step = 0x1p-24;

typedef struct csg_traversal {
    const csg_tree *tree;
    const pov_ray *ray;
    csg_scratch *scratch;
    pov_hits found;              /* the members' crossings */
    uint32_t applied;            /* number of crossings at the front that are behind; the others are in order */
    uint32_t asked_count, near_count;
    bool unsure;                 /* doubles cannot order them */
    double dir, size;            /* largest component of the direction; and of the coordinates involved */
} csg_traversal;

/* ---- memory ---- */

static bool grow(pov_hits *hits)
{
    csg_scratch *s = ((const csg_user *)hits->user)->scratch;
    size_t capacity = s->capacity;

    if (capacity > UINT32_MAX / 2 ||
        !vec_reserve(s->env, (void **)&s->crossings, &capacity, hits->count, sizeof *s->crossings)) {
        s->failed = true;
        return false;
    }
    s->capacity = hits->capacity = (uint32_t)capacity;
    hits->at = s->crossings;
    return true;
}

bool csg_scratch_init(csg_scratch *s, const csg_list *all, const env *e)
{
    uint32_t nodes = 0, members = 0;

    for (uint32_t i = 0; i < all->count; i++) {
        nodes = all->items[i].node_count > nodes ? all->items[i].node_count : nodes;
        members = all->items[i].member_count > members ? all->items[i].member_count : members;
    }
    s->env = e;
    if (all->count == 0)
        return true;
    s->states = env_alloc(e, nodes, sizeof *s->states);
    s->inside = env_alloc(e, members, sizeof *s->inside);
    s->asked = env_alloc(e, members, sizeof *s->asked);
    s->near = env_alloc(e, 2 * (size_t)members, sizeof *s->near);
    return s->states && s->inside && s->asked && s->near;
}

void csg_scratch_free(csg_scratch *s)
{
    env_free(s->env, s->crossings);
    env_free(s->env, s->states);
    env_free(s->env, s->inside);
    env_free(s->env, s->asked);
    env_free(s->env, s->near);
}

/* ---- values ---- */

/* Enter or leave a member, and update its ancestors, up to the first whose value stays. */
static void toggle(csg_traversal *w, uint32_t member)
{
    const csg_member *m = &w->tree->members[member];
    csg_state *states = w->scratch->states;
    uint32_t node = m->node;
    int32_t now = (w->scratch->inside[member] ^= 1) != m->inverse, before = !now;

    for (;;) {
        const csg_node *n = &w->tree->nodes[node];
        csg_state *s = &states[node];

        s->sum += now - before;
        s->zeros += (now == 0) - (before == 0);
        before = s->value;
        now = s->value = csg_value(n, s);
        if (now == before || node == 0)
            return;
        node = n->parent;
    }
}

/* ---- boxes ---- */

static bool narrow(double o, double d, double lo, double hi, double *enter, double *leave)
{
    const double slack = box_slack * (fabs(o) + fabs(lo) + fabs(hi));
    double a = lo - slack - o, b = hi + slack - o;

    if (d == 0.0)
        return a <= 0.0 && b >= 0.0;
    a /= d;
    b /= d;
    *enter = fmax(*enter, fmin(a, b) * (1.0 - 0x1p-50));
    *leave = fmin(*leave, fmax(a, b) * (1.0 + 0x1p-50));
    return *enter <= *leave;
}

/* May the ray hit the contents of the box before tmax, and from which distance on? */
static bool hits_box(const pov_ray *r, const pov_box *b, double tmax, double *enter)
{
    double leave = tmax;

    *enter = 0.0;
    return narrow(r->org.x, r->dir.x, b->lo.x, b->hi.x, enter, &leave) &&
           narrow(r->org.y, r->dir.y, b->lo.y, b->hi.y, enter, &leave) &&
           narrow(r->org.z, r->dir.z, b->lo.z, b->hi.z, enter, &leave);
}

static void push(csg_traversal *w, uint32_t bound)
{
    csg_near *near = w->scratch->near;
    uint32_t i = w->near_count;
    double t;

    if (!hits_box(w->ray, &w->tree->bounds[bound].box, HUGE_VAL, &t))
        return;
    for (w->near_count++; i > 0 && t < near[(i - 1) / 2].t; i = (i - 1) / 2)
        near[i] = near[(i - 1) / 2];
    near[i].t = t;
    near[i].bound = bound;
}

static uint32_t pop(csg_traversal *w)
{
    csg_near *near = w->scratch->near;
    const uint32_t bound = near[0].bound, n = --w->near_count;
    const csg_near last = near[n];
    uint32_t i = 0, child;

    for (; (child = 2 * i + 1) < n; i = child) {
        child += child + 1 < n && near[child + 1].t < near[child].t;
        if (!(near[child].t < last.t))
            break;
        near[i] = near[child];
    }
    near[i] = last;
    return bound;
}

/* ---- members ---- */

static const csg_member *member_of(const csg_traversal *w, const pov_crossing *at)
{
    return &w->tree->members[at->owner - w->tree->members[0].leaf];
}

/* Cosine between the ray and the normal, times the length of the direction. */
static double slope_at(const csg_traversal *w, const pov_crossing *at)
{
    const csg_member *m = member_of(w, at);
    pov_vec3 normal;

    if (m->xform)
        instance_normal(m->xform, m->shape, m->instance, w->ray, at, &normal);
    else
        m->shape->normal(m->instance, w->ray, at, &normal);
    return pov_dot(normal, w->ray->dir);
}

static double cosine_at(const csg_traversal *w, const pov_crossing *at) { return fabs(slope_at(w, at)); }

/* A surface that coincides with the ray's origin surface is behind the ray. */
static bool is_behind(csg_traversal *w, const pov_crossing *at)
{
    if (!(at->t * w->dir <= separation * w->size))
        return false;
    if (!w->found.always_exact) {
        w->unsure = true;
        return false;
    }
    return at->t * cosine_at(w, at) <= same_point * w->size;
}

static void drop_behind(csg_traversal *w, uint32_t first)
{
    pov_hits *found = &w->found;
    uint32_t kept = first;

    for (uint32_t i = first; i < found->count; i++)
        if (!is_behind(w, &found->at[i]))
            found->at[kept++] = found->at[i];
    found->count = kept;
}

static pov_two along(double o, double o_lo, double t, double d, double d_lo)
{
    return pov_two_along(pov_two_sum(o, o_lo), t, d, d_lo);
}

static pov_two3 point_at(const pov_ray *r, double t)
{
    pov_two3 p;

    p.x = along(r->org.x, r->org_lo.x, t, r->dir.x, r->dir_lo.x);
    p.y = along(r->org.y, r->org_lo.y, t, r->dir.y, r->dir_lo.y);
    p.z = along(r->org.z, r->org_lo.z, t, r->dir.z, r->dir_lo.z);
    return p;
}

static bool is_inside_at(const csg_traversal *w, const csg_member *m, double t)
{
    const pov_two3 p = point_at(w->ray, t);

    return m->xform ? instance_inside(m->xform, m->shape, m->instance, pov_two3_hi(p), pov_two3_lo(p))
                    : m->shape->inside(m->instance, pov_two3_hi(p), pov_two3_lo(p));
}

/* Does the ray end inside an infinite member? Tested well behind its last crossing. */
static bool ends_inside(const csg_traversal *w, const csg_member *m, uint32_t first)
{
    double t = w->dir > 0.0 ? w->size / w->dir : 1.0;

    for (uint32_t i = first; i < w->found.count; i++)
        t = fmax(t, w->found.at[i].t);
    return is_inside_at(w, m, 2.0 * t);
}

static bool comes_before(const pov_crossing *a, const pov_crossing *b)
{
    if (a->t != b->t)
        return a->t < b->t;
    if (a->t_lo != b->t_lo)
        return a->t_lo < b->t_lo;
    return a->owner < b->owner;
}

/* Merge the crossings from `first` on into those still ahead. */
static void put_in_order(csg_traversal *w, uint32_t first)
{
    pov_crossing *at = w->found.at;

    for (uint32_t i = first, j; i < w->found.count; i++) {
        const pov_crossing c = at[i];

        for (j = i; j > w->applied && comes_before(&c, &at[j - 1]); j--)
            at[j] = at[j - 1];
        at[j] = c;
    }
}

/* All crossings of a member ahead; the parity of their number tells whether the ray starts inside it. */
static void test_member(csg_traversal *w, uint32_t member)
{
    const csg_member *m = &w->tree->members[member];
    const uint32_t first = w->found.count;
    bool inside;

    w->scratch->asked[w->asked_count++] = member;
    w->found.owner = m->leaf;
    if (m->xform)
        instance_intersect(m->xform, m->shape, m->instance, w->ray, &w->found);
    else
        m->shape->intersect(m->instance, w->ray, &w->found);
    drop_behind(w, first);
    inside = !m->patch && !m->open && (w->found.count - first) & 1;
    if (!m->boxed && !m->patch && !m->open)
        inside = inside != ends_inside(w, m, first);
    if (inside)
        toggle(w, member);
    put_in_order(w, first);
}

/* ---- places ---- */

static bool shares_point(const csg_traversal *w, const pov_crossing *first, const pov_crossing *next)
{
    const double between = (next->t - first->t) + (next->t_lo - first->t_lo);
    double a, b;

    if (between > separation * fabs(first->t))
        return false;
    a = cosine_at(w, first);
    b = cosine_at(w, next);
    return !(between * a * b > same_point * (w->size + fabs(first->t) * w->dir) * (a + b));
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

/* The coincident crossing whose surface is reported: of the members that are entered or left like the solid, the
 * earliest in the text. */
static const pov_crossing *owner_of(const csg_traversal *w, uint32_t first, uint32_t end, bool enters)
{
    const pov_crossing *at = w->found.at, *best = NULL, *other = NULL;

    for (uint32_t i = first; i < end; i++) {
        const csg_member *m = member_of(w, &at[i]);
        const bool entered = w->scratch->inside[m - w->tree->members];

        if (m->hidden || m->patch)
            continue;
        other = other ? other : &at[i];
        if ((entered != m->turned) == enters && (!best || at[i].owner < best->owner) && is_changed(w, i, first, end))
            best = &at[i];
    }
    return best ? best : other;
}

static bool report(const pov_crossing *at, bool enters, pov_hits *hits)
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

/* ---- walks ---- */

static void begin(csg_traversal *w, const pov_hits *hits, bool exact)
{
    const csg_tree *t = w->tree;
    csg_scratch *s = w->scratch;

    memset(&w->found, 0, sizeof w->found);
    w->found.tmax = HUGE_VAL;
    w->found.want = POV_WANT_ALL;
    w->found.always_exact = exact;
    w->found.at = s->crossings;
    w->found.capacity = s->capacity;
    w->found.grow = grow;
    w->found.user = hits->user;
    w->found.scratch = hits->scratch;
    w->applied = w->asked_count = w->near_count = 0;
    w->unsure = false;
    memcpy(s->states, t->outside, t->node_count * sizeof *s->states);
    for (uint32_t i = 0; i < t->endless_count; i++)
        test_member(w, t->endless[i]);
    if (t->bounds_count > 0)
        push(w, 0);
}

static void end(csg_traversal *w)
{
    for (uint32_t i = 0; i < w->asked_count; i++)
        w->scratch->inside[w->scratch->asked[i]] = 0;
}

/* Open bounds until the next crossing is before all remaining bounds. */
static void test_ahead(csg_traversal *w)
{
    while (w->near_count > 0) {
        const csg_bound *b;
        uint32_t which;

        if (w->applied < w->found.count && w->found.at[w->applied].t * (1.0 + 0x1p-40) < w->scratch->near[0].t)
            return;
        which = pop(w);
        b = &w->tree->bounds[which];
        if (b->other == 0) {
            test_member(w, b->member);
        } else {
            push(w, which + 1);
            push(w, b->other);
        }
    }
}

/* Are the next two crossings too close for doubles? */
static bool is_close(const csg_traversal *w)
{
    const pov_crossing *at = w->found.at;
    const uint32_t i = w->applied + 1;

    return !w->found.always_exact && i < w->found.count && at[i].t - at[i - 1].t <= separation * fabs(at[i].t);
}

/* ---- coincident crossings ---- */

static uint32_t which_of(const csg_traversal *w, const pov_crossing *at) { return at->owner - w->tree->members[0].leaf; }

/* Apply members that clip: before the others those that uncover surfaces, after them those that cover. So a surface that
 * coincides with the clip's is visible. */
static void clip(csg_traversal *w, uint32_t first, uint32_t end, bool enters)
{
    for (uint32_t i = first; i < end; i++) {
        pov_crossing *at = &w->found.at[i];
        const csg_member *m = member_of(w, at);

        if (!m->hidden || m->patch || m->open || at->mark.flags & APPLIED ||
            ((w->scratch->inside[which_of(w, at)] == m->turned) != enters && enters))
            continue;
        at->mark.flags |= APPLIED;
        toggle(w, which_of(w, at));
    }
}

static void apply(csg_traversal *w, uint32_t first, uint32_t end)
{
    for (uint32_t i = first; i < end; i++) {
        const csg_member *m = member_of(w, &w->found.at[i]);

        if (!m->hidden && !m->patch && !m->open)
            toggle(w, which_of(w, &w->found.at[i]));
    }
}

/* How far from its crossing an open member is asked where the ray is: not as far as the next crossing. */
static double step_at(const csg_traversal *w, uint32_t first, uint32_t end)
{
    const pov_crossing *at = w->found.at;
    double step = w->dir > 0.0 ? open_step * w->size / w->dir : 0.0;

    step = fmin(step, 0.5 * (at[first].t - (first > 0 ? at[first - 1].t : 0.0)));
    return end < w->found.count ? fmin(step, 0.5 * (at[end].t - at[end - 1].t)) : step;
}

/* Open members are where they say, at a point of the ray: a ray may enter them without a crossing. */
static void update_open(csg_traversal *w, double t)
{
    for (uint32_t i = 0; w->tree->open_count > 0 && i < w->asked_count; i++) {
        const uint32_t member = w->scratch->asked[i];
        const csg_member *m = &w->tree->members[member];

        if (m->open && is_inside_at(w, m, t) != w->scratch->inside[member])
            toggle(w, member);
    }
}

/* The earliest patch whose entry would change the tree's value. NULL: none. */
static const pov_crossing *find_patch(csg_traversal *w, uint32_t first, uint32_t end)
{
    const pov_crossing *at = w->found.at, *best = NULL;

    for (uint32_t i = first; i < end; i++) {
        const int32_t before = w->scratch->states[0].value;
        bool changes;

        if (!member_of(w, &at[i])->patch || member_of(w, &at[i])->hidden)
            continue;
        toggle(w, which_of(w, &at[i]));
        changes = w->scratch->states[0].value != before;
        toggle(w, which_of(w, &at[i]));
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

    update_open(w, w->found.at[first].t - step);
    clip(w, first, end, true);
    before = root->value;
    apply(w, first, end);
    update_open(w, w->found.at[end - 1].t + step);
    enters = root->value > before;
    at = root->value != before ? owner_of(w, first, end, enters) : find_patch(w, first, end);
    clip(w, first, end, false);
    if (!at)
        return true;
    if (member_of(w, at)->patch)
        enters = slope_at(w, at) < 0.0;
    return report(at, enters, hits) && !(hits->want == POV_WANT_NEAREST && at->t > hits->tmin);
}

/* False: doubles were not sufficient. Crossings reported so far are right. */
static bool traverse(csg_traversal *w, pov_hits *hits, bool exact)
{
    bool enough = true;

    begin(w, hits, exact);
    for (;;) {
        test_ahead(w);
        enough = !(w->unsure || is_close(w));
        if (!enough || w->scratch->failed || w->applied == w->found.count || w->found.at[w->applied].t > hits->tmax ||
            !pass_point(w, hits))
            break;
    }
    end(w);
    return enough;
}

void csg_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    csg_traversal w = { .tree = ((const csg_root *)self)->tree, .ray = ray };
    const uint32_t count = hits->count;
    double enter;

    if (w.tree->boxed && !hits_box(ray, &w.tree->box, hits->tmax, &enter))
        return;
    w.scratch = ((const csg_user *)hits->user)->scratch;
    w.dir = pov_largest(ray->dir);
    w.size = pov_largest(ray->org) + w.tree->size;
    if (traverse(&w, hits, hits->always_exact))
        return;
    if (hits->want == POV_WANT_ALL)
        hits->count = count;   /* the traversal begins again */
    hits->escalated++;
    traverse(&w, hits, true);
}
