/* parse_texture.h - pigments, normals, densities and textures, each as a node. */
#ifndef SDL_PARSE_TEXTURE_H
#define SDL_PARSE_TEXTURE_H

#include "sdl/parse.h"

/* Contents up to the punctuation, which is not taken. NULL: the reader has failed; or a normal that perturbs nothing.
 * What is read changes the base, which may be NULL. kind: VALUE_PIGMENT or VALUE_DENSITY. */
const pigment_node *parse_pigment_content(pov_reader *in, value_kind kind, const pigment_node *base, int end);
const normal_node *parse_normal_content(pov_reader *in, const normal_node *base, int end);
const texture *parse_texture_node(pov_reader *in, int end);
/* The word was taken: the block. Upon nothing else the defaults are changed. */
const pigment_node *parse_pigment_node(pov_reader *in);
const pigment_node *parse_pigment_upon(pov_reader *in, const pigment_node *base);
const normal_node *parse_normal_node(pov_reader *in);
const normal_node *parse_normal_upon(pov_reader *in, const normal_node *base);
const pigment_node *parse_density_node(pov_reader *in);
/* As the block `{ color rgbft C }`. */
const pigment_node *parse_pigment_colour(pov_reader *in, const pigment_node *base, const pigment *p);

/* What the surface's textures are; NULL: constant, as its material says. */
const texture *parse_surface_texture(pov_reader *in, const surface_parsed *s);
/* The same, whatever it is. NULL: the reader has failed. */
const texture *parse_surface_node(pov_reader *in, const surface_parsed *s);
/* Transformations move all that was read so far. */
void parse_surface_move(pov_reader *in, surface_parsed *s, const transform *moves);
/* Its material, ready for the model. */
void parse_surface_material(pov_reader *in, const surface_parsed *s, material *out);

#endif
