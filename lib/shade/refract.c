#include "shade/refract.h"

#include "base/simd.h"
#include "base/vec.h"
#include "shade/geometry.h"

#include <string.h>

/* A surface without an interior bounds a medium of ior 1: a bubble. An ior that is no positive number is that
 * too. */
static double ior_of(const model *m, uint32_t which)
{
    double ior = m->materials.items[m->leaves.items[which].material].ior;

    return ior > 0.0 && ior <= 1e100 ? ior : 1.0;
}

void media_cross(const media_stack *stack, media_span in, const model *m, uint32_t which, media_crossing *out)
{
    const uint32_t *list = in.count > 0 ? stack->items + in.first : NULL;
    size_t index = 0;

    while (index < in.count && list[index] != which)
        index++;
    out->object = which;
    out->index = index;
    out->before = out->after = in.count > 0 ? ior_of(m, list[in.count - 1]) : 1.0;
    if (index == in.count)
        out->after = ior_of(m, which);
    else if (index == in.count - 1)
        out->after = index > 0 ? ior_of(m, list[index - 1]) : 1.0;
}

bool media_push(media_stack *stack, const env *e, uint32_t which)
{
    return VEC_PUSH(e, stack, which);
}

bool media_pass(media_stack *stack, const env *e, media_span *in, const media_crossing *c)
{
    media_span out = { stack->count, 0 };

    for (size_t i = 0; i < in->count; i++)
        if (i != c->index && !media_push(stack, e, stack->items[in->first + i]))
            return false;
    if (c->index == in->count && !media_push(stack, e, c->object))
        return false;
    out.count = stack->count - out.first;
    *in = out;
    return true;
}

void media_settle(media_stack *stack, media_span *span, size_t floor)
{
    if (span->count > 0)
        memmove(stack->items + floor, stack->items + span->first, span->count * sizeof *stack->items);
    span->first = floor;
    stack->count = floor + span->count;
}

/* The square of the cosine behind the surface, c'^2 = 1 - (eta s)^2 = (eta c)^2 - e with e = eta^2 - 1, where
 * s is the sine before it. Steep rays take the first form, for a large eta multiplies the error of s by less
 * than that of c^2; flat ones the second, in which (before - after)(before + after) keeps what an ior of 1 +
 * 1e-11 is about. */
static inline double squared_cosine(double sine_out, double cosine, double before, double after)
{
    const double steep = 0.5, eta = before / after;
    const double e = eta * ((before - after) / before) * ((before + after) / after);
    const double critical = sqrt(e > 0.0 ? e : 0.0);
    const double flat = e <= 0.0 ? eta * cosine * eta * cosine - e
                                 : (eta * cosine - critical) * (eta * cosine + critical);

    return cosine > steep ? (1.0 - sine_out) * (1.0 + sine_out) : flat;
}

/* The way behind the surface, of about unit length; returns what squared_cosine() does. */
static inline double bend(pov_vec3 view, pov_vec3 normal, double cosine, double before, double after, pov_vec3 *out)
{
    pov_vec3 along = pov_add(view, pov_scale(normal, cosine));
    double c2;

    along = pov_scale(pov_sub(along, pov_scale(normal, pov_dot(along, normal))), before / after);
    c2 = squared_cosine(sqrt(pov_dot(along, along)), cosine, before, after);
    *out = pov_sub(along, pov_scale(normal, sqrt(c2 > 0.0 ? c2 : 0.0)));
    return c2;
}

bool refract(pov_vec3 view, pov_vec3 normal, double cosine, double before, double after, pov_vec3 *out)
{
    const double c2 = bend(view, normal, cosine, before, after, out);

    *out = pov_unit(*out);
    return c2 > 0.0;
}

/* False: some way is too short or long for its square. */
SIMD_CLONES static bool bend_plain(bends *restrict b, const vec_lanes *restrict view, const vec_lanes *restrict normal,
                                   const double *restrict cosines, uint32_t n)
{
    int64_t plain = -1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 way;

        b->squared_cosine[i] = bend(lanes_at(view, i), lanes_at(normal, i), cosines[i], b->before[i], b->after[i],
                                    &way);
        plain &= geometry_unit(way.x, way.y, way.z, &way);
        lanes_put(&b->way, i, way);
    }
    return plain != 0;
}

void refract_many(bends *b, const vec_lanes *view, const vec_lanes *normal, const double *cosines, uint32_t n)
{
    if (bend_plain(b, view, normal, cosines, lanes_whole(n)))
        return;
    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 way;

        refract(lanes_at(view, i), lanes_at(normal, i), cosines[i], b->before[i], b->after[i], &way);
        lanes_put(&b->way, i, way);
    }
}
