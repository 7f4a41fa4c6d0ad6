#include "common/cell_box.h"

/* Halves of the whole, one axis after the other. */
enum { HALVES = 12 };

typedef struct search { const void *shape; common_may_hold *may_hold; pov_box *out; } search;

static bool is_boxed(const pov_box *all, const pov_box *b)
{
    return b->lo.x >= all->lo.x && b->lo.y >= all->lo.y && b->lo.z >= all->lo.z && b->hi.x <= all->hi.x && b->hi.y <= all->hi.y &&
           b->hi.z <= all->hi.z;
}

static void add_box(pov_box *all, const pov_box *b)
{
    all->lo = pov_vec3_of(pov_min(all->lo.x, b->lo.x), pov_min(all->lo.y, b->lo.y), pov_min(all->lo.z, b->lo.z));
    all->hi = pov_vec3_of(pov_max(all->hi.x, b->hi.x), pov_max(all->hi.y, b->hi.y), pov_max(all->hi.z, b->hi.z));
}

static void find_cells(const search *s, const pov_box *cell, uint32_t left)
{
    const pov_vec3 middle = pov_scale(pov_add(cell->lo, cell->hi), 0.5);
    const double at = left % 3 == 0 ? middle.x : left % 3 == 1 ? middle.y : middle.z;
    pov_box low = *cell, high = *cell;

    if (is_boxed(s->out, cell) || !s->may_hold(s->shape, cell))
        return;
    if (left == 0) {
        add_box(s->out, cell);
        return;
    }
    *(left % 3 == 0 ? &low.hi.x : left % 3 == 1 ? &low.hi.y : &low.hi.z) = at;
    *(left % 3 == 0 ? &high.lo.x : left % 3 == 1 ? &high.lo.y : &high.lo.z) = at;
    find_cells(s, &low, left - 1);
    find_cells(s, &high, left - 1);
}

bool common_cell_box(const void *shape, const pov_box *whole, common_may_hold *may_hold, pov_box *out)
{
    const search s = { shape, may_hold, out };

    out->lo = whole->hi;
    out->hi = whole->lo;
    find_cells(&s, whole, HALVES);
    return out->lo.x <= out->hi.x;
}
