/* contract_blocks.c - what a filter of a block says is never wrong. */
#include "plugins/contract.h"
#include "plugins/subject.h"

#include "support/check.h"
#include "support/fake_reader.h"

#include <povtrace/exact.h>

#include <math.h>
#include <string.h>

/* What a filter says of one ray and one thing is right; m is NULL where it says nothing. */
static bool is_right(const pov_candidate *m, const thing *t, const pov_ray *ray, double tmax)
{
    pov_crossing at[MOST];
    const uint32_t found = subject_ask_in(t->self, ray, POV_WANT_NEAREST, 0.0, tmax, true, at);

    if (!m)
        return !found;
    if (m->definite_pair && !m->definite)
        return false;
    if (found && at[0].t < m->lo)
        return false;
    if (m->definite && (!found || at[0].t > m->hi))
        return false;
    return !m->definite_pair || subject_ask_in(t->self, ray, POV_WANT_ALL, 0.0, tmax, true, at) == 2;
}

/* Around all of them, as a world's are: half of what is in it is below one. False: they have no box. */
static bool frame_around(const thing *const *things, uint32_t n, pov_frame *out)
{
    pov_vec3 lo, hi;
    pov_box box;
    uint32_t i;
    int e;

    for (i = 0; i < n; i++) {
        if (!subject.shape->bounds(things[i]->self, &box) || !(pov_largest(box.lo) < 1e150 && pov_largest(box.hi) < 1e150))
            return false;
        lo = i > 0 ? pov_vec3_of(fmin(lo.x, box.lo.x), fmin(lo.y, box.lo.y), fmin(lo.z, box.lo.z)) : box.lo;
        hi = i > 0 ? pov_vec3_of(fmax(hi.x, box.hi.x), fmax(hi.y, box.hi.y), fmax(hi.z, box.hi.z)) : box.hi;
    }
    out->centre = pov_add(pov_scale(lo, 0.5), pov_scale(hi, 0.5));
    frexp(fmax(0.5 * pov_largest(pov_sub(hi, lo)), fmax(fmax(pov_largest(lo), pov_largest(hi)) * 0x1p-50, 1e-300)), &e);
    out->scale = ldexp(1.0, -e);
    return true;
}

static size_t single_block_size(void)
{
    const shape_class *s = subject.shape;

    return s->single_block_size > 0 ? s->single_block_size : s->block_size;
}

static bool is_filled(const unsigned char *from, const unsigned char *to, unsigned char with)
{
    for (; from < to; from++)
        if (*from != with)
            return false;
    return true;
}

/* A block for one shape ends sooner: what is behind it is nobody's, and no number. */
static bool pack(unsigned char *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    unsigned char *end = block + subject.shape->block_size, *behind = n == 1 ? block + single_block_size() : end;
    bool takes;

    memset(block, 0, subject.shape->block_size);
    memset(behind, 0xff, (size_t)(end - behind));
    takes = subject.shape->block_pack(block, frame, selves, n);
    assert_true(is_filled(behind, end, 0xff));
    return takes;
}

/* Up to POV_BLOCK_MAX of the subject's things in a block, or one of them as often, and the frame that they are in; its
 * scale is zero where there is none. 0: it declines them. */
static uint32_t pack_some(void *block, const thing **things, pov_frame *frame)
{
    const uint32_t n = 1 + (uint32_t)(POV_BLOCK_MAX * subject_uniform());
    const bool alike = subject_uniform() < 0.4;
    const void *selves[POV_BLOCK_MAX];
    bool local;
    uint32_t i;

    for (i = 0; i < n; i++) {
        things[i] = alike && i > 0 ? things[0]
                                   : &subject.things[(int)((subject.count + subject.hard) * subject_uniform())];
        selves[i] = things[i]->self;
    }
    local = frame_around(things, n, frame);
    if (!local)
        frame->scale = 0.0;
    return pack(block, local ? frame : NULL, selves, n) ? n : 0;
}

/* A ray along the surface of one, or off that by little: from the side of a crossing, across its normal. */
static pov_ray grazing_ray(const thing *t, pov_ray ray)
{
    pov_crossing at[MOST];
    const uint32_t n = subject_ask(t->self, &ray, at);
    pov_vec3 normal, at_point, low;
    double tilt;

    if (n == 0)
        return ray;
    subject.shape->normal(t->self, &ray, &at[0], &normal);
    subject_point(&ray, at[0].t, at[0].t_lo, &at_point, &low);
    tilt = pov_dot(ray.dir, normal) * (1.0 - (subject_uniform() < 0.3 ? 0.0 : pow(10.0, -16.0 * subject_uniform())));
    ray.dir = pov_sub(ray.dir, pov_scale(normal, tilt));
    ray.org = pov_sub(at_point, pov_scale(ray.dir, t->size / subject_length(ray.dir) * 100.0 * subject_uniform()));
    ray.org = pov_add(ray.org, pov_scale(normal, t->size * (subject_uniform() < 0.5 ? -1.0 : 1.0)
                                                     * pow(10.0, -17.0 * subject_uniform())));
    return ray;
}

/* One that starts on the surface, in double-double. */
static pov_ray starting_ray(const thing *t, pov_ray ray)
{
    pov_crossing at[MOST];
    const uint32_t n = subject_ask(t->self, &ray, at);
    pov_vec3 point, low;

    if (n > 0) {
        subject_point(&ray, at[0].t, at[0].t_lo, &point, &low);
        ray.org = point;
        ray.org_lo = low;
        ray.dir = subject_direction();
    }
    return ray;
}

/* Low parts of a direction are those that a map leaves. */
static double lower(double d) { return d * 0x1p-54 * (2.0 * subject_uniform() - 1.0); }

/* All that rays can be: far off, along the surface or from it, parallel to axes, with low parts. */
static pov_ray block_ray(const thing *t)
{
    const int family = (int)(8.0 * subject_uniform());
    pov_ray ray = subject_ray(t);

    if (family == 0)
        ray.org = pov_sub(ray.org, pov_scale(ray.dir, t->size / subject_length(ray.dir)
                                                          * pow(10.0, 12.0 * subject_uniform())));
    else if (family == 1)
        ray = grazing_ray(t, ray);
    else if (family == 2)
        ray = starting_ray(t, ray);
    else if (family == 3)
        ray.dir_lo = pov_vec3_of(lower(ray.dir.x), lower(ray.dir.y), lower(ray.dir.z));
    else if (family == 4 && subject_uniform() < 0.5)
        ray.dir = pov_vec3_of(0.0, subject_uniform() < 0.5 ? -0.0 : 0.0, ray.dir.z);
    else if (family == 4)
        ray.dir = pov_vec3_of(ray.dir.x, subject_uniform() < 0.5 ? -0.0 : 1e-250, -0.0);
    else if (family == 5)
        ray.dir = pov_scale(ray.dir, pow(10.0, 200.0 * subject_uniform() - 100.0));
    if (family > 4 && subject_uniform() < 0.1)
        ray.dir.x = 0.0;
    if (family > 4 && subject_uniform() < 0.05)
        ray.dir.y = -0.0;
    return ray;
}

/* Put the ray where filters want it, unless it is out of the range that they are promised. */
static bool put_in_range(pov_rays *rays, uint32_t i, const pov_ray *ray, double tmax)
{
    const double o[3] = { ray->org.x, ray->org.y, ray->org.z }, d[3] = { ray->dir.x, ray->dir.y, ray->dir.z };
    const double low[3] = { ray->org_lo.x, ray->org_lo.y, ray->org_lo.z };
    int k;

    for (k = 0; k < 3; k++) {
        if (!(fabs(o[k]) < 1e99) || (d[k] != 0.0 && !(fabs(d[k]) > 1e-80 && fabs(d[k]) < 1e80)))
            return false;
        rays->org[k][i] = o[k];
        rays->org_lo[k][i] = low[k];
        rays->dir[k][i] = d[k];
    }
    rays->inverse[i] = 1.0 / pov_dot(ray->dir, ray->dir);
    rays->per_length[i] = sqrt(rays->inverse[i]);
    rays->size[i] = fabs(o[0]) + fabs(o[1]) + fabs(o[2]);
    rays->tmax[i] = tmax;
    return pov_largest(ray->dir) > 0.0 && pov_largest(ray->dir_lo) == 0.0;
}

/* And in the frame, from near it. False: its line passes far by, or it goes the other way. */
static bool put_in_frame(pov_rays *rays, uint32_t i, const pov_ray *ray, const pov_frame *f)
{
    const double length = subject_length(ray->dir), scale = f->scale * length;
    const pov_vec3 d = pov_scale(ray->dir, 1.0 / length);
    pov_vec3 o = pov_scale(pov_add(pov_sub(ray->org, f->centre), ray->org_lo), f->scale);
    double along = -pov_dot(o, d), shift = 0.0, smax;

    if (!(scale > 1e-280 && scale < 1e280))
        return false;
    if (pov_largest(o) > 8.0) {
        shift = (along - 4.0 - pov_largest(o) * 0x1p-48) / scale;
        if (!(shift > 0.0))
            return false;
        o = pov_scale(pov_vec3_of(pov_recentre(ray->org.x, ray->org_lo.x, f->centre.x, shift, ray->dir.x).hi,
                                  pov_recentre(ray->org.y, ray->org_lo.y, f->centre.y, shift, ray->dir.y).hi,
                                  pov_recentre(ray->org.z, ray->org_lo.z, f->centre.z, shift, ray->dir.z).hi), f->scale);
        if (!(pov_largest(o) <= 8.0))
            return false;
    }
    smax = (rays->tmax[i] - shift) * scale;
    rays->local.org[0][i] = (float)o.x, rays->local.org[1][i] = (float)o.y, rays->local.org[2][i] = (float)o.z;
    rays->local.dir[0][i] = (float)d.x, rays->local.dir[1][i] = (float)d.y, rays->local.dir[2][i] = (float)d.z;
    rays->local.size[i] = (float)(fabs(o.x) + fabs(o.y) + fabs(o.z) + fabs(shift) * scale * 0x1p-22);
    rays->local.smax[i] = (float)fmin(smax + fabs(smax) * 0x1p-22 + fabs(shift) * scale * 0x1p-46, 1e38);
    rays->local.shift[i] = shift;
    rays->local.unit[i] = 1.0 / scale;
    return true;
}

/* One that passes near the thing as another does, apart from it by parts of the thing's size. */
static pov_ray beside(const thing *t, pov_ray ray, double org, double dir)
{
    const double length = subject_length(ray.dir), way = subject_length(pov_sub(t->middle, ray.org)) + t->size;
    const pov_vec3 off = pov_scale(subject_direction(), t->size * dir * subject_uniform() / way);

    ray.org = pov_add(ray.org, pov_scale(subject_direction(), t->size * org * subject_uniform()));
    ray.dir = pov_scale(pov_unit(pov_add(pov_scale(ray.dir, 1.0 / length), off)), length);
    return ray;
}

/* From near the start of another to a point of the sphere around the thing. */
static pov_ray aimed(const thing *t, pov_ray ray, double org)
{
    const pov_vec3 at = pov_add(t->middle, pov_scale(subject_direction(), 0.5 * t->size));

    ray.org = pov_add(ray.org, pov_scale(subject_direction(), t->size * org * subject_uniform()));
    ray.dir = pov_scale(pov_unit(pov_sub(at, ray.org)), subject_length(ray.dir));
    return ray;
}

/* A packet, as it comes from a camera or a mirror: one ray and others beside it, or one that goes elsewhere. */
static void packet_rays(const thing *t, pov_ray *out)
{
    const bool alike = subject_uniform() < 0.3;
    const double org = subject_uniform() < 0.5 ? 0.0 : pow(10.0, -8.0 * subject_uniform());
    const double dir = alike ? 0.0 : pow(10.0, 1.0 - 8.0 * subject_uniform());
    const pov_ray one = block_ray(t), past = beside(t, one, 0.0, 4.0);
    const bool some = subject_uniform() < 0.5;
    uint32_t i;

    for (i = 0; i < POV_RAYS_MAX; i++)
        out[i] = some ? beside(t, one, org, dir) : past;
    if (!some)
        out[(uint32_t)(POV_RAYS_MAX * subject_uniform())] = aimed(t, past, org);
}

static void block_rays(const thing *const *things, uint32_t n, pov_ray *out)
{
    uint32_t i;

    if (subject_uniform() < 0.6) {
        packet_rays(things[(uint32_t)(n * subject_uniform())], out);
        return;
    }
    for (i = 0; i < POV_RAYS_MAX; i++)
        out[i] = block_ray(things[(uint32_t)(n * subject_uniform())]);
}

/* A ray that nothing is known of, as a world says it. */
static void put_blind(pov_rays *rays, uint32_t i)
{
    int k;

    for (k = 0; k < 3; k++) {
        rays->local.org[k][i] = 0.0f;
        rays->local.dir[k][i] = 1.0f;
    }
    rays->local.size[i] = rays->local.smax[i] = HUGE_VALF;
    rays->local.shift[i] = 0.0;
    rays->local.unit[i] = 1.0;
}

/* What stands in a lane that nobody asks for: anything. */
static void put_nothing(pov_rays *rays, uint32_t i)
{
    int k;

    for (k = 0; k < 3; k++) {
        rays->local.org[k][i] = NAN;
        rays->local.dir[k][i] = subject_uniform() < 0.5 ? NAN : HUGE_VALF;
    }
    rays->local.size[i] = subject_uniform() < 0.5 ? NAN : HUGE_VALF;
}

/* Which of the rays are where filters want them. */
static uint64_t put_rays(pov_rays *rays, const pov_ray *ray, const pov_frame *frame, const thing *const *things, uint32_t n)
{
    const double asked = subject_uniform() < 0.5 ? 0.95 : 0.6, blind = subject_uniform() < 0.2 ? 0.05 : 0.0;
    uint64_t lanes = 0;
    uint32_t i;

    for (i = 0; i < POV_RAYS_MAX; i++) {
        const double scale = things[(uint32_t)(n * subject_uniform())]->size / subject_length(ray[i].dir);
        const double tmax = subject_uniform() < 0.5 ? HUGE_VAL : 20.0 * scale * subject_uniform();

        if (subject_uniform() < asked && put_in_range(rays, i, &ray[i], tmax)
            && (frame->scale == 0.0 || put_in_frame(rays, i, &ray[i], frame)))
            lanes |= (uint64_t)1 << i;
        else
            put_nothing(rays, i);
        if (subject_uniform() < blind)
            put_blind(rays, i);
    }
    return lanes;
}

static bool is_alike(const pov_hits *a, const pov_hits *b)
{
    return a->count == b->count && a->count == 1 && a->at->t == b->at->t && a->at->t_lo == b->at->t_lo
           && a->at->mark.feature == b->at->mark.feature && a->tmax == b->tmax;
}

/* Whom rays definitely cross, all at once; how many get another answer than alone. */
static int wrong_crossings(const pov_candidate *candidates, uint32_t count, const thing *const *things,
                           const pov_ray *ray, const double *tmax)
{
    static const void *selves[POV_CANDIDATES_MAX];
    static const pov_ray *rays[POV_CANDIDATES_MAX];
    static pov_hits hits[2][POV_CANDIDATES_MAX], *asked[POV_CANDIDATES_MAX];
    static pov_crossing at[2][POV_CANDIDATES_MAX];
    uint32_t n = 0, i;
    int wrong = 0;

    for (i = 0; i < count; i++) {
        if (!candidates[i].definite)
            continue;
        selves[n] = things[candidates[i].lane]->self;
        rays[n] = &ray[candidates[i].ray];
        hits[0][n] = subject_nearest(tmax[candidates[i].ray], &at[0][n]);
        hits[1][n] = subject_nearest(tmax[candidates[i].ray], &at[1][n]);
        asked[n] = &hits[1][n];
        subject.shape->intersect(selves[n], rays[n], &hits[0][n]);
        n++;
    }
    if (n > 0)
        subject.shape->cross_many(selves, rays, asked, n);
    for (i = 0; i < n; i++)
        wrong += !is_alike(&hits[0][i], &hits[1][i]);
    return wrong;
}

/* Start a ray shortly before its crossing. */
static void come_near(const void *self, pov_ray *ray, double *end)
{
    pov_crossing at;
    pov_hits hits = subject_nearest(*end, &at);
    double t;

    subject.shape->intersect(self, ray, &hits);
    t = hits.count ? at.t * (1.0 - 1.0 / (2.0 + 1e6 * pow(subject_uniform(), 4.0))) : 0.0;
    ray->org = pov_add(ray->org, pov_scale(ray->dir, t));
    *end -= t;
}

/* The same without sinks: the crossings are those of intersect(), and where they are is known. */
static int wrong_sure(const pov_candidate *candidates, uint32_t count, const thing *const *things, const pov_ray *ray, const double *tmax)
{
    const void *selves[POV_RAYS_MAX];
    const pov_ray *rays[POV_RAYS_MAX];
    pov_crossing at[POV_RAYS_MAX], *to[POV_RAYS_MAX];
    pov_contact contacts[POV_RAYS_MAX], *where[POV_RAYS_MAX];
    double ends[POV_RAYS_MAX];
    static pov_ray moved[POV_RAYS_MAX];
    uint32_t n = 0;
    uint64_t open;
    int wrong = 0;

    memset(at, 0, sizeof at);
    for (uint32_t i = 0; i < count && n < POV_RAYS_MAX; i++)
        if (candidates[i].definite) {
            selves[n] = things[candidates[i].lane]->self;
            moved[n] = ray[candidates[i].ray];
            rays[n] = &moved[n];
            ends[n] = tmax[candidates[i].ray];
            if (subject_uniform() < 0.3)
                come_near(selves[n], &moved[n], &ends[n]);
            where[n] = &contacts[n];
            to[n] = &at[n];
            n++;
        }
    if (n == 0)
        return 0;
    if (subject_uniform() < 0.5)
        n = 1 + (uint32_t)((n - 1) * subject_uniform());
    open = subject.shape->cross_sure(selves, rays, to, where, n);
    for (uint32_t i = 0; i < n; i++) {
        pov_crossing alone;
        pov_hits hits = subject_nearest(ends[i], &alone);

        subject.shape->intersect(selves[i], rays[i], &hits);
        if (!(open >> i & 1))
            wrong += hits.count != 1 || alone.t != at[i].t || alone.t_lo != at[i].t_lo || memcmp(&alone.mark, &at[i].mark, sizeof alone.mark) != 0 ||
                     !subject_is_contact(selves[i], rays[i], &at[i], &contacts[i]);
    }
    return wrong;
}

/* Does a ray that starts on the thing cross it? */
static bool is_left_open(const thing *t, pov_ray ray, double tmax)
{
    pov_crossing at;
    pov_hits hits = subject_nearest(tmax, &at);

    ray.origin_surface = hits.owner;
    subject.shape->intersect(t->self, &ray, &hits);
    return hits.count > 0;
}

/* The bounds by lane, of shapes with one crossing, as a host takes them. */
static int wrong_bounds(const void *block, const thing *const *things, uint32_t n, const pov_rays *rays, const pov_ray *ray, uint64_t lanes)
{
    double lo[POV_RAYS_MAX], hi[POV_RAYS_MAX];
    int wrong = 0;

    for (uint32_t k = 0; k < n; k++) {
        subject.shape->block_bounds(block, k, rays, lanes, lo, hi);
        for (uint32_t i = 0; i < POV_RAYS_MAX; i++) {
            const double tmax = rays->tmax[i];
            const pov_candidate m = { .lo = lo[i], .hi = hi[i], .definite = lo[i] > 0.0 && hi[i] < tmax };

            if (lanes >> i & 1)
                wrong += !is_right(lo[i] > tmax || hi[i] < 0.0 ? NULL : &m, things[k], &ray[i], tmax) || is_left_open(things[k], ray[i], tmax);
        }
    }
    return wrong;
}

/* Rays at some things; how many of the answers are wrong. */
static int wrong_answers(const void *block, const pov_frame *frame, const thing *const *things, uint32_t n, int *seen)
{
    static pov_rays rays;
    static pov_ray ray[POV_RAYS_MAX];
    static const pov_ray *of_lanes[POV_RAYS_MAX];
    static pov_candidate candidates[POV_CANDIDATES_MAX];
    static const uint32_t owners[POV_BLOCK_MAX] = { 11, 12, 13, 14, 15, 16, 17, 18 };
    const bool convex = subject.shape->flags & POV_SHAPE_CONVEX;
    const pov_candidate *of[POV_RAYS_MAX][POV_BLOCK_MAX];
    uint64_t lanes;
    uint32_t count, i, k;
    int broken = 0;

    block_rays(things, n, ray);
    lanes = put_rays(&rays, ray, frame, things, n);
    for (i = 0; i < POV_RAYS_MAX; i++)
        of_lanes[i] = &ray[i];
    rays.rays = subject_uniform() < 0.9 ? of_lanes : NULL;
    for (i = 0; i < POV_RAYS_MAX; i++)
        rays.excluded[i] = subject_uniform() < 0.3 ? owners[(uint32_t)(n * subject_uniform())] : POV_NO_OWNER;
    /* Now and then one alone. */
    if (subject_uniform() < 0.3)
        lanes &= ~(lanes - 1);
    if (!lanes)
        return 0;
    memset(of, 0, sizeof of);
    count = subject.shape->block_filter(block, owners, &rays, lanes, candidates);
    for (i = 0; i < count; i++) {
        if (candidates[i].ray >= POV_RAYS_MAX || !(lanes >> candidates[i].ray & 1) || candidates[i].lane >= n ||
            of[candidates[i].ray][candidates[i].lane]) return 1;
        of[candidates[i].ray][candidates[i].lane] = &candidates[i];
        *seen += candidates[i].definite;
    }
    if (HAS(cross_many))
        broken += wrong_crossings(candidates, count, things, ray, rays.tmax);
    if (HAS(block_bounds))
        broken += wrong_bounds(block, things, n, &rays, ray, lanes);
    if (HAS(cross_sure))
        broken += wrong_sure(candidates, count, things, ray, rays.tmax);
    for (i = 0; i < POV_RAYS_MAX; i++)
        for (k = 0; (lanes >> i & 1) && k < n; k++)
            if ((of[i][k] || !convex || rays.excluded[i] != owners[k])
                && !is_right(of[i][k], things[k], &ray[i], rays.tmax[i]) && broken++ < 2)
                print_error("%s { %s }\n    from <%.17g, %.17g, %.17g> along <%.17g, %.17g, %.17g> to %.17g: %s\n",
                            subject.shape->keyword, things[k]->text, ray[i].org.x, ray[i].org.y, ray[i].org.z,
                            ray[i].dir.x, ray[i].dir.y, ray[i].dir.z, rays.tmax[i],
                            of[i][k] ? "the filter's bounds are wrong" : "the filter leaves a crossing out");
    return broken;
}

void block_filters_never_exclude_a_crossing(void **unused)
{
    void *block;
    int round, broken = 0, packed = 0, seen = 0;

    (void)unused;
    if (!HAS(block_pack))
        subject_skip("has no block_pack");
    block = fake_reader_memory(subject.in, subject.shape->block_size);
    for (round = 0; round < 6000; round++) {
        const thing *things[POV_BLOCK_MAX];
        pov_frame frame;
        const uint32_t n = pack_some(block, things, &frame);

        if (n == 0)
            continue;
        packed++;
        broken += wrong_answers(block, &frame, things, n, &seen);
    }
    assert_true(packed > 0);
    assert_int_equal(broken, 0);
    /* A filter that is never sure is of no use. */
    assert_true(seen > 0);
}
