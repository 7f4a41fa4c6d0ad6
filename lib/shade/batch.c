#include "shade/batch.h"

#include "base/vec.h"

/* ---- batches, filled and spare ---- */

static batch *make(const env *e)
{
    batch *b = env_alloc_aligned(e, sizeof *b, SIMD_LINE);

    for (uint32_t i = 0; b && i < BATCH_MAX; i++)
        b->rays[i] = &b->room[i];
    return b;
}

static batch *take_spare(pov_tracer *t)
{
    batch *b = t->spare;

    if (!b)
        return make(t->env);
    t->spare = b->next;
    return b;
}

static void give_spare(pov_tracer *t, batch *b)
{
    b->next = t->spare;
    t->spare = b;
}

bool batch_make(pov_tracer *t)
{
    t->now = take_spare(t);
    t->mirrored = take_spare(t);
    t->passed = take_spare(t);
    return t->now && t->mirrored && t->passed;
}

void batch_forget(pov_tracer *t)
{
    while (t->waits.count > 0)
        give_spare(t, t->waits.items[--t->waits.count].paths);
    t->media.count = t->spots.count = 0;
}

void batch_free(pov_tracer *t)
{
    batch_forget(t);
    env_free(t->env, t->waits.items);
    env_free_aligned(t->env, t->now);
    env_free_aligned(t->env, t->mirrored);
    env_free_aligned(t->env, t->passed);
    while (t->spare)
        env_free_aligned(t->env, take_spare(t));
}

/* The transmitted paths wait, and others take their place. False: no memory. */
static bool put_aside(pov_tracer *t)
{
    const wait w = { t->passed, t->media.count, t->spots.count };
    batch *empty = take_spare(t);

    if (!empty)
        return false;
    if (!VEC_PUSH(t->env, &t->waits, w)) {
        give_spare(t, empty);
        return false;
    }
    t->passed = empty;
    return true;
}

/* Those that came last go on. */
static void take_up(pov_tracer *t)
{
    const wait w = t->waits.items[--t->waits.count];

    give_spare(t, t->now);
    t->now = w.paths;
    t->media.count = w.media;
    t->spots.count = w.spots;
}

/* ---- what paths carry with them ---- */

/* Of a batch whose lists all lie behind those of the batches that wait, or all before their end. */
static void settle_media(pov_tracer *t)
{
    batch *b = t->now;
    size_t floor = t->waits.count > 0 ? t->waits.items[t->waits.count - 1].media : 0;

    t->media.count = floor;
    for (uint32_t i = 0; i < b->count; i++) {
        media_span *in = &b->paths[i].media;
        if (in->count > 0 && in->first >= floor)
            media_settle(&t->media, in, t->media.count);
    }
}

/* The same of the spots. */
static void settle_spots(pov_tracer *t)
{
    const size_t floor = t->waits.count > 0 ? t->waits.items[t->waits.count - 1].spots : 0;

    t->spots.count = floor;
    for (uint32_t i = 0; i < t->now->count; i++) {
        path *p = &t->now->paths[i];

        if (p->spot <= floor)
            continue;
        if (p->spot - 1 != t->spots.count)
            t->spots.items[t->spots.count] = t->spots.items[p->spot - 1];
        p->spot = (uint32_t)++t->spots.count;
    }
}

/* ---- from batch to batch ---- */

static void change(batch **a, batch **b)
{
    batch *c = *a;

    *a = *b;
    *b = c;
}

/* The paths to be followed next. The mirrored go first and their transmitted sisters wait: mirrored ones are always a
 * level deeper, so no more batches wait than there are levels. */
bool batch_next(pov_tracer *t)
{
    if (t->mirrored->count > 0 && t->passed->count > 0 && !put_aside(t)) {
        t->failed = true;
        return false;
    }
    if (t->mirrored->count > 0)
        change(&t->now, &t->mirrored);
    else if (t->passed->count > 0)
        change(&t->now, &t->passed);
    else if (t->waits.count > 0)
        take_up(t);
    else
        return false;
    if (t->plan->refraction)
        settle_media(t);
    if (t->spots.count > 0)
        settle_spots(t);
    return true;
}
