/* A program gives each of several lanes what it gives alone: bit-identical. */
#include "support/check.h"
#include "support/reading.h"

#include "base/mix.h"
#include "sdl/function.h"
#include "texture/inner.h"

#include <stdio.h>
#include <string.h>

enum { ROOM = 1 << 15, TURNS = 20 };

static const char *const declared =
    "#version 3.7;\n#declare F = function(x, y, z) { x*y - sum(k, 1, 3, k*z) };\n"
    "#declare G = function { pattern { crackle turbulence .3 } };\n"
    "#declare P = function { pigment { bozo color_map { [0 rgb <1, .5, .2>] [1 rgbt <0, .3, 1, .4>] } } };\n"
    "#declare S = function { spline { cubic_spline -2, <0, 1, 2> 0, <1, 0, 3> 1, <2, 2, 1> 3, <0, 0, 1> } };\n"
    "#declare T = function { transform { rotate <10, 20, 30> translate <1, 2, 3> } };\n"
    "#declare I = function { internal(17) }; #declare N = function { internal(76) }; #declare R = function { internal(59) };\n"
    "#declare H = function { internal(29) }; #declare D = function { internal(58) }; #declare V = function { internal(78) };\n"
    "#declare Nested = function { pigment { function { P(x, y, 2*z).green + G(y, z, x) } } };\n";

static const char *const formulas[] = {
    "x + y*z - x/(y + 3)", "-x*(x < y) + (y <= z)*2 + (x = z) + (y != x)", "(x > 0 & y > 0) + (x | z)",
    "sin(x) + atan2(y, z) + pow(abs(x), y) + min(x, y, z) + mod(x*5, 2) + sqrt(abs(z))", "select(x, y, z) + select(y, 1, 2, x)",
    "F(x, y, z) + F(z, F(y, x, 1), x)", "sum(i, 1, 4, i*x) + prod(i, 1, 3, i + y)", "G(x, y, z)*2", "P(x, y, z).red + P(z, x, y).transmit",
    "S(x).y + T(x, y, z).z", "I(x, y, z, 1, 2, .5) + N(x, y, z)", "R(x, y, z, 1, 2, 4, 1, 2, 2)",
    "H(x, y, z, .5, 2, 3.5, .4, 2, 1) + D(y, x, z, 2, 3.5, .6, .7, .8, 3) + V(z, y, x, 2)",
    "R(x, y, z, 1, 2, 1 + abs(y), 1, z, 2) + H(x, y, z, x, 2, 2, y, 1, 1) + D(x, y, z, 2, abs(z), y, .5, .5, 2) + V(x, y, z, 2 + y)",
    "Nested(x, y, z).blue", "x", "0.25",
};

static const program *program_of(const reading *r, uint32_t i)
{
    const material *m = &r->model.materials.items[r->model.leaves.items[i].material];

    return &((const function *)((const function_pattern *)m->texture->pigment->pattern->self)->self)->program;
}

static void read_formulas(reading *r)
{
    static char text[ROOM];
    size_t used = (size_t)snprintf(text, ROOM, "%s", declared);

    for (size_t i = 0; i < sizeof formulas / sizeof formulas[0]; i++)
        used += (size_t)snprintf(text + used, ROOM - used, "sphere { %d*x, 1 pigment { function { %s } } }\n", (int)i, formulas[i]);
    reading_begin(r, text);
    if (r->status != POV_OK)
        fail_msg("%d:%d %s", r->error.line, r->error.column, r->error.message);
}

static double draw(uint64_t *state)
{
    *state += 0x9e3779b97f4a7c15u;
    return 6.0 * (double)(mix_bits(*state) >> 11) * 0x1p-53 - 3.0;
}

static void check_program(const program *p, const char *formula, uint64_t *state)
{
    static double many[ROOM], one[ROOM];
    double at[3][PROGRAM_LANES], out[PROGRAM_LANES];

    assert_true(program_lanes_capacity(p) <= ROOM && p->parameters == 3);
    for (uint32_t turn = 0; turn < TURNS; turn++) {
        const uint32_t n = 1 + turn % PROGRAM_LANES;

        for (uint32_t i = 0; i < 3 * PROGRAM_LANES; i++)
            at[i / PROGRAM_LANES][i % PROGRAM_LANES] = draw(state);
        memcpy(many, at, sizeof at);
        program_run_many(p, many, n, NULL, out);
        for (uint32_t i = 0; i < n; i++) {
            double alone;

            one[0] = at[0][i];
            one[1] = at[1][i];
            one[2] = at[2][i];
            alone = program_run(p, one);
            if (memcmp(&alone, &out[i], sizeof alone) != 0)
                fail_msg("%s: %.17g alone, %.17g beside others", formula, alone, out[i]);
        }
    }
}

static void lanes_have_the_bits_of_single_runs(void **user)
{
    uint64_t state = 3;
    reading r;
    (void)user;

    read_formulas(&r);
    for (uint32_t i = 0; i < sizeof formulas / sizeof formulas[0]; i++)
        check_program(program_of(&r, i), formulas[i], &state);
    reading_end(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(lanes_have_the_bits_of_single_runs) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
