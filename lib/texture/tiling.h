/* tiling.h - the plane in tiles with straight sides, which repeat along two vectors. */
#ifndef TEXTURE_TILING_H
#define TEXTURE_TILING_H

#include <stdint.h>

enum { TILING_SIDES = 12, TILING_DIRECTIONS = 24, TILINGS = 24 };

/* A convex tile: the normals of its sides, in steps of 15 degrees from x towards z, and their distances, which repeat. */
typedef struct tiling_outline {
    uint8_t sides, distances, direction[TILING_SIDES];
    double distance[4];
    uint16_t gentle;             /* bits of the sides whose depth counts by the cosine of 30 degrees */
} tiling_outline;

typedef struct tiling_tile { uint8_t outline, kind; double x, z; } tiling_tile;

typedef struct tiling {
    uint32_t kinds, count;
    double inner;                /* the distance of the smallest tile's sides from its middle */
    double across[2], along[2];  /* the vectors of the lattice, x and z */
    const tiling_tile *tiles;
} tiling;

extern const tiling_outline tiling_outlines[];
/* Number n of the language is the n-1st. */
extern const tiling tiling_table[TILINGS];

#endif
