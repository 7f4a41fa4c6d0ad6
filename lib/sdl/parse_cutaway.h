/* parse_cutaway.h - cutaway_textures: cut faces without a texture have those of the solids that were cut. */
#ifndef SDL_PARSE_CUTAWAY_H
#define SDL_PARSE_CUTAWAY_H

#include "sdl/parse.h"

/* A leaf of such an object. */
typedef struct cutaway_member {
    uint32_t leaf;
    surface_parsed surface;      /* its own, or that of the nearest object around it */
    const transform *map;        /* all that moves it */
    uint32_t moves;              /* how many of these came behind its texture */
    bool cuts;                   /* the object holds what it does not hold */
} cutaway_member;

typedef struct cutaway_list {
    cutaway_member *items;
    size_t count, capacity;
    const object_parsed *whole;
} cutaway_list;

/* The outermost object with the word begins; false: it is within another one. */
bool parse_cutaway_begin(pov_reader *in, const object_parsed *o, cutaway_list *list);
void parse_cutaway_add(pov_reader *in, const cutaway_member *member);
/* All of its leaves are in the model. */
void parse_cutaway_end(pov_reader *in, cutaway_list *list);

#endif
