/* cells.h - the numbers of pixels, printed into them where they are magnified enough. */
#ifndef VIEWER_CELLS_H
#define VIEWER_CELLS_H

#include "panel.h"
#include "session.h"

/* A number in at most six characters. */
void cells_write(double value, char *out, size_t size);
/* The picture's pixels that are seen, in whole or in part. False: they are too small for numbers. */
bool cells_seen(const app *a, pov_rect *out);
/* A sheet as large as the window, to be shown at its corner; empty where pixels are too small. True: it has changed. */
bool cells_set(panel *p, const app *a, session *from);

#endif
