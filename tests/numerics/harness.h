/* harness.h - ask plugins and the exact reference the same, and keep the score. */
#ifndef NUMERICS_HARNESS_H
#define NUMERICS_HARNESS_H

#include "numerics/families.h"

typedef struct score {
    long rays, rejected;            /* rejected: shapes that parse refused, distances no double can hold */
    long crossings;
    long miss_false, hit_false;     /* crossings said not to be there that are, and the other way round */
    long part_false;                /* found, under a wrong name */
    long escalated;                 /* rays that double-double arithmetic decided */
    long spawned, selfhit, leak;    /* rays that left the surface; met it again; lost the other side */
    long exact_differs;             /* always_exact found another number of crossings */
    long scale_differs;             /* scaled by a power of two, the bits were others */
    double ulp_median, ulp_p99, ulp_max, normal_max, point_max;
    double ns_median, ns_iqr;       /* for a ray */
    char worst[4096];               /* the probe of ulp_max, or of the first failure */
} score;

/* A way to intersect. The first of a harness is ours, which is held to everything; the others are asked the same rays
 * and timed in turn with it. */
typedef struct method {
    const char *name;
    const char *folder;             /* of its plugins, below the build's */
    bool always_exact;
    bool rival;                     /* not ours: its failures are counted, and no news */
} method;

enum { METHODS_MAX = 8 };

typedef struct harness harness;

harness *harness_create(const method *methods, int count);
void harness_destroy(harness *h);

/* `rays` probes of a family, a score for each method. Failures of ours are printed as lines that replay.txt can hold,
 * eight at most. */
void harness_run(harness *h, kind k, const family *f, long rays, uint64_t seed, score *out);
/* One probe alone. */
void harness_replay(harness *h, const probe *p, score *out);

#endif
