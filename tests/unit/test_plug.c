/* plug: what is found, what is refused, and why. */
#include "support/check.h"
#include "support/failing.h"

#include "plug/check.h"
#include "plug/registry.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    (void)self;
    (void)host;
    (void)in;
}

static bool bounds(const void *self, pov_box *out)
{
    (void)self;
    (void)out;
    return false;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    (void)self;
    (void)ray;
    (void)hits;
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)self;
    (void)ray;
    (void)at;
    *out = pov_vec3_of(0, 0, 1);
}

static void prepare(void *self, const void *text)
{
    (void)self;
    (void)text;
}

static const void *fast_with_a_large_single_block(const char *name)
{
    static const pov_shape_fast fast = { .size = sizeof fast, .block_size = 64, .single_block_size = 128 };

    return strcmp(name, POV_SHAPE_FAST) == 0 ? &fast : NULL;
}

static const void *a_fast_extension(const char *name)
{
    static const pov_shape_fast fast = { .size = sizeof fast, .full_leaves = true, .block_size = 64 };

    return strcmp(name, POV_SHAPE_FAST) == 0 ? &fast : NULL;
}

static pov_shape_class good_class(void)
{
    pov_shape_class c = { 0 };

    c.size = sizeof c;
    c.keyword = "thing";
    c.instance_size = 8;
    c.parse = parse;
    c.bounds = bounds;
    c.intersect = intersect;
    c.normal = normal;
    return c;
}

static pov_plugin plugin_of(const pov_shape_class *const *shapes)
{
    pov_plugin p = { POV_PLUGIN_ABI, sizeof p, "thing", "1", shapes, NULL, NULL };

    return p;
}

static const char *verdict(const pov_shape_class *c)
{
    const pov_shape_class *shapes[2] = { NULL, NULL };
    pov_plugin p;

    shapes[0] = c;
    p = plugin_of(shapes);
    return check_plugin(&p);
}

static void a_class_must_keep_the_contract(void **state)
{
    pov_shape_class c = good_class();

    (void)state;
    assert_null(verdict(&c));
    c.size = 40;
    assert_string_equal(verdict(&c), "a shape class is shorter than the contract's first version");
    c = good_class();
    c.keyword = "";
    assert_string_equal(verdict(&c), "a shape class has no keyword");
    c = good_class();
    c.normal = NULL;
    assert_string_equal(verdict(&c), "a shape class lacks parse, bounds, intersect or normal");
    c = good_class();
    c.flags = POV_SHAPE_SOLID;
    assert_string_equal(verdict(&c), "a shape class is a solid without inside");
    c = good_class();
    c.instance_size = 0;
    assert_string_equal(verdict(&c), "a shape class has an impossible instance size");
    c = good_class();
    c.extension = fast_with_a_large_single_block;
    assert_string_equal(verdict(&c), "a shape class has a larger block for one shape than for several");
    c = good_class();
    c.prepare = prepare;
    assert_string_equal(verdict(&c), "a shape class has prepare with an impossible size");
}

/* A plugin of an older host knows fewer members, and one of a newer one more. */
static void a_class_is_completed_with_its_extension_and_with_nothing_unknown(void **state)
{
    struct { pov_shape_class known; void *later[4]; } longer = { good_class(), { NULL } };
    shape_class out;

    (void)state;
    longer.known.size = sizeof longer;
    longer.known.extension = a_fast_extension;
    memset(&out, 0xff, sizeof out);
    shape_class_fill(&out, &longer.known);
    assert_true(out.normal == normal && out.full_leaves && out.block_size == 64);
    assert_true(!out.prepare && !out.uv && !out.scratch && !out.block_filter && !out.ellipsoid);
    longer.known.extension = NULL;
    shape_class_fill(&out, &longer.known);
    assert_true(!out.full_leaves && out.block_size == 0);
}

static void an_added_class_is_found_and_a_later_one_wins(void **state)
{
    pov_shape_class first = good_class(), second = good_class();
    const shape_class *of_first;
    const pov_shape_class *shapes[2][2] = { { NULL, NULL }, { NULL, NULL } };
    const shape_class *found;
    pov_plugin p, q;
    registry *r;
    env e;

    (void)state;
    second.instance_size = 16;
    shapes[0][0] = &first;
    shapes[1][0] = &second;
    p = plugin_of(shapes[0]);
    q = plugin_of(shapes[1]);
    env_init(&e, NULL, NULL, NULL);
    r = registry_create(&e, "/nowhere", NULL);
    assert_int_equal(registry_shape(r, "thing", &found, NULL), POV_OK);
    assert_null(found);
    assert_int_equal(registry_add(r, &p, NULL), POV_OK);
    assert_int_equal(registry_shape(r, "thing", &found, NULL), POV_OK);
    assert_int_equal(found->instance_size, 8);
    of_first = found;
    assert_int_equal(registry_add(r, &q, NULL), POV_OK);
    assert_int_equal(registry_shape(r, "thing", &found, NULL), POV_OK);
    assert_ptr_not_equal(found, of_first);
    assert_int_equal(found->instance_size, 16);
    assert_int_equal(registry_shape(r, "../thing", &found, NULL), POV_OK);
    assert_null(found);
    registry_destroy(r);
}

static void adding_without_memory_leaves_nothing_half_known(void **state)
{
    pov_shape_class c = good_class();
    const pov_shape_class *shapes[2] = { NULL, NULL };
    const shape_class *found;
    pov_plugin p;
    long n;

    (void)state;
    shapes[0] = &c;
    p = plugin_of(shapes);
    for (n = 1;; n++) {
        pov_allocator a;
        registry *r;
        failing f;
        env e;
        pov_status status = POV_E_MEMORY;

        failing_init(&f, n);
        a = failing_allocator(&f);
        env_init(&e, &a, NULL, NULL);
        r = registry_create(&e, "/nowhere", NULL);
        if (r) {
            status = registry_add(r, &p, NULL);
            assert_int_equal(registry_shape(r, "thing", &found, NULL), POV_OK);
            assert_true((found != NULL) == (status == POV_OK));
        }
        registry_destroy(r);
        assert_int_equal(f.blocks, 0);
        if (status == POV_OK)
            break;
        assert_int_equal(status, POV_E_MEMORY);
    }
    assert_true(n > 3);
}

static void a_file_that_is_no_plugin_is_an_error_with_its_path(void **state)
{
    char folder[] = "/tmp/povtrace-plug-XXXXXX", sub[64], file[96];
    const shape_class *found;
    pov_error err;
    registry *r;
    FILE *out;
    env e;

    (void)state;
    assert_non_null(mkdtemp(folder));
    snprintf(sub, sizeof sub, "%s/primitives", folder);
    snprintf(file, sizeof file, "%s/thing.so", sub);
    assert_int_equal(mkdir(sub, 0700), 0);
    out = fopen(file, "w");
    assert_non_null(out);
    fputs("\177ELF and no more", out);
    fclose(out);
    env_init(&e, NULL, NULL, NULL);
    r = registry_create(&e, folder, NULL);
    assert_int_equal(registry_shape(r, "thing", &found, &err), POV_E_PLUGIN);
    assert_null(found);
    assert_string_equal(err.file, file);
    assert_non_null(strstr(err.message, "cannot load this plugin"));
    registry_destroy(r);
    unlink(file);
    rmdir(sub);
    rmdir(folder);
}

static void remember(void *user, const char *keyword)
{
    if (strcmp(keyword, "sphere") == 0)
        *(int *)user += 1;
}

static void the_built_plugins_are_listed_and_load(void **state)
{
    const shape_class *found;
    int seen = 0;
    registry *r;
    env e;

    (void)state;
    env_init(&e, NULL, NULL, NULL);
    r = registry_create(&e, "::" TEST_BUILD "/lib/povtrace:/nowhere", NULL);
    registry_each_keyword(r, "primitives", remember, &seen);
    assert_int_equal(seen, 1);
    assert_int_equal(registry_shape(r, "sphere", &found, NULL), POV_OK);
    assert_string_equal(found->keyword, "sphere");
    registry_destroy(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_class_must_keep_the_contract),
        cmocka_unit_test(a_class_is_completed_with_its_extension_and_with_nothing_unknown),
        cmocka_unit_test(an_added_class_is_found_and_a_later_one_wins),
        cmocka_unit_test(adding_without_memory_leaves_nothing_half_known),
        cmocka_unit_test(a_file_that_is_no_plugin_is_an_error_with_its_path),
        cmocka_unit_test(the_built_plugins_are_listed_and_load),
    };

    return cmocka_run_group_tests_name("plug", tests, NULL, NULL);
}
