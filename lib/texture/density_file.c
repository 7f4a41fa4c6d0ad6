#include "model/image.h"
#include "texture/pattern.h"

/* A volume fills the unit cube; voxel i begins at i / n, and neighbours repeat. Outside it is 0. The voxel before the first is
 * 2^64 - 1 modulo their number, as in POV-Ray: the last only where that is a power of two. */

static double voxel(const density_file *d, size_t index)
{
    const unsigned char *at = d->samples + index * d->bytes;
    uint32_t value = 0, most = 0;

    if (d->bytes == 1)
        return *at / 255.0;
    for (uint32_t i = 0; i < d->bytes; i++) {
        value = value << 8 | at[i];
        most = most << 8 | 255u;
    }
    return (double)value / most;
}

/* Along one axis: weights of the voxels before, at, behind, and two behind, and where they are. */
typedef struct neighbours { double weight[4]; size_t at[4]; } neighbours;

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

static void find_neighbours(const density_file *d, int axis, double at, neighbours *out)
{
    const double scaled = at * d->size[axis];
    const uint64_t low = (uint64_t)scaled, n = d->size[axis];

    find_weights(d->interpolation, scaled - (double)low, out->weight);
    for (int i = 0; i < 4; i++)
        out->at[i] = out->weight[i] != 0.0 ? (size_t)((low + (uint64_t)i - 1) % n) : 0;
}

static double sum_voxels(const density_file *d, const neighbours by[3])
{
    const neighbours *x = &by[0], *y = &by[1], *z = &by[2];
    const size_t nx = d->size[0], ny = d->size[1];
    const int first = d->interpolation == 2 ? 0 : 1, end = d->interpolation == 2 ? 4 : 2 + d->interpolation;
    double sum = 0.0;

    for (int k = first; k < end; k++)
        for (int j = first; j < end; j++)
            for (int i = first; i < end; i++) {
                const double weight = x->weight[i] * y->weight[j] * z->weight[k];

                if (weight != 0.0)
                    sum += weight * voxel(d, (z->at[k] * ny + y->at[j]) * nx + x->at[i]);
            }
    return sum;
}

static double value_at(const density_file *d, pov_vec3 p)
{
    const double at[3] = { p.x, p.y, p.z };
    neighbours by[3];
    double sum;

    for (int axis = 0; axis < 3; axis++)
        if (!(at[axis] >= 0.0 && at[axis] < 1.0))
            return 0.0;
    for (int axis = 0; axis < 3; axis++)
        find_neighbours(d, axis, at[axis], &by[axis]);
    sum = sum_voxels(d, by);
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
