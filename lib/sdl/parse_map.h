/* parse_map.h - color_map, pigment_map and their like, and the lists of patterns that number their members. */
#ifndef SDL_PARSE_MAP_H
#define SDL_PARSE_MAP_H

#include "sdl/textures.h"

/* In the scene's memory; also the value of a name. Members are by kind: VALUE_COLOUR_MAP pigment; VALUE_SLOPE_MAP slope_entry;
 * others pointers to pigment_node, normal_node or texture. */
typedef struct map_parsed {
    value_kind kind;             /* VALUE_NOTHING: there is none */
    uint32_t count;
    const float *values;         /* NULL: of a list */
    const void *members;
} map_parsed;

/* The kind of map of a word, or VALUE_NOTHING. */
value_kind parse_map_kind(keyword_id keyword);
/* The word of a map was taken: its block. */
void parse_map(pov_reader *in, value_kind kind, map_parsed *out);
/* Blocks that begin with the word of a map's members, at most so many. False: none is next. */
bool parse_map_list(pov_reader *in, value_kind kind, uint32_t most, map_parsed *out);
/* Make a list whole: members that it does not give are what #default says. */
void parse_map_complete(pov_reader *in, uint32_t count, map_parsed *list);

#endif
