/* raygen.h - from a pixel to a ray. */
#ifndef RENDER_RAYGEN_H
#define RENDER_RAYGEN_H

#include "render/sample.h"
#include "world/surface.h"

/* The ray of a camera through pixel (x, y) of a picture, row 0 at the top. (dx, dy) is the position within the pixel,
 * from its top left corner: (1/2, 1/2) is the centre. The direction is not normalised: rounding it to a unit vector
 * would only add an error. */
pov_ray raygen_ray(const pov_camera *camera, int width, int height, int x, int y, double dx, double dy);

/* Many rays at once: their positions in the picture, by lane. */
enum { RAYGEN_MANY = WORLD_MANY };
typedef struct raygen_places {
    int x[RAYGEN_MANY], y[RAYGEN_MANY];
    uint32_t k[RAYGEN_MANY];     /* which sample of the pixel */
    double dx[RAYGEN_MANY], dy[RAYGEN_MANY];
} raygen_places;

/* The same positions on the screen, in widths to the right of its centre and heights above it. Pixels of a column share
 * u, those of a row v. Where the camera has a lens: points of the unit disc that say where on it rays start. Of a camera of meshes lens[0] is the sample's number in its pixel. */
typedef struct raygen_screen {
    double u[RAYGEN_MANY], v[RAYGEN_MANY], lens[2][RAYGEN_MANY];
    int width, height;           /* of the whole picture, in pixels */
} raygen_screen;
static inline bool raygen_has_lens(const pov_camera *c) { return c->lens_radius > 0.0; }
/* Do samples of a pixel differ in more than their places in it? */
static inline bool raygen_counts(const pov_camera *c) { return c->lens_radius > 0.0 || c->type == POV_CAMERA_MESH; }

/* Positions within pixels for a seed. */
void raygen_sample(uint32_t seed, uint32_t n, raygen_places *p);
/* Where on the lens samples start; of a camera of meshes their numbers. alone: pixels have one sample. */
void raygen_spread(const pov_camera *camera, uint32_t seed, bool alone, const raygen_places *p, uint32_t n, raygen_screen *out);

/* From -1/2 to 1/2, symmetric bit for bit about the middle. */
static inline double raygen_u(int x, double dx, int width) { return (((double)x - 0.5 * width) + dx) / width; }
static inline double raygen_v(int y, double dy, int height) { return -raygen_u(y, dy, height); }
void raygen_place(const raygen_places *p, int width, int height, uint32_t n, raygen_screen *out);

/* How far apart rays of neighbouring pixels start in the middle of the picture, and how much farther apart they are for each
 * unit of their length: the lesser of beside and below each other. 0: nothing is known. */
void raygen_apart(const pov_camera *camera, int width, int height, double *start, double *slope);

struct photon_screen;
/* The camera's screen. False: lines through the scene are no lines there, or the camera has a lens. */
bool raygen_flat(const pov_camera *camera, int width, int height, struct photon_screen *out);

/* Rays that start at the camera, without directions. */
void raygen_begin(const pov_camera *camera, pov_ray *rays, uint32_t n);
/* Set the starts and directions of such rays, as the camera's type has them; n <= RAYGEN_MANY. Returns their known properties, as tracer_colors()
 * takes them. */
unsigned raygen_aim(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays);
/* The same as the scene's own camera bends them. */
unsigned raygen_cast(const model *m, const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays);

#endif
