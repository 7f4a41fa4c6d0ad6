#include "sdl/object_query.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A leaf's shape, ready to be asked. */
typedef struct subject {
    const shape_class *shape;
    const void *self;
    void *own;           /* the same where it was prepared for this */
    void *scratch;
    unsigned char buffer[POV_PREPARED_MAX + 64];
} subject;

static bool begin(pov_reader *in, const object_parsed *o, subject *s)
{
    size_t bytes;

    s->shape = o->leaf.shape;
    s->self = o->leaf.instance;
    s->own = NULL;
    s->scratch = NULL;
    if (s->shape->prepare) {
        void *at = s->buffer + (64 - ((uintptr_t)s->buffer & 63));

        memset(s->buffer, 0, sizeof s->buffer);
        s->shape->prepare(at, o->leaf.instance);
        s->self = s->own = at;
    }
    bytes = s->shape->scratch ? s->shape->scratch(s->self) : 0;
    if (bytes > 0)
        s->scratch = env_alloc_aligned(in->model->env, bytes, 64);
    if (bytes > 0 && !s->scratch)
        report_memory(in);
    return !in->failed;
}

static void end(pov_reader *in, subject *s)
{
    if (s->scratch)
        env_free_aligned(in->model->env, s->scratch);
}

/* The map of an object, if it has one. */
static bool find_map(const object_parsed *o, pov_affine *map)
{
    return o->map && transform_compose(o->map, map);
}

static pov_vec3 back(const pov_affine *map, pov_vec3 p, double weight)
{
    const double (*m)[4] = map->inv;

    return pov_vec3_of(m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + weight * m[0][3],
                       m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z + weight * m[1][3],
                       m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z + weight * m[2][3]);
}

/* By the transposed inverse. */
static pov_vec3 map_normal(const pov_affine *map, pov_vec3 n)
{
    const double (*m)[4] = map->inv;

    return pov_unit(pov_vec3_of(m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z,
                                m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
                                m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z));
}

/* ---- points ---- */

static bool holds_as(pov_reader *in, const object_parsed *o, pov_vec3 point, bool cuts);

/* Does the group hold a point that `but`, one of its members, is taken to hold, or not to? */
static bool group_holds(pov_reader *in, const object_parsed *o, pov_vec3 point, const object_parsed *but,
                        bool but_holds)
{
    const object_parsed *member;
    bool is_first = true;

    for (member = o->first; member; member = member->next, is_first = false) {
        const bool cuts = o->op == NODE_DIFFERENCE && !is_first;
        const bool holds = member == but ? but_holds != cuts : holds_as(in, member, point, cuts);

        switch (o->op) {
        case NODE_UNION: case NODE_MERGE:
            if (holds)
                return true;
            break;
        case NODE_INTERSECTION: case NODE_DIFFERENCE:
            if (!holds)
                return false;
            break;
        case NODE_CLIP:          /* no statement makes one */
            break;
        }
    }
    return o->first && (o->op == NODE_INTERSECTION || o->op == NODE_DIFFERENCE);
}

/* Is the point in all that clips the object? Of its transformations only those behind a clip move this one. */
static bool clips_hold(pov_reader *in, const object_parsed *o, pov_vec3 point)
{
    for (const object_parsed *clip = o->clips; clip; clip = clip->next) {
        const transform *moves = NULL;
        pov_vec3 at = point;
        pov_affine map;

        parse_append_transforms(in, &moves, o->map, clip->since);
        if (moves && transform_compose(moves, &map))
            at = back(&map, point, 1.0);
        if (!object_holds(in, clip, at))
            return false;
    }
    return true;
}

/* The object, or what it leaves when it cuts: of a clipped one that is clipped too, and of a surface that holds nothing nothing
 * is left, as in POV-Ray. */
static bool holds_as(pov_reader *in, const object_parsed *o, pov_vec3 point, bool cuts)
{
    const pov_vec3 zero = pov_vec3_of(0.0, 0.0, 0.0);
    const bool turned = ((o->flags & LEAF_INVERSE) != 0) != cuts;
    bool holds = false;
    pov_affine map;
    subject s;

    if (o->clips && !clips_hold(in, o, point))
        return false;
    if (find_map(o, &map))
        point = back(&map, point, 1.0);
    if (o->kind == OBJECT_LEAF && begin(in, o, &s)) {
        holds = shape_is_solid(s.shape, o->leaf.instance) ? s.shape->inside(s.self, point, zero) : turned;
        end(in, &s);
    } else if (o->kind == OBJECT_GROUP) {
        holds = group_holds(in, o, point, NULL, false);
    }
    return holds != turned;
}

bool object_is_solid(const object_parsed *o)
{
    return o->kind == OBJECT_GROUP || (o->kind == OBJECT_LEAF && shape_is_solid(o->leaf.shape, o->leaf.instance));
}

bool object_holds(pov_reader *in, const object_parsed *o, pov_vec3 point) { return holds_as(in, o, point, false); }

/* ---- rays ---- */

/* The nearest crossing beyond `from` and before best->t. */
typedef struct search { pov_ray ray; double from; } search;

/* Members of a group are asked again behind crossings that are no surface of the group. */
enum { CROSSINGS_MAX = 4096 };

static bool trace(pov_reader *in, const object_parsed *o, const search *outer, object_hit *best);

/* The normal that light sees, as in POV-Ray, of a leaf that is moved by `map` or by none. */
static void find_normal(const subject *s, const pov_affine *map, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const pov_vec3 zero = pov_vec3_of(0.0, 0.0, 0.0), point = pov_add(ray->org, pov_scale(ray->dir, at->t));
    pov_vec3 normal[POV_NORMALS_MAX];
    double share[POV_NORMALS_MAX];
    uint32_t count = 0, i;

    if (s->shape->shading_normals)
        count = s->shape->shading_normals(s->self, point, zero, &at->mark, normal, share);
    *out = zero;
    for (i = 0; i < count; i++)
        *out = pov_add(*out, pov_scale(map ? map_normal(map, normal[i]) : normal[i], share[i]));
    if (pov_largest(*out) > 0.0) {
        *out = pov_unit(*out);
        return;
    }
    s->shape->normal(s->self, ray, at, out);
    if (map)
        *out = map_normal(map, *out);
}

/* Nothing inverts a patch. */
static void invert(object_hit *h)
{
    if (!h->on_patch)
        h->normal = pov_scale(h->normal, -1.0);
}

static bool trace_leaf(pov_reader *in, const object_parsed *o, const pov_affine *map, const search *ask, object_hit *best)
{
    const pov_vec3 zero = pov_vec3_of(0.0, 0.0, 0.0);
    pov_crossing at;
    pov_hits hits;
    subject s;
    bool found;

    if (!begin(in, o, &s))
        return false;
    memset(&hits, 0, sizeof hits);
    hits.tmin = ask->from;
    hits.tmax = best->t;
    hits.want = POV_WANT_NEAREST;
    hits.capacity = 1;
    hits.at = &at;
    hits.scratch = s.scratch;
    s.shape->intersect(s.self, &ask->ray, &hits);
    found = hits.count > 0 && at.t < best->t;
    if (found) {
        best->t = at.t;
        find_normal(&s, map, &ask->ray, &at, &best->normal);
        best->on_patch = shape_is_patch(s.shape);
        if (s.shape->reversed && s.shape->reversed(s.self, &ask->ray, &at))
            best->normal = pov_sub(zero, best->normal);
        if (o->flags & LEAF_INVERSE)
            invert(best);
    }
    end(in, &s);
    return found;
}

static bool is_sheet(const object_parsed *o)
{
    const object_parsed *member;

    for (member = o->kind == OBJECT_GROUP ? o->first : NULL; member; member = member->next)
        if (!is_sheet(member))
            return false;
    return o->kind == OBJECT_GROUP || !shape_is_solid(o->leaf.shape, o->leaf.instance);
}

/* So little of the ray is far beyond its rounding. */
static double grain(const pov_ray *ray, double t)
{
    return 1e-9 * (fabs(t) + sqrt(pov_dot(ray->org, ray->org) / pov_dot(ray->dir, ray->dir)));
}

/* A crossing of a solid is one of the group where before it is in the group and behind it is not, or the other way round:
 * faces of members may coincide. One of a sheet is, where being in it decides about being in the group. */
static bool is_surface(pov_reader *in, const object_parsed *o, const object_parsed *member, const pov_ray *ray,
                       double t)
{
    const double step = grain(ray, t);
    const pov_vec3 point = pov_add(ray->org, pov_scale(ray->dir, t));

    if (is_sheet(member))
        return group_holds(in, o, point, member, true) != group_holds(in, o, point, member, false);
    return group_holds(in, o, pov_add(ray->org, pov_scale(ray->dir, t - step)), NULL, false) !=
           group_holds(in, o, pov_add(ray->org, pov_scale(ray->dir, t + step)), NULL, false);
}

/* A crossing may lie a little behind its distance as a double: it is not met again. */
static double behind(double t) { return t + fmax(DBL_EPSILON * fabs(t), DBL_MIN); }

static bool trace_member(pov_reader *in, const object_parsed *o, const object_parsed *member, search ask,
                         object_hit *best)
{
    const bool is_hole = o->op == NODE_DIFFERENCE && member != o->first;
    int i;

    for (i = 0; i < CROSSINGS_MAX; i++) {
        object_hit hit = *best;

        if (!trace(in, member, &ask, &hit))
            return false;
        if (o->op == NODE_UNION || is_surface(in, o, member, &ask.ray, hit.t)) {
            *best = hit;
            if (is_hole)
                invert(best);
            return true;
        }
        ask.from = behind(hit.t);
    }
    return false;
}

/* Of an object as if nothing clipped it. */
static bool trace_whole(pov_reader *in, const object_parsed *o, const search *outer, object_hit *best)
{
    const object_parsed *member;
    search ask = *outer;
    bool found = false, is_mapped;
    pov_affine map;

    is_mapped = find_map(o, &map);
    if (is_mapped) {
        ask.ray.org = back(&map, outer->ray.org, 1.0);
        ask.ray.dir = back(&map, outer->ray.dir, 0.0);
    }
    if (o->kind == OBJECT_LEAF)
        found = trace_leaf(in, o, is_mapped ? &map : NULL, &ask, best);
    for (member = o->kind == OBJECT_GROUP ? o->first : NULL; member; member = member->next)
        found |= trace_member(in, o, member, ask, best);
    if (found && is_mapped && o->kind == OBJECT_GROUP)
        best->normal = map_normal(&map, best->normal);
    if (found && o->kind == OBJECT_GROUP && (o->flags & LEAF_INVERSE))
        invert(best);
    return found;
}

static bool trace(pov_reader *in, const object_parsed *o, const search *outer, object_hit *best)
{
    search ask = *outer;

    for (int i = 0; i < CROSSINGS_MAX; i++) {
        object_hit hit = *best;

        if (!trace_whole(in, o, &ask, &hit))
            return false;
        if (!o->clips || clips_hold(in, o, pov_add(ask.ray.org, pov_scale(ask.ray.dir, hit.t)))) {
            *best = hit;
            return true;
        }
        ask.from = behind(hit.t);
    }
    return false;
}

bool object_trace(pov_reader *in, const object_parsed *o, pov_vec3 origin, pov_vec3 direction, object_hit *out)
{
    search ask;

    memset(&ask, 0, sizeof ask);
    ask.ray.org = origin;
    ask.ray.dir = direction;
    ask.ray.origin_surface = POV_NO_OWNER;
    out->t = HUGE_VAL;
    return trace(in, o, &ask, out);
}

/* ---- boxes ---- */

static void enclose(pov_box *box, pov_vec3 p, bool is_first)
{
    if (is_first) {
        box->lo = box->hi = p;
        return;
    }
    box->lo = pov_vec3_of(fmin(box->lo.x, p.x), fmin(box->lo.y, p.y), fmin(box->lo.z, p.z));
    box->hi = pov_vec3_of(fmax(box->hi.x, p.x), fmax(box->hi.y, p.y), fmax(box->hi.z, p.z));
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
    box->lo = pov_vec3_of(fmax(box->lo.x, by->lo.x), fmax(box->lo.y, by->lo.y), fmax(box->lo.z, by->lo.z));
    box->hi = pov_vec3_of(fmin(box->hi.x, by->hi.x), fmin(box->hi.y, by->hi.y), fmin(box->hi.z, by->hi.z));
}

/* The shape takes in as many of its transformations as it can; the others move its box. */
static bool leaf_bounds(pov_reader *in, const object_parsed *o, pov_box *out)
{
    const bool takes = o->leaf.shape->prepare && o->leaf.shape->absorb;
    const transform *first = takes ? o->map : NULL;
    uint32_t left = takes ? 0 : parse_count_transforms(o->map);
    bool has_box;
    pov_affine map;
    subject s;

    if (!begin(in, o, &s))
        return false;
    while (first && !(transform_compose(first, &map) && s.shape->absorb(s.own, &map))) {
        first = first->before;
        left++;
    }
    has_box = s.shape->bounds(s.self, out);
    end(in, &s);
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
    if (o->kind != OBJECT_LEAF || !o->leaf.shape->half_space || !begin(in, o, &s))
        return false;
    is_one = s.shape->half_space(s.self, &h);
    end(in, &s);
    if (is_one && find_map(o, &map)) {
        const pov_vec3 on = pov_affine_point(&map, pov_scale(h.normal, h.distance));

        h.normal = map_normal(&map, h.normal);
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
