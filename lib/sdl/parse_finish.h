/* parse_finish.h - words of a finish that old scenes have right in a texture. */
#ifndef SDL_PARSE_FINISH_H
#define SDL_PARSE_FINISH_H

#include "sdl/parse.h"

void parse_finish_item(pov_reader *in, void *self, keyword_id keyword);
void parse_finish_reflection(pov_reader *in, void *self, keyword_id keyword);
/* That of a name. */
void parse_finish_take(pov_reader *in, void *self, const value *v);
/* Their rows of a table of items. */
#define PARSE_FINISH_ROWS(one, reflection) \
    { KEYWORD_AMBIENT, one }, { KEYWORD_EMISSION, one }, { KEYWORD_DIFFUSE, one }, { KEYWORD_BRILLIANCE, one }, \
    { KEYWORD_PHONG, one }, { KEYWORD_PHONG_SIZE, one }, { KEYWORD_SPECULAR, one }, { KEYWORD_ROUGHNESS, one }, \
    { KEYWORD_METALLIC, one }, { KEYWORD_CRAND, one }, { KEYWORD_CONSERVE_ENERGY, one }, \
    { KEYWORD_REFLECTION_EXPONENT, one }, { KEYWORD_REFLECTION, reflection }
/* Words of features to come; ends with KEYWORD_OTHER. */
extern const keyword_id parse_finish_coming[];

#endif
