#include "render/camera.h"

#include "shade/tracer.h"

#include <float.h>

/* By lane, so that the loop becomes vectors. False: some direction may be none, or not a number. */
SIMD_CLONES static bool find_directions(const pov_camera *camera, const raygen_screen *restrict through, uint32_t n,
                                        vec_lanes *restrict out)
{
    int sound = 1;

    for (uint32_t i = 0; i < n; i++) {
        const pov_vec3 across = pov_scale(camera->right, through->u[i]), up = pov_scale(camera->up, through->v[i]);
        const pov_vec3 d = pov_add(camera->direction, pov_add(across, up));
        const double size = fabs(d.x + d.y + d.z);

        lanes_put(out, i, d);
        sound &= (size > 0.0) & (size <= DBL_MAX);
    }
    return sound;
}

static unsigned aim(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    const pov_vec3 from = camera->location;
    vec_lanes directions;
    const bool sound = find_directions(camera, through, n, &directions);

    for (uint32_t i = 0; i < n; i++)
        rays[i].dir = lanes_at(&directions, i);
    return TRACER_ONE_START | (sound && isfinite(from.x + from.y + from.z) ? TRACER_SOUND : 0);
}

const camera_class camera_perspective = { aim, NULL };
