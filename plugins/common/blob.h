/* blob.h - the components of a blob, and their field along a ray.
 *
 * Along a ray d^2 is a quadratic over each stretch within a component, a cylinder with its round ends being three of them.
 * Between the ends of all stretches the field is a quartic. Its Bernstein coefficients are sums of products of those of
 * the quadratics, so neighbours have the same value where they touch. */
#ifndef COMMON_BLOB_H
#define COMMON_BLOB_H

#include "common/boxed.h"
#include "common/runs.h"

/* A component in a space where it is the unit sphere, or what is nearer than one to the line from 0 to z = length. */
typedef struct common_blob_part {
    double m[3][4];              /* from the blob's space, scaled */
    pov_vec3 centre;             /* of a sphere that nothing has moved, scaled, and 1 / radius^2; or 0 */
    double per_square;
    double length, strength;
    pov_vec3 lo, hi;             /* its box, scaled */
    uint32_t texture, number;    /* number: in the text */
} common_blob_part;

typedef struct common_blob {
    uint32_t count, capacity;
    common_blob_part *at;
    uint32_t *by_number;         /* where a component of the text is; NULL: in the order of the text */
    double threshold;
    bool textured, written;      /* any component, be its radius 0 */
    common_boxed boxed;
    common_runs runs;
    pov_box box;                 /* around all that is inside, scaled */
} common_blob;

static inline pov_vec3 common_blob_mapped(const common_blob_part *c, pov_vec3 p, double one)
{
    return pov_vec3_of(c->m[0][0] * p.x + c->m[0][1] * p.y + c->m[0][2] * p.z + c->m[0][3] * one,
                       c->m[1][0] * p.x + c->m[1][1] * p.y + c->m[1][2] * p.z + c->m[1][3] * one,
                       c->m[2][0] * p.x + c->m[2][1] * p.y + c->m[2][2] * p.z + c->m[2][3] * one);
}

/* Far more than roundings. */
static inline bool common_blob_stays_below(const common_blob *b, double most) { return most <= b->threshold * (1.0 - 0x1p-30) && b->threshold > 0.0; }

/* A root so near to where a ray starts on the blob is that start. */
#define COMMON_BLOB_NEAR 0x1p-30

size_t common_blob_scratch(const void *self);
void common_blob_cross(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits);
void common_blob_first(const void *self, const common_entries *restrict l, common_first_crossings *restrict out);

#endif
