#include "render/tiles.h"

/* How many parts of `edge` a length has. */
static int parts(int length, int edge)
{
    return (length - 1) / edge + 1;
}

static size_t count_of(int width, int height, int edge)
{
    return (size_t)parts(width, edge) * (size_t)parts(height, edge);
}

static int edge_of(int width, int height, int threads, bool together)
{
    /* At the end all threads wait for the last tile: with this many tiles it is a small part of each thread's work. One waits for none. */
    const size_t many_for_one = !together ? 128 : threads > 1 ? 4 : 1;
    int edge = together ? TILE_EDGE_MAX : TILE_EDGE_MAX / 2;

    while (edge > TILE_EDGE_MIN && count_of(width, height, edge) / many_for_one < (size_t)threads)
        edge /= 2;
    return edge;
}

/* Distance of a tile from the centre in tiles: the maximum over both axes, doubled. Tiles of a ring share one
 * number. */
static int ring_of(const tiles *t, uint32_t index)
{
    int x = (int)(index % (uint32_t)t->columns), y = (int)(index / (uint32_t)t->columns);
    int from_x = 2 * x - (t->columns - 1), from_y = 2 * y - (t->rows - 1);

    from_x = from_x < 0 ? -from_x : from_x;
    from_y = from_y < 0 ? -from_y : from_y;
    return from_x > from_y ? from_x : from_y;
}

void tiles_make(tiles *t, int width, int height, int threads, bool together)
{
    t->width = width;
    t->height = height;
    t->edge = edge_of(width, height, threads, together);
    t->columns = parts(width, t->edge);
    t->rows = parts(height, t->edge);
    t->count = count_of(width, height, t->edge);
    t->order = NULL;
    t->own = 0;
}

/* Counting sort by rings; within a ring the tiles keep the order of the rows. */
bool tiles_sort(tiles *t, const env *e)
{
    size_t rings = (size_t)(t->columns > t->rows ? t->columns : t->rows) + 1;
    size_t *start = env_alloc(e, rings + 1, sizeof *start);

    if (t->count <= UINT32_MAX)
        t->order = env_resize(e, NULL, t->count, sizeof *t->order);
    if (!start || !t->order) {
        env_free(e, start);
        return false;
    }
    for (uint32_t i = 0; i < t->count; i++)
        start[ring_of(t, i) + 1]++;
    for (size_t r = 1; r <= rings; r++)
        start[r] += start[r - 1];
    for (uint32_t i = 0; i < t->count; i++)
        t->order[start[ring_of(t, i)]++] = i;
    env_free(e, start);
    t->own = t->count;
    return true;
}

enum { BLOCK = 16 };             /* tiles that a block is wide and high */

/* Every other bit of a number below BLOCK squared. */
static int half_of_bits(unsigned code)
{
    return (int)((code & 1u) | (code >> 1 & 2u) | (code >> 2 & 4u) | (code >> 3 & 8u));
}

/* Parts take turns along a curve of squares within squares, so that each has some of every region. */
static size_t deal_block(tiles *t, int left, int top, size_t turn, int part, int parts)
{
    for (unsigned code = 0; code < BLOCK * BLOCK; code++) {
        const int x = left + half_of_bits(code), y = top + half_of_bits(code >> 1);

        if (x < t->columns && y < t->rows && turn++ % (size_t)parts == (size_t)(part - 1))
            t->order[t->own++] = (uint32_t)y * (uint32_t)t->columns + (uint32_t)x;
    }
    return turn;
}

void tiles_deal(tiles *t, int part, int parts)
{
    size_t turn = 0;

    t->own = 0;
    for (int top = 0; top < t->rows; top += BLOCK)
        for (int left = 0; left < t->columns; left += BLOCK)
            turn = deal_block(t, left, top, turn, part, parts);
}

void tiles_free(tiles *t, const env *e)
{
    env_free(e, t->order);
    t->order = NULL;
}

pov_rect tiles_rect(const tiles *t, size_t index)
{
    pov_rect r;

    r.x = (int)(index % (size_t)t->columns) * t->edge;
    r.y = (int)(index / (size_t)t->columns) * t->edge;
    r.width = t->width - r.x < t->edge ? t->width - r.x : t->edge;
    r.height = t->height - r.y < t->edge ? t->height - r.y : t->edge;
    return r;
}

size_t lattice_pixels(lattice l, int width, int height)
{
    size_t all = count_of(width, height, l.step);

    return l.finer ? all - count_of(width, height, 2 * l.step) : all;
}
