/* curve.h - a panel with the picture's error against its time. */
#ifndef VIEWER_CURVE_H
#define VIEWER_CURVE_H

#include "panel.h"
#include "session.h"

/* Empty as long as no error is known. */
bool curve_set(panel *p, const session *s, bool shown, double scale);

#endif
