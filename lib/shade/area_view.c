#include "shade/area_view.h"

#include "base/vec3.h"

/* The light's plane from a point: the point to + u axes[0] + v axes[1] lies in the direction x with
 * u = of[0] . x / (across . x), v = of[1] . x / (across . x). */
typedef struct plane {
    pov_vec3 from, to, axes[2], across, of[2];
    double size, least;          /* least: of across . x, for x of a length of one */
} plane;

/* Of what is too slanted, or too near the point, less is said. So all that is projected has errors below 2^-14. */
static const double slanted = 0x1p-16, near_by = 0x1p-8, thin = 0x1p-14, small = 0x1p-10;
/* Wider than these by far, in widths of the light. */
static const double margin = 0x1p-8;

static bool make_plane(const light *l, pov_vec3 from, pov_vec3 to, plane *p)
{
    double across;

    p->from = from;
    p->to = to;
    grid_axes(l, to, p->axes);
    p->across = pov_cross_product(p->axes[0], p->axes[1]);
    p->of[0] = pov_cross_product(p->axes[1], to);
    p->of[1] = pov_cross_product(to, p->axes[0]);
    if (pov_dot(p->across, to) < 0.0) {
        p->across = pov_scale(p->across, -1.0);
        p->of[0] = pov_scale(p->of[0], -1.0);
        p->of[1] = pov_scale(p->of[1], -1.0);
    }
    p->size = vec3_sum(from) + vec3_sum(to);
    across = vec3_sum(p->across);
    p->least = slanted * across;
    return across > thin * vec3_sum(to) * (vec3_sum(p->axes[0]) + vec3_sum(p->axes[1])) && p->size < 1e60;
}

static void widen(grid_part *part)
{
    for (int axis = 0; axis < 2; axis++) {
        part->lo[axis] -= margin * (1.0 + fabs(part->lo[axis]));
        part->hi[axis] += margin * (1.0 + fabs(part->hi[axis]));
    }
}

/* Bounds of one axis by the corners of a box, of which some may lie behind the point. All before it are at u or farther if
 * the plane through the point and the light's line u has all corners on one side: that is an interval of u. */
typedef struct bounds { double first, last, least_behind, most_behind; bool open_below, open_above; } bounds;

static void add_corner(const plane *p, int axis, const grid_part *all, pov_vec3 x, bounds *b)
{
    const double depth = pov_dot(p->across, x), along = pov_dot(p->of[axis], x);
    const double least = p->least * (vec3_sum(x) + near_by * p->size), u = along / depth;

    if (depth > least) {
        b->first = u < b->first ? u : b->first;
        b->last = u > b->last ? u : b->last;
    } else if (depth < -least) {
        b->least_behind = u < b->least_behind ? u : b->least_behind;
        b->most_behind = u > b->most_behind ? u : b->most_behind;
    } else {
        const double doubt = 4.0 * least * (1.0 + fabs(all->lo[axis]) + fabs(all->hi[axis]));

        b->open_below = b->open_below || !(along > doubt);
        b->open_above = b->open_above || !(-along > doubt);
    }
}

static void project_box(const plane *p, const grid_part *all, const pov_box *box, grid_part *out)
{
    for (int axis = 0; axis < 2; axis++) {
        bounds b = { HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL, false, false };

        for (int i = 0; i < 8; i++) {
            const pov_vec3 at = pov_vec3_of(i & 1 ? box->hi.x : box->lo.x, i & 2 ? box->hi.y : box->lo.y,
                                            i & 4 ? box->hi.z : box->lo.z);

            add_corner(p, axis, all, pov_sub(at, p->from), &b);
        }
        out->lo[axis] = !b.open_below && b.first - b.most_behind > margin ? b.first : -HUGE_VAL;
        out->hi[axis] = !b.open_above && b.least_behind - b.last > margin ? b.last : HUGE_VAL;
    }
}

/* A plane through the point and a line u = constant of the light has the normal m = of - u across. It leaves the sphere
 * around c on one side where (m . c)^2 > r^2 m . m: outside of two values of u if the sphere is before the point, and between
 * them if it reaches behind it. */
static bool project_axis(const plane *p, int axis, pov_vec3 c, double r, grid_part *out)
{
    const double oc = pov_dot(p->of[axis], c), ac = pov_dot(p->across, c), rr = r * r, aa = pov_dot(p->across, p->across);
    const double a = ac * ac - rr * aa, b = oc * ac - rr * pov_dot(p->of[axis], p->across);
    const double d = b * b - a * (oc * oc - rr * pov_dot(p->of[axis], p->of[axis]));
    const double root = sqrt(d > 0.0 ? d : 0.0), first = (b - root) / a, second = (b + root) / a;

    if (!(fabs(a) > thin * (ac * ac + rr * aa)) || (a > 0.0 && !(ac > 0.0 && d > 0.0)))
        return false;
    out->lo[axis] = a > 0.0 ? first : -HUGE_VAL;
    out->hi[axis] = a > 0.0 ? second : HUGE_VAL;
    if (a < 0.0 && d > 0.0) {
        if (oc - b / a * ac > 0.0)
            out->lo[axis] = first;
        else
            out->hi[axis] = second;
    }
    return true;
}

static bool project_sphere(const plane *p, const pov_box *b, grid_part *out)
{
    const pov_vec3 c = pov_sub(pov_scale(pov_add(b->lo, b->hi), 0.5), p->from);
    const double r = 0.5 * (b->hi.x - b->lo.x) * (1.0 + margin);

    return r > small * p->size && project_axis(p, 0, c, r, out) && project_axis(p, 1, c, r, out);
}

/* Places of one axis that may lie beyond a plane, `height` of it at the light's middle and `rise` along the axes. */
static void cut_axis(double height, const double rise[2], int axis, const grid_part *all, grid_part *out)
{
    const int other = 1 - axis;
    const double least = height + pov_min(rise[other] * all->lo[other], rise[other] * all->hi[other]), at = -least / rise[axis];

    out->lo[axis] = rise[axis] < 0.0 ? at : -HUGE_VAL;
    out->hi[axis] = rise[axis] > 0.0 ? at : HUGE_VAL;
}

/* A plane hides what lies beyond it, seen from the point: all of it if the point may lie on the plane. */
static void project_plane(const plane *p, const grid_part *all, const pov_half_space *h, grid_part *out)
{
    const double start = pov_dot(h->normal, p->from) - h->distance, side = start < 0.0 ? -1.0 : 1.0;
    const double doubt = thin * thin * (p->size + vec3_sum(p->axes[0]) + vec3_sum(p->axes[1]) + fabs(h->distance));
    const double height = side * (start + pov_dot(h->normal, p->to)) - doubt;
    const double rise[2] = { side * pov_dot(h->normal, p->axes[0]), side * pov_dot(h->normal, p->axes[1]) };

    for (int axis = 0; axis < 2; axis++) {
        out->lo[axis] = -HUGE_VAL;
        out->hi[axis] = HUGE_VAL;
        if (fabs(start) > doubt && fabs(rise[axis]) > doubt)
            cut_axis(height, rise, axis, all, out);
    }
}

/* Where the light may be hidden. */
static grid_part shadow_of(const plane *p, const grid_part *all, const blocker *b)
{
    grid_part out;

    if (b->is_plane)
        project_plane(p, all, &b->plane, &out);
    else if (!b->is_sphere || !project_sphere(p, &b->box, &out))
        project_box(p, all, &b->box, &out);
    widen(&out);
    return out;
}

/* ---- what holds all of it ----
 *
 * No segment between points well inside a convex solid meets its surface. */

static bool sphere_holds(const plane *p, const pov_box *b, const pov_vec3 corner[4])
{
    const pov_vec3 c = pov_sub(pov_scale(pov_add(b->lo, b->hi), 0.5), p->from);
    const double r = 0.5 * (b->hi.x - b->lo.x), most = (1.0 - margin) * r * r;
    bool within = r > thin * p->size && pov_dot(c, c) < most;

    for (int i = 0; i < 4; i++) {
        const pov_vec3 to = pov_sub(corner[i], c);

        within = within && pov_dot(to, to) < most;
    }
    return within;
}

static bool box_holds(const shaft *s, const pov_box *b)
{
    const pov_vec3 size = pov_scale(pov_sub(b->hi, b->lo), margin), lo = pov_add(b->lo, size), hi = pov_sub(b->hi, size);
    const double least = thin * margin * s->size;

    return size.x > least && size.y > least && size.z > least && s->lo.x > lo.x && s->lo.y > lo.y && s->lo.z > lo.z && s->hi.x < hi.x && s->hi.y < hi.y && s->hi.z < hi.z;
}

static bool holds(const plane *p, const shaft *s, const blocker *b)
{
    return b->is_sphere ? sphere_holds(p, &b->box, s->corner) : b->is_box && box_holds(s, &b->box);
}

/* ---- all of it ---- */

typedef struct finding { plane plane; grid_part all; shaft shaft; const area_start *start; area_view *out; } finding;

/* The side of a normal that all of the shaft goes to, with more than the errors of roundings; 0: that is in doubt. */
static int side_of(const shaft *s, pov_vec3 normal)
{
    bool up = true, down = true;

    for (int i = 0; i < 4; i++) {
        const double along = pov_dot(s->corner[i], normal), least = WORLD_GRAZING * vec3_sum(s->corner[i]);

        up = up && along > least;
        down = down && -along > least;
    }
    return (up ? 1 : 0) - (down ? 1 : 0);
}

/* Do all rays start on the object, which is closed and convex, and go to one side of each surface that they start on? Then they cross the
 * same ones at once, and those that go into the object leave it once, from its edges too. */
static bool are_of_one_side(const finding *f, uint32_t object)
{
    const area_start *s = f->start;
    bool is_on = false;

    if (!s->on)
        return s->at->object == object && side_of(&f->shaft, s->normal) != 0;
    for (uint32_t i = 0; i < s->on->count; i++) {
        if (side_of(&f->shaft, s->on->at[i].normal) == 0)
            return false;
        is_on = is_on || s->on->at[i].object == object;
    }
    return is_on;
}

/* Is all of the light outside of a box? */
static bool is_beyond(const finding *f, const pov_box *b)
{
    const pov_vec3 from = f->plane.from, *corner = f->shaft.corner;
    const double gap = near_by * f->plane.size;
    bool beyond[6] = { true, true, true, true, true, true };

    for (int i = 0; i < 4; i++) {
        const pov_vec3 p = pov_add(from, corner[i]);
        const bool at[6] = { p.x > b->hi.x + gap, p.y > b->hi.y + gap, p.z > b->hi.z + gap, p.x < b->lo.x - gap, p.y < b->lo.y - gap, p.z < b->lo.z - gap };

        for (int k = 0; k < 6; k++)
            beyond[k] = beyond[k] && at[k];
    }
    return beyond[0] || beyond[1] || beyond[2] || beyond[3] || beyond[4] || beyond[5];
}

static bool find_ring(const finding *f, const blocker *b, area_ring *out)
{
    const plane *p = &f->plane;
    area_cover clip, hollow;

    return (!b->clipped || area_cover_make(&clip, &b->clip, p->from, p->to, p->axes)) &&
           (!b->ring->hollowed || area_cover_make(&hollow, &b->ring->hollow, p->from, p->to, p->axes)) &&
           area_ring_make(out, b->ring->radii, &b->ring->own, p->from, p->to, p->axes, b->clipped ? &clip : NULL, b->ring->hollowed ? &hollow : NULL);
}

static void find_cover(const finding *f, const blocker *b, area_shadow *out)
{
    area_view *view = f->out;

    out->ring = b->ring && view->rings < AREA_RINGS_MAX && find_ring(f, b, &view->ring[view->rings]) ? view->rings + 1 : 0;
    out->outlined = b->outlined && area_cover_make(&out->cover, &b->solid, f->plane.from, f->plane.to, f->plane.axes);
    out->hides = (out->outlined || out->ring) && b->hides;
    out->dims = out->outlined && b->dims && is_beyond(f, &b->box);
    out->leaves = out->dims && are_of_one_side(f, b->object);
    out->tree = b->tree;
    out->unaided = !b->tree || b->unaided;
}

/* Do all rays start on a member's surface, and leave what it shows within before they meet it again? */
static bool leaves_clip(const finding *f, const blocker *b, const area_shadow *s)
{
    const area_start *start = f->start;
    area_cover clip;

    return b->clipped && s->outlined && !start->on && start->at->object == b->object &&
           area_cover_make(&clip, &b->clip, f->plane.from, f->plane.to, f->plane.axes) && area_cover_holds(&s->cover, &clip, &f->all);
}

/* hidden: do all certainly cross a ring? */
static bool misses(const area_view *v, const area_shadow *s, const grid_part *all, bool *hidden)
{
    *hidden = false;
    return s->ring ? area_ring_misses(&v->ring[s->ring - 1], all, hidden) : s->outlined && area_cover_misses(&s->cover, all);
}

static bool add_blocker(void *user, const blocker *b)
{
    finding *f = user;
    area_view *out = f->out;
    area_shadow s = { .part = shadow_of(&f->plane, &f->all, b) };
    bool hidden;

    if (!grid_parts_overlap(&s.part, &f->all) || holds(&f->plane, &f->shaft, b))
        return true;
    find_cover(f, b, &s);
    if (misses(out, &s, &f->all, &hidden) || leaves_clip(f, b, &s))
        return true;
    out->dark = s.hides && s.unaided && (hidden || (s.outlined && area_cover_hides(&s.cover, &f->all)));
    if (out->dark || out->count == AREA_VIEW_MAX)
        return false;
    out->rings += s.ring ? 1 : 0;
    out->shadows[out->count++] = s;
    return true;
}

/* The object that all rays leave, and whether outward, as world_origin_aim() has it. */
static departure find_left(const finding *f)
{
    const hit *h = f->start->at;

    return (departure){ h->object, side_of(&f->shaft, f->start->normal) == (h->outside ? 1 : -1) };
}

static bool make_shaft(const plane *p, const grid_part *all, shaft *s)
{
    pov_vec3 corner[4];

    for (int i = 0; i < 4; i++) {
        const double u = (i + 1) & 2 ? all->hi[0] : all->lo[0], v = i & 2 ? all->hi[1] : all->lo[1];

        corner[i] = pov_add(p->to, pov_add(pov_scale(p->axes[0], u), pov_scale(p->axes[1], v)));
    }
    return shaft_make(s, p->from, corner);
}

/* Something else may hide all of it; and some members of trees are not known. */
static void hide_all(area_view *out)
{
    area_shadow *s = &out->shadows[out->count < AREA_VIEW_MAX ? out->count++ : AREA_VIEW_MAX - 1];

    for (uint32_t i = 0; i < out->count; i++)
        out->shadows[i].hides = out->shadows[i].hides && out->shadows[i].unaided;
    s->part = (grid_part){ { -HUGE_VAL, -HUGE_VAL }, { HUGE_VAL, HUGE_VAL } };
    s->outlined = s->hides = s->dims = s->leaves = false;
    s->ring = 0;
    s->tree = 0;
}

void area_view_find(const shading *scene, const scene_light *from, const area_start *start, pov_vec3 to, area_view *out)
{
    finding f = { .all = from->grid->all, .start = start, .out = out };

    out->dark = false;
    out->count = out->rings = 0;
    if ((!make_plane(from->light, start->at->point, to, &f.plane) || !make_shaft(&f.plane, &f.all, &f.shaft) ||
         !query_blockers(scene->world, &f.shaft, find_left(&f), add_blocker, &f)) && !out->dark)
        hide_all(out);
}

/* Parts that it may hide; and of a ring those that it certainly does. */
static uint64_t open_of(const area_view *v, const area_shadow *s, const area_parts *parts, uint64_t *hidden)
{
    const uint64_t may = area_parts_overlap(parts, &s->part);

    *hidden = 0;
    if (may && s->ring)
        return may & ~area_ring_misses_of(&v->ring[s->ring - 1], parts, may, hidden);
    return may && s->outlined ? may & ~area_cover_misses_of(&s->cover, parts, may) : may;
}

/* Of these parts, those that the i-th shadow certainly hides; may: those that each may; hidden: those that it does if it is a ring. */
static uint64_t hidden_of(const area_view *v, uint32_t i, const area_parts *parts, const uint64_t *may, uint64_t hidden, uint64_t which)
{
    const uint32_t tree = v->shadows[i].tree;
    uint64_t hollow = 0;

    for (uint32_t k = 0; !v->shadows[i].unaided && k < v->count; k++)
        hollow |= k != i && v->shadows[k].tree == tree ? may[k] : 0;
    which &= may[i] & ~hollow;
    if (v->shadows[i].ring)
        return which & hidden;
    return which ? area_cover_hides_of(&v->shadows[i].cover, parts, which) : 0;
}

/* Of these parts, those that all segments to cross the i-th shadow's solid alike, and nothing else. */
static uint64_t alike_of(const area_view *v, uint32_t i, const area_parts *parts, const uint64_t *may, uint64_t which)
{
    for (uint32_t k = 0; k < v->count; k++)
        which &= k == i ? may[k] : ~may[k];
    return which && !v->shadows[i].leaves ? area_cover_hides_of(&v->shadows[i].cover, parts, which) : which;
}

/* Of a tree nothing may hide where the member that all of it lies in does not. */
static void keep_within(const area_view *v, uint64_t *may)
{
    for (uint32_t i = 0; i < v->count; i++)
        for (uint32_t k = 0; v->shadows[i].tree && v->shadows[i].hides && k < v->count; k++)
            may[k] &= v->shadows[k].tree == v->shadows[i].tree ? may[i] : ~(uint64_t)0;
}

area_states area_view_open(const area_view *v, const area_parts *parts)
{
    area_states out = { 0, 0, 0 };
    uint64_t may[AREA_VIEW_MAX], hidden[AREA_VIEW_MAX];

    for (uint32_t i = 0; i < v->count; i++)
        may[i] = open_of(v, &v->shadows[i], parts, &hidden[i]);
    keep_within(v, may);
    for (uint32_t i = 0; i < v->count; i++)
        out.open |= may[i];
    out.lit = area_parts_all(parts) & ~out.open;
    for (uint32_t i = 0; out.open && i < v->count; i++)
        if (v->shadows[i].hides)
            out.open &= ~hidden_of(v, i, parts, may, hidden[i], out.open);
    for (uint32_t i = 0; out.open && i < v->count && !out.alike; i++)
        if (v->shadows[i].dims)
            out.alike = alike_of(v, i, parts, may, out.open);
    return out;
}
