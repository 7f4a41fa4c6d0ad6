/* probe.h - one question: a shape by its numbers and a ray; and the exact answer to it. */
#ifndef NUMERICS_PROBE_H
#define NUMERICS_PROBE_H

#include "numerics/real.h"

#include "plug/shape_class.h"

enum { PROBE_NUMBERS = 64, PROBE_CROSSINGS = 4 };

/* A mesh has one face. */
typedef enum kind {
    SPHERE, BOX, CONE, CYLINDER, QUADRIC, POLYGON, TRIANGLE, MESH, SMOOTH_TRIANGLE, TORUS, PLANE, DISC, KINDS
} kind;

static inline bool kind_has_corners(kind k) { return k == POLYGON || k == TRIANGLE || k == MESH || k == SMOOTH_TRIANGLE; }
static inline bool kind_is_planar(kind k) { return kind_has_corners(k) || k == DISC; }

/* The numbers stand in the order of the scene text: vectors as three. A polygon's begin with its count of
 * points; those of a triangle are a polygon's of three corners, the first of them again at the end; its normals are that
 * of its plane. */
typedef struct probe {
    kind kind;
    int count;
    double number[PROBE_NUMBERS];
    bool open;              /* cones and cylinders */
    pov_ray ray;
    double size;            /* of the shape; errors of points and normals are measured by it */
} probe;

typedef struct exact_crossing {
    real t;
    uint32_t feature;
    double normal[3];
    double clearance;       /* to where the surface has no normal: about the way to a cone's apex */
} exact_crossing;

typedef struct exact_result {
    int count;
    exact_crossing at[PROBE_CROSSINGS];   /* on the whole line, in growing order */
} exact_result;

/* The exact answer, in 512 bits, on the same doubles. Uses numbers of the pool. */
void probe_exact(const probe *p, exact_result *out);
/* The same with a ray that no doubles could hold. Not for polygons. */
void probe_exact_line(const probe *p, real3 org, real3 dir, exact_result *out);

const char *probe_keyword(kind k);
/* The normal that a smooth triangle has at its corners: that of its plane. */
void probe_flat_normal(const probe *p, double normal[3]);
/* The shape, parsed by its plugin into memory of the class's size. */
bool probe_make(const probe *p, const shape_class *shape, pov_reader *in, void *self);

/* All lengths times a power of two. */
void probe_scale(probe *p, double power);

/* A probe as one line of hexadecimal numbers, and back. */
void probe_write(const probe *p, char *line, size_t size);
bool probe_read(probe *p, const char *line);

#endif
