#include "photon/map.h"

#include <float.h>
#include <math.h>

/* ---- the tree ---- */

static const pov_box empty_box = { { HUGE_VAL, HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };

/* Of numbers that are no NaN. */
static inline double lesser(double a, double b) { return b < a ? b : a; }

static inline double greater(double a, double b) { return b > a ? b : a; }

static inline void reach(pov_box *b, pov_vec3 p, double r)
{
    b->lo = pov_vec3_of(lesser(b->lo.x, p.x - r), lesser(b->lo.y, p.y - r), lesser(b->lo.z, p.z - r));
    b->hi = pov_vec3_of(greater(b->hi.x, p.x + r), greater(b->hi.y, p.y + r), greater(b->hi.z, p.z + r));
}

static double along(pov_vec3 p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

static int longest_axis(const pov_box *b)
{
    const pov_vec3 size = pov_sub(b->hi, b->lo);

    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

static void swap(photon *a, photon *b)
{
    const photon t = *a;

    *a = *b;
    *b = t;
}

/* The k-th of n photons along an axis stands at its place, and none before it is larger: Hoare's FIND. */
static void select_kth(photon *p, size_t n, size_t k, int axis)
{
    size_t from = 0, to = n - 1;

    while (from < to) {
        const double pivot = along(p[from + (to - from) / 2].at, axis);
        size_t i = from, j = to;

        for (;; i++, j--) {
            while (along(p[i].at, axis) < pivot)
                i++;
            while (along(p[j].at, axis) > pivot)
                j--;
            if (i >= j)
                break;
            swap(&p[i], &p[j]);
        }
        if (k <= j)
            to = j;
        else
            from = j + 1;
    }
}

static uint32_t build(photon_map *m, uint32_t first, uint32_t count)
{
    const uint32_t index = m->node_count++, half = (count / PHOTON_LANES + 1) / 2 * PHOTON_LANES;
    photon_node *n = &m->nodes[index];

    n->box = empty_box;
    for (uint32_t i = first; i < first + count; i++)
        reach(&n->box, m->photons[i].at, 0.0);
    n->first = first;
    n->count = count <= PHOTON_LANES ? count : 0;
    if (n->count == 0) {
        select_kth(m->photons + first, count, half, longest_axis(&n->box));
        build(m, first, half);
        build(m, first + half, count - half);
    }
    n->skip = m->node_count;
    return index;
}

/* ---- discs ---- */

static photon_block *block_of(const photon_map *m, const photon_node *leaf) { return &m->blocks[leaf->first / PHOTON_LANES]; }

static void fill_block(photon_block *b, const photon *of, uint32_t count)
{
    const photon nowhere = { .at = { HUGE_VAL, HUGE_VAL, HUGE_VAL } };

    for (uint32_t i = 0; i < PHOTON_LANES; i++) {
        const photon *p = i < count ? &of[i] : &nowhere;

        b->at[0][i] = p->at.x;
        b->at[1][i] = p->at.y;
        b->at[2][i] = p->at.z;
        for (int k = 0; k < 3; k++)
            b->normal[k][i] = p->normal[k];
    }
}

static void fill_blocks(photon_map *m)
{
    for (uint32_t i = 0; i < m->node_count; i++)
        if (m->nodes[i].count > 0)
            fill_block(block_of(m, &m->nodes[i]), m->photons + m->nodes[i].first, m->nodes[i].count);
}

/* The squares of the distances of the nearest photons found so far: a heap with the largest on top. */
typedef struct nearest { uint32_t count, most; double *square; } nearest;

static void sift_down(nearest *h, double value)
{
    uint32_t i = 0;

    for (uint32_t child; (child = 2 * i + 1) < h->count; i = child) {
        if (child + 1 < h->count && h->square[child + 1] > h->square[child])
            child++;
        if (value >= h->square[child])
            break;
        h->square[i] = h->square[child];
    }
    h->square[i] = value;
}

static void sift_up(nearest *h, double value)
{
    uint32_t i = h->count++;

    for (; i > 0 && h->square[(i - 1) / 2] < value; i = (i - 1) / 2)
        h->square[i] = h->square[(i - 1) / 2];
    h->square[i] = value;
}

static inline double outside(double lo, double hi, double p) { return p < lo ? lo - p : p > hi ? p - hi : 0.0; }

static double distance_square(const pov_box *b, pov_vec3 p)
{
    const double x = outside(b->lo.x, b->hi.x, p.x), y = outside(b->lo.y, b->hi.y, p.y), z = outside(b->lo.z, b->hi.z, p.z);

    return x * x + y * y + z * z;
}

SIMD_CLONES static void find_squares(const photon_block *restrict b, pov_vec3 at, double *restrict square)
{
    for (int i = 0; i < PHOTON_LANES; i++) {
        const double x = b->at[0][i] - at.x, y = b->at[1][i] - at.y, z = b->at[2][i] - at.z;

        square[i] = x * x + y * y + z * z;
    }
}

static void take_leaf(const photon_map *m, const photon_node *n, pov_vec3 at, nearest *h)
{
    double square[PHOTON_LANES];

    find_squares(block_of(m, n), at, square);
    for (uint32_t i = 0; i < n->count; i++)
        if (h->count < h->most)
            sift_up(h, square[i]);
        else if (square[i] < h->square[0])
            sift_down(h, square[i]);
}

/* The nearer child is looked into first. */
static void find_nearest(const photon_map *m, uint32_t node, pov_vec3 at, nearest *h)
{
    const photon_node *n = &m->nodes[node];
    uint32_t near = node + 1, far;
    double to_near, to_far;

    if (n->count > 0) {
        take_leaf(m, n, at, h);
        return;
    }
    far = m->nodes[near].skip;
    to_near = distance_square(&m->nodes[near].box, at);
    to_far = distance_square(&m->nodes[far].box, at);
    if (to_far < to_near) {
        const double square = to_near;

        near = far;
        far = node + 1;
        to_near = to_far;
        to_far = square;
    }
    if (h->count < h->most || to_near < h->square[0])
        find_nearest(m, near, at, h);
    if (h->count < h->most || to_far < h->square[0])
        find_nearest(m, far, at, h);
}

/* The radius of a leaf's discs; photons that all lie at one point have one all the same. */
static double radius_of(const photon_map *m, const photon_node *n, nearest *h)
{
    pov_vec3 middle = pov_vec3_of(0, 0, 0);
    double radius;

    for (uint32_t i = n->first; i < n->first + n->count; i++)
        middle = pov_add(middle, pov_scale(m->photons[i].at, 1.0 / n->count));
    h->count = 0;
    find_nearest(m, 0, middle, h);
    radius = sqrt(h->square[0]);
    return pov_max(radius, pov_max(pov_largest(middle) * 0x1p-40, FLT_MIN));
}

/* From the last to the first: children stand behind their parents. */
static void widen(photon_map *m)
{
    for (uint32_t i = m->node_count; i-- > 0;) {
        photon_node *n = &m->nodes[i];

        n->box = empty_box;
        for (uint32_t k = n->first; k < n->first + n->count; k++)
            reach(&n->box, m->photons[k].at, block_of(m, n)->radius);
        for (uint32_t child = i + 1; n->count == 0 && child < n->skip; child = m->nodes[child].skip) {
            reach(&n->box, m->nodes[child].box.lo, 0.0);
            reach(&n->box, m->nodes[child].box.hi, 0.0);
        }
    }
}

static void set_radii(photon_map *m, nearest *h)
{
    for (uint32_t i = 0; i < m->node_count; i++)
        if (m->nodes[i].count > 0)
            block_of(m, &m->nodes[i])->radius = (double)(float)radius_of(m, &m->nodes[i], h);
}

bool photon_map_make(photon_map *out, const env *e, photon *photons, uint32_t count, uint32_t most, photon_kernel kernel)
{
    const photon_map none = { photons, count, 0, kernel, NULL, NULL };
    nearest h = { 0, most < count ? most : count, NULL };

    *out = none;
    if (count == 0)
        return true;
    out->nodes = env_alloc(e, 2 * ((size_t)count / PHOTON_LANES + 1), sizeof *out->nodes);
    out->blocks = env_alloc_aligned(e, ((size_t)count / PHOTON_LANES + 1) * sizeof *out->blocks, SIMD_LINE);
    h.square = env_alloc(e, h.most, sizeof *h.square);
    if (out->nodes && out->blocks && h.square) {
        build(out, 0, count);
        fill_blocks(out);
        set_radii(out, &h);
        widen(out);
    }
    env_free(e, h.square);
    if (out->node_count > 0)
        return true;
    photon_map_free(out, e);
    return false;
}

void photon_map_free(photon_map *m, const env *e)
{
    const photon_map none = { NULL, 0, 0, PHOTON_SMOOTH, NULL, NULL };

    env_free_aligned(e, m->blocks);
    env_free(e, m->photons);
    env_free(e, m->nodes);
    *m = none;
}

/* ---- queries ---- */

/* Does the box, wider by `more` on all sides, hold the point? */
static inline bool holds(const pov_box *b, pov_vec3 p, double more)
{
    return (p.x >= b->lo.x - more) & (p.x <= b->hi.x + more) & (p.y >= b->lo.y - more) & (p.y <= b->hi.y + more) &
           (p.z >= b->lo.z - more) & (p.z <= b->hi.z + more);
}

/* Photons on a surface that is turned further away, or lies further above or below it, belong to another one. */
static const double least_alike = 0.5, most_above = 0.5;
static const double three_by_pi = 0.95492965855137201461;

/* The kernel's last factor is base + slope (1 - u). */
typedef struct factor { double base, slope; } factor;

static inline factor factor_of(const photon_map *m)
{
    static const factor by_kernel[] = { [PHOTON_SMOOTH] = { 1.0, 0.0 }, [PHOTON_SHARP] = { -4.0, 20.0 / 3.0 } };

    return by_kernel[m->kernel];
}

/* By lane: what a photon counts for at a point, if it counts there. Returns bit i for lane i that does. */
SIMD_CLONES static uint32_t try_photons(const photon_block *restrict b, pov_vec3 at, pov_vec3 normal, double least, factor by,
                                        double *restrict density)
{
    const double radius = greater(b->radius, least), square = radius * radius, most = three_by_pi / square, height = most_above * radius;
    uint32_t held = 0;

    for (int i = 0; i < PHOTON_LANES; i++) {
        const double x = b->at[0][i] - at.x, y = b->at[1][i] - at.y, z = b->at[2][i] - at.z;
        const double near = 1.0 - (x * x + y * y + z * z) / square, above = x * normal.x + y * normal.y + z * normal.z;
        const double alike = normal.x * (double)b->normal[0][i] + normal.y * (double)b->normal[1][i] + normal.z * (double)b->normal[2][i];

        density[i] = ((near > 0.0) & (fabs(alike) > least_alike) & (fabs(above) < height)) ? most * near * near * (by.base + by.slope * near) : 0.0;
    }
    for (int i = 0; i < PHOTON_LANES; i++)
        held |= (uint32_t)(density[i] != 0.0) << i;
    return held;
}

void photon_map_find(const photon_map *m, pov_vec3 at, pov_vec3 normal, double least, photon_visit *visit, void *user)
{
    const factor by = factor_of(m);
    double density[PHOTON_LANES];

    for (uint32_t i = 0, held; i < m->node_count;) {
        const photon_node *n = &m->nodes[i];

        if (!holds(&n->box, at, least)) {
            i = n->skip;
            continue;
        }
        for (held = n->count > 0 ? try_photons(block_of(m, n), at, normal, least, by, density) : 0; held; held &= held - 1)
            visit(user, &m->photons[n->first + first_of(held)], (float)density[first_of(held)]);
        i++;
    }
}

/* ---- cells ---- */

/* The same for photons that are seen in a cell. */
SIMD_CLONES static uint32_t count_photons(const photon_block *restrict b, pov_vec3 at, pov_vec3 normal, const photon_cell *restrict cell,
                                          double *restrict density)
{
    const photon_screen s = *cell->screen;
    const double x0 = cell->lo[0], x1 = cell->hi[0], y0 = cell->lo[1], y1 = cell->hi[1];
    const double least = cell->spacing * cell->spacing, per_area = 1.0 / ((x1 - x0) * (y1 - y0));
    const double highest = most_above * most_above;
    uint32_t held = 0;

    for (int i = 0; i < PHOTON_LANES; i++) {
        const double x = b->at[0][i] - at.x, y = b->at[1][i] - at.y, z = b->at[2][i] - at.z;
        const double nx = (double)b->normal[0][i], ny = (double)b->normal[1][i], nz = (double)b->normal[2][i];
        const double above = x * normal.x + y * normal.y + z * normal.z, alike = normal.x * nx + normal.y * ny + normal.z * nz;
        const double square = x * x + y * y + z * z, wide = greater(square, least);
        const double dx = b->at[0][i] - s.from.x, dy = b->at[1][i] - s.from.y, dz = b->at[2][i] - s.from.z;
        const double depth = s.row[2].x * dx + s.row[2].y * dy + s.row[2].z * dz + s.one, by = 1.0 / depth;
        const double u = (s.row[0].x * dx + s.row[0].y * dy + s.row[0].z * dz) * by;
        const double v = (s.row[1].x * dx + s.row[1].y * dy + s.row[1].z * dz) * by;
        const double kx = s.across[2].x + u * s.across[0].x + v * s.across[1].x;
        const double ky = s.across[2].y + u * s.across[0].y + v * s.across[1].y;
        const double kz = s.across[2].z + u * s.across[0].z + v * s.across[1].z;
        const double area = fabs(nx * kx + ny * ky + nz * kz) * by * by;

        density[i] = ((depth > 0.0) & (u >= x0) & (u < x1) & (v >= y0) & (v < y1) & (fabs(alike) > least_alike) &
                      (above * above < highest * wide)) ? area * per_area : 0.0;
    }
    for (int i = 0; i < PHOTON_LANES; i++)
        held |= (uint32_t)(density[i] != 0.0) << i;
    return held;
}

void photon_map_count(const photon_map *m, pov_vec3 at, pov_vec3 normal, const photon_cell *cell, photon_visit *visit, void *user)
{
    const factor by = factor_of(m);
    double density[PHOTON_LANES];

    for (uint32_t i = 0, held = 0; i < m->node_count;) {
        const photon_node *n = &m->nodes[i];

        if (!holds(&n->box, at, cell->reach)) {
            i = n->skip;
            continue;
        }
        if (n->count > 0 && block_of(m, n)->radius < cell->spacing)
            held = count_photons(block_of(m, n), at, normal, cell, density);
        else if (n->count > 0)
            held = try_photons(block_of(m, n), at, normal, 0.0, by, density);
        for (; held; held &= held - 1)
            visit(user, &m->photons[n->first + first_of(held)], (float)density[first_of(held)]);
        i++;
    }
}

/* ---- rays ---- */

/* Do the box, wider by `more` on all sides, and the ray's first `length` meet? */
static bool meets(const pov_box *b, pov_vec3 from, pov_vec3 per, double length, double more)
{
    const double x0 = (b->lo.x - more - from.x) * per.x, x1 = (b->hi.x + more - from.x) * per.x;
    const double y0 = (b->lo.y - more - from.y) * per.y, y1 = (b->hi.y + more - from.y) * per.y;
    const double z0 = (b->lo.z - more - from.z) * per.z, z1 = (b->hi.z + more - from.z) * per.z;
    const double enters = greater(greater(lesser(x0, x1), lesser(y0, y1)), greater(lesser(z0, z1), 0.0));

    return enters <= lesser(lesser(greater(x0, x1), greater(y0, y1)), lesser(greater(z0, z1), length));
}

/* One over a component: a ray that is as good as parallel is wide of no box that it is in. */
static double inverse(double d) { return 1.0 / (fabs(d) > 0x1p-60 ? d : copysign(0x1p-60, d)); }

/* The same of those that the ray passes, and where it does. */
SIMD_CLONES static uint32_t pass_photons(const photon_block *restrict b, const photon_ray *restrict ray, factor by,
                                         double *restrict where, double *restrict density)
{
    const pov_vec3 from = ray->from, dir = ray->dir;
    const double length = ray->length, least = ray->least, slope = ray->slope, own = b->radius;
    uint32_t held = 0;

    for (int i = 0; i < PHOTON_LANES; i++) {
        const double x = b->at[0][i] - from.x, y = b->at[1][i] - from.y, z = b->at[2][i] - from.z;
        const double at = x * dir.x + y * dir.y + z * dir.z, u = x - dir.x * at, v = y - dir.y * at, w = z - dir.z * at;
        const double wide = least + slope * at, radius = wide > own ? wide : own, square = radius * radius;
        const double near = 1.0 - (u * u + v * v + w * w) / square;

        where[i] = at;
        density[i] = ((near > 0.0) & (at >= 0.0) & (at <= length)) ? three_by_pi / square * near * near * (by.base + by.slope * near) : 0.0;
    }
    for (int i = 0; i < PHOTON_LANES; i++)
        held |= (uint32_t)(density[i] != 0.0) << i;
    return held;
}

/* The same for photons that are seen in the ray's cell, and have narrow discs there. */
SIMD_CLONES static uint32_t pass_counted(const photon_block *restrict b, const photon_ray *restrict ray, factor by,
                                         double *restrict where, double *restrict density)
{
    const photon_cell cell = *ray->cell;
    const photon_screen s = *cell.screen;
    const pov_vec3 from = ray->from, dir = ray->dir;
    const double length = ray->length, own = b->radius, per_own = three_by_pi / (own * own);
    const double per_area = 1.0 / ((cell.hi[0] - cell.lo[0]) * (cell.hi[1] - cell.lo[1]));
    uint32_t held = 0;

    for (int i = 0; i < PHOTON_LANES; i++) {
        const double x = b->at[0][i] - from.x, y = b->at[1][i] - from.y, z = b->at[2][i] - from.z;
        const double at = x * dir.x + y * dir.y + z * dir.z, u = x - dir.x * at, v = y - dir.y * at, w = z - dir.z * at;
        const double near = 1.0 - (u * u + v * v + w * w) / (own * own);
        const double disc = near > 0.0 ? per_own * near * near * (by.base + by.slope * near) : 0.0;
        const pov_vec3 d = { b->at[0][i] - s.from.x, b->at[1][i] - s.from.y, b->at[2][i] - s.from.z };
        const double depth = pov_dot(s.row[2], d) + s.one, p = pov_dot(s.row[0], d) / depth, q = pov_dot(s.row[1], d) / depth;
        const pov_vec3 k = { s.across[2].x + p * s.across[0].x + q * s.across[1].x, s.across[2].y + p * s.across[0].y + q * s.across[1].y,
                             s.across[2].z + p * s.across[0].z + q * s.across[1].z };
        const double area = sqrt(pov_dot(k, k)) / (depth * depth) * per_area;
        const bool inside = (depth > 0.0) & (p >= cell.lo[0]) & (p < cell.hi[0]) & (q >= cell.lo[1]) & (q < cell.hi[1]);
        const double counted = inside ? area : 0.0;

        where[i] = at;
        density[i] = ((at >= 0.0) & (at <= length)) ? (own < cell.spacing + cell.slope * at ? counted : disc) : 0.0;
    }
    for (int i = 0; i < PHOTON_LANES; i++)
        held |= (uint32_t)(density[i] != 0.0) << i;
    return held;
}

/* No disc of the node that the ray passes is wider than this where its own is smaller; nor does the cell reach further. */
static double widest(const photon_node *n, const photon_ray *ray)
{
    const double least = ray->cell ? ray->cell->reach : ray->least, slope = ray->cell ? ray->cell->widening : ray->slope;
    const pov_vec3 middle = pov_scale(pov_add(n->box.lo, n->box.hi), 0.5), half = pov_scale(pov_sub(n->box.hi, n->box.lo), 0.5);
    const double reach = fabs(ray->dir.x) * half.x + fabs(ray->dir.y) * half.y + fabs(ray->dir.z) * half.z;

    return least + slope * lesser(ray->length, greater(pov_dot(pov_sub(middle, ray->from), ray->dir) + reach, 0.0));
}

void photon_map_follow(const photon_map *m, const photon_ray *ray, photon_pass *pass, void *user)
{
    const pov_vec3 per = pov_vec3_of(inverse(ray->dir.x), inverse(ray->dir.y), inverse(ray->dir.z));
    const factor by = factor_of(m);
    double where[PHOTON_LANES], density[PHOTON_LANES];

    for (uint32_t i = 0, held; i < m->node_count;) {
        const photon_node *n = &m->nodes[i];

        if (!meets(&n->box, ray->from, per, ray->length, widest(n, ray))) {
            i = n->skip;
            continue;
        }
        held = n->count == 0 ? 0 : ray->cell ? pass_counted(block_of(m, n), ray, by, where, density) : pass_photons(block_of(m, n), ray, by, where, density);
        for (; held; held &= held - 1) {
            const uint32_t k = first_of(held);

            pass(user, &m->photons[n->first + k], where[k], (float)density[k]);
        }
        i++;
    }
}
