/* text.h - a line of scene text, printed so that a mark stands under the right position. */
#ifndef CLI_TEXT_H
#define CLI_TEXT_H

#include <stddef.h>

/* The line made safe for a terminal: control characters and invalid UTF-8 become '?', tabs stay. */
void text_printable(const char *line, char *out, size_t size);
/* White space as wide as the first `bytes` bytes of the line: tabs for tabs, none for a combining mark, two
 * blanks for a character of double width. */
void text_indent(const char *line, int bytes, char *out, size_t size);

#endif
