#include "query/context.h"

#include "base/err.h"
#include "base/simd.h"

#include <string.h>

pov_status walker_create(walker **out, const world *w, pov_error *err)
{
    walker *k = env_alloc_aligned(w->env, sizeof *k, SIMD_LINE);
    int i;

    *out = k;
    if (!k)
        return err_memory(err);
    k->env = w->env;
    for (i = 0; i < WORLD_MANY; i++) {
        k->rooms[i].csg = &k->csg;
        k->rooms[i].walker = k;
    }
    if (w->scratch_bytes > 0)
        k->scratch = env_alloc_aligned(w->env, w->scratch_bytes, SIMD_LINE);
    if (csg_scratch_init(&k->csg, world_trees(w), w->env) && (k->scratch || w->scratch_bytes == 0))
        return POV_OK;
    walker_destroy(k);
    *out = NULL;
    return err_memory(err);
}

void walker_destroy(walker *k)
{
    int i;

    if (!k)
        return;
    for (i = 0; i < WORLD_MANY; i++)
        env_free(k->env, k->rooms[i].crossings);
    csg_scratch_free(&k->csg);
    env_free_aligned(k->env, k->scratch);
    env_free_aligned(k->env, k);
}

uint64_t walker_decided(const walker *k)
{
    return k->decided;
}

void walker_take_classes(walker *k, class_counts *sum)
{
    uint32_t i;

    for (i = 0; i < WORLD_CLASSES; i++) {
        sum->of[i].asked += k->classes.of[i].asked;
        sum->of[i].decided += k->classes.of[i].decided;
    }
    memset(&k->classes, 0, sizeof k->classes);
}

bool walker_failed(const walker *k)
{
    return k->failed || k->csg.failed;
}

const own_rays *walker_own(const walker *k)
{
    return &k->own;
}
