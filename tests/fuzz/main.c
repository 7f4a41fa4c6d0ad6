/* The entry of libFuzzer; HARNESS is one of fuzz.h's. */
#include "fuzz/fuzz.h"

#include <dlfcn.h>
#include <glob.h>

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Plugins stay in memory, or their counters would be gone when libFuzzer reads them. */
int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    glob_t found;

    (void)argc;
    (void)argv;
    if (glob(TEST_BUILD "/lib/povtrace/*/*.so", 0, NULL, &found) == 0)
        for (size_t i = 0; i < found.gl_pathc; i++)
            dlopen(found.gl_pathv[i], RTLD_NOW);
    globfree(&found);
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    HARNESS(data, size);
    return 0;
}
