#include "sdl/builder.h"

static term constant_term(builder *b, const intrinsic *row)
{
    term t = { row->size > 1 ? VALUE_VECTOR : VALUE_NUMBER, false, false, row->size, { 0 } };
    int i;

    for (i = 0; i < row->size; i++)
        t.reg[i] = builder_constant(b, row->v[i]);
    return t;
}

static term of_one(builder *b, calc_op op, const intrinsic *row)
{
    const uint16_t a = builder_to_number(b, builder_full(b));

    return builder_number_in(builder_emit(b, op, a, 0, builder_row(b, row)));
}

static term of_two(builder *b, calc_op op, const intrinsic *row)
{
    const uint16_t a = builder_number(b);

    builder_accept(b, ',');
    return builder_number_in(builder_emit(b, op, a, builder_number(b), builder_row(b, row)));
}

static term of_many(builder *b, const intrinsic *row, bool is_cut)
{
    uint16_t a = builder_number(b);
    bool has_comma = builder_accept(b, ',');

    while ((has_comma || !builder_is_next(b, ')')) && !b->is_refused) {
        a = builder_emit(b, CALC_TWO, a, builder_number(b), builder_row(b, row));
        has_comma = builder_accept(b, ',');
    }
    return builder_number_in(is_cut ? builder_emit(b, CALC_CUT, a, 0, 0) : a);
}

static term of_select(builder *b)
{
    uint16_t v[4];
    int i;

    for (i = 0; i < 3; i++) {
        v[i] = builder_number(b);
        if (i < 2)
            builder_accept(b, ',');
    }
    if (!builder_is_next(b, ')')) {
        builder_accept(b, ',');
        v[3] = builder_number(b);
        v[2] = builder_emit(b, CALC_PICK, builder_emit(b, CALC_SAME, v[0], 0, 0), v[2], v[3]);
    }
    return builder_number_in(builder_emit(b, CALC_PICK, builder_emit(b, CALC_BELOW, v[0], 0, 0), v[1], v[2]));
}

static term of_random(builder *b)
{
    if (b->randoms++ == CALC_RANDOMS)
        return builder_refuse(b);
    return builder_number_in(builder_emit(b, CALC_RAND, builder_to_number(b, builder_full(b)), 0, 0));
}

static term of_vectors(builder *b, intrinsic_form form)
{
    const uint16_t a = builder_vector(b);
    uint16_t second, to;

    if (form == INTRINSIC_VLENGTH)
        return builder_number_in(builder_emit(b, CALC_VLENGTH, a, 0, 0));
    if (form == INTRINSIC_VNORMALIZE) {
        to = builder_registers(b, 3);
        builder_emit_to(b, CALC_VNORMALIZE, to, a, 0, 0);
        return builder_vector_in(to, 3, false, 3);
    }
    builder_accept(b, ',');
    second = builder_vector(b);
    if (form == INTRINSIC_VDOT)
        return builder_number_in(builder_emit(b, CALC_VDOT, a, second, 0));
    to = builder_registers(b, 3);
    builder_emit_to(b, CALC_VCROSS, to, a, second, 0);
    return builder_vector_in(to, 3, false, 3);
}

static term of_form(builder *b, const intrinsic *row)
{
    switch (row->form) {
    case INTRINSIC_ONE:
        return of_one(b, CALC_ONE, row);
    case INTRINSIC_ARC:
        return of_one(b, CALC_ARC, row);
    case INTRINSIC_LOGARITHM:
        return of_one(b, CALC_LOGARITHM, row);
    case INTRINSIC_ROOT:
        return of_one(b, CALC_ROOT, row);
    case INTRINSIC_TWO:
        return of_two(b, CALC_TWO, row);
    case INTRINSIC_ATAN2:
        return of_two(b, CALC_ATAN2, row);
    case INTRINSIC_POW:
        return of_two(b, CALC_POW, row);
    case INTRINSIC_MANY: case INTRINSIC_BITS:
        return of_many(b, row, row->form == INTRINSIC_BITS);
    case INTRINSIC_SELECT:
        return of_select(b);
    case INTRINSIC_RAND:
        return of_random(b);
    case INTRINSIC_VLENGTH: case INTRINSIC_VDOT: case INTRINSIC_VCROSS: case INTRINSIC_VNORMALIZE:
        return of_vectors(b, row->form);
    default:
        return builder_refuse(b);
    }
}

term builder_function(builder *b, const intrinsic *row)
{
    term t;

    if (row->form == INTRINSIC_CONSTANT)
        return constant_term(b, row);
    builder_expect(b, '(');
    t = b->is_refused ? builder_refuse(b) : of_form(b, row);
    builder_expect(b, ')');
    return t;
}
