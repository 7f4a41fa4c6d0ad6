/* part.h - the files of a picture in parts: what a part has traced, and what all parts shall trace next. */
#ifndef RENDER_PART_H
#define RENDER_PART_H

#include "base/env.h"
#include "render/identity.h"
#include "render/settings.h"

/* What both kinds of files begin with. The rest of a part: for each of its tiles the counts of the groups, with those of single pixels, then for each
 * row of pixels their halves, or where a pixel has one sample, the pixels. The rest of a round: the targets of all
 * groups, in the same way. The last part of both is the hash of all that. */
typedef struct part_head {
    identity id;
    int32_t part, round;         /* part: 0 for a round */
    int32_t decodes_srgb, transfer, alike, single;   /* alike: as in cells; single: pixels have counts of their own */
    double decode, cpu;          /* cpu: seconds, since the first round */
    pov_counts counts;
    char note[SETTINGS_NOTE];
} part_head;

/* A complete part; or of a joined job, the next round. */
pov_status part_save(pov_job *job, const char *file, pov_error *err);
/* A round; after one, the job's own part of an earlier round. */
pov_status part_load(pov_job *job, const char *file, pov_error *err);
/* The head of a part's file that was read, if that is whole. */
bool part_read_head(const char *bytes, size_t count, part_head *out);
/* Put the results of a part into the job; the head is that of `bytes`. The lock is held, or the job is nobody else's.
 * POV_E_IO: they cannot be those of this job. */
pov_status part_take(pov_job *job, const part_head *head, const char *bytes, size_t count);

#endif
