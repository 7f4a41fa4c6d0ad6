#include "world/compile.h"

/* Limit of comparisons of boxes, for a cost of about a millisecond. */
enum { PAIRS_MAX = 1 << 19 };
/* Relative gap to other boxes that holds whatever a ray's start is rounded to. */
static const double margin = 0x1p-20;

static bool is_transparent(const compile_state *f, uint32_t id)
{
    return (f->objects_info[id].slot & COMPILE_PLAIN) && !(f->objects_info[id].slot & COMPILE_OPAQUE);
}

/* Counts up to `most` + 1. */
static uint32_t count_transparent(const compile_state *f, uint32_t most)
{
    uint32_t count = 0, i;

    for (i = 0; i < f->finite_count && count <= most; i++)
        count += is_transparent(f, f->finite[i]);
    return count;
}

static pov_box widened(pov_box b)
{
    const double by = margin * pov_largest(pov_sub(b.hi, b.lo));

    b.lo = pov_sub(b.lo, pov_vec3_of(by, by, by));
    b.hi = pov_add(b.hi, pov_vec3_of(by, by, by));
    return b;
}

static bool are_disjoint(const pov_box *a, const pov_box *b)
{
    return a->lo.x > b->hi.x || a->lo.y > b->hi.y || a->lo.z > b->hi.z ||
           b->lo.x > a->hi.x || b->lo.y > a->hi.y || b->lo.z > a->hi.z;
}

static bool is_isolated(const pov_box *boxes, uint32_t count, uint32_t which)
{
    const pov_box own = widened(boxes[which]);
    uint32_t i;

    for (i = 0; i < count; i++)
        if (i != which && !are_disjoint(&own, &boxes[i]))
            return false;
    return true;
}

bool compile_find_isolated(const compile_state *f, uint8_t **isolated)
{
    const uint32_t n = f->finite_count, most = n > 0 ? PAIRS_MAX / n : 0, transparent = count_transparent(f, most);
    pov_box *boxes;
    uint32_t i;

    *isolated = NULL;
    if (transparent == 0 || f->infinite_count > 0 || transparent > most)
        return true;
    boxes = env_resize(f->env, NULL, n, sizeof *boxes);
    *isolated = env_alloc(f->env, compile_count(f), sizeof **isolated);
    for (i = 0; boxes && i < n; i++)
        compile_box(f, f->finite[i], &boxes[i]);
    for (i = 0; boxes && *isolated && i < n; i++)
        (*isolated)[f->finite[i]] = is_transparent(f, f->finite[i]) && is_isolated(boxes, n, i);
    env_free(f->env, boxes);
    return boxes && *isolated;
}
