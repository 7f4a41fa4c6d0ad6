#include "base/map.h"

#include <string.h>

void map_init(map *m, const env *e)
{
    m->env = e;
    m->slots = NULL;
    m->count = m->capacity = 0;
}

void map_free(map *m)
{
    size_t i;

    for (i = 0; i < m->capacity; i++)
        env_free(m->env, m->slots[i].name);
    env_free(m->env, m->slots);
    map_init(m, m->env);
}

/* FNV-1a, 32 bit. */
static size_t hash(const char *name)
{
    uint32_t h = 2166136261u;

    for (; *name; name++)
        h = (h ^ (unsigned char)*name) * 16777619u;
    return h;
}

/* Slot that holds the name, or the empty slot for it. The capacity is a power of two, and one slot is always empty. */
static map_entry *find(const map *m, const char *name)
{
    size_t i = hash(name) & (m->capacity - 1);

    while (m->slots[i].name && strcmp(m->slots[i].name, name) != 0)
        i = (i + 1) & (m->capacity - 1);
    return &m->slots[i];
}

static bool grow(map *m)
{
    map bigger = *m;
    size_t i;

    bigger.capacity = m->capacity ? 2 * m->capacity : 16;
    bigger.slots = env_alloc(m->env, bigger.capacity, sizeof *bigger.slots);
    if (!bigger.slots)
        return false;
    for (i = 0; i < m->capacity; i++)
        if (m->slots[i].name)
            *find(&bigger, m->slots[i].name) = m->slots[i];
    env_free(m->env, m->slots);
    *m = bigger;
    return true;
}

void *map_get(const map *m, const char *name)
{
    return m->capacity ? find(m, name)->value : NULL;
}

bool map_put(map *m, const char *name, void *value)
{
    map_entry *slot;
    size_t bytes = strlen(name) + 1;

    if (4 * (m->count + 1) > 3 * m->capacity && !grow(m))
        return false;
    slot = find(m, name);
    if (!slot->name) {
        slot->name = env_alloc(m->env, bytes, 1);
        if (!slot->name)
            return false;
        memcpy(slot->name, name, bytes);
        m->count++;
    }
    slot->value = value;
    return true;
}
