/* maps.h - what the surfaces seen are like, as colours, traced on a thread of their own from coarse to fine. */
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

typedef struct maps maps;

/* The scene must outlive it. `wake` is called from the thread when there is something to take where there was nothing. */
pov_status maps_create(maps **out, const pov_scene *scene, void (*wake)(void *), void *wake_user, pov_error *err);
void maps_destroy(maps *m);
/* Drop what there is and begin with this. */
void maps_begin(maps *m, const maps_request *request);
void maps_stop(maps *m);
/* Copy the rows that have changed into a picture of the size asked for, red, green, blue and alpha in bytes, and say
 * which. False: none. */
bool maps_take(maps *m, uint8_t *pixels, int *first, int *last);
bool maps_is_done(maps *m);

/* The colour of a hit, and of NULL for none. Normals' -1 .. 1 become 0 .. 255, world x red, y green, z blue; depth is
 * white near, black far, as 1 / (1 + (depth / middle)^3). What
 * double precision decided is blue, what it left to two-part numbers is orange. */
void maps_color(const maps_request *request, const pov_hit *hit, uint8_t *rgba);

#endif
