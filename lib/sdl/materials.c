#include "sdl/materials.h"

#include "base/vec.h"
#include "sdl/report.h"

#include <string.h>

static uint32_t mix(uint32_t hash, float number)
{
    uint32_t bits;

    number += 0.0f;               /* -0 equals 0 */
    memcpy(&bits, &number, sizeof bits);
    return (hash ^ bits) * 0x9E3779B1u + (hash >> 15);
}

static uint32_t mix_colour(uint32_t hash, colour c)
{
    return mix(mix(mix(hash, c.r), c.g), c.b);
}

static uint32_t hash_of(const material *m)
{
    const finish *f = &m->finish;
    uint32_t hash = mix_colour(m->interior.given, m->pigment);

    hash = mix(mix(hash, m->filter), m->transmit);
    hash = mix_colour(hash, f->ambient);
    hash = mix(mix(mix(mix(hash, f->diffuse), f->phong), f->phong_size), f->metallic);
    hash = mix(mix(hash, f->specular), (float)f->roughness);
    hash = mix_colour(hash, f->reflection.max);
    hash = mix(hash, (float)m->interior.ior);
    hash ^= (uint32_t)((uintptr_t)m->texture >> 4) ^ (uint32_t)((uintptr_t)m->inside >> 3);
    return hash ^ hash >> 16;
}

/* The slot that holds the material, or the empty one where it belongs. */
static uint32_t *slot_of(pov_reader *in, const material *m)
{
    const material *items = in->model->materials.items;
    size_t i = hash_of(m) & (in->material_capacity - 1);

    while (in->material_slots[i] && !material_equal(&items[in->material_slots[i] - 1], m))
        i = (i + 1) & (in->material_capacity - 1);
    return &in->material_slots[i];
}

static bool grow(pov_reader *in)
{
    const material_list *known = &in->model->materials;
    size_t i, capacity = in->material_capacity ? 2 * in->material_capacity : 64;
    uint32_t *slots = env_alloc(in->model->env, capacity, sizeof *slots);

    if (!slots)
        return false;
    env_free(in->model->env, in->material_slots);
    in->material_slots = slots;
    in->material_capacity = capacity;
    for (i = 0; i < known->count; i++)
        *slot_of(in, &known->items[i]) = (uint32_t)(i + 1);
    return true;
}

uint32_t materials_index(pov_reader *in, const material *m)
{
    material_list *known = &in->model->materials;
    uint32_t *slot;

    if (in->failed)
        return 0;
    if (known->count > 0 && material_equal(&known->items[known->count - 1], m))
        return (uint32_t)(known->count - 1);
    if (2 * (known->count + 1) > in->material_capacity && !grow(in)) {
        report_memory(in);
        return 0;
    }
    slot = slot_of(in, m);
    if (*slot)
        return *slot - 1;
    if (!VEC_PUSH(in->model->env, known, *m)) {
        report_memory(in);
        return 0;
    }
    *slot = (uint32_t)known->count;
    return *slot - 1;
}
