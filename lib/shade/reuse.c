#include "shade/reuse.h"

#include "base/simd.h"
#include "shade/gather.h"

static const double inverse_pi = 0.31830988618379067;

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

        r->found[lane] = is_even(c->scene, s) ? REUSE_PLACE : REUSE_NOTHING;
        r->object[lane] = s->at->object;
        r->out[lane] = s->at->outside;
        lanes_put(&r->end, lane, s->at->point);
        lanes_put(&r->end_normal, lane, pov_dot(normal, s->ray->dir) > 0.0 ? pov_scale(normal, -1.0) : normal);
    }
}

/* ---- weights ---- */

/* The starts x of a set, from .. to - 1, and a place y. By start: what y counts there, by area of y, which is the product of the
 * cosines at x and y over pi and the square of the distance; and how densely rays from x would meet y. */
typedef struct weights {
    uint32_t from, to;
    pov_vec3 at, normal;
    double kernel[WORLD_MANY], density[WORLD_MANY];
    double x[WORLD_MANY], y[WORLD_MANY], z[WORLD_MANY];   /* from start to place */
    double facing[WORLD_MANY];   /* the cosine at the place, times the distance */
} weights;

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

static void find_densities(const shade_context *c, const reuse *r, weights *w)
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

/* The ray meets the place itself, but for roundings, or nothing before it. */
static bool arrives(const hit *h, uint32_t object)
{
    const double nearly = 1.0 - 0x1p-20;

    return h->object == object && h->crossing.t > nearly;
}

/* Leave the kernels and densities of those that see what the ray `own` found; `clear` do. False: given up. */
static bool hide(shade_context *c, reuse *r, uint32_t own, uint32_t lane, uint64_t clear, weights *w)
{
    const pov_ray *rays[WORLD_MANY];
    uint8_t of[WORLD_MANY];
    hit hits[WORLD_MANY];
    const bool is_sky = r->found[lane] == REUSE_SKY;
    uint64_t hidden;
    uint32_t n = 0;

    for (uint32_t i = w->from; i < w->to; i++)
        if (i != own && w->kernel[i] > 0.0 && !(clear >> i & 1)) {
            rays[n] = aim(r, w, i);
            of[n++] = (uint8_t)i;
        }
    if (n == 0)
        return true;
    hidden = query_nearest(c->scene->world, c->context, rays, n, is_sky ? HUGE_VAL : 1.0, hits);
    c->counts.shadow += n;
    for (uint32_t k = 0; k < n; k++)
        if ((hidden >> k & 1) && (is_sky || !arrives(&hits[k], r->object[lane])))
            w->kernel[of[k]] = w->density[of[k]] = 0.0;
    return !interrupt_is_due(&c->interrupt, n);
}

/* ---- flat parts ---- */

/* Starts of a set that lie on one plane side of an object: the corners of a rectangle around them. */
typedef struct flat { pov_vec3 normal, corner[4]; uint32_t object; bool outside; uint64_t lanes; } flat;
enum { FLATS_MAX = 4 };
typedef struct flats { uint32_t count; flat of[FLATS_MAX]; } flats;

static bool is_same(pov_vec3 a, pov_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

static bool is_on(const reuse *r, const flat *f, uint32_t i)
{
    return r->from_object[i] == f->object && r->outside[i] == f->outside && is_same(lanes_at(&r->face, i), f->normal);
}

/* The rectangle around its starts. False: they do not lie on a plane. */
static bool close_flat(const reuse *r, flat *f)
{
    const uint32_t first = first_of64(f->lanes);
    const pov_vec3 n = f->normal, at = lanes_at(&r->start, first);
    const bool x_least = fabs(n.x) <= fabs(n.y) && fabs(n.x) <= fabs(n.z), y_least = fabs(n.y) <= fabs(n.z);
    const pov_vec3 axis = pov_vec3_of(x_least, !x_least && y_least, !x_least && !y_least);
    const pov_vec3 u = pov_unit(pov_cross_product(n, axis)), v = pov_cross_product(n, u);
    double lo[2] = { 0.0, 0.0 }, hi[2] = { 0.0, 0.0 }, off = 0.0;

    for (uint64_t rest = f->lanes; rest; rest &= rest - 1) {
        const pov_vec3 d = pov_sub(lanes_at(&r->start, first_of64(rest)), at);
        const double a = pov_dot(d, u), b = pov_dot(d, v);

        lo[0] = fmin(lo[0], a);
        hi[0] = fmax(hi[0], a);
        lo[1] = fmin(lo[1], b);
        hi[1] = fmax(hi[1], b);
        off = fmax(off, fabs(pov_dot(d, n)));
    }
    for (int i = 0; i < 4; i++)
        f->corner[i] = pov_add(at, pov_add(pov_scale(u, (i + 1) & 2 ? hi[0] : lo[0]), pov_scale(v, i & 2 ? hi[1] : lo[1])));
    return off <= 0x1p-40 * (hi[0] - lo[0] + hi[1] - lo[1]);
}

static void find_flats(const reuse *r, uint32_t from, uint32_t to, flats *out)
{
    uint64_t left = 0;

    for (uint32_t i = from; i < to; i++)
        left |= (uint64_t)1 << i;
    out->count = 0;
    while (left && out->count < FLATS_MAX) {
        const uint32_t first = first_of64(left);
        flat *f = &out->of[out->count];

        *f = (flat){ .normal = lanes_at(&r->face, first), .object = r->from_object[first], .outside = r->outside[first] };
        for (uint64_t rest = left; rest; rest &= rest - 1)
            if (is_on(r, f, first_of64(rest)))
                f->lanes |= rest & (~rest + 1);
        left &= ~f->lanes;
        out->count += close_flat(r, f);
    }
}

/* Lanes of which one look tells that nothing lies before the place. */
static uint64_t find_clear(const shade_context *c, const reuse *r, const flats *all, const weights *w, uint32_t lane)
{
    const departure left = { r->object[lane], r->out[lane] };
    uint64_t clear = 0;

    for (uint32_t k = 0; k < all->count; k++) {
        const flat *f = &all->of[k];
        const departure on = { f->object, f->outside };
        pov_vec3 corner[4];
        shaft s;

        for (int i = 0; i < 4; i++)
            corner[i] = pov_sub(f->corner[i], w->at);
        if (shaft_make(&s, w->at, corner) && query_is_clear(c->scene->world, &s, left, on))
            clear |= f->lanes;
    }
    return clear;
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
    double all = 0.0;
    weights w;

    if (seen.r == 0.0f && seen.g == 0.0f && seen.b == 0.0f)
        return;
    w.from = from;
    w.to = to;
    w.at = lanes_at(&r->end, lane);
    w.normal = lanes_at(&r->end_normal, lane);
    if (to - from > 1 && r->found[lane] == REUSE_PLACE)
        find_kernels(r, &w);
    else if (to - from > 1 && r->found[lane] == REUSE_SKY)
        find_sky_kernels(r, &w);
    if (to - from == 1 || r->found[lane] == REUSE_NOTHING || !(w.kernel[own] > 0.0)) {
        add(sum, own, seen, (double)r->by[own]);
        return;
    }
    find_densities(c, r, &w);
    if (!hide(c, r, own, lane, r->found[lane] == REUSE_SKY ? 0 : find_clear(c, r, all_flats, &w, lane), &w))
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
        find_flats(r, from, to, &all);
        for (uint32_t i = from; i < to && !c->interrupt.given_up; i++)
            spread_one(c, sum, &all, from, to, i);
    }
}

bool reuse_is_possible(const shade_context *c)
{
    const shading *s = c->scene;

    return !s->plan->hidden && !(s->plan->media && s->model->radiosity.sees_media);
}
