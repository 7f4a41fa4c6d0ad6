/* view.h - how the samples of a pixel see the places that photons light.
 *
 * What a pixel shows is the mean of the light over its part of the screen. Where photons lie closer than samples, this part itself is
 * what their light is counted in: each photon of a surface counts for the samples of the cell of the pixel that it is seen in,
 * by the ratio of areas on the screen and on the surface. So no light is blurred, and however unevenly it lies within the
 * cell, all of it is counted once. See docs/light.md. */
#ifndef PHOTON_VIEW_H
#define PHOTON_VIEW_H

#include "world/surface.h"

/* Places of points on the screen, in pixels from its top left corner: that of `from + d` is (row[0] . d, row[1] . d) over
 * row[2] . d where all rays start at `from`, and over 1 where all are parallel. across: products of the rows. */
typedef struct photon_screen {
    pov_vec3 from, row[3], across[3];
    double one;                  /* added to row[2] . d: 0, or 1 */
} photon_screen;

/* The screen of a camera by three rays, of its corners at the top left and right and at the bottom left. False: there is none. */
bool photon_screen_make(photon_screen *out, const pov_ray corners[3], int width, int height);

/* One sample. Rays of neighbouring pixels are `width` apart at `from`, and by `slope` more for each unit of distance. No disc
 * has a radius less than `least` of that: one that is smaller than samples lie apart would be met by chance, with much
 * light, or not at all, and no number of samples that miss it tells of it. */
typedef struct photon_view {
    pov_vec3 from;
    double width, slope, least;
    const photon_screen *screen; /* NULL: there is none */
    double place[2];             /* of the sample on the screen */
    int parts[2];                /* cells of a pixel across and down */
} photon_view;

/* The number of a pixel's sample, its ray. */
void photon_view_begin(photon_view *v, const photon_screen *screen, const pov_ray *ray, uint32_t number);
/* How far apart samples of neighbouring pixels see the place. */
double photon_view_spacing(const photon_view *v, pov_vec3 at);

/* A cell of a pixel, and where the sample sees it. Along a ray, spacing and reach grow by `slope` and `widening` for each unit. */
typedef struct photon_cell {
    const photon_screen *screen;
    double lo[2], hi[2];         /* on the screen */
    double reach, widening;      /* no place of the surface, or none at this distance, that is seen in the cell lies further from the
                                  * sample's */
    double spacing, slope;       /* photons with wider discs than this have discs all the same */
} photon_cell;

/* The cell of a surface with this normal. False: there is none, for the place is not seen straight, or too flat. */
bool photon_view_cell(const photon_view *v, pov_vec3 at, pov_vec3 normal, photon_cell *out);
/* The cell of a ray in this direction, unit. False: it is not the sample's. */
bool photon_view_along(const photon_view *v, pov_vec3 from, pov_vec3 dir, photon_cell *out);

#endif
