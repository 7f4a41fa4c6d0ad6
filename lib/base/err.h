/* err.h - filling a caller's pov_error. Each function returns the status that it was given, so that a failure is one
 * line. */
#ifndef BASE_ERR_H
#define BASE_ERR_H

#include <povtrace/base.h>

#include <stdarg.h>

pov_status err_set(pov_error *err, pov_status status, const char *format, ...) POV_PRINTF(3, 4);
pov_status err_setv(pov_error *err, pov_status status, const char *format, va_list args);
/* Store the place in the text, too; the file is for a caller to store who knows it. */
pov_status err_set_at(pov_error *err, pov_status status, int line, int column, const char *format, ...) POV_PRINTF(5, 6);
/* Store the file of the failed operation in err->file. */
pov_status err_file(pov_error *err, pov_status status, const char *file, const char *format, ...) POV_PRINTF(4, 5);
pov_status err_memory(pov_error *err);

#endif
