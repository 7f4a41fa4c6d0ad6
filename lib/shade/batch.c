#include "shade/batch.h"

#include "base/vec.h"

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

    if (!b)
        return make(e);
    q->spare = b->next;
    return b;
}

static void give_spare(batch_queue *q, batch *b)
{
    b->next = q->spare;
    q->spare = b;
}

bool batch_make(batch_queue *q, const env *e)
{
    q->now = take_spare(q, e);
    q->reflected = take_spare(q, e);
    q->transmitted = take_spare(q, e);
    return q->now && q->reflected && q->transmitted;
}

static void forget(batch_queue *q)
{
    while (q->waits.count > 0)
        give_spare(q, q->waits.items[--q->waits.count].paths);
}

void batch_forget(batch_queue *q, shade_context *c)
{
    forget(q);
    c->dielectrics.count = c->coincident_sets.count = 0;
}

void batch_free(batch_queue *q, const env *e)
{
    forget(q);
    env_free(e, q->waits.items);
    env_free_aligned(e, q->now);
    env_free_aligned(e, q->reflected);
    env_free_aligned(e, q->transmitted);
    while (q->spare)
        env_free_aligned(e, take_spare(q, e));
}

/* Push the transmitted paths on the stack of waiting batches, and take a spare batch. False: no memory. */
static bool put_aside(batch_queue *q, const shade_context *c)
{
    const wait w = { q->transmitted, c->dielectrics.count, c->coincident_sets.count };
    batch *empty = take_spare(q, c->env);

    if (!empty)
        return false;
    if (!VEC_PUSH(c->env, &q->waits, w)) {
        give_spare(q, empty);
        return false;
    }
    q->transmitted = empty;
    return true;
}

/* Pop the last waiting batch. */
static void take_up(batch_queue *q, shade_context *c)
{
    const wait w = q->waits.items[--q->waits.count];

    give_spare(q, q->now);
    q->now = w.paths;
    c->dielectrics.count = w.dielectrics;
    c->coincident_sets.count = w.coincident_sets;
}

/* ---- what paths carry with them ---- */

/* Compact the lists of a batch. All of them lie behind those of the waiting batches, or all before their end. */
static void compact_dielectrics(batch_queue *q, shade_context *c)
{
    batch *b = q->now;
    size_t floor = q->waits.count > 0 ? q->waits.items[q->waits.count - 1].dielectrics : 0;

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
    const size_t floor = q->waits.count > 0 ? q->waits.items[q->waits.count - 1].coincident_sets : 0;

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

/* Choose the next paths. Reflected paths go first and the transmitted ones wait: reflected ones are always a level
 * deeper, so no more batches wait than there are levels. */
bool batch_next(batch_queue *q, shade_context *c)
{
    if (q->reflected->count > 0 && q->transmitted->count > 0 && !put_aside(q, c)) {
        c->failed = true;
        return false;
    }
    if (q->reflected->count > 0)
        change(&q->now, &q->reflected);
    else if (q->transmitted->count > 0)
        change(&q->now, &q->transmitted);
    else if (q->waits.count > 0)
        take_up(q, c);
    else
        return false;
    if (c->scene->plan->refraction)
        compact_dielectrics(q, c);
    if (c->coincident_sets.count > 0)
        compact_coincident_sets(q, c);
    return true;
}
