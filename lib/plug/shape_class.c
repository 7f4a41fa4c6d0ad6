#include "plug/shape_class.h"

#include <string.h>

/* Members that abi 4 has from its start: a plugin whose struct is shorter was not built from this contract. */
#define REACHES(ptr, type, last) ((ptr)->size >= offsetof(type, last) + sizeof((ptr)->last))

enum { INSTANCE_MOST = 1 << 20 };

/* Copy the members that both sides know; the rest is zero. */
static void copy_known(void *out, size_t out_size, const void *from, size_t from_size)
{
    memset(out, 0, out_size);
    memcpy(out, from, from_size < out_size ? from_size : out_size);
}

static const pov_shape_fast *fast_of(const pov_shape_class *c)
{
    return c->extension ? c->extension(POV_SHAPE_FAST) : NULL;
}

static void fill_fast(shape_class *out, const pov_shape_fast *from)
{
    pov_shape_fast f;

    copy_known(&f, sizeof f, from, from->size);
    out->full_leaves = f.full_leaves;
    out->block_size = f.block_size;
    out->single_block_size = f.single_block_size;
    out->block_pack = f.block_pack;
    out->block_filter = f.block_filter;
    out->intersect_many = f.intersect_many;
    out->normal_many = f.normal_many;
    out->cross_many = f.cross_many;
    out->ellipsoid = f.ellipsoid;
    out->half_space = f.half_space;
    out->hull = f.hull;
    out->outline = f.outline;
    out->intersect_between = f.intersect_between;
    out->intersect_between_many = f.intersect_between_many;
    out->narrow = f.narrow;
    out->reorder = f.reorder;
    out->normal_at_many = f.normal_at_many;
    out->cross_sure = f.cross_sure;
    out->ring = f.ring;
    out->block_bounds = f.block_bounds;
    out->shading_normals_many = f.shading_normals_many;
}

void shape_class_fill(shape_class *out, const pov_shape_class *from)
{
    pov_shape_class c;

    copy_known(&c, sizeof c, from, from->size);
    memset(out, 0, sizeof *out);
    out->flags = c.flags;
    out->keyword = c.keyword;
    out->instance_size = c.instance_size;
    out->parse = c.parse;
    out->bounds = c.bounds;
    out->intersect = c.intersect;
    out->normal = c.normal;
    out->inside = c.inside;
    out->absorb = c.absorb;
    out->parsed_size = c.parsed_size;
    out->prepare = c.prepare;
    out->uv = c.uv;
    out->scratch = c.scratch;
    out->open = c.open;
    out->solid = c.solid;
    out->shading_normals = c.shading_normals;
    out->textures = c.textures;
    out->face = c.face;
    out->reversed = c.reversed;
    if (fast_of(&c))
        fill_fast(out, fast_of(&c));
}

static const char *check_fast(const pov_shape_fast *f)
{
    if (!REACHES(f, pov_shape_fast, ellipsoid))
        return "a shape's fast extension is shorter than its first version";
    if (f->block_filter && (!f->block_pack || f->block_size == 0))
        return "a shape class has a block filter without block_pack or block_size";
    if (REACHES(f, pov_shape_fast, block_bounds) && f->block_bounds && !f->block_filter)
        return "a shape class has bounds of blocks without block_filter";
    if (f->single_block_size > f->block_size)
        return "a shape class has a larger block for one shape than for several";
    return NULL;
}

const char *shape_class_check(const pov_shape_class *c)
{
    if (!REACHES(c, pov_shape_class, extension))
        return "a shape class is shorter than the contract's first version";
    if (!c->keyword || !c->keyword[0])
        return "a shape class has no keyword";
    if (c->instance_size == 0 || c->instance_size > INSTANCE_MOST)
        return "a shape class has an impossible instance size";
    if (!c->parse || !c->bounds || !c->intersect || !c->normal)
        return "a shape class lacks parse, bounds, intersect or normal";
    if ((c->flags & POV_SHAPE_SOLID) && !c->inside)
        return "a shape class is a solid without inside";
    if (c->prepare && (c->parsed_size == 0 || c->parsed_size > INSTANCE_MOST || c->instance_size > POV_PREPARED_MAX))
        return "a shape class has prepare with an impossible size";
    return fast_of(c) ? check_fast(fast_of(c)) : NULL;
}
