/* texture.h - pigments, normals and textures: trees whose inner nodes blend their members by a pattern, by weights or as
 * layers. They never change once made, and those of a scene that are equal are one. */
#ifndef MODEL_TEXTURE_H
#define MODEL_TEXTURE_H

#include "model/colour.h"
#include "model/finish.h"
#include "model/pattern.h"

/* How a node's members are put together at a point. */
typedef enum blend {
    BLEND_NONE,                  /* no members: constant, or the pattern gives the colour itself */
    BLEND_MAP,                   /* the pattern's value lies between those of two members, which are mixed */
    BLEND_LIST,                  /* the pattern's value is the number of a member */
    BLEND_AVERAGE,               /* all, by weights; the pattern has only a space */
    BLEND_PARTS,                 /* of a surface with parts: what the shape says there, or the last one; no pattern */
    BLEND_LAYERS                 /* of textures: the last one on top; no pattern */
} blend;

/* ---- pigments ---- */

/* What a pigment is at one point. */
typedef struct pigment { colour color; float filter, transmit; } pigment;

typedef struct pigment_node {
    blend blend;
    bool own_map;                /* no map was written: this is the pattern's own, which another pattern does not take over */
    uint32_t count;              /* of members: either colours or pigments */
    const pattern *pattern;      /* NULL: constant */
    const float *values;         /* of a map, or the weights of an average */
    const pigment *colours;
    const struct pigment_node *const *pigments;
    const pattern *space;        /* of a constant: what was written of a pattern that may come; or NULL */
    const struct pigment_node *map;     /* of a constant: the members that this pattern then chooses from; or NULL */
    const struct pigment_node *draft;   /* what it is in drafts; NULL: itself */
    pigment most;                /* the constant; where it varies, the largest that each component can be: what is zero
                                  * there is zero everywhere */
} pigment_node;

/* ---- normals ---- */

typedef struct slope_entry { float height, slope; } slope_entry;

typedef struct normal_node {
    blend blend;
    uint32_t count;              /* of members; of BLEND_NONE: of slopes, or 0 */
    const pattern *pattern;      /* NULL: the surface's own normal */
    const pattern *space;        /* what was written of a pattern that may come; or NULL */
    const float *values;         /* of the slopes or of a map, or the weights of an average */
    const slope_entry *slopes;
    const struct normal_node *const *normals;   /* NULL: the surface's own */
    float amount, accuracy;      /* of BLEND_NONE */
    bool is_scaled;              /* bumps are scaled with the pattern; no_bump_scale: they aren't */
} normal_node;

/* ---- textures ---- */

typedef struct texture {
    blend blend;
    uint32_t count;              /* of members */
    const pattern *pattern;
    const float *values;         /* of a map, or the weights of an average */
    const struct texture *const *textures;
    /* Of BLEND_NONE. */
    const pigment_node *pigment;
    const normal_node *normal;   /* NULL: the surface's own */
    finish finish;
} texture;

/* Of two pigments the larger components. */
pigment pigment_most(pigment a, pigment b);
/* Pigment and finish of all that the texture consists of: components are the largest of all. */
void texture_bounds(const texture *of, pigment *most, finish *all);
/* Does any part of it ask for the surface's uv coordinates? */
bool pigment_has_uv(const pigment_node *of);
bool texture_has_uv(const texture *of);
/* Does any part of it perturb normals? */
bool texture_has_normals(const texture *of);

#endif
