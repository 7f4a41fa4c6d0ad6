/* orbit.h - where the camera is, and how it moves. Pure: no window, no clock, no scene; a picture's size and
 * distances come as numbers. Ways across the picture are in parts of its width and height, to the right and down. */
#ifndef VIEWER_ORBIT_H
#define VIEWER_ORBIT_H

#include <povtrace/scene.h>

typedef struct orbit {
    pov_camera home;         /* the scene's, for a picture of its shape */
    pov_camera camera;       /* where we are */
    pov_vec3 sky;            /* unit, what is up in the scene */
    double mirror;           /* 1, or -1 for a camera that shows the world mirrored */
    double reach;            /* the pivot is location + reach * direction */
    double home_reach;
    double first_shape;      /* width / height of the picture that the camera is for */
    double home_shape;
    double shape;            /* that of the picture now */
    bool moved;              /* the user has taken the camera from its home */
} orbit;

typedef enum orbit_side { ORBIT_FRONT, ORBIT_RIGHT, ORBIT_TOP } orbit_side;

/* The scene's camera, how far ahead its pivot is, and the shape of the picture, width / height, that it is for. */
void orbit_init(orbit *o, const pov_camera *home, double reach, double shape);
/* The scene was read anew: R leads to this camera now. A camera that the user has moved stays where it is. */
void orbit_set_home(orbit *o, const pov_camera *home, double reach, double shape);
/* A window of another shape shows more or less at its sides; nothing is stretched, and heights stay. */
void orbit_fit(orbit *o, int width, int height);
/* The camera for a picture of the size now. */
pov_camera orbit_camera(const orbit *o);
/* The direction through a place in the picture, 0 .. 1 from its upper left corner. */
pov_vec3 orbit_ray(const orbit *o, double x, double y);
pov_vec3 orbit_pivot(const orbit *o);
/* What is at `reach` lengths of the direction ahead is the pivot from now on; not positive: leave it. */
void orbit_set_reach(orbit *o, double reach);

/* Turn the camera about the pivot: the picture's height is half a turn. */
void orbit_turn(orbit *o, double right, double down);
/* Shift the camera so that what is at the pivot's depth follows the pointer. */
void orbit_pan(orbit *o, double right, double down);
/* Go towards the point that is seen at (x, y), `reach` lengths of the ray through there away; not positive: at the
 * pivot's depth. Each step leaves nine tenths of the way, a negative one undoes a positive one. */
void orbit_dolly(orbit *o, double x, double y, double reach, double steps);
/* Turn the camera about its own place, towards the side that the pointer goes to: the picture's width or height is
 * the angle that it shows. */
void orbit_look(orbit *o, double right, double down);
/* Move the camera in its own frame by so many units of the scene. */
void orbit_fly(orbit *o, double right, double up, double ahead);
/* Look at the pivot along an axis from the same distance. */
void orbit_face(orbit *o, orbit_side side);
void orbit_reset(orbit *o);

#endif
