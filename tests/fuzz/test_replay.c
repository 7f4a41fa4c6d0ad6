/* test_replay.c - the harnesses of tests/fuzz on good inputs and on some that were spoilt, in any build and without a fuzzer. */
#include "support/check.h"
#include "support/scenes.h"

#include "fuzz/fuzz.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { BYTES_MOST = 1 << 14, SPOILT = 3, SECONDS_MOST = 120 };

static uint64_t next(uint64_t *seed)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    return *seed ^= *seed << 17;
}

/* A few bytes changed, doubled or left out. */
static size_t spoil(uint8_t *bytes, size_t size, uint64_t *seed)
{
    for (int i = 0; i < 4 && size > 8; i++) {
        const size_t at = next(seed) % size, length = 1 + next(seed) % 8;

        switch (next(seed) % 4) {
        case 0:
            bytes[at] ^= (uint8_t)(1u << next(seed) % 8);
            break;
        case 1:
            bytes[at] = bytes[next(seed) % size];
            break;
        case 2:
            if (at + length >= size)
                break;
            memmove(bytes + at, bytes + at + length, size - at - length);
            size -= length;
            break;
        default:
            if (size + length > BYTES_MOST || at + length > size)
                break;
            memmove(bytes + at + length, bytes + at, size - at);
            size += length;
        }
    }
    return size;
}

static size_t read_file(const char *path, uint8_t *to)
{
    FILE *from = fopen(path, "rb");
    size_t n = from ? fread(to, 1, BYTES_MOST, from) : 0;

    if (from)
        fclose(from);
    return n;
}

static void scenes_that_were_spoilt_do_no_harm(void **state)
{
    static uint8_t good[BYTES_MOST], bad[BYTES_MOST];
    uint64_t seed = 88172645463325252u;
    char **list = scenes_list("test");

    (void)state;
    for (size_t i = 0; list[i]; i += 7) {
        const size_t size = read_file(list[i], good);

        for (int k = 0; k < SPOILT; k++) {
            memcpy(bad, good, size);
            fuzz_scene(bad, k == 0 ? size : spoil(bad, size, &seed));
        }
    }
    scenes_free(list);
}

static void images_that_were_spoilt_do_no_harm(void **state)
{
    static const char ppm[] = "\1P6 3 2 255\n123456789012345678", pfm[] = "\2PF\n2 1\n-1\n123412341234123412341234";
    static uint8_t bad[BYTES_MOST];
    uint64_t seed = 521288629u;

    (void)state;
    for (int i = 0; i < 400; i++) {
        const char *good = i % 2 ? pfm : ppm;
        size_t size = i % 2 ? sizeof pfm - 1 : sizeof ppm - 1;

        memcpy(bad, good, size);
        bad[0] = (uint8_t)(i % 16 < 2 ? i / 16 % 6 : good[0]);
        fuzz_image(bad, i < 2 ? size : spoil(bad + 1, size - 1, &seed) + 1);
    }
}

static void checkpoints_that_were_forged_do_no_harm(void **state)
{
    uint8_t edits[31];
    uint64_t seed = 2463534242u;

    (void)state;
    for (int i = 0; i < 60; i++) {
        for (size_t k = 0; k < sizeof edits; k++)
            edits[k] = (uint8_t)next(&seed);
        fuzz_checkpoint(edits, 1 + 3 * (size_t)(i % 11));
    }
}

static void words_of_any_kind_do_no_harm(void **state)
{
    static const char good[] = "s.pov\n64\n48\no.png\n--spp\n4\n--crop\n0,0,8,8\n-D\nA=1\n--aov\ndepth\nd.pfm\n--time=3\n-t\n2\n--limit\nturns=5";
    static uint8_t bad[BYTES_MOST];
    uint64_t seed = 362436069u;

    (void)state;
    for (int i = 0; i < 5000; i++) {
        memcpy(bad, good, sizeof good - 1);
        fuzz_arguments(bad, spoil(bad, sizeof good - 1, &seed));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scenes_that_were_spoilt_do_no_harm),
        cmocka_unit_test(images_that_were_spoilt_do_no_harm),
        cmocka_unit_test(checkpoints_that_were_forged_do_no_harm),
        cmocka_unit_test(words_of_any_kind_do_no_harm),
    };

    alarm(SECONDS_MOST);         /* what waits for ever is a failure */
    return cmocka_run_group_tests(tests, NULL, NULL);
}
