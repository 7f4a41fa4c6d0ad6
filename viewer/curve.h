/* curve.h - the picture's error against its time, as it comes down: a panel. */
#ifndef VIEWER_CURVE_H
#define VIEWER_CURVE_H

#include "panel.h"
#include "session.h"

/* Nothing is shown as long as no error is known. */
bool curve_set(panel *p, const session *s, bool shown, double scale);

#endif
