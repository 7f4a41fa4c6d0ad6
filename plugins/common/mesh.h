/* mesh.h - many triangles over shared corners, with a hierarchy of their own: what mesh and mesh2 both make.
 *
 * Faces stand in the order of the hierarchy's leaves. Corners are times a power of two that makes the mesh of the order
 * of one, so that hit and miss are decided at its own size. */
#ifndef COMMON_MESH_H
#define COMMON_MESH_H

#include "common/face_filter.h"
#include "common/triangle.h"

/* Three numbers of a face: of its corners, or what is at these. */
typedef struct common_face { uint32_t at[3]; } common_face;
typedef struct common_uv { double u, v; } common_uv;

#define COMMON_NO_TEXTURE 0xffffffffu

/* A mesh as it is read: arrays from host->resize(), or NULL. */
typedef struct common_mesh_parts {
    pov_vec3 *corners;
    common_face *faces;
    uint32_t corner_count, face_count;
    pov_vec3 *normals;           /* unit */
    common_face *normal_faces;   /* NULL: as the faces */
    uint32_t normal_count;
    common_uv *uvs;
    common_face *uv_faces;       /* NULL: as the faces */
    uint32_t uv_count;
    common_face *textures;       /* by face: three equal ones, or one a corner */
    pov_vec3 toward;             /* a direction along which crossings tell what is inside; zero: nothing is */
} common_mesh_parts;

typedef struct common_mesh {
    double scale;                /* a power of two */
    pov_vec3 anchor;             /* the middle, scaled */
    const pov_vec3 *corners;     /* scaled */
    const common_face *faces;
    const pov_hierarchy *tree;
    const float *blocks;         /* by leaf: those of its first face begin at COMMON_FACE_ROWS times its number */
    const uint32_t *places;      /* of the faces, by their order in the text */
    uint32_t face_count;
    bool closed;                 /* each edge has an even number of faces */
    pov_vec3 toward;
    const uint8_t *turned;       /* of a solid, bits by face: what is outside lies against its normal */
    const pov_vec3 *normals;     /* NULL: the faces are flat */
    const common_face *normal_faces;
    const common_uv *uvs;
    const common_face *uv_faces;
    const common_face *textures;
    pov_box box;
} common_mesh;

/* Make the mesh, and free the parts. Faces whose corners lie on a line are dropped. */
void common_mesh_make(common_mesh *m, common_mesh_parts *p, const pov_host *host, pov_reader *in);
void common_mesh_drop(common_mesh_parts *p, const pov_host *host, pov_reader *in);

/* Does a face's normal point to what is inside? */
bool common_mesh_is_turned(const common_mesh *m, uint32_t face);

/* Functions of the class. */
bool common_mesh_bounds(const void *self, pov_box *out);
void common_mesh_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void common_mesh_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
void common_mesh_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                             pov_vec3 *const *out, uint32_t n);
const void *common_mesh_extension(const char *name);
void common_mesh_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
bool common_mesh_inside(const void *self, pov_vec3 point, pov_vec3 point_lo);
bool common_mesh_solid(const void *self);
bool common_mesh_open(const void *self);
void common_mesh_uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2]);
uint32_t common_mesh_shading_normals(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark,
                                     pov_vec3 *normal, double *share);
void common_mesh_shading_normals_many(const void *const *selves, const pov_vec3 *points, const pov_vec3 *points_lo, const pov_mark *const *marks,
                                      uint32_t n, pov_vec3 *out, uint32_t *count);
uint32_t common_mesh_textures(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark,
                              uint32_t *which, double *share);
bool common_mesh_face(const void *self, uint32_t number, pov_face *out);

/* The rest of a class and its plugin, whose functions are these. */
#define COMMON_MESH_CLASS(word, read) \
    { \
        .size = sizeof(pov_shape_class), \
        .flags = POV_SHAPE_SOLID | POV_SHAPE_FACETED | POV_SHAPE_CERTIFIED, \
        .keyword = word, \
        .instance_size = sizeof(common_mesh), \
        .parse = read, \
        .bounds = common_mesh_bounds, \
        .intersect = common_mesh_intersect, \
        .normal = common_mesh_normal, \
        .inside = common_mesh_inside, \
        .solid = common_mesh_solid, \
        .open = common_mesh_open, \
        .uv = common_mesh_uv, \
        .shading_normals = common_mesh_shading_normals, \
        .textures = common_mesh_textures, \
        .face = common_mesh_face, \
        .extension = common_mesh_extension, \
    }

#endif
