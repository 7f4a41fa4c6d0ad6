/* Opaque objects that lie where an earlier one lies, as where a program writes each edge of a mesh once for either face. Of surfaces
 * in one place a ray crosses the one that stands first in the text (docs/numerics.md, "Coincident surfaces"), and none goes through
 * it. So the later ones are never seen, and rays need not be tested against them: they are laid out as members of trees are. */
#include "world/compile.h"

#include "base/hash.h"

#include <string.h>

/* A table of leaves by their hash, with twice as many slots. `number` is one more than a leaf's index. */
typedef struct slot { uint32_t number, hash; } slot;
typedef struct twins {
    compile_state *f;
    slot *slots;
    size_t mask;
} twins;

/* The text of a shape, in the one order that all texts of the same solid have. */
enum { TEXT = 512 };
typedef struct written { SIMD_ALIGNED unsigned char bytes[TEXT]; size_t count; } written;

static bool read(const leaf_node *o, written *out)
{
    out->count = o->shape->prepare ? o->shape->parsed_size : o->shape->instance_size;
    if (out->count > TEXT)
        return false;
    memcpy(out->bytes, o->instance, out->count);
    if (o->shape->reorder)
        o->shape->reorder(out->bytes);
    return true;
}

/* What fills it, it fills together with its twin. */
static bool may_be_twin(const compile_state *f, size_t leaf)
{
    const leaf_node *o = &f->model->leaves.items[leaf];
    const material *of = &f->model->materials.items[o->material];

    return !(f->is_member && f->is_member[leaf]) && !material_is_transparent(of) && !of->interior.media;
}

static bool is_twin(const leaf_node *a, const leaf_node *b, const written *of_a)
{
    written of_b;

    return a->shape == b->shape && a->map == b->map && a->flags == b->flags && read(b, &of_b) &&
           memcmp(of_a->bytes, of_b.bytes, of_b.count) == 0;
}

/* Put a leaf in the table, or find that it is the twin of one that is there. */
static bool put(twins *t, uint32_t leaf)
{
    const leaf_node *all = t->f->model->leaves.items;
    written text;
    uint64_t hash;

    if (!may_be_twin(t->f, leaf) || !read(&all[leaf], &text))
        return false;
    hash = hash_bytes((uint64_t)(uintptr_t)all[leaf].map, text.bytes, text.count);
    for (size_t at = hash & t->mask;; at = (at + 1) & t->mask) {
        const slot found = t->slots[at];

        if (!found.number) {
            t->slots[at] = (slot){ leaf + 1, (uint32_t)(hash >> 32) };
            return false;
        }
        if (found.hash == (uint32_t)(hash >> 32) && is_twin(&all[leaf], &all[found.number - 1], &text))
            return true;
    }
}

/* In larger scenes looking for them would take a sixth of the time to build the world. */
bool compile_find_twins(compile_state *f)
{
    const uint32_t n = (uint32_t)f->model->leaves.count;
    size_t count = 2;
    twins t = { f, NULL, 0 };

    if (n > COMPILE_MANY)
        return true;
    while (count < 2 * (size_t)n)
        count *= 2;
    t.mask = count - 1;
    t.slots = env_alloc(f->env, count, sizeof *t.slots);
    f->is_twin = env_alloc(f->env, n + 1u, sizeof *f->is_twin);
    for (uint32_t i = 0; t.slots && f->is_twin && i < n; i++)
        f->is_twin[i] = put(&t, i);
    env_free(f->env, t.slots);
    return t.slots && f->is_twin;
}
