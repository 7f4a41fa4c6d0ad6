/* textures.h - makes pigments, normals and textures: equal ones are one, moved ones are new. */
#ifndef SDL_TEXTURES_H
#define SDL_TEXTURES_H

#include "sdl/parse.h"

/* A pattern with the transformations behind its last warp. The map is made of them when the pattern is used, so that
 * steps on the way leave none. */
typedef struct pattern_parsed {
    const transform *moves, *turns;   /* turns: of normals alone, behind these */
    pattern pattern;             /* nodes point to it */
} pattern_parsed;

static inline const pattern_parsed *textures_parsed(const pattern *p)
{
    return (const pattern_parsed *)(const void *)((const char *)p - offsetof(pattern_parsed, pattern));
}

/* The scene's own of each; NULL: the reader has failed. */
const pattern *textures_pattern(pov_reader *in, const pattern_parsed *p);
const pigment_node *textures_pigment(pov_reader *in, const pigment_node *p);
const normal_node *textures_normal(pov_reader *in, const normal_node *n);
const texture *textures_texture(pov_reader *in, const texture *t);
/* One colour everywhere. */
const pigment_node *textures_constant(pov_reader *in, const pigment *p);

/* The same, moved; NULL stays NULL. */
const pigment_node *textures_move_pigment(pov_reader *in, const pigment_node *p, const transform *moves);
const normal_node *textures_move_normal(pov_reader *in, const normal_node *n, const transform *moves);
const texture *textures_move(pov_reader *in, const texture *t, const transform *moves);
/* The same upon the surface's uv coordinates. */
const pigment_node *textures_uv_pigment(pov_reader *in, const pigment_node *p);
const normal_node *textures_uv_normal(pov_reader *in, const normal_node *n);
/* turns: bumps turn with the object. */
const texture *textures_uv(pov_reader *in, const texture *t, bool turns);

/* Quick pictures are asked for, and what things are in them. */
bool textures_are_drafts(const pov_reader *in);
const pigment_node *textures_draft_pigment(pov_reader *in, const pigment_node *p);
const texture *textures_draft(pov_reader *in, const texture *t);

/* The same with all filter as transmit, as in layers above others before version 3.5; images keep theirs. */
const pigment_node *textures_colourless(pov_reader *in, const pigment_node *p);

/* Before it becomes part of the model: its patterns know where they stand, and the scene has the noise that they need. */
void textures_settle_pattern(pov_reader *in, const pattern *p);
void textures_settle_pigment(pov_reader *in, const pigment_node *p);
void textures_settle_normal(pov_reader *in, const normal_node *n);
void textures_settle(pov_reader *in, const texture *t);

#endif
