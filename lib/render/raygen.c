#include "render/raygen.h"

/* Where a place between 0 and `size` lies in -1/2 .. 1/2, symmetric to the bit about the middle. */
static double centred(int pixel, double within, int size)
{
    return (((double)pixel - 0.5 * size) + within) / size;
}

pov_ray raygen_ray(const pov_camera *camera, int width, int height, int x, int y, double dx, double dy)
{
    double u = centred(x, dx, width), v = -centred(y, dy, height);
    pov_vec3 across = pov_add(pov_scale(camera->right, u), pov_scale(camera->up, v));
    pov_ray ray = { .org = camera->location, .dir = pov_add(camera->direction, across), .left = POV_NOBODY };

    return ray;
}
