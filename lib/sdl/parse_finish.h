/* parse_finish.h - words of a finish that old scenes have right in a texture. */
#ifndef SDL_PARSE_FINISH_H
#define SDL_PARSE_FINISH_H

#include "sdl/parse.h"

void parse_finish_item(pov_reader *in, void *self, keyword_id keyword);
void parse_finish_reflection(pov_reader *in, void *self, keyword_id keyword);
/* Their rows of a table of items. */
#define PARSE_FINISH_ITEMS \
    { KEYWORD_AMBIENT, parse_finish_item }, { KEYWORD_EMISSION, parse_finish_item }, \
    { KEYWORD_DIFFUSE, parse_finish_item }, { KEYWORD_BRILLIANCE, parse_finish_item }, \
    { KEYWORD_PHONG, parse_finish_item }, { KEYWORD_PHONG_SIZE, parse_finish_item }, \
    { KEYWORD_SPECULAR, parse_finish_item }, { KEYWORD_ROUGHNESS, parse_finish_item }, \
    { KEYWORD_METALLIC, parse_finish_item }, { KEYWORD_CRAND, parse_finish_item }, \
    { KEYWORD_CONSERVE_ENERGY, parse_finish_item }, { KEYWORD_REFLECTION_EXPONENT, parse_finish_item }, \
    { KEYWORD_REFLECTION, parse_finish_reflection }
/* Words of features to come; ends with KEYWORD_OTHER. */
extern const keyword_id parse_finish_coming[];

#endif
