#include "sdl/materials.h"

#include "base/vec.h"
#include "sdl/report.h"

#include <string.h>

enum { HASHED = 20 };
/* Powers of 0x9E3779B1: each number times a factor of its own, side by side. */
static const uint32_t factors[HASHED] = {
    0x9E3779B1u, 0xFFE6CC61u, 0xCC042811u, 0x1F76BCC1u, 0x8BC6BA71u,
    0x5ECD5121u, 0x6364B0D1u, 0x4B180981u, 0xF0D38B31u, 0xA49465E1u,
    0xB018C991u, 0x448FE641u, 0x0149EBF1u, 0x43680AA1u, 0x6E8C7251u,
    0x5E8A5301u, 0x3215DCB1u, 0x9E743F61u, 0xFC2BAB11u, 0x3CB34FC1u,
};

static uint32_t hash_of(const material *m)
{
    const finish *f = &m->finish;
    const float numbers[HASHED] = {
        m->pigment.r, m->pigment.g, m->pigment.b, m->filter, m->transmit, f->ambient.r, f->ambient.g, f->ambient.b,
        f->diffuse, f->phong, f->phong_size, f->metallic, f->specular, (float)f->roughness, f->reflection.max.r,
        f->reflection.max.g, f->reflection.max.b, (float)m->interior.ior, m->interior.given ? 1.0f : 0.0f, 0.0f,
    };
    uint32_t bits, hash = (uint32_t)((uintptr_t)m->texture >> 4) ^ (uint32_t)((uintptr_t)m->inside >> 3);

    for (size_t i = 0; i < HASHED; i++) {
        const float number = numbers[i] + 0.0f;   /* -0 equals 0 */

        memcpy(&bits, &number, sizeof bits);
        hash += bits * factors[i];
    }
    hash = (hash ^ hash >> 16) * 0x85EBCA6Bu;
    return hash ^ hash >> 13;
}

/* The slot that holds the material, or the empty one where it belongs. m NULL: only an empty one. */
static material_slot *slot_of(const pov_reader *in, const material *m, uint32_t hash)
{
    const material *items = in->model->materials.items;
    size_t i = hash & (in->material_capacity - 1);
    const material_slot *s;

    for (s = in->material_slots; s[i].number > 0; i = (i + 1) & (in->material_capacity - 1))
        if (m && s[i].hash == hash && material_equal(&items[s[i].number - 1], m))
            break;
    return &in->material_slots[i];
}

static bool grow(pov_reader *in)
{
    material_slot *old = in->material_slots;
    const size_t count = in->material_capacity, capacity = count ? 2 * count : 64;
    material_slot *slots = env_alloc(in->model->env, capacity, sizeof *slots);

    if (!slots)
        return false;
    in->material_slots = slots;
    in->material_capacity = capacity;
    for (size_t i = 0; i < count; i++)
        if (old[i].number > 0)
            *slot_of(in, NULL, old[i].hash) = old[i];
    env_free(in->model->env, old);
    return true;
}

uint32_t materials_index(pov_reader *in, const material *m)
{
    material_list *known = &in->model->materials;
    material_slot *slot;
    uint32_t hash;

    if (in->failed)
        return 0;
    if (known->count > 0 && material_equal(&known->items[known->count - 1], m))
        return (uint32_t)(known->count - 1);
    if (2 * (known->count + 1) > in->material_capacity && !grow(in)) {
        report_memory(in);
        return 0;
    }
    hash = hash_of(m);
    slot = slot_of(in, m, hash);
    if (slot->number > 0)
        return slot->number - 1;
    if (!VEC_PUSH(in->model->env, known, *m)) {
        report_memory(in);
        return 0;
    }
    *slot = (material_slot){ hash, (uint32_t)known->count };
    return slot->number - 1;
}
