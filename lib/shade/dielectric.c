#include "shade/dielectric.h"

#include "base/elementary.h"
#include "base/simd.h"
#include "base/vec.h"


const interior *dielectric_interior(const model *m, uint32_t which)
{
    return &m->materials.items[model_leaf(m, which)->material].interior;
}

/* A surface without an interior bounds a dielectric of ior 1: a bubble. So does one with an invalid ior. */
static inline double white_ior(const interior *in) { return in->ior > 0.0 && in->ior <= 1e100 ? in->ior : 1.0; }

/* Dispersion is the ior of violet over that of red. */
double dielectric_ior(const interior *in, float hue)
{
    const double middle = white_ior(in);

    return hue < 0.0f || in->dispersion == 1.0 ? middle : middle * elementary_pow(in->dispersion, (double)hue - 0.5);
}

static inline double ior_of(const model *m, uint32_t which, float hue, bool white)
{
    const interior *in = &m->materials.items[model_leaf(m, which)->material].interior;

    return white ? white_ior(in) : dielectric_ior(in, hue);
}

static inline void cross(const uint32_t *list, size_t count, const model *m, uint32_t which, float hue, bool white, dielectric_crossing *out)
{
    size_t index = 0;

    while (index < count && list[index] != which)
        index++;
    out->object = which;
    out->index = index;
    out->before = out->after = count > 0 ? ior_of(m, list[count - 1], hue, white) : 1.0;
    if (index == count)
        out->after = ior_of(m, which, hue, white);
    else if (index == count - 1)
        out->after = index > 0 ? ior_of(m, list[index - 1], hue, white) : 1.0;
}

SIMD_NOINLINE static void cross_coloured(const uint32_t *list, size_t count, const model *m, uint32_t which, float hue, dielectric_crossing *out)
{
    cross(list, count, m, which, hue, false, out);
}

void dielectric_cross(const dielectric_stack *stack, dielectric_span in, const model *m, uint32_t which, float hue,
                      dielectric_crossing *out)
{
    const uint32_t *list = in.count > 0 ? stack->items + in.first : NULL;   /* an empty stack has no items */

    if (hue < 0.0f)
        cross(list, in.count, m, which, hue, true, out);
    else
        cross_coloured(list, in.count, m, which, hue, out);
}

bool dielectric_is_in(const dielectric_stack *stack, dielectric_span in, uint32_t which)
{
    for (size_t i = 0; i < in.count; i++)
        if (stack->items[in.first + i] == which)
            return true;
    return false;
}

bool dielectric_push(dielectric_stack *stack, const env *e, uint32_t which)
{
    return VEC_PUSH(e, stack, which);
}

bool dielectric_pass_any(dielectric_stack *stack, const env *e, dielectric_span *in, const dielectric_crossing *c)
{
    dielectric_span out = { stack->count, 0 };

    for (size_t i = 0; i < in->count; i++)
        if (i != c->index && !dielectric_push(stack, e, stack->items[in->first + i]))
            return false;
    if (c->index == in->count && !dielectric_push(stack, e, c->object))
        return false;
    out.count = stack->count - out.first;
    *in = out;
    return true;
}

/* ---- where camera rays start ---- */

static inline bool is_same(pov_vec3 a, pov_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

typedef struct finding { dielectric_stack *found; const env *env; bool failed; } finding;

static void add_found(void *user, uint32_t which)
{
    finding *f = user;

    if (!dielectric_push(f->found, f->env, which))
        f->failed = true;
}

bool dielectric_find(dielectric_start *s, const env *e, const world *w, const pov_ray *ray)
{
    finding f = { &s->found, e, false };

    if (s->known && is_same(s->org, ray->org) && is_same(s->org_lo, ray->org_lo))
        return true;
    s->found.count = 0;
    world_dielectrics_at(w, ray->org, ray->org_lo, add_found, &f);
    s->org = ray->org;
    s->org_lo = ray->org_lo;
    s->known = true;
    return !f.failed;
}

bool dielectric_begin(dielectric_stack *stack, const env *e, const dielectric_start *from, dielectric_span *out)
{
    out->first = stack->count;
    out->count = 0;
    for (size_t i = 0; i < from->found.count; i++)
        if (!dielectric_push(stack, e, from->found.items[i]))
            return false;
    out->count = stack->count - out->first;
    return true;
}
