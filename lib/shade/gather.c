#include "shade/gather.h"

#include "shade/air.h"
#include "shade/guide.h"
#include "shade/reuse.h"
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
    dielectric_cross(&c->dielectrics, next->inside, c->scene->model, shading_solid(c->scene, s->at->object), next->hue, &crossing);
    c->failed = c->failed || !dielectric_pass(&c->dielectrics, c->env, &next->inside, &crossing);
}

/* What the first surface of a camera ray gathers may be known. True: then it is added. */
static bool is_lent(const gathering *to, const path *from, bool behind, colour factor)
{
    const lent_light *lent = to->context->lent;
    colour *out = &to->queue->out[from->lane];

    if (!lent || behind || from->branch != 0 || !lent[from->lane].known)
        return false;
    *out = colour_add(*out, colour_mul(factor, lent[from->lane].light));
    return true;
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
    if (is_lent(to, s->from, behind, factor.by))
        return;
    b = batch_grow(to->queue, to->context->env, &to->queue->gathered, s->from->lane);
    to->context->failed = to->context->failed || !b;
    if (!b)
        return;
    b->gather->draws[b->count] = draws_of(to, s->from, factor.weight);
    set_sides(to, b->gather, b->count, i, behind);
    next = spawn(b, s, pov_vec3_of(0.0, 0.0, 0.0), factor, true);
    next->clear = 0.0f;
    next->mirrored = false;
    next->gathering = true;
    next->travelled = 0.0;
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

/* The rays of one draw. */
typedef struct drawing {
    shade_context *context;
    const batch *from;
    uint32_t draw;
    batch *to;
    power_sum *sum;              /* NULL: all is added as it is found */
} drawing;

static uint64_t set_of(const shade_context *c, const batch *b, uint32_t i)
{
    return b->paths[i].coincident ? 0 : c->samples[b->paths[i].lane].set;
}

/* Note where a ray starts whose samples its neighbours may use, and how it was drawn. */
static void note_start(const drawing *d, uint32_t i, const path *p, const guide_views *all, bool goes, pov_vec3 dir, float by)
{
    const uint32_t n = d->sum->count;
    const gather_origins *g = d->from->gather;
    reuse *r = d->sum->reuse;

    reuse_put(r, n, d->from, i, all, world_get_lamps(d->context->scene->world)->count);
    r->sets[n] = set_of(d->context, d->from, i);
    r->by[n] = by;
    r->below[p->lane] = !(pov_dot(dir, lanes_at(&g->face, i)) > 0.0);
    r->found[p->lane] = goes && !r->below[p->lane] ? REUSE_SKY : REUSE_NOTHING;   /* until a surface is found */
    lanes_put(&r->end, p->lane, dir);
}

/* What a ray finds counts by this factor; if it is summed up, when that is complete. */
static void note_factor(const drawing *d, path *p, float by)
{
    uint32_t n;

    if (!d->sum) {
        p->factor.by = colour_scale(p->factor.by, by);
        return;
    }
    n = d->sum->count++;
    d->sum->lane[n] = p->lane;
    d->sum->factor[n] = d->sum->reuse ? p->factor.by : colour_scale(p->factor.by, by);
    p->factor.by = colour_of(1.0f, 1.0f, 1.0f);
}

/* False: the ray is not needed; what others find may count for its start. */
static bool aim(const drawing *d, uint32_t i, uint32_t n)
{
    const shade_context *c = d->context;
    const gather_origins *g = d->from->gather;
    const uint32_t draws = g->draws[i];
    path *p = &d->to->paths[n];
    pov_ray *ray = &d->to->own[n];
    const bool first = p->gathers == 1;
    const guide_kind kind = first || draws == 1 ? GUIDE_EITHER : d->draw == 0 ? GUIDE_EVEN : GUIDE_LAMPS;
    const pov_vec3 normal = lanes_at(&g->normal, i);
    sequence_point at;
    guide_views all;
    bool goes;
    float by;

    if (first) {
        p->draw = (uint8_t)d->draw;
        p->draws = (uint8_t)draws;
    }
    at = random_point_of_set(&c->samples[p->lane], p->draw, p->draws, p->branch);
    guide_find(world_get_lamps(c->scene->world), ray->org, normal, &all);
    goes = guide_draw(&all, ray->org, normal, at, kind, &ray->dir, &by);
    if (!goes && !(d->sum && d->sum->reuse))
        return false;
    if (kind == GUIDE_LAMPS)
        spawn_turn(p, TURN_TO_LAMP);
    p->factor.by = colour_scale(p->factor.by, 1.0f / (float)draws);
    if (d->sum && d->sum->reuse)
        note_start(d, i, p, &all, goes, ray->dir, by);
    note_factor(d, p, by);
    name_side(ray, g, i);
    return goes;
}

static void draw_ray(const drawing *d, uint32_t i)
{
    const uint32_t n = d->to->count;

    d->to->paths[n] = d->from->paths[i];
    d->to->own[n] = d->from->own[i];
    d->to->count += aim(d, i, n);
}

/* ---- sets ---- */

/* Each ray of a set is drawn as often as makes twice the samples of one that is alone for all of them. Where rays may find what
 * counts for none but themselves, those of a pixel's first sample, which may be its only one, are half as many as of one that
 * is alone. The paths end by the weight of the one that counts most. */
static void draw_alike(const shade_context *c, batch *b, uint32_t from, uint32_t to)
{
    const uint32_t most = c->scene->model->radiosity.draws;
    const bool many = !c->scene->even && c->samples[b->paths[from].lane].number == 0;
    uint32_t draws = many && most > 1 ? most / 2 : 1;
    float weight = 0.0f;

    while (draws < most && draws * (to - from) < 2 * most)
        draws *= 2;
    for (uint32_t i = from; i < to; i++)
        weight = pov_maxf(weight, b->paths[i].factor.weight);
    for (uint32_t i = from; i < to; i++) {
        b->gather->draws[i] = (uint8_t)draws;
        b->paths[i].factor.weight = weight;
    }
}

/* Are there sets in the batch? */
static bool find_sets(const shade_context *c, batch *b)
{
    bool some = false;

    if (b->count < 2 || b->paths[0].gathers != 1 || !reuse_is_possible(c))
        return false;
    for (uint32_t from = 0, to; from < b->count; from = to) {
        const uint64_t set = set_of(c, b, from);

        for (to = from + 1; to < b->count && set && set_of(c, b, to) == set; to++)
            ;
        some = some || to - from > 1;
        if (to - from > 1)
            draw_alike(c, b, from, to);
    }
    return some;
}

/* Samples that are not added as they are have sums of their own. */
static bool sum_up(drawing *d, batch_queue *q)
{
    const shade_context *c = d->context;
    const radiosity_settings *r = &c->scene->model->radiosity;
    const bool reuses = d->from->gather->reuses;

    if (!(reuses || r->gray_threshold > 0.0f || r->max_sample > 0.0f))
        return true;
    if (!batch_add_power(q, c->env, d->to) || (reuses && !batch_add_reuse(q, c->env, d->to->power)))
        return false;
    d->sum = d->to->power;
    d->sum->gathers = true;
    if (reuses)
        d->sum->reuse->lamps_seen = 0;
    return true;
}

bool gather_draw(shade_context *c, batch_queue *q, batch *from, uint32_t draw)
{
    drawing d = { c, from, draw, q->now, NULL };

    if (draw == 0)
        from->gather->reuses = find_sets(c, from);
    d.to->count = 0;
    d.to->power = NULL;
    d.to->out = from->out;
    if (!sum_up(&d, q))
        return false;
    for (uint32_t i = 0; i < from->count; i++)
        if (draw < from->gather->draws[i])
            draw_ray(&d, i);
    return true;
}

bool gather_is_even(const shading *s) { return s->even && !s->plan->smooth && !s->model->radiosity.uses_normals; }

colour gather_sample(const radiosity_settings *r, colour seen)
{
    const float g = r->gray_threshold, grey = g * colour_grey(seen), most = colour_weight(seen);
    const colour c = colour_add(colour_scale(seen, 1.0f - g), colour_of(grey, grey, grey));

    return r->max_sample > 0.0f && most > r->max_sample ? colour_scale(c, r->max_sample / most) : c;
}
