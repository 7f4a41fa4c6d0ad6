/* Cameras that see more than half of what is around them: ultra_wide_angle, panoramic, spherical. */
#include "render/camera_wide.h"

#include "base/elementary.h"
#include "shade/tracer.h"

#include <string.h>

static const double pi = 3.14159265358979323846;

camera_basis camera_basis_of(const pov_camera *camera)
{
    camera_basis b = { .camera = camera };

    b.right = pov_unit(camera->right);
    b.up = pov_unit(camera->up);
    b.view = pov_unit(camera->direction);
    b.width = camera_length(camera->right);
    b.height = camera_length(camera->up);
    b.depth = camera_length(camera->direction);
    return b;
}

unsigned camera_aim_along(camera_directions *find, const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    const pov_vec3 nowhere = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
    const camera_basis b = camera_basis_of(camera);
    camera_lanes found;

    memset(found.black, 0, sizeof found.black);
    find(&b, through, n, &found);
    for (uint32_t i = 0; i < n; i++) {
        rays[i].org = camera->location;
        rays[i].dir = found.black[i] != 0.0 ? nowhere : lanes_at(&found.dir, i);
    }
    return 0;
}

/* Turned about a unit vector, from z towards x about y. */
SIMD_INLINE pov_vec3 turned(pov_vec3 v, pov_vec3 about, double angle)
{
    const double cosine = elementary_cos(angle);
    const pov_vec3 across = pov_scale(pov_cross_product(about, v), elementary_sin(angle)), along = pov_scale(about, pov_dot(about, v) * (1.0 - cosine));

    return pov_add(pov_add(pov_scale(v, cosine), across), along);
}

/* ---- the kinds ---- */

SIMD_CLONES static void ultra_wide(const camera_basis *restrict b, const raygen_screen *restrict through, uint32_t n, camera_lanes *restrict out)
{
    const double width = b->camera->angles[0], height = b->height, by = b->width;

    for (uint32_t i = 0; i < n; i++) {
        const double across = through->u[i] * width, upwards = through->v[i] * width * height / by;

        lanes_put(&out->dir, i, camera_combine(b, elementary_sin(across), elementary_sin(upwards), elementary_cos(across) * elementary_cos(upwards)));
    }
}

SIMD_CLONES static void panoramic(const camera_basis *restrict b, const raygen_screen *restrict through, uint32_t n, camera_lanes *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const double across = through->u[i] * pi, upwards = through->v[i] * pi, level = elementary_cos(upwards);

        lanes_put(&out->dir, i, camera_combine(b, b->width * elementary_sin(across) * level, b->height * elementary_sin(upwards),
                                               b->depth * elementary_cos(across) * level));
    }
}

/* The view is turned about what is right, and then about what is up: where right is mirrored it is up and down that change
 * places, as in POV-Ray. */
SIMD_CLONES static void spherical(const camera_basis *restrict b, const raygen_screen *restrict through, uint32_t n, camera_lanes *restrict out)
{
    const double across = b->camera->angles[0], upwards = b->camera->angles[1];

    for (uint32_t i = 0; i < n; i++)
        lanes_put(&out->dir, i, turned(turned(b->view, b->right, -through->v[i] * upwards), b->up, through->u[i] * across));
}

static unsigned aim_ultra_wide(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_along(ultra_wide, camera, through, n, rays);
}

static unsigned aim_panoramic(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_along(panoramic, camera, through, n, rays);
}

static unsigned aim_spherical(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_along(spherical, camera, through, n, rays);
}

/* ---- where normals are looked up ---- */

static void ultra_wide_point(const pov_camera *c, double u, double v, double *x, double *y)
{
    *x = u * c->angles[0];
    *y = v * c->angles[0] * camera_length(c->up) / camera_length(c->right);
}

static void panoramic_point(const pov_camera *c, double u, double v, double *x, double *y)
{
    (void)c;
    *x = (0.5 - u) * pi;
    *y = v * pi;
}

static void spherical_point(const pov_camera *c, double u, double v, double *x, double *y)
{
    *x = u * c->angles[0];
    *y = v * c->angles[1];
}

const camera_class camera_ultra_wide = { aim_ultra_wide, ultra_wide_point };
const camera_class camera_panoramic = { aim_panoramic, panoramic_point };
const camera_class camera_spherical = { aim_spherical, spherical_point };
