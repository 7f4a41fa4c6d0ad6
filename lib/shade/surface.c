#include "shade/surface.h"

/* More surfaces on one spot than are told apart can hand a ray back and forth there: straight on does not count for the
 * depth. After this many crossings without a move the ray is cut off as too deep. */
enum { STANDING_MAX = 1000 };

static const coefficient whole = { { 1.0f, 1.0f, 1.0f }, 1.0f };

bool surface_meet(pov_tracer *t, surface *s)
{
    const uint32_t which = t->model->objects.items[s->at->object].material;
    const plan_look *look = &t->plan->looks[which];

    s->look = look;
    s->lit = colour_of(0.0f, 0.0f, 0.0f);
    if (!look->lit && t->plan->lighting)
        t->counts.shadow_idle += t->model->lights.count;
    return look->lit || look->mirrors || look->passes;
}

/* ---- the rays that go on ---- */

/* What cuts rays off, and how many it did. */
typedef struct limits { int level; float weight; uint64_t cut_depth, cut_weight; } limits;

/* Begin a path that goes on from the surface, by a direction without a low part; what its ray leaves is still to be named.
 * Its factor is not yet that of the way it takes. */
static inline path *leave(batch *b, const surface *s, pov_vec3 direction)
{
    const path *p = s->from;
    path *next = &b->paths[b->count];
    pov_ray *ray = &b->room[b->count];

    ray->org = s->at->point;
    ray->org_lo = s->at->point_lo;
    ray->dir = direction;
    next->factor = p->factor;
    next->level = p->level;
    next->lane = p->lane;
    next->spot = s->spot;
    next->above = s->above;
    next->media = p->media;
    next->standing = 0;
    return next;
}

/* To the surface's other side, where other surfaces may begin. */
static path *leave_across(batch *b, const surface *s, pov_vec3 direction)
{
    path *next = leave(b, s, direction);

    b->room[b->count].left = s->at->object;
    b->room[b->count].left_mark = s->at->crossing.mark;
    next->above ^= 1u << s->on;
    return next;
}

/* Take a path on by a coefficient. False: it is cut off. The depth is asked first, so that a ray is counted
 * once. */
static inline bool goes_on(limits *l, path *next, const coefficient *by, bool deeper)
{
    next->factor = coefficient_mul(next->factor, *by);
    if (deeper && next->level >= l->level) {
        l->cut_depth++;
        return false;
    }
    if (!(next->factor.weight >= l->weight)) {
        l->cut_weight++;
        return false;
    }
    next->level += deeper;
    return true;
}

/* Here and below: true when the ray goes on. */
static inline bool reflect(pov_tracer *t, limits *l, uint32_t lane, const coefficient *by)
{
    const surface *s = &t->surfaces[lane];
    batch *b = t->mirrored;
    const bool goes = goes_on(l, leave(b, s, lanes_at(&t->geometry.mirrored, lane)), by, true);

    world_leave(&b->room[b->count], s->at, t->geometry.cosine[lane]);
    b->count += goes;
    return goes;
}

/* Straight on, whatever lies on both sides. */
static bool pass(pov_tracer *t, limits *l, const surface *s)
{
    const pov_vec3 from = s->ray->org, to = s->at->point;
    path *out = leave_across(t->passed, s, s->ray->dir);

    if (!goes_on(l, out, &s->look->filter, false))
        return false;
    if (from.x == to.x && from.y == to.y && from.z == to.z)
        out->standing = s->from->standing + 1;
    if (out->standing > STANDING_MAX) {
        l->cut_depth++;
        return false;
    }
    return true;
}

/* The mirrored ray of an ordinary surface. */
static inline void mirror(pov_tracer *t, limits *l, uint32_t lane)
{
    const plan_look *look = t->surfaces[lane].look;

    if (look->mirrors)
        reflect(t, l, lane, &look->mirror);
}

/* Both rays that can go on from a surface between two media. The list of media goes on with the transmitted
 * ray; a mirrored one stays in what it was in. */
static void bend(pov_tracer *t, limits *l, uint32_t lane)
{
    const surface *s = &t->surfaces[lane];
    const geometry *g = &t->geometry;
    const pov_vec3 view = lanes_at(&g->view, lane), normal = lanes_at(&g->normal, lane);
    media_crossing c = media_cross(&t->media, s->from->media, t->model, s->at->object);
    path *out = &t->passed->paths[t->passed->count];
    pov_vec3 direction;
    bool passes;

    if (c.before == c.after) {
        passes = pass(t, l, s);
    } else if (refract(view, normal, g->cosine[lane], c.before, c.after, &direction)) {
        passes = goes_on(l, leave_across(t->passed, s, direction), &s->look->filter, true);
    } else {
        t->counts.inner_reflections += reflect(t, l, lane, &whole);
        return;
    }
    mirror(t, l, lane);
    if (passes && !media_pass(&t->media, t->env, &out->media, &c))
        t->failed = true;
    t->passed->count += passes;
}

void surface_branch(pov_tracer *t, uint32_t n)
{
    limits l = { t->model->max_trace_level, (float)t->model->adc_bailout, 0, 0 };

    for (uint32_t i = 0; i < n; i++) {
        const surface *s = &t->surfaces[i];

        if (s->look->passes && t->plan->refraction) {
            bend(t, &l, i);
        } else {
            mirror(t, &l, i);
            if (s->look->passes)
                t->passed->count += pass(t, &l, s);
        }
    }
    t->counts.cut_depth += l.cut_depth;
    t->counts.cut_weight += l.cut_weight;
    t->counts.reflected += t->mirrored->count;
    t->counts.transmitted += t->passed->count;
}
