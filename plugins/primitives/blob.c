/* blob { [threshold t] sphere { <centre>, radius, strength } cylinder { <end>, <end>, radius, strength } ... }: where the sum
 * of strength (1 - d^2 / r^2)^2 over the components within whose radius a point is reaches the threshold. */
#include "common/blob.h"
#include "common/cell_box.h"
#include "common/simd.h"

/* ---- loading ---- */

/* As written: a transformation, and a capsule before it. */
typedef struct written { pov_vec3 from, to; double radius; pov_affine map; bool moved; } written;

static pov_vec3 perpendicular(pov_vec3 a)
{
    const pov_vec3 x = { 1.0, 0.0, 0.0 }, y = { 0.0, 1.0, 0.0 };

    return pov_unit(pov_cross_product(a, fabs(a.x) < fabs(a.y) ? x : y));
}

static void put_row(double row[4], pov_vec3 axis, pov_vec3 from, double radius)
{
    row[0] = axis.x / radius;
    row[1] = axis.y / radius;
    row[2] = axis.z / radius;
    row[3] = -pov_dot(axis, from) / radius;
}

/* The map to the component's own space: first back through its transformation. */
static void find_map(common_blob_part *c, const written *w)
{
    const pov_vec3 along = pov_sub(w->to, w->from), z = { 0.0, 0.0, 1.0 };
    const pov_vec3 axis = pov_largest(along) > 0.0 ? pov_unit(along) : z, side = perpendicular(axis);
    double m[3][4];

    c->length = sqrt(pov_dot(along, along)) / w->radius;
    put_row(m[0], side, w->from, w->radius);
    put_row(m[1], pov_cross_product(axis, side), w->from, w->radius);
    put_row(m[2], axis, w->from, w->radius);
    memcpy(c->m, m, sizeof m);
    for (int i = 0; i < 3 && w->moved; i++)
        for (int j = 0; j < 4; j++)
            c->m[i][j] = m[i][0] * w->map.inv[0][j] + m[i][1] * w->map.inv[1][j] + m[i][2] * w->map.inv[2][j] + (j == 3 ? m[i][3] : 0.0);
}

/* Both ends are spheres, which a map makes ellipsoids. */
static void find_box(common_blob_part *c, const written *w)
{
    pov_vec3 a = w->from, b = w->to, reach = { w->radius, w->radius, w->radius };
    double r[3];

    if (w->moved) {
        a = pov_affine_point(&w->map, a);
        b = pov_affine_point(&w->map, b);
        for (int i = 0; i < 3; i++)
            r[i] = w->radius * sqrt(w->map.m[i][0] * w->map.m[i][0] + w->map.m[i][1] * w->map.m[i][1] + w->map.m[i][2] * w->map.m[i][2]);
        reach = pov_vec3_of(r[0], r[1], r[2]);
    }
    reach = pov_scale(reach, 1.0 + 0x1p-40);
    c->lo = pov_sub(pov_vec3_of(pov_min(a.x, b.x), pov_min(a.y, b.y), pov_min(a.z, b.z)), reach);
    c->hi = pov_add(pov_vec3_of(pov_max(a.x, b.x), pov_max(a.y, b.y), pov_max(a.z, b.z)), reach);
}

static common_blob_part *append(common_blob *b, const pov_host *host, pov_reader *in)
{
    if (b->count == b->capacity) {
        common_blob_part *bigger = host->alloc(in, (2 * b->capacity + 8) * sizeof *bigger);

        if (!bigger)
            return NULL;
        if (b->count > 0)
            memcpy(bigger, b->at, b->count * sizeof *bigger);
        b->at = bigger;
        b->capacity = 2 * b->capacity + 8;
    }
    return &b->at[b->count++];
}

static void add(common_blob *b, const pov_host *host, pov_reader *in, const written *w, double strength, uint32_t texture)
{
    common_blob_part *c = w->radius > 0.0 ? append(b, host, in) : NULL;

    b->written = true;
    if (!c)
        return;
    c->strength = strength;
    c->texture = texture;
    c->number = b->count - 1;
    b->textured |= texture != POV_OWN_TEXTURE;
    c->centre = w->from;
    c->per_square = w->moved || pov_largest(pov_sub(w->to, w->from)) > 0.0 ? 0.0 : 1.0 / (w->radius * w->radius);
    find_map(c, w);
    find_box(c, w);
}

static void read_component(common_blob *b, const pov_host *host, pov_reader *in, bool is_cylinder)
{
    uint32_t texture = POV_OWN_TEXTURE;
    double strength;
    bool read;
    written w;

    memset(&w, 0, sizeof w);
    host->expect(in, "{");
    host->vector(in, &w.from);
    host->accept(in, ",");
    w.to = w.from;
    if (is_cylinder) {
        host->vector(in, &w.to);
        if (!(pov_largest(pov_sub(w.to, w.from)) > 0.0))
            host->fail(in, "a cylinder of a blob needs two different ends");
        host->accept(in, ",");
    }
    w.radius = fabs(host->number(in));
    host->accept(in, ",");
    host->accept(in, "strength");
    strength = host->number(in);
    do {
        read = host->component_texture && host->component_texture(in, &texture);
        if (host->transform && host->transform(in, &w.map))
            read = w.moved = true;
    } while (read);
    host->expect(in, "}");
    add(b, host, in, &w, strength, texture);
}

/* The form of old: `component strength, radius, <centre>`. */
static void read_old(common_blob *b, const pov_host *host, pov_reader *in)
{
    written w;
    double strength;

    memset(&w, 0, sizeof w);
    strength = host->number(in);
    host->accept(in, ",");
    w.radius = fabs(host->number(in));
    host->accept(in, ",");
    host->vector(in, &w.from);
    w.to = w.from;
    add(b, host, in, &w, strength, POV_OWN_TEXTURE);
}

static bool read_item(common_blob *b, const pov_host *host, pov_reader *in)
{
    if (host->accept(in, "threshold"))
        b->threshold = host->number(in);
    else if (host->accept(in, "sphere"))
        read_component(b, host, in, false);
    else if (host->accept(in, "cylinder"))
        read_component(b, host, in, true);
    else if (host->accept(in, "component"))
        read_old(b, host, in);
    else if (host->accept(in, "hierarchy") || host->accept(in, "sturm"))
        return !host->more(in) || (host->boolean(in), true);
    else
        return false;
    return true;
}

static double number_of(double a) { return a == a ? a : 0.0; }

/* In runs of neighbours. */
static void arrange(common_blob *b, const pov_host *host, pov_reader *in)
{
    common_part *parts = host->alloc(in, b->count * sizeof *parts);
    common_blob_part *at = host->alloc(in, b->count * sizeof *at);
    pov_box *box = host->alloc(in, (b->count / COMMON_RUN + 1) * sizeof *box), *around = host->alloc(in, (b->count / COMMON_RUNS + 1) * sizeof *around);

    b->by_number = host->alloc(in, b->count * sizeof *b->by_number);
    if (!parts || !at || !box || !around || !b->by_number)
        return;
    for (uint32_t i = 0; i < b->count; i++) {
        const pov_vec3 middle = pov_scale(pov_add(b->at[i].lo, b->at[i].hi), 0.5);

        parts[i] = (common_part){ { number_of(middle.x), number_of(middle.y), number_of(middle.z) }, i };
    }
    common_runs_arrange(parts, b->count);
    for (uint32_t i = 0; i < b->count; i++) {
        at[i] = b->at[parts[i].number];
        b->by_number[parts[i].number] = i;
    }
    b->at = at;
    b->runs.box = box;
    b->runs.around = around;
}

/* About the middle of all boxes, scaled to the order of one. */
static void place(common_blob *b)
{
    pov_vec3 lo = b->at[0].lo, hi = b->at[0].hi, middle;
    double back;

    for (uint32_t i = 1; i < b->count; i++) {
        const common_blob_part *c = &b->at[i];

        lo = pov_vec3_of(pov_min(lo.x, c->lo.x), pov_min(lo.y, c->lo.y), pov_min(lo.z, c->lo.z));
        hi = pov_vec3_of(pov_max(hi.x, c->hi.x), pov_max(hi.y, c->hi.y), pov_max(hi.z, c->hi.z));
    }
    middle = pov_scale(pov_add(lo, hi), 0.5);
    b->boxed.anchor = pov_two3_of(middle, pov_vec3_of(0.0, 0.0, 0.0));
    b->boxed.scale = pov_inverse_power(pov_largest(pov_sub(hi, lo)));
    back = common_inverse(b->boxed.scale);
    b->boxed.lo = pov_scale(pov_sub(lo, middle), b->boxed.scale);
    b->boxed.hi = pov_scale(pov_sub(hi, middle), b->boxed.scale);
    for (uint32_t i = 0; i < b->count; i++) {
        common_blob_part *c = &b->at[i];

        c->lo = pov_scale(pov_sub(c->lo, middle), b->boxed.scale);
        c->hi = pov_scale(pov_sub(c->hi, middle), b->boxed.scale);
        c->centre = pov_scale(pov_sub(c->centre, middle), b->boxed.scale);
        c->per_square *= back * back;
        for (int j = 0; j < 3; j++) {
            c->m[j][3] += c->m[j][0] * middle.x + c->m[j][1] * middle.y + c->m[j][2] * middle.z;
            for (int k = 0; k < 3; k++)
                c->m[j][k] *= back;
        }
        if (b->runs.box)
            common_runs_add(&b->runs, i, c->lo, c->hi);
    }
}

/* How near the cell comes to the component, in its own space. */
static double nearest_of(const common_blob_part *c, const pov_box *cell)
{
    const pov_vec3 half = pov_scale(pov_sub(cell->hi, cell->lo), 0.5);
    pov_vec3 q = common_blob_mapped(c, pov_add(cell->lo, half), 1.0);
    double reach = 0.0;

    q.z -= common_lesser(common_greater(q.z, 0.0), c->length);
    for (int i = 0; i < 3; i++) {
        const double by = fabs(c->m[i][0]) * half.x + fabs(c->m[i][1]) * half.y + fabs(c->m[i][2]) * half.z;

        reach += by * by;
    }
    return common_greater(sqrt(pov_dot(q, q)) - sqrt(reach), 0.0);
}

static bool may_hold(const void *self, const pov_box *cell)
{
    const common_blob *b = self;
    double most = 0.0;

    for (uint32_t i = 0; i < b->count; i++) {
        const double near = nearest_of(&b->at[i], cell), depth = 1.0 - near * near;

        most += near < 1.0 ? common_greater(b->at[i].strength, 0.0) * depth * depth : 0.0;
    }
    return !common_blob_stays_below(b, most);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    enum { FEW = 64 };           /* where there are more components, to look for the box would take too long */
    common_blob *b = self;
    pov_box whole;

    b->threshold = 1.0;
    while (read_item(b, host, in))
        continue;
    if (b->count == 0 && b->written)
        add(b, host, in, &(written){ .radius = 1.0 }, 0.0, POV_OWN_TEXTURE);
    if (b->count == 0) {
        host->fail(in, "a blob needs at least one component");
        return;
    }
    b->runs.count = b->count;
    if (b->count > 2 * COMMON_RUN)
        arrange(b, host, in);
    place(b);
    whole = (pov_box){ b->boxed.lo, b->boxed.hi };
    if (b->count > FEW || !common_cell_box(b, &whole, may_hold, &b->box))
        b->box = whole;
}

static bool bounds(const void *self, pov_box *out)
{
    const common_blob *b = self;
    const pov_vec3 middle = pov_two3_hi(b->boxed.anchor), lo = pov_add(pov_scale(b->box.lo, 1.0 / b->boxed.scale), middle);
    const pov_vec3 hi = pov_add(pov_scale(b->box.hi, 1.0 / b->boxed.scale), middle);

    out->lo = pov_vec3_of(common_below(lo.x), common_below(lo.y), common_below(lo.z));
    out->hi = pov_vec3_of(common_above(hi.x), common_above(hi.y), common_above(hi.z));
    return true;
}

/* ---- points ---- */

/* A component's part of the field, and its slope in the blob's space. */
static double field_of(const common_blob_part *c, pov_vec3 p, pov_vec3 *slope)
{
    pov_vec3 q = common_blob_mapped(c, p, 1.0);
    double depth, factor;

    q.z -= common_lesser(common_greater(q.z, 0.0), c->length);
    depth = 1.0 - pov_dot(q, q);
    if (!(depth > 0.0)) {
        *slope = pov_vec3_of(0.0, 0.0, 0.0);
        return 0.0;
    }
    factor = -4.0 * c->strength * depth;
    slope->x = factor * (c->m[0][0] * q.x + c->m[1][0] * q.y + c->m[2][0] * q.z);
    slope->y = factor * (c->m[0][1] * q.x + c->m[1][1] * q.y + c->m[2][1] * q.z);
    slope->z = factor * (c->m[0][2] * q.x + c->m[1][2] * q.y + c->m[2][2] * q.z);
    return c->strength * depth * depth;
}

/* Components that are not zero at a point, in the order of the text; or all. */
enum { HERE = 48 };
typedef struct here { const common_blob_part *at[HERE]; uint32_t count; bool all; } here;

static bool is_here(const common_blob_part *c, pov_vec3 p)
{
    pov_vec3 slope;

    return field_of(c, p, &slope) != 0.0;
}

static void find_here(const common_blob *b, pov_vec3 p, here *out)
{
    out->count = 0;
    out->all = !b->by_number;
    for (uint32_t i = 0; !out->all && (i = common_runs_near(&b->runs, i, p)) < b->count; i++) {
        uint32_t k = out->count;

        if (!is_here(&b->at[i], p))
            continue;
        out->all = k == HERE;
        for (; !out->all && k > 0 && out->at[k - 1]->number > b->at[i].number; k--)
            out->at[k] = out->at[k - 1];
        if (!out->all)
            out->at[k] = &b->at[i];
        out->count++;
    }
    if (out->all)
        out->count = b->count;
}

static const common_blob_part *component_here(const common_blob *b, const here *h, uint32_t i)
{
    return !h->all ? h->at[i] : &b->at[b->by_number ? b->by_number[i] : i];
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const common_blob *b = self;
    const pov_vec3 p = pov_two3_hi(common_offset(point, point_lo, b->boxed.anchor, b->boxed.scale));
    double sum = 0.0;
    pov_vec3 slope;
    here h;

    find_here(b, p, &h);
    for (uint32_t i = 0; i < h.count; i++)
        sum += field_of(component_here(b, &h, i), p, &slope);
    return sum > b->threshold;
}

static void normal_at(const void *self, pov_vec3 p, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const common_blob *b = self;
    pov_vec3 sum = { 0.0, 0.0, 0.0 }, slope;
    here h;

    (void)at;
    find_here(b, p, &h);
    for (uint32_t i = 0; i < h.count; i++) {
        field_of(component_here(b, &h, i), p, &slope);
        sum = pov_sub(sum, slope);
    }
    *out = pov_unit(sum);
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

COMMON_BOXED_RAYS(common_blob, common_blob_cross, common_blob_first, true)
COMMON_BOXED_NORMALS(common_blob, normal_at)

static const pov_shape_fast fast = { .size = sizeof(pov_shape_fast), .intersect_many = intersect_many, .normal_many = normal_many };

static const void *extension(const char *name) { return common_is_fast(name) ? &fast : NULL; }

/* Shares of the field so far, in falling order; the least gives way to a larger one. */
typedef struct shares { uint32_t *which; double *share; uint32_t count; } shares;

static void add_share(shares *s, uint32_t texture, double field)
{
    uint32_t i = 0;

    while (i < s->count && s->which[i] != texture)
        i++;
    if (i == POV_TEXTURES_MAX && s->share[--i] >= field)
        return;
    if (i < s->count && s->which[i] == texture)
        field += s->share[i];
    else if (i == s->count)
        s->count++;
    for (; i > 0 && s->share[i - 1] < field; i--) {
        s->share[i] = s->share[i - 1];
        s->which[i] = s->which[i - 1];
    }
    s->share[i] = field;
    s->which[i] = texture;
}

/* By the shares of the components in the field, whatever its sign; those without a texture have the blob's. */
static uint32_t textures(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark, uint32_t *which,
                         double *share)
{
    const common_blob *b = self;
    const pov_vec3 p = pov_two3_hi(common_offset(point, point_lo, b->boxed.anchor, b->boxed.scale));
    shares all = { which, share, 0 };
    double sum = 0.0;
    pov_vec3 slope;
    here h;

    (void)mark;
    if (b->textured)
        find_here(b, p, &h);
    for (uint32_t i = 0; b->textured && i < h.count; i++) {
        const common_blob_part *c = component_here(b, &h, i);
        const double field = fabs(field_of(c, p, &slope));

        if (field > 0.0)
            add_share(&all, c->texture, field);
    }
    for (uint32_t i = 0; i < all.count; i++)
        sum += share[i];
    for (uint32_t i = 0; i < all.count; i++)
        share[i] /= sum;
    return all.count;
}

static const pov_shape_class blob_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "blob",
    .instance_size = sizeof(common_blob),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .scratch = common_blob_scratch,
    .extension = extension,
    .textures = textures,
};

static const pov_shape_class *const shapes[] = { &blob_class, NULL };

POV_PLUGIN(blob) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "blob",
    .version = "1",
    .shapes = shapes,
};
