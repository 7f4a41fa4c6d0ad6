#include "numerics/methods/number.h"

#include "common/affine.h"
#include "numerics/methods/lanes.h"

typedef struct box { double plane[6]; } box;   /* plane[2 * axis] is the lower one, and so is a mark's part */

static void set_plane(double plane[6], int axis, double a, double b)
{
    plane[2 * axis] = fmin(a, b);
    plane[2 * axis + 1] = fmax(a, b);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    box *b = self;
    pov_vec3 p, q;

    host->vector(in, &p);
    host->accept(in, ",");
    host->vector(in, &q);
    set_plane(b->plane, 0, p.x, q.x);
    set_plane(b->plane, 1, p.y, q.y);
    set_plane(b->plane, 2, p.z, q.z);
}

static bool bounds(const void *self, pov_box *out)
{
    const double *p = ((const box *)self)->plane;

    out->lo = pov_vec3_of(p[0], p[2], p[4]);
    out->hi = pov_vec3_of(p[1], p[3], p[5]);
    return true;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const box *b = self;
    const line l = line_from(ray, num3_planar(pov_vec3_of(b->plane[0], b->plane[2], b->plane[4])));
    const num from[3] = { l.from.x, l.from.y, l.from.z }, dir[3] = { l.dir.x, l.dir.y, l.dir.z };
    num first = num_of(-1.7e308), last = num_of(1.7e308);
    uint32_t entry = 0, exit = 0, i;

    for (i = 0; i < 3; i++) {
        const bool down = num_double(dir[i]) < 0.0;
        const num width = num_sub(num_of(b->plane[2 * i + 1]), num_of(b->plane[2 * i])), zero = num_of(0.0);
        num near, far;

        if (num_double(dir[i]) == 0.0) {
            if (num_less(from[i], zero) || num_less(width, from[i]))
                return;
            continue;
        }
        near = num_div(num_sub(down ? width : zero, from[i]), dir[i]);
        far = num_div(num_sub(down ? zero : width, from[i]), dir[i]);
        if (num_less(first, near)) {
            first = near;
            entry = 2 * i + down;
        }
        if (num_less(far, last)) {
            last = far;
            exit = 2 * i + !down;
        }
    }
    if (!num_less(last, first) && report(hits, ray, &l, first, entry))
        report(hits, ray, &l, last, exit);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const double dir = at->mark.feature % 2 ? 1.0 : -1.0;
    const uint32_t axis = at->mark.feature / 2;

    (void)self;
    (void)ray;
    *out = pov_vec3_of(axis == 0 ? dir : 0.0, axis == 1 ? dir : 0.0, axis == 2 ? dir : 0.0);
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const double *p = ((const box *)self)->plane;

    (void)point_lo;
    return point.x > p[0] && point.x < p[1] && point.y > p[2] && point.y < p[3] && point.z > p[4] && point.z < p[5];
}

static bool absorb(void *self, const pov_affine *map)
{
    box *b = self;
    double plane[6];
    int axis[3], i;

    if (!common_is_axial(map, axis))
        return false;
    for (i = 0; i < 3; i++)
        set_plane(plane, i, map->m[i][axis[i]] * b->plane[2 * axis[i]] + map->m[i][3],
                  map->m[i][axis[i]] * b->plane[2 * axis[i] + 1] + map->m[i][3]);
    for (i = 0; i < 6; i++)
        b->plane[i] = plane[i];
    return true;
}

METHODS_LANES(bounds)

static const pov_shape_fast box_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(lane_boxes),
    .block_pack = block_pack,
    .block_filter = block_filter,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &box_fast : NULL; }

static const pov_shape_class box_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "box",
    .instance_size = sizeof(box),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .absorb = absorb,
    .extension = extension,
};

METHODS_PLUGIN(box, box_class);
