/* identity.h - what the results of a job belong to: another job may continue them only if it has the same. */
#ifndef RENDER_IDENTITY_H
#define RENDER_IDENTITY_H

#include <povtrace/render.h>

/* Written over zeros, so that padding matches too. */
typedef struct identity {
    char magic[16], version[16]; /* of the kind of file; of the library */
    uint32_t order, format;
    uint64_t scene;
    int32_t dialect, depth, exact, camera_type;
    int32_t width, height, crop[4], first_step, samples, adaptive, alpha, cell_edge;
    uint32_t seed;
    double target_error, camera[12];
    int32_t parts, ends_early;
} identity;

void identity_of(const pov_job *job, const char *magic, identity *out);
/* `what` names the kind of file. */
pov_status identity_check(const identity *theirs, const identity *ours, const char *file, const char *what, pov_error *err);
/* Is it of this version and machine, so that the other members mean what they say? */
bool identity_is_ours(const identity *theirs);

#endif
