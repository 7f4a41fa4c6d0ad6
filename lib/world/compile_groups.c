/* Groups: the shapes of one class with the same storage, and the lists of objects. */
#include "world/compile.h"

static uint32_t stride_of(const shape_class *shape)
{
    size_t bytes = shape->instance_size > 0 ? shape->instance_size : 1;
    return (uint32_t)((bytes + COMPILE_ALIGN - 1) / COMPILE_ALIGN * COMPILE_ALIGN);
}

/* Classes are numbered in the order of the scene; the last number is shared by all further classes. */
static uint8_t number_of(const compile_state *f, const shape_class *shape)
{
    uint8_t next = 0;
    size_t i;

    for (i = 0; i < f->group_count; i++) {
        if (f->groups[i].shape == shape)
            return f->groups[i].class_number;
        if (f->groups[i].class_number >= next)
            next = (uint8_t)(f->groups[i].class_number + 1);
    }
    return next < WORLD_CLASSES ? next : WORLD_CLASSES - 1;
}

bool compile_make_groups(compile_state *f, const shape_class *const *classes, size_t count)
{
    size_t n = compile_count(f), most = COMPILE_KINDS * count, i;
    uint16_t *name = env_alloc(f->env, most, sizeof *name);   /* 0: not seen yet */
    uint32_t finite = 0, infinite = 0, members = 0;

    f->groups = env_alloc(f->env, most, sizeof *f->groups);
    f->shares_leaf = env_alloc(f->env, most, sizeof *f->shares_leaf);
    f->finite = env_resize(f->env, NULL, f->finite_count + 1u, sizeof *f->finite);
    f->infinite = env_resize(f->env, NULL, f->infinite_count + 1u, sizeof *f->infinite);
    f->member_count = (uint32_t)n - f->finite_count - f->infinite_count;
    f->members = env_resize(f->env, NULL, f->member_count + 1u, sizeof *f->members);
    for (i = 0; name && f->groups && f->shares_leaf && f->finite && f->infinite && f->members && i < n; i++) {
        unsigned mark = f->group[i], old = mark & ~(unsigned)(COMPILE_INFINITE | COMPILE_MEMBER);
        if (!name[old]) {
            const shape_class *shape = classes[old / COMPILE_KINDS];
            shape_group fresh = { shape, old % COMPILE_KINDS == COMPILE_INSTANCED,
                                  old % COMPILE_KINDS == COMPILE_SHARES_LEAF, number_of(f, shape), 0, stride_of(shape), NULL };
            f->shares_leaf[f->group_count] = fresh.shares_leaf && shape->full_leaves;
            f->groups[f->group_count] = fresh;
            name[old] = (uint16_t)++f->group_count;
        }
        f->group[i] = (uint16_t)(name[old] - 1);
        f->groups[f->group[i]].count++;
        if (mark & COMPILE_MEMBER)
            f->members[members++] = (uint32_t)i;
        else if (mark & COMPILE_INFINITE)
            f->infinite[infinite++] = (uint32_t)i;
        else
            f->finite[finite++] = (uint32_t)i;
    }
    env_free(f->env, name);
    return f->groups && f->shares_leaf && f->finite && f->infinite && f->members && i == n;
}

void compile_free_groups(const env *e, shape_group *groups, size_t count)
{
    size_t i;

    for (i = 0; groups && i < count; i++)
        env_free_aligned(e, groups[i].instances);
    env_free(e, groups);
}
