#include "photon/emission.h"

#include "base/elementary.h"
#include "base/mix.h"
#include "base/vec.h"

/* ---- rectangles ---- */

static bool is_parallel(const light *l) { return light_class_of(l)->parallel; }

static pov_vec3 corner_of(const pov_box *b, int i)
{
    return pov_vec3_of(i & 1 ? b->hi.x : b->lo.x, i & 2 ? b->hi.y : b->lo.y, i & 4 ? b->hi.z : b->lo.z);
}

/* Two unit vectors across a unit vector, one of them in the plane of a coordinate axis. */
static void frame_across(pov_vec3 w, pov_vec3 out[2])
{
    const double x = fabs(w.x), y = fabs(w.y), z = fabs(w.z);
    const pov_vec3 axis = x <= y && x <= z ? pov_vec3_of(1, 0, 0) : y <= z ? pov_vec3_of(0, 1, 0) : pov_vec3_of(0, 0, 1);

    out[0] = pov_unit(pov_sub(axis, pov_scale(w, pov_dot(axis, w))));
    out[1] = pov_cross_product(w, out[0]);
}

typedef struct extent { double lo[2], hi[2]; } extent;

static const extent nothing = { { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL } };

static void reach(extent *e, const double at[2])
{
    for (int k = 0; k < 2; k++) {
        e->lo[k] = at[k] < e->lo[k] ? at[k] : e->lo[k];
        e->hi[k] = at[k] > e->hi[k] ? at[k] : e->hi[k];
    }
}

/* A box is known but for roundings. */
static const double beyond = 0x1p-20;

static bool set_rectangle(photon_aim *a, const extent *e, pov_vec3 middle, const pov_vec3 frame[2])
{
    double size[2];

    a->corner = middle;
    for (int k = 0; k < 2; k++) {
        const double more = beyond * (e->hi[k] - e->lo[k]);

        size[k] = e->hi[k] - e->lo[k] + 2.0 * more;
        a->corner = pov_add(a->corner, pov_scale(frame[k], e->lo[k] - more));
        a->sides[k] = pov_scale(frame[k], size[k]);
    }
    a->area = size[0] * size[1];
    return a->area > 0.0 && a->area <= 1e200;
}

/* Where the box is seen in the plane at distance 1 along w. False: part of the box lies beside or behind. */
static bool project_box(const photon_aim *a, const pov_box *b, pov_vec3 w, const pov_vec3 frame[2], extent *e)
{
    const double least_cosine = 0.2;

    *e = nothing;
    for (int i = 0; i < 8; i++) {
        const pov_vec3 to = pov_sub(corner_of(b, i), a->from.from);
        const double depth = pov_dot(to, w), at[2] = { pov_dot(to, frame[0]) / depth, pov_dot(to, frame[1]) / depth };

        if (!(depth > least_cosine * sqrt(pov_dot(to, to))))
            return false;
        reach(e, at);
    }
    return true;
}

/* The rectangle in that plane. False: there is none. */
static bool cover_box(photon_aim *a, const pov_box *b, pov_vec3 w)
{
    extent e;
    pov_vec3 frame[2];

    frame_across(w, frame);
    return project_box(a, b, w, frame, &e) && set_rectangle(a, &e, w, frame);
}

/* What lies within this distance of the middle is lit. */
static void keep_lit(extent *e, double radius)
{
    for (int k = 0; k < 2; k++) {
        e->lo[k] = pov_max(e->lo[k], -radius);
        e->hi[k] = pov_min(e->hi[k], radius);
    }
}

/* The light comes in a cone that is not wide. */
static bool is_narrow(const light *l) { return l->type == LIGHT_SPOT && l->falloff >= 0.5; }

/* The same in the plane across the cone's axis. False: nothing of the box is lit. */
static bool cover_cone(photon_aim *a, const pov_box *b)
{
    const double cosine = a->light->falloff, radius = sqrt(pov_max(1.0 - cosine * cosine, 0.0)) / cosine;
    extent e;
    pov_vec3 frame[2];

    frame_across(a->light->axis, frame);
    if (!b || !project_box(a, b, a->light->axis, frame, &e))
        e = (extent){ { -radius, -radius }, { radius, radius } };
    keep_lit(&e, radius);
    return e.lo[0] < e.hi[0] && e.lo[1] < e.hi[1] && set_rectangle(a, &e, a->light->axis, frame);
}

/* One face of the cube of directions. */
static bool cover_face(photon_aim *a, int face)
{
    static const extent whole = { { -1.0, -1.0 }, { 1.0, 1.0 } };
    const double side = face & 1 ? -1.0 : 1.0;
    const pov_vec3 w = pov_vec3_of(face / 2 == 0 ? side : 0, face / 2 == 1 ? side : 0, face / 2 == 2 ? side : 0);
    pov_vec3 frame[2];

    frame_across(w, frame);
    return set_rectangle(a, &whole, w, frame);
}

/* The rectangle across the light's axis that the box is behind: in the plane through the light, or in front of a box that
 * reaches across that. */
static bool cover_parallel(photon_aim *a, const pov_box *b)
{
    extent e = nothing, depths = nothing;
    pov_vec3 frame[2];
    double along;

    frame_across(a->light->axis, frame);
    for (int i = 0; i < 8; i++) {
        const pov_vec3 to = pov_sub(corner_of(b, i), a->from.from);
        const double at[2] = { pov_dot(to, frame[0]), pov_dot(to, frame[1]) };
        const double depth[2] = { pov_dot(to, a->light->axis), 0.0 };

        reach(&depths, depth);
        reach(&e, at);
    }
    if (a->light->type == LIGHT_CYLINDER)
        keep_lit(&e, a->light->falloff);
    if (!(e.lo[0] < e.hi[0] && e.lo[1] < e.hi[1]))
        return false;
    along = depths.lo[0] > 0.0 ? 0.0 : 2.0 * depths.lo[0] - depths.hi[0];
    return set_rectangle(a, &e, pov_add(a->from.from, pov_scale(a->light->axis, along)), frame);
}

/* ---- aims ---- */

bool emission_is_source(const light *l)
{
    return !colour_is_black(l->color) && !(l->flags & LIGHT_SHADOWLESS) && l->group == 0 && l->through_count == 0;
}

static bool add(photon_aims *list, photon_aim *a)
{
    a->number = (uint32_t)list->count;
    return VEC_PUSH(list->env, list, *a);
}

/* From one origin to one target. */
static bool add_origin(photon_aims *list, photon_aim a, const photon_target *t, const pov_box *around)
{
    const pov_box *box = t->boxed ? &t->box : around;
    pov_vec3 to;

    if (is_parallel(a.light))
        return !box || !cover_parallel(&a, box) || add(list, &a);
    if (is_narrow(a.light))
        return !cover_cone(&a, box) || add(list, &a);
    to = t->boxed ? pov_sub(pov_scale(pov_add(box->lo, box->hi), 0.5), a.from.from) : pov_vec3_of(0, 0, 0);
    if (pov_largest(to) > 0.0 && cover_box(&a, box, pov_unit(to)))
        return add(list, &a);
    for (int face = 0; face < 6; face++)
        if (cover_face(&a, face) && !add(list, &a))
            return false;
    return true;
}

/* A point of the area, without jitter and turning. */
static pov_vec3 point_of(const light *l, uint32_t i, uint32_t k)
{
    const uint32_t *n = l->area.counts;
    const double u = n[0] > 1 ? (double)i / (n[0] - 1) - 0.5 : 0.0, v = n[1] > 1 ? (double)k / (n[1] - 1) - 0.5 : 0.0;

    return pov_add(l->position, pov_add(pov_scale(l->area.axes[0], u), pov_scale(l->area.axes[1], v)));
}

/* POV-Ray gives the points on the edges of a grid half the weight of those within, in effect. */
static double weight_of(uint32_t i, uint32_t n) { return n == 1 ? 1.0 : (i == 0 || i == n - 1 ? 0.5 : 1.0) / (n - 1); }

static bool add_area(photon_aims *list, photon_aim a, const photon_target *t, const pov_box *around)
{
    const uint32_t *n = a.light->area.counts;

    for (uint32_t i = 0; i < n[0] * n[1]; i++) {
        a.from.from = point_of(a.light, i % n[0], i / n[0]);
        a.share = (float)(weight_of(i % n[0], n[0]) * weight_of(i / n[0], n[1]));
        if (!add_origin(list, a, t, around))
            return false;
    }
    return true;
}

/* From a light to all targets that it sends photons to. */
static bool add_light(photon_aims *list, uint32_t number, const photon_target *targets, const uint32_t *flags, size_t count,
                      const pov_box *around)
{
    const light *l = &list->lights[number];
    photon_aim a = { .light = l, .from = light_own_origin(l), .light_number = number, .share = 1.0f };
    const bool is_area = (l->flags & PHOTON_AREA) && (l->flags & LIGHT_AREA);

    for (size_t i = 0; i < count; i++) {
        a.target = (uint32_t)i;
        if (!photons_reflect(flags[i], l->flags) && !photons_refract(flags[i], l->flags))
            continue;
        if (!(is_area ? add_area(list, a, &targets[i], around) : add_origin(list, a, &targets[i], around)))
            return false;
    }
    return true;
}

bool emission_aim(photon_aims *out, const model *m, const photon_target *targets, const uint32_t *target_flags, size_t count,
                  const pov_box *around)
{
    const photon_aims none = { m->env, NULL, 0, 0, NULL };

    *out = none;
    out->lights = env_alloc(m->env, m->lights.count, sizeof *out->lights);
    if (!out->lights && m->lights.count > 0)
        return false;
    for (size_t i = 0; i < m->lights.count; i++) {
        out->lights[i] = m->lights.items[i];
        out->lights[i].fade_distance = 0.0;
        if (emission_is_source(&m->lights.items[i]) &&
            !add_light(out, (uint32_t)i, targets, target_flags, count, around))
            return false;
    }
    return true;
}

void emission_free(photon_aims *a)
{
    if (!a->env)
        return;
    env_free(a->env, a->items);
    env_free(a->env, a->lights);
}

/* ---- rays ---- */

static double fraction(double x) { return x - floor(x); }

/* The place of an emission in its rectangle: Roberts's sequence of two dimensions, by the root of x^3 = x + 1. Aims have
 * shifts of their own: those of the points of an area light are much alike, and so would be their errors. */
static void place_of(const photon_aim *a, uint32_t seed, uint32_t map, uint32_t i, double out[2])
{
    static const double step[2] = { 0.7548776662466927, 0.5698402909980532 };
    const uint64_t of = map * 0x9e3779b97f4a7c15u + 1 + a->number * 0xd1342543de82ef95u;
    const uint64_t bits = mix_bits(of + seed * 0xa0761d6478bd642fu);

    out[0] = fraction((double)(bits >> 32) * 0x1p-32 + fraction((double)i * step[0]));
    out[1] = fraction((double)(bits & 0xffffffff) * 0x1p-32 + fraction((double)i * step[1]));
}

/* The light's colour along the rays, as cones and cylinders dim it. */
static void find_colours(const photon_aim *a, uint32_t n, const emission_batch *b, light_lanes *in)
{
    vec_lanes point, low;
    const light_points at = { &point, &low, n };

    for (uint32_t i = 0; i < lanes_whole(n); i++) {
        const pov_ray *ray = &b->rays[i < n ? i : 0];

        lanes_put(&point, i, is_parallel(a->light) ? ray->org : pov_add(ray->org, ray->dir));
        lanes_put(&low, i, pov_vec3_of(0, 0, 0));
    }
    light_class_of(a->light)->incident(a->light, &a->from, &at, in);
}

void emission_rays(const photon_aim *a, uint32_t seed, uint32_t map, uint32_t first, uint32_t n, uint32_t total, emission_batch *out)
{
    static const pov_ray fresh;
    light_lanes in;

    for (uint32_t i = 0; i < n; i++) {
        pov_ray *ray = &out->rays[i];
        double at[2];
        pov_vec3 to;

        place_of(a, seed, map, first + i, at);
        to = pov_add(a->corner, pov_add(pov_scale(a->sides[0], at[0]), pov_scale(a->sides[1], at[1])));
        *ray = fresh;
        ray->origin_surface = POV_NO_OWNER;
        ray->org = is_parallel(a->light) ? to : a->from.from;
        ray->org_lo = is_parallel(a->light) ? pov_vec3_of(0, 0, 0) : a->from.from_lo;
        ray->dir = is_parallel(a->light) ? a->light->axis : to;
    }
    find_colours(a, n, out, &in);
    for (uint32_t i = 0; i < n; i++) {
        const pov_vec3 d = out->rays[i].dir;
        const double square = pov_dot(d, d), part = is_parallel(a->light) ? 1.0 : 1.0 / (square * sqrt(square));
        const colour c = in.uniform ? in.color : colour_of(in.red[i], in.green[i], in.blue[i]);

        out->flux[i] = colour_scale(c, (float)(part * a->area / (double)total * (double)a->share));
    }
}

double emission_factor(const light *l, double distance)
{
    const double spread = is_parallel(l) ? 1.0 : distance * distance;

    return light_fades(l) ? spread * 2.0 / (1.0 + elementary_pow(distance / l->fade_distance, l->fade_power)) : spread;
}
