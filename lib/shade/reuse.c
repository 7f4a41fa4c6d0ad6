#include "shade/reuse.h"

#include "base/lane_mask.h"
#include "base/simd.h"
#include "base/vec3.h"
#include "shade/gather.h"

static const double inverse_pi = 0.31830988618379067;

/* ---- where rays start ---- */

void reuse_put(reuse *r, uint32_t n, const batch *from, uint32_t i, const guide_views *above, uint32_t lamps)
{
    const gather_origins *g = from->gather;

    lanes_put(&r->start, n, from->own[i].org);
    lanes_put(&r->normal, n, lanes_at(&g->normal, i));
    lanes_put(&r->face, n, lanes_at(&g->face, i));
    r->rays[n] = from->own[i];
    r->outside[n] = g->outside[i] != g->behind[i];
    r->from_object[n] = from->own[i].origin_surface;
    r->guided[n] = above->count > 0;
    for (uint32_t k = 0; k < lamps; k++)
        r->lamps[k][n] = 0.0;
    for (uint32_t k = 0; k < above->count; k++) {
        r->lamps[above->of[k].lamp][n] = above->of[k].share / above->of[k].whole;
        r->lamps_seen |= (uint64_t)1 << above->of[k].lamp;
    }
}

/* ---- what rays find ---- */

/* Is all that is seen of it the same from everywhere on this side? */
static bool is_even(const shading *scene, const surface *s)
{
    const object_info *o = shading_info(scene, s->at->object);

    return !o->smooth && s->appearance != &scene->unseen && shading_constant(scene, s->at->object)->even;
}

void reuse_note(const shade_context *c, const surfaces *on, reuse *r)
{
    for (uint32_t i = 0; i < on->count; i++) {
        const surface *s = &on->at[i];
        const pov_vec3 normal = lanes_at(&on->geometry.to.normal, i);
        const uint32_t lane = s->from->lane;

        r->found[lane] = !r->below[lane] && is_even(c->scene, s) ? REUSE_PLACE : REUSE_NOTHING;
        r->object[lane] = s->at->object;
        r->out[lane] = s->at->outside;
        lanes_put(&r->end, lane, s->at->point);
        lanes_put(&r->end_normal, lane, pov_dot(normal, s->ray->dir) > 0.0 ? pov_scale(normal, -1.0) : normal);
    }
}

/* ---- weights ---- */

SIMD_CLONES static void find_kernels(const reuse *r, weights *w)
{
    for (uint32_t i = w->from; i < w->to; i++) {
        const double x = w->at.x - r->start.x[i], y = w->at.y - r->start.y[i], z = w->at.z - r->start.z[i];
        const double square = x * x + y * y + z * z;
        const double along = x * r->normal.x[i] + y * r->normal.y[i] + z * r->normal.z[i];
        const double face = x * r->face.x[i] + y * r->face.y[i] + z * r->face.z[i];
        const double facing = -(x * w->normal.x + y * w->normal.y + z * w->normal.z);
        const double kernel = along * facing * inverse_pi / (square * square);

        w->x[i] = x;
        w->y[i] = y;
        w->z[i] = z;
        w->facing[i] = facing;
        w->kernel[i] = ((along > 0.0) & (face > 0.0) & (facing > 0.0)) ? kernel : 0.0;
    }
}

/* The same of the sky: by solid angle, and the place is a direction. */
SIMD_CLONES static void find_sky_kernels(const reuse *r, weights *w)
{
    for (uint32_t i = w->from; i < w->to; i++) {
        const double along = w->at.x * r->normal.x[i] + w->at.y * r->normal.y[i] + w->at.z * r->normal.z[i];
        const double face = w->at.x * r->face.x[i] + w->at.y * r->face.y[i] + w->at.z * r->face.z[i];

        w->x[i] = w->at.x;
        w->y[i] = w->at.y;
        w->z[i] = w->at.z;
        w->facing[i] = 1.0;
        w->kernel[i] = ((along > 0.0) & (face > 0.0)) ? along * inverse_pi : 0.0;
    }
}

/* By one axis: where a line enters and leaves the slab, and the component of its direction across the face. */
SIMD_INLINE void cut(double lo, double hi, double d, double *enters, double *leaves, double *across)
{
    const double a = lo / d, b = hi / d, near = a < b ? a : b, far = a < b ? b : a;

    *across = near > *enters ? fabs(d) : *across;
    *enters = near > *enters ? near : *enters;
    *leaves = far < *leaves ? far : *leaves;
}

/* Add the density of rays to a lamp's box; see guide.c. */
SIMD_CLONES static void add_lamp(const reuse *r, const double *lamp, const pov_box *box, weights *w)
{
    for (uint32_t i = w->from; i < w->to; i++) {
        double enters = 0.0, leaves = HUGE_VAL, across = 1.0, by;

        cut(box->lo.x - r->start.x[i], box->hi.x - r->start.x[i], w->x[i], &enters, &leaves, &across);
        cut(box->lo.y - r->start.y[i], box->hi.y - r->start.y[i], w->y[i], &enters, &leaves, &across);
        cut(box->lo.z - r->start.z[i], box->hi.z - r->start.z[i], w->z[i], &enters, &leaves, &across);
        by = 0.5 * lamp[i] * enters * enters * w->facing[i] / across;
        w->density[i] += ((enters <= leaves) & (w->kernel[i] > 0.0) & (by <= 1e300)) ? by : 0.0;
    }
}

void reuse_find_densities(const shade_context *c, const reuse *r, weights *w)
{
    const world_lamps *lamps = world_get_lamps(c->scene->world);

    for (uint32_t i = w->from; i < w->to; i++)
        w->density[i] = r->guided[i] ? 0.5 * w->kernel[i] : w->kernel[i];
    for (uint32_t k = 0; k < lamps->count; k++)
        if (r->lamps_seen >> k & 1)
            add_lamp(r, r->lamps[k], &lamps->items[k].box, w);
}

/* ---- who sees it ---- */

/* Turn the ray to the place, which is at its parameter 1, or to the sky. */
static const pov_ray *aim(reuse *r, const weights *w, uint32_t i)
{
    pov_ray *ray = &r->rays[i];

    ray->dir = pov_vec3_of(w->x[i], w->y[i], w->z[i]);
    ray->origin_mark.flags &= ~(uint32_t)(POV_MARK_OUTWARD | POV_MARK_INWARD);
    world_origin_leave(ray, r->outside[i], pov_dot(ray->dir, lanes_at(&r->face, i)), pov_largest(ray->dir));
    return ray;
}

/* What lies beyond this part of the way is the place itself, but for roundings. */
static const double nearly = 1.0 - 0x1p-20;

/* ---- flat parts ---- */

static bool is_on(const reuse *r, const flat *f, uint32_t i)
{
    return r->from_object[i] == f->object && r->outside[i] == f->outside && vec3_is_same(lanes_at(&r->face, i), f->normal);
}

/* A rectangle across a normal, from a point. */
typedef struct rectangle { pov_vec3 at, normal, u, v; double lo[2], hi[2], off; } rectangle;

static rectangle begin_rectangle(pov_vec3 n, pov_vec3 at)
{
    const bool x_least = fabs(n.x) <= fabs(n.y) && fabs(n.x) <= fabs(n.z), y_least = fabs(n.y) <= fabs(n.z);
    const pov_vec3 axis = pov_vec3_of(x_least, !x_least && y_least, !x_least && !y_least);
    rectangle r = { .at = at, .normal = n, .u = pov_unit(pov_cross_product(n, axis)) };

    r.v = pov_cross_product(n, r.u);
    return r;
}

static void extend(rectangle *r, pov_vec3 point)
{
    const pov_vec3 d = pov_sub(point, r->at);
    const double a = pov_dot(d, r->u), b = pov_dot(d, r->v);

    r->lo[0] = pov_min(r->lo[0], a);
    r->hi[0] = pov_max(r->hi[0], a);
    r->lo[1] = pov_min(r->lo[1], b);
    r->hi[1] = pov_max(r->hi[1], b);
    r->off = pov_max(r->off, fabs(pov_dot(d, r->normal)));
}

/* False: the points do not lie on a plane. */
static bool end_rectangle(const rectangle *r, pov_vec3 corner[4])
{
    for (int i = 0; i < 4; i++)
        corner[i] = pov_add(r->at, pov_add(pov_scale(r->u, (i + 1) & 2 ? r->hi[0] : r->lo[0]), pov_scale(r->v, i & 2 ? r->hi[1] : r->lo[1])));
    return r->off <= 0x1p-40 * (r->hi[0] - r->lo[0] + r->hi[1] - r->lo[1]);
}

/* To look at a pyramid costs as much as some rays. */
enum { FLAT_LEAST = 4 };

/* The rectangle around its starts. False: they do not lie on a plane. */
static bool close_flat(const reuse *r, flat *f)
{
    rectangle around = begin_rectangle(f->normal, lanes_at(&r->start, first_of64(f->lanes)));

    for (uint64_t rest = f->lanes; rest; rest &= rest - 1)
        extend(&around, lanes_at(&r->start, first_of64(rest)));
    return end_rectangle(&around, f->corner);
}

void reuse_find_flats(const reuse *r, uint32_t from, uint32_t to, flats *out)
{
    uint64_t left = 0;

    for (uint32_t i = from; i < to; i++)
        left |= (uint64_t)1 << i;
    out->count = 0;
    for (int tries = 0; left && tries < 2 * FLATS_MAX && out->count < FLATS_MAX; tries++) {
        const uint32_t first = first_of64(left);
        flat *f = &out->of[out->count];

        *f = (flat){ .normal = lanes_at(&r->face, first), .object = r->from_object[first], .outside = r->outside[first] };
        for (uint64_t rest = left; rest; rest &= rest - 1)
            if (is_on(r, f, first_of64(rest)))
                f->lanes |= rest & (~rest + 1);
        left &= ~f->lanes;
        out->count += lane_mask_count(f->lanes) >= FLAT_LEAST && close_flat(r, f);
    }
}

static bool is_one_side(const flat *a, const flat *b)
{
    return a->object == b->object && a->outside == b->outside && vec3_is_same(a->normal, b->normal);
}

/* Widen the rectangle to hold one in its plane. False: it lies in another. */
static bool widen(flat *f, const flat *by)
{
    rectangle r = begin_rectangle(f->normal, f->corner[0]);

    for (int i = 0; i < 4; i++) {
        extend(&r, f->corner[i]);
        extend(&r, by->corner[i]);
    }
    return end_rectangle(&r, f->corner);
}

void reuse_join_flats(const flats *some, flats *out)
{
    for (uint32_t k = 0; k < some->count; k++) {
        const flat *f = &some->of[k];
        uint32_t i = 0;

        while (i < out->count && !is_one_side(&out->of[i], f))
            i++;
        if (i < out->count) {
            if (!widen(&out->of[i], f))
                out->of[i].lanes = 0;   /* parallel planes: nothing is known of any */
        } else if (i < FLATS_MAX) {
            out->of[out->count++] = *f;
        }
    }
}

/* Around all segments to the place. */
static bool make_shaft(const flat *f, const weights *w, shaft *out)
{
    pov_vec3 corner[4];

    for (int i = 0; i < 4; i++)
        corner[i] = pov_sub(f->corner[i], w->at);
    return shaft_make(out, w->at, corner);
}

/* The same to the sky. Rays in one direction are a prism: to the end of all that is finite it lies in a pyramid that is so much
 * longer, on a base so much wider. What is infinite and no plane is never clear; and of the rays beside a plane that do not start on
 * different sides of it all meet it or none. */
static bool make_sky_shaft(const world *scene, const flat *f, const weights *w, shaft *out)
{
    const double longer = 64.0, wider = longer / (longer - 1.0);
    const pov_vec3 middle = pov_scale(pov_add(f->corner[0], f->corner[2]), 0.5), half = pov_sub(f->corner[0], middle);
    pov_vec3 corner[4], far = half, apex;
    pov_box box;

    if (world_bounds(scene, &box))
        far = pov_vec3_of(pov_max(fabs(box.lo.x - middle.x), fabs(box.hi.x - middle.x)), pov_max(fabs(box.lo.y - middle.y), fabs(box.hi.y - middle.y)),
                          pov_max(fabs(box.lo.z - middle.z), fabs(box.hi.z - middle.z)));
    apex = pov_add(middle, pov_scale(w->at, longer * (sqrt(pov_dot(far, far)) + sqrt(pov_dot(half, half)))));
    for (int i = 0; i < 4; i++)
        corner[i] = pov_sub(pov_add(middle, pov_scale(pov_sub(f->corner[i], middle), wider)), apex);
    return shaft_make(out, apex, corner);
}

/* Lanes of which one look tells that nothing lies before the place; of the sky they are one of parts[] each. */
typedef struct clearing { uint64_t lanes, parts[FLATS_MAX]; uint32_t count; } clearing;

/* What the segments to the place end on. */
static departure end_of(const weights *w)
{
    const departure place = { w->object, w->out }, none = { POV_NO_OWNER, false };

    return w->found == REUSE_SKY ? none : place;
}

static bool is_clear(const shade_context *c, const flat *f, const weights *w)
{
    const world *scene = c->scene->world;
    const departure on = { f->object, f->outside };
    shaft s;

    return (w->found == REUSE_SKY ? make_sky_shaft(scene, f, w, &s) : make_shaft(f, w, &s)) && query_is_clear(scene, &s, end_of(w), on);
}

static bool any_sees(const flat *f, const weights *w)
{
    for (uint64_t rest = f->lanes; rest; rest &= rest - 1)
        if (w->kernel[first_of64(rest)] > 0.0)
            return true;
    return false;
}

/* Is the place on the side that rays leave to? */
static bool is_before(const flat *f, const weights *w)
{
    return pov_dot(f->normal, w->found == REUSE_SKY ? w->at : pov_sub(w->at, f->corner[0])) > 0.0;
}

/* Rays to the sky beside one from the same plane are all clear if one is: see make_sky_shaft(). */
void reuse_find_clear(const shade_context *c, const reuse *from, uint32_t start, const flats *joined, const weights *w, flats *out)
{
    out->count = 0;
    for (uint32_t k = 0; k < joined->count; k++) {
        const flat *f = &joined->of[k];

        if (f->lanes && (w->found != REUSE_SKY || is_on(from, f, start)) && is_before(f, w) && is_clear(c, f, w))
            out->of[out->count++] = *f;
    }
}

static bool is_within(const flats *clear, const flat *f)
{
    for (uint32_t i = 0; i < clear->count; i++)
        if (is_one_side(&clear->of[i], f))
            return true;
    return false;
}

uint64_t reuse_lanes_within(const flats *some, const flats *clear)
{
    uint64_t out = 0;

    for (uint32_t k = 0; k < some->count; k++)
        if (is_within(clear, &some->of[k]))
            out |= some->of[k].lanes;
    return out;
}

static void find_clear(const shade_context *c, const flats *all, const weights *w, clearing *out)
{
    out->lanes = 0;
    out->count = 0;
    for (uint32_t k = 0; k < all->count; k++) {
        const flat *f = &all->of[k];

        if (any_sees(f, w) && is_clear(c, f, w)) {
            out->lanes |= f->lanes;
            out->parts[out->count++] = f->lanes;
        }
    }
}

/* ---- who sees it: all ---- */

/* The first of some lanes whose starts face the place. POV_NO_OWNER: there is none. */
static uint32_t first_facing(const weights *w, uint64_t lanes)
{
    for (; lanes; lanes &= lanes - 1)
        if (w->kernel[first_of64(lanes)] > 0.0)
            return first_of64(lanes);
    return POV_NO_OWNER;
}

static uint64_t facing_lanes(const weights *w)
{
    static const double none[WORLD_MANY];

    return lane_mask_below(none, w->kernel, w->to) & ~lane_mask_all(w->from);
}

static void hide(weights *w, uint64_t lanes)
{
    for (; lanes; lanes &= lanes - 1)
        w->kernel[first_of64(lanes)] = w->density[first_of64(lanes)] = 0.0;
}

static void ask(reuse *r, weights *w, uint32_t i, uint64_t lanes, asking *out)
{
    out->rays[out->count] = aim(r, w, i);
    out->of[out->count] = w;
    out->lanes[out->count++] = lanes;
}

bool reuse_send(shade_context *c, asking *a)
{
    const weights *w = a->of[0];
    const uint32_t n = a->count;
    uint64_t hidden;

    if (n == 0)
        return true;
    hidden = ~query_visible(c->scene->world, c->context, a->rays, n, w->found == REUSE_SKY ? HUGE_VAL : nearly, end_of(w));
    c->counts.shadow += n;
    for (hidden &= lane_mask_all(n); hidden; hidden &= hidden - 1)
        hide(a->of[first_of64(hidden)], a->lanes[first_of64(hidden)]);
    a->count = 0;
    return !interrupt_is_due(&c->interrupt, n);
}

/* Rays to the sky from clear parts: one of each stands for all of them. False: given up. */
static bool ask_parts(shade_context *c, reuse *r, uint32_t own, const clearing *clear, weights *w, asking *out)
{
    for (uint32_t k = 0; w->found == REUSE_SKY && k < clear->count; k++) {
        const uint32_t first = first_facing(w, clear->parts[k]);

        if (first == POV_NO_OWNER || (own < 64 && clear->parts[k] >> own & 1))
            continue;
        if (out->count == WORLD_MANY && !reuse_send(c, out))
            return false;
        ask(r, w, first, clear->parts[k], out);
    }
    return true;
}

/* One of some lanes, by chance. */
static uint32_t pick(uint64_t lanes, uint64_t bits)
{
    for (uint32_t n = (uint32_t)((bits & UINT32_MAX) * lane_mask_count(lanes) >> 32); n > 0; n--)
        lanes &= lanes - 1;
    return first_of64(lanes);
}

/* Who is drawn does not depend on what is known. */
bool reuse_ask(shade_context *c, reuse *r, uint32_t own, uint64_t known, const sharing *s, weights *w, asking *out)
{
    uint64_t facing = facing_lanes(w), bits = s->bits;

    while (facing) {
        const uint32_t first = first_of64(facing);
        const uint64_t lanes = s->alike ? facing & s->alike[first] : (uint64_t)1 << first;
        const uint32_t one = pick(lanes, bits);

        facing &= ~lanes;
        bits = bits >> 5 | bits << 59;
        if ((own < 64 && lanes >> own & 1) || known >> one & 1)
            continue;
        if (out->count == WORLD_MANY && !reuse_send(c, out))
            return false;
        ask(r, w, one, lanes, out);
    }
    return true;
}

/* Those of a set that see it keep their kernels. False: given up. */
static bool hide_some(shade_context *c, reuse *r, const flats *all, uint32_t own, weights *w)
{
    const sharing none = { NULL, 0 };
    clearing clear;
    asking asked;

    asked.count = 0;
    find_clear(c, all, w, &clear);
    return ask_parts(c, r, own, &clear, w, &asked) && reuse_ask(c, r, own, clear.lanes, &none, w, &asked) && reuse_send(c, &asked);
}

/* ---- weights of a place ---- */

void reuse_begin(const reuse *r, uint32_t lane, weights *w)
{
    w->at = lanes_at(&r->end, lane);
    w->normal = lanes_at(&r->end_normal, lane);
    w->found = r->found[lane];
    w->object = r->object[lane];
    w->out = r->out[lane];
}

void reuse_find_kernels(const reuse *r, weights *w)
{
    if (w->found == REUSE_SKY)
        find_sky_kernels(r, w);
    else
        find_kernels(r, w);
}

/* ---- sums ---- */

static void add(power_sum *sum, uint32_t i, colour seen, double by)
{
    colour *out = &sum->out[sum->lane[i]];

    *out = colour_add(*out, colour_mul(colour_scale(sum->factor[i], (float)by), seen));
}

/* What the ray `own` has seen, to all of its set. */
static void spread_one(shade_context *c, power_sum *sum, const flats *all_flats, uint32_t from, uint32_t to, uint32_t own)
{
    reuse *r = sum->reuse;
    const uint32_t lane = sum->lane[own];
    const colour seen = gather_sample(&c->scene->model->radiosity, sum->seen[lane]);
    const bool is_shared = r->found[lane] != REUSE_NOTHING;
    double all = 0.0;
    weights w;

    if (seen.r == 0.0f && seen.g == 0.0f && seen.b == 0.0f)
        return;
    reuse_begin(r, lane, &w);
    w.from = from;
    w.to = to;
    if (to - from > 1 && is_shared)
        reuse_find_kernels(r, &w);
    if (to - from == 1 || !is_shared || !(w.kernel[own] > 0.0)) {
        add(sum, own, seen, (double)r->by[own]);
        return;
    }
    reuse_find_densities(c, r, &w);
    if (!hide_some(c, r, all_flats, own, &w))
        return;
    for (uint32_t i = from; i < to; i++)
        all += w.density[i];
    for (uint32_t i = from; i < to; i++)
        if (w.kernel[i] > 0.0)
            add(sum, i, seen, w.kernel[i] / all);
}

void reuse_spread(shade_context *c, power_sum *sum)
{
    const reuse *r = sum->reuse;

    flats all;

    for (uint32_t from = 0, to; from < sum->count; from = to) {
        for (to = from + 1; to < sum->count && r->sets[to] == r->sets[from] && r->sets[from]; to++)
            ;
        reuse_find_flats(r, from, to, &all);
        for (uint32_t i = from; i < to && !c->interrupt.given_up; i++)
            spread_one(c, sum, &all, from, to, i);
    }
}

bool reuse_is_possible(const shade_context *c)
{
    const shading *s = c->scene;

    return !s->plan->hidden && !(s->plan->media && s->model->radiosity.sees_media);
}
