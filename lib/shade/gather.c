#include "shade/gather.h"

#include "shade/air.h"
#include "shade/guide.h"
#include "shade/spawn.h"

/* ---- origins ---- */

/* From one batch of surfaces; layers NULL: they have none. */
typedef struct gathering {
    shade_context *context;
    const surfaces *on;
    const layers *layers;
    batch_queue *queue;
    const radiosity_settings *settings;
    uint64_t begun, cut;
} gathering;

/* What is seen of light that the surface has on one side. */
static colour share_of(const gathering *to, uint32_t i, float diffuse)
{
    const appearance *a = to->on->at[i].appearance;
    const colour c = colour_scale(a->pigment, a->opacity * diffuse * a->finish->written * to->settings->brightness);

    return to->layers ? colour_mul(to->layers->of[i].by, c) : c;
}

/* Rays of little weight count less, so there are fewer of them. Deeper surfaces send one by the cosine and one towards a lamp,
 * where there are some. */
static uint8_t draws_of(const gathering *to, const path *from, float weight)
{
    const float least = 0.2f;
    uint32_t draws = to->settings->draws;

    if (from->gathers > 0)
        return world_get_lamps(to->context->scene->world)->count > 0 && weight >= least ? 2 : 1;
    for (; draws > 1 && weight <= 0.5f; weight *= 2.0f)
        draws /= 2;
    return (uint8_t)draws;
}

/* The normals on the side that the rays leave to. */
static void set_sides(const gathering *to, gather_origins *g, uint32_t n, uint32_t i, bool behind)
{
    const geometry *from = &to->on->geometry;
    const double side = behind ? -1.0 : 1.0;
    const vec_lanes *normal = to->settings->uses_normals ? from->shading : from->raw;

    lanes_put(&g->normal, n, pov_scale(lanes_at(normal, i), side));
    lanes_put(&g->face, n, pov_scale(lanes_at(&from->to.normal, i), side));
    g->outside[n] = to->on->at[i].at->outside;
    g->behind[n] = behind;
}

/* Rays on the other side are in other solids. */
static void go_behind(const gathering *to, const surface *s, path *next)
{
    shade_context *c = to->context;
    dielectric_crossing crossing;

    if (c->scene->dims)
        next->solids = air_solids_across(c->scene, s);
    if (!c->scene->plan->refraction || !s->appearance->transmissive)
        return;
    dielectric_cross(&c->dielectrics, next->inside, c->scene->model, world_solid(c->scene->world, s->at->object), next->hue, &crossing);
    c->failed = c->failed || !dielectric_pass(&c->dielectrics, c->env, &next->inside, &crossing);
}

/* The rays that gather the light that counts by this factor on one side of surface i. */
static void add(gathering *to, uint32_t i, bool behind, colour by)
{
    const surface *s = &to->on->at[i];
    coefficient factor = coefficient_mul(s->from->factor, coefficient_of(by));
    batch *b;
    path *next;

    if (colour_is_black(by))
        return;
    if (!(factor.weight >= (float)to->settings->adc_bailout)) {
        to->cut++;
        return;
    }
    b = batch_grow(to->queue, to->context->env, &to->queue->gathered, s->from->lane);
    to->context->failed = to->context->failed || !b;
    if (!b)
        return;
    b->gather->draws[b->count] = draws_of(to, s->from, factor.weight);
    factor.by = colour_scale(factor.by, 1.0f / (float)b->gather->draws[b->count]);
    set_sides(to, b->gather, b->count, i, behind);
    next = spawn(b, s, pov_vec3_of(0.0, 0.0, 0.0), factor, true);
    next->clear = 0.0f;
    next->mirrored = false;
    next->gathering = true;
    next->gathers++;
    spawn_turn(next, behind ? TURN_GATHERING_BEHIND : TURN_GATHERING);
    if (behind) {
        next->above ^= 1u << s->on;
        go_behind(to, s, next);
    }
    world_origin_reflect(&b->own[b->count], s->at, 0.0);
    to->begun += b->gather->draws[b->count++];
}

static bool is_one_ray(const gathering *to, uint32_t a, uint32_t b)
{
    const geometry *g = &to->on->geometry;
    const pov_vec3 m = lanes_at(g->shading, a), n = lanes_at(g->shading, b);

    return to->layers && to->layers->of[a].of == to->layers->of[b].of &&
           (!to->settings->uses_normals || (m.x == n.x && m.y == n.y && m.z == n.z));
}

/* The layers of a hit that have one normal have their light from the same rays: those of the last one of them. */
static void begin(gathering *to)
{
    colour front = { 0.0f, 0.0f, 0.0f }, back = front;

    for (uint32_t i = 0; i < to->on->count; i++) {
        const surface *s = &to->on->at[i];
        const finish *f = s->appearance->finish;

        if (s->appearance->gathers) {
            front = colour_add(front, share_of(to, i, f->diffuse));
            back = colour_add(back, share_of(to, i, f->diffuse_back));
        }
        if (i + 1 < to->on->count && is_one_ray(to, i, i + 1))
            continue;
        if (s->from->gathers < to->settings->recursion_limit) {
            add(to, i, false, front);
            add(to, i, true, back);
        }
        front = back = colour_of(0.0f, 0.0f, 0.0f);
    }
    to->context->counts.reflected += to->begun;
    to->context->counts.cut_weight += to->cut;
}

void gather_begin(shade_context *c, const surfaces *on, batch_queue *q)
{
    gathering to = { c, on, NULL, q, &c->scene->model->radiosity, 0, 0 };

    begin(&to);
}

void gather_begin_layers(shade_context *c, const layers *l, batch_queue *q)
{
    gathering to = { c, &l->on, l, q, &c->scene->model->radiosity, 0, 0 };

    begin(&to);
}

/* ---- draws ---- */

bool gather_has_draw(const batch *b, uint32_t draw)
{
    for (uint32_t i = 0; i < b->count; i++)
        if (draw < b->gather->draws[i])
            return true;
    return false;
}

/* The ray's side is known now. */
static void name_side(pov_ray *ray, const gather_origins *g, uint32_t i)
{
    const double along = pov_dot(ray->dir, lanes_at(&g->face, i));

    world_origin_leave(ray, g->outside[i] != g->behind[i], along, 1.0);
}

/* False: the ray is not needed. */
static bool aim(const shade_context *c, const batch *from, uint32_t i, uint32_t draw, path *p, pov_ray *ray)
{
    const uint32_t draws = from->gather->draws[i], all = c->scene->model->radiosity.draws;
    const bool first = p->gathers == 1;
    const sequence_point at = random_point(&c->samples[p->lane], first ? draw : p->draw, first ? draws : all, p->branch);
    const guide_kind kind = first || draws == 1 ? GUIDE_EITHER : draw == 0 ? GUIDE_EVEN : GUIDE_LAMPS;
    float by;

    if (!guide_draw(world_get_lamps(c->scene->world), ray->org, lanes_at(&from->gather->normal, i), at, kind, &ray->dir, &by))
        return false;
    if (kind == GUIDE_LAMPS)
        spawn_turn(p, TURN_TO_LAMP);
    p->factor.by = colour_scale(p->factor.by, by);
    if (first)
        p->draw = (uint8_t)draw;
    name_side(ray, from->gather, i);
    return true;
}

static void draw_ray(const shade_context *c, const batch *from, uint32_t i, uint32_t draw, batch *to)
{
    const uint32_t n = to->count;

    to->paths[n] = from->paths[i];
    to->own[n] = from->own[i];
    to->count += aim(c, from, i, draw, &to->paths[n], &to->own[n]);
}

/* Samples that are not added as they are have sums of their own. */
static bool sum_up(shade_context *c, batch_queue *q, batch *b)
{
    const radiosity_settings *r = &c->scene->model->radiosity;

    if (!(r->gray_threshold > 0.0f || r->max_sample > 0.0f))
        return true;
    if (!batch_add_power(q, c->env, b))
        return false;
    b->power->gathers = true;
    for (; b->power->count < b->count; b->power->count++) {
        path *p = &b->paths[b->power->count];

        b->power->lane[b->power->count] = p->lane;
        b->power->factor[b->power->count] = p->factor.by;
        p->factor.by = colour_of(1.0f, 1.0f, 1.0f);
    }
    return true;
}

bool gather_draw(shade_context *c, batch_queue *q, const batch *from, uint32_t draw)
{
    batch *to = q->now;

    to->count = 0;
    to->power = NULL;
    to->out = from->out;
    for (uint32_t i = 0; i < from->count; i++)
        if (draw < from->gather->draws[i])
            draw_ray(c, from, i, draw, to);
    return sum_up(c, q, to);
}

colour gather_sample(const radiosity_settings *r, colour seen)
{
    const float g = r->gray_threshold, grey = g * colour_grey(seen), most = colour_weight(seen);
    const colour c = colour_add(colour_scale(seen, 1.0f - g), colour_of(grey, grey, grey));

    return r->max_sample > 0.0f && most > r->max_sample ? colour_scale(c, r->max_sample / most) : c;
}
