/* povray_read.h - the parts of reading POV-Ray's command line: settings, and the files and words that hold them. */
#ifndef CLI_POVRAY_READ_H
#define CLI_POVRAY_READ_H

#include "povray.h"

/* Say what is wrong, unless something was wrong before; always false. And: a line for a warning. */
bool povray_refuse(povray *p, const char *format, ...) POV_PRINTF(2, 3);
void povray_doubt(povray *p, const char *format, ...) POV_PRINTF(2, 3);
bool povray_read_text(povray *p, const char *name, const char *text, char *out, size_t size);
bool povray_add(povray *p, const char *name, const char *text, povray_list *to);
/* +WORD or -WORD. */
bool povray_read_switch(povray *p, const char *word);
/* FILE, FILE.ini or FILE.ini[SECTION], in the working folder or in those of Library_Path. */
bool povray_read_ini(povray *p, const char *name);

#endif
