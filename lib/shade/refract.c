#include "shade/refract.h"

#include "shade/geometry.h"

/* The squared cosine behind the surface, c'^2 = 1 - (eta s)^2 = (eta c)^2 - e with e = eta^2 - 1, where s is the sine
 * before it. Steep rays use the first form, because a large eta multiplies the error of s by less than that of c^2.
 * Grazing ones use the second, in which (before - after)(before + after) keeps the accuracy for an ior of 1 + 1e-11. */
static inline double squared_cosine(double sine_out, double cosine, double before, double after)
{
    const double steep = 0.5, eta = before / after;
    const double e = eta * ((before - after) / before) * ((before + after) / after);
    const double critical = sqrt(e > 0.0 ? e : 0.0);
    const double flat = e <= 0.0 ? eta * cosine * eta * cosine - e
                                 : (eta * cosine - critical) * (eta * cosine + critical);

    return cosine > steep ? (1.0 - sine_out) * (1.0 + sine_out) : flat;
}

/* The direction behind the surface, of about unit length; returns the result of squared_cosine(). */
static inline double refracted(pov_vec3 view, pov_vec3 normal, double cosine, double before, double after, pov_vec3 *out)
{
    pov_vec3 along = pov_add(view, pov_scale(normal, cosine));
    double c2;

    along = pov_scale(pov_sub(along, pov_scale(normal, pov_dot(along, normal))), before / after);
    c2 = squared_cosine(sqrt(pov_dot(along, along)), cosine, before, after);
    *out = pov_sub(along, pov_scale(normal, sqrt(c2 > 0.0 ? c2 : 0.0)));
    return c2;
}

bool refract(pov_vec3 view, pov_vec3 normal, double cosine, double before, double after, pov_vec3 *out)
{
    const double c2 = refracted(view, normal, cosine, before, after, out);

    *out = pov_unit(*out);
    return c2 > 0.0;
}

/* False: the squared length of some direction is out of range. */
SIMD_CLONES static bool refract_plain(refraction_lanes *restrict b, const vec_lanes *restrict view, const vec_lanes *restrict normal,
                                   const double *restrict cosines, uint32_t n)
{
    int64_t plain = -1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 dir;

        b->squared_cosine[i] = refracted(lanes_at(view, i), lanes_at(normal, i), cosines[i], b->before[i], b->after[i],
                                    &dir);
        plain &= geometry_unit(dir.x, dir.y, dir.z, &dir);
        lanes_put(&b->dir, i, dir);
    }
    return plain != 0;
}

void refract_lanes(refraction_lanes *b, const vec_lanes *view, const vec_lanes *normal, const double *cosines, uint32_t n)
{
    if (refract_plain(b, view, normal, cosines, lanes_whole(n)))
        return;
    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 dir;

        refract(lanes_at(view, i), lanes_at(normal, i), cosines[i], b->before[i], b->after[i], &dir);
        lanes_put(&b->dir, i, dir);
    }
}
