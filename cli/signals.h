/* signals.h - what the keyboard and other programs ask of a render. The handlers only leave a note. */
#ifndef CLI_SIGNALS_H
#define CLI_SIGNALS_H

#include <stdbool.h>

/* From now on SIGINT, SIGTERM and SIGHUP ask for an early end, and SIGUSR1 for the picture so far. The second
 * of a kind ends the program at once. A signal that was ignored before stays ignored. */
void signals_watch(void);
/* The signal that asked for the end, or 0. */
int signals_end_asked(void);
/* True once for each SIGUSR1 seen. */
bool signals_write_asked(void);
/* End by that signal, so that whoever started us sees it. */
void signals_end_by(int signal);

#endif
