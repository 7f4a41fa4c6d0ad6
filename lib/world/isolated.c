#include "world/compile.h"

/* Limit of comparisons of boxes, for a cost of about a millisecond. */
enum { PAIRS_MAX = 1 << 19 };
/* Relative gap to other boxes that holds whatever a ray's start is rounded to. */
static const double margin = 0x1p-20;
/* What is left of a solid beside others is to be more than this part of each of its extents. */
static const double least_part = 0.25;

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

static bool are_disjoint(const pov_box *a, const pov_box *b)
{
    return a->lo.x > b->hi.x || a->lo.y > b->hi.y || a->lo.z > b->hi.z ||
           b->lo.x > a->hi.x || b->lo.y > a->hi.y || b->lo.z > a->hi.z;
}

/* ---- boxes beside others ---- */

/* The box of a solid, the gap to others, and the part of space in which there are none: numbers by axis. */
typedef struct solid_box { double lo[3], hi[3], gap, free_lo[3], free_hi[3]; } solid_box;

static void numbers_of(const pov_box *b, double lo[3], double hi[3])
{
    lo[0] = b->lo.x;
    lo[1] = b->lo.y;
    lo[2] = b->lo.z;
    hi[0] = b->hi.x;
    hi[1] = b->hi.y;
    hi[2] = b->hi.z;
}

/* Roundings are small against the gap, wherever it is. */
static solid_box begin(const pov_box *own)
{
    const double size = pov_largest(pov_sub(own->hi, own->lo)), far = pov_max(pov_largest(own->lo), pov_largest(own->hi));
    solid_box s;

    numbers_of(own, s.lo, s.hi);
    s.gap = margin * size + 0x1p-44 * far;
    for (int k = 0; k < 3; k++) {
        s.free_lo[k] = -HUGE_VAL;
        s.free_hi[k] = HUGE_VAL;
    }
    return s;
}

/* What would be left of the solid's extent beside a limit. */
static double left_above(const solid_box *s, int k, double at) { return (s->hi[k] - at) / (s->hi[k] - s->lo[k]); }
static double left_below(const solid_box *s, int k, double at) { return (at - s->lo[k]) / (s->hi[k] - s->lo[k]); }

/* Leave the other out by the plane on one of its sides that takes least of the solid. False: too much. */
static bool leave_out(solid_box *s, const double lo[3], const double hi[3])
{
    double most = least_part;
    int axis = -1;
    bool above = false;

    for (int k = 0; k < 3; k++) {
        if (lo[k] - s->gap > s->hi[k] || hi[k] + s->gap < s->lo[k] || lo[k] > s->free_hi[k] || hi[k] < s->free_lo[k])
            return true;
        if (left_above(s, k, hi[k]) > most) {
            most = left_above(s, k, hi[k]);
            axis = k;
            above = true;
        }
        if (left_below(s, k, lo[k]) > most) {
            most = left_below(s, k, lo[k]);
            axis = k;
            above = false;
        }
    }
    if (axis >= 0 && above)
        s->free_lo[axis] = hi[axis] + s->gap;
    else if (axis >= 0)
        s->free_hi[axis] = lo[axis] - s->gap;
    return axis >= 0;
}

/* Where the boundary of a half-space passes the solid. */
static bool leave_out_plane(solid_box *s, const pov_half_space *of)
{
    const double normal[3] = { of->normal.x, of->normal.y, of->normal.z };
    double lo[3], hi[3];

    s->gap += 0x1p-44 * fabs(of->distance);
    for (int k = 0; k < 3; k++) {
        double least = of->distance, most = of->distance;

        for (int j = 0; j < 3; j++) {
            if (j == k)
                continue;
            least -= pov_max(normal[j] * s->lo[j], normal[j] * s->hi[j]);
            most -= pov_min(normal[j] * s->lo[j], normal[j] * s->hi[j]);
        }
        lo[k] = fabs(normal[k]) < margin ? -HUGE_VAL : (normal[k] > 0.0 ? least : most) / normal[k];
        hi[k] = fabs(normal[k]) < margin ? HUGE_VAL : (normal[k] > 0.0 ? most : least) / normal[k];
    }
    return leave_out(s, lo, hi);
}

/* ---- all of them ---- */

/* Where no other box and no plane is, within a solid; of finite objects the boxes are known. False: hardly anywhere. */
static bool find_free(const pov_box *boxes, uint32_t count, const pov_half_space *planes, uint32_t plane_count, uint32_t which,
                      pov_box *out)
{
    solid_box s = begin(&boxes[which]);
    const pov_vec3 by = pov_vec3_of(s.gap, s.gap, s.gap);
    const pov_box own = { pov_sub(boxes[which].lo, by), pov_add(boxes[which].hi, by) };
    bool found = true;

    for (uint32_t i = 0; found && i < plane_count; i++)
        found = leave_out_plane(&s, &planes[i]);
    for (uint32_t i = 0; found && i < count; i++) {
        double lo[3], hi[3];

        if (i == which || are_disjoint(&own, &boxes[i]))
            continue;
        numbers_of(&boxes[i], lo, hi);
        found = leave_out(&s, lo, hi);
    }
    out->lo = pov_vec3_of(s.free_lo[0], s.free_lo[1], s.free_lo[2]);
    out->hi = pov_vec3_of(s.free_hi[0], s.free_hi[1], s.free_hi[2]);
    return found;
}

/* False: something infinite is no half-space. */
static bool find_planes(const compile_state *f, pov_half_space *planes)
{
    bool are = true;

    for (uint32_t i = 0; are && i < f->infinite_count; i++)
        are = compile_half_space(f, f->infinite[i], &planes[i]);
    return are;
}

static void find_all(const compile_state *f, const pov_box *boxes, const pov_half_space *planes, world_isolation *out)
{
    uint32_t found = 0;

    for (uint32_t i = 0; i < f->finite_count; i++) {
        const uint32_t id = f->finite[i];

        if (is_transparent(f, id) && find_free(boxes, f->finite_count, planes, f->infinite_count, i, &out->boxes[found]))
            out->number[id] = ++found;
    }
}

bool compile_find_isolated(const compile_state *f, world_isolation *out)
{
    const uint32_t n = f->finite_count, all = n + f->infinite_count, most = all > 0 ? PAIRS_MAX / all : 0;
    const uint32_t transparent = count_transparent(f, most);
    pov_half_space *planes;
    pov_box *boxes;
    bool done;

    out->number = NULL;
    out->boxes = NULL;
    if (transparent == 0 || transparent > most)
        return true;
    boxes = env_resize(f->env, NULL, n, sizeof *boxes);
    planes = env_resize(f->env, NULL, f->infinite_count + 1u, sizeof *planes);
    out->number = env_alloc(f->env, compile_count(f), sizeof *out->number);
    out->boxes = env_alloc(f->env, transparent, sizeof *out->boxes);
    done = boxes && planes && out->number && out->boxes;
    for (uint32_t i = 0; done && i < n; i++)
        compile_box(f, f->finite[i], &boxes[i]);
    if (done && find_planes(f, planes))
        find_all(f, boxes, planes, out);
    env_free(f->env, boxes);
    env_free(f->env, planes);
    return done;
}
