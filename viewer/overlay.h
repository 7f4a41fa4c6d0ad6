/* overlay.h - the panels over the picture: the message, the inspector, a brief notice, the help. */
#ifndef VIEWER_OVERLAY_H
#define VIEWER_OVERLAY_H

#include "panel.h"
#include "present.h"
#include "session.h"

typedef struct overlay { panel panels[PRESENT_PANELS]; int x[PRESENT_PANELS], y[PRESENT_PANELS]; } overlay;

/* Update the panels and pass changed ones to the presenter. True: some have changed. */
bool overlay_update(overlay *o, const app *a, session *s, present *p);
void overlay_free(overlay *o);
/* Pixels of the help that do not fit. */
int overlay_help_below(const overlay *o);

/* The text of the panels. */
void overlay_write_help(char *out, size_t size);
void overlay_write_message(const pov_error *err, bool has_scene, char *out, size_t size);
void overlay_write_place(const session_place *place, char *out, size_t size);

#endif
