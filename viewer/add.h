/* add.h - text that is put together piece by piece. */
#ifndef VIEWER_ADD_H
#define VIEWER_ADD_H

#include <povtrace/base.h>

/* Add to the end of a string, as far as the room goes. */
void add(char *out, size_t size, const char *format, ...) POV_PRINTF(3, 4);

#endif
