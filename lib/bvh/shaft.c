#include "bvh/shaft.h"

#include "base/simd.h"
#include "base/vec3.h"

/* Far more than the errors of roundings here, relative to the sizes of what is rounded. */
static const double slack = 0x1p-40;

static inline double lesser(double a, double b) { return a < b ? a : b; }
static inline double greater(double a, double b) { return a > b ? a : b; }

/* A flank whose direction outward is in doubt tells nothing. */
static void make_flank(shaft *s, int i, pov_vec3 middle)
{
    const pov_vec3 a = s->corner[i], b = s->corner[(i + 1) & 3], normal = pov_cross_product(a, b);
    const double error = slack * (vec3_sum(a) + s->size) * (vec3_sum(b) + s->size), inside = pov_dot(normal, middle);

    s->normal[i] = inside > 0.0 ? pov_scale(normal, -1.0) : normal;
    s->error[i] = fabs(inside) > error * (vec3_sum(middle) + s->size) ? error : HUGE_VAL;
}

static void make_box(shaft *s)
{
    pov_vec3 lo = s->from, hi = s->from;

    for (int i = 0; i < 4; i++) {
        const pov_vec3 p = pov_add(s->from, s->corner[i]);

        lo = pov_vec3_of(lesser(lo.x, p.x), lesser(lo.y, p.y), lesser(lo.z, p.z));
        hi = pov_vec3_of(greater(hi.x, p.x), greater(hi.y, p.y), greater(hi.z, p.z));
    }
    s->lo = lo;
    s->hi = hi;
}

/* size: of coordinates that were rounded before. */
static bool make(shaft *s, pov_vec3 from, const pov_vec3 corner[4], double size)
{
    const pov_vec3 middle = pov_add(pov_add(corner[0], corner[1]), pov_add(corner[2], corner[3]));
    double longest = 0.0;

    s->from = from;
    for (int i = 0; i < 4; i++) {
        s->corner[i] = corner[i];
        longest = greater(longest, vec3_sum(corner[i]));
    }
    s->size = vec3_sum(from) + longest + size;
    if (!(s->size < 1e60))
        return false;
    make_box(s);
    for (int i = 0; i < 4; i++)
        make_flank(s, i, middle);
    return true;
}

bool shaft_make(shaft *s, pov_vec3 from, const pov_vec3 corner[4]) { return make(s, from, corner, 0.0); }

static pov_vec3 rotated(const pov_vec3 column[3], pov_vec3 v)
{
    return pov_add(pov_add(pov_scale(column[0], v.x), pov_scale(column[1], v.y)), pov_scale(column[2], v.z));
}

bool shaft_move(const shaft *s, const pov_vec3 column[3], pov_vec3 anchor, pov_vec3 to, shaft *out)
{
    const double largest = vec3_sum(column[0]) + vec3_sum(column[1]) + vec3_sum(column[2]);
    pov_vec3 corner[4];

    for (int i = 0; i < 4; i++)
        corner[i] = rotated(column, s->corner[i]);
    return make(out, pov_add(rotated(column, pov_sub(s->from, anchor)), to), corner, largest * (s->size + vec3_sum(anchor)) + vec3_sum(to));
}

/* A shaft in a frame. */
typedef struct local { double from[3], lo[3], hi[3], normal[4][3], error[4]; } local;

/* Boxes of a frame lie in the cube -1..1: no point of them is farther from `from` than this and its size. */
enum { CUBE = 3 };

static inline void put(double out[3], pov_vec3 v)
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static void enter(const shaft *s, const bvh_frame *frame, local *l)
{
    const double size = (s->size + vec3_sum(frame->centre)) * frame->scale, more = slack * size;
    const pov_vec3 around = pov_vec3_of(more, more, more);

    put(l->from, pov_scale(pov_sub(s->from, frame->centre), frame->scale));
    put(l->lo, pov_sub(pov_scale(pov_sub(s->lo, frame->centre), frame->scale), around));
    put(l->hi, pov_add(pov_scale(pov_sub(s->hi, frame->centre), frame->scale), around));
    for (int i = 0; i < 4; i++) {
        put(l->normal[i], s->normal[i]);
        l->error[i] = s->error[i] * (CUBE + size);
    }
}

/* The boxes of a node that the shaft may overlap. Unused ones are beyond it. */
SIMD_CLONES static uint32_t overlapping(const bvh_node *node, const local *l)
{
    int out[BVH_WIDTH] = { 0 };
    uint32_t found = 0;

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < BVH_WIDTH; i++)
            out[i] |= ((double)node->bounds[2 * k][i] > l->hi[k]) | ((double)node->bounds[2 * k + 1][i] < l->lo[k]);
    for (int flank = 0; flank < 4; flank++) {
        const double *n = l->normal[flank], error = l->error[flank];
        const float *x = node->bounds[n[0] < 0.0], *y = node->bounds[2 + (n[1] < 0.0)], *z = node->bounds[4 + (n[2] < 0.0)];

        for (int i = 0; i < BVH_WIDTH; i++)
            out[i] |= n[0] * ((double)x[i] - l->from[0]) + n[1] * ((double)y[i] - l->from[1]) +
                      n[2] * ((double)z[i] - l->from[2]) > error;
    }
    for (int i = 0; i < BVH_WIDTH; i++)
        found |= (uint32_t)!out[i] << i;
    return found;
}

/* A box of a node in the world, rounded: it is off by a few units in the last place of its coordinates. */
static pov_box box_of(const bvh_node *node, uint32_t i, const bvh_frame *frame)
{
    const float(*b)[BVH_WIDTH] = node->bounds;
    const pov_vec3 lo = pov_vec3_of((double)b[0][i], (double)b[2][i], (double)b[4][i]);
    const pov_vec3 hi = pov_vec3_of((double)b[1][i], (double)b[3][i], (double)b[5][i]);
    const double by = 1.0 / frame->scale;
    const pov_box box = { pov_add(pov_scale(lo, by), frame->centre), pov_add(pov_scale(hi, by), frame->centre) };

    return box;
}

/* All of a frame. */
static pov_box cube_of(const bvh_frame *frame)
{
    const double half = 1.0 / frame->scale;
    const pov_vec3 around = pov_vec3_of(half, half, half);
    const pov_box box = { pov_sub(frame->centre, around), pov_add(frame->centre, around) };

    return box;
}

typedef struct search { const bvh *tree; const shaft *of; shaft_leaf_fn *leaf; void *user; } search;

static bool search_frame(const search *s, uint32_t frame);

/* What is no node: a leaf, or a frame of its own. */
static bool search_end(const search *s, uint32_t child, const pov_box *box)
{
    const uint32_t index = child & ~BVH_KIND;

    return (child & BVH_KIND) == BVH_FRAME ? search_frame(s, index)
                                           : s->leaf(s->user, s->tree->leaves + (size_t)index * BVH_UNIT, box);
}

static bool search_node(const search *s, const bvh_frame *in, const local *l, uint32_t at)
{
    const bvh_node *node = &s->tree->nodes[at];

    for (uint32_t found = overlapping(node, l); found; found &= found - 1) {
        const uint32_t i = first_of(found), child = node->child[i];
        const pov_box box = box_of(node, i, in);

        if ((child & BVH_KIND) == BVH_NODE ? !search_node(s, in, l, child) : !search_end(s, child, &box))
            return false;
    }
    return true;
}

static bool search_frame(const search *s, uint32_t frame)
{
    const bvh_frame *in = &s->tree->frames[frame];
    const pov_box cube = cube_of(in);
    local l;

    if ((in->root & BVH_KIND) != BVH_NODE)
        return search_end(s, in->root, &cube);
    enter(s->of, in, &l);
    return search_node(s, in, &l, in->root);
}

bool shaft_search(const bvh *tree, const shaft *s, shaft_leaf_fn *leaf, void *user)
{
    const search all = { tree, s, leaf, user };

    return search_frame(&all, 0);
}

/* Does a box lie beyond a flank? Of one that is long, only what lies in the shaft's own box is asked for. */
static bool is_beyond(const shaft *s, int i, const pov_box *box, double size)
{
    const pov_vec3 n = s->normal[i];
    const pov_vec3 nearest = pov_vec3_of(n.x < 0.0 ? box->hi.x : box->lo.x, n.y < 0.0 ? box->hi.y : box->lo.y,
                                         n.z < 0.0 ? box->hi.z : box->lo.z);

    return pov_dot(n, pov_sub(nearest, s->from)) > s->error[i] * size;
}

bool shaft_may_overlap(const shaft *s, const pov_box *box)
{
    const double size = s->size + vec3_sum(box->lo) + vec3_sum(box->hi), more = slack * size;
    const pov_box both = { pov_vec3_of(greater(box->lo.x, s->lo.x - more), greater(box->lo.y, s->lo.y - more), greater(box->lo.z, s->lo.z - more)),
                           pov_vec3_of(lesser(box->hi.x, s->hi.x + more), lesser(box->hi.y, s->hi.y + more), lesser(box->hi.z, s->hi.z + more)) };

    if (box->lo.x - s->hi.x > more || s->lo.x - box->hi.x > more || box->lo.y - s->hi.y > more || s->lo.y - box->hi.y > more ||
        box->lo.z - s->hi.z > more || s->lo.z - box->hi.z > more)
        return false;
    return !is_beyond(s, 0, &both, size) && !is_beyond(s, 1, &both, size) && !is_beyond(s, 2, &both, size) && !is_beyond(s, 3, &both, size);
}

/* Where the shaft lies, from a plane. */
static void find_range(const shaft *s, pov_vec3 normal, double distance, double *least, double *most)
{
    const double above = pov_dot(normal, s->from) - distance;

    *least = *most = above;
    for (int i = 0; i < 4; i++) {
        const double at = above + pov_dot(normal, s->corner[i]);

        *least = lesser(*least, at);
        *most = greater(*most, at);
    }
}

bool shaft_may_cross(const shaft *s, pov_vec3 normal, double distance)
{
    const double size = slack * (s->size + fabs(distance));
    double least, most;

    find_range(s, normal, distance, &least, &most);
    return !(least > size || -most > size);
}

bool shaft_may_overlap_triangle(const shaft *s, const pov_vec3 corner[3], pov_vec3 normal, bool touches)
{
    const double size = s->size + vec3_sum(corner[0]) + vec3_sum(corner[1]) + vec3_sum(corner[2]);
    double least, most;

    for (int i = 0; i < 4; i++) {
        bool beyond = true;

        for (int k = 0; k < 3; k++)
            beyond = beyond && pov_dot(s->normal[i], pov_sub(corner[k], s->from)) > s->error[i] * size;
        if (beyond)
            return false;
    }
    find_range(s, normal, pov_dot(normal, corner[0]), &least, &most);
    return touches ? !(least > slack * size || -most > slack * size) : least < -slack * size && most > slack * size;
}
