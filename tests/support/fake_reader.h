/* fake_reader.h - a host for parse functions that reads a text or a list of numbers and words. */
#ifndef SUPPORT_FAKE_READER_H
#define SUPPORT_FAKE_READER_H

#include "plug/shape_class.h"

/* fake_reader_destroy() frees the reader and all its instances. */
pov_reader *fake_reader_create(void);
void fake_reader_destroy(pov_reader *in);

/* Drop the input, and any error. Memory that instances use stays. */
void fake_reader_clear(pov_reader *in);
void fake_reader_number(pov_reader *in, double value);
void fake_reader_word(pov_reader *in, const char *word);
/* Numbers, words and punctuation as in a scene; anything else becomes a word that no parser expects. */
void fake_reader_text(pov_reader *in, const char *text);

/* What any file holds; it must live as long as the reader. */
void fake_reader_file(pov_reader *in, const void *file, size_t bytes);
/* What an image stands for, rows from the top; it must live as long as the reader. */
void fake_reader_heights(pov_reader *in, const uint16_t *heights, uint32_t width, uint32_t height);

/* The input as text that fake_reader_text() takes; cut off where it is longer. */
void fake_reader_print(const pov_reader *in, char *out, size_t size);

/* Zeroed memory, aligned to 64 bytes, freed with the reader. */
void *fake_reader_memory(pov_reader *in, size_t bytes);

/* An instance parsed from the input, or NULL if that failed or left a rest. */
void *fake_reader_parse(pov_reader *in, const shape_class *shape);
/* The same into memory of the caller, of the class's size. */
bool fake_reader_parse_into(pov_reader *in, const shape_class *shape, void *self);
const char *fake_reader_message(const pov_reader *in);   /* message of the first failure; "" for none */
int fake_reader_warnings(const pov_reader *in);

/* The first shape of a plugin file; the file stays loaded. On failure NULL, and a line on standard error. */
const shape_class *fake_reader_load(const char *path);
/* The shape of the build's own plugin. */
const shape_class *fake_reader_shape(const char *keyword);

#endif
