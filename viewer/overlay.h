/* overlay.h - what stands over the picture: the message, the inspector, a word in passing, the help. */
#ifndef VIEWER_OVERLAY_H
#define VIEWER_OVERLAY_H

#include "panel.h"
#include "present.h"
#include "session.h"

typedef struct overlay { panel panels[PRESENT_PANELS]; int x[PRESENT_PANELS], y[PRESENT_PANELS]; } overlay;

/* Bring the panels up to date and hand what has changed to the presenter. True: something has. */
bool overlay_update(overlay *o, const app *a, session *s, present *p);
void overlay_free(overlay *o);

/* The text of the panels. */
void overlay_write_message(const pov_error *err, bool has_scene, char *out, size_t size);
void overlay_write_place(const session_place *place, char *out, size_t size);

#endif
