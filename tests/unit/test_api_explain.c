/* What --explain says of plugins: which are used, and what their distances are worth. */
#include "api/explain.h"
#include "support/check.h"
#include "support/shapes.h"

static const explain_row *row_on(const explanation *p, const char *subject)
{
    for (size_t i = 0; i < p->rows.count; i++)
        if (strcmp(p->rows.items[i].subject, subject) == 0)
            return &p->rows.items[i];
    fail_msg("no row on %s", subject);
    return NULL;
}

static void assert_reason(const shape_class *shape, const char *reason)
{
    pov_error err = { 0 };
    model m;
    explanation p;

    test_model_init(&m, NULL);
    test_add_sphere(&m, pov_vec3_of(0.0, 0.0, 0.0), 1.0, 0);
    m.leaves.items[0].shape = shape;
    explain_init(&p, m.env);
    assert_int_equal(explain_plugins(&p, &m, NULL, &err), POV_OK);
    assert_true(row_on(&p, "plugin ball")->used);
    assert_string_equal(row_on(&p, "plugin ball")->reason, reason);
    explain_free(&p);
    model_free(&m);
}

static void a_class_that_is_not_certified_is_named(void **state)
{
    shape_class certified = test_sphere_class;

    (void)state;
    certified.flags |= POV_SHAPE_CERTIFIED;
    assert_reason(&certified, "objects: 1");
    assert_reason(&test_sphere_class, "objects: 1; its distances are not certified: as right as its own arithmetic");
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(a_class_that_is_not_certified_is_named) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
