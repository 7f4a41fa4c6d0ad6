#define _GNU_SOURCE   /* dladdr */
#include "base/dl.h"

#include "base/str.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef __ELF__
#include <link.h>

/* Does a segment of the file lie beyond its end? `head` is a header of this machine's kind. */
static bool is_cut_short(int file, const ElfW(Ehdr) *head, size_t size)
{
    unsigned i;

    for (i = 0; i < head->e_phnum; i++) {
        ElfW(Phdr) segment;
        off_t at = (off_t)(head->e_phoff + (size_t)i * head->e_phentsize);

        if (pread(file, &segment, sizeof segment, at) != (ssize_t)sizeof segment)
            return true;
        if (segment.p_type == PT_LOAD &&
            (segment.p_offset > size || segment.p_filesz > size - segment.p_offset))
            return true;
    }
    return false;
}

/* The system's loader maps a file without checking its length, and the process is killed when it touches a missing
 * page. Files that are no object files of this machine at all are refused by the loader itself. */
static bool is_whole(const char *path)
{
    int file = open(path, O_RDONLY | O_CLOEXEC);
    ElfW(Ehdr) head;
    struct stat about;
    bool whole = true;

    if (file < 0)
        return true;
    if (fstat(file, &about) == 0 && read(file, &head, sizeof head) == (ssize_t)sizeof head &&
        memcmp(head.e_ident, ELFMAG, SELFMAG) == 0 &&
        head.e_ident[EI_CLASS] == (sizeof(void *) == 8 ? ELFCLASS64 : ELFCLASS32))
        whole = !is_cut_short(file, &head, (size_t)about.st_size);
    close(file);
    return whole;
}
#else
static bool is_whole(const char *path)
{
    (void)path;
    return true;
}
#endif

void *dl_open(const char *path, char *why, size_t why_size)
{
    void *handle;

    if (!is_whole(path)) {
        str_copy(why, why_size, "the file is cut short");
        return NULL;
    }
    handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
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

#ifdef POV_WIDE
const char *dl_wide(void)
{
    return POV_WIDE;
}
#else
const char *dl_wide(void)
{
    return "";
}
#endif

/* Length of the folder's name without the suffix that the loader uses for wide copies. */
static size_t without_wide(const char *folder, size_t n)
{
    char tail[64];
    size_t m = (size_t)snprintf(tail, sizeof tail, "/glibc-hwcaps/%s", dl_wide());

    return dl_wide()[0] && n > m && memcmp(folder + n - m, tail, m) == 0 ? n - m : n;
}

bool dl_own_folder(char *out, size_t size)
{
    static const char here = 0;   /* an address within this library */
    Dl_info info;
    char whole[PATH_MAX], *slash;
    size_t n;

    if (!dladdr(&here, &info) || !info.dli_fname || !realpath(info.dli_fname, whole))
        return false;
    slash = strrchr(whole, '/');
    if (!slash)
        return false;
    n = without_wide(whole, (size_t)(slash - whole));
    if (n >= size)
        return false;
    whole[n] = '\0';
    str_copy(out, size, whole);
    return true;
}
