#include "base/dl.h"

#include <povtrace/base.h>

void pov_version(int *major, int *minor, int *patch)
{
    if (major)
        *major = POVTRACE_VERSION_MAJOR;
    if (minor)
        *minor = POVTRACE_VERSION_MINOR;
    if (patch)
        *patch = POVTRACE_VERSION_PATCH;
}

const char *pov_built_for(void)
{
    return dl_wide()[0] ? dl_wide() : "baseline";
}

const char *pov_status_name(pov_status status)
{
    static const char *const names[] = {
        "ok", "argument", "memory", "io", "syntax", "unsupported", "plugin", "cancelled"
    };
    int index = -(int)status;

    return index >= 0 && index < (int)(sizeof names / sizeof *names) ? names[index] : "unknown";
}
