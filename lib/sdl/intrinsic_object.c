#include "sdl/intrinsic.h"

#include "sdl/expression.h"
#include "sdl/object_query.h"
#include "sdl/report.h"

/* What stands for a side of a box that has no end. */
static const double endless = 1e10;

/* The name of an object. NULL: the reader has failed. */
static const object_parsed *read_object(pov_reader *in)
{
    value v = expression_read(in);

    if (v.kind == VALUE_OBJECT)
        return v.as.part;
    if (!in->failed)
        report_fail(in, &in->value, POV_E_SYNTAX, "expected the name of an object, found %s", value_name(&v));
    value_drop(&in->heap, &v);
    return NULL;
}

/* As in POV-Ray a polygon may be asked, and holds nothing; other patches may not. */
static bool is_polygon(const object_parsed *o)
{
    return o->kind == OBJECT_LEAF && strcmp(o->leaf.shape->keyword, "polygon") == 0;
}

static void read_inside(pov_reader *in, const intrinsic *row, value *out)
{
    const object_parsed *o;
    pov_vec3 point;

    (void)row;
    state_open(in, '(');
    o = read_object(in);
    state_accept(in, ',');
    point = expression_vector(in);
    state_close(in, ')');
    if (o && !in->failed && !object_is_solid(o) && !is_polygon(o))
        report_fail(in, &in->value, POV_E_SYNTAX, "this object has no inside");
    out->as.v[0] = o && !in->failed && object_is_solid(o) && object_holds(in, o, point);
}

/* The variable that is to have the normal: the name of a vector, or an element of an array. It has been taken; the value
 * belongs to the lender, of which one use is held. NULL: the reader has failed. */
static value *read_normal(pov_reader *in, shared **lender)
{
    const binding *b = in->token.symbol ? in->token.symbol->binding : NULL;
    const place at = in->token.at;
    value *slot;

    if (!b || (b->slot->kind != VALUE_VECTOR && b->slot->kind != VALUE_ARRAY)) {
        report_expected(in, "the name of a vector");
        return NULL;
    }
    *lender = b->lender ? b->lender : (shared *)&b->head;
    (*lender)->uses++;
    state_advance(in);
    slot = expression_element(in, b->slot, lender);
    if (slot && (slot->kind != VALUE_VECTOR || slot->size != 3) && !in->failed)
        report_fail(in, &at, POV_E_SYNTAX, "expected the name of a vector of three numbers, found %s", value_name(slot));
    return in->failed ? NULL : slot;
}

static void read_trace(pov_reader *in, const intrinsic *row, value *out)
{
    object_hit hit = { 0.0, { 0.0, 0.0, 0.0 } };
    pov_vec3 origin, direction;
    const object_parsed *o;
    shared *lender = NULL;
    value *normal = NULL;
    bool found;

    (void)row;
    state_open(in, '(');
    o = read_object(in);
    state_accept(in, ',');
    origin = expression_vector(in);
    state_accept(in, ',');
    direction = expression_vector(in);
    if (state_accept(in, ','))
        normal = read_normal(in, &lender);
    found = o && !in->failed && object_trace(in, o, origin, direction, &hit);
    if (!found)
        hit.normal = pov_vec3_of(0.0, 0.0, 0.0);
    /* The bracket may be the last of a macro, and the name its parameter. */
    if (normal)
        *normal = value_of_vector(hit.normal);
    if (lender)
        value_unshare(&in->heap, lender);
    state_close(in, ')');
    *out = value_of_vector(found ? pov_add(origin, pov_scale(direction, hit.t)) : hit.normal);
}

/* Boxes are wider than their shapes by roundings, of 2^-40 at the most where they are known best. A number of ten digits that is so near
 * is the one that is meant: the steps of a loop are counted by it. */
static double without_roundings(double number, double size)
{
    const double digits = floor(log10(size)), power = pow(10.0, fabs(9.0 - digits));
    const double whole = round(digits < 9.0 ? number * power : number / power), near = digits < 9.0 ? whole / power : whole * power;

    return fabs(near - number) <= 0x1p-39 * size ? near + 0.0 : number;
}

static pov_vec3 extent_of(const pov_box *box, bool is_most)
{
    const pov_vec3 v = is_most ? box->hi : box->lo, w = is_most ? box->lo : box->hi;

    return pov_vec3_of(without_roundings(v.x, pov_max(fabs(v.x), fabs(w.x))), without_roundings(v.y, pov_max(fabs(v.y), fabs(w.y))),
                       without_roundings(v.z, pov_max(fabs(v.z), fabs(w.z))));
}

static void read_extent(pov_reader *in, const intrinsic *row, value *out)
{
    const object_parsed *o;
    pov_box box;

    (void)row;
    state_open(in, '(');
    o = read_object(in);
    state_close(in, ')');
    box.lo = pov_vec3_of(-endless, -endless, -endless);
    box.hi = pov_vec3_of(endless, endless, endless);
    if (o && !in->failed && !object_bounds(in, o, &box)) {
        box.lo = pov_vec3_of(-endless, -endless, -endless);
        box.hi = pov_vec3_of(endless, endless, endless);
    }
    *out = value_of_vector(extent_of(&box, row->v[0] != 0.0));
}

#define READ(name, read) { name, read, NULL, NULL, { 0 }, 0, INTRINSIC_OTHER }

static const intrinsic rows[] = {
    READ("inside", read_inside), READ("trace", read_trace), READ("min_extent", read_extent),
    { "max_extent", read_extent, NULL, NULL, { 1.0 }, 0, INTRINSIC_OTHER },
};

intrinsic_list intrinsic_object_rows(void)
{
    intrinsic_list list = { rows, sizeof rows / sizeof rows[0] };

    return list;
}
