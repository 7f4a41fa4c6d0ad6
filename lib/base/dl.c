#define _GNU_SOURCE   /* dladdr */
#include "base/dl.h"

#include "base/str.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

void *dl_open(const char *path, char *why, size_t why_size)
{
    void *handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);

    if (!handle)
        str_copy(why, why_size, dlerror());
    return handle;
}

const void *dl_data(void *handle, const char *symbol)
{
    return dlsym(handle, symbol);
}

void dl_close(void *handle)
{
    dlclose(handle);
}

bool dl_own_folder(char *out, size_t size)
{
    static const char here = 0;   /* an address within this library */
    Dl_info info;
    char whole[PATH_MAX], *slash;

    if (!dladdr(&here, &info) || !info.dli_fname || !realpath(info.dli_fname, whole))
        return false;
    slash = strrchr(whole, '/');
    if (!slash || (size_t)(slash - whole) >= size)
        return false;
    *slash = '\0';
    str_copy(out, size, whole);
    return true;
}
