/* Round pictures: fisheye, omnimax. */
#include "base/elementary.h"
#include "render/camera_wide.h"

/* In a direction (x, y) of the picture, at this angle from the view. */
static void tilt(const camera_basis *b, double x, double y, double angle, pov_vec3 *dir)
{
    const double q = sqrt(x * x + y * y), sine = q > 0.0 ? elementary_sin(angle) / q : 0.0;

    *dir = camera_combine(b, sine * x, sine * y, elementary_cos(angle));
}

static bool fisheye(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    const double x = 2.0 * u * b->width, y = 2.0 * v * b->height, q = sqrt(x * x + y * y);

    (void)start;
    tilt(b, x, y, 0.5 * q * b->camera->angles[0], dir);
    return q <= 1.0;
}

/* A dome that leans back by 45 degrees; the polynomial was measured on POV-Ray's pictures. */
static bool omnimax(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    const double ratio = b->height / b->width, least = 0.7791453;   /* 45 degrees below the view at the lower edge */
    const double s = ratio > least ? ratio : least;
    const double x = ratio <= 1.0 ? 2.0 * u * s / ratio : 2.0 * u;
    const double y = ratio <= 1.0 ? 2.0 * v * s + (1.0 - s) : 2.0 * v * ratio;
    const double q = sqrt(x * x + y * y), q3 = q * q * q;

    (void)start;
    tilt(b, x, y, 1.411269 * q - 0.09439 * q3 + 0.25674 * q3 * q * q, dir);
    return q <= 1.0 && pov_dot(*dir, b->up) + pov_dot(*dir, b->view) >= 0.0;
}

static unsigned aim_fisheye(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_each(fisheye, camera, through, n, rays);
}

static unsigned aim_omnimax(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_each(omnimax, camera, through, n, rays);
}

const camera_class camera_fisheye = { aim_fisheye };
const camera_class camera_omnimax = { aim_omnimax };
