#include "sdl/parse_inner.h"

#include "sdl/function_host.h"
#include "sdl/parse_texture.h"
#include "sdl/report.h"
#include "texture/inner.h"

#include <string.h>

/* ---- objects that are asked for points ---- */

static const void *prepared(pov_reader *in, const object_parsed *o)
{
    void *at;

    if (!o->leaf.shape->prepare)
        return o->leaf.instance;
    at = state_alloc(in, o->leaf.shape->instance_size, 64);
    if (at)
        o->leaf.shape->prepare(at, o->leaf.instance);
    return at;
}

static void set_map(pov_reader *in, const object_parsed *o, solid_part *out)
{
    pov_affine map;

    if (!o->map)
        return;
    out->has_map = transform_compose(o->map, &map);
    if (out->has_map)
        memcpy(out->map, map.inv, sizeof out->map);
    else
        report_fail(in, &in->last, POV_E_SYNTAX, "the object is moved beyond what a double holds");
}

static const solid_part *make_solid(pov_reader *in, const object_parsed *o)
{
    solid_part *out = in->failed ? NULL : state_alloc(in, sizeof *out, 16);
    const solid_part **end;

    if (!out)
        return NULL;
    out->is_inverse = (o->flags & LEAF_INVERSE) != 0;
    set_map(in, o, out);
    out->op = o->op;
    end = &out->first;
    if (o->kind == OBJECT_LEAF) {
        out->inside = o->leaf.shape->inside;
        out->self = prepared(in, o);
    }
    for (const object_parsed *m = o->kind == OBJECT_GROUP ? o->first : NULL; m && !in->failed; m = m->next) {
        solid_part *member = (solid_part *)(void *)make_solid(in, m);

        *end = member;
        end = member ? &member->next : end;
    }
    return out;
}

static void move_object(pov_reader *in, void *self, keyword_id keyword) { parse_transform(in, self, keyword); }

static const item moves[] = { PARSE_MOVES(move_object) };
static const item_list move_list = { "a transformation", ITEMS(moves), NULL, NULL, NULL, VALUE_NOTHING, NULL };

/* What moves the object may stand behind it too. */
static void read_object(pov_reader *in, object_pattern *self)
{
    object_parsed o;

    if (parse_object_try(in, &o)) {
        while (!in->failed && items_try(in, &move_list, &o.map))
            ;
        self->solid = make_solid(in, &o);
    } else if (!in->failed) {
        report_expected(in, "an object");
    }
    state_accept(in, ',');
}

/* ---- functions ---- */

/* Registers that a function of a pattern may use; they are on the stack of who asks. */
enum { REGISTERS_MAX = 1024 };

/* Coordinate a of point i is at[a * PROGRAM_LANES + i]; n is at most that. */
static void run_each(const program *p, const double *at, uint32_t n, double *out)
{
    double registers[REGISTERS_MAX];

    for (uint32_t i = 0; i < n; i++) {
        for (int k = 0; k < 3; k++)
            registers[k] = at[k * PROGRAM_LANES + i];
        out[i] = program_run(p, registers);
    }
}

/* The registers of a large program would fill too much of the stack side by side. */
static void run(const function *f, const double *at, uint32_t n, function_memo *memo, double *out)
{
    enum { SIDE_BY_SIDE = 2 * REGISTERS_MAX };
    double registers[SIDE_BY_SIDE];

    if (f->kind != FUNCTION_FORMULA) {
        function_host_values(f, at, 0, n, memo, out);
    } else if (n == 1 || program_lanes_capacity(&f->program) > SIDE_BY_SIDE) {
        run_each(&f->program, at, n, out);
    } else {
        memcpy(registers, at, 3 * PROGRAM_LANES * sizeof *registers);
        program_run_many(&f->program, registers, n, memo, out);
    }
}

static void values_of_function(const void *self, const vec_lanes *points, uint32_t n, function_memo *memo, double *out)
{
    double at[3][PROGRAM_LANES] = { { 0.0 } };

    for (uint32_t first = 0, some; first < n; first += some) {
        some = n - first < PROGRAM_LANES ? n - first : PROGRAM_LANES;
        memcpy(at[0], points->x + first, some * sizeof at[0][0]);
        memcpy(at[1], points->y + first, some * sizeof at[0][0]);
        memcpy(at[2], points->z + first, some * sizeof at[0][0]);
        run(self, at[0], some, memo, out + first);
    }
}

static void read_function(pov_reader *in, function_pattern *self)
{
    const place at = in->last;
    const value v = function_read(in);
    const function *f = v.as.part;

    if (in->failed)
        return;
    if (f->kind == FUNCTION_FORMULA && (f->program.parameters > 3 || f->program.capacity > REGISTERS_MAX))
        report_fail(in, &at, POV_E_SYNTAX, f->program.parameters > 3 ? "the function of a pattern has at most three parameters" :
                    "this function is too large for a pattern");
    *self = (function_pattern){ values_of_function, f };
}

bool parse_inner(pov_reader *in, const pattern_class *class, void *self, block *b, bool *is_open)
{
    *is_open = false;
    if (class == &pattern_function) {
        read_function(in, self);
        return true;
    }
    if (class != &pattern_object && class != &pattern_pigment_pattern)
        return false;
    *is_open = true;
    items_open(in, b);
    if (class == &pattern_object)
        read_object(in, self);
    else
        ((pigment_pattern *)self)->pigment = parse_pigment_content(in, VALUE_PIGMENT, NULL, '}');
    return true;
}
