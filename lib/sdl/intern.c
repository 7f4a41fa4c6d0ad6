#include "sdl/intern.h"

#include "base/hash.h"
#include "sdl/report.h"

#include <string.h>

/* The slot that holds the bytes, or the empty one where they belong. */
static interned *find(const intern_table *t, const void *item, size_t compared, uint64_t hash)
{
    size_t i = (size_t)hash & (t->capacity - 1);

    while (t->slots[i].item && (t->slots[i].hash != hash || t->slots[i].compared != compared ||
                                memcmp(t->slots[i].item, item, compared) != 0))
        i = (i + 1) & (t->capacity - 1);
    return &t->slots[i];
}

static bool grow(intern_table *t, const env *e)
{
    intern_table larger = { NULL, t->count, t->capacity ? 2 * t->capacity : 64 };

    larger.slots = env_alloc(e, larger.capacity, sizeof *larger.slots);
    if (!larger.slots)
        return false;
    for (size_t i = 0; i < t->capacity; i++)
        if (t->slots[i].item)
            *find(&larger, t->slots[i].item, t->slots[i].compared, t->slots[i].hash) = t->slots[i];
    env_free(e, t->slots);
    *t = larger;
    return true;
}

const void *intern(pov_reader *in, const void *item, size_t bytes, size_t compared)
{
    intern_table *t = &in->interned;
    const uint64_t hash = hash_bytes(0, item, compared);
    interned *slot;
    void *kept;

    if (in->failed || bytes == 0)
        return NULL;
    if (2 * (t->count + 1) > t->capacity && !grow(t, in->model->env)) {
        report_memory(in);
        return NULL;
    }
    slot = find(t, item, compared, hash);
    if (slot->item)
        return slot->item;
    kept = state_alloc(in, bytes, 16);
    if (!kept)
        return NULL;
    memcpy(kept, item, bytes);
    *slot = (interned){ kept, compared, hash };
    t->count++;
    return kept;
}

void intern_free(intern_table *t, const env *e)
{
    env_free(e, t->slots);
}
