/* fog.h - what fog does on segments of paths, by lane. */
#ifndef SHADE_FOG_H
#define SHADE_FOG_H

#include "base/lanes.h"
#include "model/model.h"

/* Directions are unit vectors; a length is HUGE_VAL where nothing is hit. */
typedef struct SIMD_ALIGNED fog_segments {
    vec_lanes from, dir;
    double length[LANES_MAX];
    uint32_t count;              /* at least 1; lanes up to lanes_whole(count) are there */
} fog_segments;

/* What is behind becomes by x behind + given. */
typedef struct SIMD_ALIGNED fog_veils { float by[3][LANES_MAX], given[3][LANES_MAX]; } fog_veils;

/* Of several fogs each adds its own light, whatever the others let through. */
void fog_find(const model *m, const fog_segments *s, fog_veils *out);
/* Fill the lanes behind the last one. */
void fog_fill(fog_segments *s);

#endif
