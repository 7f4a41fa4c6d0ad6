#include "render/camera.h"

#include "shade/tracer.h"

#include <float.h>

/* Starts by lane; false: some may be none. */
SIMD_CLONES static bool find_starts(const pov_camera *camera, const raygen_screen *restrict through, uint32_t n,
                                    vec_lanes *restrict out)
{
    int sound = 1;

    for (uint32_t i = 0; i < n; i++) {
        const pov_vec3 across = pov_scale(camera->right, through->u[i]), up = pov_scale(camera->up, through->v[i]);
        const pov_vec3 start = pov_add(camera->location, pov_add(across, up));

        lanes_put(out, i, start);
        sound &= fabs(start.x + start.y + start.z) <= DBL_MAX;
    }
    return sound;
}

static unsigned aim(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    const double size = pov_largest(camera->direction);
    vec_lanes starts;
    const bool sound = find_starts(camera, through, n, &starts);

    for (uint32_t i = 0; i < n; i++) {
        rays[i].org = lanes_at(&starts, i);
        rays[i].dir = camera->direction;
    }
    return sound && size > 0.0 && size <= DBL_MAX ? TRACER_SOUND : 0;
}

const camera_class camera_orthographic = { aim, NULL };
