/* matter.h - the media in the strata of a march's table: at one random point of each, and at more of them where they change fast.
 *
 * Whether a pair of strata is split is decided by the pairs beside it, never by its own points, which therefore stay evenly
 * spread: sums over strata stay unbiased. */
#ifndef MEDIA_MATTER_H
#define MEDIA_MATTER_H

#include "media/march.h"

/* The optics stand in blocks of lanes. */
typedef struct media_matter { double at[MEDIA_STRATA_MAX]; media_optics of[MEDIA_STRATA_MAX / LANES_MAX]; } media_matter;

static inline uint32_t matter_block(const media_strata *s, uint32_t first)
{
    return s->count - first < LANES_MAX ? s->count - first : LANES_MAX;
}

void matter_find(const media_march *l, media_matter *out);
/* Strata to split, as bits: at most LANES_MAX of them, whose depths are known. */
uint64_t matter_uneven(const media_march *l, const media_matter *m);
/* Those strata are split; their points remain. */
void matter_split(media_march *l, const media_matter *m, uint64_t which, media_matter *out);

#endif
