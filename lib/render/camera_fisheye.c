/* Round pictures: fisheye, omnimax. */
#include "base/elementary.h"
#include "render/camera_wide.h"

/* Where on the disc, which has the radius 1, and how far from the view. */
typedef struct place { double x, y, q, angle; } place;

/* Lengths of the camera's right and up. */
typedef struct screen { double width, height, angle; } screen;

static screen screen_of(const pov_camera *c)
{
    const screen s = { camera_length(c->right), camera_length(c->up), c->angles[0] };

    return s;
}

SIMD_INLINE place fisheye_place(const screen *s, double u, double v)
{
    place p = { 2.0 * u * s->width, 2.0 * v * s->height, 0.0, 0.0 };

    p.q = sqrt(p.x * p.x + p.y * p.y);
    p.angle = 0.5 * p.q * s->angle;
    return p;
}

/* A dome that leans back by 45 degrees; the polynomial was measured on POV-Ray's pictures. */
SIMD_INLINE place omnimax_place(const screen *c, double u, double v)
{
    const double ratio = c->height / c->width, least = 0.7791453;   /* 45 degrees below the view at the lower edge */
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

SIMD_INLINE pov_vec3 tilted(const camera_basis *b, const place *p, double cosine, double sine)
{
    const double by = p->q > 0.0 ? sine / p->q : 0.0;

    return camera_combine(b, by * p->x, by * p->y, cosine);
}

SIMD_CLONES static void fisheye(const camera_basis *restrict b, const raygen_screen *restrict through, uint32_t n, camera_lanes *restrict out)
{
    const screen s = { b->width, b->height, b->camera->angles[0] };

    for (uint32_t i = 0; i < n; i++) {
        const place p = fisheye_place(&s, through->u[i], through->v[i]);

        lanes_put(&out->dir, i, tilted(b, &p, elementary_cos(p.angle), elementary_sin(p.angle)));
        out->black[i] = p.q <= 1.0 ? 0.0 : 1.0;
    }
}

SIMD_CLONES static void omnimax(const camera_basis *restrict b, const raygen_screen *restrict through, uint32_t n, camera_lanes *restrict out)
{
    const screen s = { b->width, b->height, 0.0 };

    for (uint32_t i = 0; i < n; i++) {
        const place p = omnimax_place(&s, through->u[i], through->v[i]);
        const double cosine = elementary_cos(p.angle), sine = elementary_sin(p.angle), below = sine * p.y + cosine * p.q >= 0.0 ? 0.0 : 1.0;

        lanes_put(&out->dir, i, tilted(b, &p, cosine, sine));
        out->black[i] = p.q <= 1.0 ? below : 1.0;
    }
}

/* Normals are looked up by the direction on the disc, from -90 degrees to 270, and the angle to the view. */
static void polar(place p, double *x, double *y)
{
    const double pi = 3.14159265358979323846, turn = p.q > 0.0 ? elementary_asin(p.y / p.q) : 0.0;

    *x = p.x < 0.0 ? pi - turn : turn;
    *y = p.angle;
}

static void fisheye_point(const pov_camera *c, double u, double v, double *x, double *y)
{
    const screen s = screen_of(c);

    polar(fisheye_place(&s, u, v), x, y);
}

static void omnimax_point(const pov_camera *c, double u, double v, double *x, double *y)
{
    const screen s = screen_of(c);

    polar(omnimax_place(&s, u, v), x, y);
}

static unsigned aim_fisheye(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_along(fisheye, camera, through, n, rays);
}

static unsigned aim_omnimax(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_along(omnimax, camera, through, n, rays);
}

const camera_class camera_fisheye = { aim_fisheye, fisheye_point };
const camera_class camera_omnimax = { aim_omnimax, omnimax_point };
