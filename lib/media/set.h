/* set.h - the media that act on a segment of a ray, and what they are at its points. */
#ifndef MEDIA_SET_H
#define MEDIA_SET_H

#include "base/lanes.h"
#include "model/model.h"
#include "texture/texture.h"

/* Segments in more media than this are seen as if the first ones were all. */
enum { MEDIA_SET_MAX = 32 };

/* leaf: the object whose inside it fills; MEDIA_AIR: it is of the atmosphere. */
#define MEDIA_AIR UINT32_MAX
typedef struct media_member { const medium *medium; uint32_t leaf; } media_member;

typedef struct media_set {
    uint32_t count;
    bool varies;                 /* some density does */
    bool dims, shines, scatters;
    uint32_t strata;             /* the most that one of them asks for */
    media_member of[MEDIA_SET_MAX];
} media_set;

/* A piece of a ray: unit direction. */
typedef struct media_segment { pov_vec3 from, dir; double length; } media_segment;

/* Sums over the media by channel and lane, per unit of length: lost light, own light, scattered light. Each is set if some of the media
 * does it: if the set dims, shines, scatters. */
typedef struct media_optics { double loss[3][LANES_MAX], emitted[3][LANES_MAX], scatter[3][LANES_MAX]; } media_optics;

void media_set_add(media_set *s, const media *m, uint32_t leaf);
/* Are they the same media, in the same order? */
bool media_set_same(const media_set *a, const media_set *b);
/* At points of the segment, n <= LANES_MAX. Light from `by` alone is scattered, as light groups have it; NULL: any. */
void media_set_at(const model *m, const media_set *s, const media_segment *on, const double *at, uint32_t n,
                  const light *by, media_optics *out);
/* The same at points of several segments; the set varies. Lanes behind the last one, up to lanes_whole(n), are as some of the points. */
void media_set_at_points(const model *m, const media_set *s, const texture_points *points, uint32_t n, const light *by, media_optics *out);
/* What one channel of light loses, is given, and what of it is scattered, per unit of length. */
typedef struct media_channel { double loss, emitted, scatter; } media_channel;
/* The same where no density varies, and so at all points. */
void media_set_even(const model *m, const media_set *s, const light *by, media_channel out[3]);
/* Does any of them scatter this light? */
bool media_set_scatters(const model *m, const media_set *s, const light *by);

#endif
