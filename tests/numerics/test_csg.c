/* test_csg.c - random trees of solids against their rules, in 512 bits, on the same doubles.
 *
 * Members are spheres, boxes, cylinders, cones, tori, planes and quadrics of the plugins, part of them on a grid of
 * quarters, part copies of others: faces coincide, and rays along the grid meet edges and tangents. Some clip others, but for what
 * complements are taken of. A ray that met a
 * surface goes on from it twice: straight ahead, and anywhere. Without arguments a short run; test_csg RAYS [SEED] for a
 * long one. */
#include "query/context.h"   /* before probe.h, whose name for a kind it uses for a parameter */

#include "numerics/families.h"

#include "support/check.h"
#include "support/fake_reader.h"
#include "support/shapes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MEMBERS = 27, PLACES_MAX = MEMBERS * PROBE_CROSSINGS, RAYS_OF_A_TREE = 64 };

#define U families_uniform

static long rays = 4000;
static uint64_t seed = 20261123;

typedef struct tally { long judged, open, hits, shared, wrong; } tally;

/* A tree, its members as probes, and what rays ask. */
typedef struct scene {
    model model;
    probe probes[MEMBERS];
    pov_reader *in;
    node_ref root;
    double on_grid;              /* share of coordinates on the grid */
    bool tori;                   /* nothing but tori, most of them equal */
    bool hidden[MEMBERS];        /* they clip */
    world *world;
    query_context *context;
} scene;

/* ---- trees ---- */

static uint32_t below(uint32_t n) { return (uint32_t)(n * U()); }

static double coordinate(const scene *s)
{
    const double x = 2.0 * U() - 1.0;

    return U() < s->on_grid ? 0.25 * floor(4.0 * x + 0.5) : x;
}

static double extent(const scene *s) { return U() < s->on_grid ? 0.25 * (1.0 + below(5)) : 0.1 + 1.2 * U(); }

static void put_point(const scene *s, double *at)
{
    for (int i = 0; i < 3; i++)
        at[i] = coordinate(s);
}

/* Around the y axis; a spindle now and then. */
static void make_torus(const scene *s, probe *p)
{
    p->number[0] = extent(s);
    p->number[1] = U() < 0.3 ? extent(s) : p->number[0] * (U() < s->on_grid ? 0.5 : (0.1 + 0.8 * U()));
}

static void make_plane(const scene *s, probe *p)
{
    const pov_vec3 n = families_direction();

    p->number[0] = n.x, p->number[1] = n.y, p->number[2] = n.z;
    if (U() < s->on_grid) {
        memset(p->number, 0, 3 * sizeof *p->number);
        p->number[below(3)] = U() < 0.5 ? -1.0 : 1.0;
    }
    p->number[3] = coordinate(s);
}

/* Ellipsoids, and what has no end: cylinders, cones, hyperboloids, paraboloids. */
static void make_quadric(const scene *s, probe *p)
{
    for (int i = 0; i < 3; i++)
        p->number[i] = U() < s->on_grid ? (double)below(3) - 0.5 * below(4) : 2.0 * U() - 0.5;
    for (int i = 3; i < 9; i++)
        p->number[i] = U() < 0.8 ? 0.0 : coordinate(s);
    p->number[9] = -extent(s);
}

static void make_member(const scene *s, probe *p)
{
    static const kind kinds[] = { SPHERE, BOX, BOX, CYLINDER, CONE, TORUS, PLANE, QUADRIC };
    static const int counts[KINDS] = { [SPHERE] = 4, [BOX] = 6, [CONE] = 8, [CYLINDER] = 7, [QUADRIC] = 10, [TORUS] = 2, [PLANE] = 4 };
    double *top;

    memset(p, 0, sizeof *p);
    p->kind = s->tori ? TORUS : kinds[below(sizeof kinds / sizeof *kinds)];
    p->count = counts[p->kind];
    p->size = 1.0;
    if (p->kind == TORUS)
        make_torus(s, p);
    else if (p->kind == PLANE)
        make_plane(s, p);
    else if (p->kind == QUADRIC)
        make_quadric(s, p);
    if (p->kind == TORUS || p->kind == PLANE || p->kind == QUADRIC)
        return;
    put_point(s, p->number);
    if (p->kind == SPHERE)
        p->number[3] = extent(s);
    else if (p->kind == BOX)
        for (int i = 0; i < 3; i++)
            p->number[3 + i] = p->number[i] + extent(s);
    if (p->kind != CYLINDER && p->kind != CONE)
        return;
    top = p->number + (p->kind == CYLINDER ? 3 : 4);
    memcpy(top, p->number, 3 * sizeof *top);
    top[below(3)] += extent(s);
    p->number[p->count - 1] = extent(s);
    if (p->kind == CONE)
        p->number[3] = 0.5 * p->number[7];
}

/* As parsed: the world prepares it. */
static void *parse(const scene *s, const probe *p, const shape_class *shape)
{
    shape_class written = *shape;
    void *self = fake_reader_memory(s->in, shape->instance_size + shape->parsed_size);

    if (shape->prepare)
        written.instance_size = shape->parsed_size;
    written.prepare = NULL;
    assert_true(probe_make(p, &written, s->in, self));
    return self;
}

static node_ref add_probe(scene *s, const probe *p, uint32_t flags)
{
    const shape_class *shape = fake_reader_shape(probe_keyword(p->kind));

    return test_add(&s->model, shape, parse(s, p, shape), NULL, 0, flags);
}

static node_ref add_member(scene *s)
{
    const uint32_t which = (uint32_t)s->model.leaves.count;
    probe *p = &s->probes[which];

    if (which > 0 && U() < (s->tori ? 0.8 : 0.33 * s->on_grid))
        *p = s->probes[below(which)];
    else
        make_member(s, p);
    return add_probe(s, p, U() < 0.1 ? LEAF_INVERSE : 0);
}

/* complement: it is taken of something around it. */
static node_ref add_tree(scene *s, int depth, bool complement)
{
    const bool inverse = U() < 0.1;
    const node_op op = (node_op)below(complement || inverse ? 4 : 5);
    const group_node shape = { .op = op, .inverse = inverse, .united = op == NODE_UNION, .line = 1, .column = 1 };
    const uint32_t n = 2 + below(2);
    node_ref children[3], out;

    if (depth == 0)
        return add_member(s);
    for (uint32_t i = 0; i < n; i++) {
        const size_t first = s->model.leaves.count;

        children[i] = add_tree(s, depth - 1, complement || inverse || (op == NODE_DIFFERENCE && i > 0));
        for (size_t k = first; op == NODE_CLIP && i > 0 && k < s->model.leaves.count; k++)
            s->hidden[k] = true;
    }
    assert_true(model_add_group(&s->model, &shape, children, n, &out));
    return out;
}

/* ---- the rules ---- */

typedef struct crossing { const exact_crossing *at; uint32_t member; double cosine; } crossing;

/* A ray's crossings ahead, of all members, in order; and where it is at its start, then as places are applied. */
typedef struct course {
    exact_result of[MEMBERS];
    crossing at[PLACES_MAX];
    int count;
    bool inside[MEMBERS], open;
    double scale;                /* of lengths along the ray, in units of its direction */
} course;

static int value_of(const scene *s, const course *c, node_ref node, int *sense, uint32_t leaf, int turn)
{
    const group_node *g;
    int sum = 0, zeros = 0, value;

    if (!(node & NODE_GROUP)) {
        const bool inverse = s->model.leaves.items[node].flags & LEAF_INVERSE;

        if (node == leaf && sense)
            *sense = inverse ? -turn : turn;
        return c->inside[node] != inverse;
    }
    g = &s->model.groups.items[node & ~NODE_GROUP];
    turn = g->inverse ? -turn : turn;
    for (uint32_t i = 0; i < g->child_count; i++) {
        const bool cut = g->op == NODE_DIFFERENCE && i > 0;

        value = value_of(s, c, s->model.children.items[g->child + i], sense, leaf, cut ? -turn : turn);
        value = cut ? value == 0 : value;
        sum += value;
        zeros += value == 0;
    }
    value = g->op == NODE_UNION ? sum : g->op == NODE_MERGE ? sum > 0 : zeros > 0 ? 0 : 1 + sum - (int)g->child_count;
    return g->inverse ? value == 0 : value;
}

static double cosine_of(const exact_crossing *at, const pov_ray *ray)
{
    return fabs(pov_dot(pov_vec3_of(at->normal[0], at->normal[1], at->normal[2]), ray->dir));
}

static void insert(course *c, const exact_crossing *at, uint32_t member, double cosine)
{
    const crossing new = { at, member, cosine };
    int i = c->count++;

    for (; i > 0 && real_compare(at->t, c->at[i - 1].at->t) < 0; i--)
        c->at[i] = c->at[i - 1];
    c->at[i] = new;
    /* No double-double tells whether a tangent is met. */
    c->open = c->open || !(cosine > 1e-12);
}

/* Does it lie at the start, by the rule, or behind it? Not judged: neither clearly. */
static bool is_behind(course *c, const exact_crossing *at, double cosine)
{
    const double t = real_double(at->t), apart = t * cosine / c->scale;

    c->open = c->open || (apart > 0x1p-97 && apart < 0x1p-90);
    return apart < 0x1p-92;
}

/* The crossing at which the ray leaves a member: of one that is left by name, that next to the start. -1: none. */
static int left_crossing(const scene *s, const pov_ray *ray, uint32_t member, const exact_result *r)
{
    const probe *p = &s->probes[member], *from = ray->origin_surface == POV_NO_OWNER ? NULL : &s->probes[ray->origin_surface];
    int best = -1;

    if (!from || p->kind != from->kind || memcmp(p->number, from->number, sizeof p->number) != 0)
        return -1;
    for (int k = 0; k < r->count; k++)
        if (best < 0 || fabs(real_double(r->at[k].t)) < fabs(real_double(r->at[best].t)))
            best = k;
    return best >= 0 && fabs(real_double(r->at[best].t)) * cosine_of(&r->at[best], ray) < 0x1p-43 ? best : -1;
}

/* Does the ray run in the plane of a cap of a cone or cylinder? Whether the rim is met is then a matter of convention. */
static bool is_in_cap(const probe *p, const pov_ray *ray)
{
    const double o[3] = { ray->org.x, ray->org.y, ray->org.z }, d[3] = { ray->dir.x, ray->dir.y, ray->dir.z };
    const double *top = p->number + (p->kind == CYLINDER ? 3 : 4);

    if (p->kind != CYLINDER && p->kind != CONE)
        return false;
    for (int i = 0; i < 3; i++)
        if (top[i] != p->number[i] && d[i] == 0.0 && (o[i] == top[i] || o[i] == p->number[i]))
            return true;
    return false;
}

/* Along the axis both sheets of a spindle meet in the poles, which have no normal. */
static bool is_on_axis(const probe *p, const pov_ray *ray)
{
    return p->kind == TORUS && ray->org.x == 0.0 && ray->org.z == 0.0 && ray->dir.x == 0.0 && ray->dir.z == 0.0;
}

static bool has_no_end(kind k) { return k == PLANE || k == QUADRIC; }

/* On which side of an endless member does the ray end? By the first of these that is not 0: the value of the second order, the
 * first and the start. None: the ray runs in the surface, which nothing decides. */
static bool ends_inside(const probe *p, const pov_ray *ray, bool *open)
{
    const double *q = p->number, o[3] = { ray->org.x, ray->org.y, ray->org.z }, d[3] = { ray->dir.x, ray->dir.y, ray->dir.z };
    const double o_lo[3] = { ray->org_lo.x, ray->org_lo.y, ray->org_lo.z };
    static const int first[6] = { 0, 1, 2, 0, 0, 1 }, second[6] = { 0, 1, 2, 1, 2, 2 };
    real sum[3] = { real_of(0.0), real_of(0.0), real_of(0.0) }, at[3];

    for (int i = 0; i < 3; i++)
        at[i] = real_of2(o[i], o_lo[i]);
    for (int i = 0; i < 6 && p->kind == QUADRIC; i++) {
        const real c = real_of(q[i]), x = real_of(d[first[i]]), y = real_of(d[second[i]]);

        sum[0] = real_add(sum[0], real_mul(c, real_mul(x, y)));
        sum[1] = real_add(sum[1], real_mul(c, real_add(real_mul(x, at[second[i]]), real_mul(y, at[first[i]]))));
        sum[2] = real_add(sum[2], real_mul(c, real_mul(at[first[i]], at[second[i]])));
    }
    for (int i = 0; i < 3; i++) {
        const real c = real_of(q[p->kind == QUADRIC ? 6 + i : i]);

        sum[1] = real_add(sum[1], real_mul(c, real_of(d[i])));
        sum[2] = real_add(sum[2], real_mul(c, at[i]));
    }
    if (p->kind == QUADRIC) {
        sum[2] = real_add(sum[2], real_of(q[9]));
    } else {
        const real3 n = real3_of(real_of(q[0]), real_of(q[1]), real_of(q[2]));

        sum[2] = real_sub(sum[2], real_mul(real_of(q[3]), real_sqrt(real3_dot(n, n))));
    }
    for (int i = 0; i < 3; i++)
        if (real_sign(sum[i]) != 0) {
            *open = *open || fabs(real_double(sum[i])) < 0x1p-80;
            return real_sign(sum[i]) < 0;
        }
    *open = true;
    return false;
}

/* Does the line pass a rim, where two of the crossings are one place? Which of them count is a matter of convention, too. */
static bool is_on_rim(const exact_result *r, kind k)
{
    for (int i = 1; i < r->count; i++)
        if (real_double(real_sub(r->at[i].t, r->at[i - 1].t)) < 0x1p-80)
            return true;
    return !has_no_end(k) && r->count & 1;
}

static void find_course(scene *s, const pov_ray *ray, course *c)
{
    memset(c, 0, sizeof *c);
    c->scale = 3.0 + pov_largest(ray->org);
    for (uint32_t i = 0; i < s->model.leaves.count; i++) {
        exact_result *r = &c->of[i];
        int ahead = 0, left;

        s->probes[i].ray = *ray;
        probe_exact(&s->probes[i], r);
        left = left_crossing(s, ray, i, r);
        c->open = c->open || is_in_cap(&s->probes[i], ray) || is_on_axis(&s->probes[i], ray) ||
                  (s->probes[i].kind != BOX && is_on_rim(r, s->probes[i].kind));
        for (int k = 0; k < r->count; k++)
            if (k != left && !is_behind(c, &r->at[k], cosine_of(&r->at[k], ray))) {
                insert(c, &r->at[k], i, cosine_of(&r->at[k], ray));
                ahead++;
            }
        c->inside[i] = (ahead & 1) != (has_no_end(s->probes[i].kind) && ends_inside(&s->probes[i], ray, &c->open));
    }
}

/* The end of the place that begins at `first`. */
static int end_of(course *c, int first)
{
    int end = first + 1;

    for (; end < c->count; end++) {
        const crossing *a = &c->at[first], *b = &c->at[end];
        const double gap = real_double(real_sub(b->at->t, a->at->t)) * a->cosine * b->cosine / (a->cosine + b->cosine);

        if (gap > 0x1p-91 * c->scale) {
            c->open = c->open || gap < 0x1p-80 * c->scale;
            break;
        }
    }
    return end;
}

/* Does a member change, and each node above it? */
static bool is_passed_on(const scene *s, const course *before, const course *c, node_ref node, uint32_t member)
{
    const group_node *g = &s->model.groups.items[node & ~NODE_GROUP];
    bool found = false;

    if (!(node & NODE_GROUP))
        return node == member && c->inside[node] != before->inside[node];
    if (value_of(s, c, node, NULL, 0, 1) == value_of(s, before, node, NULL, 0, 1))
        return false;
    for (uint32_t i = 0; i < g->child_count; i++)
        found = found || is_passed_on(s, before, c, s->model.children.items[g->child + i], member);
    return found;
}

static uint32_t owner_of(const scene *s, const course *before, course *c, int first, int end, bool enters)
{
    uint32_t best = UINT32_MAX;

    for (int i = first; i < end; i++) {
        const uint32_t m = c->at[i].member;
        int sense = 0;

        value_of(s, c, s->root, &sense, m, 1);
        if (!s->hidden[m] && (c->inside[m] == (sense > 0)) == enters && m < best && is_passed_on(s, before, c, s->root, m))
            best = m;
    }
    return best;
}

/* Members that clip are applied before the others of a place where they uncover, and else behind them. */
static void apply(const scene *s, course *c, int first, int end, bool hidden, bool uncover, bool *applied)
{
    for (int i = first; i < end; i++) {
        const uint32_t m = c->at[i].member;
        int sense = 0;

        value_of(s, c, s->root, &sense, m, 1);
        if (applied[i - first] || s->hidden[m] != hidden || (uncover && c->inside[m] != (sense < 0)))
            continue;
        applied[i - first] = true;
        c->inside[m] ^= true;
    }
}

/* The first surface. False: there is none. */
static bool first_surface(const scene *s, course *c, real *t, double *cosine, uint32_t *owner, bool *enters, bool *shared)
{
    for (int first = 0, end; first < c->count; first = end) {
        bool applied[PLACES_MAX] = { false };
        course uncovered;
        int before, after;

        end = end_of(c, first);
        apply(s, c, first, end, true, true, applied);
        uncovered = *c;
        before = value_of(s, c, s->root, NULL, 0, 1);
        apply(s, c, first, end, false, false, applied);
        after = value_of(s, c, s->root, NULL, 0, 1);
        if (after == before) {
            apply(s, c, first, end, true, false, applied);
            continue;
        }
        *t = c->at[first].at->t;
        *cosine = c->at[first].cosine;
        *enters = after > before;
        *shared = end - first > 1;
        *owner = owner_of(s, &uncovered, c, first, end, *enters);
        c->open = c->open || *owner == UINT32_MAX;
        return true;
    }
    return false;
}

/* ---- rays ---- */

static pov_ray new_ray(const scene *s)
{
    static const double far[] = { 1.0, 3.0, 10.0, 1e3, 1e6, 1e9 };
    const pov_vec3 target = pov_vec3_of(coordinate(s), coordinate(s), coordinate(s));
    pov_vec3 dir = families_direction();
    pov_ray ray;

    if (U() < 0.4 * s->on_grid)
        dir = pov_vec3_of((double)below(3) - 1.0, (double)below(3) - 1.0, (double)below(3) - 1.0);
    if (!(pov_largest(dir) > 0.0))
        dir.x = 1.0;
    memset(&ray, 0, sizeof ray);
    ray.org = pov_sub(target, pov_scale(dir, 4.0 * far[below(6)]));
    ray.dir = dir;
    ray.origin_surface = POV_NO_OWNER;
    return ray;
}

static void complain(const scene *s, const pov_ray *ray, const char *what, bool on)
{
    fprintf(stderr, "%s, %u members, %s surface: <%a %a %a> + <%a %a %a> to <%a %a %a>\n", what, (unsigned)s->model.leaves.count,
            on ? "on a" : "on no", ray->org.x, ray->org.y, ray->org.z, ray->org_lo.x, ray->org_lo.y, ray->org_lo.z, ray->dir.x,
            ray->dir.y, ray->dir.z);
}

/* Within four units in the last place, and what a point is rounded to in two parts; more where a surface is grazed. */
static bool is_near(const course *c, double cosine, real exact, double t)
{
    return fabs(real_double(exact) - t) <= 0x1p-50 * fabs(t) + 0x1p-97 * c->scale / (cosine * cosine);
}

/* Judge a ray. True: it met a surface, completed in h. */
static bool judge(scene *s, const pov_ray *ray, hit *h, tally *out)
{
    const pov_ray *one = ray;
    course c;
    uint32_t owner = 0;
    bool enters = false, shared = false, expected, met;
    const char *what;
    double cosine = 1.0;
    real t = NULL;

    real_reset();
    find_course(s, ray, &c);
    expected = first_surface(s, &c, &t, &cosine, &owner, &enters, &shared);
    met = query_nearest(s->world, s->context, &one, 1, HUGE_VAL, h) & 1;
    if (met)
        world_surface(s->world, ray, h);
    if (c.open) {
        out->open++;
        return met;
    }
    out->judged++;
    out->hits += expected;
    out->shared += shared;
    what = met != expected ? met ? "met nothing" : "missed" : !met ? NULL : !is_near(&c, cosine, t, h->crossing.t) ? "distance"
           : h->object != owner ? "owner" : h->entering != enters ? "side" : NULL;
    out->wrong += what != NULL;
    if (what && out->wrong <= 8)
        complain(s, ray, what, ray->origin_surface != POV_NO_OWNER);
    return met;
}

static void leave(pov_ray *ray, const hit *h, pov_vec3 dir)
{
    ray->org = h->point;
    ray->org_lo = h->point_lo;
    ray->dir = dir;
    memset(&ray->dir_lo, 0, sizeof ray->dir_lo);
    test_leave(ray, h);
}

static void judge_tree(scene *s, tally *out)
{
    for (int i = 0; i < RAYS_OF_A_TREE; i++) {
        pov_ray ray = new_ray(s);
        hit h;

        for (int turn = 0; turn < 6 && judge(s, &ray, &h, out); turn++)
            leave(&ray, &h, turn % 2 ? families_direction() : ray.dir);
    }
}

static void make_and_judge(tally *out, int round, bool tori)
{
    const world_options options = { .accel = round % 2 ? POV_ACCEL_TREE : POV_ACCEL_NONE, .threads = 1 };
    scene s;

    memset(&s, 0, sizeof s);
    test_model_init(&s.model, NULL);
    s.in = fake_reader_create();
    s.on_grid = 0.33 * (round % 4);
    s.tori = tori;
    s.root = add_tree(&s, 1 + (int)below(tori ? 2 : 3), false);
    assert_true(model_add_tree(&s.model, s.root));
    if (s.model.trees.count == 1 && s.model.trees.items[0] == s.root) {
        assert_int_equal(world_create(&s.world, &s.model, &options, NULL), POV_OK);
        assert_int_equal(query_context_create(&s.context, s.world, NULL), POV_OK);
        judge_tree(&s, out);
        query_context_destroy(s.context);
        world_destroy(s.world);
    }
    model_free(&s.model);
    fake_reader_destroy(s.in);
}

static void judge_trees(long count, bool tori, double least_shared)
{
    tally all = { 0, 0, 0, 0, 0 };

    families_seed(seed);
    for (int round = 0; all.judged < count; round++)
        make_and_judge(&all, round, tori);
    print_message("%ld rays: %ld surfaces, %ld of them shared; %ld too near a tangent or a rim; %ld wrong\n", all.judged,
                  all.hits, all.shared, all.open, all.wrong);
    assert_true(all.hits > count / 5 && all.shared > least_shared * count);
    assert_int_equal(all.wrong, 0);
}

/* Around a box whose top touches that of a sphere, which is within what a far sphere leaves and so counts for nothing but the owner: a ray
 * that starts in the box's side crosses both at the top, 2^-60 farther, at distances that differ by 2^-100. */
static void a_place_next_to_the_start_is_shared(void **state)
{
    static const probe upper = { .kind = SPHERE, .count = 4, .size = 1.0, .number = { -0.75, -0.5, 0.25, 1.25 } };
    static const probe far = { .kind = SPHERE, .count = 4, .size = 1.0, .number = { 9.0, 0.0, 0.0, 1.0 } };
    static const probe brick = { .kind = BOX, .count = 6, .size = 1.0, .number = { -0.75, -0.5, -0.25, -0.25, 0.75, 0.5 } };
    const world_options options = { .accel = POV_ACCEL_NONE, .threads = 1 };
    const group_node merge = { .op = NODE_MERGE, .line = 1, .column = 1 };
    const group_node both = { .op = NODE_INTERSECTION, .inverse = true, .line = 1, .column = 1 };
    const pov_ray ray = { .org = { -0.75, 0.75, 0x1.fffffffffffecp-3 }, .org_lo = { 0.0, -0x1.9cb722eb26ep-62, 0x1.3681acfba6p-64 },
                          .dir = { 0x1.315c513599fc9p-1, 0x1.30e13e7444381p-2, -0x1.7da7d27f3eeb8p-1 }, .origin_surface = 2,
                          .origin_mark = { .flags = POV_MARK_ESCALATED | POV_MARK_INWARD } };
    tally all = { 0, 0, 0, 0, 0 };
    node_ref children[2];
    scene s;
    hit h;

    (void)state;
    memset(&s, 0, sizeof s);
    test_model_init(&s.model, NULL);
    s.in = fake_reader_create();
    s.probes[0] = upper;
    s.probes[1] = far;
    s.probes[2] = brick;
    for (int i = 0; i < 2; i++)
        children[i] = add_probe(&s, &s.probes[i], i == 1 ? LEAF_INVERSE : 0);
    assert_true(model_add_group(&s.model, &merge, children, 2, &children[0]));
    children[1] = add_probe(&s, &s.probes[2], 0);
    assert_true(model_add_group(&s.model, &both, children, 2, &s.root) && model_add_tree(&s.model, s.root));
    assert_int_equal(world_create(&s.world, &s.model, &options, NULL), POV_OK);
    assert_int_equal(query_context_create(&s.context, s.world, NULL), POV_OK);
    assert_true(judge(&s, &ray, &h, &all));
    assert_true(all.judged == 1 && all.shared == 1 && all.wrong == 0);
    query_context_destroy(s.context);
    world_destroy(s.world);
    model_free(&s.model);
    fake_reader_destroy(s.in);
}

/* From the face of a neighbour, which may be off by little: what lies between both counts from 2^-92 of the tree's size on. */
static void judge_by_a_face(scene *s, tally *out)
{
    static const double by[] = { 0.0, 0x1p-58, 0x1p-64, 0x1p-80, 0x1p-91, 0x1p-92, 0x1p-93, 0x1p-104 };

    families_seed(seed);
    for (int i = 0; i < 2000; i++) {
        pov_ray ray = { .org = { 0.4 + 0.5 * U(), 0.4 * U(), i % 2 ? 0.25 : 0.0 }, .origin_surface = POV_NO_OWNER };
        hit h;

        ray.org_lo.z = (U() - 0.5) * by[below(8)];
        ray.dir = families_direction();
        judge(s, &ray, &h, out);
    }
}

static void next_to_a_face_little_counts_and_less_does_not(void **state)
{
    static const probe members[] = {
        { .kind = CYLINDER, .count = 7, .size = 1.0, .number = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.25, 1.0 } },
        { .kind = CYLINDER, .count = 7, .size = 1.0, .number = { 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.25 } },
        { .kind = BOX, .count = 6, .size = 1.0, .number = { -1.5, -1.5, -1.0, 0.0, 1.5, 1.0 } } };
    const world_options options = { .accel = POV_ACCEL_TREE, .threads = 1 };
    const group_node all = { .op = NODE_INTERSECTION, .line = 1, .column = 1 };
    tally found = { 0, 0, 0, 0, 0 };
    node_ref children[3];
    scene s;

    (void)state;
    memset(&s, 0, sizeof s);
    test_model_init(&s.model, NULL);
    s.in = fake_reader_create();
    for (int i = 0; i < 3; i++) {
        s.probes[i] = members[i];
        children[i] = add_probe(&s, &s.probes[i], i > 0 ? LEAF_INVERSE : 0);
    }
    assert_true(model_add_group(&s.model, &all, children, 3, &s.root) && model_add_tree(&s.model, s.root));
    assert_int_equal(world_create(&s.world, &s.model, &options, NULL), POV_OK);
    assert_int_equal(query_context_create(&s.context, s.world, NULL), POV_OK);
    judge_by_a_face(&s, &found);
    assert_true(found.judged > 1500 && found.hits > 1000);
    assert_int_equal(found.wrong, 0);
    query_context_destroy(s.context);
    world_destroy(s.world);
    model_free(&s.model);
    fake_reader_destroy(s.in);
}

static void random_trees_keep_their_rules(void **state)
{
    (void)state;
    judge_trees(rays, false, 0.005);
}

/* A ray that starts on one of them leaves all by its name. */
static void equal_tori_are_one_surface(void **state)
{
    (void)state;
    judge_trees(rays / 2, true, 0.1);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(a_place_next_to_the_start_is_shared),
                                       cmocka_unit_test(next_to_a_face_little_counts_and_less_does_not),
                                       cmocka_unit_test(random_trees_keep_their_rules),
                                       cmocka_unit_test(equal_tori_are_one_surface) };
    int failed;

    if (argc > 1)
        rays = strtol(argv[1], NULL, 10);
    if (argc > 2)
        seed = strtoull(argv[2], NULL, 10);
    failed = cmocka_run_group_tests(tests, NULL, NULL);
    real_free_all();
    return failed;
}
