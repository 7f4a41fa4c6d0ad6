/* caption.h - what the colours of the view mean. */
#ifndef VIEWER_CAPTION_H
#define VIEWER_CAPTION_H

#include "session.h"

/* Text for panel_set(); empty for the plain picture. */
void caption_write(const app *a, const session *s, char *out, size_t size);

#endif
