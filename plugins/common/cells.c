#include "common/cells.h"

/* Cells are tested with so much more around them, far more than places on rays are rounded by. */
#define WIDER (1.0 + 0x1p-10)

enum { N = COMMON_CELLS, PER_BOX = 4, BOXES = POV_FORMS / PER_BOX };

/* ---- making ---- */

typedef struct making {
    const common_cells *c;
    const pov_function_bounds *f;
    double threshold;
    bool (*is_outside)(const void *user, pov_vec3 middle, pov_vec3 half);
    const void *user;
    pov_form *memory;
    uint8_t *kind;
} making;

/* A cube of cells, `size` of them along each axis. */
typedef struct cube { int x, y, z, size; } cube;

static pov_vec3 half_of(const making *m, cube at) { return pov_scale(m->c->size, 0.5 * WIDER * at.size); }

static pov_vec3 middle_of(const making *m, cube at)
{
    const pov_vec3 s = m->c->size, lo = m->c->lo;
    const double half = 0.5 * at.size;

    return pov_vec3_of(lo.x + (at.x + half) * s.x, lo.y + (at.y + half) * s.y, lo.z + (at.z + half) * s.z);
}

/* One coordinate in the four lanes of a box: along u in the lane of its axis, anywhere in the two others, its middle in the
 * last. */
static void put_axis(pov_form *to, int lane, int axis, double middle, double half)
{
    for (int k = 0; k < PER_BOX; k++) {
        to->middle[lane + k] = middle;
        to->slope[lane + k] = k == axis ? half : 0.0;
        to->off[lane + k] = (k == axis || k == PER_BOX - 1 ? 0.0 : half) + 0x1p-50 * (fabs(middle) + half);
        to->slope_off[lane + k] = k == axis ? 0x1p-50 * half : 0.0;
    }
}

/* By the bounds of the values, and by the mean value theorem: the middle's value and the slopes along the axes. */
static common_cell judge(const pov_form *f, int lane, double threshold)
{
    const double at = f->middle[lane + 3] - threshold;
    double mean = f->off[lane + 3] + fabs(f->slope[lane + 3]), most = 0x1p-48 * fabs(at);

    for (int k = 0; k < 3; k++) {
        const double middle = f->middle[lane + k] - threshold;
        const double reach = (fabs(f->slope[lane + k]) + f->off[lane + k]) * (1.0 + 0x1p-48) + 0x1p-48 * fabs(middle);

        if (middle - reach >= 0.0)
            return COMMON_CELL_ABOVE;
        if (middle + reach < 0.0)
            return COMMON_CELL_BELOW;
        mean += fabs(f->slope[lane + k]) + f->slope_off[lane + k];
    }
    most += mean * (1.0 + 0x1p-48);
    return at - most >= 0.0 ? COMMON_CELL_ABOVE : at + most < 0.0 ? COMMON_CELL_BELOW : COMMON_CELL_OPEN;
}

static void classify(const making *m, const cube *of, common_cell *out)
{
    pov_form f;

    for (int i = 0; i < BOXES; i++) {
        const pov_vec3 middle = middle_of(m, of[i]), half = half_of(m, of[i]);

        put_axis(&m->memory[0], PER_BOX * i, 0, middle.x, half.x);
        put_axis(&m->memory[1], PER_BOX * i, 1, middle.y, half.y);
        put_axis(&m->memory[2], PER_BOX * i, 2, middle.z, half.z);
    }
    f = *m->f->over(m->f, m->memory);
    for (int i = 0; i < BOXES; i++)
        out[i] = m->is_outside(m->user, middle_of(m, of[i]), half_of(m, of[i])) ? COMMON_CELL_ABOVE : judge(&f, PER_BOX * i, m->threshold);
}

static void fill(const making *m, cube of, common_cell kind)
{
    for (int z = of.z; z < of.z + of.size; z++)
        for (int y = of.y; y < of.y + of.size; y++)
            memset(&m->kind[of.x + N * (y + N * z)], (int)kind, (size_t)of.size);
}

/* Cubes that are open are cut into eight. */
static void split(const making *m, cube of)
{
    const int half = of.size / 2;

    for (int first = 0; first < 8; first += BOXES) {
        cube parts[BOXES];
        common_cell kind[BOXES];

        for (int i = 0; i < BOXES; i++) {
            const int k = first + i;
            const cube part = { of.x + (k & 1) * half, of.y + (k >> 1 & 1) * half, of.z + (k >> 2) * half, half };

            parts[i] = part;
        }
        classify(m, parts, kind);
        for (int i = 0; i < BOXES; i++) {
            if (kind[i] == COMMON_CELL_OPEN && half > 1)
                split(m, parts[i]);
            else
                fill(m, parts[i], kind[i]);
        }
    }
}

/* Rounded outward by the margin of a cell. */
static void find_box(common_cells *c)
{
    int lo[3] = { N, N, N }, hi[3] = { 0, 0, 0 };

    for (int i = 0; i < N * N * N; i++) {
        const int at[3] = { i % N, i / N % N, i / (N * N) };

        for (int k = 0; k < 3 && c->kind[i] != COMMON_CELL_ABOVE; k++) {
            lo[k] = at[k] < lo[k] ? at[k] : lo[k];
            hi[k] = at[k] + 1 > hi[k] ? at[k] + 1 : hi[k];
        }
    }
    c->from = pov_vec3_of(c->lo.x + (lo[0] - 0x1p-11) * c->size.x, c->lo.y + (lo[1] - 0x1p-11) * c->size.y, c->lo.z + (lo[2] - 0x1p-11) * c->size.z);
    c->to = pov_vec3_of(c->lo.x + (hi[0] + 0x1p-11) * c->size.x, c->lo.y + (hi[1] + 0x1p-11) * c->size.y, c->lo.z + (hi[2] + 0x1p-11) * c->size.z);
}

bool common_cells_make(common_cells *c, const pov_host *host, pov_reader *in, const pov_function_bounds *f, double threshold,
                       pov_box box, bool (*is_outside)(const void *user, pov_vec3 middle, pov_vec3 half), const void *user)
{
    const cube all = { 0, 0, 0, N };
    making m = { c, f, threshold, is_outside, user, NULL, NULL };

    c->lo = box.lo;
    c->size = pov_scale(pov_sub(box.hi, box.lo), 1.0 / N);
    c->per_size = pov_vec3_of(1.0 / c->size.x, 1.0 / c->size.y, 1.0 / c->size.z);
    c->kind = m.kind = host->alloc(in, (size_t)N * N * N);
    m.memory = host->resize(in, NULL, f->registers * sizeof *m.memory);
    if (m.kind && m.memory) {
        split(&m, all);
        find_box(c);
    }
    if (m.memory)
        host->resize(in, m.memory, 0);
    return m.kind && m.memory;
}

/* ---- asking ---- */

static int cell_along(double at, double lo, double per_size)
{
    const double place = (at - lo) * per_size;

    return place >= 0.0 ? place < N ? (int)place : N - 1 : 0;
}

common_cell common_cells_kind(const common_cells *c, pov_vec3 at)
{
    const int x = cell_along(at.x, c->lo.x, c->per_size.x), y = cell_along(at.y, c->lo.y, c->per_size.y), z = cell_along(at.z, c->lo.z, c->per_size.z);

    return (common_cell)c->kind[x + N * (y + N * z)];
}

/* A walk from cell to cell: what an axis adds to the cell's number, where it leaves its cell next, and how far cells are. */
typedef struct axis { int at, end, step; double next, size; } axis;

static axis axis_of(double o, double d, double start, double lo, double size, double per_size, int stride)
{
    axis a;

    a.at = cell_along(o + start * d, lo, per_size);
    a.end = d > 0.0 ? N : -1;
    a.step = d > 0.0 ? stride : -stride;
    a.next = d == 0.0 ? HUGE_VAL : (lo + (a.at + (d > 0.0)) * size - o) / d;
    a.size = d == 0.0 ? HUGE_VAL : size / fabs(d);
    return a;
}

/* The stretches that are collected until there are enough to ask for; the last one may still grow. */
typedef struct stretches { double lo[POV_FORMS], hi[POV_FORMS]; int count; bool grows; } stretches;

static bool ask(stretches *s, common_level *n)
{
    const int count = s->count;

    s->count = 0;
    return count == 0 || common_level_search(n, s->lo, s->hi, count);
}

/* Stretches shorter than `least` go on in the next cell: where a ray starts on the surface, no end must be as near as that. */
static bool collect(stretches *s, common_level *n, double lo, double hi, double least)
{
    if (!s->grows) {
        if (s->count == POV_FORMS && !ask(s, n))
            return false;
        s->lo[s->count++] = lo;
    }
    s->hi[s->count - 1] = hi;
    s->grows = hi - s->lo[s->count - 1] < least;
    return true;
}

bool common_cells_search(const common_cells *c, common_level *n, double lo, double hi)
{
    axis a[3] = { axis_of(n->o.x, n->d.x, lo, c->lo.x, c->size.x, c->per_size.x, 1),
                  axis_of(n->o.y, n->d.y, lo, c->lo.y, c->size.y, c->per_size.y, N),
                  axis_of(n->o.z, n->d.z, lo, c->lo.z, c->size.z, c->per_size.z, N * N) };
    const uint8_t *kind = &c->kind[a[0].at + N * (a[1].at + N * a[2].at)];
    const double least = 0x1p26 * n->shortest;
    common_cell side = n->start < 0.0 ? COMMON_CELL_BELOW : COMMON_CELL_ABOVE;
    stretches s = { .count = 0 };
    bool is_inside = true;
    double t = lo;

    while (t < hi && is_inside) {
        const int which = a[0].next < a[1].next ? (a[0].next < a[2].next ? 0 : 2) : a[1].next < a[2].next ? 1 : 2;
        axis *next = &a[which];
        double end = next->next < hi ? next->next : hi;

        next->at += next->step > 0 ? 1 : -1;
        is_inside = next->at != next->end;
        end = is_inside ? end : hi;      /* with what rounding left */
        /* Behind a crossing for certain: it need not be looked for farther on. */
        if (*kind != side && *kind != COMMON_CELL_OPEN && !s.grows) {
            side = (common_cell)*kind;
            if (!ask(&s, n))
                return false;
        }
        if (end > t && (*kind == COMMON_CELL_OPEN || s.grows) && !collect(&s, n, t, end, least))
            return false;
        t = end > t ? end : t;
        kind += is_inside ? next->step : 0;
        next->next += next->size;
    }
    return ask(&s, n);
}
