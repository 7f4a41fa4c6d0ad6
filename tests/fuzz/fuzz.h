/* fuzz.h - what strangers' bytes are given to: each harness takes any bytes, and ends the process where they do harm.
 *
 * `make fuzz SECONDS=n` runs them under libFuzzer and the sanitizers, test_replay.c runs them for moments in every build. */
#ifndef FUZZ_FUZZ_H
#define FUZZ_FUZZ_H

#include <stddef.h>
#include <stdint.h>

void fuzz_scene(const uint8_t *data, size_t size);        /* scene text: read, trace, tree against list */
void fuzz_image(const uint8_t *data, size_t size);        /* the first byte chooses the format of the rest */
void fuzz_checkpoint(const uint8_t *data, size_t size);   /* edits of a good one, or its bytes; the hash is renewed */
void fuzz_arguments(const uint8_t *data, size_t size);    /* povc's words, a line each */

#endif
