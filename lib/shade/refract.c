#include "shade/refract.h"

#include "base/vec.h"

#include <string.h>

/* A surface without an interior bounds a medium of ior 1: a bubble. An ior that is no positive number is that too. */
static double ior_of(const model *m, uint32_t which)
{
    double ior = m->materials.items[m->objects.items[which].material].ior;

    return ior > 0.0 && ior <= 1e100 ? ior : 1.0;
}

media_crossing media_cross(const media_stack *stack, media_span in, const model *m, uint32_t which)
{
    const uint32_t *list = stack->items + in.first;
    media_crossing c = { which, 0, 1.0, 1.0 };

    while (c.index < in.count && list[c.index] != which)
        c.index++;
    if (in.count > 0)
        c.before = c.after = ior_of(m, list[in.count - 1]);
    if (c.index == in.count)
        c.after = ior_of(m, which);
    else if (c.index == in.count - 1)
        c.after = c.index > 0 ? ior_of(m, list[c.index - 1]) : 1.0;
    return c;
}

bool media_push(media_stack *stack, const env *e, uint32_t which)
{
    return VEC_PUSH(e, stack, which);
}

/* A copy of the span at the top. */
static bool lift(media_stack *stack, const env *e, media_span *span)
{
    size_t first = stack->count;

    for (size_t i = 0; i < span->count; i++)
        if (!media_push(stack, e, stack->items[span->first + i]))
            return false;
    span->first = first;
    return true;
}

bool media_pass(media_stack *stack, const env *e, media_span *in, const media_crossing *c, bool keep)
{
    bool on_top = in->first + in->count == stack->count;
    uint32_t *list;

    if ((keep || !on_top) && !lift(stack, e, in))
        return false;
    if (c->index == in->count) {
        in->count++;
        return media_push(stack, e, c->object);
    }
    list = stack->items + in->first;
    in->count--;
    stack->count--;
    memmove(list + c->index, list + c->index + 1, (in->count - c->index) * sizeof *list);
    return true;
}

void media_settle(media_stack *stack, media_span *span, size_t floor)
{
    if (span->count > 0)
        memmove(stack->items + floor, stack->items + span->first, span->count * sizeof *stack->items);
    span->first = floor;
    stack->count = floor + span->count;
}

/* With eta = before / after, c and c' the cosines of both angles, and e = eta^2 - 1:
 *     c'^2 = (eta c)^2 - e,    out = eta view + (eta c - c') normal,    eta c - c' = e / (eta c + c').
 * The last form and e = (before - after)(before + after) / after^2 have no cancellation, so that an ior of 1 + 1e-11
 * bends by what it should. The final correction puts the component along the normal on the right side also where
 * rounding of eta view is larger than c'. */
bool refract(pov_vec3 view, pov_vec3 normal, double cosine, double before, double after, pov_vec3 *out)
{
    double eta = before / after, e = eta * ((before - after) / before) * ((before + after) / after);
    double along = eta * cosine, cosine_out, critical;
    pov_vec3 d;

    if (e > 0.0) {
        critical = sqrt(e);
        if (!(along > critical))
            return false;
        cosine_out = sqrt((along - critical) * (along + critical));
    } else {
        cosine_out = sqrt(along * along - e);
    }
    d = pov_add(pov_scale(view, eta), pov_scale(normal, e / (along + cosine_out)));
    *out = pov_unit(pov_sub(d, pov_scale(normal, pov_dot(d, normal) + cosine_out)));
    return true;
}
