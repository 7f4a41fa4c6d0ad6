/* internal.h - internal(0) to internal(78): surfaces and curves that POV-Ray's functions.inc gives names to. */
#ifndef FUNCTION_INTERNAL_H
#define FUNCTION_INTERNAL_H

#include <stdbool.h>
#include <stdint.h>

/* LIMITED: p[0] times the value, limited to 10. TURNED: the same of a curve, whose last three parameters turn it; the
 * first four are limited by p[1]. */
typedef enum internal_form { INTERNAL_PLAIN, INTERNAL_LIMITED, INTERNAL_TURNED, INTERNAL_TURNED_LIMIT } internal_form;
enum { INTERNAL_HEX_X = 27, INTERNAL_HEX_Y = 28, INTERNAL_POLYTUBES = 52 };

/* Arguments: x, y, z, then the parameters; at most INTERNAL_ARGUMENTS_MAX. 0: there is no such function. */
enum { INTERNAL_ARGUMENTS_MAX = 16 };
uint32_t internal_arguments(uint32_t number);
/* Noise is not this room's: its functions have the value 0 here. */
double internal_value(uint32_t number, const double *v);

/* The formula of x, y, z and p[0] on, before its form is applied; NULL: it has none. */
const char *internal_text(uint32_t number, internal_form *form);
/* Coordinate 0 or 1 in the plane of a curve that is turned, p[0] to p[2] its last parameters; the radius of polytubes. */
const char *internal_curve_text(int axis);
const char *internal_tube_text(void);

/* A place in a pavement of hexagons: along and across its nearest axis, along which (x, y) leads; across grows to the left
 * of that if side is 1, else to the right. */
typedef struct internal_hex { double along, across, x, y, side; } internal_hex;
void internal_hexagon(double x, double y, internal_hex *out);

#endif
