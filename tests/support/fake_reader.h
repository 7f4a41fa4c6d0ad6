/* fake_reader.h - a host for parse functions, fed from a text or from a list of numbers and words. */
#ifndef SUPPORT_FAKE_READER_H
#define SUPPORT_FAKE_READER_H

#include "plug/shape_class.h"

/* Every reader and instance made is freed by fake_reader_destroy(). */
pov_reader *fake_reader_create(void);
void fake_reader_destroy(pov_reader *in);

/* Forget what was fed, and any error. Memory that instances use stays. */
void fake_reader_clear(pov_reader *in);
void fake_reader_number(pov_reader *in, double value);
void fake_reader_word(pov_reader *in, const char *word);
/* Numbers, words and marks as in a scene; anything else becomes a word that nobody expects. */
void fake_reader_text(pov_reader *in, const char *text);

/* What was fed, as text that fake_reader_text() takes; cut off where it is longer. */
void fake_reader_print(const pov_reader *in, char *out, size_t size);

/* Zeroed memory, aligned to 64 bytes, freed with the reader. */
void *fake_reader_memory(pov_reader *in, size_t bytes);

/* An instance parsed from what was fed, or NULL when that failed or left something over. */
void *fake_reader_parse(pov_reader *in, const shape_class *shape);
/* The same into memory of the caller's, of the class's size. */
bool fake_reader_parse_into(pov_reader *in, const shape_class *shape, void *self);
const char *fake_reader_message(const pov_reader *in);   /* of the first failure; "" for none */
int fake_reader_warnings(const pov_reader *in);

/* The first shape of a plugin file; the file stays loaded. NULL, and a line on standard error, if it
 * cannot be had. */
const shape_class *fake_reader_load(const char *path);
/* The shape of the build's own plugin. */
const shape_class *fake_reader_shape(const char *keyword);

#endif
