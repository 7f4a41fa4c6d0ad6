/* text_file.h - #fopen, #read, #write, #fclose. What a scene writes it can read again; on the disk it lands only
 * where that was allowed. */
#ifndef SDL_TEXT_FILE_H
#define SDL_TEXT_FILE_H

#include "sdl/state.h"

void text_file_open(pov_reader *in, const place *at);
void text_file_read(pov_reader *in, const place *at);
void text_file_write(pov_reader *in, const place *at);
void text_file_close(pov_reader *in, const place *at);

/* How often the scene began and ended to write a file of that name; 0: never. */
uint32_t text_file_kept(const pov_reader *in, const string *name);
/* Its bytes, with an end mark that is not counted, for the caller to free. NULL: there is none, or no memory. */
char *text_file_copy(pov_reader *in, const string *name, size_t *length);
/* At the end of the text: what it has not closed. */
void text_file_store_open(pov_reader *in);
void text_file_free_all(pov_reader *in);

#endif
