/* say.h - messages for the terminal. */
#ifndef VIEWER_SAY_H
#define VIEWER_SAY_H

#include <povtrace/base.h>

/* Print "file:line:column: kind: message", or "povview: kind: message" without a file, to standard error. Any
 * thread. */
void say(const char *kind, const pov_error *err);

#endif
