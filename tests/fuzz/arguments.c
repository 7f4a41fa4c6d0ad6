#include "fuzz/fuzz.h"

#include "args.h"

#include <stdlib.h>
#include <string.h>

enum { WORDS_MOST = 64 };

void fuzz_arguments(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1), *words[WORDS_MOST + 2] = { (char[]){ "povc" } }, *at = text;
    int count = 1;
    args a;

    if (!text)
        return;
    memcpy(text, data, size);
    text[size] = '\0';
    while (count <= WORDS_MOST && at) {
        char *end = strchr(at, '\n');

        if (end)
            *end = '\0';
        words[count++] = at;
        at = end ? end + 1 : NULL;
    }
    if (args_parse(&a, count, words) == ARGS_WRONG && !a.problem[0])
        abort();                 /* a refusal says why */
    free(text);
}
