#include "render/meter.h"

#include "base/clock.h"

#include <string.h>

void meter_begin(meter *m)
{
    if (!m)
        return;
    memset(m->spent, 0, sizeof m->spent);
    m->since = clock_thread_seconds();
}

static double seconds_since(meter *m)
{
    double now = clock_thread_seconds(), seconds = now - m->since;

    m->since = now;
    return seconds;
}

static double *cell_at(meter *m, pov_rect tile, int x, int y)
{
    return &m->spent[y / CELL_EDGE * cells_of(tile).columns + x / CELL_EDGE];
}

void meter_cells(meter *m, const int *of, uint32_t count)
{
    double each;

    if (!m)
        return;
    each = seconds_since(m) / count;
    for (uint32_t i = 0; i < count; i++)
        m->spent[of[i]] += each;
}

void meter_block(meter *m, pov_rect tile, lattice l, int left, int top, int width, int height)
{
    int right = left + width < tile.width ? left + width : tile.width, count = 0;
    int bottom = top + height < tile.height ? top + height : tile.height;
    double each;

    if (!m)
        return;
    for (int y = top; y < bottom; y += l.step)
        for (int x = left; x < right; x += l.step)
            count += lattice_has(l, x, y);
    if (count == 0)
        return;
    each = seconds_since(m) / count;
    for (int y = top; y < bottom; y += l.step)
        for (int x = left; x < right; x += l.step)
            if (lattice_has(l, x, y))
                *cell_at(m, tile, x, y) += each;
}
