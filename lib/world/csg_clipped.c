/* The first crossing of one surface that convex solids clip, such as an endless one within a sphere. It is the first one between where
 * the ray enters the last of them and where it leaves the first, whatever is inside the surface. Where the solids show as well, as in
 * an intersection, it is one of theirs for a ray that is inside the surface as it enters them, or until it leaves them. Where
 * crossings are too close for doubles, and where more than the first is wanted, csg_intersect.c has the rules. */
#include "world/csg_traversal.h"
#include "world/internal.h"

/* Crossings of the surface are looked for a little beyond the clips. */
static const double beside = 0x1p-41;
/* Slopes below this may have the other sign. */
static const double certain = 0x1p-30;

enum { CROSSINGS = 8 };

/* ---- members ---- */

typedef struct clip_search {
    csg_traversal *w;
    double enter, leave;         /* of all clips but hollows */
    double in[CSG_FEW], out[CSG_FEW];   /* of hollows */
    pov_crossing entry, exit;    /* where they are known in double-double */
    uint32_t escalated;
    bool unsure;
    pov_crossing at[CROSSINGS];
} clip_search;

static void begin(clip_search *s, csg_traversal *w)
{
    s->w = w;
    s->enter = 0.0;
    s->leave = HUGE_VAL;
    s->escalated = 0;
    s->unsure = false;
}

/* For crossings of a member between two distances, into `at`: all, or the first of them. */
static pov_hits hits_between(clip_search *s, const csg_member *m, double from, double to, pov_want want, const pov_hits *hits)
{
    const pov_hits found = { .tmin = from, .tmax = to, .want = want, .at = s->at, .capacity = CROSSINGS, .grow = csg_no_more,
                             .user = hits->user, .scratch = hits->scratch, .owner = s->w->scratch->names + m->leaf };

    return found;
}

/* Counts them; returns how many there are. */
static uint32_t note(clip_search *s, const csg_member *m, const pov_hits *found)
{
    class_counts *classes = s->w->scratch->classes;

    if (classes) {
        classes->of[m->class_number].asked++;
        classes->of[m->class_number].escalated += found->escalated;
    }
    s->escalated += found->escalated;
    s->unsure = s->unsure || found->count == CROSSINGS;
    for (uint32_t i = 0; i < found->count; i++)
        s->unsure = s->unsure || s->at[i].t * s->w->dir <= CSG_SEPARATION * s->w->size;
    return found->count;
}

static uint32_t intersect(clip_search *s, const csg_member *m, const pov_ray *own, double from, double to, pov_want want,
                          const pov_hits *hits)
{
    pov_hits found = hits_between(s, m, from, to, want, hits);

    (m->shape->intersect_between ? m->shape->intersect_between : m->shape->intersect)(m->instance, own, &found);
    return note(s, m, &found);
}

/* Crossings at two distances: is the second one farther? Where that is open the answer does not matter. */
static bool is_before(clip_search *s, double a, double b)
{
    s->unsure = s->unsure || fabs(b - a) <= CSG_SEPARATION * fabs(b);
    return a < b;
}

static const pov_ray *ray_of(const clip_search *s, const csg_member *m, pov_ray *own)
{
    if (!m->xform)
        return s->w->ray;
    instance_ray(m->xform, s->w->ray, own);
    return own;
}

/* False: the ray is never within the clip. */
static bool narrow(clip_search *s, const csg_member *m, const pov_hits *hits)
{
    pov_ray own;
    const uint32_t count = intersect(s, m, ray_of(s, m, &own), 0.0, HUGE_VAL, POV_WANT_ALL, hits);
    const bool in_order = count < 2 || is_before(s, s->at[0].t, s->at[1].t);
    const double in = count < 2 ? 0.0 : s->at[!in_order].t, out = count == 0 ? 0.0 : s->at[count < 2 ? 0 : in_order].t;

    s->unsure = s->unsure || count > 2;
    if (s->unsure || count == 0)
        return false;
    if (in > 0.0 && !(s->enter > 0.0 && is_before(s, in, s->enter))) {
        s->enter = in;
        s->entry = s->at[!in_order];
    }
    if (!isfinite(s->leave) || !is_before(s, s->leave, out)) {
        s->leave = out;
        s->exit = s->at[count < 2 ? 0 : in_order];
    }
    return is_before(s, s->enter, s->leave);
}

/* The first of the surface's crossings within the clips, whose ends are off by less than `off`. NULL: there is none. */
static const pov_crossing *first_of_surface(clip_search *s, uint32_t count, double off)
{
    const pov_crossing *first = NULL;

    for (uint32_t i = 0; i < count; i++) {
        s->unsure = s->unsure || fabs(s->at[i].t - s->enter) < off || fabs(s->at[i].t - s->leave) < off;
        if (is_before(s, s->at[i].t, s->enter) || is_before(s, s->leave, s->at[i].t))
            continue;
        first = !first || is_before(s, s->at[i].t, first->t) ? &s->at[i] : first;
    }
    return first;
}

/* Will this crossing do, whichever is the first? Of a clip that shows, one behind the ray's end says nothing of those before it. */
static bool is_enough(const csg_clipped *c, const pov_crossing *at, const pov_hits *hits)
{
    return hits->want == POV_WANT_ANY && (!c->shown || at->t < hits->tmax - hits->slack);
}

/* By the normal, does the ray enter the solid? False: the slope is too small to tell. */
static bool find_side(const csg_member *m, const pov_ray *own, const pov_vec3 *normal, bool *enters)
{
    const double slope = pov_dot(*normal, own->dir);

    *enters = (slope < 0.0) != m->turned;
    return fabs(slope) > certain * pov_largest(own->dir);
}

/* The same of a surface with gaps, by what it holds on both sides of the crossing, within clips whose ends are off by less than `off`. */
static bool find_open_side(const clip_search *s, const csg_member *m, const pov_crossing *at, double off, bool *enters)
{
    const double step = csg_open_step(s->w, at->t, at->t, HUGE_VAL), far = off + 2.0 * step;
    const bool before = csg_member_holds(s->w, m, at->t - step), after = csg_member_holds(s->w, m, at->t + step);

    *enters = after != m->inverse;
    return before != after && at->t - s->enter > far && s->leave - at->t > far;
}

/* Where the ray is within all clips, in double-double. False: it never is, or not before its end; or that is open. */
static bool narrow_all(clip_search *s, const pov_hits *hits)
{
    const csg_tree *t = s->w->tree;

    for (uint32_t i = 0; i < t->clipped.count; i++)
        if (!narrow(s, &t->members[t->clipped.clip[i]], hits))
            return false;
    return !(s->enter > hits->tmax + hits->slack);
}

/* The same by the outline, all ends off by less than `off`. CSG_OPEN: doubles do not tell. */
static csg_found narrow_by_outline(clip_search *s, const pov_hits *hits, double *off)
{
    const uint32_t hollows = s->w->tree->clipped.hollows;
    csg_intervals k;

    if (!csg_outline_common(s->w->tree->outline, hollows, s->w->ray, &k))
        return CSG_OPEN;
    *off = csg_margin(s->w->tree->outline, &k);
    if (!isfinite(*off))
        return CSG_OPEN;
    s->enter = (k.in[0] - k.start) * k.per_unit;
    s->leave = (k.out[0] - k.start) * k.per_unit;
    for (uint32_t i = 0, left = hollows; left; left &= left - 1, i++) {
        s->in[i] = (k.in[i + 1] - k.start) * k.per_unit;
        s->out[i] = (k.out[i + 1] - k.start) * k.per_unit;
    }
    return s->enter > s->leave + *off || s->leave < -*off || s->enter - *off > hits->tmax + hits->slack ? CSG_NOTHING : CSG_CROSSED;
}

/* Between the ends the ray is inside the surface up to its first crossing, or throughout: a clip's end is the first, if that shows.
 * False: open. */
static bool report_clip(clip_search *s, pov_hits *hits)
{
    const pov_crossing *end;

    begin(s, s->w);
    if (s->w->tree->clipped.loose)
        return false;
    if (!narrow_all(s, hits) || s->unsure)
        return !s->unsure;
    end = s->enter > 0.0 ? &s->entry : &s->exit;
    if (csg_is_unseen(csg_member_at(s->w, end)))
        return false;
    hits->escalated += s->escalated;
    csg_report(end, s->enter > 0.0, hits);
    return true;
}

/* Will any crossing of the surface do that is certainly within the clips? It is then no nearer than it is said to be, and the slack says that
 * it is not at the end. */
static bool is_brief(const clip_search *s, double off, const pov_hits *hits)
{
    const csg_clipped *c = &s->w->tree->clipped;

    return off > 0.0 && hits->want == POV_WANT_ANY && !c->shown && !c->hollows && s->w->tree->members[c->surface].shape->intersect_between;
}

/* For crossings of the surface within clips whose ends are off by less than `off`, or in all of a stretch. */
static pov_hits hits_of_surface(clip_search *s, double from, double to, double off, const pov_hits *hits)
{
    const csg_member *m = &s->w->tree->members[s->w->tree->clipped.surface];
    pov_hits found = hits_between(s, m, from, to, off > 0.0 ? POV_WANT_NEAREST : POV_WANT_ALL, hits);

    if (is_brief(s, off, hits)) {
        found.want = POV_WANT_ANY;
        found.tmax = pov_min(s->leave, hits->tmax);
        found.slack = pov_max(off, hits->slack);
    }
    return found;
}

/* Of ends that are off nothing lies outside of them, and no crossing counts but the first. */
static const pov_crossing *find_first(clip_search *s, const pov_hits *found, double off)
{
    const pov_crossing *first = first_of_surface(s, note(s, &s->w->tree->members[s->w->tree->clipped.surface], found), off);

    s->unsure = s->unsure || found->near_end || (found->want == POV_WANT_ANY && found->count > 0 && !first);
    return first;
}

static bool needs_normal(const clip_search *s, const pov_crossing *first, const pov_hits *hits)
{
    const csg_clipped *c = &s->w->tree->clipped;

    return !s->unsure && first && !s->w->tree->members[c->surface].open && !is_enough(c, first, hits);
}

/* Is a crossing certainly in no hollow, all ends of which are off by less than `off`? */
static bool is_beside_hollows(const clip_search *s, const pov_crossing *at, double off)
{
    bool is_beside = true;

    for (uint32_t i = 0, left = s->w->tree->clipped.hollows; left; left &= left - 1, i++)
        is_beside = is_beside && (s->in[i] > s->out[i] + off || at->t < s->in[i] - off || at->t > s->out[i] + off);
    return is_beside;
}

/* Is the ray inside the surface half way between the ends, where nothing crosses it? Doubles will do there. */
static bool is_inside(const clip_search *s, const csg_member *m, const pov_ray *own)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const double t = 0.5 * (pov_max(s->enter, 0.0) + s->leave);

    return m->shape->inside(m->instance, pov_add(own->org, pov_scale(own->dir, t)), zero) != m->inverse;
}

/* The end of the hollow that certainly holds a crossing; -HUGE_VAL if certainly none does, HUGE_VAL where that is open. */
static double hollow_end(const clip_search *s, const pov_crossing *at, double off)
{
    double end = is_beside_hollows(s, at, off) ? -HUGE_VAL : HUGE_VAL;

    for (uint32_t i = 0, left = s->w->tree->clipped.hollows; left; left &= left - 1, i++)
        if (at->t > s->in[i] + off && at->t < s->out[i] - off)
            end = s->out[i];
    return end;
}

/* The first crossing that no hollow holds, which blocks light. A ray that enters the surface in a hollow may be in it still where the hollow
 * ends: what it crosses next tells. False: open. */
static bool leave_hollows(clip_search *s, const pov_ray *own, double off, const pov_hits *hits, const pov_crossing **first)
{
    const csg_member *m = &s->w->tree->members[s->w->tree->clipped.surface];

    for (int round = 0; round < CROSSINGS && *first; round++) {
        const double end = hollow_end(s, *first, off);
        pov_vec3 normal;
        pov_hits found;
        bool enters;

        if (end == -HUGE_VAL)
            return round == 0 || is_enough(&s->w->tree->clipped, *first, hits);
        m->shape->normal(m->instance, own, *first, &normal);
        if (!(end < s->leave - off && find_side(m, own, &normal, &enters) && enters))
            return false;
        s->enter = end;
        found = hits_of_surface(s, end - off, s->leave + off, off, hits);
        m->shape->intersect_between(m->instance, own, &found);
        *first = find_first(s, &found, off);
        if (s->unsure)
            return false;
    }
    return !*first;
}

/* Where hollows clip too: the first crossing of the surface, if no hollow holds the place. Where these show, nothing does before it if the ray
 * enters the surface there. */
static bool conclude_beside(clip_search *s, const pov_ray *own, const pov_crossing *first, const pov_vec3 *normal, double off, pov_hits *hits)
{
    const csg_clipped *c = &s->w->tree->clipped;
    const csg_member *m = &s->w->tree->members[c->surface];
    bool enough, enters = m->turned;

    if (s->unsure || !(off > 0.0) || (hits->want == POV_WANT_ANY && !leave_hollows(s, own, off, hits, &first)) ||
        (!first && c->shown && is_inside(s, m, own)))
        return false;
    enough = first && is_enough(c, first, hits);
    if (first && !(is_beside_hollows(s, first, off) && (enough || (find_side(m, own, normal, &enters) && (enters || !c->shown)))))
        return false;
    hits->escalated += s->escalated;
    if (first)
        csg_report(first, enters, hits);
    return true;
}

/* Or where nothing but hollows clips, whatever they hold. */
static bool conclude_hollow(clip_search *s, const pov_ray *own, const pov_crossing *first, const pov_vec3 *normal, double off, pov_hits *hits)
{
    return conclude_beside(s, own, first, normal, off, hits) ||
           (off > 0.0 && csg_is_hollowed(s->w->tree) && csg_hollows_first(s->w, s->in, s->out, off, hits));
}

/* Of a surface with gaps, which shows where its inside begins or ends. False: open. */
static bool conclude_open(clip_search *s, const pov_crossing *first, double off, pov_hits *hits)
{
    const csg_member *m = &s->w->tree->members[s->w->tree->clipped.surface];
    bool enters = false;

    if (s->unsure || (first && !find_open_side(s, m, first, off, &enters)))
        return false;
    hits->escalated += s->escalated;
    if (first)
        csg_report(first, enters, hits);
    return true;
}

/* `first`: of the surface, or NULL; `normal`: where that is needed. False: open. */
static bool conclude(clip_search *s, const pov_ray *own, const pov_crossing *first, const pov_vec3 *normal, double off, pov_hits *hits)
{
    const csg_clipped *c = &s->w->tree->clipped;
    const csg_member *m = &s->w->tree->members[c->surface];
    const bool enough = first && is_enough(c, first, hits);
    bool enters = m->turned;

    if (m->open)
        return conclude_open(s, first, off, hits);
    if (c->hollows)
        return conclude_hollow(s, own, first, normal, off, hits);
    if (s->unsure || (first && !enough && !find_side(m, own, normal, &enters)))
        return false;
    hits->escalated += s->escalated;
    if (!first)
        return !c->shown || !is_inside(s, m, own) || report_clip(s, hits);
    if (c->shown && !enough && !enters && s->enter >= -off) {
        if (off > 0.0 && s->enter <= off)
            return false;
        if (s->enter > 0.0)
            return report_clip(s, hits);
    }
    csg_report(first, enters, hits);
    return true;
}

static bool find_between(clip_search *s, double from, double to, double off, pov_hits *hits)
{
    const csg_member *m = &s->w->tree->members[s->w->tree->clipped.surface];
    const pov_crossing *first;
    const pov_ray *ray;
    pov_hits found;
    pov_vec3 normal;
    pov_ray own;

    ray = ray_of(s, m, &own);
    found = hits_of_surface(s, from, to, off, hits);
    (m->shape->intersect_between ? m->shape->intersect_between : m->shape->intersect)(m->instance, ray, &found);
    first = find_first(s, &found, off);
    if (needs_normal(s, first, hits))
        m->shape->normal(m->instance, ray, first, &normal);
    return conclude(s, ray, first, &normal, off, hits);
}

bool csg_clipped_first(csg_traversal *w, pov_hits *hits)
{
    csg_found found = CSG_OPEN;
    clip_search s;
    double off;

    if (w->tree->clipped.outlined && w->tree->clipped.hollows && !w->tree->members[w->tree->clipped.surface].shape->intersect_between)
        return csg_hollowed_first(w, hits);
    begin(&s, w);
    if (w->tree->clipped.outlined)
        found = narrow_by_outline(&s, hits, &off);
    if (found == CSG_NOTHING || (found == CSG_CROSSED && find_between(&s, pov_max(s.enter - off, 0.0), s.leave + off, off, hits)))
        return true;
    if (w->tree->clipped.loose)
        return false;
    begin(&s, w);
    if (!narrow_all(&s, hits))
        return !s.unsure;
    return find_between(&s, s.enter * (1.0 - beside), s.leave * (1.0 + beside), 0.0, hits);
}

/* ---- several rays ---- */

/* Rays that are within all clips for certain, by the caller's number. */
typedef struct clip_searches {
    csg_traversal w[CSG_CLIPPED_MANY];
    clip_search s[CSG_CLIPPED_MANY];
    pov_ray own[CSG_CLIPPED_MANY];
    const pov_ray *rays[CSG_CLIPPED_MANY];
    pov_hits found[CSG_CLIPPED_MANY];
    double off[CSG_CLIPPED_MANY];
    pov_vec3 normal[CSG_CLIPPED_MANY];
} clip_searches;

/* Rays to the surface's own space. */
static void to_own_space(clip_searches *all, const csg_member *m, uint32_t which, const pov_ray *const *rays)
{
    xform_batch instanced;

    instanced.count = 0;
    for (; which; which &= which - 1) {
        const uint32_t i = first_of(which);

        all->rays[i] = m->xform ? &all->own[i] : rays[i];
        if (m->xform)
            xform_batch_add(&instanced, m->xform, rays[i], &all->own[i]);
    }
    xform_batch_apply(&instanced);
}

static void ask_surface(clip_searches *all, const csg_member *m, uint32_t which)
{
    const void *selves[CSG_CLIPPED_MANY];
    const pov_ray *rays[CSG_CLIPPED_MANY];
    pov_hits *hits[CSG_CLIPPED_MANY];
    uint32_t n = 0;

    for (; which; which &= which - 1, n++) {
        selves[n] = m->instance;
        rays[n] = all->rays[first_of(which)];
        hits[n] = &all->found[first_of(which)];
    }
    m->shape->intersect_between_many(selves, rays, hits, n);
}

static void ask_normals(clip_searches *all, const csg_member *m, uint32_t which, const pov_crossing *const *first)
{
    const void *selves[CSG_CLIPPED_MANY];
    const pov_ray *rays[CSG_CLIPPED_MANY];
    const pov_crossing *at[CSG_CLIPPED_MANY];
    pov_vec3 *out[CSG_CLIPPED_MANY];
    uint32_t n = 0;

    for (uint32_t left = which; left; left &= left - 1, n++) {
        const uint32_t i = first_of(left);

        selves[n] = m->instance;
        rays[n] = all->rays[i];
        at[n] = first[i];
        out[n] = &all->normal[i];
    }
    if (n > 0 && m->shape->normal_many)
        m->shape->normal_many(selves, rays, at, out, n);
    for (uint32_t i = 0; !m->shape->normal_many && i < n; i++)
        m->shape->normal(selves[i], rays[i], at[i], out[i]);
}

uint32_t csg_clipped_many(const csg_tree *t, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    const csg_member *m = &t->members[t->clipped.surface];
    const pov_crossing *first[CSG_CLIPPED_MANY];
    uint32_t crossed = 0, nearest = 0, open = 0;
    clip_searches all;

    for (uint32_t i = 0; i < n; i++) {
        clip_search *s = &all.s[i];
        csg_found found;

        csg_traversal_init(&all.w[i], t, rays[i], hits[i]);
        begin(s, &all.w[i]);
        found = narrow_by_outline(s, hits[i], &all.off[i]);
        open |= (uint32_t)(found == CSG_OPEN) << i;
        if (found != CSG_CROSSED)
            continue;
        crossed |= 1u << i;
        all.found[i] = hits_of_surface(s, pov_max(s->enter - all.off[i], 0.0), s->leave + all.off[i], all.off[i], hits[i]);
    }
    if (!crossed)
        return open;
    to_own_space(&all, m, crossed, rays);
    ask_surface(&all, m, crossed);
    for (uint32_t left = crossed; left; left &= left - 1) {
        const uint32_t i = first_of(left);
        clip_search *s = &all.s[i];

        first[i] = find_first(s, &all.found[i], all.off[i]);
        nearest |= (uint32_t)needs_normal(s, first[i], hits[i]) << i;
    }
    ask_normals(&all, m, nearest, first);
    for (uint32_t left = crossed; left; left &= left - 1) {
        const uint32_t i = first_of(left);

        if (!conclude(&all.s[i], all.rays[i], first[i], &all.normal[i], all.off[i], hits[i]))
            open |= 1u << i;
    }
    return open;
}

/* ---- rays that pass the surface ---- */

/* Does a ray that is inside the surface certainly cross it? Then one that passes it is outside. Its end, rounded, lies well outside. */
static bool ends_outside(const csg_member *m, const pov_rays *rays, uint32_t i)
{
    const double t = rays->tmax[i], margin = 0x1p-40 * (rays->size[i] + t * (fabs(rays->dir[0][i]) + fabs(rays->dir[1][i]) + fabs(rays->dir[2][i])));
    const pov_vec3 at = { rays->org[0][i] + t * rays->dir[0][i], rays->org[1][i] + t * rays->dir[1][i], rays->org[2][i] + t * rays->dir[2][i] };

    return m->boxed && (t == HUGE_VAL || at.x > m->box.hi.x + margin || at.y > m->box.hi.y + margin || at.z > m->box.hi.z + margin ||
                        at.x < m->box.lo.x - margin || at.y < m->box.lo.y - margin || at.z < m->box.lo.z - margin);
}

/* Leaves out candidates of the tree that pass its surface, and so whatever else shows of it, by a closer look of the class. */
uint32_t csg_clipped_narrow(const csg_tree *t, const pov_rays *rays, pov_candidate *io, uint32_t n)
{
    const csg_member *m = &t->members[t->clipped.surface];
    const bool shown = t->clipped.shown;
    pov_candidate some[POV_RAYS_MAX];
    uint32_t kept = 0, count = 0, next = 0;
    pov_own_map map;

    if (!m->shape->narrow || !m->xform || !rays->rays || (shown && (m->inverse || m->turned)))
        return n;
    map = (pov_own_map){ m->xform->anchor, { m->xform->column[0], m->xform->column[1], m->xform->column[2] }, m->xform->own_anchor };
    for (uint32_t i = 0; i < n; i++)
        if (!shown || ends_outside(m, rays, io[i].ray))
            some[count++] = io[i];
    count = count > 0 ? m->shape->narrow(m->instance, &map, m->leaf, rays, some, count) : 0;
    for (uint32_t i = 0; i < n; i++) {
        const bool is_asked = !shown || ends_outside(m, rays, io[i].ray), is_kept = next < count && some[next].ray == io[i].ray;

        next += is_kept;
        if (!is_asked || is_kept)
            io[kept++] = io[i];
    }
    return kept;
}
