#include "common/mesh.h"

#include "common/report.h"
#include "common/simd.h"
#include "common/triangle_shape.h"

bool common_mesh_bounds(const void *self, pov_box *out)
{
    *out = ((const common_mesh *)self)->box;
    return true;
}

static const pov_vec3 *corner_of(const common_mesh *m, uint32_t face, int i)
{
    return &m->corners[m->faces[face].at[i]];
}

/* ---- what is inside ---- */

bool common_mesh_solid(const void *self) { return pov_largest(((const common_mesh *)self)->toward) > 0.0; }

bool common_mesh_open(const void *self) { return !((const common_mesh *)self)->closed; }

/* Crossings are counted and forgotten. */
static bool forget(pov_hits *hits)
{
    *(uint64_t *)hits->user += hits->count;
    hits->count = 0;
    return true;
}

/* Is the number of crossings ahead odd, but for that of a face? */
static bool is_odd(const common_mesh *m, pov_ray *ray, uint32_t face)
{
    uint64_t before = 0;
    pov_crossing at;
    pov_hits hits = { .tmax = HUGE_VAL, .want = POV_WANT_ALL, .count_only = true, .capacity = 1, .at = &at,
                      .grow = forget, .user = &before };

    ray->origin_surface = hits.owner;
    ray->origin_mark.feature = face;
    common_mesh_intersect(m, ray, &hits);
    return (before + hits.count) & 1;
}

bool common_mesh_inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const common_mesh *m = self;
    pov_ray ray = { .org = point, .org_lo = point_lo, .dir = m->toward };

    return common_mesh_solid(m) && is_odd(m, &ray, m->face_count);
}

bool common_mesh_is_turned(const common_mesh *m, uint32_t face)
{
    const pov_vec3 *a = corner_of(m, face, 0), *b = corner_of(m, face, 1), *c = corner_of(m, face, 2);
    const pov_vec3 normal = pov_unit(common_triangle_normal(a, b, c)), dir = m->closed ? normal : m->toward;
    pov_ray ray = { .dir = dir };

    ray.org = pov_scale(pov_add(pov_scale(*a, 0.25), pov_add(pov_scale(*b, 0.25), pov_scale(*c, 0.5))), 1.0 / m->scale);
    return is_odd(m, &ray, face) != (pov_dot(dir, normal) < 0.0);
}

/* ---- points ---- */

static uint32_t face_of(const common_mesh *m, const pov_mark *mark)
{
    return mark->feature < m->face_count ? mark->feature : 0;
}

/* As its corners run. */
static pov_vec3 written_normal(const common_mesh *m, uint32_t face)
{
    return common_triangle_normal(corner_of(m, face, 0), corner_of(m, face, 1), corner_of(m, face, 2));
}

static bool is_turned(const common_mesh *m, uint32_t face) { return m->turned && m->turned[face / 8] >> face % 8 & 1; }

void common_mesh_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const common_mesh *m = self;
    const uint32_t face = face_of(m, &at->mark);

    (void)ray;
    *out = pov_unit(written_normal(m, face));
    if (is_turned(m, face))
        *out = pov_scale(*out, -1.0);
}

void common_mesh_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                             pov_vec3 *const *out, uint32_t n)
{
    (void)rays;
    for (uint32_t some; n > 0; n -= some, selves += some, at += some, out += some) {
        const pov_vec3 *corner[COMMON_TRIANGLES][3];

        some = n < COMMON_TRIANGLES ? n : COMMON_TRIANGLES;
        for (uint32_t i = 0; i < some; i++)
            for (int k = 0; k < 3; k++)
                corner[i][k] = corner_of(selves[i], face_of(selves[i], &at[i]->mark), k);
        common_triangle_normals((const pov_vec3 *const(*)[3])corner, some, out);
        for (uint32_t i = 0; i < some; i++)
            if (is_turned(selves[i], face_of(selves[i], &at[i]->mark)))
                *out[i] = pov_scale(*out[i], -1.0);
    }
}

static void shares_of(const common_mesh *m, uint32_t face, pov_vec3 point, pov_vec3 point_lo, double share[3])
{
    common_triangle_shares(corner_of(m, face, 0), corner_of(m, face, 1), corner_of(m, face, 2),
                           pov_scale(point, m->scale), pov_scale(point_lo, m->scale), share);
}

/* The normals of a face that is smooth, else NULL. As in POV-Ray one whose unit normals are the same within 1e-5 is not. */
static const uint32_t *smooth_face(const common_mesh *m, uint32_t face)
{
    const uint32_t *at = m->normals ? m->normal_faces[face].at : NULL;
    pov_vec3 u, v;

    if (!at || at[0] == COMMON_NO_TEXTURE)
        return NULL;
    u = pov_sub(m->normals[at[1]], m->normals[at[0]]);
    v = pov_sub(m->normals[at[2]], m->normals[at[0]]);
    return pov_dot(u, u) > 1e-10 || pov_dot(v, v) > 1e-10 ? at : NULL;
}

/* A mesh blends the normals in its own space, as POV-Ray's does. */
uint32_t common_mesh_shading_normals(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark,
                                     pov_vec3 *normal, double *share)
{
    const common_mesh *m = self;
    const uint32_t face = face_of(m, mark);
    const uint32_t *at = smooth_face(m, face);
    double of_corner[3];

    *share = 1.0;
    if (!at && !is_turned(m, face))
        return 0;
    if (!at) {
        *normal = pov_unit(written_normal(m, face));
        return 1;
    }
    shares_of(m, face, point, point_lo, of_corner);
    return common_triangle_blend((const pov_vec3[3]){ m->normals[at[0]], m->normals[at[1]], m->normals[at[2]] }, of_corner,
                                 normal);
}

/* Those of faces that are smooth, side by side. */
typedef struct smooth_some { common_triangle_point at[COMMON_TRIANGLES]; uint32_t of[COMMON_TRIANGLES], count; } smooth_some;

static void blend_some(smooth_some *some, pov_vec3 *out, uint32_t *count)
{
    pov_vec3 normal[COMMON_TRIANGLES];
    const uint32_t found = some->count > 0 ? common_triangle_blend_many(some->at, some->count, normal) : 0;

    for (uint32_t i = 0; i < some->count; i++) {
        out[some->of[i]] = normal[i];
        count[some->of[i]] = found >> i & 1;
    }
    some->count = 0;
}

static void put_smooth(smooth_some *some, const common_mesh *m, uint32_t face, const uint32_t *normals, pov_vec3 point, pov_vec3 point_lo,
                       uint32_t of)
{
    common_triangle_point *p = &some->at[some->count];

    for (int k = 0; k < 3; k++) {
        p->corner[k] = corner_of(m, face, k);
        p->normal[k] = &m->normals[normals[k]];
    }
    p->point = pov_scale(point, m->scale);
    p->point_lo = pov_scale(point_lo, m->scale);
    some->of[some->count++] = of;
}

void common_mesh_shading_normals_many(const void *const *selves, const pov_vec3 *points, const pov_vec3 *points_lo, const pov_mark *const *marks,
                                      uint32_t n, pov_vec3 *out, uint32_t *count)
{
    smooth_some some;

    some.count = 0;
    for (uint32_t i = 0; i < n; i++) {
        const common_mesh *m = selves[i];
        const uint32_t face = face_of(m, marks[i]), *at = smooth_face(m, face);
        double share;

        if (!at) {
            count[i] = common_mesh_shading_normals(m, points[i], points_lo[i], marks[i], &out[i], &share);
            continue;
        }
        put_smooth(&some, m, face, at, points[i], points_lo[i], i);
        if (some.count == COMMON_TRIANGLES)
            blend_some(&some, out, count);
    }
    blend_some(&some, out, count);
}

void common_mesh_uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2])
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_mesh *m = self;
    const uint32_t face = face_of(m, mark);
    double share[3];
    int i;

    out[0] = out[1] = 0.0;
    if (!m->uvs || m->uv_faces[face].at[0] == COMMON_NO_TEXTURE)
        return;
    shares_of(m, face, point, zero, share);
    for (i = 0; i < 3; i++) {
        out[0] += share[i] * m->uvs[m->uv_faces[face].at[i]].u;
        out[1] += share[i] * m->uvs[m->uv_faces[face].at[i]].v;
    }
}

uint32_t common_mesh_textures(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark,
                              uint32_t *which, double *share)
{
    const common_mesh *m = self;
    const uint32_t face = face_of(m, mark);
    const uint32_t *at;
    int i;

    if (!m->textures || m->textures[face].at[0] == COMMON_NO_TEXTURE)
        return 0;
    at = m->textures[face].at;
    which[0] = at[0];
    share[0] = 1.0;
    if (at[0] == at[1] && at[1] == at[2])
        return 1;
    shares_of(m, face, point, point_lo, share);
    for (i = 0; i < 3; i++)
        which[i] = at[i];
    return 3;
}

/* ---- faces as they were written ---- */

static void take_uv(const common_mesh *m, uint32_t face, pov_face *out)
{
    const uint32_t *at = m->uvs ? m->uv_faces[face].at : NULL;
    int i;

    for (i = 0; i < 3; i++) {
        out->uv[i][0] = at && at[0] != COMMON_NO_TEXTURE ? m->uvs[at[i]].u : 0.0;
        out->uv[i][1] = at && at[0] != COMMON_NO_TEXTURE ? m->uvs[at[i]].v : 0.0;
    }
}

bool common_mesh_face(const void *self, uint32_t number, pov_face *out)
{
    const common_mesh *m = self;
    const uint32_t face = number < m->face_count ? m->places[number] : 0;
    const uint32_t *at;
    int i;

    if (number >= m->face_count)
        return false;
    at = smooth_face(m, face);
    out->normal = pov_unit(written_normal(m, face));
    for (i = 0; i < 3; i++) {
        out->corners[i] = pov_scale(*corner_of(m, face, i), 1.0 / m->scale);
        out->normals[i] = at ? m->normals[at[i]] : out->normal;
    }
    take_uv(m, face, out);
    return true;
}
