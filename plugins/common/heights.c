#include "common/heights.h"

/* ---- along a ray ---- */

typedef struct walk {
    const common_heights *f;
    const pov_ray *ray;
    pov_hits *hits;
    common_triangle_ray through;   /* its view is made when it is asked for */
    double base;                 /* where distances are counted from */
    pov_vec3 at, by;             /* where the ray is there and how it goes on, in cells and 1/65536 */
    double off, most;            /* how much a height over a plane may be off, by far, infinite if all is to be exact; of a cell and its way */
    bool from_here, seen;
} walk;

static bool is_dry(const common_heights *f, const walk *w, double t)
{
    return f->water <= 0.0 || pov_two_add(pov_two_sum(w->ray->org.y, w->ray->org_lo.y), pov_two_product(t, w->ray->dir.y)).hi >= f->water;
}

/* One of the two triangles of a cell, which the line of the ray passes through. False: nothing more is wanted. */
static bool cross_face(walk *w, uint32_t feature, const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c)
{
    pov_mark mark = { feature, 0, 0.0, 0.0 };

    if (w->from_here && w->ray->origin_mark.feature == feature)
        return true;
    if (w->f->water > 0.0) {
        pov_hits one = *w->hits;
        pov_crossing at;

        one.want = POV_WANT_NEAREST;
        one.count = 0;
        one.at = &at;
        common_triangle_cross(&w->through, a, b, c, mark, &one);
        if (one.count == 0 || !is_dry(w->f, w, at.t))
            return true;
    }
    return common_triangle_cross(&w->through, a, b, c, mark, w->hits);
}

static bool cross_faces(walk *w, uint32_t x, uint32_t z, common_passing low, common_passing high)
{
    const common_heights *f = w->f;
    const pov_vec3 a = common_height_corner(f, x, z), b = common_height_corner(f, x + 1, z);
    const pov_vec3 c = common_height_corner(f, x, z + 1), d = common_height_corner(f, x + 1, z + 1);
    const uint32_t feature = 2 * (z * (f->wide - 1) + x);

    if (low == COMMON_UNCLEAR || high == COMMON_UNCLEAR) {
        common_triangle_ray *r = &w->through;
        common_seen p, q;

        if (!w->seen)
            common_triangle_look(r, w->hits->unfiltered);
        w->seen = true;
        p = common_triangle_see(r, &b);
        q = common_triangle_see(r, &c);
        low = common_triangle_is_passed(r, &a, common_triangle_see(r, &a), &b, p, &c, q) ? COMMON_THROUGH : COMMON_BESIDE;
        high = common_triangle_is_passed(r, &b, p, &d, common_triangle_see(r, &d), &c, q) ? COMMON_THROUGH : COMMON_BESIDE;
    }
    return (low == COMMON_BESIDE || cross_face(w, feature, &a, &b, &c)) && (high == COMMON_BESIDE || cross_face(w, feature + 1, &b, &d, &c));
}

static bool visit_cell(void *user, uint32_t x, uint32_t z)
{
    walk *w = user;
    const uint16_t *h = w->f->height + (size_t)z * w->f->wide + x, *g = h + w->f->wide;
    const double a = h[0], b = h[1], c = g[0], d = g[1], u = w->at.x - x, v = w->at.z - z, du = w->by.x, dv = w->by.z, p = 1.0 - u, q = 1.0 - v;
    const double off = w->off * (w->most + fabs(u) + fabs(v));
    const double above_low = w->at.y - a - u * (b - a) - v * (c - a), rise_low = w->by.y - du * (b - a) - dv * (c - a);
    const double above_high = w->at.y - d - p * (c - d) - q * (b - d), rise_high = w->by.y + du * (c - d) + dv * (b - d);
    const common_passing low = common_passing_of(common_judge_face(above_low, rise_low, u, v, du, dv, off));
    const common_passing high = common_passing_of(common_judge_face(above_high, rise_high, p, q, -du, -dv, off));
    const double before = w->hits->tmax;

    if (low == COMMON_BESIDE && high == COMMON_BESIDE)
        return true;
    if (!cross_faces(w, x, z, low, high))
        return false;
    /* What comes behind a crossing well within the cell is farther. */
    return w->hits->want != POV_WANT_NEAREST || w->hits->tmax == before || low == COMMON_UNCLEAR || high == COMMON_UNCLEAR;
}

/* Where the interval ends. */
static double end_of(const walk *w)
{
    const pov_hits *h = w->hits;
    const double most = h->tmax * w->through.about.per_unit * (1.0 + 0x1p-40);

    return most - w->base + 0x1p-40 * (1.0 + fabs(w->base));
}

static pov_vec3 in_steps(const common_heights *f, pov_vec3 v) { return pov_vec3_of(v.x * (f->wide - 1.0), v.y * 0x1p16, v.z * (f->deep - 1.0)); }

void common_heights_cross(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits)
{
    const common_heights *f = self;
    pov_vec3 o;
    walk w;

    if (!f->relief.levels)
        return;
    w.f = f;
    w.ray = ray;
    w.hits = hits;
    w.through.about = e->k;
    w.base = pov_max(e->span.lo, 0.0);
    w.from_here = ray->origin_surface == hits->owner;
    w.seen = false;
    common_triangle_place(&w.through, ray, common_heights_centre(), 1.0);
    o = pov_add(common_along(&e->k, w.base), common_heights_centre());
    w.at = in_steps(f, o);
    w.by = in_steps(f, e->k.d);
    w.off = hits->always_exact || !(pov_largest(pov_two3_hi(e->k.f)) < COMMON_FAR) ? HUGE_VAL : 0x1p-10 * (1.0 + pov_largest(o));
    w.most = 2.0 + fabs(w.by.x) + fabs(w.by.z);
    common_relief_search(&f->relief, o, e->k.d, pov_min(e->span.hi - w.base, end_of(&w)), visit_cell, &w);
    hits->escalated += w.through.view.escalated;
}
