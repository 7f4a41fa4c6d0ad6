#include "common/swept.h"

enum { LOW_CAP, HIGH_CAP, PIECES };

/* How near to its start, in sizes, a ray's crossing of the piece it starts on is that start; and of another piece, beside
 * whose end it starts. */
static const double NEAR = 0x1p-30, BESIDE = 0x1p-44;

static void across(const common_swept *s, pov_vec3 v, double out[2])
{
    out[0] = v.x;
    out[1] = s->axis == 1 ? v.z : v.y;
}

static pov_vec3 joined(const common_swept *s, double x, double height, double y)
{
    return s->axis == 1 ? pov_vec3_of(x, height, y) : pov_vec3_of(x, y, height);
}

void common_swept_bounds(const common_swept *s, pov_vec3 *lo, pov_vec3 *hi)
{
    const common_outline *o = &s->outline;
    const double low = s->conic ? s->lo.hi : 1.0, high = s->conic ? s->hi.hi : 1.0;
    double a[2], b[2];

    for (int i = 0; i < 2; i++) {
        a[i] = pov_min(pov_min(o->lo[i] * low, o->lo[i] * high), pov_min(o->hi[i] * low, o->hi[i] * high));
        b[i] = pov_max(pov_max(o->lo[i] * low, o->lo[i] * high), pov_max(o->hi[i] * low, o->hi[i] * high));
        if (s->conic && low < 0.0 && high > 0.0) {
            a[i] = pov_min(a[i], 0.0);
            b[i] = pov_max(b[i], 0.0);
        }
    }
    *lo = joined(s, a[0], s->lo.hi, a[1]);
    *hi = joined(s, b[0], s->hi.hi, b[1]);
}

void common_swept_close(common_swept *s) { common_swept_bounds(s, &s->least, &s->most); }

/* ---- along a ray ---- */

/* The distance of a plane: to within `off`, and exactly where that has been needed. */
typedef struct plane { double about, off; pov_two exact; bool known; } plane;

/* A ray among the crossings of the outline. */
typedef struct walk {
    const common_swept *s;
    const common_ray *k;
    const common_cross *at;
    uint32_t count, start;       /* start: the crossing that the ray starts on, or count */
    uint32_t origin;             /* the feature that it starts on, or beyond them all */
    bool odd;                    /* inside the sweep before the first crossing */
    double base;                 /* the distance where their parameter is zero */
    pov_two from, along;         /* the ray across the planes */
    plane near, far;
    bool rising;                 /* it comes from below */
} walk;

static const plane never = { HUGE_VAL, 0.0, { HUGE_VAL, 0.0 }, true }, always = { -HUGE_VAL, 0.0, { -HUGE_VAL, 0.0 }, true };

static pov_two height_of(const walk *w, const plane *p) { return (p == &w->near) == w->rising ? w->s->lo : w->s->hi; }

/* Roundings of the difference, of the direction and of the quotient. */
static void find_plane(walk *w, plane *p)
{
    p->about = pov_two_sub(height_of(w, p), w->from).hi / w->along.hi;
    p->off = 0x1p-50 * fabs(p->about);
    p->known = false;
}

static void make_exact(walk *w, plane *p)
{
    if (!p->known)
        p->exact = pov_two_div(pov_two_sub(height_of(w, p), w->from), w->along);
    p->known = true;
}

static bool find_slab(walk *w)
{
    const pov_two3 dir = common_direction(w->k);

    w->from = w->s->axis == 1 ? w->k->f.y : w->k->f.z;
    w->along = w->s->axis == 1 ? dir.y : dir.z;
    w->rising = w->along.hi > 0.0;
    w->near = always;
    w->far = never;
    if (w->along.hi == 0.0)
        return pov_two_less(w->s->lo, w->from) && pov_two_less(w->from, w->s->hi);
    find_plane(w, &w->near);
    find_plane(w, &w->far);
    return true;
}

/* Is the plane before a distance, or behind it? */
static bool is_behind(walk *w, plane *p, pov_two t)
{
    if (!p->known && !(fabs(t.hi - p->about) > p->off))
        make_exact(w, p);
    return p->known ? pov_two_less(p->exact, t) : p->about < t.hi;
}

static bool is_ahead(walk *w, plane *p, pov_two t)
{
    if (!p->known && !(fabs(t.hi - p->about) > p->off))
        make_exact(w, p);
    return p->known ? pov_two_less(t, p->exact) : t.hi < p->about;
}

static uint32_t count_before(const walk *w, double t)
{
    uint32_t n = 0;

    while (n < w->count && w->base + w->at[n].s < t)
        n++;
    return n;
}

/* Crossings before a plane. */
static uint32_t count_up_to(walk *w, plane *p)
{
    for (uint32_t i = 0; !p->known && i < w->count; i++)
        if (!(fabs(w->base + w->at[i].s - p->about) > p->off))
            make_exact(w, p);
    return count_before(w, p->known ? p->exact.hi : p->about);
}

/* The crossing nearest to the start. */
static uint32_t find_start(const walk *w)
{
    uint32_t best = w->count;
    double least = HUGE_VAL;

    if (w->origin < PIECES || w->origin >= PIECES + w->s->outline.count)
        return w->count;
    for (uint32_t i = 0; i < w->count; i++) {
        const double limit = w->at[i].piece == w->origin - PIECES ? NEAR : BESIDE, off = fabs(w->at[i].s);

        if (off <= limit && off / limit < least) {
            least = off / limit;
            best = i;
        }
    }
    return best;
}

/* A line is outside where it passes the height of the apex. One through the apex itself crosses nothing else. */
static bool begins_in_cone(const walk *w, pov_vec3 p)
{
    const pov_vec3 d = w->k->d;
    const double along[2] = { d.x / d.y, d.z / d.y };

    if (p.x == p.y * along[0] && p.z == p.y * along[1])
        return common_outline_inside(&w->s->outline, along);
    return count_before(w, w->base - p.y / d.y) % 2 == 1;
}

/* Crossings of the line with the sweep, and where it begins inside: all but those that certainly are before `ahead` or behind `last`, or
 * in no interval between the planes. That one which the ray starts on is where it starts: a plane in the edge there comes before or behind it. */
static void find_crossings(walk *w, common_cross *room, double ahead, double last)
{
    const pov_vec3 p = pov_two3_hi(common_along_two(w->k, w->base));
    double a[2], d[2];

    across(w->s, p, a);
    across(w->s, w->k->d, d);
    w->at = room;
    w->count = 0;
    w->odd = false;
    if (w->s->conic) {
        w->count = common_outline_cross_cone(&w->s->outline, p, w->k->d, room);
        w->odd = w->k->d.y != 0.0 && begins_in_cone(w, p);
    } else if (d[0] != 0.0 || d[1] != 0.0) {
        const double near = w->near.about > ahead ? w->near.about : ahead, far = w->far.about < last ? w->far.about : last;
        const double range[2] = { near - w->base, far - w->base };

        w->count = common_outline_cross(&w->s->outline, a, d, range, room, &w->odd);
    } else {
        w->odd = common_outline_inside(&w->s->outline, a);
    }
    w->start = find_start(w);
    if (w->start < w->count)
        room[w->start].s = 0.0;
}

static bool report(const walk *w, pov_two t, uint32_t feature, double u, bool entering, pov_hits *hits)
{
    const pov_mark mark = { w->s->first + feature, 0, u, entering ? 1.0 : 0.0 };

    return pov_cross(hits, t.hi * w->k->unit, t.lo * w->k->unit, mark);
}

static bool report_cap(walk *w, bool is_near, pov_hits *hits)
{
    const uint32_t feature = is_near == w->rising ? LOW_CAP : HIGH_CAP;
    plane *p = is_near ? &w->near : &w->far;

    if (w->s->open || w->origin == feature || !(fabs(p->about) < HUGE_VAL))
        return true;
    if (p->about - p->off > common_wants(w->k, 0.0, 0.0, hits).far || (count_up_to(w, p) + w->odd) % 2 == 0)
        return true;
    make_exact(w, p);
    return report(w, p->exact, feature, 0.0, is_near, hits);
}

bool common_swept_cross(const common_swept *s, const pov_ray *ray, const common_entry *e, common_cross *room, pov_hits *hits)
{
    const bool from_here = ray->origin_surface == hits->owner;
    walk w;

    w.s = s;
    w.k = &e->k;
    w.origin = from_here ? ray->origin_mark.feature - s->first : UINT32_MAX;
    w.base = w.origin < PIECES + s->outline.count ? 0.0 : e->span.lo;
    if (!find_slab(&w))
        return true;
    find_crossings(&w, room, pov_min(hits->tmin * w.k->per_unit, 0.0) - 2.0 * NEAR, common_wants(w.k, 0.0, 0.0, hits).far + 2.0 * NEAR);
    for (uint32_t i = 0; i < w.count; i++) {
        const pov_two t = pov_two_sum(w.base, w.at[i].s);

        if (i == w.start || !is_behind(&w, &w.near, t) || !is_ahead(&w, &w.far, t))
            continue;
        if (!report(&w, t, PIECES + w.at[i].piece, w.at[i].u, (i + w.odd) % 2 == 0, hits))
            return false;
    }
    return report_cap(&w, true, hits) && report_cap(&w, false, hits);
}

bool common_swept_intersect(const common_swept *s, const pov_ray *ray, const common_ray *k, common_cross *room, pov_hits *hits)
{
    common_entry e;

    if (!common_clip(k, s->least, s->most, &e.span) || e.span.hi < 0.0 || e.span.lo * k->unit > hits->tmax)
        return true;
    e.k = *k;
    return common_swept_cross(s, ray, &e, room, hits);
}

/* ---- points ---- */

bool common_swept_inside(const common_swept *s, pov_two3 point)
{
    const pov_two height = s->axis == 1 ? point.y : point.z;
    double p[2];

    if (!pov_two_less(s->lo, height) || !pov_two_less(height, s->hi))
        return false;
    across(s, pov_two3_hi(point), p);
    if (s->conic) {
        p[0] /= height.hi;
        p[1] /= height.hi;
    }
    return common_outline_inside(&s->outline, p);
}

/* Across a piece, of any length: to the right of its way; of a cone, to the left. */
static pov_vec3 across_piece(const common_swept *s, const pov_mark *mark)
{
    double point[2], tangent[2];

    common_piece_at(&s->outline.at[mark->feature - s->first - PIECES], mark->u, point, tangent);
    return s->conic ? pov_cross_product(pov_vec3_of(tangent[0], 0.0, tangent[1]), pov_vec3_of(point[0], 1.0, point[1]))
                    : joined(s, tangent[1], 0.0, -tangent[0]);
}

bool common_swept_reversed(const common_swept *s, pov_vec3 dir, const pov_mark *mark)
{
    const uint32_t feature = mark->feature - s->first;
    const bool enters = mark->v > 0.0;

    if (feature < PIECES)
        return s->upward && feature == LOW_CAP;
    return ((pov_dot(across_piece(s, mark), dir) < 0.0) != enters) != (s->turned != s->conic);
}

/* Is it a plane's part? */
static bool is_planar(const common_swept *s, uint32_t feature) { return !s->conic && s->outline.at[feature - PIECES].degree == 1; }

void common_swept_normal(const common_swept *s, pov_vec3 dir, const pov_mark *mark, pov_vec3 *out)
{
    const uint32_t feature = mark->feature - s->first;

    if (feature < PIECES) {
        *out = joined(s, 0.0, feature == LOW_CAP ? -1.0 : 1.0, 0.0);
        return;
    }
    *out = is_planar(s, feature) ? joined(s, s->outline.across[feature - PIECES][0], 0.0, s->outline.across[feature - PIECES][1])
                               : pov_unit(across_piece(s, mark));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_unit(dir);
    if ((pov_dot(*out, dir) < 0.0) != (mark->v > 0.0))
        *out = pov_scale(*out, -1.0);
}
