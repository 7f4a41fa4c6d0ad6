/* mesh_camera: rays from the faces of meshes, along their normals. docs/language.md says which face a pixel has. */
#include "render/camera.h"

#include "model/camera_mesh.h"

/* A face and a row above: the first row of faces is used twice, as in POV-Ray. */
static const camera_face *face_at(const camera_faces *f, int column, int width, int row)
{
    const int64_t number = column + (int64_t)width * (row > 1 ? row - 1 : 0);

    return number < f->count ? &f->items[number] : NULL;
}

static const camera_face *through_all(const camera_mesh *m, int column, int width, int row)
{
    int64_t number = column + (int64_t)width * (row > 1 ? row - 1 : 0);

    for (uint32_t i = 0; i < m->mesh_count; i++) {
        if (number < m->meshes[i].count)
            return &m->meshes[i].items[number];
        number -= m->meshes[i].count;
    }
    return NULL;
}

/* The column is that of the whole picture, so that each mesh begins a row further than the one before it. */
static const camera_face *side_by_side(const camera_mesh *m, int column, int width, int row)
{
    const int each = width / (int)m->mesh_count, which = each > 0 ? column / each : 0;

    return each > 0 && which < (int)m->mesh_count ? face_at(&m->meshes[which], column, each, row) : NULL;
}

/* ---- by surface coordinates ---- */

/* Twice the area of a corner of (u, v) and two others. Of two faces at an edge, one's is the other's with another sign, so
 * that no point is in neither. */
static double area(const double *a, const double *b, double u, double v)
{
    return (a[0] - u) * (b[1] - v) - (a[1] - v) * (b[0] - u);
}

static bool holds(const camera_uv_face *f, double u, double v, double share[3])
{
    double sum = 0.0;
    int below = 0, above = 0;

    for (int i = 0; i < 3; i++) {
        share[i] = area(f->uv[(i + 1) % 3], f->uv[(i + 2) % 3], u, v);
        below += share[i] < 0.0;
        above += share[i] > 0.0;
        sum += share[i];
    }
    for (int i = 0; i < 3; i++)
        share[i] /= sum;
    return (below == 0 || above == 0) && sum != 0.0;
}

static pov_vec3 mean_of(const pov_vec3 of[3], const double share[3])
{
    return pov_add(pov_scale(of[0], share[0]), pov_add(pov_scale(of[1], share[1]), pov_scale(of[2], share[2])));
}

/* The face that has a place, and the place on it. */
static bool find_uv(const camera_atlas *a, double u, double v, camera_face *out)
{
    const uint32_t row = camera_atlas_row(a, v);
    double share[3];

    for (uint32_t i = a->first[row]; i < a->first[row + 1]; i++) {
        const camera_uv_face *f = &a->faces[a->numbers[i]];

        if (!holds(f, u, v, share))
            continue;
        out->middle = mean_of(f->corners, share);
        out->normal = pov_unit(mean_of(f->normals, share));
        return true;
    }
    return false;
}

/* A share of the picture as pixels, without what its division has rounded: the first column would else begin before the
 * faces do. Samples in a pixel are far wider apart than 2^-32. */
static double pixels_of(double share, int size)
{
    return rint(share * size * 0x1p32) * 0x1p-32;
}

/* The corners of pixels count, but for the first row and the last column, as in POV-Ray. */
static bool find_place(const camera_mesh *m, const raygen_screen *through, uint32_t lane, camera_face *out)
{
    double x = pixels_of(through->u[lane] + 0.5, through->width) - 0.5;
    double y = pixels_of(0.5 - through->v[lane], through->height) - 0.5;

    x = x > through->width - 1.5 ? through->width - 1.5 : x;
    y = y < 0.5 ? 0.5 : y;
    return find_uv(&m->atlas, x / through->width, 1.0 - y / through->height, out);
}

/* ---- rays ---- */

static bool find(const camera_mesh *m, const raygen_screen *through, uint32_t lane, camera_face *out)
{
    const int width = through->width, column = (int)floor((through->u[lane] + 0.5) * width);
    const int row = (int)floor((0.5 - through->v[lane]) * through->height);
    const camera_face *face;

    if (m->distribution == 3)
        return find_place(m, through, lane, out);
    if (m->distribution == 0)
        face = face_at(&m->meshes[(uint32_t)through->lens[0][lane] % m->rays], column, width, row);
    else if (m->distribution == 1)
        face = through_all(m, column, width, row);
    else
        face = side_by_side(m, column, width, row);
    if (face)
        *out = *face;
    return face != NULL;
}

void camera_mesh_cast(const camera_mesh *m, const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    const double sign = camera->direction.z < 0.0 ? -1.0 : 1.0;
    camera_face face;

    for (uint32_t i = 0; i < n; i++) {
        if (!find(m, through, i, &face))
            continue;
        rays[i].org = pov_add(face.middle, pov_scale(face.normal, camera->location.z));
        rays[i].dir = pov_scale(face.normal, sign);
    }
}

/* Without the scene's meshes there is nothing to see. */
static unsigned aim(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    (void)through;
    for (uint32_t i = 0; i < n; i++) {
        rays[i].org = camera->location;
        rays[i].dir = pov_vec3_of(HUGE_VAL, HUGE_VAL, HUGE_VAL);
    }
    return 0;
}

const camera_class camera_meshes = { aim, NULL };
