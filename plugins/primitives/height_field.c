/* height_field { image | function W, H { f } [smooth] [water_level w] }: heights over the unit square, in cells of two triangles.
 *
 * Rays ask the cells that they may meet (common/heights.h). Edges are those of common/triangle.h: no ray slips between two
 * triangles. What is below the water level is left out. Inside is below the surface or the water, down without end. */
#include "common/heights.h"

typedef common_heights height_field;

/* ---- loading ---- */

/* Rows of an image come from the top. */
static void read_heights(height_field *f, const pov_host *host, pov_reader *in)
{
    const uint16_t *at = host->heights(in, &f->wide, &f->deep);
    const size_t row = at ? f->wide * sizeof *at : 0;
    uint16_t *out = at ? host->alloc(in, f->deep * row) : NULL;

    for (uint32_t z = 0; out && z < f->deep; z++)
        memcpy(out + (size_t)z * f->wide, at + (size_t)(f->deep - 1 - z) * f->wide, row);
    f->height = out;
}

static void find_range(height_field *f)
{
    uint16_t low = f->height[0], high = low;

    for (size_t i = 1; i < (size_t)f->wide * f->deep; i++) {
        low = f->height[i] < low ? f->height[i] : low;
        high = f->height[i] > high ? f->height[i] : high;
    }
    f->low = pov_max(low * 0x1p-16, f->water);
    f->high = high * 0x1p-16;
}

static const double *make_places(uint32_t count, const pov_host *host, pov_reader *in)
{
    double *at = host->alloc(in, count * sizeof *at);

    for (uint32_t i = 0; at && i < count; i++)
        at[i] = i / (count - 1.0);
    return at;
}

static void make_cells(height_field *f, const pov_host *host, pov_reader *in)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };

    f->column = make_places(f->wide, host, in);
    f->row = make_places(f->deep, host, in);
    if (!f->column || !f->row || !common_relief_make(&f->relief, host, in, f->height, f->wide, f->deep, 65536.0 * f->water) ||
        !common_relief_ranges_make(&f->ranges, &f->relief, host, in))
        return;
    find_range(f);
    f->boxed.anchor = pov_two3_of(common_heights_centre(), zero);
    f->boxed.scale = 1.0;
    f->boxed.lo = pov_vec3_of(-0.5, f->low - 0.5, -0.5);
    f->boxed.hi = pov_vec3_of(0.5, f->high - 0.5, 0.5);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    height_field *f = self;
    bool read = true;

    read_heights(f, host, in);
    while (read) {
        read = false;
        if (host->accept(in, "smooth")) {
            f->smooth = !host->more(in) || host->boolean(in);
            read = true;
        } else if (host->accept(in, "water_level")) {
            f->water = host->number(in);
            read = true;
        } else if (host->accept(in, "hierarchy")) {
            read = !host->more(in) || (host->boolean(in), true);
        }
    }
    if (f->height && (f->wide < 2 || f->deep < 2))
        host->fail(in, "a height_field needs 2 points a side at least");
    else if (f->height)
        make_cells(f, host, in);
    if (f->relief.levels && f->smooth) {
        f->steeps.wide = f->wide;
        f->steeps.deep = f->deep;
        f->steeps.height = f->height;
        common_steeps_make(&f->steeps, host, in);
    }
}

static bool bounds(const void *self, pov_box *out)
{
    const height_field *f = self;

    out->lo = pov_vec3_of(0.0, pov_min(f->low, f->high), 0.0);
    out->hi = pov_vec3_of(1.0, f->high, 1.0);
    return true;
}

/* ---- along a ray ---- */

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    common_boxed_intersect(&((const height_field *)self)->boxed, common_heights_cross, self, ray, hits);
}

static const pov_shape_fast fast = { .size = sizeof(pov_shape_fast), .intersect_many = common_heights_intersect_many };
static const void *extension(const char *name) { return common_is_fast(name) ? &fast : NULL; }

/* ---- points ---- */

/* The cell of a point, and where it is in it. */
static void cell_of(const height_field *f, pov_vec3 p, uint32_t *x, uint32_t *z, double *u, double *v)
{
    const double across = pov_min(pov_max(p.x * (f->wide - 1.0), 0.0), f->wide - 1.0), along = pov_min(pov_max(p.z * (f->deep - 1.0), 0.0), f->deep - 1.0);

    *x = (uint32_t)across < f->wide - 2 ? (uint32_t)across : f->wide - 2;
    *z = (uint32_t)along < f->deep - 2 ? (uint32_t)along : f->deep - 2;
    *u = across - *x;
    *v = along - *z;
}

static double blend(double at, double by_u, double by_v, double u, double v) { return at + u * (by_u - at) + v * (by_v - at); }

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const height_field *f = self;
    const pov_vec3 p = pov_add(point, point_lo);
    double u, v, height;
    uint32_t x, z;

    if (!f->height || !(p.x >= 0.0 && p.x <= 1.0 && p.z >= 0.0 && p.z <= 1.0))
        return false;
    cell_of(f, p, &x, &z, &u, &v);
    height = u + v <= 1.0 ? blend(common_height_at(f, x, z), common_height_at(f, x + 1, z), common_height_at(f, x, z + 1), u, v)
                          : blend(common_height_at(f, x + 1, z + 1), common_height_at(f, x, z + 1), common_height_at(f, x + 1, z), 1.0 - u, 1.0 - v);
    return p.y < pov_max(height, f->water);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const height_field *f = self;
    const uint32_t cell = at->mark.feature / 2, x = cell % (f->wide - 1), z = cell / (f->wide - 1);
    const pov_vec3 b = common_height_corner(f, x + 1, z), c = common_height_corner(f, x, z + 1);
    const pov_vec3 a = at->mark.feature % 2 == 0 ? common_height_corner(f, x, z) : common_height_corner(f, x + 1, z + 1);

    (void)ray;
    *out = pov_unit(pov_cross_product(pov_sub(b, a), pov_sub(c, a)));
    if (out->y < 0.0)
        *out = pov_scale(*out, -1.0);
}

/* What light sees of a smooth one. */
static uint32_t shading_normals(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark, pov_vec3 *normals,
                                double *share)
{
    const height_field *f = self;
    double u, v;
    uint32_t x, z;

    (void)mark;
    if (!f->smooth)
        return 0;
    cell_of(f, pov_add(point, point_lo), &x, &z, &u, &v);
    common_steeps_of_cell(&f->steeps, x, z, normals);
    for (uint32_t i = 0; i < 4; i++)
        share[i] = (i % 2 ? u : 1.0 - u) * (i / 2 ? v : 1.0 - v);
    return 4;
}

static bool open(const void *self)
{
    (void)self;
    return true;
}

static const pov_shape_class height_field_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_ENDLESS,
    .keyword = "height_field",
    .instance_size = sizeof(height_field),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .open = open,
    .shading_normals = shading_normals,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &height_field_class, NULL };

POV_PLUGIN(height_field) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "height_field",
    .version = "1",
    .shapes = shapes,
};
