/* maps.h - maps of visible surfaces as colours, traced on a thread of their own from coarse to fine. */
#ifndef VIEWER_MAPS_H
#define VIEWER_MAPS_H

#include <povtrace/trace.h>

typedef enum maps_kind { MAPS_NORMAL, MAPS_DEPTH, MAPS_CERTAINTY } maps_kind;

typedef struct maps_request {
    maps_kind kind;
    pov_camera camera;
    int width, height;
    double middle;               /* the depth, in lengths of the direction, that is shown as middle grey */
} maps_request;

/* Pixels whose surface double precision decided, or double-double. */
typedef struct maps_counts { size_t certain, uncertain; } maps_counts;

typedef struct maps maps;

/* The scene must outlive it. `wake` is called from the thread when there are changes where there were none. */
pov_status maps_create(maps **out, const pov_scene *scene, void (*wake)(void *), void *wake_user, pov_error *err);
void maps_destroy(maps *m);
/* Drop all results and begin with this request. */
void maps_begin(maps *m, const maps_request *request);
void maps_stop(maps *m);
/* Copy the changed rows into a picture of the requested size, red, green, blue and alpha in bytes, and return them.
 * False: none. */
bool maps_take(maps *m, uint8_t *pixels, int *first, int *last);
/* Of the pixels that have been traced. */
maps_counts maps_count(maps *m);
bool maps_is_done(maps *m);

/* The colour of a hit, or of none (NULL). Normals -1 .. 1 become 0 .. 255, world x red, y green, z blue. Depth is white
 * near, black far, as 1 / (1 + (depth / middle)^3). Certainty is blue where double precision sufficed, orange where
 * double-double numbers were needed. */
void maps_color(const maps_request *request, pov_vec3 ray, const pov_hit *hit, uint8_t *rgba);

#endif
