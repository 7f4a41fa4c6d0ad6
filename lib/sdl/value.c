#include "sdl/value.h"

#include "base/env.h"

void *value_share(value_heap *heap, value_kind kind, size_t bytes)
{
    shared *item;

    if (heap->most_bytes > 0 && bytes > heap->most_bytes - heap->bytes) {
        heap->is_full = true;
        return NULL;
    }
    item = env_alloc(heap->env, 1, bytes);
    if (!item)
        return NULL;
    heap->bytes += bytes;
    item->bytes = bytes;
    item->kind = kind;
    item->uses = 1;
    item->next = heap->first;
    if (item->next)
        item->next->previous = item;
    heap->first = item;
    return item;
}

void value_unshare(value_heap *heap, shared *item)
{
    if (--item->uses > 0)
        return;
    heap->drop(heap, item);
    heap->bytes -= item->bytes;
    if (item->previous)
        item->previous->next = item->next;
    else
        heap->first = item->next;
    if (item->next)
        item->next->previous = item->previous;
    env_free(heap->env, item);
}

void value_free_all(value_heap *heap)
{
    shared *item, *next;

    for (item = heap->first; item; item = next) {
        next = item->next;
        env_free(heap->env, item);
    }
    heap->first = NULL;
}

value value_of_vector(pov_vec3 vector)
{
    value v = { VALUE_VECTOR, false, false, 3, { { vector.x, vector.y, vector.z, 0.0, 0.0 } } };

    return v;
}

value value_of_part(value_kind kind, const void *part)
{
    value v;

    v.kind = kind;
    v.is_colour = false;
    v.size = 0;
    v.as.part = part;
    return v;
}

const char *value_kind_name(value_kind kind)
{
    static const char *const names[VALUE_KINDS] = {
        "nothing",      "a number",     "a vector",      "a string",     "an array",      "a macro",
        "a spline",     "a file",       "a function",    "a transform",  "an object",     "a texture",
        "a pigment",    "a normal",     "a finish",      "a material",   "an interior",   "a media",
        "a density",    "a camera",     "a light",       "a sky_sphere", "a fog",         "a rainbow",
        "a color_map",  "a pigment_map", "a normal_map", "a texture_map", "a slope_map",  "a density_map",
    };

    return names[kind];
}

const char *value_name(const value *v)
{
    return v->is_colour && v->kind == VALUE_VECTOR ? "a colour" : value_kind_name(v->kind);
}

bool value_is_alike(const value *a, const value *b)
{
    return a->kind == b->kind && (a->kind != VALUE_VECTOR || a->size == b->size);
}
