#include "base/elementary.h"
#include "world/compile.h"
#include "world/internal.h"

/* Luminance from which on a surface is a lamp: brighter than what light sources make of most. */
static const float bright = 0.9f;

static float light_of(const model *m, const material *of)
{
    const colour ambient = colour_mul(of->finish.ambient, m->ambient_light);

    return colour_luminance(colour_mul(colour_add(of->finish.emission, ambient), of->pigment));
}

/* The same for a tree and a list of objects, whose boxes are not rounded alike. */
static double rounded(double x) { return elementary_of_bits((elementary_bits(x) + 0x800000) & ~(uint64_t)0xffffff); }

static pov_box rounded_box(const pov_box *of)
{
    const pov_box box = { pov_vec3_of(rounded(of->lo.x), rounded(of->lo.y), rounded(of->lo.z)),
                          pov_vec3_of(rounded(of->hi.x), rounded(of->hi.y), rounded(of->hi.z)) };

    return box;
}

static double surface_of(const pov_box *b)
{
    const pov_vec3 size = pov_sub(b->hi, b->lo);

    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/* The strongest ones are kept; of equal ones the first. */
static void add(world_lamps *all, const world_lamp *one)
{
    uint32_t least = 0;

    if (all->count < WORLD_LAMPS_MAX) {
        all->items[all->count++] = *one;
        return;
    }
    for (uint32_t i = 1; i < all->count; i++)
        if (all->items[i].power <= all->items[least].power)
            least = i;
    if (one->power > all->items[least].power)
        all->items[least] = *one;
}

void compile_find_lamps(const compile_state *f, world_lamps *out)
{
    const model *m = f->model;

    out->count = 0;
    for (uint32_t i = 0; i < f->finite_count; i++) {
        const uint32_t object = f->finite[i];
        world_lamp one;
        pov_box box;
        float shines;

        if (object >= m->leaves.count || (m->leaves.items[object].flags & LEAF_NO_RADIOSITY))
            continue;
        shines = light_of(m, &m->materials.items[m->leaves.items[object].material]);
        if (!(shines > bright))
            continue;
        compile_box(f, object, &box);
        one.box = rounded_box(&box);
        one.power = (double)shines * surface_of(&one.box);
        add(out, &one);
    }
}
