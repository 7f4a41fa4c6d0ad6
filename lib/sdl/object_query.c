#include "sdl/object_query.h"

#include "sdl/object_subject.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- what there is of it ---- */

static object_content turned_content(object_content c)
{
    return c == CONTENT_NOTHING ? CONTENT_EVERYTHING : c == CONTENT_EVERYTHING ? CONTENT_NOTHING : c;
}

object_content object_content_of(const object_parsed *o)
{
    for (const object_parsed *clip = o->clips; clip; clip = clip->next)
        if (object_content_of(clip) == CONTENT_NOTHING)
            return CONTENT_NOTHING;
    return o->flags & LEAF_INVERSE ? turned_content(o->content) : o->content;
}

/* Of a union all surfaces are seen, whatever else is in it. Lights are no members. */
object_content object_content_of_members(const object_parsed *o)
{
    static const object_content none[] = { [NODE_UNION] = CONTENT_NOTHING, [NODE_MERGE] = CONTENT_NOTHING,
                                           [NODE_INTERSECTION] = CONTENT_EVERYTHING, [NODE_DIFFERENCE] = CONTENT_EVERYTHING };
    const object_content decides = o->op == NODE_UNION ? CONTENT_SHAPES : turned_content(none[o->op]);
    object_content found = none[o->op];

    for (const object_parsed *member = o->first; member; member = member->next) {
        const bool cuts = o->op == NODE_DIFFERENCE && member != o->first;
        const object_content c = cuts ? turned_content(object_content_of(member)) : object_content_of(member);

        if (member->kind == OBJECT_LIGHT || c == none[o->op])
            continue;
        found = c;
        if (c == decides)
            break;
    }
    return found;
}

/* ---- points ---- */

/* How often an object holds a point: a union counts its members, so that faces of one within another are surfaces of a group
 * around it too; a merge, and whatever is turned, counts 0 or 1. What is not 0 need not be told from `most` or more. */
static uint32_t value_as(pov_reader *in, const object_parsed *o, pov_vec3 point, bool cuts, uint32_t most);

/* A member that is taken to hold the point, or not to. */
typedef struct given { const object_parsed *member; bool holds; } given;

/* Of a group, or, if `turned`, of its complement. That is made of the complements of members, for a surface, or what is clipped, has
 * one of its own. */
static uint32_t group_value(pov_reader *in, const object_parsed *o, pov_vec3 point, bool turned, const given *but, uint32_t most)
{
    const bool any = (o->op == NODE_UNION || o->op == NODE_MERGE) != turned;
    const uint32_t limit = turned || o->op == NODE_MERGE ? 1 : most;
    uint32_t sum = any ? 0 : 1;

    for (const object_parsed *member = o->first; member && (!any || sum < limit); member = member->next) {
        const bool cuts = (o->op == NODE_DIFFERENCE && member != o->first) != turned;
        const uint32_t count = but && member == but->member ? but->holds != cuts : value_as(in, member, point, cuts, limit);

        if (!any && count == 0)
            return 0;
        sum += any ? count : count - 1;
    }
    return sum < limit ? sum : limit;
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
            at = subject_back(&map, point, 1.0);
        if (!object_holds(in, clip, at))
            return false;
    }
    return true;
}

/* The object, or what it leaves when it cuts: of a clipped one that is clipped too, and of a surface that holds nothing nothing
 * is left, as in POV-Ray. */
static uint32_t value_as(pov_reader *in, const object_parsed *o, pov_vec3 point, bool cuts, uint32_t most)
{
    const pov_vec3 zero = pov_vec3_of(0.0, 0.0, 0.0);
    const bool turned = ((o->flags & LEAF_INVERSE) != 0) != cuts;
    bool holds = false;
    pov_affine map;
    subject s;

    if (o->clips && !clips_hold(in, o, point))
        return 0;
    if (subject_map(o, &map))
        point = subject_back(&map, point, 1.0);
    if (o->kind == OBJECT_GROUP)
        return group_value(in, o, point, turned, NULL, most);
    if (o->kind == OBJECT_LEAF && subject_begin(in, o, &s)) {
        holds = shape_is_solid(s.shape, o->leaf.instance) ? s.shape->inside(s.self, point, zero) : turned;
        subject_end(in, &s);
    }
    return holds != turned;
}

bool object_is_solid(const object_parsed *o)
{
    return o->kind == OBJECT_GROUP || (o->kind == OBJECT_LEAF && shape_is_solid(o->leaf.shape, o->leaf.instance));
}

bool object_holds(pov_reader *in, const object_parsed *o, pov_vec3 point) { return value_as(in, o, point, false, 1) > 0; }

/* ---- rays ---- */

/* The nearest crossing beyond `from` and before best->t. */
typedef struct search { pov_ray ray; double from; } search;

/* on_patch: of a shape that nothing inverts; on_sheet: of one that has no inside. Where light sees another normal it is the blend of
 * normals as they are in the scene: each is moved with the groups around. */
typedef struct crossing {
    double t;
    bool on_patch, on_sheet;
    uint32_t count;
    pov_vec3 normal, blend[POV_NORMALS_MAX];
    double share[POV_NORMALS_MAX];
} crossing;

/* Members of a group are asked again behind crossings that are no surface of the group. */
enum { CROSSINGS_MAX = 4096 };

/* cuts: what is left of the object when it cuts is asked, which is of the same surfaces where all members are solids. */
static bool trace(pov_reader *in, const object_parsed *o, const search *outer, bool cuts, crossing *best);

static void move_normals(const pov_affine *map, crossing *c)
{
    c->normal = subject_map_normal(map, c->normal);
    for (uint32_t i = 0; i < c->count; i++)
        c->blend[i] = subject_map_normal(map, c->blend[i]);
}

static void turn_normals(crossing *c)
{
    c->normal = pov_scale(c->normal, -1.0);
    for (uint32_t i = 0; i < c->count; i++)
        c->blend[i] = pov_scale(c->blend[i], -1.0);
}

/* The normal that light sees, as in POV-Ray. */
static pov_vec3 seen_normal(const crossing *c)
{
    pov_vec3 sum = pov_vec3_of(0.0, 0.0, 0.0);

    for (uint32_t i = 0; i < c->count; i++)
        sum = pov_add(sum, pov_scale(c->blend[i], c->share[i]));
    return pov_largest(sum) > 0.0 ? pov_unit(sum) : c->normal;
}

static void find_normals(const subject *s, const pov_ray *ray, const pov_crossing *at, crossing *out)
{
    const pov_vec3 point = pov_add(ray->org, pov_scale(ray->dir, at->t));

    out->count = 0;
    if (s->shape->shading_normals)
        out->count = s->shape->shading_normals(s->self, point, pov_vec3_of(0.0, 0.0, 0.0), &at->mark, out->blend, out->share);
    s->shape->normal(s->self, ray, at, &out->normal);
}

/* Nothing inverts a patch. */
static void invert(crossing *c)
{
    if (!c->on_patch)
        turn_normals(c);
}

static bool trace_leaf(pov_reader *in, const object_parsed *o, const search *ask, crossing *best)
{
    pov_crossing at;
    pov_hits hits;
    subject s;
    bool found;

    if (!subject_begin(in, o, &s))
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
        find_normals(&s, &ask->ray, &at, best);
        best->on_patch = shape_is_patch(s.shape);
        best->on_sheet = !shape_is_solid(s.shape, o->leaf.instance);
        if (s.shape->reversed && s.shape->reversed(s.self, &ask->ray, &at))
            turn_normals(best);
        if (o->flags & LEAF_INVERSE)
            invert(best);
    }
    subject_end(in, &s);
    return found;
}

/* So little of the ray is far beyond its rounding. */
static double grain(const pov_ray *ray, double t)
{
    return 1e-9 * (fabs(t) + sqrt(pov_dot(ray->org, ray->org) / pov_dot(ray->dir, ray->dir)));
}

/* A crossing of a solid is one of the group where the group's value before it is another than behind it: faces of members may
 * coincide. One of a sheet is, where being in it decides about the value. */
static bool is_surface(pov_reader *in, const object_parsed *o, const object_parsed *member, const pov_ray *ray, bool turned,
                       const crossing *h)
{
    const double step = grain(ray, h->t);
    const pov_vec3 point = pov_add(ray->org, pov_scale(ray->dir, h->t));

    if (h->on_sheet)
        return group_value(in, o, point, turned, &(given){ member, true }, UINT32_MAX) !=
               group_value(in, o, point, turned, &(given){ member, false }, UINT32_MAX);
    return group_value(in, o, pov_add(ray->org, pov_scale(ray->dir, h->t - step)), turned, NULL, UINT32_MAX) !=
           group_value(in, o, pov_add(ray->org, pov_scale(ray->dir, h->t + step)), turned, NULL, UINT32_MAX);
}

/* A crossing may lie a little behind its distance as a double: it is not met again. */
static double behind(double t) { return t + pov_max(DBL_EPSILON * fabs(t), DBL_MIN); }

static bool trace_member(pov_reader *in, const object_parsed *o, const object_parsed *member, search ask, bool turned,
                         crossing *best)
{
    const bool is_hole = o->op == NODE_DIFFERENCE && member != o->first;
    int i;

    for (i = 0; i < CROSSINGS_MAX; i++) {
        crossing hit = *best;

        if (!trace(in, member, &ask, is_hole != turned, &hit))
            return false;
        if ((o->op == NODE_UNION && !turned) || is_surface(in, o, member, &ask.ray, turned, &hit)) {
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
static bool trace_whole(pov_reader *in, const object_parsed *o, const search *outer, bool cuts, crossing *best)
{
    const bool turned = ((o->flags & LEAF_INVERSE) != 0) != cuts;
    const object_parsed *member;
    search ask = *outer;
    bool found = false, is_mapped;
    pov_affine map;

    is_mapped = subject_map(o, &map);
    if (is_mapped) {
        ask.ray.org = subject_back(&map, outer->ray.org, 1.0);
        ask.ray.dir = subject_back(&map, outer->ray.dir, 0.0);
    }
    if (o->kind == OBJECT_LEAF)
        found = trace_leaf(in, o, &ask, best);
    for (member = o->kind == OBJECT_GROUP ? o->first : NULL; member; member = member->next)
        found |= trace_member(in, o, member, ask, turned, best);
    if (found && is_mapped)
        move_normals(&map, best);
    if (found && o->kind == OBJECT_GROUP && (o->flags & LEAF_INVERSE))
        invert(best);
    return found;
}

static bool trace(pov_reader *in, const object_parsed *o, const search *outer, bool cuts, crossing *best)
{
    search ask = *outer;

    for (int i = 0; i < CROSSINGS_MAX; i++) {
        crossing hit = *best;

        if (!trace_whole(in, o, &ask, cuts, &hit))
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
    crossing best;

    memset(&ask, 0, sizeof ask);
    memset(&best, 0, sizeof best);
    ask.ray.org = origin;
    ask.ray.dir = direction;
    ask.ray.origin_surface = POV_NO_OWNER;
    best.t = HUGE_VAL;
    if (!trace(in, o, &ask, false, &best))
        return false;
    out->t = best.t;
    out->normal = seen_normal(&best);
    return true;
}
