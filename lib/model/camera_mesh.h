/* camera_mesh.h - a camera whose rays leave the faces of meshes, along their normals. */
#ifndef MODEL_CAMERA_MESH_H
#define MODEL_CAMERA_MESH_H

#include <povtrace/math.h>

#include <stdbool.h>
#include <stdint.h>

/* The middle of a face, and its unit normal. */
typedef struct camera_face { pov_vec3 middle, normal; } camera_face;
typedef struct camera_faces { const camera_face *items; uint32_t count; } camera_faces;

/* A face that is found by its surface coordinates. */
typedef struct camera_uv_face { pov_vec3 corners[3], normals[3]; double uv[3][2]; } camera_uv_face;

/* Those of one mesh, and for each of `rows` strips of v, from 0 to 1, the numbers of the faces that reach into it: from
 * first[row] on up to first[row + 1], ascending. */
typedef struct camera_atlas {
    const camera_uv_face *faces;
    uint32_t rows;
    const uint32_t *first, *numbers;
} camera_atlas;

typedef struct camera_mesh {
    int distribution;            /* 0: a face a pixel in each mesh; 1: through all meshes; 2: meshes side by side; 3: by uv */
    uint32_t rays;               /* of distribution 0: the meshes that the mean is taken of */
    uint32_t mesh_count;
    const camera_faces *meshes;  /* of distributions 0 to 2 */
    camera_atlas atlas;          /* of distribution 3 */
} camera_mesh;

/* The strip of a coordinate. */
static inline uint32_t camera_atlas_row(const camera_atlas *a, double v)
{
    return v > 0.0 ? (v < 1.0 ? (uint32_t)(v * a->rows) : a->rows - 1) : 0;
}

#endif
