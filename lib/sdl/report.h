/* report.h - errors and warnings with their places. */
#ifndef SDL_REPORT_H
#define SDL_REPORT_H

#include "sdl/state.h"

#include <stdarg.h>

/* Enough for what a message quotes of the text. */
enum { REPORT_QUOTE = 64 };

/* The first error is kept, later ones are consequences of it. */
void report_fail(pov_reader *in, const place *at, pov_status status, const char *format, ...)
    POV_PRINTF(4, 5);
void report_failv(pov_reader *in, const place *at, pov_status status, const char *format, va_list args);
void report_memory(pov_reader *in);
/* An error of another room, with the place added where it has none. */
void report_pass_on(pov_reader *in, const place *at, const pov_error *error);
/* `expected WANTED after "x", found "y"`, where the next token is y. */
void report_expected(pov_reader *in, const char *wanted);

void report_warn(pov_reader *in, const place *at, const char *format, ...) POV_PRINTF(3, 4);
void report_warnv(pov_reader *in, const place *at, const char *format, va_list args);

/* The stretch of text as it may stand in a message: shortened, without what is not printable. */
void report_quote(const place *at, char out[REPORT_QUOTE]);
/* What the scene itself says, as it stands. */
void report_text(pov_reader *in, const char *text, size_t length);

/* ---- the word that was probably meant ---- */

typedef struct guess {
    char word[REPORT_QUOTE], best[REPORT_QUOTE];
    int edits;
} guess;

/* Of the word that is next; candidates that a plugin asked for are tried first. */
void report_guess_start(guess *g, const pov_reader *in);
void report_guess_try(guess *g, const char *candidate);
/* All names that there are. */
void report_guess_names(guess *g, const pov_reader *in);
/* As report_expected(), with what was guessed. */
void report_expected_guess(pov_reader *in, const char *wanted, const guess *g);
/* The next token is a name that has no value. */
void report_undeclared(pov_reader *in);
/* The next token is no word that may stand here. */
void report_misplaced(pov_reader *in, const char *wanted, const guess *g);

#endif
