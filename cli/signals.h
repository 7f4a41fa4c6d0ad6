/* signals.h - signals from the keyboard and other programs to a render. The handlers only set flags. */
#ifndef CLI_SIGNALS_H
#define CLI_SIGNALS_H

#include <stdbool.h>

/* From now on SIGINT, SIGTERM and SIGHUP request an early end, and SIGUSR1 the present picture. A second signal of a
 * kind ends the program at once. A signal that was ignored before stays ignored. */
void signals_watch(void);
/* The signal that requested the end, or 0. */
int signals_end_asked(void);
/* True once for each SIGUSR1 seen. */
bool signals_write_asked(void);
/* End by that signal, so that the parent process is told. */
void signals_end_by(int signal);

#endif
