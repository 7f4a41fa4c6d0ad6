#include "render/raygen.h"

#include "base/simd.h"
#include "render/camera.h"
#include "render/lens.h"
#include "shade/camera_normal.h"
#include "shade/photon_light.h"

pov_ray raygen_ray(const pov_camera *camera, int width, int height, int x, int y, double dx, double dy)
{
    const raygen_screen through = { .u = { raygen_u(x, dx, width) }, .v = { raygen_v(y, dy, height) } };
    pov_ray ray;

    raygen_begin(camera, &ray, 1);
    raygen_aim(camera, &through, 1, &ray);
    return ray;
}

void raygen_begin(const pov_camera *camera, pov_ray *rays, uint32_t n)
{
    const pov_ray ray = { .org = camera->location, .origin_surface = POV_NO_OWNER };

    for (uint32_t i = 0; i < n; i++)
        rays[i] = ray;
}

SIMD_CLONES static void place(const raygen_places *restrict p, int width, int height, uint32_t n,
                              raygen_screen *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        out->u[i] = raygen_u(p->x[i], p->dx[i], width);
        out->v[i] = raygen_v(p->y[i], p->dy[i], height);
    }
}

void raygen_place(const raygen_places *p, int width, int height, uint32_t n, raygen_screen *out)
{
    place(p, width, height, n, out);
    out->width = width;
    out->height = height;
}

SIMD_CLONES static void find_positions(uint32_t seed, uint32_t n, raygen_places *restrict p)
{
    for (uint32_t i = 0; i < n; i++) {
        const sample at = sample_at(seed, p->x[i], p->y[i], (int)(p->k[i] & 1u), p->k[i] / 2);

        p->dx[i] = at.x;
        p->dy[i] = at.y;
    }
}

void raygen_sample(uint32_t seed, uint32_t n, raygen_places *p) { find_positions(seed, n, p); }

SIMD_CLONES static void find_lens(uint32_t seed, uint32_t n, const raygen_places *restrict p, raygen_screen *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const sample at = sample_of_disc(sample_on_lens(seed, p->x[i], p->y[i], (int)(p->k[i] & 1u), p->k[i] / 2));

        out->lens[0][i] = at.x;
        out->lens[1][i] = at.y;
    }
}

SIMD_CLONES static void find_lens_alone(uint32_t seed, uint32_t n, const raygen_places *restrict p, raygen_screen *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const sample at = sample_of_disc_alone(sample_on_lens_alone(seed, p->x[i], p->y[i]));

        out->lens[0][i] = at.x;
        out->lens[1][i] = at.y;
    }
}

void raygen_spread(const pov_camera *camera, uint32_t seed, bool alone, const raygen_places *p, uint32_t n, raygen_screen *out)
{
    if (camera->type == POV_CAMERA_MESH)
        for (uint32_t i = 0; i < n; i++) {
            out->lens[0][i] = p->k[i];
            out->lens[1][i] = 0.0;
        }
    else if (alone)
        find_lens_alone(seed, n, p, out);
    else
        find_lens(seed, n, p, out);
}

static double length_of(pov_vec3 v) { return sqrt(pov_dot(v, v)); }

void raygen_apart(const pov_camera *camera, int width, int height, double *start, double *slope)
{
    const raygen_screen through = { .u = { 0.0, 1.0 / width, 0.0 }, .v = { 0.0, 0.0, 1.0 / height } };
    double starts[2], slopes[2];
    pov_ray rays[3];

    raygen_begin(camera, rays, 3);
    raygen_aim(camera, &through, 3, rays);
    for (int i = 0; i < 2; i++) {
        starts[i] = length_of(pov_sub(rays[i + 1].org, rays[0].org));
        slopes[i] = length_of(pov_sub(pov_unit(rays[i + 1].dir), pov_unit(rays[0].dir)));
    }
    *start = pov_min(starts[0], starts[1]);
    *slope = pov_min(slopes[0], slopes[1]);
    if (camera->type == POV_CAMERA_MESH || !isfinite(*start + *slope))
        *start = *slope = 0.0;
}

bool raygen_flat(const pov_camera *camera, int width, int height, struct photon_screen *out)
{
    const raygen_screen corners = { .u = { -0.5, 0.5, -0.5 }, .v = { 0.5, 0.5, -0.5 }, .width = width, .height = height };
    pov_ray rays[3];

    if ((camera->type != POV_CAMERA_PERSPECTIVE && camera->type != POV_CAMERA_ORTHOGRAPHIC) || raygen_has_lens(camera))
        return false;
    raygen_begin(camera, rays, 3);
    raygen_aim(camera, &corners, 3, rays);
    return photon_screen_make(out, rays, width, height);
}

unsigned raygen_aim(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    if (!raygen_has_lens(camera))
        return camera_class_of(camera)->aim(camera, through, n, rays);
    for (uint32_t i = 0; i < n; i++)
        rays[i].org = camera->location;   /* the last ones started on the lens */
    camera_class_of(camera)->aim(camera, through, n, rays);
    lens_spread(camera, through, n, rays);
    return 0;
}

/* Where the camera's normal is looked up. */
static void look_up(const pov_camera *camera, const raygen_screen *through, uint32_t n, raygen_screen *at)
{
    const camera_class *class = camera_class_of(camera);

    for (uint32_t i = 0; i < n; i++) {
        at->u[i] = through->u[i];
        at->v[i] = through->v[i];
        if (class->look_up)
            class->look_up(camera, through->u[i], through->v[i], &at->u[i], &at->v[i]);
    }
}

unsigned raygen_cast(const model *m, const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    const unsigned known = raygen_aim(camera, through, n, rays);
    raygen_screen at;

    if (camera->type == POV_CAMERA_MESH && m->camera_mesh)
        camera_mesh_cast(m->camera_mesh, camera, through, n, rays);
    if (!m->camera_normal)
        return known;
    look_up(camera, through, n, &at);
    camera_normal_apply(m, at.u, at.v, n, rays);
    return 0;
}
