/* parse_camera_mesh.h - the faces by which a camera of meshes sees. */
#ifndef SDL_PARSE_CAMERA_MESH_H
#define SDL_PARSE_CAMERA_MESH_H

#include "sdl/parse.h"

/* The block behind the word, in memory of the scene. NULL: the reader has failed. */
const struct camera_mesh *parse_camera_mesh(pov_reader *in);

#endif
