/* Tapes give what programs give, forms hold all values and derivatives over their stretches, and slopes are derivatives. */
#include "support/check.h"

#include "base/mix.h"
#include "function/form.h"
#include "function/internal.h"
#include "function/slope.h"

#include <math.h>
#include <string.h>

enum { INTERNALS = 79, ARGUMENTS = 13, REGISTERS = 1024, PLACES = 40 };

static env memory;
static uint64_t state = 7;

static int begin(void **user)
{
    (void)user;
    env_init(&memory, NULL, NULL, NULL);
    return 0;
}

static double draw(double lo, double hi)
{
    state += 0x9e3779b97f4a7c15u;
    return lo + (hi - lo) * (double)(mix_bits(state) >> 11) * 0x1p-53;
}

/* x, y and z and constants in their places, then one instruction of them. */
typedef struct formula { program p; instruction code[ARGUMENTS + 1]; double constants[ARGUMENTS]; } formula;

static void make_internal(formula *f, uint32_t number)
{
    const uint32_t n = internal_arguments(number);

    memset(f, 0, sizeof *f);
    for (uint32_t i = 3; i < n; i++) {
        const instruction c = { PROGRAM_CONSTANT, 0, i, i - 3, 0 };

        f->code[i - 3] = c;
        f->constants[i - 3] = number == INTERNAL_POLYTUBES && i == 3 ? 5.0 : draw(0.1, 1.5);
    }
    {
        const instruction call = { PROGRAM_INTERNAL, 0, 0, 0, number };

        f->code[n - 3] = call;
    }
    f->p.parameters = 3;
    f->p.registers = f->p.capacity = n;
    f->p.count = n - 2;
    f->p.code = f->code;
    f->p.constants = f->constants;
}

static void make_one(formula *f, const char *name)
{
    const instruction code = { PROGRAM_ONE, 0, 0, 0, (uint32_t)program_one_argument(name) };

    memset(f, 0, sizeof *f);
    f->code[0] = code;
    f->p.parameters = f->p.registers = f->p.capacity = 3;
    f->p.count = 1;
    f->p.code = f->code;
}

static void make_two(formula *f, const char *name)
{
    const instruction code = { PROGRAM_TWO, (uint16_t)program_two_arguments(name), 0, 0, 1 };

    memset(f, 0, sizeof *f);
    f->code[0] = code;
    f->p.parameters = f->p.registers = f->p.capacity = 3;
    f->p.count = 1;
    f->p.code = f->code;
}

static double value_of(const formula *f, const double at[3])
{
    double registers[REGISTERS];

    memcpy(registers, at, 3 * sizeof *at);
    return program_run(&f->p, registers);
}

static pov_slope slope_of(const tape *t, const double at[3], const double dir[3])
{
    static pov_slope registers[REGISTERS];

    for (int i = 0; i < 3; i++)
        for (int l = 0; l < POV_SLOPES; l++) {
            registers[i].value[l] = at[i];
            registers[i].slope[l] = dir[i];
        }
    slope_run(t, registers);
    return registers[t->result];
}

/* Over a stretch in each lane, each shorter than the one before. */
static pov_form form_of(const tape *t, const double at[3], const double dir[3])
{
    static pov_form registers[REGISTERS];

    for (int i = 0; i < 3; i++)
        for (int l = 0; l < POV_FORMS; l++) {
            registers[i].middle[l] = at[i];
            registers[i].slope[l] = ldexp(dir[i], -2 * l);
            registers[i].off[l] = registers[i].slope_off[l] = 0.0;
        }
    form_run(t, registers);
    return registers[t->result];
}

/* What is not known holds everything. */
static bool holds(double middle, double off, double value, double slack)
{
    return !(fabs(value - middle) > off + slack) || middle != middle || value != value;
}

static void check_stretches(const formula *f, const tape *t, const double at[3], const double dir[3])
{
    const pov_form form = form_of(t, at, dir);

    for (int l = 0; l < POV_FORMS; l++)
        for (int k = 0; k <= PLACES; k++) {
            const double u = (2.0 * k - PLACES) / PLACES, h = ldexp(1.0, -2 * l);
            const double place[3] = { at[0] + u * h * dir[0], at[1] + u * h * dir[1], at[2] + u * h * dir[2] };
            const double value = value_of(f, place);
            const pov_slope slope = slope_of(t, place, dir);

            assert_true(holds(form.middle[l] + u * form.slope[l], form.off[l], value, 1e-12 * (1.0 + fabs(value))));
            assert_true(fabs(slope.value[0] - value) <= 1e-10 * (1.0 + fabs(value)) || value != value || slope.value[0] != slope.value[0] ||
                        form.slope_off[l] == HUGE_VAL);
            assert_true(holds(form.slope[l], form.slope_off[l], h * slope.slope[0], 1e-10 * (1.0 + fabs(value))));
        }
}

static void check(const formula *f, double reach)
{
    tape t;

    assert_int_equal(tape_record(&memory, &f->p, &t), TAPE_RECORDED);
    assert_true(t.registers <= REGISTERS);
    for (int i = 0; i < 60; i++) {
        const double at[3] = { draw(-reach, reach), draw(-reach, reach), draw(-reach, reach) };
        const double dir[3] = { draw(-1.0, 1.0), draw(-1.0, 1.0), draw(-1.0, 1.0) };

        check_stretches(f, &t, at, dir);
    }
    env_free(&memory, (void *)(uintptr_t)t.steps);
}

static void forms_hold_the_internal_functions(void **user)
{
    formula f;

    (void)user;
    for (uint32_t n = 0; n < INTERNALS; n++) {
        internal_form form;

        if (!internal_text(n, &form) && n != INTERNAL_HEX_X && n != INTERNAL_HEX_Y && n != INTERNAL_POLYTUBES)
            continue;
        for (int i = 0; i < 4; i++) {
            make_internal(&f, n);
            check(&f, 2.0);
        }
    }
}

static void forms_hold_the_functions_of_one_and_two_arguments(void **user)
{
    static const char *const ones[] = { "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh",
                                        "abs", "int", "floor", "ceil", "sqrt", "exp", "ln", "log", "radians", "degrees" };
    static const char *const twos[] = { "atan2", "pow", "mod", "div", "min", "max" };
    formula f;

    (void)user;
    for (size_t i = 0; i < sizeof ones / sizeof *ones; i++) {
        make_one(&f, ones[i]);
        check(&f, 1.5);
        check(&f, 6.0);
    }
    for (size_t i = 0; i < sizeof twos / sizeof *twos; i++) {
        make_two(&f, twos[i]);
        check(&f, 3.0);
    }
}

/* x x + y over a stretch is x0 x0 + y0 + 1/2 x'x', with its slope, off by half a square: nothing is lost. */
static void a_square_is_as_narrow_as_it_can_be(void **user)
{
    const instruction code[] = { { PROGRAM_MULTIPLY, 0, 3, 0, 0 }, { PROGRAM_ADD, 0, 0, 3, 1 } };
    const program p = { 3, 4, 4, 0, 2, code, NULL, NULL, NULL };
    const double at[3] = { 2.0, 1.0, 0.0 }, dir[3] = { 1.0, 0.0, 0.0 };
    pov_form form;
    tape t;

    (void)user;
    assert_int_equal(tape_record(&memory, &p, &t), TAPE_RECORDED);
    form = form_of(&t, at, dir);
    assert_true(form.middle[0] == 5.5 && form.slope[0] == 4.0);
    assert_true(form.off[0] >= 0.5 && form.off[0] < 0.5 + 1e-13 && form.slope_off[0] >= 2.0 && form.slope_off[0] < 2.0 + 1e-13);
    env_free(&memory, (void *)(uintptr_t)t.steps);
}

static void what_is_equal_or_constant_is_recorded_once(void **user)
{
    /* (x x + x x) * (2 + 3): one product, one sum, one factor. */
    const instruction code[] = { { PROGRAM_MULTIPLY, 0, 3, 0, 0 }, { PROGRAM_MULTIPLY, 0, 4, 0, 0 }, { PROGRAM_ADD, 0, 3, 3, 4 },
                                 { PROGRAM_CONSTANT, 0, 4, 0, 0 }, { PROGRAM_CONSTANT, 0, 5, 1, 0 }, { PROGRAM_ADD, 0, 4, 4, 5 },
                                 { PROGRAM_MULTIPLY, 0, 3, 3, 4 } };
    const double constants[] = { 2.0, 3.0 };
    const program p = { 3, 6, 6, 3, 7, code, constants, NULL, NULL };
    tape t;

    (void)user;
    assert_int_equal(tape_record(&memory, &p, &t), TAPE_RECORDED);
    assert_int_equal(t.count, 3);
    assert_int_equal(t.registers, 5);
    env_free(&memory, (void *)(uintptr_t)t.steps);
}

/* The rest of 1 by a step that is a little above 1/5 is nearly that step, not 0. */
static void a_rest_is_exact(void **user)
{
    const instruction code[] = { { PROGRAM_CONSTANT, 0, 1, 0, 0 }, { PROGRAM_TWO, (uint16_t)program_two_arguments("mod"), 0, 0, 1 } };
    const double fifth = 0.2, at[3] = { 1.0, 0.0, 0.0 }, dir[3] = { 1.0, 0.0, 0.0 };
    const program p = { 3, 3, 3, 0, 2, code, &fifth, NULL, NULL };
    tape t;

    (void)user;
    assert_int_equal(tape_record(&memory, &p, &t), TAPE_RECORDED);
    assert_true(slope_of(&t, at, dir).value[0] == fmod(1.0, 0.2) && slope_of(&t, at, dir).value[0] > 0.1);
    assert_true(slope_of(&t, at, dir).slope[0] == 1.0);
    env_free(&memory, (void *)(uintptr_t)t.steps);
}

/* Within a box without rounding f_rounded_box is the root of 0 + 0 + 0, a constant. */
static void the_root_of_zero_has_no_slope(void **user)
{
    enum { ROUNDED_BOX = 60 };
    const double at[3] = { 0.1, 0.2, -0.3 }, dir[3] = { 0.2, 0.1, 0.3 };
    formula f;
    pov_form form;
    tape t;

    (void)user;
    make_internal(&f, ROUNDED_BOX);
    f.constants[0] = 0.0;
    f.constants[1] = f.constants[2] = f.constants[3] = 1.0;
    assert_int_equal(tape_record(&memory, &f.p, &t), TAPE_RECORDED);
    form = form_of(&t, at, dir);
    assert_true(fabs(form.middle[0] + 1e-6) < 1e-15 && form.slope[0] == 0.0 && form.off[0] < 1e-15 && form.slope_off[0] < 1e-15);
    assert_true(slope_of(&t, at, dir).slope[0] == 0.0);
    env_free(&memory, (void *)(uintptr_t)t.steps);
}

static void a_host_and_an_open_repetition_have_no_tape(void **user)
{
    const instruction host[] = { { PROGRAM_HOST, 0, 0, 0, 0 } };
    const instruction jump[] = { { PROGRAM_JUMP_WITHIN, 0, 0, 0, 1 } };
    const program asks = { 3, 3, 3, 0, 1, host, NULL, NULL, NULL }, repeats = { 3, 3, 3, 0, 1, jump, NULL, NULL, NULL };
    tape t;

    (void)user;
    assert_int_equal(tape_record(&memory, &asks, &t), TAPE_NONE);
    assert_int_equal(tape_record(&memory, &repeats, &t), TAPE_NONE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forms_hold_the_internal_functions),
        cmocka_unit_test(forms_hold_the_functions_of_one_and_two_arguments),
        cmocka_unit_test(a_square_is_as_narrow_as_it_can_be),
        cmocka_unit_test(what_is_equal_or_constant_is_recorded_once),
        cmocka_unit_test(a_rest_is_exact),
        cmocka_unit_test(the_root_of_zero_has_no_slope),
        cmocka_unit_test(a_host_and_an_open_repetition_have_no_tape),
    };

    return cmocka_run_group_tests(tests, begin, NULL);
}
