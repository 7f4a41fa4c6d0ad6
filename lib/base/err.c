#include "base/err.h"

#include "base/str.h"

#include <stdio.h>
#include <string.h>

pov_status err_setv(pov_error *err, pov_status status, const char *format, va_list args)
{
    if (!err)
        return status;
    memset(err, 0, sizeof *err);
    err->status = status;
    vsnprintf(err->message, sizeof err->message, format, args);
    return status;
}

pov_status err_set(pov_error *err, pov_status status, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    err_setv(err, status, format, args);
    va_end(args);
    return status;
}

pov_status err_set_at(pov_error *err, pov_status status, int line, int column, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    err_setv(err, status, format, args);
    va_end(args);
    if (err) {
        err->line = line;
        err->column = column;
    }
    return status;
}

pov_status err_file(pov_error *err, pov_status status, const char *file, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    err_setv(err, status, format, args);
    va_end(args);
    if (err)
        str_copy(err->file, sizeof err->file, file);
    return status;
}

pov_status err_memory(pov_error *err)
{
    return err_set(err, POV_E_MEMORY, "out of memory");
}
