/* march.h - what media do to light along a segment: its loss, their own light, and the light of lamps that they scatter.
 *
 * Where densities are constant, loss and own light are closed forms. Else both are sums over strata with one random
 * point each: the sums are unbiased, and the bias of the loss, which is an exponential of one, is half their variance. */
#ifndef MEDIA_MARCH_H
#define MEDIA_MARCH_H

#include "light/light.h"
#include "media/strata.h"

/* Optical depths at the edges of strata; and if there are few of them, the points in them and what is scattered there by
 * any light. */
typedef struct media_table {
    media_strata strata;
    double depth[3][MEDIA_STRATA_MAX + 1];
    bool reused;                 /* these are there; where no density varies, only the first of `scatter` */
    double at[LANES_MAX], scatter[3][LANES_MAX];
} media_table;

typedef struct media_march {
    const model *model;
    const media_set *set;
    media_segment on;
    double scale;                /* how far away the scene's objects are */
    double weight;               /* largest part of the light that the path leaves: less light needs fewer samples */
    media_random random;
    colour through, given;       /* what is left of light from behind, and the media's own */
    media_table table;
} media_march;

/* Begin with model, set, on, scale, weight and random: the rest is set. */
void media_march_begin(media_march *l);
/* Transmittance of the segment alone, for shadows. */
colour media_transmittance(const model *m, const media_set *s, const media_segment *on);
/* The same of n segments in media that vary, n <= MEDIA_TOGETHER. */
enum { MEDIA_TOGETHER = 8 };
void media_transmittances(const model *m, const media_set *s, const media_segment *on, uint32_t n, colour *out);
/* In sets that do not vary, segments side by side: their depths, and what is left of light behind n of them. */
typedef struct media_depths { double by[3][LANES_MAX]; } media_depths;
void media_depths_put(const model *m, const media_set *s, double length, uint32_t i, media_depths *out);
void media_depths_left(const media_depths *d, uint32_t n, colour *out);

/* Points of the segment that a light may reach: what each gives to the ray's colour if the light is not occluded there,
 * and the light at the points. */
typedef struct media_samples {
    uint32_t count;
    double at[LANES_MAX];        /* along the segment */
    vec_lanes point, point_lo;
    light_lanes in;
    colour value[LANES_MAX];
} media_samples;

/* False: the light gives nothing. number: of the light, for its random numbers. */
bool media_sample_light(const media_march *l, const light *from, const light_class *class, uint32_t number,
                        media_samples *out);

/* Light from somewhere else at points of the segment: where it comes from, unit vectors; n <= LANES_MAX. */
typedef struct media_light { uint32_t count; double at[LANES_MAX]; pov_vec3 from[LANES_MAX]; colour light[LANES_MAX]; } media_light;

/* What of it is scattered to the beginning of the segment and left there, by length. */
colour media_scattered(const media_march *l, const media_light *in);

#endif
