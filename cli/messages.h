/* messages.h - messages on standard error, about a scene and about povc itself. */
#ifndef CLI_MESSAGES_H
#define CLI_MESSAGES_H

#include "args.h"

typedef struct messages {
    bool color, quiet, verbose, json;   /* json: one object a line */
    unsigned warnings;           /* written or silenced */
    unsigned errors;             /* of a scene, written while it was read */
} messages;

/* Is standard error a terminal that may be coloured and redrawn? */
bool messages_on_terminal(void);

void messages_init(messages *m, const args *a);
/* If it was not written while the scene was read. */
void messages_error(const messages *m, const pov_error *err);
/* "povc: warning: ..." */
void messages_warn(const messages *m, const char *format, ...) POV_PRINTF(2, 3);
/* About the command line, if anything. */
void messages_notes(const messages *m, const args *a);
/* A pov_log_fn; user is the messages. */
void messages_log(void *user, pov_log_level level, const pov_error *note);
/* "povc: ..." */
void messages_say(const messages *m, const char *format, ...) POV_PRINTF(2, 3);

#endif
