/* object_query.h - what rays, points and boxes find of an object that has been read, before there is a world. */
#ifndef SDL_OBJECT_QUERY_H
#define SDL_OBJECT_QUERY_H

#include "sdl/parse.h"

/* The normal is the one that light sees. */
typedef struct object_hit { double t; pov_vec3 normal; } object_hit;

/* The first hit in front of the origin, in multiples of the direction. False: there is none. */
bool object_trace(pov_reader *in, const object_parsed *o, pov_vec3 origin, pov_vec3 direction, object_hit *out);
/* Patches and lights have no inside. */
bool object_is_solid(const object_parsed *o);
/* As in POV-Ray an intersection or difference of nothing is everywhere, a union or merge nowhere. */
object_content object_content_of(const object_parsed *o);
/* The same of its members alone, whose contents are known. */
object_content object_content_of_members(const object_parsed *o);
bool object_holds(pov_reader *in, const object_parsed *o, pov_vec3 point);
/* False: it has no end, or there is nothing of it. What is not drawn yet has the unit cube. */
bool object_bounds(pov_reader *in, const object_parsed *o, pov_box *out);
/* A convex solid, one shape? */
bool object_is_convex(const object_parsed *o);
/* Does such a one certainly hold all of the object, moved as it is? False: that is not known. */
bool object_is_within(pov_reader *in, const object_parsed *o, const object_parsed *by);

#endif
