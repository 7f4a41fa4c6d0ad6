#include "api/adapt.h"

#include <string.h>

pov_status adapt_in(void *ours, size_t size, const void *theirs, const char *what, pov_error *err)
{
    size_t given;

    memset(ours, 0, size);
    if (theirs) {
        memcpy(&given, theirs, sizeof given);
        if (given < sizeof given)
            return err_set(err, POV_E_ARGUMENT, "%s has no size: initialise it with POV_INIT", what);
        memcpy(ours, theirs, given < size ? given : size);
    }
    memcpy(ours, &size, sizeof size);
    return POV_OK;
}

void adapt_out(void *theirs, const void *ours, size_t size)
{
    size_t buffer;

    memcpy(&buffer, theirs, sizeof buffer);
    if (buffer > size)
        memset((unsigned char *)theirs + size, 0, buffer - size);
    if (buffer > sizeof buffer)
        memcpy((unsigned char *)theirs + sizeof buffer, (const unsigned char *)ours + sizeof buffer,
               (buffer < size ? buffer : size) - sizeof buffer);
}
