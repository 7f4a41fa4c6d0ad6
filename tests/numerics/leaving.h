/* leaving.h - rays that leave a surface: the start must not be met again, and the other side must not be lost. */
#ifndef NUMERICS_LEAVING_H
#define NUMERICS_LEAVING_H

#include "numerics/probe.h"

enum { CROSSINGS_MAX = 8, OWNER = 7 };

/* An instance, and how it is asked. */
typedef struct subject {
    const shape_class *shape;
    const void *self;
    bool always_exact;
} subject;

/* All crossings in front of the origin, in growing order. Gives how many. */
uint32_t subject_ask(const subject *s, const pov_ray *ray, pov_crossing at[CROSSINGS_MAX], uint32_t *escalated);

/* From the crossing into any direction; half of them are tilted against the surface, by 1e-6 at least. */
pov_vec3 leaving_direction(pov_vec3 normal);
pov_ray leaving_ray(const pov_ray *ray, const pov_crossing *c, pov_vec3 direction);

typedef enum leaving_verdict { LEFT_WELL, HIT_ITSELF, LEAKED, MISPLACED, NOT_JUDGED } leaving_verdict;

/* For a probe whose ray is leaving_ray()'s, from a crossing with this normal, `dir` along a ray. Exact; resets no
 * reals. *expected is the number of crossings. */
leaving_verdict leaving_judge(const subject *s, const probe *q, const pov_crossing *c, double dir, pov_vec3 normal,
                              int *expected);

/* The unit in the last place that errors of t are held against, for this kind: 16, 32, 4 or 64. */
double probe_limit(kind k);
double probe_ulps_off(real exact, double t);
/* Keeps the crossings in front of the origin. False: a distance is out of the range of doubles, or of all reason. */
bool probe_keep_positive(exact_result *e, const probe *p);
/* How far the direction reaches in one unit of t. */
double probe_speed(const probe *p);

#endif
