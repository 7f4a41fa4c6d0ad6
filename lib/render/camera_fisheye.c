/* Round pictures: fisheye, omnimax. */
#include "base/elementary.h"
#include "render/camera_wide.h"

/* Where on the disc, which has the radius 1, and how far from the view. */
typedef struct place { double x, y, q, angle; } place;

static place fisheye_place(const pov_camera *c, double u, double v)
{
    place p = { 2.0 * u * camera_length(c->right), 2.0 * v * camera_length(c->up), 0.0, 0.0 };

    p.q = sqrt(p.x * p.x + p.y * p.y);
    p.angle = 0.5 * p.q * c->angles[0];
    return p;
}

/* A dome that leans back by 45 degrees; the polynomial was measured on POV-Ray's pictures. */
static place omnimax_place(const pov_camera *c, double u, double v)
{
    const double ratio = camera_length(c->up) / camera_length(c->right), least = 0.7791453;   /* 45 degrees below the view at the lower edge */
    const double s = ratio > least ? ratio : least;
    place p;
    double q3;

    p.x = ratio <= 1.0 ? 2.0 * u * s / ratio : 2.0 * u;
    p.y = ratio <= 1.0 ? 2.0 * v * s + (1.0 - s) : 2.0 * v * ratio;
    p.q = sqrt(p.x * p.x + p.y * p.y);
    q3 = p.q * p.q * p.q;
    p.angle = 1.411269 * p.q - 0.09439 * q3 + 0.25674 * q3 * p.q * p.q;
    return p;
}

static void tilt(const camera_basis *b, const place *p, pov_vec3 *dir)
{
    const double sine = p->q > 0.0 ? elementary_sin(p->angle) / p->q : 0.0;

    *dir = camera_combine(b, sine * p->x, sine * p->y, elementary_cos(p->angle));
}

static bool fisheye(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    const place p = fisheye_place(b->camera, u, v);

    (void)start;
    tilt(b, &p, dir);
    return p.q <= 1.0;
}

static bool omnimax(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    const place p = omnimax_place(b->camera, u, v);

    (void)start;
    tilt(b, &p, dir);
    return p.q <= 1.0 && elementary_sin(p.angle) * p.y + elementary_cos(p.angle) * p.q >= 0.0;
}

/* Normals are looked up by the direction on the disc, from -90 degrees to 270, and the angle to the view. */
static void polar(place p, double *x, double *y)
{
    const double pi = 3.14159265358979323846, turn = p.q > 0.0 ? elementary_asin(p.y / p.q) : 0.0;

    *x = p.x < 0.0 ? pi - turn : turn;
    *y = p.angle;
}

static void fisheye_point(const pov_camera *c, double u, double v, double *x, double *y) { polar(fisheye_place(c, u, v), x, y); }
static void omnimax_point(const pov_camera *c, double u, double v, double *x, double *y) { polar(omnimax_place(c, u, v), x, y); }

static unsigned aim_fisheye(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_each(fisheye, camera, through, n, rays);
}

static unsigned aim_omnimax(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_each(omnimax, camera, through, n, rays);
}

const camera_class camera_fisheye = { aim_fisheye, fisheye_point };
const camera_class camera_omnimax = { aim_omnimax, omnimax_point };
