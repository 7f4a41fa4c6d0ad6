/* orbit.h - the camera's position and motion. Pure: no window, no clock, no scene; sizes and distances are arguments.
 * Distances across the picture are fractions of its width and height, to the right and down. */
#ifndef VIEWER_ORBIT_H
#define VIEWER_ORBIT_H

#include <povtrace/scene.h>

typedef struct orbit {
    pov_camera home;         /* the scene's, for a picture of its shape */
    pov_camera camera;       /* the present camera */
    pov_vec3 sky;            /* unit vector that points up in the scene */
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
/* The scene was reloaded: R returns to this camera now. A camera that the user has moved stays. */
void orbit_set_home(orbit *o, const pov_camera *home, double reach, double shape);
/* A window of another aspect ratio shows more or less at its sides; nothing is stretched, and heights stay. */
void orbit_fit(orbit *o, int width, int height);
/* The camera for a picture of the size now. */
pov_camera orbit_camera(const orbit *o);
/* The direction through a position in the picture, 0 .. 1 from its upper left corner. */
pov_vec3 orbit_ray(const orbit *o, double x, double y);
pov_vec3 orbit_pivot(const orbit *o);
/* Set the pivot at `reach` lengths of the direction ahead; not positive: leave it. */
void orbit_set_reach(orbit *o, double reach);

/* Rotate the camera about the pivot: the picture's height is half a turn. */
void orbit_turn(orbit *o, double right, double down);
/* Pan the camera so that points at the pivot's depth follow the pointer. */
void orbit_pan(orbit *o, double right, double down);
/* Dolly towards the point seen at (x, y), `reach` lengths of the ray through there away; not positive: at the pivot's
 * depth. Each step leaves nine tenths of the distance; a negative step undoes a positive one. */
void orbit_dolly(orbit *o, double x, double y, double reach, double steps);
/* Rotate the camera about its own position, towards the side that the pointer goes to: the picture's width or height is
 * the angle that it shows. */
void orbit_look(orbit *o, double right, double down);
/* Move the camera in its own frame by so many units of the scene. */
void orbit_fly(orbit *o, double right, double up, double ahead);
/* Look at the pivot along an axis from the same distance. */
void orbit_face(orbit *o, orbit_side side);
void orbit_reset(orbit *o);
/* Go back or ahead, in the same direction, until the box is the pivot and just within the picture. False: it has no
 * extent, or no end. */
bool orbit_frame(orbit *o, const pov_box *box);
/* Multiply the width of what is seen at the pivot. Returns the angle across in degrees, 0 for parallel rays, and below 0
 * for a camera whose field of view this does not change. */
double orbit_widen(orbit *o, double factor);

#endif
