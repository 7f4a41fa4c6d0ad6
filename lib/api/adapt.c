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
    size_t room;

    memcpy(&room, theirs, sizeof room);
    if (room > size)
        memset((unsigned char *)theirs + size, 0, room - size);
    if (room > sizeof room)
        memcpy((unsigned char *)theirs + sizeof room, (const unsigned char *)ours + sizeof room,
               (room < size ? room : size) - sizeof room);
}
