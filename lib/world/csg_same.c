/* Members of a tree that are one surface: equal records under equal transforms. Their crossings have the same bits if all
 * are left by the name of the one that a ray starts on; by their own names, one's root is divided out and the others' are
 * rounded. */
#include "base/hash.h"
#include "world/csg.h"

#include <stdlib.h>
#include <string.h>

/* Of a transform, what rays are taken through. */
static const void *inverse_of(const instance_xform *x) { return x->column; }
static const size_t inverse_size = sizeof(instance_xform) - offsetof(instance_xform, column);

static bool is_same(const csg_member *a, const csg_member *b)
{
    if (a->shape != b->shape || !a->xform != !b->xform || memcmp(a->instance, b->instance, a->shape->instance_size) != 0)
        return false;
    return !a->xform || (memcmp(&a->xform->anchor, &b->xform->anchor, sizeof a->xform->anchor) == 0 &&
                         memcmp(inverse_of(a->xform), inverse_of(b->xform), inverse_size) == 0);
}

typedef struct hashed { uint64_t hash; uint32_t member; } hashed;

static hashed hash_of(const csg_tree *t, uint32_t member)
{
    const csg_member *m = &t->members[member];
    hashed out = { hash_bytes(0, m->instance, m->shape->instance_size), member };

    out.hash = m->xform ? hash_bytes(out.hash, inverse_of(m->xform), inverse_size) : out.hash;
    return out;
}

static int by_hash(const void *a, const void *b)
{
    const hashed *x = a, *y = b;

    return x->hash != y->hash ? (x->hash < y->hash ? -1 : 1) : x->member < y->member ? -1 : x->member > y->member;
}

bool csg_find_same(csg_tree *t, const env *e)
{
    hashed *all = env_alloc(e, t->member_count, sizeof *all);

    if (!all)
        return false;
    for (uint32_t i = 0; i < t->member_count; i++) {
        t->members[i].same = i;
        all[i] = hash_of(t, i);
    }
    qsort(all, t->member_count, sizeof *all, by_hash);
    for (uint32_t i = 1; i < t->member_count; i++) {
        csg_member *m = &t->members[all[i].member];
        const csg_member *before = &t->members[all[i - 1].member];

        if (all[i].hash == all[i - 1].hash && is_same(m, before))
            m->same = before->same;
    }
    env_free(e, all);
    return true;
}
