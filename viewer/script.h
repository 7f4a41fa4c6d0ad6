/* script.h - parses the user's actions in --keys, one step at a time. Pure.
 *
 * A character stands for its key, and blanks are ignored. Angle brackets hold keys without a character (<tab> <enter>
 * <esc> <f1> <f5> <lt>), actions of the pointer (<drag 40,-20> <pan 40,-20> <look 40,-20> in pixels, <move x,y> to a
 * position, <wheel 3>), and other events (<fly W 0.5>: keys held for seconds, <size 320,200>: of the window, <load
 * file>: the scene's text becomes that of another file). */
#ifndef VIEWER_SCRIPT_H
#define VIEWER_SCRIPT_H

#include <stdbool.h>
#include <stddef.h>

typedef enum script_kind {
    SCRIPT_END, SCRIPT_CHARACTER, SCRIPT_KEY, SCRIPT_DRAG, SCRIPT_PAN, SCRIPT_LOOK, SCRIPT_MOVE, SCRIPT_WHEEL,
    SCRIPT_FLY, SCRIPT_SIZE, SCRIPT_LOAD
} script_kind;

typedef struct script_step {
    script_kind kind;
    int code;                /* of a character or a key, as app.h has them */
    double x, y;             /* the arguments in their order */
    char word[256];          /* the keys of a flight, the name of a file */
} script_step;

/* The next step, SCRIPT_END at the text's end. False: `problem` names the error. */
bool script_next(const char **at, script_step *out, char *problem, size_t size);
/* Is the whole text valid? */
bool script_check(const char *text, char *problem, size_t size);

#endif
