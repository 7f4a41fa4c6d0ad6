#include "common/triangle_shape.h"

#include "common/report.h"

void common_triangle_make(common_triangle *t, const pov_vec3 corner[3])
{
    const pov_vec3 e = pov_sub(corner[1], corner[0]), f = pov_sub(corner[2], corner[0]);
    const double size = pov_max(pov_largest(e), pov_largest(f));
    int i;

    t->scale = size > 0.0 ? pov_inverse_power(size) : 1.0;   /* programs write points, too */
    for (i = 0; i < 3; i++)
        t->corner[i] = pov_scale(corner[i], t->scale);
    t->seen = !common_triangle_is_degenerate(&t->corner[0], &t->corner[1], &t->corner[2]);
    t->normal = pov_unit(common_triangle_normal(&t->corner[0], &t->corner[1], &t->corner[2]));
}

bool common_triangle_bounds(const void *self, pov_box *out)
{
    const common_triangle *t = self;
    const double back = common_inverse(t->scale);
    const pov_vec3 a = t->corner[0], b = t->corner[1], c = t->corner[2];

    out->lo = pov_vec3_of(pov_min(pov_min(a.x, b.x), c.x), pov_min(pov_min(a.y, b.y), c.y), pov_min(pov_min(a.z, b.z), c.z));
    out->hi = pov_vec3_of(pov_max(pov_max(a.x, b.x), c.x), pov_max(pov_max(a.y, b.y), c.y), pov_max(pov_max(a.z, b.z), c.z));
    out->lo = pov_scale(out->lo, back);
    out->hi = pov_scale(out->hi, back);
    return true;
}

bool common_triangle_face(const void *self, uint32_t number, pov_face *out)
{
    const common_triangle *t = self;
    const double back = common_inverse(t->scale);

    if (number > 0)
        return false;
    *out = (pov_face){ .normal = t->normal, .normals = { t->normal, t->normal, t->normal } };
    for (int i = 0; i < 3; i++)
        out->corners[i] = pov_scale(t->corner[i], back);
    return true;
}

/* ---- rays ---- */

void common_triangle_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const common_triangle *t = self;
    const pov_vec3 *c = t->corner;
    common_triangle_ray r;

    if (!t->seen || ray->origin_surface == hits->owner)
        return;
    common_triangle_enter(&r, ray, c[0], t->scale, hits->unfiltered);
    if (common_triangle_is_hit(&r, &c[0], &c[1], &c[2]))
        common_triangle_cross(&r, &c[0], &c[1], &c[2], common_mark(0, POV_MARK_OUTWARD), hits);
    hits->escalated += r.view.escalated;
}

void common_triangle_plane_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)ray;
    (void)at;
    *out = ((const common_triangle *)self)->normal;
}

uint32_t common_triangle_shading_normals(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark,
                                         pov_vec3 *normal, double *share)
{
    const common_triangle *t = self;

    (void)mark;
    common_triangle_shares(&t->corner[0], &t->corner[1], &t->corner[2], pov_scale(point, t->scale),
                           pov_scale(point_lo, t->scale), share);
    memcpy(normal, t->at_corner, sizeof t->at_corner);
    return 3;
}

/* ---- blocks ---- */

static void describe(const common_triangle *t, common_planar *f)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 }, n = t->normal;
    const pov_vec3 corners[3] = { zero, pov_sub(t->corner[1], t->corner[0]), pov_sub(t->corner[2], t->corner[0]) };

    f->anchor = pov_scale(t->corner[0], common_inverse(t->scale));
    f->normal = pov_scale(n, pov_inverse_power(pov_largest(n)));
    f->scale = t->scale;
    if (common_planar_outline(f, corners, 3))
        return;
    common_planar_begin(f, zero, pov_vec3_of(fabs(n.x) < fabs(n.y), fabs(n.x) >= fabs(n.y), 0.0));
    common_planar_extend(f, corners[1]);
    common_planar_extend(f, corners[2]);
}

bool common_triangle_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    common_planar figures[POV_BLOCK_MAX];
    uint32_t i;

    for (i = 0; i < n; i++) {
        const common_triangle *t = selves[i];

        if (!t->seen)
            return false;
        describe(t, &figures[i]);
    }
    return common_planar_pack(block, frame, figures, n);
}
