/* Members of a tree of shapes along a ray: which are near, and where the ray crosses them. */
#include "base/simd.h"
#include "base/vec.h"
#include "world/csg_traversal.h"

#include <string.h>

/* Boxes are tested in doubles. */
static const double box_slack = 0x1p-48;
/* Slopes against a half-space are off by less. */
static const double certain = 0x1p-40;
/* What counts for infinite members begins so much before their boxes. */
static const double beside = 0x1p-40;

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

void csg_measure(const csg_list *all, csg_size *most)
{
    for (uint32_t i = 0; i < all->count; i++) {
        const csg_tree *t = &all->items[i];

        most->nodes = t->node_count > most->nodes ? t->node_count : most->nodes;
        most->members = t->member_count > most->members ? t->member_count : most->members;
    }
}

bool csg_scratch_init(csg_scratch *s, const csg_size *most, const env *e)
{
    const uint32_t nodes = most->nodes, members = most->members;

    s->env = e;
    if (nodes == 0)
        return true;
    s->states = env_alloc(e, nodes, sizeof *s->states);
    s->before = env_alloc(e, nodes, sizeof *s->before);
    s->inside = env_alloc(e, members, sizeof *s->inside);
    s->asked = env_alloc(e, members, sizeof *s->asked);
    s->near = env_alloc(e, 2 * (size_t)members, sizeof *s->near);
    return s->states && s->before && s->inside && s->asked && s->near;
}

void csg_scratch_free(csg_scratch *s)
{
    env_free(s->env, s->crossings);
    env_free(s->env, s->states);
    env_free(s->env, s->before);
    env_free(s->env, s->inside);
    env_free(s->env, s->asked);
    env_free(s->env, s->near);
}

/* ---- values ---- */

void csg_flip(const csg_tree *t, csg_state *states, uint8_t *inside, uint32_t member)
{
    const csg_member *m = &t->members[member];
    uint32_t node = m->node;
    int32_t now = (inside[member] ^= 1) != m->inverse, before = !now;

    for (;;) {
        const csg_node *n = &t->nodes[node];
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

void csg_toggle(csg_traversal *w, uint32_t member)
{
    csg_flip(w->tree, w->scratch->states, w->scratch->inside, member);
}

/* ---- boxes ---- */

static bool narrow(double o, double d, double inverse, double lo, double hi, double *enter, double *leave)
{
    const double a = (lo - o) * inverse, b = (hi - o) * inverse, near = a < b ? a : b, far = a < b ? b : a;

    if (d == 0.0)
        return lo <= o && hi >= o;
    *enter = near > *enter ? near : *enter;
    *leave = far < *leave ? far : *leave;
    return *enter <= *leave;
}

/* The box is widened by more than the slabs are off, which is a few roundings of the largest coordinate. */
bool csg_hits_box(const csg_traversal *w, const pov_box *b, double *enter, double *leave)
{
    const pov_vec3 o = w->ray->org, d = w->ray->dir;
    const double wide = box_slack * w->size;

    *enter = 0.0;
    return narrow(o.x, d.x, w->inverse.x, b->lo.x - wide, b->hi.x + wide, enter, leave) &&
           narrow(o.y, d.y, w->inverse.y, b->lo.y - wide, b->hi.y + wide, enter, leave) &&
           narrow(o.z, d.z, w->inverse.z, b->lo.z - wide, b->hi.z + wide, enter, leave);
}

/* ---- half-spaces of a finite intersection ---- */

/* Where the ray crosses the plane of a cut, and how far that may be off. Within the tree's box, which is all that counts, no
 * coordinate is larger than w->size. */
typedef struct cut_crossing { double slope, t, off; } cut_crossing;

static cut_crossing cross(const csg_traversal *w, const pov_half_space *h)
{
    const double slope = pov_dot(h->normal, w->ray->dir), height = pov_dot(h->normal, w->ray->org) - h->distance;
    const double t = -height / slope;
    const cut_crossing c = { slope, t, box_slack * (w->size / fabs(slope) + fabs(t)) };

    return c;
}

static void narrow_by(const csg_traversal *w, const csg_cut *cut, double *enter, double *leave)
{
    const cut_crossing at = cross(w, &cut->within);

    if (at.slope < 0.0)
        *enter = pov_max(*enter, at.t - at.off);
    else if (at.slope > 0.0)
        *leave = pov_min(*leave, at.t + at.off);
}

/* May the ray be within all of them between these distances? */
static bool hits_cuts(const csg_traversal *w, double enter, double leave)
{
    for (uint32_t i = 0; i < w->tree->cut_count && enter <= leave; i++)
        narrow_by(w, &w->tree->cuts[i], &enter, &leave);
    return enter <= leave;
}

static void insert(csg_traversal *w, uint32_t bound, double t)
{
    csg_near *near = w->scratch->near;
    uint32_t i = w->near_count;

    for (w->near_count++; i > 0 && t < near[(i - 1) / 2].t; i = (i - 1) / 2)
        near[i] = near[(i - 1) / 2];
    near[i].t = t;
    near[i].bound = bound;
}

static void push(csg_traversal *w, uint32_t bound)
{
    double t, leave = HUGE_VAL;

    if (csg_hits_box(w, &w->tree->bounds[bound].box, &t, &leave))
        insert(w, bound, t);
}

/* A component of the direction that is zero has an infinite inverse: planes are then infinitely far, before the ray or
 * behind it. */
static inline void narrow_few(const double *lo, const double *hi, double o, double inverse, double wide, double *enter,
                              double *leave)
{
    for (uint32_t i = 0; i < CSG_FEW; i++) {
        const double a = (lo[i] - wide - o) * inverse, b = (hi[i] + wide - o) * inverse;
        const double near = a < b ? a : b, far = a < b ? b : a;

        enter[i] = near > enter[i] ? near : enter[i];
        leave[i] = far < leave[i] ? far : leave[i];
    }
}

SIMD_CLONES static void enter_few(const csg_few *few, pov_vec3 o, pov_vec3 inverse, double wide, double *enter,
                                  double *leave)
{
    for (uint32_t i = 0; i < CSG_FEW; i++) {
        enter[i] = 0.0;
        leave[i] = HUGE_VAL;
    }
    narrow_few(few->lo[0], few->hi[0], o.x, inverse.x, wide, enter, leave);
    narrow_few(few->lo[1], few->hi[1], o.y, inverse.y, wide, enter, leave);
    narrow_few(few->lo[2], few->hi[2], o.z, inverse.z, wide, enter, leave);
}

void csg_enter_few(const csg_traversal *w, const csg_few *few, double *enter, double *leave)
{
    enter_few(few, w->ray->org, w->inverse, box_slack * w->size, enter, leave);
}

static void push_few(csg_traversal *w, const csg_few *few)
{
    SIMD_ALIGNED double enter[CSG_FEW], leave[CSG_FEW];

    csg_enter_few(w, few, enter, leave);
    for (uint32_t i = 0; i < few->count; i++)
        if (enter[i] <= leave[i])
            insert(w, few->bound[i], enter[i]);
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

/* Cosine between the ray and the normal, times the length of the direction. */
double csg_slope(const csg_traversal *w, const pov_crossing *at)
{
    const csg_member *m = csg_member_at(w, at);
    pov_vec3 normal;

    if (m->xform)
        instance_normal(m->xform, m->shape, m->instance, w->ray, at, &normal);
    else
        m->shape->normal(m->instance, w->ray, at, &normal);
    return pov_dot(normal, w->ray->dir);
}

static double cosine_at(const csg_traversal *w, const pov_crossing *at) { return fabs(csg_slope(w, at)); }

bool csg_is_behind(const csg_traversal *w, const pov_crossing *at)
{
    return at->t * cosine_at(w, at) <= CSG_SAME_POINT * w->size;
}

/* A surface that coincides with the ray's origin surface is behind the ray. */
static bool is_behind(csg_traversal *w, const pov_crossing *at)
{
    if (!(at->t * w->dir <= CSG_SEPARATION * w->size))
        return false;
    if (!w->found.always_exact) {
        w->unsure = true;
        return false;
    }
    return csg_is_behind(w, at);
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

bool csg_member_holds(const csg_traversal *w, const csg_member *m, double t)
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
        t = pov_max(t, w->found.at[i].t);
    return csg_member_holds(w, m, 2.0 * t);
}

/* The part of the ray that counts for an infinite member. */
typedef struct stretch { double from, to; } stretch;

/* Is the ray inside where a stretch begins? Tested in the middle of the widest gap between crossings, which are in order. */
static bool begins_inside(const csg_traversal *w, const csg_member *m, uint32_t first, const stretch *in)
{
    const uint32_t count = w->found.count;
    double at = 0.0, widest = -1.0, before = in->from;
    bool odd = false;

    for (uint32_t i = first; i <= count; i++) {
        const double next = i < count ? w->found.at[i].t : in->to;

        if (next - before > widest) {
            widest = next - before;
            at = before + 0.5 * widest;
            odd = (i - first) & 1;
        }
        before = next;
    }
    return csg_member_holds(w, m, at) != odd;
}

static bool comes_before(const pov_crossing *a, const pov_crossing *b)
{
    if (a->t != b->t)
        return a->t < b->t;
    if (a->t_lo != b->t_lo)
        return a->t_lo < b->t_lo;
    return a->owner < b->owner;
}

void csg_put_in_order(csg_traversal *w, uint32_t first, uint32_t least)
{
    pov_crossing *at = w->found.at;

    for (uint32_t i = first, j; i < w->found.count; i++) {
        const pov_crossing c = at[i];

        for (j = i; j > least && comes_before(&c, &at[j - 1]); j--)
            at[j] = at[j - 1];
        at[j] = c;
    }
}

uint32_t csg_name_of(const csg_traversal *w, const csg_member *m)
{
    const uint32_t from = csg_which(w, w->ray->origin_surface);

    return from < w->tree->member_count && w->tree->members[from].same == m->same ? w->ray->origin_surface
                                                                                    : w->scratch->names + m->leaf;
}

static void count(const csg_traversal *w, const csg_member *m, uint32_t escalated)
{
    class_counts *classes = w->scratch->classes;

    if (classes) {
        classes->of[m->class_number].asked++;
        classes->of[m->class_number].escalated += escalated;
    }
}

void csg_intersect_member(const csg_traversal *w, const csg_member *m, pov_hits *found)
{
    const uint32_t escalated = found->escalated;

    if (m->xform)
        instance_intersect(m->xform, m->shape, m->instance, w->ray, found);
    else
        m->shape->intersect(m->instance, w->ray, found);
    count(w, m, found->escalated - escalated);
}

/* Of an infinite member between two distances. */
static void intersect_between(const csg_traversal *w, const csg_member *m, const stretch *in, pov_hits *found)
{
    const uint32_t escalated = found->escalated;
    pov_ray own;

    found->tmin = in->from;
    found->tmax = in->to;
    if (m->xform)
        instance_ray(m->xform, w->ray, &own);
    m->shape->intersect_between(m->instance, m->xform ? &own : w->ray, found);
    found->tmin = 0.0;
    found->tmax = HUGE_VAL;
    count(w, m, found->escalated - escalated);
}

static void intersect(csg_traversal *w, const csg_member *m, const stretch *in)
{
    const uint32_t first = w->found.count;

    w->found.owner = csg_name_of(w, m);
    if (in)
        intersect_between(w, m, in, &w->found);
    else
        csg_intersect_member(w, m, &w->found);
    for (uint32_t i = first; i < w->found.count; i++)
        w->found.at[i].owner = w->scratch->names + m->leaf;
}

/* Of clips with gaps nothing counts but what is inside where others are crossed.
 *
 * All crossings of a member ahead; the parity of their number tells whether the ray starts inside it. cut: its crossing,
 * of a half-space that the tree is within; or NULL. in: crossings between two distances alone, and whether the first one is inside; or NULL. */
static void test_member(csg_traversal *w, uint32_t member, const cut_crossing *cut, const stretch *in)
{
    const csg_member *m = &w->tree->members[member];
    const uint32_t first = w->found.count;
    bool inside;

    w->scratch->asked[w->asked_count++] = member;
    if (m->open && m->hidden && !w->whole)
        return;
    intersect(w, m, in);
    drop_behind(w, first);
    if (in)
        csg_put_in_order(w, first, first);
    inside = !m->patch && !m->open && (in ? begins_inside(w, m, first, in) : (w->found.count - first) & 1);
    if (!in && !m->boxed && !m->patch && !m->open)
        inside = inside != (cut && fabs(cut->slope) > certain * w->dir ? (cut->slope < 0.0) != m->inverse : ends_inside(w, m, first));
    w->missed = w->missed || (m->needed && !m->open && !inside && w->found.count == first);
    if (inside)
        csg_toggle(w, member);
    csg_put_in_order(w, first, w->applied);
}

/* The ray is within a cut wherever it is within the others and the tree's box. */
static void hold(csg_traversal *w, uint32_t member)
{
    w->scratch->asked[w->asked_count++] = member;
    if (!w->tree->members[member].inverse)
        csg_toggle(w, member);
}

/* The ray is within the intersection from the last entry into a cut, or the tree's box, to the first exit from one: other
 * crossings change nothing. */
static void test_cuts(csg_traversal *w)
{
    const csg_tree *t = w->tree;
    double enter = w->enter, leave = w->leave;

    for (uint32_t i = 0; i < t->cut_count; i++)
        narrow_by(w, &t->cuts[i], &enter, &leave);
    for (uint32_t i = 0; i < t->cut_count; i++) {
        const cut_crossing at = cross(w, &t->cuts[i].within);

        if (at.slope < 0.0 ? at.t + at.off < enter : at.slope > 0.0 && at.t - at.off > leave)
            hold(w, t->cuts[i].member);
        else
            test_member(w, t->cuts[i].member, &at, NULL);
    }
}

/* Infinite members, those that are open or others; those of parts that the ray misses, or comes to beyond its end, stay outside. */
static void test_endless(csg_traversal *w, bool open, double end)
{
    const csg_tree *t = w->tree;

    for (uint32_t i = 0; i < t->endless_count && !w->missed; i++) {
        const csg_endless *of = &t->endless[i];
        const csg_member *m = &t->members[of->member];
        double enter = w->enter, leave = end;

        if (m->open == open && (!of->boxed || csg_hits_box(w, &of->box, &enter, &leave))) {
            const stretch in = { enter * (1.0 - beside), leave * (1.0 + beside) };
            const bool is_part = t->boxed && !m->open && !m->patch && m->shape->intersect_between && in.to < HUGE_VAL;

            test_member(w, of->member, NULL, is_part ? &in : NULL);
        }
    }
}

/* ---- in order ---- */

void csg_traversal_init(csg_traversal *w, const csg_tree *tree, const pov_ray *ray, const pov_hits *hits)
{
    w->tree = tree;
    w->ray = ray;
    w->scratch = ((const csg_user *)hits->user)->scratch;
    w->dir = pov_largest(ray->dir);
    w->size = pov_largest(ray->org) + tree->size;
    w->inverse = pov_vec3_of(1.0 / ray->dir.x, 1.0 / ray->dir.y, 1.0 / ray->dir.z);
}

bool csg_traversal_hits_box(csg_traversal *w)
{
    w->enter = 0.0;
    w->leave = HUGE_VAL;
    return !w->tree->boxed || csg_hits_box(w, &w->tree->box, &w->enter, &w->leave);
}

/* May it cross what shows, where that counts? */
static bool hits_shown(const csg_traversal *w, const pov_hits *hits)
{
    const csg_tree *t = w->tree;
    double enter = w->enter, leave = w->leave;

    return (t->boxed || !t->shows_boxed || csg_hits_box(w, &t->shown, &enter, &leave)) && enter <= hits->tmax + hits->slack && leave >= hits->tmin;
}

bool csg_traversal_enters(csg_traversal *w, const pov_hits *hits)
{
    return csg_traversal_hits_box(w) && hits_shown(w, hits) && (!w->tree->boxed || hits_cuts(w, w->enter, pov_min(w->leave, hits->tmax)));
}

void csg_traversal_begin(csg_traversal *w, const pov_hits *hits, bool exact)
{
    const csg_tree *t = w->tree;
    csg_scratch *s = w->scratch;

    memset(&w->found, 0, sizeof w->found);
    w->found.tmax = HUGE_VAL;
    w->found.want = POV_WANT_ALL;
    w->found.always_exact = exact;
    w->found.unfiltered = hits->unfiltered;
    w->found.at = s->crossings;
    w->found.capacity = s->capacity;
    w->found.grow = grow;
    w->found.user = hits->user;
    w->found.scratch = hits->scratch;
    w->applied = w->asked_count = w->near_count = 0;
    w->unsure = w->missed = w->grazes = false;
    memcpy(s->states, t->outside, t->node_count * sizeof *s->states);
    /* Others may miss the tree, and need not ask whether points are inside. */
    test_endless(w, false, pov_min(w->leave, hits->tmax + hits->slack));
    if (t->open_count > 0)
        test_endless(w, true, pov_min(w->leave, hits->tmax + hits->slack));
    if (w->missed)
        return;
    test_cuts(w);
    for (uint32_t i = 0; i < t->many_count; i++)
        push_few(w, &t->many[i]);
    if (t->few.count > 0)
        push_few(w, &t->few);
    else if (!t->many && t->bounds_count > 0)
        push(w, 0);
}

void csg_traversal_end(csg_traversal *w)
{
    for (uint32_t i = 0; i < w->asked_count; i++)
        w->scratch->inside[w->scratch->asked[i]] = 0;
}

/* Open bounds until the next crossing is before all remaining bounds. */
void csg_test_ahead(csg_traversal *w)
{
    while (w->near_count > 0 && !w->missed) {
        const csg_bound *b;
        uint32_t which;

        if (w->applied < w->found.count && w->found.at[w->applied].t * (1.0 + 0x1p-40) < w->scratch->near[0].t)
            return;
        which = pop(w);
        b = &w->tree->bounds[which];
        if (b->other == 0) {
            test_member(w, b->member, NULL, NULL);
        } else {
            push(w, which + 1);
            push(w, b->other);
        }
    }
}
