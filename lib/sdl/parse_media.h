/* parse_media.h - media { }: in interiors, at the top level, and as values of names. */
#ifndef SDL_PARSE_MEDIA_H
#define SDL_PARSE_MEDIA_H

#include "sdl/parse.h"

/* The word was taken: its block. NULL: the reader has failed. */
const medium *parse_media_node(pov_reader *in);
/* The same behind what was there before; NULL: nothing was. */
const media *parse_media_upon(pov_reader *in, const media *before);
/* As a statement, it fills the scene. */
void parse_atmosphere(pov_reader *in, void *self, keyword_id keyword);
/* The same media, moved; NULL stays NULL. Lengths, and so strengths, stay as they are. */
const media *parse_media_move(pov_reader *in, const media *m, const transform *moves);
/* Before they become part of the model; returns them. */
const media *parse_media_settle(pov_reader *in, const media *m);

#endif
