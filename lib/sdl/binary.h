/* How #write puts integers: `uint8 sint8 uint16be ...`. */
#ifndef SDL_BINARY_H
#define SDL_BINARY_H

#include <stddef.h>

typedef struct binary_format {
    const char *word;
    int bytes;
    double least, most;
    int is_little;               /* the lowest byte first */
} binary_format;

/* NULL: no such word. */
const binary_format *binary_find(const char *word);
/* The nearest integer that the format holds, of two the larger one. Returns its bytes. */
size_t binary_put(const binary_format *f, double number, char out[4]);

#endif
