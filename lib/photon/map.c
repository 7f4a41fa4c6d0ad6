#include "photon/map.h"

#include <float.h>
#include <math.h>

enum { LEAF_PHOTONS = 8 };

/* ---- the tree ---- */

static const pov_box empty_box = { { HUGE_VAL, HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };

static void reach(pov_box *b, pov_vec3 p, double r)
{
    b->lo = pov_vec3_of(fmin(b->lo.x, p.x - r), fmin(b->lo.y, p.y - r), fmin(b->lo.z, p.z - r));
    b->hi = pov_vec3_of(fmax(b->hi.x, p.x + r), fmax(b->hi.y, p.y + r), fmax(b->hi.z, p.z + r));
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
    const uint32_t index = m->node_count++, half = (count / LEAF_PHOTONS + 1) / 2 * LEAF_PHOTONS;
    photon_node *n = &m->nodes[index];

    n->box = empty_box;
    for (uint32_t i = first; i < first + count; i++)
        reach(&n->box, m->photons[i].at, 0.0);
    n->first = first;
    n->count = count <= LEAF_PHOTONS ? count : 0;
    if (n->count == 0) {
        select_kth(m->photons + first, count, half, longest_axis(&n->box));
        build(m, first, half);
        build(m, first + half, count - half);
    }
    n->skip = m->node_count;
    return index;
}

/* ---- discs ---- */

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

static void take_leaf(const photon_map *m, const photon_node *n, pov_vec3 at, nearest *h)
{
    for (uint32_t i = n->first; i < n->first + n->count; i++) {
        const pov_vec3 to = pov_sub(m->photons[i].at, at);
        const double square = pov_dot(to, to);

        if (h->count < h->most)
            sift_up(h, square);
        else if (square < h->square[0])
            sift_down(h, square);
    }
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
    return fmax(radius, fmax(pov_largest(middle) * 0x1p-40, FLT_MIN));
}

/* From the last to the first: children stand behind their parents. */
static void widen(photon_map *m)
{
    for (uint32_t i = m->node_count; i-- > 0;) {
        photon_node *n = &m->nodes[i];

        n->box = empty_box;
        for (uint32_t k = n->first; k < n->first + n->count; k++)
            reach(&n->box, m->photons[k].at, (double)m->photons[k].radius);
        for (uint32_t child = i + 1; n->count == 0 && child < n->skip; child = m->nodes[child].skip) {
            reach(&n->box, m->nodes[child].box.lo, 0.0);
            reach(&n->box, m->nodes[child].box.hi, 0.0);
        }
    }
}

static void set_radii(photon_map *m, nearest *h)
{
    for (uint32_t i = 0; i < m->node_count; i++) {
        const photon_node *n = &m->nodes[i];
        const double radius = n->count > 0 ? radius_of(m, n, h) : 0.0;

        for (uint32_t k = n->first; k < n->first + n->count; k++)
            m->photons[k].radius = (float)radius;
    }
}

bool photon_map_make(photon_map *out, const env *e, photon *photons, uint32_t count, uint32_t most)
{
    const photon_map none = { photons, count, 0, NULL };
    nearest h = { 0, most < count ? most : count, NULL };

    *out = none;
    if (count == 0)
        return true;
    out->nodes = env_alloc(e, 2 * ((size_t)count / LEAF_PHOTONS + 1), sizeof *out->nodes);
    h.square = env_alloc(e, h.most, sizeof *h.square);
    if (out->nodes && h.square) {
        build(out, 0, count);
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
    const photon_map none = { NULL, 0, 0, NULL };

    env_free(e, m->photons);
    env_free(e, m->nodes);
    *m = none;
}

/* ---- queries ---- */

static inline bool holds(const pov_box *b, pov_vec3 p)
{
    return (p.x >= b->lo.x) & (p.x <= b->hi.x) & (p.y >= b->lo.y) & (p.y <= b->hi.y) & (p.z >= b->lo.z) & (p.z <= b->hi.z);
}

/* Photons on a surface that is turned further away, or lies further above or below it, belong to another one. */
static const double least_alike = 0.5, most_above = 0.5;
static const double three_by_pi = 0.95492965855137201461;

static inline void try_photon(const photon *p, pov_vec3 at, pov_vec3 normal, photon_visit *visit, void *user)
{
    const pov_vec3 to = pov_sub(p->at, at);
    const double square = (double)p->radius * (double)p->radius, near = 1.0 - pov_dot(to, to) / square;
    const double alike = normal.x * (double)p->normal[0] + normal.y * (double)p->normal[1] + normal.z * (double)p->normal[2];

    if (near > 0.0 && fabs(alike) > least_alike && fabs(pov_dot(to, normal)) < most_above * (double)p->radius)
        visit(user, p, (float)(three_by_pi / square * near * near));
}

void photon_map_find(const photon_map *m, pov_vec3 at, pov_vec3 normal, photon_visit *visit, void *user)
{
    for (uint32_t i = 0; i < m->node_count;) {
        const photon_node *n = &m->nodes[i];

        if (!holds(&n->box, at)) {
            i = n->skip;
            continue;
        }
        for (uint32_t k = n->first; k < n->first + n->count; k++)
            try_photon(&m->photons[k], at, normal, visit, user);
        i++;
    }
}

/* ---- rays ---- */

/* Do the box and the ray's first `length` meet? */
static bool meets(const pov_box *b, pov_vec3 from, pov_vec3 per, double length)
{
    const double x0 = (b->lo.x - from.x) * per.x, x1 = (b->hi.x - from.x) * per.x;
    const double y0 = (b->lo.y - from.y) * per.y, y1 = (b->hi.y - from.y) * per.y;
    const double z0 = (b->lo.z - from.z) * per.z, z1 = (b->hi.z - from.z) * per.z;
    const double enters = fmax(fmax(fmin(x0, x1), fmin(y0, y1)), fmax(fmin(z0, z1), 0.0));

    return enters <= fmin(fmin(fmax(x0, x1), fmax(y0, y1)), fmin(fmax(z0, z1), length));
}

/* One over a component: a ray that is as good as parallel is wide of no box that it is in. */
static double inverse(double d) { return 1.0 / (fabs(d) > 0x1p-60 ? d : copysign(0x1p-60, d)); }

static inline void pass_photon(const photon *p, pov_vec3 from, pov_vec3 dir, double length, photon_pass *pass, void *user)
{
    const pov_vec3 to = pov_sub(p->at, from);
    const double at = pov_dot(to, dir), square = (double)p->radius * (double)p->radius;
    const pov_vec3 off = pov_sub(to, pov_scale(dir, at));
    const double near = 1.0 - pov_dot(off, off) / square;

    if (near > 0.0 && at >= 0.0 && at <= length)
        pass(user, p, at, (float)(three_by_pi / square * near * near));
}

void photon_map_follow(const photon_map *m, pov_vec3 from, pov_vec3 dir, double length, photon_pass *pass, void *user)
{
    const pov_vec3 per = pov_vec3_of(inverse(dir.x), inverse(dir.y), inverse(dir.z));

    for (uint32_t i = 0; i < m->node_count;) {
        const photon_node *n = &m->nodes[i];

        if (!meets(&n->box, from, per, length)) {
            i = n->skip;
            continue;
        }
        for (uint32_t k = n->first; k < n->first + n->count; k++)
            pass_photon(&m->photons[k], from, dir, length, pass, user);
        i++;
    }
}
