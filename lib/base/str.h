/* str.h - words that are nearly the same. */
#ifndef BASE_STR_H
#define BASE_STR_H

#include <stdbool.h>
#include <stddef.h>

/* Remember in *best the candidate nearest to word so far, by edits (a swap of neighbours is one). Start with
 * *best = NULL; only candidates near enough to be a slip of the pen are kept. */
void str_nearer(const char *word, const char *candidate, const char **best, int *best_edits);
/* Copy as much as fits, always with an end mark. */
void str_copy(char *dst, size_t size, const char *src);

#endif
