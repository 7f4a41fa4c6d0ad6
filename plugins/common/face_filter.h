/* face_filter.h - leaves out faces of a mesh, and cells of two faces, that a ray certainly misses, eight at a time, in floats.
 *
 * A block holds the corners of the faces of one leaf: nine rows (x, y, z of the first corner, then of the others), each
 * as long as there are faces, relative to the mesh's anchor and scaled. One of cells has twelve rows. */
#ifndef COMMON_FACE_FILTER_H
#define COMMON_FACE_FILTER_H

#include "common/edges.h"

enum { COMMON_FACE_ROWS = 9, COMMON_CELL_ROWS = 12, COMMON_FACE_PAD = 8 };   /* floats behind the last block, which are read and not used */

/* A ray seen along its largest axis, in floats: its point near the anchor, its slopes, and the error of a coordinate in
 * the view. */
typedef struct common_face_view {
    int across, up, forward;
    float point[3], slope_across, slope_up, error;
} common_face_view;

common_face_view common_face_view_of(const common_view *v);

/* Rays side by side: the same, the point by axes of the view (across, up, forward), and t of the point and how much it grows with
 * the depth beyond it. */
typedef struct common_face_views {
    float point[3][POV_RAYS_MAX], slope_across[POV_RAYS_MAX], slope_up[POV_RAYS_MAX], error[POV_RAYS_MAX];
    double near[POV_RAYS_MAX], pace[POV_RAYS_MAX];
    int32_t forward[POV_RAYS_MAX];
} common_face_views;

/* How n rays see a mesh. Those that start too far away, or whose numbers are out of the range of squares, have an error that
 * is not below HUGE_VALF: the caller sets them. */
void common_face_views_make(common_face_views *v, const pov_ray *const *rays, uint32_t n, pov_vec3 anchor, double scale);
/* The same of one, from its view. t = along * unit + depth * unit / direction. */
void common_face_views_set(common_face_views *v, uint32_t i, const common_view *view, double along, double unit);

/* Faces from `first` on, up to eight, by bit: those that the line of a ray may pass, and those that it certainly passes. Of
 * these the crossing is between two depths. */
typedef struct common_face_found { uint32_t maybe, sure; float lo[POV_BLOCK_MAX], hi[POV_BLOCK_MAX]; } common_face_found;
void common_face_find(const float *block, uint32_t count, uint32_t first, const common_face_views *v, uint32_t ray,
                      common_face_found *out);
/* Only those that the line may pass. */
uint32_t common_face_find_any(const float *block, uint32_t count, uint32_t first, const common_face_views *v, uint32_t ray);

/* Write one face of a block of `count`. */
void common_face_put(float *block, uint32_t count, uint32_t i, pov_vec3 a, pov_vec3 b, pov_vec3 c);
/* Faces from `first` on that the line of the ray may hit, by bit: up to eight. */
uint32_t common_face_filter(const float *block, uint32_t count, uint32_t first, const common_face_view *v);

/* The same of cells, whose two faces share the edge between the first and the last corner. *second: those whose second face it may
 * hit, with the third corner; the result is those of the first face, with the second corner. */
void common_cell_put(float *block, uint32_t count, uint32_t i, const pov_vec3 corner[4]);
uint32_t common_cell_filter(const float *block, uint32_t count, uint32_t first, const common_face_view *v, uint32_t *second);

#endif
