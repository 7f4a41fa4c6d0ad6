/* parse_pattern.h - pigments, normals and densities: colours, patterns, maps. */
#ifndef SDL_PARSE_PATTERN_H
#define SDL_PARSE_PATTERN_H

#include "sdl/parse.h"

/* Words of patterns and of what changes them; both end with KEYWORD_OTHER. */
extern const keyword_id parse_patterns[], parse_pattern_modifiers[];

void parse_pattern_move(pov_reader *in, void *self, keyword_id keyword);
void parse_pattern_map(pov_reader *in, void *self, keyword_id keyword);
/* The words of maps in a table of items. */
#define PARSE_MAPS \
    { KEYWORD_COLOR_MAP, parse_pattern_map }, { KEYWORD_COLOUR_MAP, parse_pattern_map }, \
    { KEYWORD_PIGMENT_MAP, parse_pattern_map }, { KEYWORD_NORMAL_MAP, parse_pattern_map }, \
    { KEYWORD_TEXTURE_MAP, parse_pattern_map }, { KEYWORD_SLOPE_MAP, parse_pattern_map }, \
    { KEYWORD_DENSITY_MAP, parse_pattern_map }

void parse_normal(pov_reader *in, surface_parsed *s);
void parse_density(pov_reader *in, surface_parsed *s);
/* What stands in a texture, up to the punctuation, which is not taken. */
void parse_texture_content(pov_reader *in, surface_parsed *s, int end);

#endif
