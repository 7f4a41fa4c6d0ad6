#include "model/image.h"
#include "texture/pattern.h"

/* A volume fills the unit cube; voxel i begins at i / n, and neighbours repeat. Outside it is 0. */

static double voxel(const density_file *d, int64_t x, int64_t y, int64_t z)
{
    const int64_t nx = d->size[0], ny = d->size[1], nz = d->size[2];
    const size_t index = (size_t)((((z % nz + nz) % nz) * ny + (y % ny + ny) % ny) * nx + (x % nx + nx) % nx);
    const unsigned char *at = d->samples + index * d->bytes;
    uint32_t value = 0, most = 0;

    for (uint32_t i = 0; i < d->bytes; i++) {
        value = value << 8 | at[i];
        most = most << 8 | 255u;
    }
    return (double)value / most;
}

/* Weights of the voxels before, at, behind, and two behind. */
static void find_weights(int32_t interpolation, double t, double w[4])
{
    if (interpolation == 2) {
        w[0] = 0.5 * t * (-1.0 + t * (2.0 - t));
        w[1] = 1.0 + 0.5 * t * t * (-5.0 + 3.0 * t);
        w[2] = 0.5 * t * (1.0 + t * (4.0 - 3.0 * t));
        w[3] = 0.5 * t * t * (-1.0 + t);
    } else {
        w[0] = w[3] = 0.0;
        w[1] = interpolation == 1 ? 1.0 - t : 1.0;
        w[2] = interpolation == 1 ? t : 0.0;
    }
}

static double sum_voxels(const density_file *d, const int64_t low[3], double w[3][4])
{
    double sum = 0.0;

    for (int k = 0; k < 4; k++)
        for (int j = 0; j < 4; j++)
            for (int i = 0; i < 4; i++) {
                const double weight = w[0][i] * w[1][j] * w[2][k];

                if (weight != 0.0)
                    sum += weight * voxel(d, low[0] + i - 1, low[1] + j - 1, low[2] + k - 1);
            }
    return sum;
}

static double value_at(const density_file *d, pov_vec3 p)
{
    const double at[3] = { p.x, p.y, p.z };
    int64_t low[3];
    double w[3][4], sum;

    for (int a = 0; a < 3; a++) {
        const double scaled = at[a] * d->size[a];

        if (!(at[a] >= 0.0 && at[a] < 1.0))
            return 0.0;
        low[a] = (int64_t)scaled;
        find_weights(d->interpolation, scaled - (double)low[a], w[a]);
    }
    sum = sum_voxels(d, low, w);
    return sum > 0.0 ? sum : 0.0;
}

static void evaluate(const pattern_input *in, double *value)
{
    const density_file *d = in->of->self;

    for (uint32_t i = 0; i < in->n; i++)
        value[i] = d->samples ? value_at(d, lanes_at(in->at, i)) : 0.0;
}

static const char *check(const void *self)
{
    const int32_t interpolation = ((const density_file *)self)->interpolation;

    return interpolation >= 0 && interpolation <= 2 ? NULL : "\"interpolate\" of a volume must be 0, 1 or 2";
}

static const pattern_word words[] = { { "interpolate", PATTERN_INTEGER, offsetof(density_file, interpolation), false } };

const pattern_class pattern_density_file = {
    .keyword = "density_file",
    .self_size = sizeof(density_file),
    .words = words,
    .word_count = 1,
    .check = check,
    .flags = PATTERN_FILE,
    .evaluate = evaluate,
};
