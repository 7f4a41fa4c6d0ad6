/* recent.h - the scenes that were shown last, in a file of the user's own. */
#ifndef VIEWER_RECENT_H
#define VIEWER_RECENT_H

enum { RECENT_MOST = 9, RECENT_PATH = 512 };

/* Absolute paths, the last one first. */
typedef struct recent { char paths[RECENT_MOST][RECENT_PATH]; int count; } recent;

/* Files that are no longer there are left out. */
void recent_read(recent *r);
/* Put a scene first. A file that cannot be written is no error. */
void recent_add(const char *path);

#endif
