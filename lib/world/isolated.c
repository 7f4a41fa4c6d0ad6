#include "world/compile.h"

/* Looked for where it costs less than a millisecond or so: boxes are held against boxes. */
enum { PAIRS_MAX = 1 << 19 };
/* What is parted from others by that much of its size is so whatever a ray's start is rounded to. */
static const double margin = 0x1p-20;

static bool is_clear(const flat *f, uint32_t id)
{
    return (f->things[id].slot & FLAT_PLAIN) && !(f->things[id].slot & FLAT_OPAQUE);
}

/* Up to one more than that. */
static uint32_t count_clear(const flat *f, uint32_t most)
{
    uint32_t count = 0, i;

    for (i = 0; i < f->finite_count && count <= most; i++)
        count += is_clear(f, f->finite[i]);
    return count;
}

static pov_box widened(pov_box b)
{
    const double by = margin * pov_largest(pov_sub(b.hi, b.lo));

    b.lo = pov_sub(b.lo, pov_vec3_of(by, by, by));
    b.hi = pov_add(b.hi, pov_vec3_of(by, by, by));
    return b;
}

static bool are_apart(const pov_box *a, const pov_box *b)
{
    return a->lo.x > b->hi.x || a->lo.y > b->hi.y || a->lo.z > b->hi.z ||
           b->lo.x > a->hi.x || b->lo.y > a->hi.y || b->lo.z > a->hi.z;
}

static bool is_lonely(const pov_box *boxes, uint32_t count, uint32_t which)
{
    const pov_box own = widened(boxes[which]);
    uint32_t i;

    for (i = 0; i < count; i++)
        if (i != which && !are_apart(&own, &boxes[i]))
            return false;
    return true;
}

bool flat_find_lonely(const flat *f, uint8_t **lonely)
{
    const uint32_t n = f->finite_count, most = n > 0 ? PAIRS_MAX / n : 0, clear = count_clear(f, most);
    pov_box *boxes;
    uint32_t i;

    *lonely = NULL;
    if (clear == 0 || f->infinite_count > 0 || clear > most)
        return true;
    boxes = env_resize(f->env, NULL, n, sizeof *boxes);
    *lonely = env_alloc(f->env, flat_count(f), sizeof **lonely);
    for (i = 0; boxes && i < n; i++)
        flat_box(f, f->finite[i], &boxes[i]);
    for (i = 0; boxes && *lonely && i < n; i++)
        (*lonely)[f->finite[i]] = is_clear(f, f->finite[i]) && is_lonely(boxes, n, i);
    env_free(f->env, boxes);
    return boxes && *lonely;
}
