/* keys.h - what each key does: one table, from which the help is written too. */
#ifndef VIEWER_KEYS_H
#define VIEWER_KEYS_H

#include "app.h"

/* A row of the help. Rows of the mouse have no action. */
typedef struct keys_row {
    const char *names, *help;
    int codes[4];            /* characters in lower case, or keys of app.h; 0: no more */
    bool always;             /* also before there is a scene */
    void (*act)(app *a, double now);
} keys_row;

/* The index-th row; NULL past the last. */
const keys_row *keys_get(int index);
/* The row of a key, or NULL. */
const keys_row *keys_find(int code);

#endif
