#include "shade/surface.h"

/* More surfaces on one spot than are told apart can hand a ray back and forth there: straight on does not count for the
 * depth. After this many crossings without a move the ray is cut off as too deep. */
enum { STANDING_MAX = 1000 };

static const coefficient whole = { { 1.0f, 1.0f, 1.0f }, 1.0f };

/* ---- the rays that go on ---- */

/* What cuts rays off, and how many it did. */
typedef struct limits { int level; float weight; uint64_t cut_depth, cut_weight; } limits;

/* Is a path that goes on from p with this factor followed? The depth is asked first, so that a ray is counted once. */
static inline bool goes_on(limits *l, const path *p, const coefficient *factor, bool deeper)
{
    if (deeper && p->level >= l->level) {
        l->cut_depth++;
        return false;
    }
    if (!(factor->weight >= l->weight)) {
        l->cut_weight++;
        return false;
    }
    return true;
}

/* Begin the path that goes on from the surface, by a direction without a low part. What its ray leaves is still to be
 * named, and the path to be counted. */
static inline path *leave(batch *b, const surface *s, pov_vec3 direction, coefficient factor, bool deeper)
{
    const path *p = s->from;
    path *next = &b->paths[b->count];
    pov_ray *ray = &b->room[b->count];

    ray->org = s->at->point;
    ray->org_lo = s->at->point_lo;
    ray->dir = direction;
    next->factor = factor;
    next->level = p->level + deeper;
    next->lane = p->lane;
    next->spot = s->spot;
    next->above = s->above;
    next->media = p->media;
    next->standing = 0;
    return next;
}

/* To the surface's other side, where other surfaces may begin, at this cosine to the normal there. NULL: the path is
 * cut off. */
static path *leave_across(batch *b, limits *l, const surface *s, pov_vec3 direction, double cosine, bool deeper)
{
    const coefficient factor = coefficient_mul(s->from->factor, s->look->filter);
    path *next;

    if (!goes_on(l, s->from, &factor, deeper))
        return NULL;
    next = leave(b, s, direction, factor, deeper);
    world_cross(&b->room[b->count], s->at, cosine);
    next->above ^= 1u << s->on;
    return next;
}

/* Back to the side that the ray came from. */
static inline void reflect(pov_tracer *t, limits *l, uint32_t lane, const coefficient *by)
{
    const surface *s = &t->surfaces[lane];
    const coefficient factor = coefficient_mul(s->from->factor, *by);
    batch *b = t->mirrored;

    if (!goes_on(l, s->from, &factor, true))
        return;
    leave(b, s, lanes_at(&t->geometry.mirrored, lane), factor, true);
    world_leave(&b->room[b->count++], s->at, t->geometry.cosine[lane]);
}

/* Straight on, whatever lies on both sides. NULL: the path is cut off. */
static path *pass(pov_tracer *t, limits *l, uint32_t lane)
{
    const surface *s = &t->surfaces[lane];
    const pov_vec3 from = s->ray->org, to = s->at->point;
    path *out = leave_across(t->passed, l, s, s->ray->dir, t->geometry.cosine[lane], false);

    if (!out)
        return NULL;
    if (from.x == to.x && from.y == to.y && from.z == to.z)
        out->standing = s->from->standing + 1;
    if (out->standing > STANDING_MAX) {
        l->cut_depth++;
        return NULL;
    }
    return out;
}

/* The mirrored ray of an ordinary surface. */
static inline void mirror(pov_tracer *t, limits *l, uint32_t lane)
{
    const plan_look *look = t->surfaces[lane].look;

    if (look->mirrors)
        reflect(t, l, lane, &look->mirror);
}

/* What rays that are bent cross, and where they go on. */
typedef struct passages { media_crossing crossing[BATCH_MAX]; bends to; } passages;

static void find_passages(const pov_tracer *t, passages *p, uint32_t n)
{
    const geometry *g = &t->geometry;
    bool any = false;

    for (uint32_t i = 0; i < lanes_whole(n); i++)
        p->to.before[i] = p->to.after[i] = 1.0;
    for (uint32_t i = 0; i < n; i++) {
        const surface *s = &t->surfaces[i];

        if (!s->look->passes)
            continue;
        media_cross(&t->media, s->from->media, t->model, s->at->object, &p->crossing[i]);
        p->to.before[i] = p->crossing[i].before;
        p->to.after[i] = p->crossing[i].after;
        any = true;
    }
    if (any)
        refract_many(&p->to, &g->view, &g->to.normal, g->cosine, n);
}

/* Both rays that can go on from a surface between two media. The list of media goes on with the transmitted
 * ray; a mirrored one stays in what it was in. */
static void part(pov_tracer *t, limits *l, const passages *p, uint32_t lane)
{
    const surface *s = &t->surfaces[lane];
    const media_crossing *c = &p->crossing[lane];
    const uint32_t before = t->mirrored->count;
    path *out;

    if (c->before == c->after) {
        out = pass(t, l, lane);
    } else if (p->to.squared_cosine[lane] > 0.0) {
        const pov_vec3 way = lanes_at(&p->to.way, lane);

        out = leave_across(t->passed, l, s, way, -pov_dot(way, lanes_at(&t->geometry.to.normal, lane)), true);
    } else {
        reflect(t, l, lane, &whole);
        t->counts.inner_reflections += t->mirrored->count - before;
        return;
    }
    mirror(t, l, lane);
    if (out && !media_pass(&t->media, t->env, &out->media, c))
        t->failed = true;
    t->passed->count += out != NULL;
}

void surface_branch(pov_tracer *t, uint32_t n)
{
    limits l = { t->model->max_trace_level, (float)t->model->adc_bailout, 0, 0 };
    passages p;

    if (t->plan->refraction)
        find_passages(t, &p, n);
    for (uint32_t i = 0; i < n; i++) {
        const surface *s = &t->surfaces[i];

        if (s->look->passes && t->plan->refraction) {
            part(t, &l, &p, i);
        } else {
            mirror(t, &l, i);
            if (s->look->passes)
                t->passed->count += pass(t, &l, i) != NULL;
        }
    }
    t->counts.cut_depth += l.cut_depth;
    t->counts.cut_weight += l.cut_weight;
    t->counts.reflected += t->mirrored->count;
    t->counts.transmitted += t->passed->count;
}
