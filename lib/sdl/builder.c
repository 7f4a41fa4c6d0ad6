#include "sdl/builder.h"

#include <string.h>

/* ---- parts ---- */

term builder_refuse(builder *b)
{
    static const term none = { VALUE_NUMBER, false, false, 1, { 0 } };

    b->is_refused = true;
    return none;
}

uint16_t builder_registers(builder *b, int count)
{
    const uint16_t first = b->next;

    if (b->next + count > CALC_REGISTERS)
        builder_refuse(b);
    else
        b->next = (uint16_t)(b->next + count);
    return first;
}

uint16_t builder_constant(builder *b, double number)
{
    uint16_t i;

    for (i = 0; i < b->calc.constants; i++)
        if (memcmp(&b->constant[i], &number, sizeof number) == 0)
            return i;
    if (i == CALC_CONSTANTS) {
        builder_refuse(b);
        return 0;
    }
    b->constant[b->calc.constants++] = number;
    return i;
}

uint16_t builder_row(builder *b, const intrinsic *row)
{
    if (b->calc.rows == BUILDER_ROWS) {
        builder_refuse(b);
        return 0;
    }
    b->row[b->calc.rows] = row;
    return b->calc.rows++;
}

void builder_emit_to(builder *b, calc_op op, uint16_t to, uint16_t a, uint16_t second, uint16_t c)
{
    const calc_step s = { (uint16_t)op, to, a, second, c };

    if (b->calc.steps == BUILDER_STEPS)
        builder_refuse(b);
    else
        b->step[b->calc.steps++] = s;
}

uint16_t builder_emit(builder *b, calc_op op, uint16_t a, uint16_t second, uint16_t c)
{
    const uint16_t to = builder_registers(b, 1);

    builder_emit_to(b, op, to, a, second, c);
    return to;
}

term builder_number_in(uint16_t reg)
{
    term t = { VALUE_NUMBER, false, false, 1, { 0 } };

    t.reg[0] = reg;
    return t;
}

term builder_vector_in(uint16_t first, int size, bool is_colour, int kept)
{
    term t = { VALUE_VECTOR, is_colour, false, size, { 0 } };
    int i;

    for (i = 0; i < kept; i++)
        t.reg[i] = (uint16_t)(first + i);
    return t;
}

/* ---- tokens ---- */

const token *builder_peek(builder *b, size_t ahead)
{
    static const token none;

    return b->s->at + ahead < b->s->end ? &b->s->tokens[b->s->at + ahead] : &none;
}

/* Behind the last token of a macro's body goes on what stands behind its call. */
const token *builder_next(builder *b)
{
    while (b->s > b->streams && !b->is_refused) {
        if (b->s->at == b->s->end) {
            b->locals = b->s->locals;
            b->s--;
        } else if (builder_peek(b, 0)->kind == '#') {
            builder_local(b);
        } else {
            break;
        }
    }
    return builder_peek(b, 0);
}

bool builder_is_next(builder *b, int kind)
{
    return builder_next(b)->kind == kind;
}

bool builder_accept(builder *b, int kind)
{
    if (!builder_is_next(b, kind))
        return false;
    b->s->at++;
    return true;
}

void builder_expect(builder *b, int kind)
{
    if (!builder_accept(b, kind))
        builder_refuse(b);
}

uint16_t builder_to_number(builder *b, term t)
{
    if (t.kind != VALUE_NUMBER)
        builder_refuse(b);
    return t.reg[0];
}

uint16_t builder_number(builder *b)
{
    return builder_to_number(b, builder_additive(b));
}

/* Three registers in a row. */
uint16_t builder_vector(builder *b)
{
    const term t = builder_additive(b);
    const uint16_t to = builder_registers(b, 3);
    int i;

    if (t.size > 3)
        builder_refuse(b);
    for (i = 0; i < 3; i++) {
        const uint16_t part = i < t.size || t.is_part ? t.reg[i] : 0;

        builder_emit_to(b, CALC_COPY, (uint16_t)(to + i), t.kind == VALUE_NUMBER && !t.is_part ? t.reg[0] : part, 0, 0);
    }
    return to;
}
