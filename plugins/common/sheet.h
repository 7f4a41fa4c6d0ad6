/* sheet.h - a curved sheet as cells of two triangles: corners on a surface, and normals there.
 *
 * No ray slips between two triangles. Light sees the blend of the normals at the corners. */
#ifndef COMMON_SHEET_H
#define COMMON_SHEET_H

#include "common/triangle.h"

typedef struct common_sheet {
    uint32_t wide, deep;         /* corners along u and v */
    const pov_vec3 *at, *normal; /* of corners: scaled; of any length */
    const pov_hierarchy *cells;
    const uint32_t *order;       /* which cell stands where in it */
    const float *blocks;         /* of its leaves, for common_cell_filter() */
    pov_vec3 anchor;             /* scaled */
    double scale;
    pov_box box;
    bool bounded;                /* what is seen of it lies within `box`, */
    double radius;               /* and within a sphere about its middle; or 0 */
} common_sheet;

/* Point and normal at u and v from 0 to 1. */
typedef void common_sheet_corner(void *user, double u, double v, pov_vec3 *at, pov_vec3 *normal);

/* Of wide times deep corners. */
void common_sheet_make(common_sheet *s, const pov_host *host, pov_reader *in, uint32_t wide, uint32_t deep,
                       common_sheet_corner *corner, void *user);
void common_sheet_intersect(const common_sheet *s, const pov_ray *ray, pov_hits *hits);
void common_sheet_normal(const common_sheet *s, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
uint32_t common_sheet_shading_normals(const common_sheet *s, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark,
                                      pov_vec3 *normal, double *share);
/* u and v of a point, from 0 to 1. */
void common_sheet_uv(const common_sheet *s, pov_vec3 point, const pov_mark *mark, double out[2]);

#endif
