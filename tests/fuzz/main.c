/* The entry of libFuzzer; HARNESS is one of fuzz.h's. */
#include "fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    HARNESS(data, size);
    return 0;
}
