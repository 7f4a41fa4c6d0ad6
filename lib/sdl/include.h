/* include.h - #include, and where files of the scene are looked for. */
#ifndef SDL_INCLUDE_H
#define SDL_INCLUDE_H

#include "sdl/state.h"

/* Find where the files of this library's own are. */
void include_init(pov_reader *in);
void include_run(pov_reader *in, const place *at);
/* A file that the scene names, to be read: below the folder of the scene, that of the text that names it, the current
 * one, those that were given, POV-Ray's own, or this library's own, in that order. False: there is none. */
bool include_find(pov_reader *in, const string *name, char path[INCLUDE_PATH_MAX]);
/* The same for a name that may lack one of these endings; the list ends with NULL. */
bool include_find_with(pov_reader *in, const string *name, const char *const *endings, char path[INCLUDE_PATH_MAX]);
/* Fails with a message for what include_find_with did not find: whether it is nowhere, or outside of the folders. */
void include_not_found(pov_reader *in, const string *name, const char *const *endings);
bool include_exists(pov_reader *in, const string *name);

#endif
