/* pattern.h - patterns: a number for each point, and the space in which they stand. */
#ifndef MODEL_PATTERN_H
#define MODEL_PATTERN_H

#include "model/warp.h"

#include <stddef.h>

struct pattern_class;

/* Equal patterns of a scene are one. A point goes through the map, the warps and the turbulence, in this order, to the
 * class, and the value from there through the wave. */
typedef struct pattern {
    const struct pattern_class *class;
    const void *self;            /* parsed form of its own keywords; NULL: it has none */
    const warp *warps;
    turbulence turbulence;
    wave wave;
    int noise_generator;         /* 0: the scene's */
    bool uv;                     /* points are the surface's uv coordinates instead; what moves it later leaves them */
    bool uv_turns;               /* bumps on them turn with the object and with what moves it later: it was said of a whole
                                  * texture */
    bool inner_uv;               /* points of the pigment that it asks, or of a part of that, are those coordinates */
    uint32_t map;                /* number in the model's map table of the transformations behind the last warp. It and the
                                  * next are last: they are set when the pattern is first used */
    uint32_t turn;               /* the same for normals, where those of points do not have it all; or 0 */
} pattern;

#endif
