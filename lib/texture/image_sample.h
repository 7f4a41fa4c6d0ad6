/* image_sample.h - values of images between their pixels. */
#ifndef TEXTURE_IMAGE_SAMPLE_H
#define TEXTURE_IMAGE_SAMPLE_H

#include "base/lanes.h"
#include "model/image.h"

/* Where a point lies on an image: 0..1 from the left and from the bottom, repeating. */
typedef struct image_place { double u, v; bool is_outside; } image_place;   /* outside: of one that does not repeat */

image_place image_place_at(const image_map *map, pov_vec3 point);
/* The same of n points side by side; those up to lanes_whole(n) are there. */
void image_places(const image_map *map, const vec_lanes *at, uint32_t n, image_place *out);
/* Decoded, with the map's filter and transmit. */
pigment image_colour(const image_map *map, image_place at);
/* The same of n points side by side, where image_has_lanes(). */
bool image_has_lanes(const image_map *map);
void image_colours(const image_map *map, const vec_lanes *at, uint32_t n, pigment *out);
/* The brightness of the colour. */
double image_grey(const image_map *map, image_place at);
/* The number that a pixel stands for: of its palette's entry, or 0 to 255 of red or grey. Interpolated where the map is. */
double image_index(const image_map *map, image_place at);
/* The largest that each component of a colour can be. */
pigment image_most(const image_map *map);

static inline double image_grey_of(colour c)
{
    return 0.297f * c.r + 0.589f * c.g + 0.114f * c.b;
}

#endif
