/* test_csg_outline.c - solids of few members, moved, turned and stretched: the first crossing that their outlines find, for rays one by
 * one and side by side, against the walk in double-double, which does not know them. Of convex members and complements of such, and of
 * planes and quadrics too in unions, intersections, differences and clips within each other; and tori that convex members, planes or
 * quadrics clip, or that they intersect. */
#include "numerics/sides.h"

#include "support/fake_reader.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 6, MEMBERS_MOST = 18, RAYS_OF_A_TREE = 400 };

#define U families_uniform

static long rays = 40000;

typedef struct scene {
    model model;
    pov_reader *in;
    const transform *map;        /* of most members: then faces of theirs lie on each other */
    bool endless;                /* planes and quadrics too */
    bool rings;                  /* tori too, which may have no outline */
    uint32_t material;           /* of all members */
    shape_class surface;         /* of a torus that is no torus of the plugin's */
    side filtered, exact;
    kept of[8];                  /* rays by octant */
} scene;
typedef struct tally { long rays, hits, blocked, together, crossed; } tally;

static uint32_t below(uint32_t n) { return (uint32_t)(n * U()); }

static double coordinate(void) { return U() < 0.3 ? 0.25 * (double)below(9) - 1.0 : 2.0 * U() - 1.0; }

/* The other corner or end: often where another member has its own. */
static void put_end(probe *p)
{
    double *to = p->number + (p->kind == CONE ? 4 : 3);
    const bool upright = p->kind != BOX && U() < 0.6;

    for (int i = 0; i < 3; i++)
        to[i] = p->number[i] + (p->kind == BOX ? U() < 0.5 ? 0.5 : 0.2 + U() : upright ? 0.0 : coordinate());
    if (upright || memcmp(to, p->number, 3 * sizeof *to) == 0)
        to[below(3)] += U() < 0.7 ? 0.5 : U() + 0.2;
}

/* A plane through the middle or near it, or a quadric of any kind. */
static void make_endless(probe *p)
{
    const pov_vec3 n = families_direction();

    p->number[0] = n.x, p->number[1] = n.y, p->number[2] = n.z;
    if (U() < 0.6) {
        memset(p->number, 0, 3 * sizeof *p->number);
        p->number[below(3)] = U() < 0.5 ? -1.0 : 1.0;
    }
    p->number[3] = 0.5 * coordinate();
    if (p->kind == PLANE)
        return;
    for (int i = 0; i < 9; i++)
        p->number[i] = i < 3 ? 2.0 * U() - 0.7 : U() < 0.6 ? 0.0 : 0.5 * coordinate();
    if (U() < 0.3)
        p->number[below(3)] = 0.0;
    p->number[9] = -U();
}

static void make_probe(probe *p)
{
    static const kind kinds[] = { SPHERE, BOX, CYLINDER, CONE };
    static const int counts[KINDS] = { [SPHERE] = 4, [BOX] = 6, [CONE] = 8, [CYLINDER] = 7 };
    const double size = U() < 0.3 ? 0.5 : 0.2 + U();

    memset(p, 0, sizeof *p);
    p->kind = kinds[below(4)];
    p->count = counts[p->kind];
    p->size = 1.0;
    for (int i = 0; i < 3; i++)
        p->number[i] = 0.5 * coordinate();
    if (p->kind == SPHERE)
        p->number[3] = size;
    else
        put_end(p);
    if (p->kind == CYLINDER)
        p->number[6] = size;
    if (p->kind == CONE)
        p->number[3] = U() < 0.3 ? 0.0 : U(), p->number[7] = size;
}

static const transform *make_map(model *m)
{
    const transform *t = NULL;
    const double all = U() < 0.5 ? 1.0 : 0.5 + U();

    if (U() < 0.3)
        return NULL;
    if (U() < 0.7)
        t = test_transform(m, t, TRANSFORM_SCALE, all * (0.6 + U()), all, all * (U() < 0.5 ? 1.0 : 0.6 + U()));
    if (U() < 0.7)
        t = test_transform(m, t, TRANSFORM_ROTATE, U() < 0.3 ? 90.0 : 360.0 * U(), 360.0 * U(), U() < 0.3 ? 0.0 : 360.0 * U());
    return test_transform(m, t, TRANSFORM_TRANSLATE, 0.5 * coordinate(), 0.5 * coordinate(), 0.5 * coordinate());
}

static void make_any(const scene *s, probe *p)
{
    if (s->rings && U() < 0.3) {
        *p = (probe){ .kind = TORUS, .count = 2, .size = 1.0, .number = { 0.3 + 0.8 * U(), 0.1 + 0.4 * U() } };
        return;
    }
    if (!s->endless || U() < 0.6) {
        make_probe(p);
        return;
    }
    memset(p, 0, sizeof *p);
    p->kind = U() < 0.5 ? PLANE : QUADRIC;
    p->count = p->kind == PLANE ? 4 : 10;
    p->size = 1.0;
    make_endless(p);
}

static node_ref add_of(scene *s, probe p, const shape_class *shape, const transform *map, uint32_t flags)
{
    shape_class written = *shape;
    void *self;

    self = fake_reader_memory(s->in, shape->instance_size + shape->parsed_size);
    if (shape->prepare)
        written.instance_size = shape->parsed_size;
    written.prepare = NULL;
    assert_true(probe_make(&p, &written, s->in, self));
    return test_add(&s->model, shape, self, map, s->material, flags);
}

static node_ref add_moved(scene *s, probe p, const transform *map, uint32_t flags)
{
    return add_of(s, p, fake_reader_shape(probe_keyword(p.kind)), map, flags);
}

static node_ref add_probe(scene *s, probe p)
{
    const transform *map = U() < 0.6 ? s->map : make_map(&s->model);

    return add_moved(s, p, map, s->endless && U() < 0.1 ? LEAF_INVERSE : 0);
}

static node_ref add_member(scene *s)
{
    probe p;

    make_any(s, &p);
    return add_probe(s, p);
}

static void make_tree(scene *s)
{
    const uint32_t within = 1 + below(2), n = within + 1 + below(MOST - within);
    group_node both = { .op = NODE_INTERSECTION, .line = 1, .column = 1 }, all = { .op = NODE_DIFFERENCE, .line = 1, .column = 1 };
    node_ref children[MOST], root;

    for (uint32_t i = 0; i < within; i++)
        children[i] = add_member(s);
    if (within > 1)
        assert_true(model_add_group(&s->model, &both, children, within, &children[0]));
    for (uint32_t i = within; i < n; i++)
        children[1 + i - within] = add_member(s);
    assert_true(model_add_group(&s->model, &all, children, 1 + n - within, &root));
    assert_true(model_add_tree(&s->model, root));
}

/* A member, or a group of up to three nodes. */
static node_ref add_any(scene *s, int depth)
{
    static const node_op ops[] = { NODE_UNION, NODE_MERGE, NODE_INTERSECTION, NODE_DIFFERENCE, NODE_CLIP };
    const uint32_t n = 2 + below(2);
    group_node g = { .op = ops[below(5)], .inverse = U() < 0.1, .line = 1, .column = 1 };
    node_ref children[3], group;

    if (depth == 0 || s->model.leaves.count + n > MEMBERS_MOST || U() < 0.2)
        return add_member(s);
    for (uint32_t i = 0; i < n; i++)
        children[i] = add_any(s, depth - 1);
    assert_true(model_add_group(&s->model, &g, children, n, &group));
    return group;
}

/* Two parts; or one within a convex member, so that it has a box. */
static void make_any_tree(scene *s)
{
    static const node_op ops[] = { NODE_MERGE, NODE_INTERSECTION, NODE_DIFFERENCE };
    const bool boxed = U() < 0.6;
    group_node all = { .op = !boxed ? ops[below(3)] : U() < 0.5 ? NODE_INTERSECTION : NODE_CLIP, .line = 1, .column = 1 };
    node_ref children[2], root;

    s->endless = true;
    children[0] = add_any(s, 3);
    if (!boxed)
        children[1] = add_any(s, 1);
    s->endless = false;
    if (boxed)
        children[1] = add_member(s);
    assert_true(model_add_group(&s->model, &all, children, 2, &root));
    assert_true(model_add_tree(&s->model, root));
}

/* The same with tori, and of glass: light is to be dimmed by every crossing. */
static void make_glass_tree(scene *s)
{
    s->material = test_add_material(&s->model, colour_of(1.0f, 1.0f, 1.0f), 0.5f, 0.0f, true);
    test_add_light(&s->model, 1.0f);
    s->rings = U() < 0.7;
    if (U() < 0.3)
        make_tree(s);
    else
        make_any_tree(s);
}

static bool has_gaps(const void *self)
{
    (void)self;
    return true;
}

/* A member or two that a torus clips as if it had gaps: it is asked what it holds beside their crossings. */
static void make_gapped_tree(scene *s)
{
    const probe torus = { .kind = TORUS, .count = 2, .size = 1.0, .number = { 0.5 + 0.8 * U(), 0.1 + 0.4 * U() } };
    const group_node clipped = { .op = NODE_CLIP, .line = 1, .column = 1 }, both = { .op = NODE_INTERSECTION, .line = 1, .column = 1 };
    node_ref children[2], root;

    s->surface = *fake_reader_shape("torus");
    s->surface.open = has_gaps;
    s->endless = U() < 0.4;
    children[0] = add_member(s);
    if (U() < 0.6) {
        children[1] = add_member(s);
        assert_true(model_add_group(&s->model, &both, children, 2, &children[0]));
    }
    s->endless = false;
    children[1] = add_of(s, torus, &s->surface, U() < 0.6 ? s->map : make_map(&s->model), U() < 0.2 ? LEAF_INVERSE : 0);
    assert_true(model_add_group(&s->model, &clipped, children, 2, &root));
    assert_true(model_add_tree(&s->model, root));
}

/* The other way: a torus as if it had gaps, which shows where what it holds begins or ends, that a member or two clip. */
static void make_gapped_surface_tree(scene *s)
{
    const probe torus = { .kind = TORUS, .count = 2, .size = 1.0, .number = { 0.5 + 0.8 * U(), 0.1 + 0.4 * U() } };
    const group_node clipped = { .op = NODE_CLIP, .line = 1, .column = 1 };
    const uint32_t n = 2 + below(2);
    node_ref children[3], root;

    s->surface = *fake_reader_shape("torus");
    s->surface.open = has_gaps;
    children[0] = add_of(s, torus, &s->surface, U() < 0.6 ? s->map : make_map(&s->model), U() < 0.2 ? LEAF_INVERSE : 0);
    s->endless = U() < 0.4;
    for (uint32_t i = 1; i < n; i++)
        children[i] = add_member(s);
    s->endless = false;
    assert_true(model_add_group(&s->model, &clipped, children, n, &root));
    assert_true(model_add_tree(&s->model, root));
}

/* A box that many planes cut, some of them along its edges or faces; or that and a member or two cut out of it. */
static void make_polyhedron(scene *s)
{
    const group_node both = { .op = NODE_INTERSECTION, .line = 1, .column = 1 }, less = { .op = NODE_DIFFERENCE, .line = 1, .column = 1 };
    const probe box = { .kind = BOX, .count = 6, .size = 1.0, .number = { -0.75, -0.5, -0.75, 0.75, 0.5, 0.75 } };
    const uint32_t n = MOST + 1 + below(7), cut = U() < 0.5 ? 0 : 1 + below(2);
    node_ref children[MOST + 7], root;

    children[0] = add_moved(s, box, s->map, 0);
    for (uint32_t i = 1; i < n; i++) {
        const pov_vec3 d = families_direction();
        probe plane = { .kind = PLANE, .count = 4, .size = 1.0, .number = { d.x, d.y, d.z, 0.4 + 0.6 * U() } };

        if (U() < 0.3)
            plane = (probe){ .kind = PLANE, .count = 4, .size = 1.0, .number = { U() < 0.5 ? 1.0 : -1.0, U() < 0.5 ? 1.0 : -1.0, 0.0, 1.25 / sqrt(2.0) } };
        else if (U() < 0.2)
            plane = (probe){ .kind = PLANE, .count = 4, .size = 1.0, .number = { 1.0, 0.0, 0.0, 0.75 } };
        children[i] = add_moved(s, plane, U() < 0.9 ? s->map : NULL, 0);
    }
    assert_true(model_add_group(&s->model, &both, children, n, &root));
    children[0] = root;
    for (uint32_t i = 1; i <= cut; i++)
        children[i] = add_member(s);
    if (cut > 0)
        assert_true(model_add_group(&s->model, &less, children, 1 + cut, &root));
    assert_true(model_add_tree(&s->model, root));
}

/* A torus without poles, which has no outline, within one convex member or two, or within planes and quadrics; or what these have of it,
 * which others may clip, or one of them without the others. */
static void make_torus_tree(scene *s, node_op op)
{
    group_node all = { .op = op, .line = 1, .column = 1 };
    const probe torus = { .kind = TORUS, .count = 2, .size = 1.0, .number = { 0.5 + 0.8 * U(), 0.1 + 0.4 * U() } };
    const uint32_t n = U() < 0.8 ? 2 : 3, place = op == NODE_CLIP ? 0 : below(n);
    node_ref children[3], root;

    s->endless = U() < 0.4;
    for (uint32_t i = 0; i < n; i++)
        children[i] = i == place ? add_probe(s, torus) : add_member(s);
    s->endless = false;
    assert_true(model_add_group(&s->model, &all, children, n, &root));
    if (op == NODE_INTERSECTION && U() < 0.2) {
        group_node clipped = { .op = NODE_CLIP, .line = 1, .column = 1 };

        children[0] = root;
        children[1] = add_member(s);
        assert_true(model_add_group(&s->model, &clipped, children, 2, &root));
    }
    assert_true(model_add_tree(&s->model, root));
}

static void make_clipped_tree(scene *s) { make_torus_tree(s, NODE_CLIP); }
static void make_cut_tree(scene *s) { make_torus_tree(s, U() < 0.6 ? NODE_INTERSECTION : NODE_DIFFERENCE); }

/* Out of a torus up to three others are cut, of which some may show and planes may be; it may be of a class that is not asked between
 * distances. */
static void make_hollowed_tree(scene *s)
{
    group_node all = { .op = NODE_DIFFERENCE, .line = 1, .column = 1 };
    const probe torus = { .kind = TORUS, .count = 2, .size = 1.0, .number = { 0.5 + 0.8 * U(), 0.1 + 0.4 * U() } };
    const uint32_t n = 2 + below(3);
    node_ref children[4], root;

    s->surface = *fake_reader_shape("torus");
    if (U() < 0.7)
        s->surface.intersect_between = NULL, s->surface.intersect_between_many = NULL;
    s->endless = U() < 0.3;
    children[0] = add_of(s, torus, &s->surface, U() < 0.6 ? s->map : make_map(&s->model), 0);
    for (uint32_t i = 1; i < n; i++)
        children[i] = add_member(s);
    s->endless = false;
    assert_true(model_add_group(&s->model, &all, children, n, &root));
    assert_true(model_add_tree(&s->model, root));
}

static pov_ray new_ray(void)
{
    const pov_vec3 target = pov_vec3_of(coordinate(), coordinate(), coordinate());
    pov_vec3 dir = U() < 0.2 ? pov_vec3_of((double)below(3) - 1.0, (double)below(3) - 1.0, (double)below(3) - 1.0)
                             : families_direction();

    if (!(pov_largest(dir) > 0.0))
        dir.x = 1.0;
    return side_ray(target, dir, 1.0);
}

/* Side by side each is as by itself, and its light as on the other side, up to the first one's hit or twice as far. */
static void compare_together(const scene *s, const kept *of, uint32_t first, uint32_t n, tally *out)
{
    const double most = of->truth[first].object == POV_NO_OWNER ? 1.0 : (1.0 + below(2)) * of->truth[first].crossing.t;
    hit hits[WORLD_MANY];

    side_compare(&s->filtered, &s->exact, of, first, n, most, hits);
    for (uint32_t i = 0; i < n; i++) {
        const hit *truth = &of->truth[first + i];

        if (truth->object == POV_NO_OWNER)
            continue;
        world_surface(s->filtered.world, &of->rays[first + i], &hits[i]);
        assert_int_equal(hits[i].entering, truth->entering);
        out->together++;
    }
}

/* With others of its octant a ray goes in a packet. */
static void keep(scene *s, const pov_ray *ray, const hit *h, bool met, tally *out)
{
    kept *of = &s->of[bvh_octant(ray)];

    if (side_keep(of, ray, h, met)) {
        compare_together(s, of, 0, WORLD_MANY, out);
        compare_together(s, of, 20, 13, out);
    }
}

/* Both give the same bits where all is to be found in double-double, from the start on and beyond a place. */
static void compare_exactly(const scene *s, const pov_ray *ray, double beyond)
{
    hit h, truth;
    const bool met = query_nearest_beyond(s->filtered.world, s->filtered.context, NULL, ray, beyond, HUGE_VAL, &h);

    assert_int_equal(met, query_nearest_beyond(s->exact.world, s->exact.context, NULL, ray, beyond, HUGE_VAL, &truth));
    if (!met)
        return;
    assert_int_equal(h.object, truth.object);
    assert_int_equal(h.crossing.mark.flags, truth.crossing.mark.flags);
    assert_true(h.crossing.t == truth.crossing.t && h.crossing.t_lo == truth.crossing.t_lo);
}

/* Do both say the same? True: there is a hit. */
static bool compare(const scene *s, const pov_ray *ray, hit *h, tally *out)
{
    const bool met = test_nearest(s->filtered.world, s->filtered.context, ray, HUGE_VAL, h);
    uint32_t owners[TEST_CROSSINGS], count, true_owners[TEST_CROSSINGS], true_count;
    hit truth;

    out->rays++;
    assert_int_equal(met, test_nearest(s->exact.world, s->exact.context, ray, HUGE_VAL, &truth));
    if (!met)
        return false;
    out->hits++;
    world_surface(s->filtered.world, ray, h);
    world_surface(s->exact.world, ray, &truth);
    assert_int_equal(h->object, truth.object);
    assert_int_equal(h->entering, truth.entering);
    assert_true(fabs(h->crossing.t - truth.crossing.t) <= 0x1p-49 * truth.crossing.t);
    for (int i = 0; i <= 2; i++)
        compare_exactly(s, ray, 0.5 * i * truth.crossing.t);
    for (int i = -1; i <= 2; i++) {
        const double most = h->crossing.t * (i > 1 ? 4.0 : 1.0 + i * 1e-6);
        const bool clear = test_light(s->filtered.world, s->filtered.context, ray, most, owners, &count);

        assert_int_equal(clear, test_light(s->exact.world, s->exact.context, ray, most, true_owners, &true_count));
        assert_int_equal(count, true_count);
        assert_memory_equal(owners, true_owners, sizeof owners);
        out->blocked += !clear;
        out->crossed += count;
    }
    return true;
}

static void ask(scene *s, tally *out)
{
    for (int i = 0; i < RAYS_OF_A_TREE; i++) {
        pov_ray ray = new_ray();
        hit h;

        for (int turn = 0; turn < 5; turn++) {
            const bool met = compare(s, &ray, &h, out);

            keep(s, &ray, &h, met, out);
            if (!met)
                break;
            ray.org = h.point;
            ray.org_lo = h.point_lo;
            ray.dir = turn % 2 ? families_direction() : ray.dir;
            test_leave(&ray, &h);
        }
    }
}

static void begin_scene(scene *s)
{
    memset(s, 0, sizeof *s);
    test_model_init(&s->model, NULL);
    s->in = fake_reader_create();
}

static void compile(scene *s)
{
    side_compile(&s->filtered, &s->model, POV_ACCEL_TREE, false);
    side_compile(&s->exact, &s->model, POV_ACCEL_TREE, true);
}

static void end_scene(scene *s)
{
    side_discard(&s->filtered);
    side_discard(&s->exact);
    model_free(&s->model);
    fake_reader_destroy(s->in);
}

typedef void make_tree_fn(scene *s);

static tally ask_all(make_tree_fn *make)
{
    tally all = { .rays = 0 };

    families_seed(20261125);
    while (all.rays < rays) {
        scene s;

        begin_scene(&s);
        s.map = make_map(&s.model);
        make(&s);
        compile(&s);
        ask(&s, &all);
        end_scene(&s);
    }
    print_message("%ld rays, %ld hits, %ld blocked, %ld crossings of light; %ld hits of rays side by side\n", all.rays, all.hits, all.blocked,
                  all.crossed, all.together);
    return all;
}

static void outlines_find_what_the_walk_finds(void **state)
{
    const tally all = ask_all(make_tree);

    (void)state;
    assert_true(all.hits > rays / 5 && all.blocked > all.hits / 2);
}

static void outlines_of_any_nodes_find_what_the_walk_finds(void **state)
{
    const tally all = ask_all(make_any_tree);

    (void)state;
    assert_true(all.hits > rays / 10 && all.blocked > all.hits / 2);
}

static void outlines_of_glass_find_what_the_walk_finds(void **state)
{
    const tally all = ask_all(make_glass_tree);

    (void)state;
    assert_true(all.hits > rays / 10 && all.crossed > 2 * all.hits);
}

static void outlines_of_what_gaps_clip_find_what_the_walk_finds(void **state)
{
    const tally all = ask_all(make_gapped_tree);

    (void)state;
    assert_true(all.hits > rays / 20);
}

static void outlines_of_clips_of_what_has_gaps_find_what_the_walk_finds(void **state)
{
    const tally all = ask_all(make_gapped_surface_tree);

    (void)state;
    assert_true(all.hits > rays / 40 && all.blocked > all.hits / 2);
}

static void outlines_of_many_planes_find_what_the_walk_finds(void **state)
{
    const tally all = ask_all(make_polyhedron);

    (void)state;
    assert_true(all.hits > rays / 5 && all.blocked > all.hits / 2);
}

static void outlines_of_clips_find_what_the_walk_finds(void **state)
{
    const tally all = ask_all(make_clipped_tree);

    (void)state;
    assert_true(all.hits > rays / 40 && all.blocked > all.hits / 2);
}

static void outlines_of_what_cuts_a_surface_find_what_the_walk_finds(void **state)
{
    const tally all = ask_all(make_cut_tree);

    (void)state;
    assert_true(all.hits > rays / 20 && all.blocked > all.hits / 2);
}

static void outlines_of_hollows_find_what_the_walk_finds(void **state)
{
    const tally all = ask_all(make_hollowed_tree);

    (void)state;
    assert_true(all.hits > rays / 10 && all.blocked > all.hits / 2);
}

/* The member that shows at 0.5 on a ray that starts outside of the first, a torus. */
static uint32_t shown_at_half(node_op op, const probe *members)
{
    const pov_ray ray = { .org = { -1.0, -0.04, -0.08 }, .dir = { 1.0, 0.1, 0.2 }, .origin_surface = POV_NO_OWNER };
    group_node all = { .op = op, .line = 1, .column = 1 };
    tally out = { .rays = 0 };
    node_ref children[3], root;
    scene s;
    hit h;

    begin_scene(&s);
    for (int i = 0; i < 3; i++)
        children[i] = add_moved(&s, members[i], NULL, 0);
    assert_true(model_add_group(&s.model, &all, children, 3, &root));
    assert_true(model_add_tree(&s.model, root));
    compile(&s);
    assert_true(compare(&s, &ray, &h, &out));
    assert_true(h.crossing.t == 0.5);
    end_scene(&s);
    return h.object;
}

#define RING { .kind = TORUS, .count = 2, .size = 1.0, .number = { 0.5, 0.18 } }

/* A ray that is inside the torus enters a box and a cylinder in one plane: the first in the text shows. */
static void a_plane_of_two_clips_is_the_first_ones(void **state)
{
    static const probe members[] = {
        RING, { .kind = BOX, .count = 6, .size = 1.0, .number = { -0.5, -0.1, -0.1, 0.5, 0.1, 0.1 } },
        { .kind = CYLINDER, .count = 7, .size = 1.0, .number = { -0.5, 0.0, 0.0, 0.25, 0.0, 0.0, 0.1 } },
    };

    (void)state;
    assert_int_equal(shown_at_half(NODE_INTERSECTION, members), 1);
}

/* Or it leaves both, which are cut out of the torus. */
static void a_plane_of_two_hollows_is_the_first_ones(void **state)
{
    static const probe members[] = {
        RING, { .kind = BOX, .count = 6, .size = 1.0, .number = { -1.5, -0.1, -0.1, -0.5, 0.1, 0.1 } },
        { .kind = CYLINDER, .count = 7, .size = 1.0, .number = { -1.25, 0.0, 0.0, -0.5, 0.0, 0.0, 0.1 } },
    };

    (void)state;
    assert_int_equal(shown_at_half(NODE_DIFFERENCE, members), 1);
}

/* A sphere, and what others on both sides of it hold: without these nothing shows. */
static void what_lies_between_others_has_nothing_in_common(void **state)
{
    static const probe members[] = {
        { .kind = SPHERE, .count = 4, .size = 1.0, .number = { 0.0, 0.0, 0.0, 0.5 } },
        { .kind = SPHERE, .count = 4, .size = 1.0, .number = { 2.0, 0.0, 0.0, 1.0 } },
        { .kind = SPHERE, .count = 4, .size = 1.0, .number = { -2.0, 0.0, 0.0, 1.0 } },
    };
    const pov_ray ray = { .org = { 0.1, 0.2, -2.0 }, .dir = { 0.0, 0.0, 1.0 }, .origin_surface = POV_NO_OWNER };
    group_node less = { .op = NODE_DIFFERENCE, .line = 1, .column = 1 };
    tally out = { .rays = 0 };
    node_ref children[3], root;
    scene s;
    hit h;

    (void)state;
    begin_scene(&s);
    for (int i = 0; i < 3; i++)
        children[i] = add_moved(&s, members[i], NULL, i == 1 ? LEAF_INVERSE : 0);
    assert_true(model_add_group(&s.model, &less, children + 1, 2, &children[1]));
    assert_true(model_add_group(&s.model, &less, children, 2, &root));
    assert_true(model_add_tree(&s.model, root));
    compile(&s);
    assert_false(compare(&s, &ray, &h, &out));
    end_scene(&s);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(outlines_find_what_the_walk_finds),
        cmocka_unit_test(outlines_of_any_nodes_find_what_the_walk_finds),
        cmocka_unit_test(outlines_of_glass_find_what_the_walk_finds),
        cmocka_unit_test(outlines_of_what_gaps_clip_find_what_the_walk_finds),
        cmocka_unit_test(outlines_of_clips_of_what_has_gaps_find_what_the_walk_finds),
        cmocka_unit_test(outlines_of_many_planes_find_what_the_walk_finds),
        cmocka_unit_test(outlines_of_clips_find_what_the_walk_finds),
        cmocka_unit_test(outlines_of_what_cuts_a_surface_find_what_the_walk_finds),
        cmocka_unit_test(outlines_of_hollows_find_what_the_walk_finds),
        cmocka_unit_test(a_plane_of_two_clips_is_the_first_ones),
        cmocka_unit_test(a_plane_of_two_hollows_is_the_first_ones),
        cmocka_unit_test(what_lies_between_others_has_nothing_in_common),
    };

    if (argc > 1)
        rays = strtol(argv[1], NULL, 10);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
