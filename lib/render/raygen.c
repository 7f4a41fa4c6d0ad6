#include "render/raygen.h"

#include "base/simd.h"

#include <float.h>

/* Where a place between 0 and `size` lies in -1/2 .. 1/2, symmetric to the bit about the middle. */
static inline double centred(int pixel, double within, int size)
{
    return (((double)pixel - 0.5 * size) + within) / size;
}

static inline pov_vec3 direction(const pov_camera *camera, int width, int height, int x, int y, double dx, double dy)
{
    double u = centred(x, dx, width), v = -centred(y, dy, height);

    return pov_add(camera->direction, pov_add(pov_scale(camera->right, u), pov_scale(camera->up, v)));
}

pov_ray raygen_ray(const pov_camera *camera, int width, int height, int x, int y, double dx, double dy)
{
    pov_ray ray = { .org = camera->location, .left = POV_NOBODY };

    ray.dir = direction(camera, width, height, x, y, dx, dy);
    return ray;
}

void raygen_begin(const pov_camera *camera, pov_ray *rays, uint32_t n)
{
    const pov_ray ray = { .org = camera->location, .left = POV_NOBODY };

    for (uint32_t i = 0; i < n; i++)
        rays[i] = ray;
}

/* Directions by lane, so that the loop becomes vectors. False: some direction may be none, or not a number. */
SIMD_CLONES static bool aim(const pov_camera *camera, int width, int height, const raygen_places *p, uint32_t n,
                            double (*out)[RAYGEN_MANY])
{
    int sound = 1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 d = direction(camera, width, height, p->x[i], p->y[i], p->dx[i], p->dy[i]);
        const double size = fabs(d.x + d.y + d.z);

        out[0][i] = d.x;
        out[1][i] = d.y;
        out[2][i] = d.z;
        sound &= (size > 0.0) & (size <= DBL_MAX);
    }
    return sound;
}

bool raygen_aim(const pov_camera *camera, int width, int height, const raygen_places *through, uint32_t n,
                pov_ray *rays)
{
    double to[3][RAYGEN_MANY];
    const bool sound = aim(camera, width, height, through, n, to);

    for (uint32_t i = 0; i < n; i++)
        rays[i].dir = pov_vec3_of(to[0][i], to[1][i], to[2][i]);
    return sound;
}
