/* frame.h - what tokens come from: a text, or tokens kept; a stack, so that one stops for another. */
#ifndef SDL_FRAME_H
#define SDL_FRAME_H

#include "sdl/state.h"

/* Tokens are the text's from here on. NULL: no memory, and the reader has failed. */
frame *frame_push_text(pov_reader *in, frame_kind kind, source *text);
/* The scene goes on with another text, behind which nothing waits; its first token is fetched by state_advance(). */
void frame_begin_text(pov_reader *in, const char *text, size_t length, const char *name);
/* Tokens are those of a buffer, which is in use until the frame goes. */
frame *frame_push_tokens(pov_reader *in, frame_kind kind, token_buffer *tokens, size_t at, size_t end);
/* The innermost frame goes, with the conditions that began in it if `conditions`. */
void frame_pop(pov_reader *in);
/* The next token, whatever it means. */
void frame_fetch(pov_reader *in, token *out);
/* The reader's token is to come again when the innermost frame is read next. */
void frame_save(pov_reader *in);
/* Tokens up to the #end that belongs to what began before, or to the end of the text, into a buffer of their own. NULL: no
 * memory, and the reader has failed. */
token_buffer *frame_capture(pov_reader *in);

#endif
