/* parse.h - who reads which part of a scene. Each is called when its word has been taken, and takes what
 * belongs to it: straight-line code, for errors stick in the reader. */
#ifndef SDL_PARSE_H
#define SDL_PARSE_H

#include "sdl/items.h"
#include "sdl/report.h"

#include <float.h>
#include <math.h>

/* What is read of one object, from its braces. */
typedef struct surface_text {
    material material;
    bool has_look;               /* a pigment, finish or texture was given */
    place layer;                 /* a texture upon another look; source NULL: none */
} surface_text;

/* The whole text, statement by statement. */
void parse_scene(pov_reader *in);
/* Is one of the words that a statement begins with meant? */
void parse_scene_guess(guess *g);
/* The next token is a word that is no other statement. */
void parse_object(pov_reader *in);
void parse_camera(pov_reader *in, void *self, word_id word);
void parse_light(pov_reader *in, void *self, word_id word);
void parse_global_settings(pov_reader *in, void *self, word_id word);
void parse_background(pov_reader *in, void *self, word_id word);

/* translate, rotate, scale, matrix: one more behind the list. */
void parse_transform(pov_reader *in, const transform **list, word_id word);

void parse_pigment(pov_reader *in, surface_text *s);
void parse_finish(pov_reader *in, surface_text *s);
void parse_texture(pov_reader *in, surface_text *s);
void parse_interior(pov_reader *in, surface_text *s);

/* When all has been read and the dialect is known. */
void parse_camera_finish(pov_reader *in);
void parse_settings_finish(pov_reader *in);

void parse_camera_defaults(camera_text *c);

/* Neither beyond what a double holds nor NaN. */
static inline bool parse_is_finite(pov_vec3 v)
{
    return fabs(v.x) <= DBL_MAX && fabs(v.y) <= DBL_MAX && fabs(v.z) <= DBL_MAX;
}

#endif
