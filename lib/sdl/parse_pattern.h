/* parse_pattern.h - patterns in pigments, normals, textures and densities: their words, arguments and modifiers. */
#ifndef SDL_PARSE_PATTERN_H
#define SDL_PARSE_PATTERN_H

#include "sdl/parse_image.h"
#include "sdl/textures.h"

/* A pattern that is being read. Modifiers may come before it. */
typedef struct pattern_reading {
    pattern_parsed parsed;       /* class NULL: no pattern was there yet */
    bool stays;                  /* it is of a name, and on uv coordinates: what moves it now does nothing */
    bool is_open;                /* the block behind its word goes on with a list */
    block block;
    union { double align; unsigned char bytes[PATTERN_SELF_MAX]; } self;
    image_block image;           /* of one that has a file */
} pattern_reading;

void parse_pattern_begin(pattern_reading *r);
/* A pattern of a name. */
void parse_pattern_take(pattern_reading *r, const pattern *p);
/* The word of a pattern is next: read it and its arguments. False: it is not. */
bool parse_pattern_word(pov_reader *in, pattern_reading *r);
/* Note at the words of the language which of them are patterns. */
void parse_pattern_init(symbols *words);
/* The word of a class was taken: its arguments. */
void parse_pattern_class(pov_reader *in, pattern_reading *r, const pattern_class *class);
/* What may stand in the block behind the word has been read. */
void parse_pattern_close(pov_reader *in, pattern_reading *r);
/* A modifier, a transformation, or a word of the pattern is next: read it. */
bool parse_pattern_modifier(pov_reader *in, pattern_reading *r);
/* The scene's pattern. NULL: the reader has failed. */
const pattern *parse_pattern_end(pov_reader *in, pattern_reading *r);
/* Modifiers without a pattern, for one that may follow in another block. NULL: there are none, or the reader has failed. */
const pattern *parse_pattern_space(pov_reader *in, const pattern_reading *r);
const pattern *parse_pattern_move_space(pov_reader *in, const pattern *space, const transform *moves);
void parse_pattern_take_space(pattern_reading *r, const pattern *space);

/* Patterns that are not drawn yet, and modifiers that belong to them or change nothing; both end with KEYWORD_OTHER. */
extern const keyword_id parse_patterns[], parse_pattern_modifiers[];

#endif
