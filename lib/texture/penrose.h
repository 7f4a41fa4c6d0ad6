/* penrose.h - the three tilings of Penrose that look alike after a fifth of a turn about the origin, and never repeat. */
#ifndef TEXTURE_PENROSE_H
#define TEXTURE_PENROSE_H

/* As tilings: kind + 1 at the borders of tiles, falling towards kind, by the number of kinds. */
double penrose_pentagons(double x, double z);    /* three kinds of pentagons, stars, boats, thin rhombi; sides of 1 */
double penrose_kites(double x, double z);        /* kites and darts with long sides of 1 */
double penrose_rhombi(double x, double z);       /* wide and thin ones with sides of 1 */

#endif
