/* findings.h - the kinds of rays by which an attack from outside found faults, N1 to N7, as families. */
#ifndef NUMERICS_FINDINGS_H
#define NUMERICS_FINDINGS_H

#include "numerics/families.h"

enum { MATRIX = 12 };

/* What is asked: the nearest hit of a ray; whether a segment is blocked; whether a light's own place on a shape reaches a
 * wall. */
typedef enum asks { A_RAY, A_SEGMENT, A_LIGHT } asks;

/* A shape in a scene, and a ray in the world. */
typedef struct question {
    probe p;                    /* its ray is the world's */
    bool mapped;
    double matrix[MATRIX];      /* as the scene's word has them: rows for x, y, z and the translation */
    pov_vec3 on, normal;        /* a point that rays start at or end on, and the normal there: near enough, in double */
    pov_vec3 to;                /* of segments */
} question;

typedef struct finding {
    const char *name;
    uint32_t kinds;             /* bit k: kind k has it */
    asks what;
    int bits;                   /* of the exact answer: a denormal number beside 1 takes many */
    double normal;              /* radians that the promise gives normals */
    void (*make)(question *q, double parameter);    /* the shape and the point; q->p.kind is set */
    double make_parameter;
    void (*aim)(question *q, double parameter);     /* a ray, a segment, or the place of a light */
    double aim_parameter;
} finding;

/* Ends with a NULL name. */
extern const finding findings[];

#endif
