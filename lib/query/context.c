#include "query/context.h"

#include "base/err.h"
#include "base/simd.h"

#include <string.h>

pov_status query_context_create(query_context **out, const world *w, pov_error *err)
{
    query_context *k = env_alloc_aligned(w->env, sizeof *k, SIMD_LINE);
    csg_size most = { 0, 0 };
    int i;

    *out = k;
    if (!k)
        return err_memory(err);
    k->env = w->env;
    for (i = 0; i < WORLD_MANY; i++) {
        k->hit_buffers[i].csg.scratch = &k->csg;
        k->hit_buffers[i].context = k;
    }
    if (w->scratch_bytes > 0)
        k->scratch = env_alloc_aligned(w->env, w->scratch_bytes, SIMD_LINE);
    k->fresh.always_exact = k->fresh.unfiltered = w->always_exact;
    k->fresh.owner = POV_NO_OWNER;
    k->fresh.capacity = 1;
    k->fresh.scratch = k->scratch;
    k->csg.classes = &k->classes;
    world_measure_trees(w, &most);
    if (csg_scratch_init(&k->csg, &most, w->env) && (k->scratch || w->scratch_bytes == 0))
        return POV_OK;
    query_context_destroy(k);
    *out = NULL;
    return err_memory(err);
}

void query_context_destroy(query_context *k)
{
    int i;

    if (!k)
        return;
    for (i = 0; i < WORLD_MANY; i++)
        env_free(k->env, k->hit_buffers[i].crossings);
    env_free(k->env, k->resolved.items);
    csg_scratch_free(&k->csg);
    env_free_aligned(k->env, k->scratch);
    env_free_aligned(k->env, k);
}

uint64_t query_context_escalated(const query_context *k)
{
    return k->escalated;
}

void query_context_take_classes(query_context *k, class_counts *sum)
{
    uint32_t i;

    for (i = 0; i < WORLD_CLASSES; i++) {
        sum->of[i].asked += k->classes.of[i].asked;
        sum->of[i].escalated += k->classes.of[i].escalated;
    }
    memset(&k->classes, 0, sizeof k->classes);
}

bool query_context_failed(const query_context *k)
{
    return k->failed || k->csg.failed;
}

const object_space_rays *query_context_own(const query_context *k)
{
    return &k->own;
}
