#include "world/compile_maps.h"

#include "plug/shape_class.h"

#include <stddef.h>
#include <string.h>

void compile_maps_init(compile_maps *k)
{
    memset(k, 0, offsetof(compile_maps, approx_maps));
}

/* The flags of a class tell for some transformations, even before they are composed, that its shapes cannot absorb
 * them. */
static bool is_rigid(const leaf_node *o)
{
    if (!o->map)
        return false;
    return !o->shape->absorb || (o->shape->flags & POV_SHAPE_SPHERE && transform_is_uneven(o->map)) ||
           (o->shape->flags & POV_SHAPE_BOX && transform_is_turned(o->map));
}

static bool is_marked(const compile_maps *k, const leaf_node *o)
{
    return k->rigid >> (o - k->window) & 1;
}

/* Collect the objects that follow in the window, up to the first with transformations of other kinds, and with the same
 * rigidity. */
static int gather(const compile_maps *k, const leaf_node *o, const transform **lists, int most)
{
    const bool rigid = is_marked(k, o);
    int n = 0;

    for (; o < k->end && n < most; o++) {
        if (!o->map || is_marked(k, o) != rigid || (n > 0 && o->map == lists[n - 1]))
            continue;
        if (n > 0 && !transform_are_alike(o->map, lists[0]))
            break;
        lists[n++] = o->map;
    }
    return n;
}

const pov_affine *compile_maps_compose(compile_maps *k, const leaf_node *o)
{
    while (k->now < k->list_count && k->lists[k->now] != o->map)
        k->now++;
    if (k->now == k->list_count) {
        k->now = 0;
        k->list_count = gather(k, o, k->lists, TRANSFORM_MANY);
        k->good = transform_compose_many(k->lists, k->list_count, k->maps);
    }
    return k->good >> k->now & 1 ? &k->maps[k->now] : NULL;
}

bool compile_maps_is_approx(compile_maps *k, const leaf_node *o)
{
    if (!is_marked(k, o))
        return false;
    while (k->approx_now < k->approx_count && k->approx[k->approx_now] != o->map)
        k->approx_now++;
    if (k->approx_now == k->approx_count) {
        k->approx_now = 0;
        k->approx_count = gather(k, o, k->approx, APPROX_MANY);
        k->moderate = transform_approx(k->approx, k->approx_count, &k->approx_maps);
    }
    return k->moderate >> k->approx_now & 1;
}

bool compile_maps_box(const compile_maps *k, const leaf_node *o, const pov_box *own, pov_box *out)
{
    return transform_approx_box(&k->approx_maps, k->approx_now, own, o->shape->flags & POV_SHAPE_SPHERE, out);
}

void compile_maps_open(compile_maps *k, const leaf_node *first, uint32_t n)
{
    uint32_t i;

    k->window = first;
    k->end = first + (n < COMPILE_WINDOW ? n : COMPILE_WINDOW);
    k->rigid = 0;
    for (i = 0; first + i < k->end; i++)
        k->rigid |= (uint32_t)is_rigid(&first[i]) << i;
}
