/* Cameras that see more than half of what is around them: ultra_wide_angle, panoramic, spherical. */
#include "render/camera_wide.h"

#include "base/elementary.h"
#include "shade/tracer.h"

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

unsigned camera_aim_each(camera_ray *find, const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    const camera_basis b = camera_basis_of(camera);

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 start = pov_vec3_of(0.0, 0.0, 0.0);

        if (!find(&b, through->u[i], through->v[i], &rays[i].dir, &start))
            rays[i].dir = pov_vec3_of(HUGE_VAL, HUGE_VAL, HUGE_VAL);
        rays[i].org = pov_add(camera->location, start);
    }
    return 0;
}

/* Turned about a unit vector, from z towards x about y. */
static pov_vec3 turned(pov_vec3 v, pov_vec3 about, double angle)
{
    const double cosine = elementary_cos(angle);
    const pov_vec3 across = pov_scale(pov_cross_product(about, v), elementary_sin(angle)), along = pov_scale(about, pov_dot(about, v) * (1.0 - cosine));

    return pov_add(pov_add(pov_scale(v, cosine), across), along);
}

/* ---- the kinds ---- */

static bool ultra_wide(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    const double across = u * b->camera->angles[0], upwards = v * b->camera->angles[0] * b->height / b->width;

    (void)start;
    *dir = camera_combine(b, elementary_sin(across), elementary_sin(upwards), elementary_cos(across) * elementary_cos(upwards));
    return true;
}

static bool panoramic(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    const double level = elementary_cos(v * pi);

    (void)start;
    *dir = camera_combine(b, b->width * elementary_sin(u * pi) * level, b->height * elementary_sin(v * pi),
                          b->depth * elementary_cos(u * pi) * level);
    return true;
}

/* The view is turned about what is right, and then about what is up: where right is mirrored it is up and down that change
 * places, as in POV-Ray. */
static bool spherical(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    (void)start;
    *dir = turned(turned(b->view, b->right, -v * b->camera->angles[1]), b->up, u * b->camera->angles[0]);
    return true;
}

static unsigned aim_ultra_wide(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_each(ultra_wide, camera, through, n, rays);
}

static unsigned aim_panoramic(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_each(panoramic, camera, through, n, rays);
}

static unsigned aim_spherical(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_each(spherical, camera, through, n, rays);
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
