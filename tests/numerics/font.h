/* font.h - a TrueType font of a single glyph, for every letter, whose outline is drawn by chance. */
#ifndef NUMERICS_FONT_H
#define NUMERICS_FONT_H

#include <stddef.h>

enum { FONT_PIECES = 64 };

/* Pieces of the outline by their three points, x and y of each, where text has them: the em is 1, and the line begins at the
 * outline's least x. Of straight pieces the second point is the middle. */
typedef struct font {
    unsigned char bytes[4096];
    size_t size;
    int pieces;
    double piece[FONT_PIECES][6];
} font;

/* draw: a number from 0 to 1 by chance. */
void font_make(font *f, double (*draw)(void));

#endif
