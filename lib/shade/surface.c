#include "shade/surface.h"

#include "shade/light.h"
#include "shade/pigment.h"

/* More surfaces on one spot than are told apart can hand a ray back and forth there: straight on does not count for the
 * depth. After this many crossings without a move the ray is cut off as too deep. */
enum { STANDING_MAX = 1000 };

static const colour white = { 1.0f, 1.0f, 1.0f };

bool surface_answers_light(const pov_tracer *t, const surface *s)
{
    return t->plan->lighting && (s->material->diffuse != 0.0f || s->material->phong != 0.0f);
}

/* Does anything but its own glow come from the surface? */
static bool needs_geometry(const pov_tracer *t, const surface *s)
{
    const material *m = s->material;

    return surface_answers_light(t, s) || (t->plan->reflection && !colour_is_black(m->reflection)) ||
           (t->plan->transmission && material_is_transparent(m));
}

static void look(pov_tracer *t, surface *s)
{
    if (s->spot == 0)
        world_surface(t->world, s->ray, &s->at);
    s->view = pov_unit(s->ray->dir);
    s->normal = s->at.entering ? s->at.normal : pov_scale(s->at.normal, -1.0);
    s->cosine = -pov_dot(s->normal, s->view);
    s->cosine = s->cosine > 0.0 ? s->cosine : 0.0;
    s->mirrored = pov_add(s->view, pov_scale(s->normal, 2.0 * s->cosine));
}

bool surface_meet(pov_tracer *t, surface *s)
{
    const model *m = t->model;

    s->material = &m->materials.items[m->objects.items[s->at.object].material];
    s->opacity = pigment_opacity(m, s->material);
    s->glow = colour_scale(colour_mul(s->material->ambient, s->material->pigment), s->opacity);
    s->glow = colour_mul(s->glow, m->ambient_light);
    if (t->plan->lighting && !surface_answers_light(t, s))
        t->counts.shadow_idle += m->lights.count;
    if (!needs_geometry(t, s))
        return false;
    look(t, s);
    return true;
}

/* ---- the rays that go on ---- */

/* Begin a path that goes on from the surface. Its factor and weight are not yet those of the way it takes. */
static path *leave(batch *b, const surface *s, pov_vec3 direction)
{
    const path *p = s->from;
    path *next = &b->paths[b->count];
    pov_ray *ray = &b->room[b->count];

    b->rays[b->count] = ray;
    ray->org = s->at.point;
    ray->org_lo = s->at.point_lo;
    ray->dir = direction;
    ray->dir_lo = pov_vec3_of(0.0, 0.0, 0.0);
    ray->left = s->at.object;
    ray->left_mark = s->at.crossing.mark;
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
static bool reflect(pov_tracer *t, const surface *s, colour coefficient)
{
    bool goes = goes_on(t, leave(t->mirrored, s, s->mirrored), coefficient, true);

    t->mirrored->count += goes;
    t->counts.reflected += goes;
    return goes;
}

/* Straight on, whatever lies on both sides. */
static bool pass(pov_tracer *t, const surface *s)
{
    const pov_vec3 from = s->ray->org, to = s->at.point;
    path *out = leave_across(t->passed, s, s->ray->dir);

    if (!goes_on(t, out, material_filter(s->material), false))
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
static void mirror(pov_tracer *t, const surface *s)
{
    if (t->plan->reflection && !colour_is_black(s->material->reflection))
        reflect(t, s, s->material->reflection);
}

static void keep_passed(pov_tracer *t, bool passes)
{
    t->passed->count += passes;
    t->counts.transmitted += passes;
}

/* Both rays that can go on from a surface between two media. The list of media goes on with the transmitted
 * ray; a mirrored one stays in what it was in. */
static void bend(pov_tracer *t, const surface *s)
{
    media_crossing c = media_cross(&t->media, s->from->media, t->model, s->at.object);
    path *out = &t->passed->paths[t->passed->count];
    pov_vec3 direction;
    bool passes;

    if (c.before == c.after) {
        passes = pass(t, s);
    } else if (refract(s->view, s->normal, s->cosine, c.before, c.after, &direction)) {
        passes = goes_on(t, leave_across(t->passed, s, direction), material_filter(s->material), true);
    } else {
        t->counts.inner_reflections += reflect(t, s, white);
        return;
    }
    mirror(t, s);
    if (passes && !media_pass(&t->media, t->env, &out->media, &c))
        t->failed = true;
    keep_passed(t, passes);
}

void surface_branch(pov_tracer *t, const surface *s)
{
    if (!t->plan->transmission || !material_is_transparent(s->material)) {
        mirror(t, s);
    } else if (t->plan->refraction) {
        bend(t, s);
    } else {
        mirror(t, s);
        keep_passed(t, pass(t, s));
    }
}
