/* steep.h - normals at the corners of a grid of heights, as POV-Ray has them. */
#ifndef COMMON_STEEP_H
#define COMMON_STEEP_H

#include "common/local.h"

/* More corners than rays will see are not worth keeping. */
enum { COMMON_STEEPS_MOST = 1 << 20 };

/* A normal as POV-Ray keeps it. */
typedef struct common_steep { int16_t x, y, z; } common_steep;

typedef struct common_steeps {
    uint32_t wide, deep;         /* corners */
    const uint16_t *height;      /* in 1/65536, rows along x */
    const common_steep *at;      /* NULL: there are too many */
} common_steeps;

void common_steeps_make(common_steeps *s, const pov_host *host, pov_reader *in);
/* Unit normals at the corners of a cell: x and z, x + 1 and z, x and z + 1, both and 1. */
void common_steeps_of_cell(const common_steeps *s, uint32_t x, uint32_t z, pov_vec3 normal[4]);

#endif
