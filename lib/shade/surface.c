#include "shade/surface.h"

#include "shade/light.h"
#include "shade/pigment.h"

/* Coincident surfaces can hand a ray back and forth on the spot: straight on does not count for the depth,
 * and by name only one of them is left out. After this many crossings without a move the ray is cut off as
 * too deep. */
enum { STANDING_MAX = 1000 };

static const colour white = { 1.0f, 1.0f, 1.0f };

static bool answers_light(const material *m)
{
    return m->diffuse != 0.0f || m->phong != 0.0f;
}

/* Does anything but ambient light come from a surface of this material? */
static bool needs_geometry(const pov_tracer *t, const material *m)
{
    if (t->plan->lighting && answers_light(m))
        return true;
    return (t->plan->reflection && !colour_is_black(m->reflection)) ||
           (t->plan->transmission && material_is_transparent(m));
}

static void look(pov_tracer *t, const path *p, hit *h, surface *s)
{
    world_surface(t->world, &p->ray, h);
    s->view = pov_unit(p->ray.dir);
    s->normal = h->entering ? h->normal : pov_scale(h->normal, -1.0);
    s->cosine = fmax(0.0, -pov_dot(s->normal, s->view));
    s->mirrored = pov_add(s->view, pov_scale(s->normal, 2.0 * s->cosine));
}

/* A ray that goes on from the hit. Its factor and weight are not yet those of the way it takes. */
static path leave(const path *p, const hit *h, pov_vec3 direction)
{
    path next = *p;

    next.ray.org = h->point;
    next.ray.org_lo = h->point_lo;
    next.ray.dir = direction;
    next.ray.dir_lo = pov_vec3_of(0.0, 0.0, 0.0);
    next.ray.left = h->object;
    next.ray.left_mark = h->crossing.mark;
    next.standing = 0;
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

static void reflect(pov_tracer *t, const path *p, const surface *s, colour coefficient, branches *next)
{
    next->reflected = leave(p, s->at, s->mirrored);
    next->reflects = goes_on(t, &next->reflected, coefficient, true);
    t->counts.reflected += next->reflects;
}

/* Straight on, whatever lies on both sides. */
static void pass(pov_tracer *t, const path *p, const surface *s, branches *next)
{
    path *out = &next->transmitted;

    *out = leave(p, s->at, p->ray.dir);
    next->transmits = goes_on(t, out, pigment_filter(s->material), false);
    if (out->ray.org.x == p->ray.org.x && out->ray.org.y == p->ray.org.y && out->ray.org.z == p->ray.org.z)
        out->standing = p->standing + 1;
    if (next->transmits && out->standing > STANDING_MAX) {
        next->transmits = false;
        t->counts.cut_depth++;
    }
}

/* Both rays that can go on from a surface between two media. The list of media goes on with the transmitted
 * ray; a mirrored one stays in what it was in. */
static void bend(pov_tracer *t, const path *p, const surface *s, branches *next)
{
    media_crossing c = media_cross(&t->media, p->media, t->model, s->at->object);
    bool mirrors = t->plan->reflection && !colour_is_black(s->material->reflection);
    pov_vec3 direction;

    if (c.before == c.after) {
        pass(t, p, s, next);
    } else if (refract(s->view, s->normal, s->cosine, c.before, c.after, &direction)) {
        next->transmitted = leave(p, s->at, direction);
        next->transmits = goes_on(t, &next->transmitted, pigment_filter(s->material), true);
    } else {
        reflect(t, p, s, white, next);
        t->counts.inner_reflections += next->reflects;
        return;
    }
    if (mirrors)
        reflect(t, p, s, s->material->reflection, next);
    if (next->transmits && !media_pass(&t->media, t->env, &next->transmitted.media, &c, next->reflects))
        t->failed = true;
}

static void branch(pov_tracer *t, const path *p, const surface *s, branches *next)
{
    const material *m = s->material;
    bool transparent = t->plan->transmission && material_is_transparent(m);

    if (transparent && t->plan->refraction) {
        bend(t, p, s, next);
    } else {
        if (t->plan->reflection && !colour_is_black(m->reflection))
            reflect(t, p, s, m->reflection, next);
        if (transparent)
            pass(t, p, s, next);
    }
    t->counts.transmitted += next->transmits;
}

colour surface_meet(pov_tracer *t, const path *p, hit *h, branches *next)
{
    const model *m = t->model;
    surface s = { .at = h, .material = &m->materials.items[m->objects.items[h->object].material] };
    colour sum;

    next->reflects = next->transmits = false;
    s.opacity = pigment_opacity(m, s.material);
    sum = colour_scale(colour_mul(s.material->ambient, s.material->pigment), s.opacity);
    sum = colour_mul(sum, m->ambient_light);
    if (t->plan->lighting && !answers_light(s.material))
        t->counts.shadow_idle += m->lights.count;
    if (!needs_geometry(t, s.material))
        return sum;
    look(t, p, h, &s);
    if (t->plan->lighting && answers_light(s.material))
        sum = colour_add(sum, light_gather(t, &s));
    branch(t, p, &s, next);
    return sum;
}
