/* args_read.h - the parts of reading the command line: values of options, and what stands without one. For cli/args*.c. */
#ifndef CLI_ARGS_READ_H
#define CLI_ARGS_READ_H

#include "args.h"

/* The largest side of a picture: libpng's own limit. */
enum { ARGS_LARGEST_SIDE = 1000000 };

/* Say what is wrong; always false, as what calls it returns then. */
bool args_refuse(args *a, const char *format, ...) POV_PRINTF(2, 3);
/* Digits only, up to `end` or the text's end; -1 when it is anything else or above the limit. */
int args_digits(const char *text, const char *end, int limit);
/* A value that `what` names in messages: a whole number; the index of a word in a list that ends with NULL; one of a list of
 * numbers that ends with -1; a positive number. */
bool args_whole(args *a, const char *what, const char *text, int least, int most, int *out);
bool args_word(args *a, const char *what, const char *text, const char *const *words, int *out);
bool args_choice(args *a, const char *what, const char *text, const int *choices, const char *list, int *out);
bool args_positive(args *a, const char *what, const char *text, double *out);
/* The words that belong to no option, once all options are read. */
bool args_places(args *a, int count, char **places);
bool args_limit(args *a, const char *text);
bool args_frames(args *a, const char *text);
bool args_clock(args *a, const char *text);
/* Once all options are read. */
bool args_check_frames(args *a);

#endif
