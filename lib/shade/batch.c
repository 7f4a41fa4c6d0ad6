#include "shade/batch.h"

#include "base/elementary.h"
#include "base/vec.h"
#include "shade/gather.h"
#include "shade/reuse.h"

/* ---- batches, filled and spare ---- */

static batch *make(const env *e)
{
    batch *b = env_alloc_aligned(e, sizeof *b, SIMD_LINE);

    if (!b)
        return NULL;
    b->camera = false;
    for (uint32_t i = 0; i < BATCH_MAX; i++)
        b->rays[i] = &b->own[i];
    return b;
}

static batch *take_spare(batch_queue *q, const env *e)
{
    batch *b = q->spare;

    if (b)
        q->spare = b->next;
    else
        b = make(e);
    if (b) {
        b->count = 0;
        b->last = UINT32_MAX;
        b->power = NULL;
        b->gather = NULL;
    }
    return b;
}

static void give_spare(batch_queue *q, batch *b)
{
    if (b->gather) {
        b->gather->next = q->spare_gather;
        q->spare_gather = b->gather;
        b->gather = NULL;
    }
    b->next = q->spare;
    q->spare = b;
}

static void give_power(batch_queue *q, power_sum *p)
{
    if (!p)
        return;
    if (p->reuse) {
        p->reuse->next = q->spare_reuse;
        q->spare_reuse = p->reuse;
    }
    p->next = q->spare_power;
    q->spare_power = p;
}

bool batch_add_power(batch_queue *q, const env *e, batch *b)
{
    power_sum *p = q->spare_power;

    if (p)
        q->spare_power = p->next;
    else
        p = env_alloc(e, 1, sizeof *p);
    if (p) {
        p->count = 0;
        p->reuse = NULL;
    }
    b->power = p;
    return p != NULL;
}

bool batch_add_reuse(batch_queue *q, const env *e, power_sum *p)
{
    p->reuse = q->spare_reuse;
    if (p->reuse)
        q->spare_reuse = p->reuse->next;
    else
        p->reuse = env_alloc_aligned(e, sizeof *p->reuse, SIMD_LINE);
    return p->reuse != NULL;
}

static bool add_gather(batch_queue *q, const env *e, batch *b)
{
    gather_origins *g = q->spare_gather;

    if (g)
        q->spare_gather = g->next;
    else
        g = env_alloc_aligned(e, sizeof *g, SIMD_LINE);
    b->gather = g;
    return g != NULL;
}

/* What paths of this list need besides. */
static bool equip(batch_queue *q, const env *e, const branches *list, batch *b)
{
    if (list == &q->powered) {
        if (!batch_add_power(q, e, b))
            return false;
        b->power->gathers = false;
    }
    return list != &q->gathered || add_gather(q, e, b);
}

/* ---- branches ---- */

static batch *add_branch(batch_queue *q, const env *e, branches *list)
{
    batch *b = take_spare(q, e);

    if (!b)
        return NULL;
    b->out = q->out;
    if (VEC_PUSH(e, list, b))
        return b;
    give_spare(q, b);
    return NULL;
}

batch *batch_grow(batch_queue *q, const env *e, branches *list, uint32_t lane)
{
    batch *b;

    for (size_t i = 0; i < list->count; i++) {
        b = list->items[i];
        if (b->count == 0 || b->paths[b->count - 1].lane < lane)
            return b;
    }
    b = add_branch(q, e, list);
    if (!b || equip(q, e, list, b))
        return b;
    list->count--;
    give_spare(q, b);
    return NULL;
}

/* Keep the first `count` of the list. */
static void drop(batch_queue *q, branches *list, size_t count)
{
    while (list->count > count) {
        batch *b = list->items[--list->count];

        give_power(q, b->power);
        give_spare(q, b);
    }
}

void batch_begin(batch_queue *q, colour *out)
{
    batch *const mirrored = q->mirrored.items[0], *const transmitted = q->transmitted.items[0];

    drop(q, &q->mirrored, 1);
    drop(q, &q->powered, 0);
    drop(q, &q->gathered, 0);
    drop(q, &q->transmitted, 1);
    mirrored->count = transmitted->count = 0;
    mirrored->last = transmitted->last = UINT32_MAX;
    q->out = mirrored->out = transmitted->out = out;
}

bool batch_make(batch_queue *q, const env *e)
{
    q->now = take_spare(q, e);
    return q->now && add_branch(q, e, &q->mirrored) && add_branch(q, e, &q->transmitted);
}

/* ---- waiting batches ---- */

static void forget(batch_queue *q)
{
    while (q->waits.count > 0) {
        const wait w = q->waits.items[--q->waits.count];

        give_power(q, w.sum);
        if (!w.paths)
            continue;
        give_power(q, w.paths->power);
        give_spare(q, w.paths);
    }
}

void batch_forget(batch_queue *q, shade_context *c)
{
    forget(q);
    c->dielectrics.count = c->coincident_sets.count = 0;
}

static void free_branches(batch_queue *q, const env *e, branches *list)
{
    drop(q, list, 0);
    env_free(e, list->items);
}

void batch_free(batch_queue *q, const env *e)
{
    forget(q);
    env_free(e, q->waits.items);
    free_branches(q, e, &q->mirrored);
    free_branches(q, e, &q->powered);
    free_branches(q, e, &q->gathered);
    free_branches(q, e, &q->transmitted);
    if (q->now) {
        give_power(q, q->now->power);
        give_spare(q, q->now);
    }
    while (q->spare) {
        batch *b = q->spare;

        q->spare = b->next;
        env_free_aligned(e, b);
    }
    while (q->spare_gather) {
        gather_origins *g = q->spare_gather;

        q->spare_gather = g->next;
        env_free_aligned(e, g);
    }
    while (q->spare_reuse) {
        reuse *r = q->spare_reuse;

        q->spare_reuse = r->next;
        env_free_aligned(e, r);
    }
    while (q->spare_power) {
        power_sum *p = q->spare_power;

        q->spare_power = p->next;
        env_free(e, p);
    }
}

/* Push the paths of a branch on the stack of waiting batches. A list's first branch is replaced by an empty one, others
 * leave their list. False: no memory. */
static bool put_aside(batch_queue *q, const shade_context *c, branches *list, size_t i, size_t keeps)
{
    const wait w = { list->items[i], NULL, c->dielectrics.count, c->coincident_sets.count, 0 };
    batch *empty = i < keeps ? take_spare(q, c->env) : NULL;

    if (i < keeps && !empty)
        return false;
    if (!VEC_PUSH(c->env, &q->waits, w)) {
        if (empty)
            give_spare(q, empty);
        return false;
    }
    if (empty)
        list->items[i] = empty;
    else
        list->count--;
    return true;
}

/* The last one first, so that it is the last to be taken up. */
static bool put_all_aside(batch_queue *q, const shade_context *c, branches *list, size_t first, size_t keeps)
{
    for (size_t i = list->count; i-- > first;)
        if (list->items[i]->count > 0 && !put_aside(q, c, list, i, keeps))
            return false;
    return true;
}

/* Sizes of the stacks below the last waiting batch. */
static wait floor_of(const batch_queue *q)
{
    static const wait none;

    return q->waits.count > 0 ? q->waits.items[q->waits.count - 1] : none;
}

/* The paths of the present batch see a colour of their own, which is complete when all that follows is. */
static bool begin_sum(batch_queue *q, const shade_context *c)
{
    power_sum *p = q->now->power;
    wait w = floor_of(q);

    w.paths = NULL;
    w.sum = p;
    if (!VEC_PUSH(c->env, &q->waits, w))
        return false;
    for (uint32_t i = 0; i < p->count; i++)
        p->seen[p->lane[i]] = colour_of(0.0f, 0.0f, 0.0f);
    p->out = q->now->out;
    q->now->out = p->seen;
    q->now->power = NULL;
    return true;
}

static float raise(float x, float exponent)
{
    return x > 0.0f ? (float)elementary_pow((double)x, 1.0 / (double)exponent) : 0.0f;
}

static colour raise_all(colour c, float e) { return colour_of(raise(c.r, e), raise(c.g, e), raise(c.b, e)); }

static void end_sum(batch_queue *q, shade_context *c, power_sum *p)
{
    if (p->reuse)
        reuse_spread(c, p);
    for (uint32_t i = 0; !p->reuse && i < p->count; i++) {
        const colour seen = p->seen[p->lane[i]];
        const colour counts = p->gathers ? gather_sample(&c->scene->model->radiosity, seen) : raise_all(seen, p->exponent[i]);
        colour *out = &p->out[p->lane[i]];

        *out = colour_add(*out, colour_mul(p->factor[i], counts));
    }
    give_power(q, p);
}

/* The next draw of the last waiting batch's rays; the batch goes with the last one. */
static bool draw(batch_queue *q, shade_context *c)
{
    wait *w = &q->waits.items[q->waits.count - 1];

    c->failed = c->failed || !gather_draw(c, q, w->paths, w->draw);
    if (q->now->count == 0) {
        give_power(q, q->now->power);
        q->now->power = NULL;
    }
    c->dielectrics.count = w->dielectrics;
    c->coincident_sets.count = w->coincident_sets;
    if (gather_has_draw(w->paths, ++w->draw))
        return !c->failed;
    q->waits.count--;
    give_spare(q, w->paths);
    return !c->failed;
}

/* Pop the last waiting batch; sums before it are complete. False: there is none. */
static bool take_up(batch_queue *q, shade_context *c)
{
    while (q->waits.count > 0) {
        const wait w = q->waits.items[q->waits.count - 1];

        if (w.paths && w.paths->gather) {
            if (!draw(q, c))
                return false;
            if (q->now->count > 0)
                return true;
            continue;
        }
        q->waits.count--;
        if (w.sum) {
            end_sum(q, c, w.sum);
            continue;
        }
        give_spare(q, q->now);
        q->now = w.paths;
        c->dielectrics.count = w.dielectrics;
        c->coincident_sets.count = w.coincident_sets;
        return true;
    }
    return false;
}

/* ---- what paths carry with them ---- */

/* Compact the lists of a batch. All of them lie behind those of the waiting batches, or all before their end. */
static void compact_dielectrics(batch_queue *q, shade_context *c)
{
    batch *b = q->now;
    const size_t floor = floor_of(q).dielectrics;

    c->dielectrics.count = floor;
    for (uint32_t i = 0; i < b->count; i++) {
        dielectric_span *in = &b->paths[i].inside;
        if (in->count > 0 && in->first >= floor)
            dielectric_compact(&c->dielectrics, in, c->dielectrics.count);
    }
}

/* The same of the coincident sets. */
static void compact_coincident_sets(batch_queue *q, shade_context *c)
{
    const size_t floor = floor_of(q).coincident_sets;

    c->coincident_sets.count = floor;
    for (uint32_t i = 0; i < q->now->count; i++) {
        path *p = &q->now->paths[i];

        if (p->coincident <= floor)
            continue;
        if (p->coincident - 1 != c->coincident_sets.count)
            c->coincident_sets.items[c->coincident_sets.count] = c->coincident_sets.items[p->coincident - 1];
        p->coincident = (uint32_t)++c->coincident_sets.count;
    }
}

/* ---- from batch to batch ---- */

static void change(batch **a, batch **b)
{
    batch *c = *a;

    *a = *b;
    *b = c;
}

/* Choose the next paths: the first branch goes on, and the others wait. Reflected ones are always a level deeper, so no
 * more batches wait than there are levels, times the branches of one. False: there are none, or no memory. */
static bool choose(batch_queue *q, shade_context *c)
{
    batch **const mirrored = &q->mirrored.items[0], **const transmitted = &q->transmitted.items[0];
    const bool single = q->mirrored.count == 1 && q->transmitted.count == 1 && q->powered.count == 0 && q->gathered.count == 0;
    bool put;

    if (single && ((*mirrored)->count == 0 || (*transmitted)->count == 0)) {
        if ((*mirrored)->count == 0 && (*transmitted)->count == 0)
            return take_up(q, c);
        change(&q->now, (*mirrored)->count > 0 ? mirrored : transmitted);
        return true;
    }
    put = put_all_aside(q, c, &q->gathered, 0, 0) && put_all_aside(q, c, &q->transmitted, 0, 1) && put_all_aside(q, c, &q->powered, 0, 0) &&
          put_all_aside(q, c, &q->mirrored, (*mirrored)->count > 0, 1);
    c->failed = c->failed || !put;
    if (!put || (*mirrored)->count == 0)
        return put && take_up(q, c);
    change(&q->now, mirrored);
    return true;
}

bool batch_next(batch_queue *q, shade_context *c)
{
    if (!choose(q, c))
        return false;
    q->now->reuse = q->now->power ? q->now->power->reuse : NULL;
    if (q->now->power && !begin_sum(q, c)) {
        c->failed = true;
        return false;
    }
    if (c->scene->plan->refraction)
        compact_dielectrics(q, c);
    if (c->coincident_sets.count > 0)
        compact_coincident_sets(q, c);
    return true;
}
