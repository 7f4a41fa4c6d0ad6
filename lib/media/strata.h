/* strata.h - divides a segment into strata, each with one random point. */
#ifndef MEDIA_STRATA_H
#define MEDIA_STRATA_H

#include "base/lanes.h"
#include "base/mix.h"
#include "media/set.h"

/* Lengths from this on count as without end; scale: how far away the scene's objects are. */
#define MEDIA_ENDLESS 1e10

/* edge[0..count]. */
enum { MEDIA_STRATA_MAX = 4 * LANES_MAX };
typedef struct media_strata { uint32_t count; double edge[MEDIA_STRATA_MAX + 1]; } media_strata;

/* What divides the segment between lo and hi into about `wanted` strata (at most MEDIA_STRATA_MAX): equal lengths; and where
 * the light comes through matter that is dense, equal losses; and around a place that matters, equal angles. All of
 * them together, so that nowhere a stratum is too large. */
typedef struct media_division {
    double lo, hi, scale;
    uint32_t wanted;
    double loss;                 /* per unit of length; 0: not known, or none */
    bool has_middle;
    double middle, distance;     /* of the place: its nearest point on the line, and how far it is from there */
} media_division;

void media_divide(const media_division *by, media_strata *out);

/* Random numbers of a segment: a number of its own for each purpose, and turned by the same amount. Samples of a pixel
 * that have one key and turns that are spread evenly have numbers that are, too. */
typedef struct media_random { uint64_t key; double turn; } media_random;

/* By the segment alone. */
media_random media_random_of(const media_segment *s);
/* 0 <= u < 1. */
static inline double media_number(const media_random *r, uint32_t number)
{
    const double u = (double)(mix_bits(r->key + (uint64_t)(number + 1) * 0x9E3779B97F4A7C15u) >> 11) * 0x1p-53 + r->turn;

    return u < 1.0 ? u : u - 1.0;
}
/* The same for a point in a stratum: neighbours lie on opposite sides of the middles of theirs, so that what changes evenly
 * along the segment has no noise. */
static inline double media_jitter(const media_random *r, uint32_t number)
{
    const double u = media_number(r, number & ~1u);

    return number & 1 ? (1.0 - 0x1p-53) - u : u;
}

#endif
