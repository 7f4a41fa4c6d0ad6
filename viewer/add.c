#include "add.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void add(char *out, size_t size, const char *format, ...)
{
    size_t used = strlen(out);
    va_list list;

    va_start(list, format);
    vsnprintf(out + used, size - used, format, list);
    va_end(list);
}
