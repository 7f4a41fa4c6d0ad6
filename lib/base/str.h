/* str.h - finding similar words for messages. */
#ifndef BASE_STR_H
#define BASE_STR_H

#include <stdbool.h>
#include <stddef.h>

/* Keep in *best the candidate with the fewest edits to word so far (a swap of neighbours is one edit). Start with *best
 * = NULL; only candidates near enough to be typing errors are kept. */
void str_nearer(const char *word, const char *candidate, const char **best, int *best_edits);
/* Copy as much as fits, always with a terminating zero. */
void str_copy(char *dst, size_t size, const char *src);

#endif
