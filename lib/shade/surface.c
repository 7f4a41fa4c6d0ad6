#include "shade/surface.h"

/* More surfaces on one spot than are told apart can hand a ray back and forth there: straight on does not count for the
 * depth. After this many crossings without a move the ray is cut off as too deep. */
enum { STANDING_MAX = 1000 };

static const colour white = { 1.0f, 1.0f, 1.0f };

bool surface_meet(pov_tracer *t, surface *s)
{
    const uint32_t which = t->model->objects.items[s->at->object].material;
    const plan_look *look = &t->plan->looks[which];

    s->material = &t->model->materials.items[which];
    s->look = look;
    s->lit = colour_of(0.0f, 0.0f, 0.0f);
    if (!look->lit && t->plan->lighting)
        t->counts.shadow_idle += t->model->lights.count;
    return look->lit || look->mirrors || look->passes;
}

/* ---- the rays that go on ---- */

/* Begin a path that goes on from the surface, by a direction without a low part. Its factor and weight are not yet those of the way it takes. */
static path *leave(batch *b, const surface *s, pov_vec3 direction)
{
    const path *p = s->from;
    path *next = &b->paths[b->count];
    pov_ray *ray = &b->room[b->count];

    b->rays[b->count] = ray;
    ray->org = s->at->point;
    ray->org_lo = s->at->point_lo;
    ray->dir = direction;
    ray->left = s->at->object;
    ray->left_mark = s->at->crossing.mark;
    next->factor = p->factor;
    next->weight = p->weight;
    next->level = p->level;
    next->standing = 0;
    next->lane = p->lane;
    next->media = p->media;
    next->spot = s->spot;
    next->above = s->above;
    return next;
}

/* To the surface's other side, where other surfaces may begin. */
static path *leave_across(batch *b, const surface *s, pov_vec3 direction)
{
    path *next = leave(b, s, direction);

    next->above ^= 1u << s->on;
    return next;
}

/* Take a path on by a coefficient. False: it is cut off. The depth is asked first, so that a ray is counted
 * once. */
static bool goes_on(pov_tracer *t, path *next, colour coefficient, bool deeper)
{
    next->factor = colour_mul(next->factor, coefficient);
    next->weight *= colour_weight(coefficient);
    if (deeper && next->level >= t->model->max_trace_level) {
        t->counts.cut_depth++;
        return false;
    }
    if (!(next->weight >= (float)t->model->adc_bailout)) {
        t->counts.cut_weight++;
        return false;
    }
    next->level += deeper;
    return true;
}

/* Here and below: true when the ray goes on. */
static bool reflect(pov_tracer *t, uint32_t lane, colour coefficient)
{
    path *next = leave(t->mirrored, &t->surfaces[lane], lanes_at(&t->geometry.mirrored, lane));
    bool goes = goes_on(t, next, coefficient, true);

    world_leave(&t->mirrored->room[t->mirrored->count], t->surfaces[lane].at, t->geometry.cosine[lane]);
    t->mirrored->count += goes;
    t->counts.reflected += goes;
    return goes;
}

/* Straight on, whatever lies on both sides. */
static bool pass(pov_tracer *t, const surface *s)
{
    const pov_vec3 from = s->ray->org, to = s->at->point;
    path *out = leave_across(t->passed, s, s->ray->dir);

    if (!goes_on(t, out, s->look->filter, false))
        return false;
    if (from.x == to.x && from.y == to.y && from.z == to.z)
        out->standing = s->from->standing + 1;
    if (out->standing > STANDING_MAX) {
        t->counts.cut_depth++;
        return false;
    }
    return true;
}

/* The mirrored ray of an ordinary surface. */
static void mirror(pov_tracer *t, uint32_t lane)
{
    const surface *s = &t->surfaces[lane];

    if (s->look->mirrors)
        reflect(t, lane, s->material->reflection);
}

static void keep_passed(pov_tracer *t, bool passes)
{
    t->passed->count += passes;
    t->counts.transmitted += passes;
}

/* Both rays that can go on from a surface between two media. The list of media goes on with the transmitted
 * ray; a mirrored one stays in what it was in. */
static void bend(pov_tracer *t, uint32_t lane)
{
    const surface *s = &t->surfaces[lane];
    const geometry *g = &t->geometry;
    const pov_vec3 view = lanes_at(&g->view, lane), normal = lanes_at(&g->normal, lane);
    media_crossing c = media_cross(&t->media, s->from->media, t->model, s->at->object);
    path *out = &t->passed->paths[t->passed->count];
    pov_vec3 direction;
    bool passes;

    if (c.before == c.after) {
        passes = pass(t, s);
    } else if (refract(view, normal, g->cosine[lane], c.before, c.after, &direction)) {
        passes = goes_on(t, leave_across(t->passed, s, direction), s->look->filter, true);
    } else {
        t->counts.inner_reflections += reflect(t, lane, white);
        return;
    }
    mirror(t, lane);
    if (passes && !media_pass(&t->media, t->env, &out->media, &c))
        t->failed = true;
    keep_passed(t, passes);
}

void surface_branch(pov_tracer *t, uint32_t lane)
{
    const surface *s = &t->surfaces[lane];

    if (!s->look->passes) {
        mirror(t, lane);
    } else if (t->plan->refraction) {
        bend(t, lane);
    } else {
        mirror(t, lane);
        keep_passed(t, pass(t, s));
    }
}
