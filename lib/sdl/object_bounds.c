/* Boxes around objects that have been read. */
#include "sdl/object_query.h"

#include "sdl/object_subject.h"

#include <math.h>

static void enclose(pov_box *box, pov_vec3 p, bool is_first)
{
    if (is_first) {
        box->lo = box->hi = p;
        return;
    }
    box->lo = pov_vec3_of(pov_min(box->lo.x, p.x), pov_min(box->lo.y, p.y), pov_min(box->lo.z, p.z));
    box->hi = pov_vec3_of(pov_max(box->hi.x, p.x), pov_max(box->hi.y, p.y), pov_max(box->hi.z, p.z));
}

static pov_box map_box(const pov_affine *map, const pov_box *box)
{
    pov_box out;
    int i;

    for (i = 0; i < 8; i++)
        enclose(&out, pov_affine_point(map, pov_vec3_of(i & 1 ? box->hi.x : box->lo.x, i & 2 ? box->hi.y : box->lo.y,
                                                        i & 4 ? box->hi.z : box->lo.z)), i == 0);
    return out;
}

static void clip(pov_box *box, const pov_box *by)
{
    box->lo = pov_vec3_of(pov_max(box->lo.x, by->lo.x), pov_max(box->lo.y, by->lo.y), pov_max(box->lo.z, by->lo.z));
    box->hi = pov_vec3_of(pov_min(box->hi.x, by->hi.x), pov_min(box->hi.y, by->hi.y), pov_min(box->hi.z, by->hi.z));
}

/* The shape takes in as many of its transformations as it can; the last `left` of them are still to move its box. */
static bool shape_bounds(pov_reader *in, const object_parsed *o, uint32_t *left, pov_box *out)
{
    const bool takes = o->leaf.shape->prepare && o->leaf.shape->absorb;
    const transform *first = takes ? o->map : NULL;
    bool has_box;
    pov_affine map;
    subject s;

    *left = takes ? 0 : parse_count_transforms(o->map);
    if (!subject_begin(in, o, &s))
        return false;
    while (first && !(transform_compose(first, &map) && s.shape->absorb(s.own, &map))) {
        first = first->before;
        (*left)++;
    }
    has_box = s.shape->bounds(s.self, out);
    subject_end(in, &s);
    return has_box;
}

static bool leaf_bounds(pov_reader *in, const object_parsed *o, pov_box *out)
{
    uint32_t left;
    const bool has_box = shape_bounds(in, o, &left, out);
    pov_affine map;

    if (has_box && left > 0 && transform_compose(parse_last_transforms(in, o->map, left), &map))
        *out = map_box(&map, out);
    return has_box;
}

/* As in POV-Ray each transformation moves the box that the one before has left. */
static void move_box(pov_reader *in, const transform *moves, pov_box *box)
{
    pov_affine map;

    if (!moves)
        return;
    move_box(in, moves->before, box);
    if (transform_compose(parse_last_transforms(in, moves, 1), &map))
        *box = map_box(&map, box);
}

/* Along the axes, without an end elsewhere: what a plane that is normal to one leaves, or what it cuts off leaves. */
static bool plane_bounds(pov_reader *in, const object_parsed *o, bool cuts, pov_box *out)
{
    const pov_vec3 all = pov_vec3_of(INFINITY, INFINITY, INFINITY);
    double n[3], lo[3] = { -INFINITY, -INFINITY, -INFINITY }, hi[3] = { INFINITY, INFINITY, INFINITY };
    pov_half_space h;
    pov_affine map;
    bool is_one;
    subject s;

    *out = (pov_box){ pov_scale(all, -1.0), all };
    if (o->kind != OBJECT_LEAF || !o->leaf.shape->half_space || !subject_begin(in, o, &s))
        return false;
    is_one = s.shape->half_space(s.self, &h);
    subject_end(in, &s);
    if (is_one && subject_map(o, &map)) {
        const pov_vec3 on = pov_affine_point(&map, pov_scale(h.normal, h.distance));

        h.normal = subject_map_normal(&map, h.normal);
        h.distance = pov_dot(h.normal, on);
    }
    n[0] = h.normal.x, n[1] = h.normal.y, n[2] = h.normal.z;
    for (int i = 0; i < 3 && is_one; i++) {
        if (n[(i + 1) % 3] != 0.0 || n[(i + 2) % 3] != 0.0)
            continue;
        if ((n[i] > 0.0) == (((o->flags & LEAF_INVERSE) != 0) == cuts))
            hi[i] = h.distance / n[i];
        else
            lo[i] = h.distance / n[i];
    }
    *out = (pov_box){ pov_vec3_of(lo[0], lo[1], lo[2]), pov_vec3_of(hi[0], hi[1], hi[2]) };
    return is_one;
}

static bool is_finite_box(const pov_box *b)
{
    return isfinite(b->lo.x + b->lo.y + b->lo.z) && isfinite(b->hi.x + b->hi.y + b->hi.z);
}

/* As in POV-Ray planes along the axes narrow the box, and bound what has none if there are six. */
static bool common_bounds(pov_reader *in, const object_parsed *o, pov_box *out)
{
    bool has_box = false, is_empty;

    *out = (pov_box){ pov_vec3_of(-INFINITY, -INFINITY, -INFINITY), pov_vec3_of(INFINITY, INFINITY, INFINITY) };
    for (const object_parsed *member = o->first; member; member = member->next) {
        const bool cuts = o->op == NODE_DIFFERENCE && member != o->first;
        pov_box box;

        if (plane_bounds(in, member, cuts, &box)) {
            clip(out, &box);
        } else if (!cuts && object_bounds(in, member, &box) && (o->op == NODE_DIFFERENCE || !(member->flags & LEAF_INVERSE))) {
            clip(out, &box);
            has_box = true;
        }
    }
    is_empty = out->lo.x > out->hi.x || out->lo.y > out->hi.y || out->lo.z > out->hi.z;
    return !is_empty && (has_box || is_finite_box(out));
}

static bool group_bounds(pov_reader *in, const object_parsed *o, pov_box *out)
{
    bool has_box = false;
    pov_box box;

    if (o->op == NODE_INTERSECTION || o->op == NODE_DIFFERENCE)
        return common_bounds(in, o, out);
    for (const object_parsed *member = o->first; member; member = member->next) {
        if (!object_bounds(in, member, &box))
            return false;
        if (!has_box)
            *out = box;
        enclose(out, box.lo, false);
        enclose(out, box.hi, false);
        has_box = true;
    }
    return has_box;
}

static bool own_bounds(pov_reader *in, const object_parsed *o, pov_box *out)
{
    if (o->kind == OBJECT_LEAF)
        return leaf_bounds(in, o, out);
    if (o->kind != OBJECT_GROUP || !group_bounds(in, o, out))
        return false;
    move_box(in, o->map, out);
    return true;
}

/* By what clips the object, or by its bounds; of its transformations only those behind one of these move that one. */
static bool narrow(pov_reader *in, const object_parsed *o, const object_parsed *by, bool has_box, pov_box *out)
{
    for (; by; by = by->next) {
        object_parsed moved = parse_copy(by);
        pov_box box;

        parse_append_transforms(in, &moved.map, o->map, by->since);
        if ((by->flags & LEAF_INVERSE) || !object_bounds(in, &moved, &box))
            continue;
        if (has_box)
            clip(out, &box);
        else
            *out = box;
        has_box = true;
    }
    return has_box;
}

bool object_bounds(pov_reader *in, const object_parsed *o, pov_box *out)
{
    const bool has_box = narrow(in, o, o->clips, own_bounds(in, o, out), out);

    return narrow(in, o, o->bounds, has_box, out);
}

/* ---- what lies within a convex solid ---- */

/* The box around one that a map moves, or its inverse: wider by some times what is lost by rounding. */
static pov_box box_around(const pov_affine *map, bool inverse, const pov_box *box)
{
    const double lo[3] = { box->lo.x, box->lo.y, box->lo.z }, hi[3] = { box->hi.x, box->hi.y, box->hi.z };
    double least[3], most[3];

    for (int i = 0; i < 3; i++) {
        const double *const row = inverse ? map->inv[i] : map->m[i];
        double size = fabs(row[3]);

        least[i] = most[i] = row[3];
        for (int j = 0; j < 3; j++) {
            least[i] += pov_min(row[j] * lo[j], row[j] * hi[j]);
            most[i] += pov_max(row[j] * lo[j], row[j] * hi[j]);
            size += pov_max(fabs(row[j] * lo[j]), fabs(row[j] * hi[j]));
        }
        least[i] -= 0x1p-45 * size;
        most[i] += 0x1p-45 * size;
    }
    return (pov_box){ pov_vec3_of(least[0], least[1], least[2]), pov_vec3_of(most[0], most[1], most[2]) };
}

/* The same of a leaf: all of it is certainly within. */
static bool box_of_leaf(pov_reader *in, const object_parsed *o, pov_box *out)
{
    uint32_t left;
    pov_affine map;

    if (!shape_bounds(in, o, &left, out))
        return false;
    if (left == 0)
        return true;
    if (!transform_compose(parse_last_transforms(in, o->map, left), &map))
        return false;
    *out = box_around(&map, false, out);
    return true;
}

static bool holds_corners(const subject *s, const pov_box *box)
{
    const pov_vec3 zero = pov_vec3_of(0.0, 0.0, 0.0);
    bool all = true;

    for (int i = 0; i < 8 && all; i++)
        all = s->shape->inside(s->self, pov_vec3_of(i & 1 ? box->hi.x : box->lo.x, i & 2 ? box->hi.y : box->lo.y, i & 4 ? box->hi.z : box->lo.z),
                               zero);
    return all;
}

/* What is convex and holds all corners of a box holds all of it. */
static bool holds_box(pov_reader *in, const object_parsed *by, pov_box box)
{
    static const pov_affine same = { .inv = { { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0, 0.0 } } };
    bool holds;
    pov_affine map;
    subject s;

    if (by->map && !transform_compose(by->map, &map))
        return false;
    box = box_around(by->map ? &map : &same, true, &box);
    if (!is_finite_box(&box) || !subject_begin(in, by, &s))
        return false;
    holds = holds_corners(&s, &box);
    subject_end(in, &s);
    return holds;
}

bool object_is_convex(const object_parsed *o)
{
    return o->kind == OBJECT_LEAF && !o->clips && !(o->flags & LEAF_INVERSE) && (o->leaf.shape->flags & POV_SHAPE_CONVEX) && object_is_solid(o);
}

bool object_is_within(pov_reader *in, const object_parsed *o, const object_parsed *by)
{
    pov_box box;

    if (o->kind == OBJECT_LEAF)
        return !(o->flags & LEAF_INVERSE) && !(o->leaf.shape->flags & POV_SHAPE_ENDLESS) && box_of_leaf(in, o, &box) && holds_box(in, by, box);
    if (o->kind != OBJECT_GROUP || o->is_light_group || (o->flags & LEAF_INVERSE) || (o->op != NODE_UNION && o->op != NODE_MERGE))
        return false;
    for (const object_parsed *member = o->first; member; member = member->next) {
        object_parsed moved = parse_copy(member);

        parse_append_transforms(in, &moved.map, o->map, NULL);
        if (!object_is_within(in, &moved, by))
            return false;
    }
    return o->first != NULL;
}
