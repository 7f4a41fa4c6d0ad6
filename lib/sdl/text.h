/* text.h - strings as values. Texts are UTF-8, what is counted is characters. */
#ifndef SDL_TEXT_H
#define SDL_TEXT_H

#include "sdl/state.h"

/* Room for `length` bytes and an end mark. NULL: the reader has failed. */
string *text_create(pov_reader *in, size_t length);
string *text_copy(pov_reader *in, const char *text, size_t length);
/* The string token that is next, which is not taken; bytes that are no UTF-8 are Latin-1. */
value text_literal(pov_reader *in);
/* The same without escapes, as names of files are read. */
value text_raw(pov_reader *in);
/* 0, or the difference of the first two characters that differ. */
int text_compare(const string *a, const string *b);
size_t text_characters(const string *s);
/* The character at a byte, and the bytes that it takes. */
unsigned text_character(const char *at, int *bytes);
/* A number after the C locale, as printf has it. */
int text_number(char *out, size_t size, double number, int width, int digits);
/* Beyond 254 characters it is written with %g instead, and beyond that as <invalid>, as POV-Ray has it. */
int text_number_of_a_line(char *out, size_t size, double number, int width, int digits);
/* As printf has it with %g. */
int text_general(char *out, size_t size, double number);

#endif
