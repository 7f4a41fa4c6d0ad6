/* sdl/parse_csg: objects made of others, and what holds for their members. */
#include "support/check.h"
#include "support/reading.h"

#include <math.h>

static void read_text(reading *r, const char *text)
{
    reading_begin(r, text);
    if (r->status != POV_OK)
        fail_msg("%s: %d:%d %s", text, r->error.line, r->error.column, r->error.message);
}

static const material *material_of(const reading *r, size_t leaf)
{
    return &r->model.materials.items[r->model.leaves.items[leaf].material];
}

static void a_difference_is_one_object_of_its_leaves(void **state)
{
    const group_node *g;
    reading r;

    (void)state;
    read_text(&r, "sphere { 0, 9 }\n difference { sphere { 0, 1 } sphere { 1, 1 } box { 0, 1 } }\n sphere { 0, 9 }");
    assert_int_equal(r.model.leaves.count, 5);
    assert_int_equal(model_object_count(&r.model), 3);
    assert_int_equal(r.model.trees.count, 1);
    g = &r.model.groups.items[r.model.trees.items[0] & ~NODE_GROUP];
    assert_int_equal(g->op, NODE_DIFFERENCE);
    assert_int_equal(g->leaf, 1);
    assert_int_equal(g->leaf_count, 3);
    assert_int_equal(g->line, 2);
    assert_int_equal(g->column, 2);
    reading_end(&r);
}

static void unions_dissolve_unless_they_stand_in_another(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "union { sphere { 0, 1 } union { sphere { 1, 1 } merge { sphere { 2, 1 } box { 0, 1 } } } }\n"
                  "intersection { union { sphere { 0, 1 } sphere { 1, 1 } } box { 0, 1 } }");
    assert_int_equal(r.model.trees.count, 2);
    assert_int_equal(model_object_count(&r.model), 4);
    reading_end(&r);
}

static void a_union_with_an_interior_is_one_object(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "union { sphere { 0, 1 } sphere { 1, 1 } interior { ior 1.5 } }");
    assert_int_equal(r.model.trees.count, 0);
    assert_int_equal(model_object_count(&r.model), 1);
    assert_true(material_of(&r, 0)->interior.ior == 1.5 && material_of(&r, 1)->interior.ior == 1.5);
    reading_end(&r);
}

static void a_member_takes_what_it_lacks_from_the_nearest_group(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "union {\n"
                  "  sphere { 0, 1 }\n"
                  "  merge { sphere { 0, 1 pigment { rgb 3 } } box { 0, 1 } pigment { rgb 2 } }\n"
                  "  difference { sphere { 0, 1 } box { 0, 1 interior { ior 1.1 } } }\n"
                  "  pigment { rgb 1 } interior { ior 1.5 } }\n");
    assert_true(material_of(&r, 0)->pigment.r == 1.0f);
    assert_true(material_of(&r, 1)->pigment.r == 3.0f);
    assert_true(material_of(&r, 2)->pigment.r == 2.0f && material_of(&r, 2)->interior.ior == 1.5);
    assert_true(material_of(&r, 3)->pigment.r == 1.0f);
    assert_true(material_of(&r, 4)->pigment.r == 1.0f && material_of(&r, 4)->interior.ior == 1.1);
    reading_end(&r);
}

/* First the member's own, then those of each group from the inner to the outer. */
static void transformations_of_groups_follow_their_members(void **state)
{
    pov_affine map;
    reading r;

    (void)state;
    read_text(&r, "union { merge { sphere { 0, 1 translate <1, 0, 0> } sphere { 0, 1 } scale 2 translate <0, 1, 0> }\n"
                  "  box { 0, 1 } rotate <0, 0, 90> translate <5, 0, 0> }");
    assert_true(transform_compose(r.model.leaves.items[0].map, &map));
    assert_true(map.m[0][3] == 4.0 && map.m[1][3] == 2.0);   /* (1, 0) to (2, 1), turned to (-1, 2), moved */
    assert_true(map.m[1][0] == 2.0 && map.m[0][1] == -2.0);
    assert_true(transform_compose(r.model.leaves.items[2].map, &map));
    assert_true(map.m[0][3] == 5.0 && map.m[1][3] == 0.0);
    reading_end(&r);
}

static void flags_of_groups_hold_where_they_belong(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "difference { sphere { 0, 1 } box { 0, 1 inverse } no_shadow inverse }\n"
                  "union { sphere { 0, 1 inverse } inverse }");
    assert_int_equal(r.model.leaves.items[0].flags, LEAF_NO_SHADOW);
    assert_int_equal(r.model.leaves.items[1].flags, LEAF_NO_SHADOW | LEAF_INVERSE);
    assert_true(r.model.groups.items[0].inverse);
    assert_int_equal(r.model.leaves.items[2].flags, 0);   /* of one member it is that member */
    reading_end(&r);
}

static void assert_hidden(const char *text, uint32_t first, uint32_t second)
{
    reading r;

    read_text(&r, text);
    if (r.model.leaves.items[0].flags != first || r.model.leaves.items[1].flags != second)
        fail_msg("%s: flags %u and %u, not %u and %u", text, r.model.leaves.items[0].flags, r.model.leaves.items[1].flags, first, second);
    reading_end(&r);
}

/* As in POV-Ray, where only unions ask their members. */
static void a_solid_throws_its_shadow_as_a_whole(void **state)
{
    const uint32_t none = LEAF_NO_SHADOW;

    (void)state;
    assert_hidden("union { sphere { 0, 1 no_shadow } sphere { 1, 1 } }", none, 0);
    assert_hidden("union { union { sphere { 0, 1 } sphere { 1, 1 } no_shadow } sphere { 2, 1 } }", none, none);
    assert_hidden("merge { sphere { 0, 1 no_shadow } sphere { 1, 1 no_shadow } }", 0, 0);
    assert_hidden("intersection { sphere { 0, 1 no_shadow } sphere { 1, 1 no_shadow } }", 0, 0);
    assert_hidden("union { difference { sphere { 0, 1 no_shadow } sphere { 1, 1 no_shadow } } sphere { 3, 1 } }", 0, 0);
    assert_hidden("merge { union { sphere { 0, 1 } sphere { 1, 1 } no_shadow } sphere { 2, 1 } }", 0, 0);
    assert_hidden("union { merge { sphere { 0, 1 } sphere { 1, 1 no_shadow } no_shadow } sphere { 2, 1 } }", none, none);
}

/* As in POV-Ray, whose intersections and differences ask no member which rays see it. */
static void a_solid_is_seen_as_a_whole(void **state)
{
    const uint32_t image = LEAF_NO_IMAGE;

    (void)state;
    assert_hidden("union { sphere { 0, 1 no_image } box { 0, 1 } }", image, 0);
    assert_hidden("merge { sphere { 0, 1 no_reflection } box { 0, 1 } }", LEAF_NO_REFLECTION, 0);
    assert_hidden("intersection { sphere { 0, 1 no_image } box { 0, 1 } no_reflection }", LEAF_NO_REFLECTION, LEAF_NO_REFLECTION);
    assert_hidden("difference { sphere { 0, 1 } box { 0, 1 no_radiosity } }", 0, 0);
    assert_hidden("difference { union { sphere { 0, 1 no_image } box { 0, 1 } no_image } sphere { 1, 1 } }", 0, 0);
    assert_hidden("difference { union { sphere { 0, 1 no_reflection } box { 0, 1 } } sphere { 1, 1 } }", LEAF_NO_REFLECTION, 0);
    assert_hidden("difference { union { sphere { 0, 1 } box { 0, 1 } no_reflection } sphere { 1, 1 } }", LEAF_NO_REFLECTION, LEAF_NO_REFLECTION);
    assert_hidden("difference { merge { sphere { 0, 1 no_image } box { 0, 1 } } sphere { 1, 1 } }", image, 0);
    assert_hidden("merge { union { sphere { 0, 1 no_image } box { 0, 1 } } sphere { 1, 1 } }", 0, 0);
    assert_hidden("merge { sphere { 1, 1 } union { sphere { 0, 1 } box { 0, 1 } no_image } }", 0, image);
    assert_hidden("union { difference { sphere { 0, 1 } box { 0, 1 } no_image } sphere { 1, 1 } }", image, image);
}

/* What lies in a member that the camera does not see is seen, as in POV-Ray. */
static void a_merge_is_parted_by_what_the_camera_sees(void **state)
{
    const group_node *g;
    reading r;

    (void)state;
    read_text(&r, "union { merge { sphere { 0, 1 no_image } box { 0, 1 } box { 1, 2 } } }");
    assert_int_equal(r.model.trees.count, 1);
    g = &r.model.groups.items[r.model.trees.items[0] & ~NODE_GROUP];
    assert_int_equal(g->op, NODE_MERGE);
    assert_int_equal(g->leaf_count, 2);
    assert_int_equal(r.model.leaves.items[g->leaf].flags | r.model.leaves.items[g->leaf + 1].flags, 0);
    assert_int_equal(r.model.leaves.items[2].flags, LEAF_NO_IMAGE);
    reading_end(&r);
    read_text(&r, "union { merge { sphere { 0, 1 no_image } box { 0, 1 } no_image } }");
    g = &r.model.groups.items[r.model.trees.items[0] & ~NODE_GROUP];
    assert_int_equal(g->leaf_count, 2);
    reading_end(&r);
    read_text(&r, "union { merge { sphere { 0, 1 no_image } box { 0, 1 } inverse } }");
    assert_int_equal(r.model.groups.items[r.model.trees.items[0] & ~NODE_GROUP].op, NODE_MERGE);
    reading_end(&r);
    read_text(&r, "intersection { merge { sphere { 0, 1 no_image } box { 0, 1 } } box { 1, 2 } }");
    assert_int_equal(r.model.trees.count, 1);
    reading_end(&r);
}

static void a_group_of_nothing_is_nothing(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "union { }\n difference { sphere { 0, 1 } union { merge { } } }");
    assert_int_equal(r.model.leaves.count, 1);
    assert_int_equal(r.model.groups.count, 0);
    reading_end(&r);
}

/* Of a solid as much is left as of what its empty members are: all of it, or its lights. */
static void a_group_of_nothing_in_a_solid_decides_what_is_left(void **state)
{
    static const struct { const char *text; unsigned leaves; } solids[] = {
        { "intersection { sphere { 0, 1 } union { } }", 0 }, { "intersection { union { } sphere { 0, 1 } }", 0 },
        { "intersection { sphere { 0, 1 } intersection { } }", 1 }, { "difference { sphere { 0, 1 } intersection { } }", 0 },
        { "difference { sphere { 0, 1 } union { } }", 1 }, { "difference { sphere { 0, 1 } object { merge { } inverse } }", 0 },
        { "difference { union { } sphere { 0, 1 } }", 0 }, { "merge { sphere { 0, 1 } difference { } }", 0 },
        { "merge { sphere { 0, 1 } union { } }", 1 }, { "union { sphere { 0, 1 } intersection { } }", 1 },
        { "sphere { 0, 1 clipped_by { union { } } }", 0 }, { "sphere { 0, 1 clipped_by { intersection { } } }", 1 },
        { "intersection { sphere { 0, 1 } intersection { box { 0, 1 } union { } } }", 0 },
        { "intersection { sphere { 0, 1 } union { box { 0, 1 } union { } } }", 2 },
        { "union { intersection { sphere { 0, 1 } union { } } box { 0, 1 } }", 1 },
        { "intersection { sphere { 0, 1 } light_source { 0, 1 } }", 1 },
    };

    (void)state;
    for (size_t i = 0; i < sizeof solids / sizeof solids[0]; i++) {
        reading r;

        read_text(&r, solids[i].text);
        if (r.model.leaves.count != solids[i].leaves)
            fail_msg("%s: %u leaves instead of %u", solids[i].text, (unsigned)r.model.leaves.count, solids[i].leaves);
        reading_end(&r);
    }
}

static void lights_in_a_solid_of_which_nothing_is_left_shine(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "intersection { union { sphere { 0, 1 } light_source { 0, 1 looks_like { box { 0, 1 } } } } union { } }");
    assert_int_equal(r.model.leaves.count, 0);
    assert_int_equal(r.model.lights.count, 1);
    reading_end(&r);
}

/* What moves an object behind its clip moves the clip too. */
static void a_clip_is_moved_by_what_follows_it(void **state)
{
    const group_node *g;
    pov_affine map;
    reading r;

    (void)state;
    read_text(&r, "union { sphere { 0, 1 translate <1, 0, 0> clipped_by { box { 0, 1 translate <0, 0, 3> } } scale 2 }\n"
                  "  translate <0, 1, 0> }");
    assert_int_equal(r.model.trees.count, 1);
    g = &r.model.groups.items[r.model.trees.items[0] & ~NODE_GROUP];
    assert_int_equal(g->op, NODE_CLIP);
    assert_int_equal(g->leaf_count, 2);
    assert_true(transform_compose(r.model.leaves.items[0].map, &map));
    assert_true(map.m[0][3] == 2.0 && map.m[1][3] == 1.0 && map.m[2][3] == 0.0);
    assert_true(transform_compose(r.model.leaves.items[1].map, &map));
    assert_true(map.m[0][3] == 0.0 && map.m[1][3] == 1.0 && map.m[2][3] == 6.0);
    reading_end(&r);
}

static void a_named_object_keeps_its_clip_when_a_copy_gets_another(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "#declare A = sphere { 0, 1 clipped_by { box { 0, 1 } } }\n"
                  "object { A clipped_by { sphere { 0, 2 } } }\n object { A }");
    assert_int_equal(r.model.leaves.count, 5);
    assert_int_equal(r.model.trees.count, 2);
    assert_int_equal(model_object_count(&r.model), 2);
    reading_end(&r);
}

static void what_is_no_object_is_refused(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "union { sphere { 0, 1 } 5 }");
    assert_int_equal(r.status, POV_E_SYNTAX);
    assert_int_equal(r.error.column, 25);
    reading_end(&r);
    reading_begin(&r, "union { sphere { 0, 1 } sphere { 1, 1 } pigmnt { rgb 1 } }");
    assert_true(r.status < 0);
    assert_int_equal(r.error.column, 41);
    reading_end(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_difference_is_one_object_of_its_leaves),
        cmocka_unit_test(unions_dissolve_unless_they_stand_in_another),
        cmocka_unit_test(a_union_with_an_interior_is_one_object),
        cmocka_unit_test(a_member_takes_what_it_lacks_from_the_nearest_group),
        cmocka_unit_test(transformations_of_groups_follow_their_members),
        cmocka_unit_test(flags_of_groups_hold_where_they_belong),
        cmocka_unit_test(a_solid_throws_its_shadow_as_a_whole),
        cmocka_unit_test(a_solid_is_seen_as_a_whole),
        cmocka_unit_test(a_merge_is_parted_by_what_the_camera_sees),
        cmocka_unit_test(a_group_of_nothing_is_nothing),
        cmocka_unit_test(a_group_of_nothing_in_a_solid_decides_what_is_left),
        cmocka_unit_test(lights_in_a_solid_of_which_nothing_is_left_shine),
        cmocka_unit_test(a_clip_is_moved_by_what_follows_it),
        cmocka_unit_test(a_named_object_keeps_its_clip_when_a_copy_gets_another),
        cmocka_unit_test(what_is_no_object_is_refused),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
